use crate::contender::Contender;
use core::hint::black_box;
use dq8::{Backend, DualQuat};
use dq8_firmware_jobs::answers::{BIPED_OFFSETS, BIPED_ROTATIONS};
use dq8_firmware_jobs::error::error;
use dq8_firmware_jobs::{Board, Table};
use nalgebra::Isometry3;

/// Interpolations in a call.
const TIMES: usize = 8;
/// The turn of all three is the same, only the way between is another.
const BOUND: f32 = 4.0;
const ARM: [f32; 3] = [1.0, 2.0, 3.0];

/// Poses between two. micromath has no such thing.
pub(crate) fn run<B: Board>(table: &mut Table<'_, B>) {
    let t: [f32; TIMES] = core::array::from_fn(|i| i as f32 / TIMES as f32);
    let last = t[TIMES - 1];
    let [a, b] = ends::<DualQuat<f32>>();
    let expected = a.slerp_lerp(b, last).transform_vector(ARM);

    let (from, to, mut between) = ([a; TIMES], [b; TIMES], [a; TIMES]);
    let best = Backend::best();
    let cost = table.count(|| {
        _ = best.sclerp_each(black_box(&from), black_box(&to), &t, black_box(&mut between))
    });
    let turned = between[TIMES - 1].transform_vector(ARM);
    table.line(
        "between, dq8, ScLERP, slices",
        cost / TIMES as u32,
        error(&turned, &expected),
        BOUND,
    );

    let (cost, last) = each(table, &t, |t| black_box(a).sclerp(black_box(b), t));
    table.line("between, dq8, ScLERP", cost, error(&last.transform_vector(ARM), &expected), BOUND);
    let (cost, last) = each(table, &t, |t| black_box(a).slerp_lerp(black_box(b), t));
    table.line(
        "between, dq8, slerp and lerp",
        cost,
        error(&last.transform_vector(ARM), &expected),
        BOUND,
    );

    let [a, b] = ends::<Isometry3<f32>>();
    let (cost, last) = each(table, &t, |t| black_box(a).lerp_slerp(&black_box(b), t));
    let turned: [f32; 3] = last.transform_vector(&ARM.into()).into();
    table.line("between, nalgebra, slerp and lerp", cost, error(&turned, &expected), BOUND);
}

fn ends<C: Contender>() -> [C; 2] {
    [1, 2].map(|joint| C::new(BIPED_ROTATIONS[joint], BIPED_OFFSETS[joint]))
}

/// Instructions of one, and the last answer.
fn each<B: Board, M: Copy>(
    table: &mut Table<'_, B>,
    t: &[f32; TIMES],
    between: impl Fn(f32) -> M,
) -> (u32, M) {
    let mut answer = between(0.0);
    let cost = table.count(|| {
        for &t in t {
            answer = black_box(between(black_box(t)));
        }
    });
    (cost / TIMES as u32, answer)
}
