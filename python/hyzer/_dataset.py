"""Datasets: measured flights of one body."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from hyzer import _hyzer
from hyzer._arguments import file_of, mapping, names, numbers, selected
from hyzer._errors import InputError
from hyzer._extras import frame_of
from hyzer._model import Model
from hyzer._tables import manifest, model_name, named, table, text_of

if TYPE_CHECKING:
    import numpy.typing as npt
    import pandas as pd


class Dataset:
    """Measured flights of one body, with its markers and sensors.

    Made by `read`, `from_pandas`, `from_arrays`, `import_takes`, or `hyzer.synthesize`; all of them
    check what they are given as files are checked.

    Attributes
    ----------
    model : str
        Name or path of the model.
    name : str
        Name in reports: that of the folder, or the one given.
    files : tuple of str
        Names of the flights.
    markers : dict of str to list of float
        Positions of the markers in the body frame, m.
    parameters : dict of str to float
        Known constants that replace the model's defaults, SI.

    Examples
    --------
    >>> import hyzer
    >>> data = hyzer.Dataset.read("examples/disc")
    >>> data.model, len(data)
    ('disc', 8)
    """

    def __init__(self, native: _hyzer.Dataset) -> None:
        self._native = native
        self.model = native.model
        self.name = native.name
        self.files = native.files
        self.markers = native.markers
        self.parameters = native.parameters

    @classmethod
    def read(cls, folder: str | os.PathLike[str], *, threads: int | None = None) -> Dataset:
        """Read a folder with `dataset.toml` and a table or C3D file per flight.

        Raises
        ------
        InputError
            For the first fault of the files, with its place.

        Examples
        --------
        >>> import hyzer
        >>> hyzer.Dataset.read("nowhere")
        Traceback (most recent call last):
        hyzer._errors.InputError: nowhere: found no such folder, expected a dataset: a folder with
        ...
        """
        return cls(_hyzer.Dataset.load(folder, threads))

    @classmethod
    def from_pandas(
        cls,
        flights: pd.DataFrame | Sequence[pd.DataFrame] | Mapping[Any, pd.DataFrame],
        *,
        markers: Mapping[str, Iterable[float] | str] | None = None,
        sensors: Mapping[str, Mapping[str, Any]] | None = None,
        model: str | os.PathLike[str] = "disc",
        parameters: Mapping[str, float] | None = None,
        sigma: float | None = None,
        held_out: Iterable[Any] | str | int = (),
        known: Mapping[Any, Mapping[str, Any]] | None = None,
        recording: Mapping[str, Any] | None = None,
        unknown: Iterable[str] | str | Mapping[Any, Iterable[str] | str] | None = None,
        inputs: Mapping[Any, pd.DataFrame] | None = None,
        interpolation: str | None = None,
        name: str = "flights",
    ) -> Dataset:
        """Make a dataset of DataFrames, one per flight.

        Parameters
        ----------
        flights : sequence or mapping of DataFrame
            Tables with a column or index `t`, s, and columns `NAME_x`, `NAME_y`, `NAME_z`, m, for
            each marker (z up); columns of other sensors as in a table of a dataset. A missing value
            is NaN. Times may be differences of time or dates, which count from the first of the
            flight, those of its inputs too. A
            sequence is named `flight01.csv`, `flight02.csv`, …; a key that is no name, as of
            `groupby`, `KEY.csv`. One DataFrame is one flight.
        markers : mapping of str to sequence of 3 floats
            Positions of the markers in the body frame, m, or "unknown" where it is to be estimated.
        sensors : mapping of str to mapping
            Other sensors by name: `kind` (`pose`, `gyroscope`, `accelerometer`, `speed`),
            `position` in the body frame, m, and optionally `sigma`, `sigma_angle`.
        model : str
            Model by name or path.
        parameters : mapping of str to float
            Known constants of the body and its environment, SI.
        sigma : float, optional
            Standard deviation of a measured coordinate, m; estimated by default.
        held_out : iterable of str, int or bool; str; int
            Flights that a fit does not use: by name or number from 0, or a mask of all flights.
            Flights whose keys are numbers go by their keys.
        known : mapping
            Values known for single flights, by name or number: `{0: {"wind": [1.0, 0.0, 0.0]}}`.
            `NAME_sigma` is the standard deviation with which `NAME` was measured.
        unknown : iterable of str, str, or mapping, optional
            Inputs, coefficients or constants that are estimated for each flight, or of single
            flights by name or number.
        inputs : mapping of str or int to DataFrame, optional
            Scalar inputs over time of single flights, SI: a column or index `t` and one column for
            each input. Inputs may be columns of the flights' tables instead.
        interpolation : {"linear", "hold", "cubic"}, optional
            Values of inputs between their samples.
        recording : mapping
            Units and axes of the tables: `length`, `time`, `up`, `left_handed`.
        name : str
            Name of the dataset in reports.

        Raises
        ------
        InputError
            With the flight, line and column of the first fault, as if the tables were files.

        Examples
        --------
        >>> import hyzer
        >>> frames = hyzer.Dataset.read("examples/ball").to_pandas()
        >>> data = hyzer.Dataset.from_pandas(frames, markers={"centre": (0, 0, 0)}, model="ball")
        >>> data.files[:2]
        ('flight01.csv', 'flight02.csv')
        """
        tables, files = named(flights)
        texts = {file: text_of(file, frame, recording) for file, frame in tables.items()}
        if not markers and not sensors:
            columns = dict.fromkeys(str(c) for frame in tables.values() for c in frame.columns)
            raise _nothing_measured(c[:-2] for c in columns if c.endswith("_x"))
        of_inputs: dict[Any, str] = {}
        of_flights = mapping(inputs, "inputs")
        for number, (flight, frame) in enumerate(of_flights.items(), start=1):
            file = f"inputs{number:02}.csv"
            beside = tables[file_of(flight, files, "inputs")]
            of_inputs[flight], texts[file] = file, text_of(file, frame, recording, beside)
        about = manifest(
            files,
            model,
            markers,
            sensors,
            parameters,
            sigma,
            held_out,
            known,
            recording,
            unknown,
            of_inputs,
            interpolation,
        )
        return cls(_hyzer.Dataset(about, texts, name))

    @classmethod
    def from_arrays(
        cls,
        flights: Sequence[Mapping[str, npt.ArrayLike]] | Mapping[Any, Any],
        *,
        markers: Mapping[str, Iterable[float] | str] | None = None,
        sensors: Mapping[str, Mapping[str, Any]] | None = None,
        **options: Any,
    ) -> Dataset:
        """Make a dataset of arrays, one mapping per flight.

        Parameters
        ----------
        flights : sequence or mapping of mappings
            Arrays by name: `t`, shape (m,), s; each marker, shape (m, 3), m; each other sensor,
            with a column for each of its components: 7 for a pose (x, y, z, qw, qx, qy, qz), 1 for
            a speed, else 3; each scalar input over time, shape (m,), SI. NaN is a missing value,
            as is a masked one. One mapping with the key `t` is one flight.
        markers, sensors, **options
            As in `from_pandas`.

        Examples
        --------
        >>> import hyzer, numpy as np
        >>> t = np.linspace(0, 0.5, 61)
        >>> seen = {"t": t, "m1": np.stack([12 * t, 0 * t, 1.5 - 4.9 * t**2], axis=1)}
        >>> data = hyzer.Dataset.from_arrays([seen], markers={"m1": (0, 0, 0)}, model="ball")
        >>> len(data)
        1
        """
        about = {
            key: options.pop(key, None)
            for key in (
                "parameters",
                "sigma",
                "held_out",
                "known",
                "recording",
                "unknown",
                "interpolation",
            )
        }
        model, name = options.pop("model", "disc"), options.pop("name", "flights")
        if options:
            raise TypeError(f"from_arrays() has no argument {', '.join(options)}")
        is_one = isinstance(flights, Mapping) and "t" in flights
        tables, files = named([flights] if is_one else flights)
        if not markers and not sensors:
            names = dict.fromkeys(str(key) for flight in tables.values() for key in flight)
            raise _nothing_measured(name for name in names if name != "t")
        kinds = dict.fromkeys(mapping(markers, "markers"), "marker")
        of_sensors = mapping(sensors, "sensors")
        kinds |= {sensor: str(about.get("kind")) for sensor, about in of_sensors.items()}
        texts = {file: table(file, flight, kinds) for file, flight in tables.items()}
        text = manifest(files, model, markers, sensors, **about)
        return cls(_hyzer.Dataset(text, texts, name))

    @classmethod
    def import_takes(
        cls,
        takes: Iterable[str | os.PathLike[str]] | str | os.PathLike[str],
        *,
        model: str | os.PathLike[str] | None = None,
        markers: str | os.PathLike[str] | None = None,
        format: str | None = None,  # noqa: A002  As the option of the program.
        length: str | None = None,
        time: str | None = None,
        rate: float | None = None,
        up: str | None = None,
        left_handed: bool = False,
        labels: Mapping[str, str] | None = None,
        centre_height: float | None = None,
        parameters: Mapping[str, float] | None = None,
        held_out: Iterable[Any] | str | int = (),
        name: str | None = None,
    ) -> Dataset:
        """Import recordings of a laboratory, cut to the free flights, as `hyzer import` does.

        Parameters
        ----------
        takes : iterable of path, or path
            Recordings, or folders of them: C3D, Vicon, Qualisys, OptiTrack, DLTdv8, poses or CSV.
        model : str or path, optional
            Model; by default that of the template.
        markers : path, optional
            Template: a TOML file with `[[markers]]`, such as a `dataset.toml`. Without it the
            positions are estimated from the throws.
        format, length, time, rate, up, left_handed
            What the files do not state: the format, the unit of length (`m`, `cm`, `mm`, `in`,
            `ft`) and time (`s`, `ms`), frames per second, the axis that points up (`+z`),
            left-handed axes.
        labels : mapping of str to str
            Names of markers by their labels in the files.
        centre_height : float, optional
            Height of the mass centre above the mean of the markers, m.
        parameters : mapping of str to float
            Known constants of the body and its environment, SI; they replace those of the template.
        held_out : iterable of str, int or bool; str; int
            Flights that a fit does not use: by name or number from 0, by the name of the recording
            that they were cut from, or a mask of all flights.
        name : str, optional
            Name of the dataset in reports; by default that of the folder of the first recording.

        Returns
        -------
        Dataset
            Its `decisions` tell what was decided; `save` writes the folder of the program.

        Examples
        --------
        >>> import hyzer
        >>> data = hyzer.Dataset.import_takes(
        ...     ["examples/disc/flight01.csv"],
        ...     length="m", time="s", up="+z", markers="examples/disc/dataset.toml",
        ...     parameters={"m": 0.175},
        ... )
        >>> "flight01.csv" in data.decisions
        True
        """
        options = {
            "format": format,
            "length": length,
            "time": time,
            "rate": rate,
            "up": up,
            "markers": markers,
            "model": None if model is None else model_name(model),
            "centre-height": centre_height,
        }
        arguments = [f"--{key}={value}" for key, value in options.items() if value is not None]
        arguments += ["--left-handed"] if left_handed else []
        arguments += [f"--label={label}={own}" for label, own in mapping(labels, "labels").items()]
        # After `--` no file can be an option.
        files = names(takes)
        if not files:
            raise InputError("takes: found none, expected the paths of recordings")
        constants = numbers(parameters, "parameters")
        if constants and model is not None:
            Model(model_name(model)).parameter_vector(constants)
        made, recordings = _hyzer.import_takes([*arguments, "--", *files], constants)
        apart = _selected_of(recordings, held_out, {file: file for file in made.files})
        text, tables, _, folder, about = made.held_out(apart).parts()
        if name is None:
            first = Path(files[0]).absolute()
            name = (first if first.is_dir() else first.parent).name
        return cls(_hyzer.Dataset(text, tables, name, folder, about))

    @property
    def decisions(self) -> str:
        """What was decided when takes were imported."""
        return self._native.decisions

    def to_pandas(self) -> dict[str, pd.DataFrame]:
        """Return the tables of the flights as DataFrames, by the names of the flights."""
        _, tables = self._native.texts()
        return {file: frame_of(text) for file, text in tables}

    def save(self, folder: str | os.PathLike[str]) -> None:
        """Write the dataset as a folder, which is new or empty, whole or not at all.

        Raises
        ------
        FolderError
            If the folder cannot be written or holds something else.
        """
        self._native.save_files(folder)

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickle the texts of the dataset."""
        return _of_parts, self._native.parts()

    @property
    def native(self) -> _hyzer.Dataset:
        """The compiled object."""
        return self._native

    def __len__(self) -> int:
        return len(self.files)

    def __repr__(self) -> str:
        name = f"{self.name!r}, " if self.name else ""
        return f"<Dataset {name}{len(self)} flights of {self.model}>"


