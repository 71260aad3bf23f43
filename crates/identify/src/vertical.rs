//! The effect with which a model rotates measured axes whose vertical is not known.

use model_spec::model::Model;

/// Name of the effect that rotates the axes in which positions are measured.
pub const EFFECT: &str = "unknown_vertical";

/// Its coefficients, rotation angles, rad: about x, then about the rotated y.
pub const ANGLES: [&str; 2] = ["vertical_x", "vertical_y"];

/// Whether the model includes the effect that rotates the axes in which positions are measured.
pub(crate) fn is_in(model: &Model) -> bool {
    model.effects.iter().any(|own| own.name == EFFECT)
}

/// Angles of the measured axes about x and then y, rad, so that the vector `up` in them points upward.
pub(crate) fn angles([x, y, z]: [f64; 3]) -> [f64; 2] {
    let length = (x * x + y * y + z * z).sqrt();
    // In measured axes the vertical is (-sin b cos a, sin a, cos b cos a).
    let about_x = (y / length).clamp(-1.0, 1.0).asin();
    [about_x, (-x).atan2(z)]
}

/// Upward unit vector in measured axes that are rotated by these angles, rad.
pub fn upward([about_x, about_y]: [f64; 2]) -> [f64; 3] {
    let (sin_x, cos_x) = about_x.sin_cos();
    let (sin_y, cos_y) = about_y.sin_cos();
    [-sin_y * cos_x, sin_x, cos_y * cos_x]
}
