//! Which quantities are shown in degrees.

use model_spec::model::{Expr, ExprKind, State};

/// Unit of angles.
const RADIAN: &str = "rad";

/// Whether an expression is an angle: of unit rad, and an inverse tangent or another function. A product such as a rate times
/// a time has this unit too, and may be a ratio.
pub(crate) fn is_angle(expr: &Expr) -> bool {
    let is_function = matches!(expr.kind, ExprKind::Atan2(..) | ExprKind::Call(..));
    is_function && expr.unit.to_string() == RADIAN
}

/// Whether a state is an angle.
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
