//! Functions that move a line, a plane or a twist by a motion, or measure two motions. They read
//! all inputs before they write, so outputs may be inputs.

use crate::memory::{one, two};
use crate::status::Status;
use dq8::{DualQuat, Line, Plane, Twist};

macro_rules! functions {
    ($R:ident $lanes:tt) => {
        export_one! { $R
            /// Moves a line by a unit motion. A line is given by its six Plücker coordinates: the
            /// direction x y z, then the moment x y z, which is the cross product of any point on
            /// the line and the direction.
            motion::line(motion: *const $R, line: *const $R, out: *mut $R) =
                two(motion, line, out, |motion: DualQuat<$R>, [direction, moment]: [[$R; 3]; 2]| {
                    let moved = motion.transform_line(Line { direction, moment });
                    Ok([moved.direction, moved.moment])
                })
        }
        export_one! { $R
            /// Moves a plane by a unit motion. A plane is given by four values: its unit normal x y
            /// z, then the dot product of the normal and any point on the plane.
            motion::plane(motion: *const $R, plane: *const $R, out: *mut $R) =
                two(motion, plane, out, |motion: DualQuat<$R>, [x, y, z, offset]: [$R; 4]| {
                    let moved = motion.transform_plane(Plane { normal: [x, y, z], offset });
                    let [x, y, z] = moved.normal;
                    Ok([x, y, z, moved.offset])
                })
        }
        export_one! { $R
            /// Applies the adjoint of a unit motion to a twist, which turns a body twist into the
            /// spatial twist. A twist has six components: angular x y z, then linear x y z.
            motion::twist(motion: *const $R, twist: *const $R, out: *mut $R) =
                two(motion, twist, out, |motion: DualQuat<$R>, twist: Twist<$R>| Ok(motion.adjoint(twist)))
        }
        export_one! { $R
            /// Writes the constant twist that moves the identity to a unit motion in one second. A
            /// twist has six components: angular x y z, then linear x y z.
            motion::to_twist(motion: *const $R, twist: *mut $R) =
                one(motion, twist, |motion: DualQuat<$R>| Ok(motion.to_twist()))
        }
        export_one! { $R
            /// Moves a unit motion on by a constant body twist for `dt` seconds. A twist has six
            /// components: angular x y z in radians per second, then linear x y z.
            motion::integrate_body(motion: *const $R, twist: *const $R, dt: $R, out: *mut $R) =
                two(motion, twist, out, |motion: DualQuat<$R>, twist: Twist<$R>| {
                    Ok(motion.integrate_body(twist, dt))
                })
        }
        export_one! { $R
            /// Writes the angle between two unit motions, in radians from 0 to pi.
            motion::angle_to(a: *const $R, b: *const $R, angle: *mut $R) =
                two(a, b, angle, |a: DualQuat<$R>, b: DualQuat<$R>| Ok(a.angle_to(b)))
        }
        export_one! { $R
            /// Writes the distance between the translations of two unit motions.
            motion::distance_to(a: *const $R, b: *const $R, distance: *mut $R) =
                two(a, b, distance, |a: DualQuat<$R>, b: DualQuat<$R>| Ok(a.distance_to(b)))
        }
    };
}
for_both_numbers!(functions);
