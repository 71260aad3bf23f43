//! Conversion of a take to the axes of a dataset: right-handed, z up.

use crate::takes::{Axis, Pose, Take, product};

impl Take {
    /// Converts the recording to right-handed axes with z up; `up` is the axis of the file that points up. If the axes
    /// of the file are `left_handed`, the second horizontal axis is mirrored, and so is the second body-fixed axis of
    /// each tracked body.
    pub fn with_z_up(mut self, up: Axis, left_handed: bool) -> Self {
        let changed = |position: [f64; 3]| up.upright(left_handed, position);
        for position in self
            .points
            .iter_mut()
            .flat_map(|point| &mut point.positions)
        {
            *position = position.map(changed);
        }
        let turn = up.to_z();
        for pose in self.bodies.iter_mut().flat_map(|body| &mut body.poses) {
            *pose = pose.map(|pose| {
                // A reflection reverses the sense of a rotation.
                let [w, x, y, z] = product(turn, pose.quaternion);
                let mirrored = if left_handed {
                    [w, -x, y, -z]
                } else {
                    [w, x, y, z]
                };
                Pose {
                    position: changed(pose.position),
                    quaternion: mirrored,
                }
            });
        }
        self.up = Some(Axis {
            index: 2,
            negative: false,
        });
        self.left_handed = Some(false);
        self
    }
}
