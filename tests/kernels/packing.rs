//! Between single things and blocks: every number of components, every width, any number of
//! instances.

use crate::errors::names;
use crate::memory::round;
use crate::records::same_bits;
use core::marker::PhantomData;
use dq8::simd::Row;
use dq8::storage::{self, Aos, Block, Element, identity};
use dq8::{Crowd, DualQuat, Quat, Scalar, ShapeError, Twist};

/// Things of one kind and blocks of one width, as functions of flat `f64` records.
pub(crate) trait Packing {
    /// How many things a block holds.
    fn lanes(&self) -> usize;
    fn components(&self) -> usize;
    /// What fills lanes without a thing.
    fn padding(&self) -> Vec<f64>;
    /// Into so many blocks of junk, then every lane of each; junk stays where it is refused.
    fn pack(&self, way: Way, things: &[Vec<f64>], blocks: usize) -> Answer;
    /// From every lane of blocks to so many things of junk, which stay where it is refused.
    fn unpack(&self, way: Way, blocks: &[Vec<f64>], count: usize) -> Answer;
    fn crowd(&self, joints: usize, things: &[Vec<f64>]) -> Result<Box<dyn Held>, ShapeError>;
    fn new_crowd(&self, joints: usize, instances: usize) -> Box<dyn Held>;
}

type Answer = Result<Vec<Vec<f64>>, ShapeError>;

/// Which things share a block.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Way {
    /// Instances of so many joints.
    Instances(usize),
    /// Segments of a chain.
    Chain,
}

/// A [`Crowd`] of any things.
pub(crate) trait Held {
    fn joints(&self) -> usize;
    fn instances(&self) -> usize;
    /// Every lane of every block.
    fn lanes(&self) -> Vec<Vec<f64>>;
    fn record(&self, instance: usize, joint: usize) -> Option<Vec<f64>>;
    fn set_record(
        &mut self,
        instance: usize,
        joint: usize,
        record: &[f64],
    ) -> Result<(), ShapeError>;
    /// Into so many things of junk, which stay where it is refused.
    fn copy(&self, count: usize) -> Answer;
}

/// What no correct result holds: to see what has been written.
const JUNK: f64 = -7.0;

/// Every kind of thing in blocks of every width; `tests/limit` tries every backend.
pub(crate) fn packings() -> Vec<Box<dyn Packing>> {
    let mut all = Vec::new();
    of_width::<f32, 4>(&mut all);
    of_width::<f32, 8>(&mut all);
    of_width::<f32, 16>(&mut all);
    of_width::<f64, 2>(&mut all);
    of_width::<f64, 4>(&mut all);
    of_width::<f64, 8>(&mut all);
    all
}

fn of_width<R: Scalar + Element<1, Layout = Aos<R>>, const N: usize>(
    all: &mut Vec<Box<dyn Packing>>,
) where
    [R; N]: Row<Real = R>,
{
    all.push(Box::new(Of::<R, R, N, 1>::new(R::ZERO)));
    all.push(Box::new(Of::<[R; 3], R, N, 3>::new([R::ZERO; 3])));
    all.push(Box::new(Of::<Quat<R>, R, N, 4>::new(Quat::IDENTITY)));
    all.push(Box::new(Of::<Twist<R>, R, N, 6>::new(Twist::from_array([R::ZERO; 6]))));
    all.push(Box::new(Of::<[R; 7], R, N, 7>::new([R::ZERO; 7])));
    all.push(Box::new(Of::<DualQuat<R>, R, N, 8>::new(DualQuat::ZERO)));
    all.push(Box::new(Of::<[[R; 4]; 3], R, N, 12>::new([[R::ZERO; 4]; 3])));
    all.push(Box::new(Of::<[[R; 4]; 4], R, N, 16>::new([[R::ZERO; 4]; 4])));
}

/// `E` is `C` numbers `R`, or in blocks of `N`.
struct Of<E, R, const N: usize, const C: usize> {
    some: E,
    real: PhantomData<R>,
}

