//! Plans for one instance, and chains in segments, on every backend against the scalar loop in `f64`.

use dq8::{
    Backend, Block, DualQuat, Hierarchy, HierarchyPlan, Link, Quat, Real, ShapeError, Strategy,
    pack_chain, unpack_chain,
};
use dq8_contract::kinematics;
use dq8_contract::random::Random;
use dq8_simd::{Float, Row};
use mocap::biped;

const ROOT: u32 = Hierarchy::ROOT;

fn chain(joints: u32) -> Vec<u32> {
    (0..joints).map(|joint| joint.wrapping_sub(1)).collect()
}

/// One joint in `roots` is a root, the others hang from one of the last `reach` joints.
fn tree(random: &mut Random, joints: u32, roots: u32, reach: u32) -> Vec<u32> {
    let mut below = |limit: u32| random.between(0.0, limit.into()) as u32;
    let parent = |joint: u32| {
        let first = joint.saturating_sub(reach);
        if joint == 0 || below(roots) == 0 { ROOT } else { first + below(joint - first) }
    };
    (0..joints).map(parent).collect()
}

/// Trees, forests and chains of many sizes.
fn hierarchies() -> Vec<Vec<u32>> {
    let mut random = Random(7);
    let mut all = vec![biped::clip().parents(), vec![ROOT; 5]];
    all.extend([0, 1, 2, 3, 7, 8, 9, 23, 24, 25, 31, 64, 129, 1000].map(chain));
    for joints in [2, 5, 16, 17, 64, 200] {
        for (roots, reach) in [(1000, 1000), (1000, 3), (4, 1000), (9, 2)] {
            all.push(tree(&mut random, joints, roots, reach));
        }
    }
    all
}

fn motions<R: Real>(random: &mut Random, count: usize) -> Vec<DualQuat<R>> {
    let mut motion = || {
        let [x, y, z, w] = [(); 4].map(|()| R::from_f64(random.signed()));
        let turn = Quat::from_xyzw(x, y, z, w + R::from_f64(0.01)).normalize();
        let shift = [(); 3].map(|()| R::from_f64(random.signed()));
        DualQuat::from_rotation_translation(turn, shift)
    };
    (0..count).map(|_| motion()).collect()
}

/// By the scalar loop, in `f64`.
fn wanted<R: Real>(parents: &[u32], locals: &[DualQuat<R>]) -> Vec<DualQuat<f64>> {
    let exact = |motion: &DualQuat<R>| DualQuat::from_array(motion.to_array().map(Into::into));
    let locals: Vec<DualQuat<f64>> = locals.iter().map(exact).collect();
    let mut models = locals.clone();
    kinematics::local_to_model(parents, &locals, &mut models);
    models
}

/// Each product adds some roundings of its factors, whose dual parts are as long as the way so far.
#[track_caller]
fn close<R: Real + Float>(got: &[DualQuat<R>], wanted: &[DualQuat<f64>], what: &str) {
    let unit = if R::SINGLE { f64::from(f32::EPSILON) } else { f64::EPSILON };
    assert_eq!(got.len(), wanted.len());
    for (index, (got, wanted)) in got.iter().zip(wanted).enumerate() {
        let size = wanted.to_array().into_iter().fold(1.0, |size, c| f64::max(size, c.abs()));
        let allowed = unit * (8.0 + index.min(1000) as f64) * size;
        for (got, wanted) in got.to_array().into_iter().zip(wanted.to_array()) {
            let error = (got.into() - wanted).abs();
            assert!(error <= allowed, "{what}, {index}: off by {error:e}, not {allowed:e}");
        }
    }
}

fn plans(parents: &[u32]) -> Vec<HierarchyPlan> {
    let hierarchy = Hierarchy::new(parents).unwrap();
    let mut plans = vec![HierarchyPlan::new(&hierarchy)];
    for strategy in [Strategy::Ordered, Strategy::Chain] {
        let plan = HierarchyPlan::with_strategy(&hierarchy, strategy);
        assert!(plan.as_ref().is_none_or(|plan| plan.strategy() == strategy));
        plans.extend(plan);
    }
    plans
}

fn bits<R: Real + Float>(motions: &[DualQuat<R>]) -> &[u8] {
    bytemuck::cast_slice(motions)
}

fn a_plan_gives_the_models_of_the_scalar_loop<R: Real + Float>() {
    let mut random = Random(1);
    for parents in hierarchies() {
        for instances in 0..=3 {
            // Of no joints there are no instances.
            let locals = motions::<R>(&mut random, instances * parents.len());
            let exact = wanted(&parents, &locals);
            for (plan, backend) in
                plans(&parents).iter().flat_map(|p| Backend::available().map(move |b| (p, b)))
            {
                let plan = plan.clone().backend(backend);
                let what = format!("{:?} on {backend}, {} joints", plan.strategy(), plan.joints());
                let mut models = vec![DualQuat::ZERO; locals.len()];
                plan.local_to_model(&locals, &mut models).unwrap();
                close(&models, &exact, &what);
                let mut poses = locals.clone();
                plan.local_to_model_in_place(&mut poses).unwrap();
                assert_eq!(bits(&poses), bits(&models), "{what}, in place");
            }
        }
    }
}

#[test]
fn a_plan_gives_the_models_of_the_scalar_loop_on_every_backend() {
    a_plan_gives_the_models_of_the_scalar_loop::<f32>();
    a_plan_gives_the_models_of_the_scalar_loop::<f64>();
}

