//! Conversion of a take to the axes of a dataset: right-handed, z up.

use crate::takes::{Axis, Pose, Take, product};

impl Take {
    /// Converts the recording, whose axis `up` points up, to right-handed axes with z up. If they are `left_handed`,
    /// the second horizontal axis and the second body-fixed axis of each body are mirrored.
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
