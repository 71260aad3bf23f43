//! The classes of recordings of a disc without hidden physics.

use rand::RngExt;
use rand_chacha::ChaCha12Rng;

use super::case::Group;
use super::mistakes::{self, Spoil, uniform};
use super::setting::{Measured, Setting};

/// A class of recordings: how its setting differs from a usual one, and what happens to the recording afterwards.
#[derive(Debug)]
pub(super) struct Class {
    /// Name of the class on the page and on the command line.
    pub(super) name: &'static str,
    pub(super) group: Group,
    /// What is measured: one of these is drawn.
    pub(super) measured: &'static [Measured],
    /// Number of datasets relative to that of another class.
    pub(super) share: usize,
    /// Changes the setting before the flights are simulated.
    pub(super) prepare: fn(&mut Setting, &mut ChaCha12Rng),
    /// Changes the recording.
    pub(super) spoil: Spoil,
}

use Measured::{Gyroscope, Inertial, Markers, MarkersAndInertial, Pose, PoseAndGyroscope, Speed};

fn same(_: &mut Setting, _: &mut ChaCha12Rng) {}

const fn clean(name: &'static str, measured: &'static [Measured], share: usize) -> Class {
    Class {
        name,
        group: Group::Clean,
        measured,
        share,
        prepare: same,
        spoil: mistakes::none,
    }
}

const fn mistake(name: &'static str, measured: &'static [Measured], spoil: Spoil) -> Class {
    Class {
        group: Group::Mistake,
        spoil,
        ..clean(name, measured, 1)
    }
}

const MARKERS: &[Measured] = &[Markers, Markers, MarkersAndInertial];
const POSES: &[Measured] = &[Pose, PoseAndGyroscope];
const GYROSCOPES: &[Measured] = &[PoseAndGyroscope, MarkersAndInertial, Inertial, Gyroscope];
const ALL: &[Measured] = &[
    Markers,
    Markers,
    Pose,
    PoseAndGyroscope,
    MarkersAndInertial,
    Inertial,
];

/// Classes of recordings of a disc without hidden physics.
pub(super) const CLASSES: &[Class] = &[
    clean("nothing wrong: markers", &[Markers], 6),
    clean("nothing wrong: pose", POSES, 3),
    clean(
        "nothing wrong: markers and inertial",
        &[MarkersAndInertial],
        2,
    ),
    clean("nothing wrong: gyroscope and accelerometer", &[Inertial], 2),
    clean("nothing wrong: gyroscope alone", &[Gyroscope], 1),
    clean("nothing wrong: speed alone", &[Speed], 1),
    Class {
        prepare: fast_spin,
        ..mistake(
            "spin above half of the frame rate",
            &[Markers, Markers, Pose],
            mistakes::none,
        )
    },
    mistake("quaternions conjugated", POSES, mistakes::conjugate),
    mistake("body axes of a y-up tracker", POSES, mistakes::y_up_body),
    mistake(
        "accelerometer in g",
        &[Inertial, MarkersAndInertial],
        mistakes::in_g,
    ),
    mistake(
        "gyroscope in degrees per second",
        GYROSCOPES,
        mistakes::in_degrees,
    ),
    Class {
        prepare: same,
        ..mistake("gyroscope saturated", GYROSCOPES, mistakes::saturate)
    },
    Class {
        prepare: rolling_shutter,
        ..mistake("rolling shutter", &[Markers], mistakes::rolling_shutter)
    },
    mistake("low-pass filter", &[Markers], mistakes::low_pass),
    Class {
        prepare: slow_frames,
        ..mistake("upsampled", &[Markers], mistakes::upsample)
    },
    Class {
        prepare: latency,
        ..mistake(
            "latency between sensors",
            &[PoseAndGyroscope, MarkersAndInertial],
            mistakes::late,
        )
    },
    Class {
        prepare: many_flights,
        ..mistake("drift of the calibration", &[Markers], mistakes::drift)
    },
    mistake(
        "marker off in the plane",
        MARKERS,
        mistakes::marker_off_in_plane,
    ),
    mistake(
        "markers off along the axis",
        MARKERS,
        mistakes::markers_off_along_axis,
    ),
    mistake(
        "mass centre off the axis",
        MARKERS,
        mistakes::mass_centre_off,
    ),
    mistake("template tilted", MARKERS, mistakes::template_tilted),
    Class {
        prepare: other_disc,
        ..mistake("another disc among the flights", ALL, mistakes::none)
    },
    mistake("prior in conflict", ALL, mistakes::prior_in_conflict),
    mistake("held value wrong", ALL, mistakes::held_wrong),
    mistake("bound excludes the truth", ALL, mistakes::bound_excludes),
    mistake("wrong mass", ALL, mistakes::wrong_mass),
    mistake("wrong inertia", ALL, mistakes::wrong_inertia),
    Class {
        prepare: outliers,
        ..mistake("outliers", MARKERS, mistakes::none)
    },
    mistake("markers swapped", MARKERS, mistakes::swap_markers),
];

fn fast_spin(setting: &mut Setting, _: &mut ChaCha12Rng) {
    setting.rate = 30.0;
    setting.throws.spin = (98.0, 125.0);
}

fn rolling_shutter(setting: &mut Setting, random: &mut ChaCha12Rng) {
    setting.row_time = uniform(random, 3e-4, 4e-3);
}

/// Frame rates of a camera whose tracks are interpolated.
fn slow_frames(setting: &mut Setting, random: &mut ChaCha12Rng) {
    setting.rate = [30.0, 50.0, 60.0, 120.0][random.random_range(0..4)];
}

fn latency(setting: &mut Setting, random: &mut ChaCha12Rng) {
    setting.latency = uniform(random, 2e-3, 3e-2);
}

fn many_flights(setting: &mut Setting, _: &mut ChaCha12Rng) {
    setting.flights = setting.flights.max(3);
}

fn other_disc(setting: &mut Setting, random: &mut ChaCha12Rng) {
    many_flights(setting, random);
    let other = setting
        .truth
        .iter()
        .map(|(name, value)| (*name, value * uniform(random, 0.6, 1.4)));
    let other = other.collect();
    setting.other_disc = Some((random.random_range(0..setting.flights), other));
}

fn outliers(setting: &mut Setting, random: &mut ChaCha12Rng) {
    setting.noise.outliers = uniform(random, 0.02, 0.1);
    setting.noise.outlier_size = uniform(random, 0.02, 0.5);
}
