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
    /// Acceleration, instead of the specific force.
    pub without_gravity: bool,
}

impl Meaning {
    /// All meanings of an instrument, that of a dataset first, and simple ones before others.
    pub fn all(instrument: Instrument) -> Vec<Self> {
        let is_accelerometer = instrument == Instrument::Accelerometer;
        let mut all = Vec::new();
        for axes in SignedAxes::all() {
            for unit in UnitOfReadings::all(instrument) {
                for in_room in [false, true] {
                    for without_gravity in [false, true] {
                        let is_possible = is_accelerometer || !without_gravity;
                        all.extend(is_possible.then_some(Self {
                            axes,
                            unit,
                            in_room,
                            without_gravity,
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
        let others = [self.unit.index > 0, self.in_room, self.without_gravity];
        self.axes.changes() + others.into_iter().filter(|is_other| *is_other).count()
    }
}
