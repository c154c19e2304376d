//! What elements of slices promise: types with names are the numbers that they are made of.

use crate::memory::round;
use dq8::representation::RotationTranslation;
use dq8::storage::{Aos, Block, Element, tiles};
use dq8::{Backend, DualQuat, Kernel, Level, Line, Plane, Quat, Twist};

/// Copies by tiles.
struct Copies<'s, E, const C: usize>(&'s [E], &'s mut [E]);

impl<E: Element<C>, const C: usize> Kernel for Copies<'_, E, C> {
    type Output = ();
    #[inline(always)]
    fn run<V: Level>(self, level: V) {
        let Self(from, to) = self;
        let padding = dq8::storage::identity();
        for tile in tiles::<E, V, C>(from.len()) {
            let Some(components) = E::load(level, from, tile, &padding) else { return };
            E::store(components, to, tile);
        }
    }
}

/// `E` beside plain arrays of its numbers, of every length up to two registers and one.
fn is_its_numbers<E, const C: usize>(some: E)
where
    E: Element<C, Layout = Aos<f32>> + PartialEq,
{
    for length in 0..34 {
        let numbers = |i: usize| core::array::from_fn(|c| (100 * i + c) as f64);
        let records: Vec<[f32; C]> = (0..length).map(|i| round(numbers(i))).collect();
        let mut things = vec![some; length];
        for (i, record) in records.iter().enumerate() {
            E::set(&mut things, i, *record);
        }
        E::set(&mut things, length, [9.0; C]);
        let read: Vec<[f32; C]> = (0..length).filter_map(|i| E::get(&things, i)).collect();
        assert_eq!(read, records);
        assert_eq!(E::get(&things, length), None);
        if let Some(plain) = E::plain(&things) {
            assert_eq!(plain, records);
        }
        for backend in Backend::available() {
            let mut copy = vec![some; length];
            backend.run(Copies::<E, C>(&things, &mut copy));
            assert!(copy == things, "{backend}, {length}");
            // A shorter slice is not written beyond its end.
            let mut part = vec![some; length];
            let end = length / 2;
            backend.run(Copies::<E, C>(&things, &mut part[..end]));
            assert!(part[..end] == things[..end] && part[end..].iter().all(|thing| *thing == some));
        }
    }
}

#[test]
fn things_with_names_are_their_numbers() {
    is_its_numbers::<f32, 1>(0.0);
    is_its_numbers::<[f32; 3], 3>([0.0; 3]);
    is_its_numbers::<Quat<f32>, 4>(Quat::IDENTITY);
    is_its_numbers::<Plane<f32>, 4>(Plane { normal: [0.0; 3], offset: 0.0 });
    is_its_numbers::<Line<f32>, 6>(Line { direction: [0.0; 3], moment: [0.0; 3] });
    is_its_numbers::<Twist<f32>, 6>(Twist::from_array([0.0; 6]));
    is_its_numbers::<RotationTranslation<f32>, 7>(RotationTranslation::IDENTITY);
    is_its_numbers::<DualQuat<f32>, 8>(DualQuat::IDENTITY);
    is_its_numbers::<[[f32; 4]; 3], 12>([[0.0; 4]; 3]);
    is_its_numbers::<[[f32; 4]; 4], 16>([[0.0; 4]; 4]);
}

#[test]
fn blocks_are_copied_by_tiles_whole() {
    fn copied<E: Element<C> + PartialEq, const C: usize>(some: E, other: E) {
        for (backend, length) in Backend::available().flat_map(|b| (0..5).map(move |n| (b, n))) {
            let (from, mut to) = (vec![some; length], vec![other; length + 1]);
            backend.run(Copies::<E, C>(&from, &mut to));
            assert!(to[..length] == from && to[length] == other, "{backend}, {length}");
        }
    }
    copied::<_, 1>(Block::<f32, 16, 1>::splat([1.0]), Block::splat([2.0]));
    copied::<_, 3>(Block::<f64, 2, 3>::splat([1.0; 3]), Block::splat([2.0; 3]));
    copied::<_, 6>(Block::<f64, 8, 6>::splat([1.0; 6]), Block::splat([2.0; 6]));
}
