"""Functions of a model for JAX."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from itertools import product
from typing import TYPE_CHECKING, Any

from ._arrays import ArrayLibrary, ArrayModel
from ._document import Ir
from ._program import Programs, required
from ._read import read
from .numpy_ import NumpyLibrary

if TYPE_CHECKING:
    import jax

    JaxModel = ArrayModel[jax.Array]


class JaxLibrary(NumpyLibrary):
    """JAX's functions; the derivative of its own `abs` at 0 is 1, of this it is 0."""

    def __init__(self, jnp: Any) -> None:
        super().__init__(jnp)
        self.functions["abs"] = self.magnitude

    def magnitude(self, x: Any) -> Any:
        """Return the absolute value."""
        return x * self.numpy.sign(x)


def to_jax(ir: dict[str, Any] | Ir) -> JaxModel:
    """Functions of a model over arrays of JAX, for `jit`, `grad` and `vmap`.

    Parameters
    ----------
    ir : dict or Ir
        Document as ``json.loads`` returns it.

    Returns
    -------
    ArrayModel
        Object with `rhs`, `jac`, `observe`, `observe_jac`, `quantities` and `limits`.

    Raises
    ------
    IrError
        If the document is not one of schema ``hyzer.ir/1``.
    ImportError
        If JAX is missing.
    RuntimeError
        If JAX computes with 32 bits.

    Examples
    --------
    >>> import json, subprocess, jax
    >>> jax.config.update("jax_enable_x64", True)
    >>> text = subprocess.check_output(["hyzer", "export", "ball", "--ir"])
    >>> ball = to_jax(json.loads(text))
    >>> speed = lambda x: ball.rhs(0.0, x)[2]
    >>> [float(part) for part in jax.jit(jax.grad(speed))(ball.x0)]
    [0.0, 0.0, 0.0, 0.0, 0.0, 1.0]
    """
    jax = required("jax", "to_jax")
    jnp = required("jax.numpy", "to_jax")
    if not jax.config.jax_enable_x64:
        advice = "call jax.config.update('jax_enable_x64', True) before any other use of JAX"
        raise RuntimeError(f"JAX computes with 32 bits, hyzer needs 64: {advice}")
    checked = read(ir)

    def dense(
        values: Sequence[Any],
        places: Sequence[tuple[int, ...]],
        batch: tuple[int, ...],
        shape: tuple[int, ...],
    ) -> Any:
        # One gather: an array of its own for each zero takes XLA minutes to compile.
        stacked = jnp.stack([jnp.broadcast_to(value, batch) for value in [*values, 0.0]], axis=-1)
        known = {place: k for k, place in enumerate(places)}
        stored = [known.get(place, len(values)) for place in product(*map(range, shape))]
        return stacked[..., jnp.asarray(stored, dtype=int)].reshape(batch + shape)

    library = ArrayLibrary(
        array=partial(jnp.asarray, dtype=float),
        broadcast_shapes=jnp.broadcast_shapes,
        dense=dense,
    )
    return ArrayModel(checked, Programs(checked, JaxLibrary(jnp)), library)
