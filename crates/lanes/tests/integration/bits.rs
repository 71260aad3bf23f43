//! Results are bit-identical among all fusing and among all non-fusing number types; the two groups differ by rounding.

// Arguments where an implementation switches branches, which resemble mathematical constants.
#![allow(clippy::approx_constant)]

use lanes::{
    ElementaryFunction, Isa, Kernel, Lanes, Real, ScalarKernel, ScalarLane, dispatch_scalar,
    dispatch_with,
};

/// Number of results that the test function `everything` computes from two numbers by the operations of `Real`.
const RESULTS: usize = 25;

#[inline(always)]
fn everything<T: Real>(a: T, b: T) -> [T; RESULTS] {
    let (sine, cosine) = a.sin_cos();
    [
        a + b,
        a - b,
        a * b,
        a / b,
        -a,
        a.sqrt(),
        a.recip_or_zero(),
        sine,
        cosine,
        a.atan2(b),
        b.atan2(a),
        a.elementary(ElementaryFunction::ALL[0]),
        a.elementary(ElementaryFunction::ALL[1]),
        a.elementary(ElementaryFunction::ALL[2]),
        a.elementary(ElementaryFunction::ALL[3]),
        a.abs(),
        a.min(b),
        a.max(b),
        a.sign(),
        a.heaviside(),
        a.if_zero(b, T::splat(2.5)),
        (a * b).exp().atan2((a + b).sin_cos().0),
        a.mul_add(b, a),
        a.mul_sub(b, b),
        a.neg_mul_add(a, b),
    ]
}

struct Map<'a> {
    a: &'a [f64],
    b: &'a [f64],
    to: &'a mut [[f64; RESULTS]],
}

impl Kernel for Map<'_> {
    type Output = usize;
    #[inline(always)]
    fn run<T: Lanes>(self) -> usize {
        let chunks = self.a.chunks(T::WIDTH).zip(self.b.chunks(T::WIDTH));
        for ((a, b), to) in chunks.zip(self.to.chunks_mut(T::WIDTH)) {
            let results = everything(T::load_part(a, 1.0), T::load_part(b, 1.0));
            for (i, result) in results.iter().enumerate() {
                for (lane, to) in to.iter_mut().enumerate() {
                    to[i] = result.lane(lane);
                }
            }
        }
        T::WIDTH
    }
}

fn special() -> Vec<f64> {
    let mut values = vec![
        0.0,
        f64::MIN_POSITIVE,
        5e-324,
        1e-310,
        1e-76,
        1e-75,
        1e-74,
        1e-9,
        0.4999999999,
        0.5,
        0.625,
    ];
    values.extend([
        0.7071067811865476,
        0.75,
        1.0,
        1.0000000000000002,
        1.5707963267948966,
        2.0,
        std::f64::consts::PI,
        22.0,
    ]);
    values.extend([
        709.78,
        709.79,
        710.5,
        745.1,
        746.5,
        1e4,
        99999.9,
        1e5,
        1e154,
        1e299,
        1e300,
        f64::MAX,
        f64::INFINITY,
    ]);
    values.extend([1e5 + 1e-3, 2e5, 1e9, 1e22]);
    if cfg!(miri) {
        // Miri randomizes the last bits of the standard library's functions, which large arguments use.
        values.retain(|v| *v <= 20.0);
    }
    let negative: Vec<f64> = values.iter().map(|v| -v).collect();
    values.extend(negative);
    values.push(f64::NAN);
    values
}

/// Pairs of numbers for tests: all pairs of special values, and random pairs with magnitudes from 2^-20 to 2^16
/// (SplitMix64).
fn pairs() -> (Vec<f64>, Vec<f64>) {
    let special = special();
    let step = if cfg!(miri) { 7 } else { 1 };
    let (mut a, mut b): (Vec<f64>, Vec<f64>) = special
        .iter()
        .flat_map(|a| special.iter().map(move |b| (*a, *b)))
        .step_by(step)
        .unzip();
    let mut seed = 1_u64;
    let mut random = || {
        seed = seed.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = seed;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    };
    for _ in 0..if cfg!(miri) { 40 } else { 400_003 } {
        for list in [&mut a, &mut b] {
            // Magnitudes from 2^-20 to 2^16, as in models.
            let exponent = 1023 - 20 + random() % if cfg!(miri) { 22 } else { 37 };
            list.push(f64::from_bits(
                random() >> 12 | exponent << 52 | random() << 63,
            ));
        }
    }
    (a, b)
}

