//! Decides which quantities are shown in degrees.

pub(crate) use identify::numbers::is_angle;
use model_spec::model::State;

/// Unit, as text, by which a quantity is recognised as an angle.
const RADIAN: &str = "rad";

/// Whether a state has unit rad, so that it is shown in degrees.
pub(crate) fn is_angle_state(state: &State) -> bool {
    state.unit.to_string() == RADIAN
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ratio_in_radians_is_no_angle() {
        let model = model_spec::load::load("disc", &[]).unwrap();
        let of = |name: &str| model.aux_variables.iter().find(|v| v.name == name).unwrap();
        assert!(is_angle(&of("alpha").value));
        assert!(!is_angle(&of("spin_ratio").value) && !is_angle(&of("V").value));
        let angles = model.states.iter().filter(|s| is_angle_state(s)).count();
        assert_eq!(angles, 3);
    }
}
