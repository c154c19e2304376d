//! Plans for one instance, on every backend against one product after the other in `f64`.

use crate::chain::assert_close;
use crate::memory::round;
use crate::records::assert_same_bits;
use crate::scene::{BIPED, ROOT, chain, motions, rounded, tree, walk};
use dq8::{Backend, DualQuat, Scalar, ShapeError, Skeleton};
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

/// By the plan of a skeleton, in numbers `R`; in place to the same bits.
fn models<R: Scalar>(skeleton: &Skeleton, backend: Backend, locals: &[[f64; 8]]) -> Vec<[f64; 8]> {
    let flat = |poses: &[DualQuat<R>]| -> Vec<[f64; 8]> {
        poses.iter().map(|pose| pose.to_array().map(Into::into)).collect()
    };
    let mut poses: Vec<DualQuat<R>> =
        locals.iter().map(|local| DualQuat::from_array(round(*local))).collect();
    let mut models = vec![DualQuat::ZERO; poses.len()];
    let job = skeleton.job().backend(backend);
    job.local_to_model(&poses, &mut models).expect("lengths fit");
    job.local_to_model_in_place(&mut poses).expect("lengths fit");
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
            let skeleton = Skeleton::new(&parents).expect("parents come first");
            for backend in Backend::available() {
                let what = format!("{} joints on {backend}", skeleton.joints());
                let [single, double] = [
                    models::<f32>(&skeleton, backend, &locals),
                    models::<f64>(&skeleton, backend, &locals),
                ];
                assert_close(&single, &singly, true, &what);
                assert_close(&double, &exactly, false, &what);
            }
        }
    }
}

/// Of one instance only long chains are cut into segments, which multiplies in another order: the
/// bits tell.
#[test]
fn long_chains_are_cut_and_nothing_else_is() {
    let mut random = Random(3);
    for (parents, is_cut) in [
        (chain(1000), true),
        (chain(24), true),
        (chain(23), false),
        (BIPED.to_vec(), false),
        // One joint beside the chain, or two chains.
        ([chain(999), vec![5]].concat(), false),
        ([chain(999), vec![ROOT]].concat(), false),
    ] {
        let skeleton = Skeleton::new(&parents).expect("parents come first");
        let locals = motions(&mut random, parents.len());
        let planned = models::<f64>(&skeleton, Backend::best(), &locals);
        let locals: Vec<_> = locals.iter().map(|local| DualQuat::from_array(*local)).collect();
        let mut plain = locals.clone();
        let job = skeleton.hierarchy().job();
        job.local_to_model(&locals, &mut plain).expect("lengths fit");
        let plain: Vec<_> = plain.iter().map(|model| model.to_array()).collect();
        assert_eq!(planned != plain, is_cut, "{} joints", parents.len());
    }
}

#[test]
fn slices_that_do_not_fit_a_plan_are_left_as_they_are() {
    for parents in [BIPED.to_vec(), chain(40), vec![]] {
        let skeleton = Skeleton::new(&parents).expect("parents come first");
        let joints = parents.len();
        let locals = vec![DualQuat::<f32>::IDENTITY; 2 * joints + 1];
        let untouched = vec![DualQuat::ZERO; 2 * joints + 1];
        let mut models = untouched.clone();
        let error = skeleton.local_to_model(&locals, &mut models).unwrap_err();
        let length = 2 * joints + 1;
        assert_eq!(error, ShapeError::NotWhole { what: "locals", length, joints });
        let error = skeleton.local_to_model(&locals[..2 * joints], &mut models).unwrap_err();
        let expected = 2 * joints;
        assert_eq!(error, ShapeError::Length { what: "models", length, expected });
        assert_eq!(models, untouched);
        let mut poses = untouched.clone();
        let error = skeleton.job().local_to_model_in_place(&mut poses).unwrap_err();
        assert_eq!(error, ShapeError::NotWhole { what: "poses", length, joints });
        assert_eq!(poses, untouched);
    }
}
