//! A kernel of a user's own, in every layout on every backend.

use crate::memory::{Memory, lay, read};
use crate::scene::{motions, rounded};
use dq8::storage::{self, AoSoA, Aos, Element, Layout};
use dq8::{Backend, DualQuat, Kernel, Level, batch};
use dq8_contract::random::Random;

/// points[i] ← σᵢ²(points[i]), and how many tiles that took.
struct MoveTwice<'s, E, P> {
    motions: &'s [E],
    points: &'s mut [P],
}

impl<E: Element<8>, P: Element<3, Layout = E::Layout>> Kernel for MoveTwice<'_, E, P> {
    type Output = usize;

    #[inline(always)]
    fn run<V: Level>(self, level: V) -> usize {
        let mut count = 0;
        for tile in storage::tiles::<E, V, 8>(self.motions.len()) {
            let motion = E::load(level, self.motions, tile, &storage::identity());
            let points = P::load(level, self.points, tile, &storage::identity());
            let (Some(motion), Some(points)) = (motion, points) else { break };
            let motion = batch::DualQuat::from_array(motion);
            P::store((motion * motion).transform_point(points), self.points, tile);
            count += 1;
        }
        count
    }
}

/// A kernel that gains nothing from AVX-512.
struct Narrow<K>(K);

impl<K: Kernel> Kernel for Narrow<K> {
    type Output = K::Output;
    const WIDE: bool = false;

    #[inline(always)]
    fn run<V: Level>(self, level: V) -> K::Output {
        self.0.run(level)
    }
}

fn moves_twice<L: Memory>() {
    let single = size_of::<L::Real>() == 4;
    let bound = if single { 24.0 * f64::from(f32::EPSILON) } else { 24.0 * f64::EPSILON };
    for count in 0..40 {
        let motions = motions(&mut Random(count), count as usize);
        let exact = rounded(single, &motions);
        let point = |i: usize| [0.5, -1.0, 0.25 * (i % 8) as f64];
        let points: Vec<_> = (0..count as usize).map(point).collect();
        let laid = lay::<L, 8>(1, &motions);
        for backend in Backend::available() {
            let mut moved = lay::<L, 3>(1, &points);
            // One element more than there are motions: it is not touched.
            moved.push(L::filled::<3>(dq8::Real::from_f64(7.0)));
            let end = moved.len() - 1;
            let kernel = MoveTwice { motions: &laid, points: &mut moved[..end] };
            assert_eq!(backend.run(kernel) == 0, laid.is_empty());
            let got = read::<L, 3>(1, &moved);
            assert!(got[got.len() - L::THINGS..].iter().all(|point| *point == [7.0; 3]));
            for (i, got) in got.iter().take(motions.len()).enumerate() {
                let motion = DualQuat::from_array(exact[i]);
                let wanted = (motion * motion).transform_point(point(i));
                let close = |(a, b): (&f64, &f64)| (a - b).abs() <= bound;
                let name = L::name();
                assert!(
                    got.iter().zip(&wanted).all(close),
                    "{name}, {backend}: {got:?}, {wanted:?}"
                );
            }
            // With AVX2 where there is AVX-512, to the last bit.
            let mut narrow = lay::<L, 3>(1, &points);
            let kernel = MoveTwice { motions: &laid, points: &mut narrow };
            backend.run(Narrow(kernel));
            assert_eq!(read::<L, 3>(1, &narrow), got[..got.len() - L::THINGS]);
        }
    }
}

#[test]
fn a_kernel_of_ones_own_computes_plain_slices_partial_tiles_and_blocks() {
    moves_twice::<Aos<f32>>();
    moves_twice::<Aos<f64>>();
    moves_twice::<AoSoA<[f32; 4]>>();
    moves_twice::<AoSoA<[f32; 8]>>();
    moves_twice::<AoSoA<[f32; 16]>>();
    moves_twice::<AoSoA<[f64; 2]>>();
    moves_twice::<AoSoA<[f64; 4]>>();
    moves_twice::<AoSoA<[f64; 8]>>();
}

/// Counts how many things the tiles of a slice cover.
struct Cover<E>(usize, core::marker::PhantomData<E>);

impl<E: Element<8>> Kernel for Cover<E> {
    type Output = usize;

    #[inline(always)]
    fn run<V: Level>(self, _: V) -> usize {
        let tiles = storage::tiles::<E, V, 8>(self.0).count();
        tiles * E::Layout::records::<V>() * E::Layout::THINGS / E::Layout::registers::<V>()
    }
}

#[test]
fn the_tiles_of_a_slice_cover_it_and_no_whole_register_more() {
    fn covered<L: Memory>(lanes: usize) {
        for backend in Backend::available() {
            for length in 0..40 {
                let cover = Cover::<L::Record<8>>(length, core::marker::PhantomData);
                let things = backend.run(cover);
                let wanted = length * L::THINGS;
                assert!(things >= wanted && things < wanted + lanes, "{length} on {backend}");
            }
        }
    }
    covered::<Aos<f32>>(16);
    covered::<Aos<f64>>(8);
    covered::<AoSoA<[f32; 4]>>(1);
    covered::<AoSoA<[f32; 16]>>(1);
    covered::<AoSoA<[f64; 2]>>(1);
    covered::<AoSoA<[f64; 8]>>(1);
}
