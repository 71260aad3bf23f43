//! Inverse trigonometric functions: `atan2` and `asin`.

use super::polynomial;
use crate::primitive::{Primitive, map_lanes};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};
use std::hint::cold_path;

/// Maximum |x| + |y| for which no intermediate result of `atan2` overflows.
const MAX_SUM: f64 = 1e300;

/// π/4 minus the `f64` nearest to π/4: low-order part of π/4 in sums that must be more accurate than one `f64`.
const FRAC_PI_4_REST: f64 = 3.061_616_997_868_383e-17;

/// Maximum tangent for which `atan2` evaluates the polynomial for the angle itself.
const MAX_DIRECT_TANGENT: f64 = 0.5625;

/// Coefficients of (atan(q)/q - 1)/z in powers of z = q² up to `MAX_DIRECT_TANGENT`, by Remez exchange; error 5e-18.
const TANGENT: [f64; 13] = [
    -0.3333333333333314,
    0.199999999999424,
    -0.14285714280109307,
    0.11111110845147187,
    -0.09090901754449021,
    0.07692178422851867,
    -0.06665128559162886,
    0.05869577095199975,
    -0.05187714260483364,
    0.04442997570716452,
    -0.03385044480293923,
    0.019406890240188053,
    -0.005920897901686788,
];

#[inline(always)]
pub(crate) fn atan2<T: Primitive>(y: T, x: T) -> T {
    let y_size = y.magnitude();
    // Fast path for small angles: the selections of `general` would add 0.
    // Where `x` is a normal number, so is the product; NaN and infinity do not come here.
    let least = T::broadcast(MAX_SUM.recip()).le(x);
    let small = (y_size * T::broadcast(16.0)).le(x * T::broadcast(16.0 * MAX_DIRECT_TANGENT));
    let far = x.le(T::broadcast(0.5 * MAX_SUM));
    if T::all_true(least) && T::all_true(small) && T::all_true(far) {
        let q = y_size / x;
        let z = q * q;
        return (q * z)
            .mul_add_op(polynomial(z, TANGENT), q)
            .xor_bits(y.sign_bit());
    }
    if T::WIDTH == 1 {
        cold_path();
    }
    general(y, x)
}

#[inline(always)]
fn general<T: Primitive>(y: T, x: T) -> T {
    let (x_size, y_size) = (x.magnitude(), y.magnitude());
    let sum = x_size + y_size;
    let steep = x_size.lt(y_size);
    let large = T::select(steep, y_size, x_size);
    let small = T::select(steep, x_size, y_size);

    // The tangent small/large, or the tangent of the angle minus π/4. The comparison uses integer factors, whose
    // products are exact for subnormals too.
    let upper = (large * T::broadcast(16.0 * MAX_DIRECT_TANGENT)).lt(small * T::broadcast(16.0));
    let q = T::select(upper, small - large, small) / T::select(upper, sum, large);
    let z = q * q;
    let within = (q * z).mul_add_op(polynomial(z, TANGENT), q);

    // Quadrant by quadrant: offset ± within, the offset as head + tail.
    let zero = T::broadcast(0.0);
    let eighth = T::select(upper, T::broadcast(FRAC_PI_4), zero);
    let eighth_tail = T::select(upper, T::broadcast(FRAC_PI_4_REST), zero);
    // A steep angle is measured back from π/2, an angle with x < 0 back from π.
    let mirror = x.sign_mask();
    let right = T::select(mirror, T::broadcast(PI), zero);
    let right_tail = T::select(mirror, T::broadcast(4.0 * FRAC_PI_4_REST), zero);
    let base = T::select(steep, T::broadcast(FRAC_PI_2), right);
    let base_tail = T::select(steep, T::broadcast(2.0 * FRAC_PI_4_REST), right_tail);
    // Sign with which the angle is measured from the offset: the signs of steep and mirrored angles cancel.
    let sense = T::select(steep, -x, x).sign_bit();
    let head = base + eighth.xor_bits(sense);
    let tail = base_tail + eighth_tail.xor_bits(sense);
    let angle = head + (within.xor_bits(sense) + tail);
    let result = T::select(sum.le(zero), zero, angle.xor_bits(y.sign_bit()));

    if T::all_true(sum.le(T::broadcast(MAX_SUM))) {
        result
    } else {
        map_lanes(y, x, result, far_atan2)
    }
}

fn far_atan2(y: f64, x: f64, near: f64) -> f64 {
    if x.abs() + y.abs() <= MAX_SUM {
        near
    } else {
        y.atan2(x)
    }
}

// Coefficients of Sun's fdlibm (1993) for (asin(s)/s - 1), numerator in powers of s² from the first.
const ARCSINE_OVER: [f64; 6] = [
    1.666_666_666_666_666_6e-1,
    -3.255_658_186_224_009e-1,
    2.012_125_321_348_629_3e-1,
    -4.005_553_450_067_941e-2,
    7.915_349_942_898_145e-4,
    3.479_331_075_960_212e-5,
];
const ARCSINE_UNDER: [f64; 5] = [
    1.0,
    -2.403_394_911_734_414,
    2.020_945_760_233_505_7,
    -6.882_839_716_054_533e-1,
    7.703_815_055_590_194e-2,
];

#[inline(always)]
pub(crate) fn asin<T: Primitive>(x: T) -> T {
    let one = T::broadcast(1.0);
    let size = x.magnitude();
    let size = T::select(one.lt(size), one, size);
    let upper = T::broadcast(0.5).lt(size);
    // asin x = π/2 - 2 asin √((1-x)/2)
    let z = T::select(upper, (one - size) * T::broadcast(0.5), size * size);
    let s = T::select(upper, z.ieee_sqrt(), size);
    let within = s.mul_add_op(
        z * polynomial(z, ARCSINE_OVER) / polynomial(z, ARCSINE_UNDER),
        s,
    );
    let from_top =
        T::broadcast(FRAC_PI_2) - ((within + within) - T::broadcast(2.0 * FRAC_PI_4_REST));
    T::select(upper, from_top, within).xor_bits(x.sign_bit())
}
