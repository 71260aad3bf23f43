use super::*;

type Function = fn(Enclosure) -> Enclosure;

/// A function over enclosures and over numbers.
macro_rules! both {
    ($(|$x:ident| $value:expr),* $(,)?) => {
        [$({
            fn of<T: Real>($x: T) -> T {
                $value
            }
            (stringify!($value), of::<Enclosure> as Function, of::<f64> as fn(f64) -> f64)
        }),*]
    };
}

fn number<T: Real>(value: f64) -> T {
    T::splat(value)
}

/// Values in a range, and differences of neighbours, are within the bounds; those of narrow ranges are near them.
#[test]
fn bounds_hold_what_a_function_does() {
    let functions = both!(
        |x| x * x - number::<T>(3.0) * x,
        |x| (x * x + number(0.01)).sqrt(),
        |x| number::<T>(1.0) / (number::<T>(1.0) + x * x),
        |x| x.sin_cos().0 * (number::<T>(3.0) * x).sin_cos().1,
        |x| (x * x * number(-4.0)).exp(),
        |x| (x * number(5.0)).tanh() - x.abs(),
        |x| (x * x + number(0.5)).log(),
        |x| (x * number(0.3)).asin(),
        |x| x.min(number::<T>(1.0) - x).max(number(-2.0)),
        |x| (x + number(4.0)).atan2(x * x - number(1.0)),
        |x| x.sign() + (x - number(0.7)).heaviside(),
        |x| x.piecewise_cubic(
            &[-1.0, 0.5, 2.0],
            &[
                [1.0, -0.5, 0.0, 0.0],
                [1.0, 2.0, -1.0, 0.3],
                [2.7625, 0.0, 1.0, 0.0],
                [5.0125, 0.0, 0.0, 0.0]
            ],
        ),
        |x| x.recip_or_zero().if_zero(number(2.0), x),
    );
    for (name, enclosed, exact) in functions {
        for k in 0..60 {
            for half in [1.5, 0.3, 0.01, 1e-5] {
                let middle = -3.0 + 0.1 * f64::from(k) + 0.013;
                let of = enclosed(Enclosure::polynomial(&[middle, half]));
                let at = |u: f64| exact(middle + half * u);
                let tiny = 1e-12 * (1.0 + at(0.0).abs());
                for n in 0..40 {
                    let [u, v] = [n, n + 1].map(|n| f64::from(n) / 20.0 - 1.0);
                    let slope = (at(v) - at(u)) / (v - u);
                    let holds = |[low, high]: Interval, value: f64| {
                        low - 40.0 * tiny <= value && value <= high + 40.0 * tiny
                    };
                    assert!(
                        holds(of.range, at(u)),
                        "{name} at {middle} +- {half}: {of:?}"
                    );
                    assert!(
                        holds(of.slope, slope),
                        "{name} at {middle} +- {half}: {of:?} {slope}"
                    );
                }
            }
        }
    }
}

/// The excess of the range falls with the square of its width, which a difference of near values needs.
#[test]
fn narrow_ranges_are_tight() {
    let excess = |half: f64| {
        let x = Enclosure::polynomial(&[33.2, half]);
        let square = x * x - Enclosure::splat(66.0) * x + Enclosure::splat(1089.0);
        let [low, high] = square.range();
        high - low - 4.0 * 0.2 * half
    };
    assert!(excess(1e-3) < 1e-5 && excess(1e-4) < 1e-7);
    let x = Enclosure::polynomial(&[33.2, 0.01]);
    assert!((x * x - Enclosure::splat(66.0) * x).is_monotone());
    assert!(!(Enclosure::polynomial(&[0.001, 0.01])).abs().is_monotone());
}
