//! Figure of the decay of a spin: what each form of the torque leaves.

use report::figures::{Line, Panel, figure};

use nalgebra::DVector;

use super::form::Form;
use super::results::SpinDecay;

/// Forms that are drawn: the model's own, its square, and the one that is not rejected.
const DRAWN: [Form; 3] = [Form::Linear, Form::Quadratic, Form::Falling];

/// The rate and what three forms leave of it, SVG.
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
