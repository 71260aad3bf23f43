"""Results of fits and diagnoses: objects with the keys of their report as attributes."""

from __future__ import annotations

import html
import json
import os
from typing import TYPE_CHECKING, Any, Protocol, cast

from hyzer import _hyzer
from hyzer._extras import extra, frame_of
from hyzer._model import Model
from hyzer._records import Record, shown

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt
    import pandas as pd


class Native(Protocol):
    """What the compiled results have in common."""

    def report_json(self) -> str:
        """Return the report."""
        ...

    def summary_text(self) -> str:
        """Return what the program prints."""
        ...

    def model_text(self) -> str | None:
        """Return the fitted or extended model; `None` where there is none."""
        ...

    def files(self) -> list[tuple[str, bytes]]:
        """Return the files of the program by their names."""
        ...

    def save_files(self, folder: str | os.PathLike[str]) -> None:
        """Write the folder of the program."""
        ...


class Result(Record):
    """A result with a report: its keys are attributes, read when they are first asked for."""

    def __init__(self, native: Native) -> None:
        super().__init__({})
        self._native = native

    def _values(self) -> dict[str, Any]:
        if not self._data:
            self._data = json.loads(self._native.report_json())
        return self._data

    def text(self) -> str:
        """Return the result as the program prints it."""
        return self._native.summary_text()

    def save(self, folder: str | os.PathLike[str]) -> None:
        """Write the folder of the program: report, page, model, figures, tables.

        Parameters
        ----------
        folder : path
            New, empty, or of earlier results, which are replaced.

        Raises
        ------
        FolderError
            If the folder cannot be written, or holds files that are not results of hyzer.
        """
        self._native.save_files(folder)

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickle the texts of the result."""
        return type(self), (Saved(self._native, json.dumps(self._values())),)

    def _cautions_html(self) -> str:
        items = "".join(f"<li>{html.escape(caution)}</li>" for caution in self["cautions"])
        return f"<p>Do not rely on this result:</p><ul>{items}</ul>" if items else ""


class Paged(Result):
    """A result with a page."""

    def page(self) -> str:
        """Return the page `report.html` of the program, a self-contained HTML text."""
        return dict(self._native.files())["report.html"].decode()


class Saved:
    """The texts of a result, in place of the compiled object."""

    def __init__(self, native: Native, report: str) -> None:
        self._report, self._summary = report, native.summary_text()
        self._model, self._files = native.model_text(), native.files()

    def report_json(self) -> str:
        """Return the report."""
        return self._report

    def summary_text(self) -> str:
        """Return what the program prints."""
        return self._summary

    def model_text(self) -> str | None:
        """Return the fitted or extended model."""
        return self._model

    def files(self) -> list[tuple[str, bytes]]:
        """Return the files of the program."""
        return self._files

    def file_text(self, name: str) -> str | None:
        """Return the text of a file of the program."""
        found = dict(self._files).get(name)
        return None if found is None else found.decode()

    def save_files(self, folder: str | os.PathLike[str]) -> None:
        """Write the folder of the program."""
        _hyzer.write_files(folder, self._files)


class Fit(Paged):
    """Result of a fit. Attributes are the keys of `hyzer.fit/2`.

    Attributes
    ----------
    reliable : bool
        Whether the estimates can be relied on.
    cautions : list of str
        The reasons if not.
    coefficients : Table
        By name: `value`, `std_error`, `unit`, `interval`, `at_bound`, …, SI.
    residual_rms, noise : Table
        By kind of sensor: `value` or `sigma`, and `unit`.
    flights : Rows
        Each flight: `file`, `role`, `outcome`, `samples`, `residual_rms`, `initial`, …
    not_identifiable, data_faults : Rows or list
        What the flights do not determine; mistakes in the data.

    Notes
    -----
    All keys are explained on the page report.json of the reference.
    `coefficients.to_pandas()` is a DataFrame.

    Examples
    --------
    >>> import hyzer
    >>> fit = hyzer.fit("examples/disc")
    >>> fit.reliable, round(fit.coefficients.C_D0.value, 3), fit.coefficients.C_La.unit
    (True, 0.15, '1/rad')
    >>> fit.covariance().shape
    (8, 8)
    """

    @property
    def fitted(self) -> Model:
        """The model with the estimates as its default values."""
        return Model(cast(str, self._native.model_text()))

    @property
    def estimated(self) -> list[str]:
        """Names of what was estimated, in the order of `covariance`."""
        return [name for name in self["coefficients"] if name in self["correlations"]]

    def residuals(self) -> pd.DataFrame:
        """Return the residuals of all markers, measured - predicted.

        Returns
        -------
        DataFrame
            A row for each measured position: `file`, `t_s` since the first sample, `marker`, `x_m`,
            `y_m`, `z_m`, and whether it is an `outlier`. It ends after a million rows.
        """
        return frame_of(dict(self._native.files())["residuals.csv"].decode())

    def correlation(self) -> npt.NDArray[np.float64]:
        """Return the correlations of the estimates, in the order of `estimated`."""
        names, rows = self.estimated, self["correlations"].to_dict()
        matrix = [[rows[a][b] for b in names] for a in names]
        return extra("numpy").array(matrix, dtype=float)  # type: ignore[no-any-return]

    def covariance(self) -> npt.NDArray[np.float64]:
        """Return the covariance matrix of the estimates, SI, in the order of `estimated`."""
        numpy = extra("numpy")
        about = self["coefficients"].to_dict()
        errors = [about[name]["std_error"] for name in self.estimated]
        # At a bound there is no standard error.
        errors = [float("nan") if error is None else error for error in errors]
        return self.correlation() * numpy.outer(errors, errors)  # type: ignore[no-any-return]

    def plot(self, axes: Any = None) -> Any:
        """Draw the RMS residual of each flight, in the unit of its first sensor; lengths in mm.

        Parameters
        ----------
        axes : matplotlib axes, optional
            Where to draw; by default a new figure.

        Returns
        -------
        matplotlib axes
        """
        if axes is None:
            _, axes = extra("matplotlib.pyplot").subplots(layout="constrained")
        used = [flight for flight in self["flights"] if flight["residual_rms"]]
        kind = next(iter(self["residual_rms"]))
        used = [flight for flight in used if kind in flight["residual_rms"]]
        unit = self["residual_rms"][kind]["unit"]
        unit, scale = ("mm", 1000.0) if unit == "m" else (unit, 1.0)
        for role, colour in (("fit", "C0"), ("held_out", "C1")):
            part = [flight for flight in used if flight["role"] == role]
            values = [scale * flight["residual_rms"][kind]["value"] for flight in part]
            if part:
                axes.bar([flight["file"] for flight in part], values, color=colour, label=role)
        axes.set_ylabel(f"RMS residual of the {kind}, {unit}")
        axes.tick_params(axis="x", rotation=60)
        # Above the axes, where there are no bars.
        axes.legend(loc="lower left", bbox_to_anchor=(0, 1), ncols=2, frameon=False)
        return axes

    def __repr__(self) -> str:
        word = "reliable" if self["reliable"] else "not reliable"
        return f"<Fit of {self['model']} to {self['dataset'] or 'a dataset'}, {word}>"

    def _repr_html_(self) -> str:
        rows = "".join(
            f"<tr><th scope='row'>{html.escape(name)}</th><td>{shown(about['value'])}</td>"
            f"<td>± {shown(about['std_error'])}</td><td>{html.escape(about['unit'])}</td></tr>"
            for name, about in self["coefficients"].to_dict().items()
        )
        of = html.escape(f"{self['model']} fitted to {self['dataset'] or 'a dataset'}")
        return f"<p>{of}</p>{self._cautions_html()}<table><tbody>{rows}</tbody></table>"


class Diagnosis(Paged):
    """Result of a diagnosis. Attributes are the keys of `hyzer.diagnosis/2`.

    Attributes
    ----------
    verdict : str
        `adequate`, `identified`, `ambiguous`, `unattributed` or `negligible`.
    summary : str
        The result in a paragraph.
    reliable : bool
        Whether the result can be relied on.
    cautions : list of str
        The reasons if not.
    explanations : Rows
        Every explanation that the data do not reject, the best first: `effects`, with `name`,
        `description` and `estimates`; `explained_fraction`, …
    predictive_gain : Record or None
        Prediction errors before and after, on flights that were not fitted, m.
    coefficients : Table
        Those of the extended model, by name: `value`, `std_error`, `unit`, and `before` without
        the effects found.
    flights : Rows
        Each flight: `file`, `role`, `outcome`, `reason`, `rms_before_m`, `rms_after_m`.
    data_faults : Rows or list
        Mistakes in the data: `file`, `fault`, `detail`, `correction`.
    tests : Rows
        The score test of each candidate.

    Notes
    -----
    All keys are explained on the page report.json of the reference.

    Examples
    --------
    >>> import hyzer
    >>> found = hyzer.diagnose("examples/mystery")
    >>> found.verdict, found.explanations[0].effects[0].name
    ('identified', 'stall')
    >>> found.predictive_gain.rms_after_m < 0.2 * found.predictive_gain.rms_before_m
    True
    """

    @property
    def causes(self) -> list[str]:
        """Names of the effects of the best explanation; empty where the model is adequate."""
        explanations = self["explanations"]
        return [effect["name"] for effect in explanations[0]["effects"]] if explanations else []

    @property
    def extended(self) -> Model | None:
        """The model with the effects found and the estimates; `None` if it was not extended."""
        text = self._native.model_text()
        return None if text is None else Model(text)

    def plot(self, axes: Any = None) -> Any:
        """Draw what was found: a coefficient before and after, or the tests of candidates.

        Of several coefficients it is the one that the effects change most.

        Parameters
        ----------
        axes : matplotlib axes, optional
            Where to draw; by default a new figure.

        Returns
        -------
        matplotlib axes
        """
        if axes is None:
            _, axes = extra("matplotlib.pyplot").subplots(layout="constrained")
        curve = self._curve()
        if curve is not None:
            axes.plot(curve["x"], curve["before"], "--", label="before")
            axes.plot(curve["x"], curve["after"], label="after")
            axes.set_xlabel(f"{curve['over']}, {curve['unit']}")
            axes.set_ylabel(curve["quantity"])
            axes.legend()
            return axes
        tests = self["tests"][:12][::-1]
        axes.barh([test["name"] for test in tests], [abs(test["z"] or 0.0) for test in tests])
        axes.axvline(self["threshold"]["z"], color="0.5", linestyle="--")
        axes.set_xlabel("|z| of the score test")
        return axes

    def _curve(self) -> dict[str, Any] | None:
        """Return the curve that the effects change most, relative to its size."""
        curves: list[dict[str, Any]] = [curve for curve in self["curves"] if curve["x"]]

        def change(curve: dict[str, Any]) -> float:
            before: list[float] = curve["before"]
            after: list[float] = curve["after"]
            size = max(abs(value) for value in before + after) or 1.0
            return max(abs(a - b) for a, b in zip(after, before, strict=True)) / size

        return max(curves, key=change, default=None)

    def __repr__(self) -> str:
        causes = f": {' and '.join(self.causes)}" if self.causes else ""
        return f"<Diagnosis of {self['model']}, {self['verdict']}{causes}>"

    def _repr_html_(self) -> str:
        items = ""
        for found in self["explanations"]:
            effects = [effect["description"].rstrip(".") for effect in found["effects"]]
            words = html.escape("; and ".join(effects))
            share = 100 * (found["explained_fraction"] or 0.0)
            items += f"<li>{words}: {share:.0f} % of the misfit</li>"
        verdict = html.escape(f"{self['model']}: {self['verdict']}")
        summary = html.escape(self["summary"])
        found = f"<ol>{items}</ol>" if items else ""
        return f"<p><b>{verdict}</b></p><p>{summary}</p>{self._cautions_html()}{found}"
