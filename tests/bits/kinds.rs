//! The kinds of arguments and answers of the tables.

/// An argument, dealt out.
#[rustfmt::skip]
macro_rules! take {
    ($deal:ident, unit) => { $deal.unit() };
    ($deal:ident, unit_motion) => { $deal.unit() };
    ($deal:ident, any) => { crate::sample::Sample::motion($deal.numbers()) };
    ($deal:ident, rotation) => { $deal.rotation() };
    ($deal:ident, unit_quat) => { $deal.rotation() };
    ($deal:ident, unit_pose) => { ($deal.rotation(), $deal.numbers()) };
    ($deal:ident, any_rotation) => { $deal.quat() };
    ($deal:ident, quat) => { $deal.quat() };
    ($deal:ident, dual) => { $deal.dual() };
    ($deal:ident, influences) => { &[(); 4].map(|()| ($deal.unit(), $deal.number()))[..] };
    ($deal:ident, level) => { $deal.level() };
    ($deal:ident, at_most) => { 8 };
    // Smaller steps than this are rounding.
    ($deal:ident, settled) => { $deal.constant(1e-6) };
    ($deal:ident, order) => { $deal.order() };
    ($deal:ident, integer) => { $deal.integer() };
    ($deal:ident, real) => { $deal.number() };
    ($deal:ident, number) => { $deal.number() };
    ($deal:ident, line) => { dq8::Line { direction: $deal.numbers(), moment: $deal.numbers() } };
    ($deal:ident, plane) => { dq8::Plane { normal: $deal.numbers(), offset: $deal.number() } };
    ($deal:ident, dual_vector) => { dq8::geometry::DualVector { real: $deal.numbers(), dual: $deal.numbers() } };
    ($deal:ident, twist) => { dq8::Twist { angular: $deal.numbers(), linear: $deal.numbers() } };
    ($deal:ident, wrench) => { dq8::geometry::Wrench { force: $deal.numbers(), torque: $deal.numbers() } };
    ($deal:ident, screw) => {
        dq8::geometry::Screw {
            axis: take!($deal, line),
            angle: $deal.number(),
            slide: $deal.number(),
        }
    };
    ($deal:ident, rows) => { $deal.matrix() };
    ($deal:ident, matrix3x4) => { $deal.matrix() };
    ($deal:ident, matrix3) => { $deal.matrix().map(|[x, y, z, _]| [x, y, z]) };
    ($deal:ident, matrix4) => {{
        let ([a, b, c], zero) = ($deal.matrix(), $deal.constant(0.0));
        [a, b, c, [zero, zero, zero, $deal.constant(1.0)]]
    }};
    // A vector, or numbers of which the operation says how many.
    ($deal:ident, $kind:ident) => { $deal.numbers() };
}

/// An answer, hashed.
macro_rules! put {
    ($deal:ident, motion $of:expr) => { $deal.put(&crate::sample::Sample::components($of)) };
    ($deal:ident, unit $of:expr) => { put!($deal, motion $of) };
    ($deal:ident, small_motion $of:expr) => { put!($deal, motion $of) };
    ($deal:ident, checked $of:expr) => {{
        let (motion, failed) = $of;
        put!($deal, motion motion);
        $deal.mask(failed);
    }};
    ($deal:ident, blend $of:expr) => { if let Some(blend) = $of { put!($deal, motion blend) } };
    ($deal:ident, mean $of:expr) => {
        if let Some(mean) = $of {
            put!($deal, motion mean.motion);
            $deal.put(&[mean.iterations]);
            $deal.mask(mean.converged);
        }
    };
    ($deal:ident, mask $of:expr) => { $deal.mask($of) };
    ($deal:ident, flag $of:expr) => { $deal.mask($of) };
    ($deal:ident, quat $of:expr) => { $deal.put_quat($of) };
    ($deal:ident, dual $of:expr) => { $deal.put_dual($of) };
    ($deal:ident, point $of:expr) => { $deal.put(&$of) };
    ($deal:ident, direction $of:expr) => { $deal.put(&$of) };
    ($deal:ident, line $of:expr) => {{ let l = $of; $deal.put(&l.direction); $deal.put(&l.moment) }};
    ($deal:ident, plane $of:expr) => {{ let p = $of; $deal.put(&p.normal); $deal.put(&[p.offset]) }};
    ($deal:ident, screw $of:expr) => {{
        let screw = $of;
        put!($deal, line screw.axis);
        $deal.put(&[screw.angle, screw.slide]);
    }};
    ($deal:ident, log $of:expr) => { put!($deal, dual_vector $of) };
    ($deal:ident, dual_vector $of:expr) => {{ let v = $of; $deal.put(&v.real); $deal.put(&v.dual) }};
    ($deal:ident, twist $of:expr) => {{ let t = $of; $deal.put(&t.angular); $deal.put(&t.linear) }};
    ($deal:ident, wrench $of:expr) => {{ let w = $of; $deal.put(&w.force); $deal.put(&w.torque) }};
    ($deal:ident, velocity $of:expr) => {{ let (w, v) = $of; $deal.put(&w); $deal.put(&v) }};
    ($deal:ident, matrix3x4 $of:expr) => { $deal.put($of.as_flattened()) };
    ($deal:ident, matrix4 $of:expr) => { $deal.put($of.as_flattened()) };
    ($deal:ident, rows $of:expr) => { $deal.put($of.as_flattened()) };
    ($deal:ident, axis_angle $of:expr) => {{
        let (axis, angle) = $of;
        $deal.put(&axis);
        $deal.put(&[angle]);
    }};
    ($deal:ident, limb $of:expr) => {{
        let limb = $of;
        $deal.put_quat(limb.upper);
        $deal.put_quat(limb.lower);
        $deal.put(&[limb.bend, limb.missed]);
    }};
    ($deal:ident, pose $of:expr) => {{
        let pose = $of;
        $deal.put_quat(pose.rotation);
        $deal.put(&pose.translation);
    }};
    ($deal:ident, map $of:expr) => {{
        let map = $of;
        $deal.put(map.linear.as_flattened());
        $deal.put(&map.translation);
    }};
    ($deal:ident, euler $of:expr) => {{
        let solution = $of;
        $deal.put(&solution.angles.angles);
        $deal.mask(solution.gimbal_lock);
    }};
    ($deal:ident, polar $of:expr) => {{
        let polar = $of;
        $deal.put_quat(polar.rotation);
        $deal.put(polar.stretch.as_flattened());
        $deal.mask(polar.mirrors);
    }};
    ($deal:ident, decomposed $of:expr) => {{
        let (motion, stretch) = $of;
        put!($deal, motion motion);
        $deal.put(stretch.as_flattened());
    }};
    ($deal:ident, perpendicular $of:expr) => {{
        let found = $of;
        put!($deal, line found.axis);
        $deal.put(found.feet.as_flattened());
        $deal.put_dual(found.angle);
        $deal.mask(found.parallel);
    }};
    // An angle, a length, a number.
    ($deal:ident, $kind:ident $of:expr) => { $deal.put(&[$of]) };
}
