"""Simulated flights."""

from __future__ import annotations

import json
import os
from functools import cached_property
from typing import TYPE_CHECKING, Any, cast

from hyzer import _hyzer
from hyzer._arguments import plain
from hyzer._errors import InputError
from hyzer._extras import extra
from hyzer._records import Record

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt
    import pandas as pd
    import xarray as xr


class Flight:
    """A simulated flight.

    Attributes
    ----------
    t : ndarray, shape (m,)
        Times of the samples since the release, s; the last is the end of the flight.
    states : ndarray, shape (m, n)
        States at these times, SI, in the order of `names`.
    names, units : tuple of str
        Names of the states, and their units.
    duration : float
        Duration, s.
    ended_by : str
        The event that ended the flight: `ground` or `time`.
    events : list of (str, float)
        Names and times of the events, s.

    Examples
    --------
    >>> import hyzer
    >>> flight = hyzer.Model("disc").fly("backhand")
    >>> flight.ended_by, flight.landing.shape
    ('ground', (3,))
    >>> float(flight["z"].max()) > 1.0
    True
    """

    def __init__(self, native: _hyzer.Flight, made: tuple[Any, ...] = ()) -> None:
        self._native = native
        self._made = made
        self.names = tuple(native.names)
        self.units = tuple(native.units)
        self.duration = native.duration
        self.ended_by = native.ended_by
        self.events = native.events

    @classmethod
    def fly(cls, *made: Any) -> Flight:
        """Simulate a flight; the arguments are those of the compiled function."""
        return cls(_hyzer.fly(*made), made)

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickle what the flight was made of, which makes the same flight."""
        return type(self).fly, self._made

    @cached_property
    def t(self) -> npt.NDArray[np.float64]:
        """Times of the samples since the release, s."""
        return self._native.time_array()

    @cached_property
    def states(self) -> npt.NDArray[np.float64]:
        """States at the times `t`, shape (m, n), SI."""
        return self._native.state_array()

    @cached_property
    def summary(self) -> Record | None:
        """Range, apex, landing and the throws at release and end: `summary.json` of the program.

        `None` for a model that has no body.
        """
        text = self._native.summary_json()
        return None if text is None else Record(json.loads(text))

    @property
    def landing(self) -> npt.NDArray[np.float64]:
        """Position of the mass centre at the end of the flight, shape (3,), m."""
        if self.summary is None:
            raise AttributeError("the model has no body, whose landing could be found")
        return extra("numpy").array(self.summary["landing_m"])  # type: ignore[no-any-return]

    def __getitem__(self, name: str) -> npt.NDArray[np.float64]:
        """Return the values of a state by name, shape (m,)."""
        try:
            return self.states[:, self.names.index(name)]
        except ValueError:
            expected = ", ".join(self.names)
            raise KeyError(f"found {name!r}, expected one of {expected}") from None

    def at(self, t: npt.ArrayLike) -> npt.NDArray[np.float64]:
        """Return the states at given times.

        Parameters
        ----------
        t : float or array_like
            Times since the release, s, within the flight.

        Returns
        -------
        ndarray
            Of the shape of `t` with one more axis, for the states.

        Examples
        --------
        >>> import hyzer
        >>> hyzer.Model("disc").fly("backhand").at([0.0, 0.25]).shape
        (2, 12)
        """
        return self._native.at(t)

    def markers(self, marker: npt.ArrayLike) -> npt.NDArray[np.float64]:
        """Return the positions of markers at the times `t`.

        Parameters
        ----------
        marker : array_like, shape (3,) or (k, 3)
            Positions of the markers in the body frame, m.

        Returns
        -------
        ndarray, shape (m, 3) or (m, k, 3)
            Positions in the inertial frame, m.
        """
        return self._native.markers(marker)

    def derivatives(self, input_name: str) -> npt.NDArray[np.float64]:
        """Return the derivatives of the states by each sample of an input over time.

        They say what an error of the record does to the flight: independent errors of standard
        deviation `sigma` move the states by
        ``sigma * np.sqrt((flight.derivatives(name) ** 2).sum(0))``.

        Parameters
        ----------
        input_name : str
            Name of a scalar input that varies in this flight.

        Returns
        -------
        ndarray, shape (k, m, n)
            By each of the `k` samples, of the `n` states at the times `t`, SI.

        Raises
        ------
        InputError
            If the model has no such input, or it is constant in this flight.

        Examples
        --------
        >>> import hyzer
        >>> model = hyzer.Model('''
        ... model sled;
        ... param m = 2 kg;
        ... input thrust: N = 0;
        ... frame N;
        ... point sled { mass m; position (x, y, z) in N; velocity (vx, vy, vz) in N; }
        ... force push = (thrust, 0, 0) in N;
        ... ''')
        >>> start = dict.fromkeys(model.states, 0.0)
        >>> thrust = ([0.0, 1.0, 2.0], [0.0, 4.0, 0.0])
        >>> release = hyzer.Release(start, inputs={"thrust": thrust}, until=2.0)
        >>> by_sample = model.fly(release, rate=1.0).derivatives("thrust")
        >>> by_sample.shape
        (3, 3, 6)
        >>> by_sample[:, -1, 3].round(6).tolist()
        [0.25, 0.5, 0.25]
        """
        return self._native.derivatives(input_name)

    def to_pandas(self) -> pd.DataFrame:
        """Return the states as a DataFrame: a column for each state, the time as its index."""
        pandas = extra("pandas")
        index = pandas.Index(self.t, name="t")
        return cast("pd.DataFrame", pandas.DataFrame(self.states, index=index, columns=self.names))

    def to_xarray(self) -> xr.Dataset:
        """Return the states as an xarray Dataset over `t`, with units as attributes."""
        states = self.states
        variables = {
            name: ("t", states[:, k], {"units": self.units[k]}) for k, name in enumerate(self.names)
        }
        coordinates = {"t": ("t", self.t, {"units": "s"})}
        return cast("xr.Dataset", extra("xarray").Dataset(variables, coordinates))

    def plot(self, axes: Any = None) -> Any:
        """Draw the path from the side and from above, with equal scales.

        Parameters
        ----------
        axes : pair of matplotlib axes, optional
            Where to draw; by default a new figure.

        Returns
        -------
        pair of matplotlib axes
        """
        if not {"x", "z"} <= set(self.names):
            found = ", ".join(self.names)
            raise InputError(
                f"the states are {found}, expected x and z to draw; to_pandas() has all"
            )
        is_new = axes is None
        if axes is None:
            pyplot = extra("matplotlib.pyplot")
            _, axes = pyplot.subplots(2, 1, sharex=True, layout="compressed")
        side, above = axes
        for axis, name in ((side, "z"), (above, "y")):
            # A motion in a plane has no y.
            axis.plot(self["x"], self[name] if name in self.names else 0 * self["x"])
            axis.set_ylabel(f"{name}, m")
        # Each axis holds all that is drawn on it, and is not much shorter than the longest.
        drawn = [(axis.dataLim.intervalx, axis.dataLim.intervaly) for axis in (side, above)]
        xs = [float(x) for across, _ in drawn for x in across]
        heights = [(float(low), float(high)) for _, (low, high) in drawn]
        widest = max(high - low for low, high in [(min(xs), max(xs)), *heights])
        for axis, height in ((side, heights[0]), (above, heights[1])):
            axis.set_xlim(*_around(min(xs), max(xs), widest))
            axis.set_ylim(*_around(*height, widest))
            axis.set_aspect("equal", adjustable="box")
        if is_new:  # One scale for both.
            spans = [high - low for low, high in (side.get_ylim(), above.get_ylim())]
            side.get_gridspec().set_height_ratios(spans)
        side.set_title(self._native.title)
        above.set_xlabel("x, m")
        return axes

    def view(self, height: int = 480) -> Any:
        """Show the flight in three dimensions, in a notebook: the page `flight.html`.

        Parameters
        ----------
        height : int
            Height of the frame, pixels.

        Returns
        -------
        View
            Displayed by notebooks; `str()` is the HTML of the page.

        Raises
        ------
        InputError
            If the height is not a number of pixels.
        """
        if isinstance(height, bool) or not isinstance(plain(height), int) or height <= 0:
            raise InputError(f"height: found {height!r}, expected a number of pixels above 0")
        page = self._native.view_html()
        if page is None:
            raise ValueError("the model has no body, which could be shown")
        return View(page, height)

    def save(self, folder: str | os.PathLike[str]) -> None:
        """Write the folder that `hyzer simulate --out` writes: table, figure, view, summary.

        Raises
        ------
        FolderError
            If the folder cannot be written, or holds files that are not results of hyzer.
        """
        self._native.save_files(folder)

    def __repr__(self) -> str:
        return f"<Flight {self._native.title}: {self.duration:.2f} s, ended by {self.ended_by}>"


def _around(low: float, high: float, widest: float) -> tuple[float, float]:
    """Return the limits of an axis around its data, with a margin."""
    middle, half = (low + high) / 2, max(0.55 * (high - low), 0.2 * widest) or 0.5
    return middle - half, middle + half


class View:
    """A page that a notebook shows in a frame."""

    def __init__(self, page: str, height: int) -> None:
        self._page = page
        self._height = height

    def __str__(self) -> str:
        return self._page

    def _repr_html_(self) -> str:
        import html

        page = html.escape(self._page, quote=True)
        style = f"width:100%;height:{self._height}px;border:0"
        return f'<iframe srcdoc="{page}" style="{style}" title="flight"></iframe>'