def dataset_of(data: str | os.PathLike[str] | Dataset) -> _hyzer.Dataset:
    """Return a dataset given by its folder or as an object."""
    if isinstance(data, Dataset):
        return data.native
    try:
        folder: str = os.fspath(data)
    except TypeError:
        found = type(data).__name__
        raise TypeError(f"data: found {found}, expected a folder or a Dataset") from None
    return Dataset.read(folder).native


def _nothing_measured(names: Iterable[str]) -> InputError:
    """Return the error that no marker and no sensor is stated; `names` are those of the tables."""
    example = ", ".join(f"{name!r}: (0, 0, 0)" for name in names) or "'m1': (0, 0, 0)"
    return InputError(
        "markers: found none, and no sensors; expected what was measured. For markers, their "
        f"positions in the body frame, m: markers={{{example}}}"
    )


def _selected_of(
    recordings: Sequence[tuple[Path, list[str]]], held_out: Any, files: Mapping[Any, str]
) -> list[str]:
    """Return the flights held out, where a recording, by path or name, stands for its flights."""

    def of(item: Any) -> list[str]:
        if not isinstance(item, (str, Path)):
            return []
        return [
            file
            for path, flights in recordings
            if Path(item) in (path, Path(path.name))
            for file in flights
        ]

    several = type(held_out) in (list, tuple, set)
    each: list[Any] = list(held_out) if several else [held_out]
    rest: Any = [item for item in each if not of(item)]
    # A mask, or an array of flights, is read as a whole.
    rest = rest if several or not rest else held_out
    return [*(file for item in each for file in of(item)), *selected(rest, files, "held_out")]


def _of_parts(*parts: Any) -> Dataset:
    return Dataset(_hyzer.Dataset(*parts))
