//! Integration: accuracy, events, sensitivities and batches.

mod analytic;
mod batch;
mod dips;
mod disc;
mod events;
mod methods;
mod sensitivity;

use ode::{OdeRhs, StateVector, rhs_from_fn};

type BoxedFunction<'n, X> = Box<dyn FnMut(f64, &X, &mut X) + 'n>;

/// Right-hand side from a closure, of one type for all closures: the solver is compiled once for each state type.
fn rhs<'n, X: StateVector + 'n>(
    names: &'n [&'n str],
    f: impl FnMut(f64, &X, &mut X) + 'n,
) -> impl OdeRhs<State = X> {
    let f: BoxedFunction<'n, X> = Box::new(f);
    rhs_from_fn(names, f)
}
