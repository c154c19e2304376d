//! Hierarchies on every backend that this machine has, against the scalar path; and that none was
//! left out. The limit is for the whole process, so this is one test in a binary of its own.

use dq8::{Backend, Block, Crowd, DualQuat, Float, Hierarchy, Quat, Real};
use dq8_contract::kinematics;
use dq8_simd::Row;

const JOINTS: usize = 23;

fn parents() -> Vec<u32> {
    // Two roots, and branches that leave the trunk every third joint.
    let parent = |j: u32| match j {
        0 | 11 => Hierarchy::ROOT,
        _ if j.is_multiple_of(3) => j / 2,
        _ => j - 1,
    };
    (0..JOINTS as u32).map(parent).collect()
}

fn locals<R: Real>(instances: usize) -> Vec<DualQuat<R>> {
    let real = <R as Real>::from_f64;
    (0..instances * JOINTS)
        .map(|i| {
            let x = i as f64;
            let axis = [(x * 0.7).sin(), (x * 1.3).cos(), (x * 0.3).sin() + 0.1].map(real);
            let turn = Quat::from_parts(axis, real((x * 0.9).cos() + 0.2)).normalize();
            DualQuat::from_rotation_translation(turn, [0.3, (x * 0.11).sin(), -0.2].map(real))
        })
        .collect()
}

/// Runs a crowd forward and back, in and out of place, and returns the largest difference to scalar.
fn difference<R: Real + Float, const N: usize>(instances: usize) -> f64
where
    [R; N]: Row<Real = R>,
{
    let parents = parents();
    let hierarchy = Hierarchy::new(&parents).expect("a hierarchy");
    let locals = locals::<R>(instances);
    let mut models = locals.clone();
    kinematics::local_to_model(&parents, &locals, &mut models);
    let mut plain = locals.clone();
    hierarchy.local_to_model(&locals, &mut plain).expect("they fit");

    let crowd = Crowd::<R, N>::from_slice(JOINTS, &locals).expect("they fit");
    let mut in_place = crowd.clone();
    hierarchy.local_to_model_in_place(in_place.blocks_mut()).expect("they fit");
    let mut out = Crowd::<R, N>::new(JOINTS, instances);
    hierarchy.local_to_model(crowd.blocks(), out.blocks_mut()).expect("they fit");
    assert_eq!(in_place, out, "in and out of place");
    let identity = Block::<R, N>::splat(DualQuat::IDENTITY.to_array());
    for lane in instances % N..N {
        let last = out.blocks()[out.blocks().len() - JOINTS..].iter();
        let padding = last.map(|block| block.get(lane));
        assert!(instances.is_multiple_of(N) || padding.into_iter().all(|p| p == identity.get(0)));
    }
    let apart = |a: &[DualQuat<R>], b: &[DualQuat<R>]| {
        let components =
            a.iter().zip(b).flat_map(|(a, b)| a.to_array().into_iter().zip(b.to_array()));
        components.map(|(a, b)| (a - b).abs().into()).fold(0.0, f64::max)
    };
    let forward = apart(&out.to_vec(), &models).max(apart(&plain, &models));
    hierarchy.model_to_local_in_place(out.blocks_mut()).expect("they fit");
    forward.max(apart(&out.to_vec(), &locals))
}

/// Models of a crowd, by a backend that is named or by the best that may be used.
fn models(named: Option<Backend>) -> Crowd<f32, 8> {
    let parents = parents();
    let hierarchy = Hierarchy::new(&parents).expect("a hierarchy");
    let mut crowd = Crowd::from_slice(JOINTS, &locals(19)).expect("they fit");
    let job = named.map_or(hierarchy.job(), |backend| hierarchy.job().backend(backend));
    job.local_to_model_in_place(crowd.blocks_mut()).expect("they fit");
    crowd
}

#[test]
fn every_backend_that_the_machine_has_agrees_with_the_scalar_path() {
    let mut ran = Vec::new();
    for backend in Backend::available() {
        Backend::limit(None);
        let named = models(Some(backend));
        Backend::limit(Some(backend));
        assert_eq!(Backend::best(), backend);
        // Where one backend fuses and another does not, the bits tell which it was.
        assert_eq!(models(None), named, "{backend} is the limit");
        for instances in [1, 7, 16, 33] {
            for (name, single) in [
                ("f32 × 4", difference::<f32, 4>(instances)),
                ("f32 × 8", difference::<f32, 8>(instances)),
                ("f32 × 16", difference::<f32, 16>(instances)),
            ] {
                assert!(single < 6e-6, "{backend}, {name}, {instances} instances: {single:e}");
            }
            for (name, double) in [
                ("f64 × 2", difference::<f64, 2>(instances)),
                ("f64 × 4", difference::<f64, 4>(instances)),
                ("f64 × 8", difference::<f64, 8>(instances)),
            ] {
                assert!(double < 1e-14, "{backend}, {name}, {instances} instances: {double:e}");
            }
        }
        ran.push(backend);
    }
    Backend::limit(None);
    assert_eq!(ran.first(), Some(&Backend::Portable));
    assert_eq!(ran.last(), Some(&Backend::best()));
    #[cfg(all(target_arch = "x86_64", target_os = "linux"))]
    {
        // What the operating system says, not the code under test.
        let text = std::fs::read_to_string("/proc/cpuinfo").expect("Linux tells what the CPU has");
        let has = |flag: &str| text.split_whitespace().any(|word| word == flag);
        assert_eq!(ran.contains(&Backend::Avx2), has("avx2") && has("fma"));
        assert_eq!(
            ran.contains(&Backend::Avx512),
            has("avx512f") && has("avx512vl") && has("avx512dq")
        );
    }
}
