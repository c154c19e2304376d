use crate::contender::{Contender, Micromath};
use core::hint::black_box;
use dq8::DualQuat;
use dq8_firmware_jobs::answers::{BIPED_MODELS, BIPED_OFFSETS, BIPED_ROTATIONS};
use dq8_firmware_jobs::error::error;
use dq8_firmware_jobs::{Board, Table};
use nalgebra::Isometry3;

pub(crate) fn run<B: Board>(table: &mut Table<'_, B>) {
    one::<DualQuat<f32>, B>(table);
    one::<Isometry3<f32>, B>(table);
    one::<Micromath, B>(table);
}

/// A function with its arguments in memory, as the linker sees them.
#[inline(never)]
fn product<C: Contender>(a: &C, b: &C, ab: &mut C) {
    *ab = *a * *b;
}

/// The root of the biped and the joint on it.
fn one<C: Contender, B: Board>(table: &mut Table<'_, B>) {
    let [a, b] = [0, 1].map(|joint| C::new(BIPED_ROTATIONS[joint], BIPED_OFFSETS[joint]));
    let mut ab = a;
    let cost = table.count(|| product(black_box(&a), black_box(&b), black_box(&mut ab)));
    let expected = DualQuat::from_array(BIPED_MODELS[1]).translation();
    table.line(C::NAMES.product, cost, error(&ab.translation(), &expected), 4.0);
}
