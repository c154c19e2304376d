//! [`Memory`]: layouts that tests fill and read, number by number.

use dq8::simd::Row;
use dq8::storage::{AoSoA, Aos, Block, Element, Layout, identity};
use dq8::{Real, Scalar};
use dq8_contract::records::Place;

/// A layout that tests can make elements of, and see the numbers of.
pub(crate) trait Memory: Layout {
    fn name() -> String;
    fn filled<const C: usize>(number: Self::Real) -> Self::Record<C>;
    /// All numbers in the order of memory, without the padding that small blocks have.
    fn numbers<const C: usize>(records: &[Self::Record<C>]) -> Vec<Self::Real>;
    fn fill<const C: usize>(records: &mut [Self::Record<C>], numbers: &[Self::Real]);
}

impl<R: Scalar> Memory for Aos<R> {
    fn name() -> String {
        format!("plain {}", core::any::type_name::<R>())
    }
    fn filled<const C: usize>(number: R) -> [R; C] {
        [number; C]
    }
    fn numbers<const C: usize>(records: &[[R; C]]) -> Vec<R> {
        records.as_flattened().to_vec()
    }
    fn fill<const C: usize>(records: &mut [[R; C]], numbers: &[R]) {
        records.as_flattened_mut().copy_from_slice(numbers);
    }
}

impl<A: Row<Real: Scalar>> Memory for AoSoA<A> {
    fn name() -> String {
        format!("blocks of {}", core::any::type_name::<A>())
    }
    fn filled<const C: usize>(number: A::Real) -> dq8::simd::Block<A, C> {
        dq8::simd::Block::splat([number; C])
    }
    fn numbers<const C: usize>(records: &[dq8::simd::Block<A, C>]) -> Vec<A::Real> {
        let rows = records.iter().flat_map(|block| &block.0).map(AsRef::as_ref);
        rows.collect::<Vec<_>>().concat()
    }
    fn fill<const C: usize>(records: &mut [dq8::simd::Block<A, C>], numbers: &[A::Real]) {
        let rows = records.iter_mut().flat_map(|block| &mut block.0);
        for (row, numbers) in rows.zip(numbers.chunks_exact(A::LANES)) {
            row.as_mut().copy_from_slice(numbers);
        }
    }
}

/// The nearest numbers of the type.
pub(crate) fn round<R: Real, const C: usize>(record: [f64; C]) -> [R; C] {
    record.map(<R as Real>::from_f64)
}

/// `[instance][joint]` as the layout keeps it; lanes without an instance hold the identity.
pub(crate) fn lay<L: Memory, const C: usize>(
    joints: usize,
    records: &[[f64; C]],
) -> Vec<L::Record<C>> {
    let place = Place { joints, components: C, lanes: L::THINGS };
    let numbers = place.lay(records.as_flattened(), &identity::<_, C>());
    let mut laid = vec![L::filled::<C>(L::Real::ZERO); numbers.len() / C / L::THINGS];
    L::fill(&mut laid, &numbers);
    laid
}

/// Back to `[instance][joint]`, lanes without an instance included.
pub(crate) fn read<L: Memory, const C: usize>(
    joints: usize,
    elements: &[L::Record<C>],
) -> Vec<[f64; C]> {
    let place = Place { joints, components: C, lanes: L::THINGS };
    place.read(&L::numbers(elements)).as_chunks().0.to_vec()
}

/// The layout that all of this stands on, once by hand: five instances of two joints in four lanes.
#[test]
fn the_layout_is_instance_block_then_joint_then_component_then_lane() {
    let record = |i: usize, j: usize| core::array::from_fn(|c| (1000 * i + 10 * j + c) as f64);
    let records: Vec<[f64; 8]> = (0..10).map(|index| record(index / 2, index % 2)).collect();
    let blocks: Vec<Block<f32, 4>> = lay::<AoSoA<[f32; 4]>, 8>(2, &records);
    let floats: &[f32] = bytemuck::cast_slice(&blocks);
    assert_eq!(floats.len(), 2 * 2 * 8 * 4);

    // The rows of component 0 and 1 of joint 0, instances 0 to 3.
    assert_eq!(floats[0..4], [0.0, 1000.0, 2000.0, 3000.0]);
    assert_eq!(floats[4..8], [1.0, 1001.0, 2001.0, 3001.0]);
    // Component 7 of joint 0, then component 0 of joint 1, still instances 0 to 3.
    assert_eq!(floats[28..32], [7.0, 1007.0, 2007.0, 3007.0]);
    assert_eq!(floats[32..36], [10.0, 1010.0, 2010.0, 3010.0]);
    // The second instance block: instance 4 in lane 0, the identity in the three others.
    assert_eq!(floats[64..68], [4000.0, 0.0, 0.0, 0.0]);
    assert_eq!(floats[64 + 12..64 + 16], [4003.0, 1.0, 1.0, 1.0]);
    assert_eq!(floats[96 + 28..128], [4017.0, 0.0, 0.0, 0.0]);

    let index = |instance: usize, joint: usize, component: usize| {
        ((instance / 4 * 2 + joint) * 8 + component) * 4 + instance % 4
    };
    for (number, record) in records.iter().enumerate() {
        for (component, &value) in record.iter().enumerate() {
            assert_eq!(f64::from(floats[index(number / 2, number % 2, component)]), value);
        }
    }
    assert_eq!(read::<AoSoA<[f32; 4]>, 8>(2, &blocks)[..10], records);
    // Thing by thing.
    let mut set = vec![Block::splat([0.0; 8]); blocks.len()];
    for (index, record) in records.iter().enumerate() {
        let (instance, joint) = (index / 2, index % 2);
        let thing = (instance / 4 * 2 + joint) * 4 + instance % 4;
        assert_eq!(Element::<8>::get(&blocks, thing), Some(round(*record)));
        Element::<8>::set(&mut set, thing, round(*record));
    }
    assert_eq!(read::<AoSoA<[f32; 4]>, 8>(2, &set)[..10], records);
    // A crowd lays its poses in the same way.
    let poses: Vec<[f32; 8]> = records.iter().map(|record| round(*record)).collect();
    let crowd = dq8::Crowd::<f32, 4>::from_slice(2, &poses).expect("whole instances");
    assert_eq!(crowd.blocks(), blocks);
}
