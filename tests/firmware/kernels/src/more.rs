//! Everything else that firmware may want.

use dq8::{
    Backend, Block, DualQuat, Hierarchy, Line, Plane, Quat, Twist,
    geometry::{DualVector, Screw, Wrench},
    hierarchy::{Bones, Plan, PlanScratch, Poses},
};

type Motion = DualQuat<f32>;

#[unsafe(no_mangle)]
fn more_axis_angle(axis: &[f32; 3], angle: f32) -> Quat<f32> {
    Quat::from_axis_angle(*axis, angle)
}
#[unsafe(no_mangle)]
fn more_inverse(a: &Motion) -> Motion {
    a.inverse()
}
#[unsafe(no_mangle)]
fn more_matrix(a: &Motion) -> [[f32; 4]; 3] {
    a.to_matrix3x4()
}
#[unsafe(no_mangle)]
fn more_from_matrix(rows: &[[f32; 4]; 3]) -> Option<Motion> {
    Motion::try_from_matrix3x4(*rows, 1e-3).ok()
}
#[unsafe(no_mangle)]
fn more_line(a: &Motion, line: &Line<f32>) -> Line<f32> {
    a.transform_line(*line)
}
#[unsafe(no_mangle)]
fn more_plane(a: &Motion, plane: &Plane<f32>) -> Plane<f32> {
    a.transform_plane(*plane)
}
#[unsafe(no_mangle)]
fn more_log(a: &Motion) -> DualVector<f32> {
    a.log()
}
#[unsafe(no_mangle)]
fn more_exp(log: &DualVector<f32>) -> Motion {
    Motion::exp(*log)
}
#[unsafe(no_mangle)]
fn more_pow(a: &Motion, t: f32) -> Motion {
    a.pow(t)
}
#[unsafe(no_mangle)]
fn more_to_screw(a: &Motion) -> Screw<f32> {
    a.to_screw()
}
#[unsafe(no_mangle)]
fn more_from_screw(screw: &Screw<f32>) -> Motion {
    Motion::from_screw(*screw)
}
#[unsafe(no_mangle)]
fn more_sclerp(a: &Motion, b: &Motion, t: f32) -> Motion {
    a.sclerp(*b, t)
}
#[unsafe(no_mangle)]
fn more_slerp_lerp(a: &Motion, b: &Motion, t: f32) -> Motion {
    a.slerp_lerp(*b, t)
}
#[unsafe(no_mangle)]
fn more_nlerp(a: &Motion, b: &Motion, t: f32) -> Motion {
    a.nlerp(*b, t)
}
#[unsafe(no_mangle)]
fn more_squad(ends: &[Motion; 2], controls: &[Motion; 2], t: f32) -> Motion {
    ends[0].squad(controls[0], controls[1], ends[1], t)
}
#[unsafe(no_mangle)]
fn more_dlb(influences: &[(Motion, f32)]) -> Option<Motion> {
    Motion::dlb(influences)
}
#[unsafe(no_mangle)]
fn more_adjoint(a: &Motion, twist: &Twist<f32>) -> Twist<f32> {
    a.adjoint(*twist)
}
#[unsafe(no_mangle)]
fn more_coadjoint(a: &Motion, wrench: &Wrench<f32>) -> Wrench<f32> {
    a.coadjoint(*wrench)
}
#[unsafe(no_mangle)]
fn more_integrate(a: &Motion, twist: &Twist<f32>, dt: f32) -> Motion {
    a.integrate_body(*twist, dt)
}
#[unsafe(no_mangle)]
fn more_angle_to(a: &Motion, b: &Motion) -> f32 {
    a.angle_to(*b)
}
#[unsafe(no_mangle)]
fn more_point_error(a: &Motion, b: &Motion, point: &[f32; 3]) -> f32 {
    a.point_error(*b, *point)
}

#[unsafe(no_mangle)]
fn more_rotations(parents: &[u32], locals: Bones<'_, Quat<f32>>, models: &mut [Motion]) -> bool {
    Hierarchy::new(parents).is_ok_and(|h| h.job().locals_to_model(locals, models).is_ok())
}
#[unsafe(no_mangle)]
fn more_palette(
    parents: &[u32],
    locals: &[Motion],
    models: &mut [Motion],
    inverse_binds: &[Motion],
    palette: &mut [[[f32; 4]; 3]],
) -> bool {
    Hierarchy::new(parents).is_ok_and(|h| {
        h.job().palette_and_models(Poses(locals), models, inverse_binds, palette).is_ok()
    })
}
#[unsafe(no_mangle)]
fn more_model_to_local(parents: &[u32], poses: &mut [Motion]) -> bool {
    Hierarchy::new(parents).is_ok_and(|h| h.job().model_to_local_in_place(poses).is_ok())
}
#[unsafe(no_mangle)]
fn more_crowd(parents: &[u32], poses: &mut [Block<f32, 8>]) -> bool {
    Hierarchy::new(parents).is_ok_and(|h| h.job().local_to_model_in_place(poses).is_ok())
}

#[unsafe(no_mangle)]
fn more_products(a: &[Motion], b: &[Motion], products: &mut [Motion]) -> bool {
    Backend::best().mul(a, b, products).is_ok()
}
#[unsafe(no_mangle)]
fn more_units(motions: &mut [Motion]) {
    Backend::best().normalize_in_place(motions);
}
#[unsafe(no_mangle)]
fn more_points(motion: &Motion, points: &[[f32; 3]], moved: &mut [[f32; 3]]) -> bool {
    Backend::best().transform_points(*motion, points, moved).is_ok()
}
#[unsafe(no_mangle)]
fn more_points_each(motions: &[Motion], points: &[[f32; 3]], moved: &mut [[f32; 3]]) -> bool {
    Backend::best().transform_points_each(motions, points, moved).is_ok()
}
#[unsafe(no_mangle)]
fn more_screws(a: &[Motion], b: &[Motion], t: &[f32], between: &mut [Motion]) -> bool {
    Backend::best().sclerp_each(a, b, t, between).is_ok()
}

#[unsafe(no_mangle)]
fn more_plan(
    parents: &[u32],
    order: &mut [[u32; 2]],
    scratch: &mut [PlanScratch],
    locals: &[Motion],
    models: &mut [Motion],
) -> bool {
    Hierarchy::new(parents).is_ok_and(|h| {
        Plan::new(&h, order, scratch)
            .is_ok_and(|plan| h.job().plan(&plan).local_to_model(locals, models).is_ok())
    })
}
