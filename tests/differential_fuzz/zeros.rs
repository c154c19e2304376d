//! The sign of zero in hierarchies, with every number of instances.

use super::kernels::{backends, of_motions};
use dq8::hierarchy::{Clip, Poses, Sampled};
use dq8::law::Sclerp;
use dq8::storage::Block;
use dq8::{Crowd, DualQuat, Hierarchy, Quat, Scalar};
use dq8_contract::fusing::fuses;
use dq8_simd::Row;

/// No width of lanes divides all numbers up to this one.
const MOST: usize = 33;

const PARENTS: [u32; 3] = [Hierarchy::ROOT, 0, 1];

/// Three bones that turn about z, as a file has them: zeros of both signs come out of their
/// products.
fn leg<R: Scalar>() -> [DualQuat<R>; 3] {
    let number = <R as dq8::Real>::from_f64;
    [[0.0, 0.0, 0.8, -0.6], [0.0, 0.0, -0.96, -0.28], [-0.0, 0.0, -0.6, 0.8]].map(|turn| {
        let turn = Quat::from_array(turn.map(number));
        DualQuat::from_rotation_translation(turn, [1.0, 0.0, -0.0].map(number))
    })
}

/// In blocks, an instance has the bits that it has alone.
fn in_blocks<R: Scalar, const N: usize>(
    count: usize,
    mut models: impl FnMut(&mut [Block<R, N>], &[Block<R, N>]),
    root: DualQuat<R>,
) -> Vec<u64>
where
    [R; N]: Row<Real = R>,
{
    let roots = Crowd::<R, N>::from_slice(1, &vec![root; count]).unwrap();
    let mut crowd = Crowd::<R, N>::from_slice(PARENTS.len(), &leg().repeat(count)).unwrap();
    models(crowd.blocks_mut(), roots.blocks());
    of_motions(&crowd.to_vec())
}

fn signs<R: Scalar, const W: usize>()
where
    [R; 4]: Row<Real = R>,
    [R; 8]: Row<Real = R>,
    [R; W]: Row<Real = R>,
{
    let (tree, joints) = (Hierarchy::new(&PARENTS).unwrap(), PARENTS.len());
    let keys = [leg::<R>(), leg().map(|bone| -bone)].concat();
    let clip = Clip::new(joints, &keys).unwrap();
    let root = leg()[1];
    let mut unfused: Option<Vec<Vec<u64>>> = None;
    for backend in backends() {
        let job = tree.job().backend(backend);
        let mut of_one: Option<Vec<Vec<u64>>> = None;
        for count in 1..=MOST {
            let (at, t) = (vec![0; count], vec![R::HALF; count]);
            let sampled = Sampled::new(Sclerp, clip, &at, &t).unwrap();
            let (locals, roots) = (leg::<R>().repeat(count), vec![root; count]);
            let plain = |poses: &dyn Fn(&mut [DualQuat<R>])| {
                let mut models = locals.clone();
                poses(&mut models);
                of_motions(&models)
            };
            // Of a clip, on roots; a closure has one width alone.
            macro_rules! sampled {
                () => {
                    |models, roots| {
                        job.clone().roots(roots).locals_to_model(sampled, models).unwrap()
                    }
                };
            }
            let got = vec![
                plain(&|models| job.local_to_model_in_place(models).unwrap()),
                plain(&|models| job.clone().root(root).local_to_model_in_place(models).unwrap()),
                plain(&|models| {
                    job.clone().roots(&roots).locals_to_model(Poses(&locals), models).unwrap();
                }),
                plain(&|models| job.locals_to_model(sampled, models).unwrap()),
                plain(&|models| {
                    job.clone().roots(&roots).locals_to_model(sampled, models).unwrap()
                }),
                in_blocks::<R, 4>(
                    count,
                    |models, _| job.local_to_model_in_place(models).unwrap(),
                    root,
                ),
                in_blocks::<R, 8>(
                    count,
                    |models, _| job.local_to_model_in_place(models).unwrap(),
                    root,
                ),
                in_blocks::<R, W>(
                    count,
                    |models, _| job.local_to_model_in_place(models).unwrap(),
                    root,
                ),
                in_blocks::<R, 4>(count, sampled!(), root),
                in_blocks::<R, 8>(count, sampled!(), root),
                in_blocks::<R, W>(count, sampled!(), root),
            ];
            let name = format!("{backend}, {count} instances");
            // All terms of x are −0: 0.0 · −0.28, −0.6 · 0.0, −(0.8 · 0.0) and 0.0 ·
            // −0.96.
            let negative = (-0.0_f64).to_bits();
            assert!(got[0].chunks(8 * joints).all(|leg| leg[8] == negative), "{name}: x is +0");
            let wanted = of_one.get_or_insert_with(|| got.clone());
            for (form, (got, wanted)) in got.iter().zip(&*wanted).enumerate() {
                let same = got.chunks(8 * joints).all(|leg| leg == &wanted[..]);
                assert!(same, "{name}: other bits than alone, in form {form}");
            }
            assert!(wanted[1] == wanted[2], "{name}: one root, and one for each");
            assert!(wanted[5] == wanted[6] && wanted[5] == wanted[7], "{name}: widths");
            assert!(wanted[8] == wanted[9] && wanted[8] == wanted[10], "{name}: widths, of clips");
        }
        if !fuses(backend) {
            let first = unfused.get_or_insert_with(|| of_one.clone().unwrap());
            assert!(of_one.as_ref() == Some(&*first), "{backend}: other bits than other lanes");
        }
    }
}

#[test]
fn the_sign_of_zero_depends_on_no_number_of_instances_in_f32() {
    signs::<f32, 16>();
}

#[test]
fn the_sign_of_zero_depends_on_no_number_of_instances_in_f64() {
    signs::<f64, 2>();
}