#[test]
fn long_chains_are_cut_and_nothing_else_is() {
    let strategy =
        |parents: &[u32]| HierarchyPlan::new(&Hierarchy::new(parents).unwrap()).strategy();
    let long =
        if Backend::best() == Backend::Portable { Strategy::Ordered } else { Strategy::Chain };
    assert_eq!(strategy(&chain(1000)), long);
    assert_eq!(strategy(&chain(5)), Strategy::Ordered);
    let biped = biped::clip().parents();
    assert_eq!(strategy(&biped), Strategy::Ordered);
    // One joint beside the chain, or two chains.
    assert_eq!(strategy(&[chain(999), vec![5]].concat()), Strategy::Ordered);
    assert_eq!(strategy(&[chain(999), vec![ROOT]].concat()), Strategy::Ordered);
    let biped = Hierarchy::new(&biped).unwrap();
    assert!(HierarchyPlan::with_strategy(&biped, Strategy::Chain).is_none());
}

#[test]
fn slices_that_do_not_fit_a_plan_are_left_as_they_are() {
    for parents in [biped::clip().parents(), chain(40), vec![]] {
        for plan in plans(&parents) {
            let joints = parents.len();
            let locals = vec![DualQuat::<f32>::IDENTITY; 2 * joints + 1];
            let untouched = vec![DualQuat::ZERO; 2 * joints + 1];
            let mut models = untouched.clone();
            let error = plan.local_to_model(&locals, &mut models).unwrap_err();
            let length = 2 * joints + 1;
            assert_eq!(error, ShapeError::NotWhole { what: "locals", length, joints });
            let error = plan.local_to_model(&locals[..2 * joints], &mut models).unwrap_err();
            let expected = 2 * joints;
            assert_eq!(error, ShapeError::Length { what: "models", length, expected });
            assert_eq!(models, untouched);
            let mut poses = untouched.clone();
            let error = plan.local_to_model_in_place(&mut poses).unwrap_err();
            assert_eq!(error, ShapeError::NotWhole { what: "poses", length, joints });
            assert_eq!(poses, untouched);
        }
    }
}

/// In place and out of place, however a chain lies in memory.
fn products_of<P: Link + PartialEq + core::fmt::Debug>(backend: Backend, links: &[P]) -> Vec<P> {
    let mut in_place = links.to_vec();
    backend.chain_products_in_place(&mut in_place);
    let mut products: Vec<P> = links.iter().rev().copied().collect();
    backend.chain_products(links, &mut products).unwrap();
    assert_eq!(products, in_place, "in place is out of place");
    products
}

fn every_product<R: Real + Float>() {
    let mut random = Random(3);
    for length in (0..70).chain([127, 128, 129, 1000, 1023]) {
        let links = motions::<R>(&mut random, length);
        let exact = wanted(&chain(length as u32), &links);
        for backend in Backend::available() {
            close(&products_of(backend, &links), &exact, &format!("{length} on {backend}"));
        }
    }
}

fn every_product_in_blocks<R: Real + Float, const N: usize>()
where
    [R; N]: Row<Real = R>,
{
    let mut random = Random(4);
    for length in (0..3 * N + 2).chain([127, 128, 1000]) {
        let links = motions::<R>(&mut random, length);
        let exact = wanted(&chain(length as u32), &links);
        let mut blocks = vec![Block::<R, N>::splat([R::NAN; 8]); length.div_ceil(N)];
        pack_chain(&links, &mut blocks).unwrap();
        let mut back = vec![DualQuat::ZERO; length];
        unpack_chain(&blocks, &mut back).unwrap();
        assert_eq!(back, links);
        for backend in Backend::available() {
            unpack_chain(&products_of(backend, &blocks), &mut back).unwrap();
            close(&back, &exact, &format!("{length} in {N} lanes on {backend}"));
        }
    }
}

#[test]
fn a_chain_of_any_length_is_the_product_of_all_links_before() {
    every_product::<f32>();
    every_product::<f64>();
}

#[test]
fn a_chain_in_blocks_is_the_product_of_all_links_before() {
    every_product_in_blocks::<f32, 4>();
    every_product_in_blocks::<f32, 8>();
    every_product_in_blocks::<f32, 16>();
    every_product_in_blocks::<f64, 2>();
    every_product_in_blocks::<f64, 4>();
    every_product_in_blocks::<f64, 8>();
}

#[test]
fn links_that_do_not_fit_are_left_as_they_are() {
    let links = [DualQuat::<f32>::IDENTITY; 17];
    let mut products = [DualQuat::ZERO; 16];
    let error = Backend::best().chain_products(&links, &mut products).unwrap_err();
    assert_eq!(error, ShapeError::Length { what: "products", length: 16, expected: 17 });
    assert_eq!(products, [DualQuat::ZERO; 16]);

    let untouched = [Block::<f32, 8>::splat([7.0; 8]); 4];
    for (blocks, length) in [(2, 2), (4, 4)] {
        let mut packed = untouched;
        let error = pack_chain(&links, &mut packed[..blocks]).unwrap_err();
        assert_eq!(error, ShapeError::Length { what: "blocks", length, expected: 3 });
        assert_eq!(packed, untouched);
        let mut unpacked = [DualQuat::ZERO; 17];
        let error = unpack_chain(&untouched[..blocks], &mut unpacked).unwrap_err();
        assert_eq!(error, ShapeError::Length { what: "blocks", length, expected: 3 });
        assert_eq!(unpacked, [DualQuat::ZERO; 17]);
    }
}
