//! The kinds of mistakes with which data are spoiled.

use super::harm::{self, Harm};

/// A kind of mistake that a laboratory could make in a recording, and the change of the data that the mistake causes.
#[derive(Clone, Copy)]
pub struct Kind {
    /// Name of the kind, as given on the command line.
    pub name: &'static str,
    /// Description of the mistake.
    pub what: &'static str,
    /// Whether the mistake affects the whole dataset (its template or parameters) rather than single flights.
    pub of_dataset: bool,
    pub(super) harm: Harm,
}

const fn flight(name: &'static str, what: &'static str, harm: harm::FlightHarm) -> Kind {
    Kind {
        name,
        what,
        of_dataset: false,
        harm: Harm::Flight(harm),
    }
}

const fn dataset(name: &'static str, what: &'static str, harm: harm::DatasetHarm) -> Kind {
    Kind {
        name,
        what,
        of_dataset: true,
        harm: Harm::Dataset(harm),
    }
}

/// Every kind of recording mistake that the study introduces into the data.
#[rustfmt::skip]
pub const KINDS: &[Kind] = &[
    flight("labels_12", "labels m1 and m2 exchanged", harm::labels_12),
    flight("labels_23", "labels m2 and m3 exchanged", harm::labels_23),
    flight("labels_cycle", "all three labels passed on", harm::labels_cycle),
    flight("labels_from_middle", "labels m1 and m3 exchanged from mid-flight on", harm::labels_from_middle),
    flight("labels_flicker", "labels m1 and m2 exchanged in a tenth of the samples", harm::labels_flicker),
    flight("mirrored_y", "left-handed axes: y counted to the other side", harm::mirrored_y),
    flight("mirrored_xy", "x and y exchanged", harm::mirrored_xy),
    flight("mirrored_z", "z counted downwards, left-handed", harm::mirrored_z),
    flight("z_down", "z down, by a half turn about x", harm::z_down),
    flight("y_up", "y up instead of z", harm::y_up),
    flight("x_up", "x up instead of z", harm::x_up),
    flight("feet", "lengths in feet", harm::feet),
    flight("inches", "lengths in inches", harm::inches),
    flight("centimetres", "lengths in centimetres", harm::centimetres),
    flight("millimetres", "lengths in millimetres", harm::millimetres),
    flight("milliseconds", "times in milliseconds", harm::milliseconds),
    flight("double_time", "times doubled", harm::double_time),
    flight("half_time", "times halved", harm::half_time),
    flight("wrong_rate", "sampled at 100 Hz, said to be 120 Hz", harm::wrong_rate),
    flight("dropped_frames", "a tenth of the frames lost, and the times closed up", harm::dropped_frames),
    flight("pause", "times jump by 0.2 s in mid-flight", harm::pause),
    flight("jitter", "times off by 2 ms at random", harm::jitter),
    flight("reversed", "samples in reverse order", harm::reversed),
    flight("frozen_marker", "m2 frozen from mid-flight on", harm::frozen_marker),
    flight("frozen", "all markers frozen from mid-flight on", harm::frozen),
    flight("teleporting_marker", "m3 half a metre off in three bursts of eight samples", harm::teleporting_marker),
    flight("jump", "all markers a metre off from mid-flight on", harm::jump),
    flight("marker_off", "m1 a metre off in every sample", harm::marker_off),
    flight("flight_off", "the whole flight a metre off, which is harmless", harm::flight_off),
    flight("constant", "every sample the same", harm::constant),
    flight("random", "random positions within a metre", harm::random),
    flight("in_the_hand", "half a second in the hand before the release", harm::in_the_hand),
    flight("after_the_catch", "half a second held after a catch", harm::after_the_catch),
    flight("bounce", "bounces and flies on", harm::bounce),
    flight("at_rest", "lies still for 0.4 s after the flight", harm::at_rest),
    flight("duplicated", "the samples of another flight", harm::duplicated),
    flight("joined", "two flights in one table", harm::joined),
    flight("foreign_marker", "m3 of another flight", harm::foreign_marker),
    flight("late_marker", "m2 sampled 25 ms after the others", harm::late_marker),
    flight("one_point", "all markers at one point", harm::one_point),
    flight("slow_frames", "every twelfth sample alone: whole turns between frames", harm::slow_frames),
    flight("dropouts", "70 % of the positions missing", harm::dropouts),
    flight("unseen_marker", "m3 never seen", harm::unseen_marker),
    flight("outliers", "a tenth of the positions half a metre off", harm::outliers),
    flight("noisy", "noise of 3 cm", harm::noisy),
    flight("smoothed", "positions averaged over eleven samples", harm::smoothed),
    flight("single_precision", "single precision, 100 km from the origin", harm::single_precision),
    flight("millimetre_steps", "positions rounded to a millimetre", harm::millimetre_steps),
    flight("centimetre_steps", "positions rounded to a centimetre", harm::centimetre_steps),
    dataset("template_5_mm", "m2 stated 5 mm from where it is", harm::template_5_mm),
    dataset("template_50_mm", "m2 stated 5 cm from where it is", harm::template_50_mm),
    dataset("template_mirrored", "positions of the markers stated mirrored", harm::template_mirrored),
    dataset("template_scale", "positions of the markers stated in centimetres", harm::template_centimetres),
    dataset("moon", "gravity stated as 1.62 m/s²", harm::moon),
];
