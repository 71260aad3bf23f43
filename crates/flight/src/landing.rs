//! Flights that are wanted at many times: their steps end there, so that no curve within a step is needed.

use crate::control::{Control, first_step};
use crate::dynamics::Dynamics;
use crate::error::FlightError;
use crate::integrate::{Options, Work, check_start, no_answer, not_finite, stuck, too_many_steps};
use crate::method::tsit5::Tsit5;
use crate::method::{Start, Stepper, Tolerance};

/// Flies and writes the states at `times` (s, in order, from the start's on), one after the other, to `samples`. Between two
/// of them it takes as many equal steps of Tsit5 as the tolerance asks for. Quicker than [`fly_at`](crate::fly_at) where the
/// times are as close as its steps would be, and for long states; slower where they are much closer.
///
/// # Errors
/// Where the flight becomes impossible.
///
/// # Panics
/// Where `samples` has not room for exactly all states at all times, or times are not in order.
pub fn fly_landing<D: Dynamics>(
    d: &mut D,
    (start, x): (f64, &D::State),
    times: &[f64],
    options: &Options,
    samples: &mut [f64],
) -> Result<Work, FlightError> {
    let n = x.as_ref().len();
    assert_eq!(
        samples.len(),
        n * times.len(),
        "room for all states at all times"
    );
    assert!(
        times.is_sorted() && times.first().is_none_or(|t| *t >= start),
        "times in order"
    );
    let mut work = Work::default();
    let Some(&end) = times.last().filter(|end| **end > start) else {
        samples
            .chunks_mut(n)
            .for_each(|to| to.copy_from_slice(x.as_ref()));
        return Ok(work);
    };
    let (mut t, mut x) = (start, x.clone());
    let mut dx = x.clone();
    check_start(d, t, &x, end, options)?;
    d.derivative(t, &x, &mut dx);
    if let Some(i) = not_finite(&dx) {
        return Err(no_answer(d, t, &x, i, dx.as_ref()[i]));
    }
    let within = Tolerance {
        relative: options.relative,
        absolute: options.absolute,
        controlled: d.controlled(),
    };
    let order = Tsit5::<D::State>::ORDER;
    let mut control = Control::new(order, Tsit5::<D::State>::MEMORY, Tsit5::<D::State>::FACTORS);
    let mut stepper = Tsit5::new(&x);
    let longest = options.longest_step.min(end - t);
    let begin = Start { t, x: &x, dx: &dx };
    let mut wanted = options
        .first_step
        .unwrap_or_else(|| first_step(d, &begin, order, &within, longest));
    work.evaluations += 2;
    let shortest = 1e-14 * t.abs().max(end.abs()).max(end - t);
    for (to, &time) in samples.chunks_mut(n).zip(times) {
        while t < time {
            let remains = time - t;
            let pieces = (remains / wanted.min(longest) * (1.0 - 1e-10))
                .ceil()
                .max(1.0);
            let last = pieces <= 1.0;
            let h = remains / pieces;
            let t_end = if last { time } else { t + h };
            if work.steps + work.refused >= options.most_steps {
                return Err(too_many_steps(d, t, &x, work));
            }
            let mut error = stepper.attempt(d, &Start { t, x: &x, dx: &dx }, h, &within);
            work.evaluations += Tsit5::<D::State>::EVALUATIONS;
            if error <= 1.0
                && (not_finite(stepper.end()).or(not_finite(stepper.end_rate()))).is_some()
            {
                error = f64::NAN;
            }
            if error.is_nan() || error > 1.0 {
                work.refused += 1;
                wanted = h * control.rejected(error);
                if wanted <= shortest {
                    return Err(stuck(d, t, &x, &dx, wanted));
                }
                continue;
            }
            work.steps += 1;
            wanted = h * control.accepted(error);
            x.clone_from(stepper.end());
            dx.clone_from(stepper.end_rate());
            t = t_end;
        }
        to.copy_from_slice(x.as_ref());
    }
    Ok(work)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Method, equations, fly_at};

    #[test]
    fn it_lands_where_a_curve_passes() {
        let names = ["x", "v"];
        let spring = |_: f64, x: &[f64; 2], dx: &mut [f64; 2]| *dx = [x[1], -2500.0 * x[0]];
        let times: Vec<f64> = [0.0, 0.001, 0.5, 0.5, 0.507, 1.0, 1.0083].into();
        let (mut landed, mut passed) = ([0.0; 14], [0.0; 14]);
        let options = Options::tolerance(1e-7);
        let from = (0.0, &[1.0, 0.0]);
        let work = fly_landing(
            &mut equations(&names, spring),
            from,
            &times,
            &options,
            &mut landed,
        );
        assert!(work.unwrap().steps > 20);
        let exact = Options {
            method: Method::Dop853,
            ..Options::tolerance(1e-12)
        };
        fly_at(
            &mut equations(&names, spring),
            from,
            &times,
            &exact,
            &mut [],
            &mut passed,
        )
        .unwrap();
        for (a, b) in landed.iter().zip(passed) {
            assert!((a - b).abs() < 2e-3, "{landed:?} {passed:?}");
        }
        assert_eq!(landed[4..6], landed[6..8]);
    }

    #[test]
    fn the_impossible_is_an_error() {
        let blows_up = |_: f64, x: &[f64; 1], dx: &mut [f64; 1]| *dx = [x[0] * x[0]];
        let mut samples = [0.0; 2];
        let options = Options::default();
        let result = fly_landing(
            &mut equations(&["x"], blows_up),
            (0.0, &[1.0]),
            &[0.5, 2.0],
            &options,
            &mut samples,
        );
        assert!(result.is_err());
    }
}
