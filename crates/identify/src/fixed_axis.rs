//! Bodies that turn about one axis of the inertial frame: a point on that axis is known where the markers are.

use model_spec::model::{FrameKind, Model};

/// Number, from 0, of the axis about which the frame of the markers turns, if it turns about one of the inertial frame only.
pub fn fixed_axis(model: &Model) -> Option<usize> {
    let frame = model.marker.as_ref()?.frame;
    match model.frames[frame].kind {
        FrameKind::Turned {
            parent: 0, axis, ..
        } => Some(usize::from(axis) - 1),
        _ => None,
    }
}

/// The point 1 m from the centre of `markers` along an axis; `None` if one of them is missing.
pub fn point_along(axis: usize, markers: &[Option<[f64; 3]>]) -> Option<[f64; 3]> {
    let mut centre = [0.0; 3];
    for marker in markers {
        let marker = (*marker)?;
        for (sum, own) in centre.iter_mut().zip(marker) {
            *sum += own / markers.len() as f64;
        }
    }
    centre[axis] += 1.0;
    Some(centre)
}

/// Adds [`point_along`] to the positions of markers; returns whether there are any.
pub fn add_point(axis: usize, markers: &mut Vec<[f64; 3]>) -> bool {
    let seen: Vec<_> = markers.iter().copied().map(Some).collect();
    let added = point_along(axis, &seen).filter(|_| !seen.is_empty());
    markers.extend(added);
    added.is_some()
}
