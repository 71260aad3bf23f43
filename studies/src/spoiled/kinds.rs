//! The kinds of mistakes with which data are spoiled.

use nalgebra::Vector3;

use super::harm::{self, Harm};
use super::kinematics::moved;

/// A kind of mistake that a laboratory could make in a recording, and the resulting change of the data.
#[derive(Clone, Copy)]
pub struct Kind {
    /// Name of this kind of recording mistake, with which a user selects it on the command line.
    pub name: &'static str,
    /// Description of the recording mistake, such as "labels m1 and m2 exchanged".
    pub what: &'static str,
    pub(super) harm: Harm,
}

impl Kind {
    /// Whether the recording mistake affects the whole dataset (its marker template or parameters) rather than single
    /// flights.
    pub fn is_of_dataset(&self) -> bool {
        matches!(self.harm, Harm::Template(_) | Harm::Dataset(_))
    }
}

const fn kind(name: &'static str, what: &'static str, harm: Harm) -> Kind {
    Kind { name, what, harm }
}

/// Every kind of recording mistake that the study introduces into the data.
#[rustfmt::skip]
pub const KINDS: &[Kind] = &[
    kind("labels_12", "labels m1 and m2 exchanged", Harm::Samples(|row| row.swap(0, 1))),
    kind("labels_23", "labels m2 and m3 exchanged", Harm::Samples(|row| row.swap(1, 2))),
    kind("labels_cycle", "all three labels passed on", Harm::Samples(|row| row.rotate_left(1))),
    kind("labels_from_middle", "labels m1 and m3 exchanged from mid-flight on", Harm::LaterSamples(|row| row.swap(0, 2))),
    kind("labels_flicker", "labels m1 and m2 exchanged in a tenth of the samples", Harm::Flight(harm::labels_flicker)),
    kind("mirrored_y", "left-handed axes: y counted to the other side", Harm::Points(|[x, y, z]| [x, -y, z])),
    kind("mirrored_xy", "x and y exchanged", Harm::Points(|[x, y, z]| [y, x, z])),
    kind("mirrored_z", "z counted downwards, left-handed", Harm::Points(|[x, y, z]| [x, y, -z])),
    kind("z_down", "z down, by a half turn about x", Harm::Points(|[x, y, z]| [x, -y, -z])),
    kind("y_up", "y up instead of z", Harm::Points(|[x, y, z]| [x, z, -y])),
    kind("x_up", "x up instead of z", Harm::Points(|[x, y, z]| [z, y, -x])),
    kind("feet", "lengths in feet", Harm::Lengths(1.0 / 0.3048)),
    kind("inches", "lengths in inches", Harm::Lengths(1.0 / 0.0254)),
    kind("centimetres", "lengths in centimetres", Harm::Lengths(100.0)),
    kind("millimetres", "lengths in millimetres", Harm::Lengths(1000.0)),
    kind("milliseconds", "times in milliseconds", Harm::Times(1000.0)),
    kind("double_time", "times doubled", Harm::Times(2.0)),
    kind("half_time", "times halved", Harm::Times(0.5)),
    kind("wrong_rate", "sampled at 100 Hz, said to be 120 Hz", Harm::Times(100.0 / 120.0)),
    kind("dropped_frames", "a tenth of the frames lost, and the times closed up", Harm::Flight(harm::dropped_frames)),
    kind("pause", "times jump by 0.2 s in mid-flight", Harm::Flight(harm::pause)),
    kind("jitter", "times off by 2 ms at random", Harm::Flight(harm::jitter)),
    kind("reversed", "samples in reverse order", Harm::Flight(|flight, _, _| flight.positions.reverse())),
    kind("frozen_marker", "m2 frozen from mid-flight on", Harm::Flight(harm::frozen_marker)),
    kind("frozen", "all markers frozen from mid-flight on", Harm::Flight(harm::frozen)),
    kind("teleporting_marker", "m3 half a metre off in three bursts of eight samples", Harm::Flight(harm::teleporting_marker)),
    kind("jump", "all markers a metre off from mid-flight on", Harm::LaterSamples(|row| *row = moved(row, Vector3::new(0.0, 1.0, 0.0)))),
    kind("marker_off", "m1 a metre off in every sample", Harm::Samples(|row| row[0] = row[0].map(|[x, y, z]| [x, y + 1.0, z]))),
    kind("flight_off", "the whole flight a metre off, which is harmless", Harm::Samples(|row| *row = moved(row, Vector3::new(0.3, 1.0, 0.0)))),
    kind("constant", "every sample the same", Harm::Flight(harm::constant)),
    kind("random", "random positions within a metre", Harm::Flight(harm::random)),
    kind("in_the_hand", "half a second in the hand before the release", Harm::Flight(harm::in_the_hand)),
    kind("after_the_catch", "half a second held after a catch", Harm::Flight(harm::after_the_catch)),
    kind("bounce", "bounces and flies on", Harm::Flight(harm::bounce)),
    kind("at_rest", "lies still for 0.4 s after the flight", Harm::Flight(harm::at_rest)),
    kind("duplicated", "the samples of another flight", Harm::Flight(harm::duplicated)),
    kind("joined", "two flights in one table", Harm::Flight(harm::joined)),
    kind("foreign_marker", "m3 of another flight", Harm::Flight(harm::foreign_marker)),
    kind("late_marker", "m2 sampled 25 ms after the others", Harm::Flight(harm::late_marker)),
    kind("one_point", "all markers at one point", Harm::Samples(harm::one_point)),
    kind("slow_frames", "every twelfth sample alone: whole turns between frames", Harm::Flight(harm::slow_frames)),
    kind("dropouts", "70 % of the positions missing", Harm::Flight(harm::dropouts)),
    kind("unseen_marker", "m3 never seen", Harm::Samples(|row| row[2] = None)),
    kind("outliers", "a tenth of the positions half a metre off", Harm::Flight(harm::outliers)),
    kind("noisy", "noise of 3 cm", Harm::Flight(harm::noisy)),
    kind("smoothed", "positions averaged over eleven samples", Harm::Flight(harm::smoothed)),
    kind("single_precision", "single precision, 100 km from the origin", Harm::Points(|[x, y, z]| [x + 1e5, y, z].map(|x| f64::from(x as f32)))),
    kind("millimetre_steps", "positions rounded to a millimetre", Harm::Points(|p| p.map(|x| (x * 1000.0).round() / 1000.0))),
    kind("centimetre_steps", "positions rounded to a centimetre", Harm::Points(|p| p.map(|x| (x * 100.0).round() / 100.0))),
    kind("template_5_mm", "m2 stated 5 mm from where it is", Harm::Dataset(|data| data.markers[1].position[0] += 0.005)),
    kind("template_50_mm", "m2 stated 5 cm from where it is", Harm::Dataset(|data| data.markers[1].position[0] += 0.05)),
    kind("template_mirrored", "positions of the markers stated mirrored", Harm::Template(|[x, y, z]| [x, -y, z])),
    kind("template_scale", "positions of the markers stated in centimetres", Harm::Template(|p| p.map(|x| x * 100.0))),
    kind("moon", "gravity stated as 1.62 m/s²", Harm::Dataset(harm::moon)),
];
