//! Jacobians, velocities and accelerations in every layout and precision, held to plain arrays of `f64`, which
//! `lanes.rs` holds to one configuration at a time.

use crate::tree::{mechanism, tree, values};
use dq8::storage::{Block, Element, LinearFirst, Number, pack, unpack};
use dq8::{Backend, DualQuat, Scalar, Twist};
use dq8_fixtures::random::Random;
use dq8_robot::{Body, JointValues, Mechanism, World, WorldAligned};

/// Poses, velocities and accelerations of a tree in `f32`, each a sum of products over the links before.
const IN_SINGLE: f64 = 1e-4;

/// Slices of poses and slices of twists: of all links, and of the Jacobian of the last one in each frame.
type Found<E, C> = (Vec<Vec<E>>, Vec<Vec<C>>);

fn all<T, E, C>(
    backend: Backend,
    robot: Mechanism<'_, Number<E, 8>>,
    [values, rates, second]: [&[T]; 3],
    (elements, pose, twist): (usize, E, C),
) -> Found<E, C>
where
    T: JointValues<E::Layout>,
    E: Element<8>,
    C: Element<6, Layout = E::Layout>,
{
    let (links, last) = (elements * robot.links(), robot.links() - 1);
    let mut poses = vec![vec![pose; links]];
    let mut twists = vec![vec![twist; links], vec![twist; links]];
    let [first, accelerations] = &mut twists[..] else { unreachable!() };
    let (job, to) = (robot.job().backend(backend), &mut poses[0]);
    job.accelerations(values, rates, second, to, first, accelerations).unwrap();
    let mut alone = vec![twist; links];
    job.velocities(values, rates, to, &mut alone).unwrap();
    twists.push(alone);
    macro_rules! jacobian {
        ($($frame:expr)*) => {$(
            let mut pose_of = vec![pose; elements];
            let mut columns = vec![twist; elements * robot.rates()];
            job.links(&[last]).jacobians($frame, values, &mut pose_of, &mut columns).unwrap();
            poses.push(pose_of);
            twists.push(columns);
        )*};
    }
    jacobian! { World Body WorldAligned }
    (poses, twists)
}

/// Plain things from blocks.
fn plain<R: Scalar, T: Element<C, Layout = dq8::storage::Aos<R>>, const N: usize, const C: usize>(
    slices: Vec<Vec<Block<R, N, C>>>,
    configurations: usize,
    nothing: T,
) -> Vec<Vec<T>>
where
    [R; N]: dq8::simd::Row<Real = R>,
{
    let unpacked = |blocks: Vec<Block<R, N, C>>| {
        let each = blocks.len() / configurations.div_ceil(N);
        let mut things = vec![nothing; each * configurations];
        unpack(each, &blocks, &mut things).unwrap();
        things
    };
    slices.into_iter().map(unpacked).collect()
}

fn close<R: Scalar>(
    found: &Found<DualQuat<R>, [R; 6]>,
    wanted: &Found<DualQuat<f64>, [f64; 6]>,
    what: &str,
) {
    let far = |found: R, wanted: f64| (found.into() - wanted).abs() / (1.0 + wanted.abs());
    let poses = found.0.iter().flatten().zip(wanted.0.iter().flatten());
    let twists = found.1.iter().flatten().zip(wanted.1.iter().flatten());
    let mut worst = 0.0_f64;
    for (found, wanted) in poses {
        for (a, b) in found.to_array().into_iter().zip(wanted.to_array()) {
            worst = worst.max(far(a, b));
        }
    }
    for (found, wanted) in twists {
        for (&a, &b) in found.iter().zip(wanted) {
            let error = far(a, b);
            assert!(!error.is_nan(), "{what}");
            worst = worst.max(error);
        }
    }
    assert!(worst < IN_SINGLE, "{what}: {worst}");
}

/// A trait for joint values in blocks of their own would say no more.
macro_rules! in_blocks {
    ($R:ident, $lanes:literal, $backend:expr, $robot:expr, $inputs:expr, $configurations:expr) => {{
        let (robot, configurations) = ($robot, $configurations);
        let blocks = usize::div_ceil(configurations, $lanes);
        let (pose, twist) =
            (Block::<$R, $lanes, 8>::splat([9.0; 8]), Block::<$R, $lanes, 6>::splat([9.0; 6]));
        let packed = $inputs.map(|(each, numbers): (usize, &[$R])| {
            let mut packed = vec![Block::<$R, $lanes, 1>::splat([0.0]); blocks * each];
            pack(each, numbers, &mut packed).unwrap();
            packed
        });
        let numbers = $inputs.map(|(_, numbers)| numbers);
        let given = packed.each_ref().map(|packed| &packed[..]);
        let found = all($backend, robot, numbers, (blocks, pose, twist));
        let from_blocks = all($backend, robot, given, (blocks, pose, twist));
        [found, from_blocks].map(|(poses, twists)| {
            (
                plain::<$R, DualQuat<$R>, $lanes, 8>(poses, configurations, DualQuat::IDENTITY),
                plain::<$R, [$R; 6], $lanes, 6>(twists, configurations, [0.0; 6]),
            )
        })
    }};
}

