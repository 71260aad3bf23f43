//! Random tables of one and of two arguments, and powers with any exponent: tape and lanes against the oracle, and their
//! derivatives against dual numbers.

use crate::backends::EveryLane;
use crate::derivatives;
use crate::support::Random;
use codegen::tape_model::{At, Scratch, TapeModel};
use model_spec::model::Model;
use oracle::Point;
use oracle::scalar::ErrorBound;

const MODELS: usize = 200;

/// Error of a result in units of the rounding error of its terms, which the oracle sums up.
const MAX_ERROR: f64 = 16.0 * f64::EPSILON;

fn whole(random: &mut Random, least: usize, greatest: usize) -> usize {
    let share = f64::midpoint(random.next(), 1.0);
    least + (share * (greatest - least + 1) as f64) as usize
}

/// `count` knots between about -2 and 2.
fn knots(random: &mut Random, count: usize) -> Vec<String> {
    let width = 4.0 / count as f64;
    let knot = |k: usize| -2.0 + width * (k as f64 + 0.4 * random.next() + 0.5);
    (0..count).map(knot).map(|x| format!("{x:?}")).collect()
}

fn row(random: &mut Random, count: usize) -> String {
    let values: Vec<String> = (0..count).map(|_| format!("{:?}", random.next())).collect();
    values.join(", ")
}

fn model(random: &mut Random) -> Model {
    let ways = ["", "constant", "linear", "linear, constant", "monotone"];
    let way = |random: &mut Random, last: usize| ways[whole(random, 0, last)];
    let count = whole(random, 2, 9);
    let one: Vec<String> = knots(random, count).into_iter().collect();
    let one: Vec<String> = one
        .into_iter()
        .map(|x| format!("{x}: {}", row(random, 1)))
        .collect();
    let of_one = way(random, 4);
    let (rows, columns) = (whole(random, 2, 7), whole(random, 2, 7));
    let second = knots(random, columns).join(", ");
    let rows = knots(random, rows).into_iter();
    let rows: Vec<String> = rows
        .map(|x| format!("{x}: ({})", row(random, columns)))
        .collect();
    let of_two = way(random, 3);
    let exponent = 3.0 * random.next();
    let text = format!(
        "model random; param n = 1.3; param tau = 1 s; coefficient c = 0.7; frame N;
         state a = 0.3; state b = -0.4; state e = 0.2;
         table one(x) = {{ {} }} {of_one};
         table two(x, y) = {{ y: ({second}), {} }} {of_two};
         der(a) = one(a + c*b)*two(b, e)/tau;
         der(b) = (two(c*a, one(e) + b) + (b^2 + 0.1)^({exponent:?}))/tau;
         der(e) = (abs(a)^n*c + (2 + cos(e))^(n*b) - e^1.85)/tau;",
        one.join(", "),
        rows.join(", ")
    );
    model_spec::load::from_text("random", &text, &[]).unwrap_or_else(|e| panic!("{text}\n{e}"))
}

#[test]
fn random_tables_and_powers_agree_on_every_way() {
    let mut random = Random(19);
    for _ in 0..MODELS {
        let model = model(&mut random);
        let compiled = codegen::compile(&model);
        let tape = TapeModel::new(&compiled);
        let default = &compiled.layout.defaults;
        let points: Vec<(Vec<f64>, Vec<f64>)> = (0..8)
            .map(|_| {
                let states = (0..3).map(|_| 1.5 * random.next()).collect();
                let parameters = default.iter().map(|p| p * (1.0 + 0.3 * random.next()));
                (states, parameters.collect())
            })
            .collect();
        for (x, p) in &points[..3] {
            derivatives::check(&compiled, x, p);
            let mut point = Point::defaults(&model);
            point.states.clone_from(x);
            point
                .parameters_mut()
                .zip(p)
                .for_each(|(to, from)| *to = *from);
            let expected =
                oracle::derivatives(&model, &point.lift::<ErrorBound>()).expect("stated");
            let prepared = tape.prepare(p);
            let at = At {
                t: 0.0,
                x,
                p,
                prepared: &prepared,
            };
            let mut found = vec![0.0; 3];
            tape.f
                .eval(at, &[], &mut Scratch::default(), &mut [&mut found]);
            for (expected, found) in expected.iter().zip(found) {
                let error = expected.relative_error(found);
                assert!(
                    error < MAX_ERROR,
                    "{found} and {expected:?}\n{}",
                    model.sources[0].text
                );
            }
        }
        lanes::dispatch(EveryLane {
            compiled: &compiled,
            points: &points,
        });
    }
}
