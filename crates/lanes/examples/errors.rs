//! Prints `function argument… result` lines in hexadecimal bits, for comparison with a multiple-precision reference.

use lanes::{ElementaryFunction, Real};

fn main() {
    let count: usize = std::env::args()
        .nth(1)
        .and_then(|n| n.parse().ok())
        .unwrap_or(20_000);
    let mut seed = 7_u64;
    let mut unit = || {
        seed = seed
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (seed >> 11) as f64 / (1_u64 << 53) as f64
    };
    let line = |name: &str, a: f64, b: f64, r: f64| {
        println!(
            "{name} {:x} {:x} {:x}",
            a.to_bits(),
            b.to_bits(),
            r.to_bits()
        );
    };
    for _ in 0..count {
        let sign = if unit() < 0.5 { -1.0 } else { 1.0 };
        // Doubles next to multiples of π/2 are the hard cases of argument reduction.
        let near = ((unit() * 63660.0).floor() * std::f64::consts::FRAC_PI_2).next_up();
        for x in [
            sign * 10_f64.powf(unit() * 8.0 - 3.0),
            3.2 * sign * unit(),
            near,
            near.next_down(),
        ] {
            let (s, c) = Real::sin_cos(x);
            line("sin", x, 0.0, s);
            line("cos", x, 0.0, c);
        }
        let (y, x) = (sign * 10_f64.powf(unit() * 2.0 - 1.0), unit() * 2.0 - 1.0);
        line("atan2", y, x, Real::atan2(y, x));
        line("atan2", x, y, Real::atan2(x, y));
        for function in ElementaryFunction::ALL {
            let arguments = match function {
                ElementaryFunction::Exp => [708.0 * x, x],
                ElementaryFunction::Log => [y.abs(), 1.0 + 0.3 * x],
                _ => [0.5 * x, x],
            };
            for x in arguments {
                line(function.name(), x, 0.0, x.elementary(function));
            }
        }
    }
}
