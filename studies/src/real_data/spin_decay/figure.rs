//! Figure of the decay of a disc's spin, with the residuals of several forms of the torque.

use report::figures::{Line, Panel, figure};

use nalgebra::DVector;

use super::form::Form;
use super::results::SpinDecay;

/// Torque laws whose residuals the figure shows: proportional to the spin (as in the model), proportional to its
/// square, and proportional to the spin with a factor that falls with time (the law that the data do not reject).
const DRAWN: [Form; 3] = [Form::Linear, Form::Quadratic, Form::Falling];

/// Draws two panels as SVG: the measured spin over time, and the residuals (measured − fitted) of three torque laws.
pub(in super::super) fn spin_decay_figure(data: &SpinDecay) -> String {
    let samples = || data.record.times.iter().zip(&data.record.rates);
    let left = DRAWN.iter().filter_map(|form| {
        let unknowns = DVector::from_vec(data.fit(*form)?.unknowns.clone());
        Some(Line {
            name: form.label().into(),
            points: samples()
                .map(|(time, rate)| (*time, rate - form.at(&unknowns, *time)))
                .collect(),
        })
    });
    let panels = [
        Panel {
            title: "Rate about the axis, rad/s".into(),
            across: "time since the release, s".into(),
            lines: vec![Line {
                name: "gyroscope".into(),
                points: samples().map(|(time, rate)| (*time, *rate)).collect(),
            }],
            ..Panel::default()
        },
        Panel {
            title: "Rate less that of a torque, rad/s".into(),
            across: "time since the release, s".into(),
            lines: left.collect(),
            thin: true,
            levels: vec![0.0],
            ..Panel::default()
        },
    ];
    figure("Spin of a disc in flight", &panels)
}
