//! Jobs whose input has zeros of both signs, quarter turns and half turns, for every number of
//! instances: the sign of a zero that comes out must not depend on how many are computed together.
//! Of one precision: `super::R`.

use super::R;
use super::jobs::{M, hash};
use crate::deal::Hash;
use crate::random::Random;
use dq8::hierarchy::{Clip, Plan, PlanScratch, Poses, Sampled};
use dq8::law::Sclerp;
use dq8::storage::{Block, pack, unpack};
use dq8::{Backend, Hierarchy};
use dq8_robot::{Joint, Mechanism, Step, World};

const JOINTS: usize = 4;
/// One more than the lanes of any register.
const MOST: usize = 17;
const ALL: usize = JOINTS * MOST;
const BLOCKS: usize = JOINTS * MOST.div_ceil(8);
const PARENTS: [u32; JOINTS] = [Hierarchy::ROOT, 0, 1, 0];

type Motions = Block<R, 8>;

pub(super) fn run(k: Backend, say: &mut dyn FnMut(&str, u64)) {
    let mut random = Random::new(6_364_136_223_846_793_005);
    let mut turned = || M::from_array(random.turned());
    let locals = [(); ALL].map(|()| turned());
    let roots = [(); MOST].map(|()| turned());
    hierarchies(k, say, &locals, &roots);
    robots(k, say, &locals);
}

/// Some instances of the same locals.
type Job<'s> = &'s mut dyn FnMut(&[M], &[M], &mut [M]);

fn hierarchies(k: Backend, say: &mut dyn FnMut(&str, u64), locals: &[M; ALL], roots: &[M; MOST]) {
    let mut each = |name: &str, job: Job<'_>| {
        let mut all = Hash(1);
        for count in 1..=MOST {
            let mut to = [M::IDENTITY; ALL];
            let to = &mut to[..JOINTS * count];
            job(&locals[..JOINTS * count], &roots[..count], to);
            all.bits(hash(to));
        }
        say(name, all.0);
    };
    let tree = Hierarchy::new(&PARENTS).expect("parents come first");
    let job = || tree.job().backend(k);
    each("local_to_model, zeros", &mut |locals, _, to| {
        job().local_to_model(locals, to).expect("lengths fit");
    });
    each("local_to_model, zeros, roots", &mut |locals, roots, to| {
        job().roots(roots).local_to_model(locals, to).expect("lengths fit");
    });
    each("local_to_model, zeros, blocks", &mut |locals, roots, to| {
        let mut crowd = [Motions::splat([0.0; 8]); BLOCKS];
        let mut on = [Motions::splat([0.0; 8]); MOST.div_ceil(8)];
        let on = &mut on[..roots.len().div_ceil(8)];
        let crowd = &mut crowd[..JOINTS * on.len()];
        pack(JOINTS, locals, crowd).expect("whole instances");
        pack(1, roots, on).expect("whole instances");
        job().roots(on).local_to_model_in_place(crowd).expect("lengths fit");
        unpack(JOINTS, crowd, to).expect("whole instances");
    });
    let (mut order, mut scratch) = ([[0; 2]; JOINTS], [PlanScratch::default(); JOINTS]);
    let plan = Plan::new(&tree, &mut order, &mut scratch).expect("lengths fit");
    each("local_to_model, zeros, plan", &mut |locals, roots, to| {
        to.copy_from_slice(locals);
        for (models, root) in to.chunks_mut(JOINTS).zip(roots) {
            let job = job().root(*root).plan(&plan);
            job.local_to_model_in_place(models).expect("lengths fit");
        }
    });
    each("model_to_local, zeros", &mut |models, roots, to| {
        job().roots(roots).model_to_local(models, to).expect("lengths fit");
    });
    each("palette, zeros", &mut |locals, roots, to| {
        let mut scratch = [M::IDENTITY; 3 * JOINTS];
        let (binds, job) = (&locals[..JOINTS], job().roots(roots));
        job.palette(Poses(locals), &mut scratch, binds, to).expect("lengths fit");
    });
    each("clips, zeros", &mut |_, roots, to| {
        let (mut at, mut t) = ([0; MOST], [0.0; MOST]);
        for (i, (at, t)) in at.iter_mut().zip(&mut t).enumerate() {
            (*at, *t) = (5 * i as u32 % 16, [0.0, 0.5, 1.0, 0.25][i % 4]);
        }
        let (clip, count) = (Clip::new(JOINTS, locals).expect("whole frames"), roots.len());
        let sampled = Sampled::new(Sclerp, clip, &at[..count], &t[..count]).expect("frames");
        job().roots(roots).locals_to_model(sampled, to).expect("lengths fit");
    });
    each("mul, zeros", &mut |a, _, to| {
        k.mul(a, &locals[ALL - a.len()..], to).expect("lengths fit");
    });
    each("chain_products, zeros", &mut |links, _, to| {
        k.chain_products(links, to).expect("lengths fit");
    });
}

/// Axes along coordinates, and values of quarter turns and zeros of both signs.
fn robots(k: Backend, say: &mut dyn FnMut(&str, u64), at: &[M; ALL]) {
    const LINKS: usize = 5;
    let joints: [Joint<R>; LINKS] = core::array::from_fn(|link| {
        let axis = core::array::from_fn(|i| if i == link % 3 { 1.0 } else { -0.0 });
        match link {
            2 => Joint::prismatic(Some(1), at[2], axis),
            _ => Joint::revolute(link.checked_sub(1), at[link], axis),
        }
    });
    let mut steps = [Step::default(); LINKS];
    let robot = Mechanism::new(&joints, &mut steps).expect("joints are sound");
    let quarter = <R as dq8::Real>::PI / 2.0;
    let values: [R; LINKS * MOST] =
        core::array::from_fn(|i| [0.0, -0.0, quarter, -quarter, 0.5, 2.0 * quarter, -0.0][i % 7]);
    let (mut poses, mut ends, mut columns) = (Hash(1), Hash(1), Hash(1));
    for count in 1..=MOST {
        let values = &values[..LINKS * count];
        let mut to = [M::IDENTITY; LINKS * MOST];
        let mut six = [[0.0; 6]; LINKS * MOST];
        let (links, six) = (&mut to[..LINKS * count], &mut six[..LINKS * count]);
        robot.job().backend(k).poses(values, links).expect("lengths fit");
        poses.bits(hash(links));
        let last = &mut to[..count];
        let job = robot.job().backend(k).links(&[LINKS - 1]);
        job.jacobians(World, values, last, six).expect("lengths fit");
        ends.bits(hash(last));
        columns.bits(hash(six));
    }
    say("poses, zeros", poses.0);
    say("poses of one link, zeros", ends.0);
    say("jacobians, zeros", columns.0);
}
