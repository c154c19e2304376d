//! One instance: plans with each strategy, beside the loop that users of glam write. Where the
//! strategies cross is what the constants in `src/hierarchy/{plan,schedule}.rs` say.

use crate::contender::{Contender, Peer};
use crate::representation::{Representation, Rows};
use crate::rows::Rows3x4;
use crate::skeleton;
use criterion::{BenchmarkId, Criterion, Throughput};
use dq8::{
    Backend, Block, DualQuat, Hierarchy, HierarchyPlan, Quat, Strategy, pack_chain, unpack_chain,
};
use dq8_contract::random::Random;
use glam::Affine3A;
use std::hint::black_box;

/// The biped of the example mocap, end sites included: pelvis, trunk and head, arms, legs.
const BIPED: [u32; 21] =
    [Hierarchy::ROOT, 0, 1, 2, 3, 2, 5, 6, 7, 2, 9, 10, 11, 0, 13, 14, 15, 0, 17, 18, 19];

/// Metres, and elements of rotations, for each joint of a way from the root.
const TOLERANCE: f64 = 1e-6;

pub(crate) fn skeletons(criterion: &mut Criterion) {
    race(criterion, "skeleton-64", &skeleton::parents());
    race(criterion, "biped", &BIPED);
    for reach in [1, 4, 16] {
        // As many chains side by side, or a tree in which every joint has so many children.
        let joints = 256;
        let side_by_side: Vec<u32> = (0..joints).map(|j| parent(j, j.checked_sub(reach))).collect();
        race(criterion, &format!("chains-{reach}"), &side_by_side);
        let tree: Vec<u32> = (0..joints).map(|j| parent(j, j.checked_sub(1))).collect();
        let tree: Vec<u32> = tree.iter().map(|&p| if p < joints { p / reach } else { p }).collect();
        race(criterion, &format!("tree-{reach}"), &tree);
    }
}

pub(crate) fn chains(criterion: &mut Criterion) {
    for joints in [8, 16, 24, 32, 64, 128, 1000, 10_000] {
        let parents: Vec<u32> = (0..joints).map(|j| parent(j, j.checked_sub(1))).collect();
        race(criterion, "chain", &parents);
    }
}

fn parent(joint: u32, before: Option<u32>) -> u32 {
    before.filter(|&before| before < joint).unwrap_or(Hierarchy::ROOT)
}

/// Any turn, and a way of half a metre.
fn locals(joints: usize) -> Vec<DualQuat<f32>> {
    let mut random = Random(9);
    let mut local = || {
        let turn = Quat::from_axis_angle(random.direction(), random.between(-3.0, 3.0));
        let shift = random.direction().map(|c| 0.5 * c);
        let local = DualQuat::<f64>::from_rotation_translation(turn, shift);
        DualQuat::from_array(local.to_array().map(|c| c as f32))
    };
    (0..joints).map(|_| local()).collect()
}

fn race(criterion: &mut Criterion, name: &str, parents: &[u32]) {
    let hierarchy = Hierarchy::new(parents).expect("parents come first");
    let joints = parents.len();
    let locals = locals(joints);
    let wanted = by_loop::<Rows3x4<f64>>(&hierarchy, &locals);
    let check = |name: &str, models: &[Rows]| {
        for (joint, (model, wanted)) in models.iter().zip(&wanted).enumerate() {
            let pairs = model.as_flattened().iter().zip(wanted.as_flattened());
            let worst = pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(worst < TOLERANCE * (joints + 8) as f64, "{name}: joint {joint}: {worst:e}");
        }
    };
    let rows = |motion: &DualQuat<f32>| motion.to_matrix3x4().map(|row| row.map(f64::from));
    let rows_of = |models: &[DualQuat<f32>]| models.iter().map(rows).collect::<Vec<_>>();

    let mut group = criterion.benchmark_group(format!("one-instance/{name}"));
    group.throughput(Throughput::Elements(joints as u64));
    let mut models = locals.clone();
    for strategy in [Strategy::Ordered, Strategy::Chain] {
        for backend in Backend::available() {
            let Some(plan) = HierarchyPlan::with_strategy(&hierarchy, strategy) else { continue };
            let plan = plan.backend(backend);
            plan.local_to_model(&locals, &mut models).expect("they fit");
            check(&format!("{strategy:?}"), &rows_of(&models));
            let id = BenchmarkId::new(format!("{strategy:?}-{backend}"), joints);
            group.bench_function(id, |bencher| {
                bencher.iter(|| plan.local_to_model(black_box(&locals), black_box(&mut models)));
            });
        }
    }
    if HierarchyPlan::with_strategy(&hierarchy, Strategy::Chain).is_some() {
        let mut links = vec![Block::<f32, 16>::splat([0.0; 8]); joints.div_ceil(16)];
        pack_chain(&locals, &mut links).expect("they fit");
        let mut products = links.clone();
        for backend in Backend::available() {
            backend.chain_products(&links, &mut products).expect("they fit");
            unpack_chain(&products, &mut models).expect("they fit");
            check("blocks", &rows_of(&models));
            let id = BenchmarkId::new(format!("Blocks-f32x16-{backend}"), joints);
            group.bench_function(id, |bencher| {
                bencher
                    .iter(|| backend.chain_products(black_box(&links), black_box(&mut products)));
            });
        }
    }
    check("glam", &by_loop::<Affine3A>(&hierarchy, &locals));
    let locals = Peer::<Affine3A>::pack(joints, &locals);
    let mut models = locals.clone();
    group.bench_function(BenchmarkId::new("glam-Affine3A", joints), |bencher| {
        bencher.iter(|| {
            Peer::<Affine3A>::local_to_model(
                &hierarchy,
                black_box(&locals),
                black_box(&mut models),
            );
        });
    });
}

fn by_loop<M: Representation>(hierarchy: &Hierarchy, locals: &[DualQuat<f32>]) -> Vec<Rows> {
    let locals = Peer::<M>::pack(locals.len(), locals);
    let mut models = locals.clone();
    Peer::<M>::local_to_model(hierarchy, &locals, &mut models);
    Peer::<M>::unpack(hierarchy.joints(), &models)
}
