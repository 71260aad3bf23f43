//! The right-hand side of a batch behind a vtable, so that the step loop is compiled once for each lane type instead of
//! once for each lane type and model.

use super::{LanePoint, LaneRhs, LaneSizes};
use lanes::{Enclosure, LaneKernel, Lanes, Switch};

/// Function of a [`LaneRhs`]; [`Function::Prepare`] reads the parameters of a point alone.
#[derive(Clone, Copy)]
pub(crate) enum Function {
    Prepare,
    Derivative,
    Limits,
    Switches,
}

/// A [`LaneRhs`] evaluated on SIMD lanes of the type `T`. The functions are compiled for the instruction set of these
/// lanes; vectors are passed by reference, because a call without that instruction set cannot pass them by value.
pub(crate) trait LaneFunctions<T> {
    fn sizes(&self) -> LaneSizes;
    fn time_breaks(&self, p: &[f64], breaks: &mut Vec<f64>);
    fn switches(&self) -> &[Switch];
    fn switch_bounds(&self, t: Enclosure, x: &[Enclosure], p: &[f64], to: &mut [Enclosure])
    -> bool;
    /// The function and its point are arguments of their own: as one in memory, they would be written in parts and read as a
    /// whole, for which a processor waits.
    fn call(&self, function: Function, at: &LanePoint<'_, T>, scratch: &mut [T], to: &mut [T]);
}

impl<T: Lanes, R: LaneRhs> LaneFunctions<T> for R {
    fn sizes(&self) -> LaneSizes {
        LaneRhs::sizes(self)
    }

    fn time_breaks(&self, p: &[f64], breaks: &mut Vec<f64>) {
        LaneRhs::time_breaks(self, p, breaks);
    }

    fn switches(&self) -> &[Switch] {
        LaneRhs::switches(self)
    }

    fn switch_bounds(
        &self,
        t: Enclosure,
        x: &[Enclosure],
        p: &[f64],
        to: &mut [Enclosure],
    ) -> bool {
        LaneRhs::switch_bounds(self, t, x, p, to)
    }

    fn call(&self, function: Function, at: &LanePoint<'_, T>, scratch: &mut [T], to: &mut [T]) {
        T::outlined(Outlined {
            rhs: self,
            function,
            at,
            scratch,
            to,
        });
    }
}

struct Outlined<'a, T, R> {
    rhs: &'a R,
    function: Function,
    at: &'a LanePoint<'a, T>,
    scratch: &'a mut [T],
    to: &'a mut [T],
}

impl<T: Lanes, R: LaneRhs> LaneKernel<T> for Outlined<'_, T, R> {
    #[inline(always)]
    fn run(self) {
        let Outlined {
            rhs,
            at,
            scratch,
            to,
            ..
        } = self;
        match self.function {
            Function::Prepare => rhs.prepare(at.p, scratch, to),
            Function::Derivative => rhs.derivative(*at, scratch, to),
            Function::Limits => rhs.limits(*at, scratch, to),
            Function::Switches => rhs.switch_arguments(*at, scratch, to),
        }
    }
}
