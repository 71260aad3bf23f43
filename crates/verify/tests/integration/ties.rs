//! `min` and `max` of equal arguments: compiler and oracle take the derivative of the second.

use codegen::compile::compile;
use codegen::tape_model::{At, Scratch, TapeModel};
use model_spec::load::from_text;
use oracle::scalar::NumDual;
use oracle::{Point, derivatives};

#[test]
fn both_take_the_derivative_of_the_second_argument() {
    let text = "model tie; param tau = 1 s; state a = 1; state b = 1; frame N;
        der(a) = min(a, b)/tau; der(b) = max(b, a)/tau;";
    let model = from_text("tie.hyz", text, &[]).unwrap();

    let compiled = compile(&model);
    let tape = TapeModel::new(&compiled);
    let (x, p) = (&compiled.layout.initial, &compiled.layout.defaults);
    let prepared = tape.prepare(p);
    let at = At {
        t: 0.0,
        x,
        p,
        prepared: &prepared,
    };
    let pattern = tape.f_jac_par.pattern("j");
    let (mut dx, mut entries) = (vec![0.0; 2], vec![0.0; pattern.len()]);
    let mut by_parameters = vec![0.0; tape.f_jac_par.pattern("jp").len()];
    let results = &mut [&mut dx[..], &mut entries, &mut by_parameters];
    tape.f_jac_par
        .eval(at, &[], &mut Scratch::default(), results);
    let mut found = [[0.0; 2]; 2];
    for (&(row, column), value) in pattern.iter().zip(&entries) {
        found[row as usize][column as usize] = *value;
    }
    assert_eq!(found, [[0.0, 1.0], [1.0, 0.0]]);

    for column in 0..2 {
        let mut point = Point::defaults(&model).lift::<NumDual>();
        point.states[column] = NumDual::new(1.0, 1.0);
        let rates = derivatives(&model, &point).unwrap();
        let by: Vec<f64> = rates.iter().map(|rate| rate.derivative()).collect();
        assert_eq!(by, found.map(|row| row[column]));
    }
}
