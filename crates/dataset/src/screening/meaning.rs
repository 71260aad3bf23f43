//! What the readings of an instrument may mean: axes, unit, frame, and whether gravity is among them.

use model_spec::compose::Instrument;

use super::signed_axes::SignedAxes;
use super::units::UnitOfReadings;

/// How the readings of an instrument may be meant.
#[derive(Clone, Copy)]
pub struct Meaning {
    pub axes: SignedAxes,
    pub unit: UnitOfReadings,
    /// Along the axes of the room, instead of those of the body.
    pub in_room: bool,
    /// How often the acceleration of gravity is missing: once in accelerations, instead of specific forces, and twice where
    /// it has the wrong sign.
    pub gravity_missing: u8,
}

impl Meaning {
    /// Readings along the axes of the body.
    pub fn of_unit(unit: UnitOfReadings) -> Self {
        Self {
            axes: SignedAxes::default(),
            unit,
            in_room: false,
            gravity_missing: 0,
        }
    }

    /// Readings along other axes, in the unit of a dataset.
    pub fn of_axes(axes: SignedAxes) -> Self {
        Self {
            axes,
            ..Self::of_unit(UnitOfReadings::default())
        }
    }

    /// All meanings of an instrument, that of a dataset first, and simple ones before others.
    pub fn all(instrument: Instrument) -> Vec<Self> {
        let is_accelerometer = instrument == Instrument::Accelerometer;
        let mut all = Vec::new();
        for axes in SignedAxes::all() {
            for unit in UnitOfReadings::all(instrument) {
                for in_room in [false, true] {
                    for gravity_missing in [0, 1, 2] {
                        let is_possible = is_accelerometer || gravity_missing == 0;
                        all.extend(is_possible.then_some(Self {
                            axes,
                            unit,
                            in_room,
                            gravity_missing,
                        }));
                    }
                }
            }
        }
        all.sort_by_key(Self::changes);
        all
    }

    /// Number of changes from what the readings are in a dataset.
    pub fn changes(&self) -> usize {
        let others = [self.unit.index > 0, self.in_room, self.gravity_missing > 0];
        self.axes.changes() + others.into_iter().filter(|is_other| *is_other).count()
    }
}
