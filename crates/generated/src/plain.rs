// Written by `hyzer generate`; changes belong in the compiler.
//! Each function for `f64`, compiled once for each kind of machine that [`lanes::alone`] knows.

use crate::Equations;
use lanes::{Alone, alone};
use std::marker::PhantomData;

macro_rules! functions {
    ($($name:ident $call:ident ($($argument:ident: $type:ty),*))*) => {$(
        struct $call<E, A>(PhantomData<E>, A);

        impl<'a, E: Equations> Alone for $call<E, ($($type,)*)> {
            #[inline(always)]
            fn run(self) {
                let ($($argument,)*) = self.1;
                E::$name($($argument),*);
            }
        }

        #[doc = concat!("See [`Equations::", stringify!($name), "`].")]
        #[inline(never)]
        pub fn $name<'a, E: Equations>($($argument: $type),*) {
            alone($call::<E, _>(PhantomData, ($($argument,)*)));
        }
    )*};
}

#[rustfmt::skip]
functions! {
    prepare Prepare(p: &'a [f64], k: &'a mut [f64])
    f F(t: f64, x: &'a [f64], p: &'a [f64], k: &'a [f64], dx: &'a mut [f64])
    f_jac FJac(t: f64, x: &'a [f64], p: &'a [f64], k: &'a [f64], dx: &'a mut [f64],
        j: &'a mut [f64])
    f_jac_par FJacPar(t: f64, x: &'a [f64], p: &'a [f64], k: &'a [f64], dx: &'a mut [f64],
        j: &'a mut [f64], jp: &'a mut [f64])
    observe Observe(t: f64, x: &'a [f64], p: &'a [f64], k: &'a [f64], marker: &'a [f64],
        y: &'a mut [f64])
    observe_jac ObserveJac(t: f64, x: &'a [f64], p: &'a [f64], k: &'a [f64], marker: &'a [f64],
        y: &'a mut [f64], dy_dx: &'a mut [f64], dy_dp: &'a mut [f64], dy_dmarker: &'a mut [f64])
    quantities Quantities(t: f64, x: &'a [f64], p: &'a [f64], k: &'a [f64], q: &'a mut [f64])
    limits Limits(t: f64, x: &'a [f64], p: &'a [f64], k: &'a [f64], l: &'a mut [f64])
}
