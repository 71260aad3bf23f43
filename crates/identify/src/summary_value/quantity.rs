//! Quantities of a summary as functions of the motion at an event.

use dataset::SummaryQuantity;

use super::dual::{COMPONENTS, Dual, DualVector};

/// What a channel of a summary compares: a column, or what a release has by assumption where no column states it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SummaryValue {
    /// A column of a table of summaries.
    Column(SummaryQuantity),
    /// Spin of a ball about its direction of flight at the release, rad/s: 0.
    Rifle,
    /// Tilt of a body's angular momentum to the side of its motion at the release, rad: 0.
    SideWobble,
    /// Turn of a body about its own axis at the release, rad: its first axis points forward.
    Turn,
}

/// Vectors of a motion in the inertial frame: position, velocity, spin, third and first axis of the body, angular
/// momentum; zero where the model has none.
pub type Vectors = [[f64; 3]; COMPONENTS / 3];

/// Value of a quantity, SI, and its derivatives by the components of the vectors. The time of a flight is 0: it is no
/// function of the motion.
pub fn value(of: SummaryValue, vectors: &Vectors) -> Dual {
    let motion = Motion::new(vectors);
    let quantity = match of {
        SummaryValue::Column(quantity) => quantity,
        SummaryValue::Rifle => return motion.spin.dot(motion.velocity.unit()),
        SummaryValue::SideWobble => return motion.wobble()[1],
        SummaryValue::Turn => {
            let [ahead, left] = motion.ahead_and_left();
            return motion.first.dot(left).atan2(motion.first.dot(ahead));
        }
    };
    let [x, y, z] = motion.position.0;
    let [u, v, w] = motion.velocity.0;
    match quantity {
        SummaryQuantity::Speed | SummaryQuantity::LandingSpeed => motion.velocity.norm(),
        SummaryQuantity::Launch => w.atan2((u * u + v * v).sqrt()),
        SummaryQuantity::LandingAngle => (-w).atan2((u * u + v * v).sqrt()),
        SummaryQuantity::Heading => v.atan2(u),
        SummaryQuantity::Nose => {
            let [along, left, up] = motion.course().map(|axis| motion.axis.dot(axis));
            (-along).atan2((left * left + up * up).sqrt())
        }
        SummaryQuantity::Hyzer => {
            let [_, left, up] = motion.course().map(|axis| motion.axis.dot(axis));
            left.atan2(up)
        }
        SummaryQuantity::Spin | SummaryQuantity::FinalSpin => match motion.has_axis {
            true => -motion.spin.dot(motion.axis),
            false => motion.spin.norm(),
        },
        SummaryQuantity::SpinAxis => {
            let [_, left, up] = motion.course().map(|axis| motion.spin.dot(axis));
            (-up).atan2(-left)
        }
        SummaryQuantity::Wobble => motion.wobble()[0],
        SummaryQuantity::Height | SummaryQuantity::ApexHeight => z,
        SummaryQuantity::Carry | SummaryQuantity::ApexDistance => (x * x + y * y).sqrt(),
        SummaryQuantity::Side => -y,
        SummaryQuantity::HangTime => Dual::ZERO,
    }
}

struct Motion {
    position: DualVector,
    velocity: DualVector,
    spin: DualVector,
    axis: DualVector,
    first: DualVector,
    momentum: DualVector,
    has_axis: bool,
}

impl Motion {
    fn new(vectors: &Vectors) -> Self {
        let own = |k: usize| {
            DualVector([0, 1, 2].map(|axis| Dual::variable(vectors[k][axis], 3 * k + axis)))
        };
        Self {
            position: own(0),
            velocity: own(1),
            spin: own(2),
            axis: own(3),
            first: own(4),
            momentum: own(5),
            has_axis: vectors[3] != [0.0; 3],
        }
    }

    /// Axes of the velocity: along it, to its left, and up.
    fn course(&self) -> [DualVector; 3] {
        let along = self.velocity.unit();
        let [u, v, _] = self.velocity.0;
        let left = DualVector([-v, u, Dual::ZERO]).unit();
        [along, left, along.cross(left)]
    }

    /// Directions in the plane of the body: ahead, and to the left of it.
    fn ahead_and_left(&self) -> [DualVector; 2] {
        let along = self.velocity.unit();
        let ahead = along.minus(self.axis.scaled(along.dot(self.axis))).unit();
        [ahead, self.axis.cross(ahead)]
    }

    /// Angles from the body's axis to its angular momentum: ahead, and to the left.
    fn wobble(&self) -> [Dual; 2] {
        let along = self.momentum.dot(self.axis);
        let sign = if along.value < 0.0 { -1.0 } else { 1.0 };
        self.ahead_and_left().map(|axis| {
            let across = self.momentum.dot(axis).times(sign);
            across.atan2(along.times(sign))
        })
    }
}
