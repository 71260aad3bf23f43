"""Functions of a model for other libraries, from the model as data.

``hyzer export MODEL --ir`` writes a model as JSON. `to_numpy`, `to_jax`, `to_casadi` and
`to_sympy` make functions of it, each with the package that it needs.
"""

from ._document import SCHEMA, Ir, IrError
from ._read import read
from .casadi_ import CasadiModel, to_casadi
from .jax_ import to_jax
from .numpy_ import to_numpy
from .sympy_ import SympyModel, to_sympy

__all__ = [
    "SCHEMA",
    "CasadiModel",
    "Ir",
    "IrError",
    "SympyModel",
    "read",
    "to_casadi",
    "to_jax",
    "to_numpy",
    "to_sympy",
]
