//! Plans for one instance, on every backend against one product after the other in `f64`.

use crate::chain::assert_close;
use crate::memory::round;
use crate::records::assert_same_bits;
use crate::scene::{BIPED, ROOT, chain, motions, rounded, tree, walk};
use dq8::{
    Backend, DualQuat, Hierarchy, Scalar, ShapeError,
    hierarchy::{HierarchyPlan, Strategy},
};
use dq8_contract::random::Random;

/// Trees, forests and chains of many sizes.
fn hierarchies() -> Vec<Vec<u32>> {
    let mut random = Random(7);
    let mut all = vec![BIPED.to_vec(), vec![ROOT; 5]];
    all.extend([0, 1, 2, 3, 7, 8, 9, 23, 24, 25, 31, 64, 129, 1000].map(chain));
    for joints in [2, 5, 16, 17, 64, 200] {
        for (roots, reach) in [(1000, 1000), (1000, 3), (4, 1000), (9, 2)] {
            all.push(tree(&mut random, joints, roots, reach));
        }
    }
    all
}

fn plans(parents: &[u32]) -> Vec<HierarchyPlan> {
    let hierarchy = Hierarchy::new(parents).expect("parents come first");
    let mut plans = vec![HierarchyPlan::new(&hierarchy)];
    for strategy in [Strategy::Ordered, Strategy::Chain] {
        let plan = HierarchyPlan::with_strategy(&hierarchy, strategy);
        assert!(plan.as_ref().is_none_or(|plan| plan.strategy() == strategy));
        plans.extend(plan);
    }
    plans
}

/// By the plan, in numbers `R`; in place to the same bits.
fn models<R: Scalar>(plan: &HierarchyPlan, locals: &[[f64; 8]]) -> Vec<[f64; 8]> {
    let flat = |poses: &[DualQuat<R>]| -> Vec<[f64; 8]> {
        poses.iter().map(|pose| pose.to_array().map(Into::into)).collect()
    };
    let mut poses: Vec<DualQuat<R>> =
        locals.iter().map(|local| DualQuat::from_array(round(*local))).collect();
    let mut models = vec![DualQuat::ZERO; poses.len()];
    plan.local_to_model(&poses, &mut models).expect("lengths fit");
    plan.local_to_model_in_place(&mut poses).expect("lengths fit");
    let models = flat(&models);
    assert_same_bits(&flat(&poses), &models, "in place");
    models
}

#[test]
fn a_plan_gives_the_models_of_the_scalar_loop_on_every_backend() {
    let mut random = Random(1);
    for parents in hierarchies() {
        for instances in 0..=3 {
            // Of no joints there are no instances.
            let locals = motions(&mut random, instances * parents.len());
            let [singly, exactly] =
                [true, false].map(|single| walk(&parents, &rounded(single, &locals)));
            for (plan, backend) in
                plans(&parents).iter().flat_map(|p| Backend::available().map(move |b| (p, b)))
            {
                let plan = plan.clone().backend(backend);
                let what = format!("{:?} on {backend}, {} joints", plan.strategy(), plan.joints());
                assert_close(&models::<f32>(&plan, &locals), &singly, true, &what);
                assert_close(&models::<f64>(&plan, &locals), &exactly, false, &what);
            }
        }
    }
}

#[test]
fn long_chains_are_cut_and_nothing_else_is() {
    let strategy = |parents: &[u32]| {
        HierarchyPlan::new(&Hierarchy::new(parents).expect("parents come first")).strategy()
    };
    let long =
        if Backend::best() == Backend::PORTABLE { Strategy::Ordered } else { Strategy::Chain };
    assert_eq!(strategy(&chain(1000)), long);
    assert_eq!(strategy(&chain(5)), Strategy::Ordered);
    assert_eq!(strategy(&BIPED), Strategy::Ordered);
    // One joint beside the chain, or two chains.
    assert_eq!(strategy(&[chain(999), vec![5]].concat()), Strategy::Ordered);
    assert_eq!(strategy(&[chain(999), vec![ROOT]].concat()), Strategy::Ordered);
    let biped = Hierarchy::new(&BIPED).expect("parents come first");
    assert!(HierarchyPlan::with_strategy(&biped, Strategy::Chain).is_none());
}

#[test]
fn slices_that_do_not_fit_a_plan_are_left_as_they_are() {
    for parents in [BIPED.to_vec(), chain(40), vec![]] {
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
