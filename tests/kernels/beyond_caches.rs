//! Kernels over memory larger than caches, where outputs that are not read are written past them.

use crate::memory::lay;
use crate::scene::motions;
use bytemuck::NoUninit;
use dq8::storage::AoSoA;
use dq8::{Backend, DualQuat, simd};
use dq8_contract::random::Random;

type Block<const C: usize> = simd::Block<[f32; 16], C>;

/// Three blocks of motions, or of the first numbers of motions.
fn three<const C: usize>() -> [Block<C>; 3] {
    let mut random = Random(3);
    std::array::from_fn(|_| {
        let motions = motions(&mut random, 16);
        let records: Vec<[f64; C]> =
            motions.iter().map(|motion| std::array::from_fn(|c| motion[c])).collect();
        lay::<AoSoA<[f32; 16]>, C>(1, &records)[0]
    })
}

/// Larger than caches: `few` again and again.
fn beyond_caches<E: Copy>(few: [E; 3]) -> Vec<E> {
    let length = (64 << 20) / size_of::<E>() + 1;
    few.into_iter().cycle().take(length).collect()
}

/// Byte by byte: number by number takes longer than the kernels.
fn as_few<E: NoUninit>(all: &[E], few: [E; 3]) -> bool {
    let few: &[u8] = bytemuck::cast_slice(&few);
    all.chunks(3).all(|some| few.starts_with(bytemuck::cast_slice(some)))
}

/// Large outputs are written past the caches, unless they are read as well, and are the same.
#[test]
fn outputs_larger_than_caches_are_computed_as_small_ones() {
    let few: [Block<8>; 3] = three();
    let many = beyond_caches(few);
    for backend in Backend::available() {
        let (mut units, mut all) = (few, many.clone());
        backend.normalize(&few, &mut units).expect("they fit");
        backend.normalize(&many, &mut all).expect("they fit");
        assert!(as_few(&all, units), "{backend}");

        let mut squares = units;
        backend.mul_in_place(&mut squares, &units).expect("they fit");
        let factors = all.clone();
        backend.mul_in_place(&mut all, &factors).expect("they fit");
        assert!(as_few(&all, squares), "{backend}, in place");
    }
}

/// What is done in place, by name.
type Step<'s, const C: usize> = (&'s str, fn(Backend, &mut [Block<C>]));

/// Each step in place over the same memory; none leaves it as it was. Whether memory is written
/// past the caches does not depend on the backend.
fn in_place_beyond_caches<const C: usize>(steps: &[Step<'_, C>]) {
    let mut few = three();
    let mut all = beyond_caches(few);
    let last = all.len() - 1;
    for (name, step) in steps {
        let before = few;
        step(Backend::best(), &mut few);
        step(Backend::best(), &mut all);
        assert!(few.iter().zip(&before).all(|(few, before)| few != before), "{name}");
        for i in (0..last).step_by(61).chain([last]) {
            assert!(all[i] == few[i % 3], "{name}, {i}");
        }
    }
}

#[test]
fn memory_larger_than_caches_is_read_where_it_is_written() {
    fn motion(length: f32) -> DualQuat<f32> {
        DualQuat::from_array([0.5, -0.5, 0.5, 0.5, 1.0, 2.0, 0.25, 0.75]).scale(length)
    }
    in_place_beyond_caches::<8>(&[
        ("mul_left", |backend, motions| backend.mul_left_in_place(motion(2.0), motions)),
        ("inverse", Backend::inverse_in_place),
        ("normalize", Backend::normalize_in_place),
        ("conjugate", Backend::conjugate_in_place),
    ]);
    in_place_beyond_caches::<3>(&[
        ("points", |backend, points| backend.transform_points_in_place(motion(1.0), points)),
        ("vectors", |backend, vectors| backend.transform_vectors_in_place(motion(1.0), vectors)),
    ]);
}