impl<E, R: Scalar, const N: usize, const C: usize> Of<E, R, N, C>
where
    E: Element<C, Layout = Aos<R>> + 'static,
    [R; N]: Row<Real = R>,
{
    fn new(some: E) -> Self {
        Self { some, real: PhantomData }
    }

    fn things(&self, records: &[Vec<f64>]) -> Vec<E> {
        let mut things = vec![self.some; records.len()];
        for (index, record) in records.iter().enumerate() {
            E::set(&mut things, index, components(record));
        }
        things
    }

    fn junk(&self, count: usize) -> Vec<E> {
        self.things(&vec![vec![JUNK; C]; count])
    }

    fn flat(things: &[E]) -> Vec<Vec<f64>> {
        let record = |index| E::get(things, index).expect("it is inside").map(Into::into).to_vec();
        (0..things.len()).map(record).collect()
    }

    fn answer(result: Result<(), ShapeError>, written: Vec<Vec<f64>>) -> Answer {
        let junk = written.iter().flatten().all(|number| *number == JUNK);
        assert!(result.is_ok() || junk, "written in spite of {result:?}");
        result.map(|()| written)
    }
}

fn components<R: Scalar, const C: usize>(record: &[f64]) -> [R; C] {
    round(record.try_into().expect("as many numbers as components"))
}

fn lanes_of<R: Scalar, const N: usize, const C: usize>(blocks: &[Block<R, N, C>]) -> Vec<Vec<f64>>
where
    [R; N]: Row<Real = R>,
{
    let lanes = blocks.iter().flat_map(|block| (0..N).map(move |lane| block.get(lane)));
    lanes.map(|record| record.expect("there is such a lane").map(Into::into).to_vec()).collect()
}

impl<E, R: Scalar, const N: usize, const C: usize> Packing for Of<E, R, N, C>
where
    E: Element<C, Layout = Aos<R>> + 'static,
    [R; N]: Row<Real = R>,
{
    fn lanes(&self) -> usize {
        N
    }
    fn components(&self) -> usize {
        C
    }
    fn padding(&self) -> Vec<f64> {
        identity::<f64, C>().to_vec()
    }
    fn pack(&self, way: Way, things: &[Vec<f64>], blocks: usize) -> Answer {
        let mut blocks = vec![Block::<R, N, C>::splat(components(&[JUNK; C])); blocks];
        let things = self.things(things);
        let result = match way {
            Way::Instances(joints) => storage::pack(joints, &things, &mut blocks),
            Way::Chain => storage::pack_chain(&things, &mut blocks),
        };
        Self::answer(result, lanes_of(&blocks))
    }
    fn unpack(&self, way: Way, lanes: &[Vec<f64>], count: usize) -> Answer {
        let mut blocks = vec![Block::<R, N, C>::splat(components(&[0.0; C])); lanes.len() / N];
        for (index, record) in lanes.iter().enumerate() {
            blocks[index / N].set(index % N, components(record)).expect("there is such a lane");
        }
        let mut things = self.junk(count);
        let result = match way {
            Way::Instances(joints) => storage::unpack(joints, &blocks, &mut things),
            Way::Chain => storage::unpack_chain(&blocks, &mut things),
        };
        Self::answer(result, Self::flat(&things))
    }
    fn crowd(&self, joints: usize, things: &[Vec<f64>]) -> Result<Box<dyn Held>, ShapeError> {
        let crowd = Crowd::<R, N, C>::from_slice(joints, &self.things(things))?;
        Ok(Box::new(Crowded { crowd, of: Self::new(self.some) }))
    }
    fn new_crowd(&self, joints: usize, instances: usize) -> Box<dyn Held> {
        let crowd = Crowd::<R, N, C>::new(joints, instances);
        Box::new(Crowded { crowd, of: Self::new(self.some) })
    }
}

struct Crowded<E, R: Scalar, const N: usize, const C: usize>
where
    [R; N]: Row<Real = R>,
{
    crowd: Crowd<R, N, C>,
    of: Of<E, R, N, C>,
}

