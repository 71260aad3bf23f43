//! Decides which quantities are shown in degrees.

use model_spec::model::{Expr, ExprKind, State};

/// Unit, as text, by which a quantity is recognised as an angle.
const RADIAN: &str = "rad";

/// Whether an expression is an angle; a product with the unit rad may be a dimensionless ratio, such as the spin ratio.
pub(crate) fn is_angle(expr: &Expr) -> bool {
    let is_function = matches!(expr.kind, ExprKind::Atan2(..) | ExprKind::Call(..));
    is_function && expr.unit.to_string() == RADIAN
}

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