#[test]
fn every_layout_holds_the_same_twists_and_floats_hold_them_rounded() {
    let mut random = Random(31);
    for count in [1, 2, 5, 9, 17] {
        let joints = tree(&mut random, count);
        let owned = mechanism::<f64>(&joints);
        let narrow = mechanism::<f32>(&joints);
        let robot = owned.view();
        if robot.values() == 0 {
            continue;
        }
        let configurations = 2 * count + 3;
        let values: Vec<f64> =
            (0..configurations).flat_map(|_| values(&mut random, &joints)).collect();
        let [rates, second] = [(); 2].map(|()| -> Vec<f64> {
            (0..configurations * robot.rates()).map(|_| random.signed()).collect()
        });
        let given = [&values[..], &rates, &second];
        let counts = [robot.values(), robot.rates(), robot.rates()];
        let floats = given.map(|all| all.iter().map(|&number| number as f32).collect::<Vec<_>>());
        let floats = floats.each_ref().map(|all| &all[..]);
        for backend in Backend::available() {
            let what = format!("{backend}, {count} joints");
            let one = DualQuat::<f64>::IDENTITY;
            let wanted = all(backend, robot, given, (configurations, one, [9.0; 6]));
            assert_eq!(
                wanted.1[0], wanted.1[2],
                "{what}: velocities alone, and with accelerations"
            );
            let twist = Twist::from_array([9.0; 6]);
            let named = all(backend, robot, given, (configurations, one, twist));
            let arrays = |of: fn(&Twist<f64>) -> [f64; 6]| {
                named.1.iter().map(|all| all.iter().map(of).collect()).collect::<Vec<Vec<_>>>()
            };
            assert_eq!(
                (&named.0, arrays(|twist| twist.to_array())),
                (&wanted.0, wanted.1.clone()),
                "{what}"
            );
            let linear_first =
                all(backend, robot, given, (configurations, one, LinearFirst([9.0; 6])));
            let arrays = arrays(|twist| {
                let ([a, b, c], [d, e, f]) = (twist.linear, twist.angular);
                [a, b, c, d, e, f]
            });
            let found: Vec<Vec<_>> = linear_first
                .1
                .iter()
                .map(|all| all.iter().map(|column| column.0).collect())
                .collect();
            assert_eq!((linear_first.0, found), (wanted.0.clone(), arrays), "{what}");

            let inputs = [0, 1, 2].map(|i| (counts[i], given[i]));
            for found in in_blocks!(f64, 8, backend, robot, inputs, configurations) {
                assert_eq!(found, wanted, "{what}, blocks of 8");
            }
            for found in in_blocks!(f64, 4, backend, robot, inputs, configurations) {
                assert_eq!(found, wanted, "{what}, blocks of 4");
            }
            let one = DualQuat::<f32>::IDENTITY;
            let rounded = all(backend, narrow.view(), floats, (configurations, one, [9.0; 6]));
            close(&rounded, &wanted, &what);
            let inputs = [0, 1, 2].map(|i| (counts[i], floats[i]));
            for found in in_blocks!(f32, 16, backend, narrow.view(), inputs, configurations) {
                assert_eq!(found, rounded, "{what}, blocks of 16");
            }
            for found in in_blocks!(f32, 8, backend, narrow.view(), inputs, configurations) {
                assert_eq!(found, rounded, "{what}, blocks of 8 floats");
            }
        }
    }
}

#[test]
fn a_twist_with_its_linear_part_first_is_the_same_twist() {
    let twist = Twist { angular: [1.0, 2.0, 3.0], linear: [4.0, 5.0, 6.0] };
    let swapped = LinearFirst::from(twist);
    assert_eq!(swapped, LinearFirst([4.0, 5.0, 6.0, 1.0, 2.0, 3.0]));
    assert_eq!(Twist::from(swapped), twist);
    // Read as well as written, by any kernel, with what lies beyond the end.
    let motions: Vec<DualQuat<f64>> = (0..11)
        .map(|i| {
            let s = f64::from(i);
            DualQuat::from_array([s.sin(), 0.3, s.cos(), 0.9, 0.1 * s, 1.0, -0.5, 0.2]).normalize()
        })
        .collect();
    let twists: Vec<_> = (0..11).map(|i| [1.0, 2.0, 3.0, 4.0, 5.0, f64::from(i)]).collect();
    let swapped: Vec<_> =
        twists.iter().map(|&numbers| LinearFirst::from(Twist::from_array(numbers))).collect();
    for backend in Backend::available() {
        let (mut moved, mut moved_swapped) = (twists.clone(), swapped.clone());
        backend.transform_twists_each(&motions, &twists, &mut moved).unwrap();
        backend.transform_twists_each(&motions, &swapped, &mut moved_swapped).unwrap();
        let back: Vec<_> =
            moved_swapped.iter().map(|&twist| Twist::from(twist).to_array()).collect();
        assert_eq!(back, moved, "{backend}");
        let mut packed = [Block::<f64, 8, 6>::splat([0.0; 6]); 2];
        pack(1, &swapped, &mut packed).unwrap();
        let mut plain = vec![[0.0; 6]; 11];
        unpack(1, &packed, &mut plain).unwrap();
        assert_eq!(plain, twists);
    }
}
