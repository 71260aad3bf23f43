//! Prints the time of each function per number, ns, for each instruction set: `cargo run --release -p hyzer-lanes
//! --example speed`.

#[path = "../tests/integration/support/mod.rs"]
mod support;

use lanes::{ElementaryFunction, Isa, Kernel, Lanes, Real, dispatch_with};
use std::hint::black_box;
use std::time::Instant;

trait Function: Copy {
    const NAME: &'static str;
    fn of<T: Real>(x: T) -> T;
    fn standard(x: f64) -> f64;
}

macro_rules! functions {
    ($($name:ident $x:ident $ours:expr, $standard:expr;)*) => {
        $(
            #[derive(Clone, Copy)]
            struct $name;
            impl Function for $name {
                const NAME: &'static str = stringify!($name);
                #[inline(always)]
                fn of<T: Real>($x: T) -> T { $ours }
                #[inline(always)]
                fn standard($x: f64) -> f64 { $standard }
            }
        )*
        fn others() { $(measure($name);)* }
    };
}
functions! {
    SinCos x { let (s, c) = x.sin_cos(); s + c }, { let (s, c) = x.sin_cos(); s + c };
    Atan2 x x.atan2(T::splat(1.5)), x.atan2(1.5);
    Sqrt x Real::sqrt(x), x.sqrt();
    Table x x.piecewise_cubic(&KNOTS, &CUBICS), x.piecewise_cubic(&KNOTS, &CUBICS);
    ByChoice x by_choice(x), by_choice(x);
}

/// Elementary function whose evaluation is timed, by its index in [`ElementaryFunction::ALL`].
#[derive(Clone, Copy)]
struct Elementary<const INDEX: usize>;

impl<const INDEX: usize> Function for Elementary<INDEX> {
    const NAME: &'static str = ElementaryFunction::ALL[INDEX].name();
    #[inline(always)]
    fn of<T: Real>(x: T) -> T {
        x.elementary(ElementaryFunction::ALL[INDEX])
    }
    #[inline(always)]
    fn standard(x: f64) -> f64 {
        support::standard(ElementaryFunction::ALL[INDEX], x)
    }
}

/// Knots of the piecewise cubic whose evaluation is timed.
const KNOTS: [f64; 33] = {
    let mut knots = [0.0; 33];
    let mut k = 0;
    while k < 33 {
        knots[k] = -1.6 + 0.1 * k as f64;
        k += 1;
    }
    knots
};

/// Coefficients of the piecewise cubic whose evaluation is timed.
const CUBICS: [[f64; 4]; 34] = {
    let mut cubics = [[0.0; 4]; 34];
    let mut k = 0;
    while k < 34 {
        let x = k as f64 / 33.0;
        cubics[k] = [x * x, 2.0 * x, 1.0 - x, 0.5];
        k += 1;
    }
    cubics
};

/// Evaluates the piecewise cubic at `x` without a search. The origin and the coefficients of the cubic at `x` are those
/// of the first cubic plus, for each knot below `x`, the change from one cubic to the next.
#[inline(always)]
fn by_choice<T: Real>(x: T) -> T {
    let mut origin = T::splat(KNOTS[0]);
    let mut c = CUBICS[0].map(T::splat);
    for k in 0..KNOTS.len() {
        let beyond = (x - T::splat(KNOTS[k])).heaviside();
        if k > 0 {
            origin = beyond.mul_add(T::splat(KNOTS[k] - KNOTS[k - 1]), origin);
        }
        for (i, c) in c.iter_mut().enumerate() {
            *c = beyond.mul_add(T::splat(CUBICS[k + 1][i] - CUBICS[k][i]), *c);
        }
    }
    let h = x - origin;
    let [a, b, c, d] = c;
    d.mul_add(h, c).mul_add(h, b).mul_add(h, a)
}

const COUNT: usize = 4096;

struct Pass<'a, F>(&'a [f64], &'a mut [f64], F);

impl<F: Function> Kernel for Pass<'_, F> {
    type Output = ();
    #[inline(always)]
    fn run<T: Lanes>(self) {
        for (from, to) in self
            .0
            .chunks_exact(T::WIDTH)
            .zip(self.1.chunks_exact_mut(T::WIDTH))
        {
            F::of(T::load(from)).store(to);
        }
    }
}

/// Evaluates `f` in a chain in which each argument depends on the previous result. The run time per element of `from`
/// is the latency of `f`.
fn chained(from: &[f64], f: impl Fn(f64) -> f64) -> f64 {
    from.iter().fold(0.0, |sum, x| f(x + sum * 1e-300))
}

fn nanoseconds(mut pass: impl FnMut()) -> f64 {
    let one = |pass: &mut dyn FnMut()| {
        let start = Instant::now();
        pass();
        start.elapsed().as_nanos() as f64 / COUNT as f64
    };
    (0..300)
        .map(|_| one(&mut pass))
        .fold(f64::INFINITY, f64::min)
}

fn measure<F: Function>(f: F) {
    let from: Vec<f64> = (0..COUNT)
        .map(|i| 6.0 * ((i as f64 * 0.618).fract() - 0.5))
        .collect();
    let mut to = vec![0.0; COUNT];
    let standard = nanoseconds(|| {
        from.iter()
            .zip(&mut to)
            .for_each(|(x, to)| *to = F::standard(*x));
    });
    let latency_standard = nanoseconds(|| _ = black_box(chained(black_box(&from), F::standard)));
    let latency = nanoseconds(|| _ = black_box(chained(black_box(&from), F::of)));
    print!(
        "{:8} latency: std {latency_standard:5.1} ours {latency:5.1}; a number: std {standard:5.2}",
        F::NAME
    );
    for isa in Isa::ALL {
        if isa.is_supported() {
            let ns = nanoseconds(|| _ = dispatch_with(isa, Pass(black_box(&from), &mut to, f)));
            print!("  {} {ns:5.2}", isa.name());
        }
    }
    println!();
}

fn main() {
    measure(Elementary::<0>);
    measure(Elementary::<1>);
    measure(Elementary::<2>);
    measure(Elementary::<3>);
    others();
}