impl<E, R: Scalar, const N: usize, const C: usize> Held for Crowded<E, R, N, C>
where
    E: Element<C, Layout = Aos<R>> + 'static,
    [R; N]: Row<Real = R>,
{
    fn joints(&self) -> usize {
        self.crowd.joints()
    }
    fn instances(&self) -> usize {
        self.crowd.instances()
    }
    fn lanes(&self) -> Vec<Vec<f64>> {
        lanes_of(self.crowd.blocks())
    }
    fn record(&self, instance: usize, joint: usize) -> Option<Vec<f64>> {
        self.crowd.record(instance, joint).map(|record| record.map(Into::into).to_vec())
    }
    fn set_record(
        &mut self,
        instance: usize,
        joint: usize,
        record: &[f64],
    ) -> Result<(), ShapeError> {
        self.crowd.set_record(instance, joint, components(record))
    }
    fn copy(&self, count: usize) -> Answer {
        let mut things = self.of.junk(count);
        let result = self.crowd.copy_to_slice(&mut things);
        Of::<E, R, N, C>::answer(result, Of::<E, R, N, C>::flat(&things))
    }
}

/// Numbers that tell instance, joint and component, exact in `f32` too: `[instance][joint]`.
pub(crate) fn things(components: usize, count: usize) -> Vec<Vec<f64>> {
    (0..count).map(|index| (0..components).map(|c| (100 * index + c) as f64).collect()).collect()
}

/// Where the lanes of blocks have their things from: `None` for lanes without one.
fn origin(lane: usize, width: usize, joints: usize, count: usize) -> Option<usize> {
    let (block, lane) = (lane / width, lane % width);
    let index = (block / joints * width + lane) * joints + block % joints;
    (index < count).then_some(index)
}

fn assert_lanes(packing: &dyn Packing, joints: usize, things: &[Vec<f64>], lanes: &[Vec<f64>]) {
    let (width, components, padding) = (packing.lanes(), packing.components(), packing.padding());
    let count = things.len();
    for (lane, got) in lanes.iter().enumerate() {
        let wanted = origin(lane, width, joints, count).map_or(&padding, |index| &things[index]);
        assert_eq!(got, wanted, "{count} of {components}, {joints} joints, {lane} by {width}");
    }
}

/// Joints and instances: no block, a partial one, one and two full ones, and one instance more or
/// less.
fn shapes(lanes: usize) -> impl Iterator<Item = (usize, usize)> {
    let instances = [0, 1, lanes - 1, lanes, lanes + 1, 2 * lanes - 1, 2 * lanes, 2 * lanes + 1];
    [1, 2, 3, 7].into_iter().flat_map(move |joints| instances.map(|count| (joints, count)))
}

#[test]
fn lanes_are_instances_and_those_without_one_hold_the_identity_whatever_was_there() {
    for packing in packings() {
        for (joints, instances) in shapes(packing.lanes()) {
            let things = things(packing.components(), joints * instances);
            let blocks = instances.div_ceil(packing.lanes()) * joints;
            let way = Way::Instances(joints);
            let lanes = packing.pack(way, &things, blocks).expect("they fit");
            assert_eq!(lanes.len(), blocks * packing.lanes());
            assert_lanes(&*packing, joints, &things, &lanes);
            assert_eq!(packing.unpack(way, &lanes, things.len()).expect("they fit"), things);
        }
    }
}

#[test]
fn lanes_are_segments_of_a_chain_and_those_without_a_link_hold_the_identity() {
    for packing in packings() {
        for length in (0..3 * packing.lanes() + 2).chain([127, 128, 1000]) {
            let links = things(packing.components(), length);
            let blocks = length.div_ceil(packing.lanes());
            let lanes = packing.pack(Way::Chain, &links, blocks).expect("they fit");
            assert_lanes(&*packing, blocks, &links, &lanes);
            assert_eq!(packing.unpack(Way::Chain, &lanes, length).expect("they fit"), links);
        }
    }
}

