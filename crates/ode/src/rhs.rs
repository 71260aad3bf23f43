//! Right-hand side of an ordinary differential equation dx/dt = f(t, x).

use crate::projection::Projection;
use lanes::{Enclosure, Switch};
use std::borrow::Cow;
use std::sync::Arc;

/// State vector of an initial value problem: `[f64; N]`, or `Box<[f64]>` or `Vec<f64>` of any length.
pub trait StateVector: Clone + AsRef<[f64]> + AsMut<[f64]> {}

impl<X: Clone + AsRef<[f64]> + AsMut<[f64]>> StateVector for X {}

/// What a solver has to know of a right-hand side f besides its values.
pub trait RhsProperties {
    /// Projection onto what the equations keep, such as constraints; none by default.
    fn projection(&self) -> Option<Projection> {
        None
    }

    /// Times, increasing, at which f or a derivative of it may jump; a step ends just before each, and the next begins
    /// with f just after it. None by default.
    fn time_breaks(&self) -> &[f64] {
        &[]
    }

    /// Levels of each of the arguments that [`switch_arguments`](Self::switch_arguments) computes: between two of them f may
    /// differ from what it is on both sides, and a step that passes both, or a kink, looks there. None by default.
    fn switches(&self) -> Option<Arc<[Switch]>> {
        None
    }

    /// Writes the arguments of functions within f that switch, such as the height of a layer of wind; one that depends
    /// on another comes after it.
    fn switch_arguments(&mut self, t: f64, x: &[f64], to: &mut [f64]) {
        let _ = (t, x, to);
    }

    /// Writes bounds of these arguments where the time and the state are functions with the bounds `t` and `x`; whether
    /// they are known, by default not. Without them narrow features are sought at points of a step alone.
    fn switch_bounds(&mut self, t: Enclosure, x: &[Enclosure], to: &mut [Enclosure]) -> bool {
        let _ = (t, x, to);
        false
    }

    /// Name of a state component, used in error messages only.
    fn state_name(&self, component: usize) -> Cow<'_, str> {
        format!("state {component}").into()
    }
}

/// Right-hand side f of dx/dt = f(t, x); [`rhs_from_fn`] builds a right-hand side from a closure.
pub trait OdeRhs: RhsProperties {
    /// Type of the state vector x.
    type State: StateVector;

    /// Writes f(t, x) to every component of `dx`, in state units per unit of time.
    ///
    /// Outside the domain of f, write NaN or an infinity: the step is rejected, and where no shorter step
    /// succeeds the integration fails with
    /// [`NonFiniteDerivative`](crate::IntegrationFailure::NonFiniteDerivative).
    fn derivative(&mut self, t: f64, x: &Self::State, dx: &mut Self::State);

    /// Number of leading state components in the error norm of the step-size control; all by default.
    fn error_controlled_len(&self) -> usize {
        usize::MAX
    }
}

/// Right-hand side from a closure `f(t, x, dx)` that writes dx/dt to `dx`.
///
/// `names` are the state names used in error messages; components beyond the end of `names` are numbered.
pub fn rhs_from_fn<'n, X, F>(names: &'n [&'n str], f: F) -> FnRhs<'n, X, F>
where
    X: StateVector,
    F: FnMut(f64, &X, &mut X),
{
    FnRhs {
        names,
        f,
        state: std::marker::PhantomData,
    }
}

/// Right-hand side that wraps a closure `f(t, x, dx)`, as [`rhs_from_fn`] returns it.
pub struct FnRhs<'n, X, F> {
    names: &'n [&'n str],
    f: F,
    state: std::marker::PhantomData<fn(X)>,
}

impl<X: StateVector, F: FnMut(f64, &X, &mut X)> OdeRhs for FnRhs<'_, X, F> {
    type State = X;

    #[inline(always)]
    fn derivative(&mut self, t: f64, x: &X, dx: &mut X) {
        (self.f)(t, x, dx);
    }
}

impl<X, F> RhsProperties for FnRhs<'_, X, F> {
    fn state_name(&self, component: usize) -> Cow<'_, str> {
        match self.names.get(component) {
            Some(name) => (*name).into(),
            None => format!("state {component}").into(),
        }
    }
}
