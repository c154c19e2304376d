//! Lines, planes and twists moved by one motion, and the distance of one motion from another. Inputs are
//! read before anything is written, so outputs may be inputs.

use crate::memory::{one, two};
use crate::status::Status;
use dq8::{DualQuat, Line, Plane, Twist};

macro_rules! functions {
    ($R:ident $lanes:tt) => {
        export_one! { $R
            /// A line moved by a unit motion. It is six numbers: its direction, and its moment p x
            /// direction of any point p on it (Plücker coordinates).
            motion::line(motion: *const $R, line: *const $R, out: *mut $R) =
                two(motion, line, out, |motion: DualQuat<$R>, [direction, moment]: [[$R; 3]; 2]| {
                    let moved = motion.transform_line(Line { direction, moment });
                    Ok([moved.direction, moved.moment])
                })
        }
        export_one! { $R
            /// A plane moved by a unit motion. It is four numbers: its unit normal n, and n . p of
            /// any point p on it.
            motion::plane(motion: *const $R, plane: *const $R, out: *mut $R) =
                two(motion, plane, out, |motion: DualQuat<$R>, [x, y, z, offset]: [$R; 4]| {
                    let moved = motion.transform_plane(Plane { normal: [x, y, z], offset });
                    let [x, y, z] = moved.normal;
                    Ok([x, y, z, moved.offset])
                })
        }
        export_one! { $R
            /// A twist, six numbers, angular part first, by the adjoint of a unit motion: a body
            /// twist becomes the spatial one.
            motion::twist(motion: *const $R, twist: *const $R, out: *mut $R) =
                two(motion, twist, out, |motion: DualQuat<$R>, twist: Twist<$R>| Ok(motion.adjoint(twist)))
        }
        export_one! { $R
            /// The twist, six numbers, angular part first, that leads to a unit motion in one
            /// second.
            motion::to_twist(motion: *const $R, twist: *mut $R) =
                one(motion, twist, |motion: DualQuat<$R>| Ok(motion.to_twist()))
        }
        export_one! { $R
            /// A unit motion after `dt` seconds of a body twist, six numbers, angular part first.
            motion::integrate_body(motion: *const $R, twist: *const $R, dt: $R, out: *mut $R) =
                two(motion, twist, out, |motion: DualQuat<$R>, twist: Twist<$R>| {
                    Ok(motion.integrate_body(twist, dt))
                })
        }
        export_one! { $R
            /// The angle between two unit motions, one number, radians in 0 to pi.
            motion::angle_to(a: *const $R, b: *const $R, angle: *mut $R) =
                two(a, b, angle, |a: DualQuat<$R>, b: DualQuat<$R>| Ok(a.angle_to(b)))
        }
        export_one! { $R
            /// The distance between the translations of two unit motions, one number.
            motion::distance_to(a: *const $R, b: *const $R, distance: *mut $R) =
                two(a, b, distance, |a: DualQuat<$R>, b: DualQuat<$R>| Ok(a.distance_to(b)))
        }
    };
}
for_both_numbers!(functions);
