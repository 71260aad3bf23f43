// Written by `hyzer generate`; changes belong in the compiler.
//! Each function on one number at a time, compiled once for each kind of machine that [`lanes::dispatch_scalar`] knows.

use crate::Equations;
use lanes::{ScalarKernel, ScalarLane, dispatch_scalar};
use std::marker::PhantomData;

macro_rules! functions {
    ($($name:ident $call:ident ($time:ident: f64, $($from:ident),*; $($to:ident),*))*) => {$(
        struct $call<'a, E> {
            equations: PhantomData<E>,
            $time: f64,
            $($from: &'a [f64],)*
            $($to: &'a mut [f64],)*
        }

        impl<E: Equations> ScalarKernel for $call<'_, E> {
            #[inline(always)]
            fn run<T: ScalarLane>(self) {
                let time = T::splat(self.$time);
                E::$name(time, $(T::slice(self.$from),)* $(T::slice_mut(self.$to)),*);
            }
        }

        #[doc = concat!("See [`Equations::", stringify!($name), "`].")]
        #[inline(never)]
        pub fn $name<E: Equations>($time: f64, $($from: &[f64],)* $($to: &mut [f64]),*) {
            dispatch_scalar($call::<E> { equations: PhantomData, $time, $($from,)* $($to),* });
        }
    )*};
}

functions! {
    f F(t: f64, x, p, k; dx)
    f_jac FJac(t: f64, x, p, k; dx, j)
    f_jac_par FJacPar(t: f64, x, p, k; dx, j, jp)
    observe Observe(t: f64, x, p, k, marker; y)
    observe_jac ObserveJac(t: f64, x, p, k, marker; y, dy_dx, dy_dp, dy_dmarker)
    quantities Quantities(t: f64, x, p, k; q)
    limits Limits(t: f64, x, p, k; l)
}

struct Prepare<'a, E>(PhantomData<E>, &'a [f64], &'a mut [f64]);

impl<E: Equations> ScalarKernel for Prepare<'_, E> {
    #[inline(always)]
    fn run<T: ScalarLane>(self) {
        E::prepare(T::slice(self.1), T::slice_mut(self.2));
    }
}

/// See [`Equations::prepare`].
#[inline(never)]
pub fn prepare<E: Equations>(p: &[f64], k: &mut [f64]) {
    dispatch_scalar(Prepare::<E>(PhantomData, p, k));
}
