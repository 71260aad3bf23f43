"""Flight models with exact derivatives, fitted to flights and diagnosed for missing effects.

A `Model` is loaded by name, path or text, and evaluated on arrays; `Model.fly` simulates a
`Release`. A `Dataset` is read from files or built from DataFrames; `fit` estimates coefficients
from it, and `diagnose` finds what the model lacks.

>>> import hyzer
>>> found = hyzer.diagnose("examples/mystery")
>>> found.verdict
'identified'
"""

from hyzer._analyses import Bootstrap, Design, Stability, bootstrap, design, stability
from hyzer._checks import Difference, Verification, diff, verify
from hyzer._dataset import Dataset
from hyzer._errors import (
    Cancelled,
    Error,
    FitError,
    FlightError,
    FolderError,
    InputError,
    InternalError,
    ModelError,
)
from hyzer._fit import diagnose, fit
from hyzer._flight import Flight
from hyzer._hyzer import __version__
from hyzer._model import Model
from hyzer._release import Release
from hyzer._results import Diagnosis, Fit
from hyzer._sweep import Sweep, sweep
from hyzer._synthesis import synthesize

__all__ = [
    "Bootstrap",
    "Cancelled",
    "Dataset",
    "Design",
    "Diagnosis",
    "Difference",
    "Error",
    "Fit",
    "FitError",
    "Flight",
    "FlightError",
    "FolderError",
    "InputError",
    "InternalError",
    "Model",
    "ModelError",
    "Release",
    "Stability",
    "Sweep",
    "Verification",
    "__version__",
    "bootstrap",
    "design",
    "diagnose",
    "diff",
    "fit",
    "stability",
    "sweep",
    "synthesize",
    "verify",
]