/// The identity of what is a motion, and zeros else.
#[test]
fn the_identity_is_the_motion_that_changes_nothing() {
    let motion = DualQuat::<f64>::IDENTITY;
    assert_eq!(identity::<f64, 1>(), [0.0]);
    assert_eq!(identity::<f64, 3>(), [0.0; 3]);
    assert_eq!(identity::<f64, 4>(), motion.rotation().to_array());
    assert_eq!(identity::<f64, 6>(), [0.0; 6]);
    assert_eq!(identity::<f64, 7>(), [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0]);
    assert_eq!(identity::<f64, 8>(), motion.to_array());
    assert_eq!(identity::<f64, 12>(), *motion.to_matrix3x4().as_flattened());
    assert_eq!(identity::<f64, 16>(), *motion.to_matrix4().as_flattened());
}

#[test]
fn things_that_are_no_whole_number_of_instances_are_refused() {
    for packing in packings() {
        for (joints, length) in [(3, 4), (3, 2), (0, 1), (0, 5), (7, 20)] {
            let things = things(packing.components(), length);
            let wanted = ShapeError::NotWhole { what: "things", length, joints };
            names(&wanted, &[length, joints]);
            let way = Way::Instances(joints);
            assert_eq!(packing.pack(way, &things, joints).as_ref(), Err(&wanted));
            let lanes = vec![packing.padding(); joints * packing.lanes()];
            assert_eq!(packing.unpack(way, &lanes, length).as_ref(), Err(&wanted));
            assert_eq!(packing.crowd(joints, &things).err(), Some(wanted));
        }
    }
}

#[test]
fn blocks_that_are_too_few_or_too_many_are_refused() {
    for packing in packings() {
        // Three joints, one full block of instances and one more instance; and a chain as long.
        let things = things(packing.components(), 3 * (packing.lanes() + 1));
        let chain = things.len().div_ceil(packing.lanes());
        for (way, expected) in [(Way::Instances(3), 6), (Way::Chain, chain)] {
            for length in [0, 3, 5, 7, 9, 51].into_iter().filter(|length| *length != expected) {
                let wanted = ShapeError::Length { what: "blocks", length, expected };
                names(&wanted, &[length, expected]);
                assert_eq!(packing.pack(way, &things, length).as_ref(), Err(&wanted));
                let lanes = vec![packing.padding(); length * packing.lanes()];
                assert_eq!(packing.unpack(way, &lanes, things.len()), Err(wanted));
            }
        }
    }
}

/// Packing copies and computes nothing: signs of zeros, infinities and NaN come back to the bit.
#[test]
fn every_bit_of_a_number_survives() {
    let odd = [-0.0, f64::NAN, -f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e-310, 1e-40, 0.1];
    for packing in packings() {
        let once = |i: usize| (0..packing.components()).map(|c| odd[(i + c) % 8]).collect();
        let things: Vec<Vec<f64>> = (0..packing.lanes() + 1).map(once).collect();
        let lanes = packing.pack(Way::Instances(1), &things, 2).expect("they fit");
        let back = packing.unpack(Way::Instances(1), &lanes, things.len()).expect("they fit");
        for (back, thing) in back.iter().zip(&things) {
            let single = |n: f64| f64::from(n as f32);
            let rounded: Vec<f64> = thing.iter().map(|n| single(*n)).collect();
            assert!(same_bits(back, thing) || same_bits(back, &rounded), "{back:?}, {thing:?}");
        }
    }
    // Of NaN the sign as well, where nothing is converted on the way.
    fn copied<R: Scalar, const N: usize>()
    where
        [R; N]: Row<Real = R>,
    {
        let odd = [-0.0, f64::NAN, -f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e-310, 1e-40, 0.1];
        let poses = vec![DualQuat::from_array(round::<R, 8>(odd)); N + 1];
        let back = Crowd::<R, N>::from_slice(1, &poses).expect("whole instances").to_vec();
        assert_eq!(bytemuck::cast_slice::<_, u8>(&back), bytemuck::cast_slice::<_, u8>(&poses));
    }
    copied::<f32, 4>();
    copied::<f32, 8>();
    copied::<f32, 16>();
    copied::<f64, 2>();
    copied::<f64, 4>();
    copied::<f64, 8>();
}