/// Scalar kernel that applies the operations under test to one pair of numbers at a time.
struct OneByOne<'a>(Map<'a>);

impl ScalarKernel for OneByOne<'_> {
    #[inline(always)]
    fn run<T: ScalarLane>(self) {
        self.0.run::<T>();
    }
}

#[track_caller]
fn same(expected: &[[f64; RESULTS]], found: &[[f64; RESULTS]], (a, b): (&[f64], &[f64]), by: &str) {
    for (i, (expected, found)) in expected.iter().zip(found).enumerate() {
        for (k, (e, f)) in expected.iter().zip(found).enumerate() {
            let same = e.to_bits() == f.to_bits() || e.is_nan() && f.is_nan();
            assert!(
                same,
                "{by}, result {k} of {:e}, {:e}: {f:e}, not {e:e}",
                a[i], b[i]
            );
        }
    }
}

#[test]
fn every_kind_of_lanes_gives_the_bits_of_its_family() {
    let (a, b) = pairs();
    let plain: Vec<[f64; RESULTS]> = a.iter().zip(&b).map(|(a, b)| everything(*a, *b)).collect();
    let mut fused: Option<Vec<[f64; RESULTS]>> = None;
    let mut kinds = 0;
    for isa in Isa::ALL {
        let mut found = vec![[0.0; RESULTS]; a.len()];
        let to = &mut found;
        let Some(width) = dispatch_with(isa, Map { a: &a, b: &b, to }) else {
            continue;
        };
        kinds += 1;
        assert_eq!(width, [8, 4, 4, 1][kinds_index(isa)]);
        assert_eq!(width, isa.width());
        if isa.fuses() {
            same(
                fused.get_or_insert(found.clone()),
                &found,
                (&a, &b),
                isa.name(),
            );
        } else {
            same(&plain, &found, (&a, &b), isa.name());
        }
    }
    assert!(kinds >= 2);

    let mut found = vec![[0.0; RESULTS]; a.len()];
    let to = &mut found;
    dispatch_scalar(OneByOne(Map { a: &a, b: &b, to }));
    match fused.as_ref().filter(|_| Isa::best().fuses()) {
        Some(fused) => same(fused, &found, (&a, &b), "alone"),
        None => same(&plain, &found, (&a, &b), "alone"),
    }

    // All but the last four, which may cancel: each function is within 3 ulp in both groups.
    for (i, (plain, fused)) in plain.iter().zip(fused.iter().flatten()).enumerate() {
        for (k, (p, f)) in plain.iter().zip(fused).take(RESULTS - 4).enumerate() {
            let close = (p - f).abs() <= 6.0 * f64::EPSILON * p.abs() + f64::MIN_POSITIVE;
            let one = p == f || p.is_nan() && f.is_nan();
            assert!(
                close || one,
                "result {k} of {:e}, {:e}: {f:e} fused, {p:e} not",
                a[i],
                b[i]
            );
        }
    }
}

struct Rounds<'a>(&'a mut f64);

impl Kernel for Rounds<'_> {
    type Output = ();
    #[inline(always)]
    fn run<T: Lanes>(self) {
        // (1 + e)² = 1 + 2e + e²; rounding the product first loses e².
        let e = 2_f64.powi(-30);
        let a = T::splat(1.0 + e);
        *self.0 = a.mul_sub(a, T::splat(1.0 + 2.0 * e)).lane(0);
    }
}

#[test]
fn those_that_say_so_round_once() {
    for isa in Isa::ALL {
        let mut left = f64::NAN;
        if dispatch_with(isa, Rounds(&mut left)).is_some() {
            let expected = if isa.fuses() { 2_f64.powi(-60) } else { 0.0 };
            assert_eq!(left, expected, "{}", isa.name());
        }
    }
}

fn kinds_index(isa: Isa) -> usize {
    Isa::ALL.iter().position(|i| *i == isa).unwrap()
}
