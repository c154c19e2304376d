use crate::contender::{Contender, Micromath};
use core::hint::black_box;
use dq8::{Backend, DualQuat};
use dq8_firmware_jobs::answers::{BIPED_OFFSETS, BIPED_ROTATIONS, POINT};
use dq8_firmware_jobs::error::{error, max_or_nan};
use dq8_firmware_jobs::{Board, Table};
use nalgebra::Isometry3;

const POINTS: usize = POINT.len();
/// The answer is our own, one by one, which the jobs have checked.
const BOUND: f32 = 8.0;

pub(crate) fn run<B: Board>(table: &mut Table<'_, B>) {
    let points = POINT.map(|(_, point, _)| point);
    let motion = motion::<DualQuat<f32>>();
    let mut moved = [[f32::NAN; 3]; POINTS];
    let cost = table.count(|| {
        _ = Backend::best().transform_points(
            black_box(motion),
            black_box(&points),
            black_box(&mut moved),
        );
    });
    table.line("point, dq8, all in a call", cost / POINTS as u32, worst(&moved), BOUND);
    one::<DualQuat<f32>, B>(table);
    one::<Isometry3<f32>, B>(table);
    one::<Micromath, B>(table);
}

#[inline(never)]
fn transform<C: Contender>(motion: &C, points: &[[f32; 3]], moved: &mut [[f32; 3]]) {
    for (moved, &point) in moved.iter_mut().zip(points) {
        *moved = motion.point(point);
    }
}

fn motion<C: Contender>() -> C {
    C::new(BIPED_ROTATIONS[0], BIPED_OFFSETS[0])
}

fn one<C: Contender, B: Board>(table: &mut Table<'_, B>) {
    let points = POINT.map(|(_, point, _)| point);
    let motion = motion::<C>();
    let mut moved = [[f32::NAN; 3]; POINTS];
    let cost =
        table.count(|| transform(black_box(&motion), black_box(&points), black_box(&mut moved)));
    table.line(C::NAMES.point, cost / POINTS as u32, worst(&moved), BOUND);
}

fn worst(moved: &[[f32; 3]; POINTS]) -> f32 {
    let motion = motion::<DualQuat<f32>>();
    let pairs = moved.iter().zip(&POINT);
    pairs.fold(0.0, |worst, (moved, (_, point, _))| {
        max_or_nan(error(moved, &motion.transform_point(*point)), worst)
    })
}
