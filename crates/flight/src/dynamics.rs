//! What is flown: a state and its rate of change.

use std::borrow::Cow;

/// Where a state is kept: `[f64; N]` where its length is known to the compiler, `Box<[f64]>` where it is not.
pub trait Storage: Clone + AsRef<[f64]> + AsMut<[f64]> {}

impl<X: Clone + AsRef<[f64]> + AsMut<[f64]>> Storage for X {}

/// Equations of motion: the rate of change of a state.
///
/// A closure makes one, with [`equations`].
pub trait Dynamics {
    /// Where the state is kept.
    type State: Storage;

    /// Writes the rate of change of `x` at time `t` (s) to `dx`, all of it.
    ///
    /// Where there is none, NaN or an infinity in `dx` ends the flight with an error.
    fn derivative(&mut self, t: f64, x: &Self::State, dx: &mut Self::State);

    /// How many of the state's leading components the step is controlled by; all, unless it says otherwise.
    fn controlled(&self) -> usize {
        usize::MAX
    }

    /// Name of a component of the state, for messages.
    fn state_name(&self, component: usize) -> Cow<'_, str> {
        format!("state {component}").into()
    }
}

impl<D: Dynamics> Dynamics for &mut D {
    type State = D::State;

    #[inline(always)]
    fn derivative(&mut self, t: f64, x: &Self::State, dx: &mut Self::State) {
        (**self).derivative(t, x, dx);
    }

    fn controlled(&self) -> usize {
        (**self).controlled()
    }

    fn state_name(&self, component: usize) -> Cow<'_, str> {
        (**self).state_name(component)
    }
}

/// Equations of motion from a closure `|t, x, dx|`; the states are named `names`, for messages.
pub fn equations<'n, X, F>(names: &'n [&'n str], f: F) -> Equations<'n, X, F>
where
    X: Storage,
    F: FnMut(f64, &X, &mut X),
{
    Equations {
        names,
        f,
        state: std::marker::PhantomData,
    }
}

/// Equations of motion made by [`equations`].
pub struct Equations<'n, X, F> {
    names: &'n [&'n str],
    f: F,
    state: std::marker::PhantomData<fn(X)>,
}

impl<X: Storage, F: FnMut(f64, &X, &mut X)> Dynamics for Equations<'_, X, F> {
    type State = X;

    #[inline(always)]
    fn derivative(&mut self, t: f64, x: &X, dx: &mut X) {
        (self.f)(t, x, dx);
    }

    fn state_name(&self, component: usize) -> Cow<'_, str> {
        match self.names.get(component) {
            Some(name) => (*name).into(),
            None => format!("state {component}").into(),
        }
    }
}
