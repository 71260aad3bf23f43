//! The right-hand side of a batch behind a vtable, so that the step loop is compiled once for each lane type instead of
//! once for each lane type and model.

use super::{LanePoint, LaneRhs, LaneSizes};
use lanes::{LaneKernel, Lanes};

/// A [`LaneRhs`] evaluated on SIMD lanes of the type `T`. Each method is compiled as a separate function for the
/// instruction set of these lanes; vectors are passed by reference, because a call without that instruction set cannot
/// pass them by value.
pub(crate) trait LaneFunctions<T> {
    fn sizes(&self) -> LaneSizes;
    fn time_breaks(&self, p: &[f64], breaks: &mut Vec<f64>);
    fn prepare(&self, p: &[T], scratch: &mut [T], prepared: &mut [T]);
    fn derivative(&self, at: &LanePoint<'_, T>, scratch: &mut [T], dx: &mut [T]);
    fn limits(&self, at: &LanePoint<'_, T>, scratch: &mut [T], margins: &mut [T]);
}

impl<T: Lanes, R: LaneRhs> LaneFunctions<T> for R {
    fn sizes(&self) -> LaneSizes {
        LaneRhs::sizes(self)
    }

    fn time_breaks(&self, p: &[f64], breaks: &mut Vec<f64>) {
        LaneRhs::time_breaks(self, p, breaks);
    }

    fn prepare(&self, p: &[T], scratch: &mut [T], prepared: &mut [T]) {
        T::outlined(Prepare {
            rhs: self,
            p,
            scratch,
            prepared,
        });
    }

    fn derivative(&self, at: &LanePoint<'_, T>, scratch: &mut [T], dx: &mut [T]) {
        T::outlined(Derivative {
            rhs: self,
            at,
            scratch,
            dx,
        });
    }

    fn limits(&self, at: &LanePoint<'_, T>, scratch: &mut [T], margins: &mut [T]) {
        T::outlined(Limits {
            rhs: self,
            at,
            scratch,
            margins,
        });
    }
}

struct Prepare<'a, T, R> {
    rhs: &'a R,
    p: &'a [T],
    scratch: &'a mut [T],
    prepared: &'a mut [T],
}

impl<T: Lanes, R: LaneRhs> LaneKernel<T> for Prepare<'_, T, R> {
    #[inline(always)]
    fn run(self) {
        self.rhs.prepare(self.p, self.scratch, self.prepared);
    }
}

struct Derivative<'a, T, R> {
    rhs: &'a R,
    at: &'a LanePoint<'a, T>,
    scratch: &'a mut [T],
    dx: &'a mut [T],
}

impl<T: Lanes, R: LaneRhs> LaneKernel<T> for Derivative<'_, T, R> {
    #[inline(always)]
    fn run(self) {
        self.rhs.derivative(*self.at, self.scratch, self.dx);
    }
}

struct Limits<'a, T, R> {
    rhs: &'a R,
    at: &'a LanePoint<'a, T>,
    scratch: &'a mut [T],
    margins: &'a mut [T],
}

impl<T: Lanes, R: LaneRhs> LaneKernel<T> for Limits<'_, T, R> {
    #[inline(always)]
    fn run(self) {
        self.rhs.limits(*self.at, self.scratch, self.margins);
    }
}
