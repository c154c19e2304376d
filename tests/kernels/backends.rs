//! That no backend of this machine was left out, and that what is named is what computes.

use crate::records::same_bits;
use crate::scene::{SMALL, Scene};
use crate::subject::{Given, Task, subjects};
use dq8::{Backend, Crowd, DualQuat, Hierarchy, Kernel, Level};
use dq8_contract::fusing::PORTABLE_FUSES;

#[test]
fn every_backend_that_the_machine_has_is_available_and_the_last_is_the_best() {
    let ran: Vec<_> = Backend::available().collect();
    assert_eq!(ran.first(), Some(&Backend::PORTABLE));
    assert_eq!(ran.last(), Some(&Backend::best()));
    assert_eq!(Backend::default(), Backend::best());
    assert!(ran.is_sorted() && ran.iter().all(|a| ran.iter().filter(|b| *b == a).count() == 1));
    let named: Vec<_> = [Some(Backend::PORTABLE), Backend::avx2(), Backend::avx512()]
        .into_iter()
        .flatten()
        .collect();
    assert_eq!(ran, named);
    #[cfg(all(target_arch = "x86_64", target_os = "linux"))]
    {
        // What the operating system says, not the code under test.
        let text = std::fs::read_to_string("/proc/cpuinfo").expect("Linux tells what the CPU has");
        let has = |flag: &str| text.split_whitespace().any(|word| word == flag);
        let ran = |name: &str| ran.iter().any(|backend| backend.to_string() == name);
        let avx2 = has("avx2") && has("fma");
        assert_eq!(ran("AVX2"), avx2);
        let avx512 = has("avx512f") && has("avx512vl") && has("avx512dq");
        assert_eq!(ran("AVX-512"), avx2 && avx512);
    }
}

/// The type of the level that runs it.
struct Name<const WIDE: bool>;

impl<const WIDE: bool> Kernel for Name<WIDE> {
    type Output = &'static str;
    const WIDE: bool = WIDE;
    #[inline(always)]
    fn run<V: Level>(self, _: V) -> &'static str {
        core::any::type_name::<V>()
    }
}

#[test]
fn a_kernel_runs_with_the_instructions_of_its_backend() {
    for backend in Backend::available() {
        let (wide, narrow) = match backend.to_string().as_str() {
            "portable" => ("Portable", "Portable"),
            "AVX2" => ("Avx2", "Avx2"),
            "AVX-512" => ("Avx512", "Avx2"),
            other => panic!("a new backend: {other}"),
        };
        let last = |name: &'static str| name.rsplit("::").next();
        assert_eq!(last(backend.run(Name::<true>)), Some(wide), "{backend}");
        // What gains nothing from AVX-512 runs with AVX2 there.
        assert_eq!(last(backend.run(Name::<false>)), Some(narrow), "{backend}");
    }
}

/// Where one backend fuses and another does not, the bits tell which it was.
#[test]
fn a_job_runs_on_the_backend_that_it_names_and_on_the_best_unless_told() {
    let scene = Scene::small(19);
    let poses: Vec<_> = scene.poses(19).into_iter().map(DualQuat::from_array).collect();
    let hierarchy = Hierarchy::new(&SMALL).expect("parents come first");
    let models = |named: Option<Backend>| {
        let mut crowd = Crowd::<f64, 8>::from_slice(SMALL.len(), &poses).expect("whole instances");
        let job = hierarchy.job();
        let job = named.map_or(job.clone(), |backend| job.backend(backend));
        job.local_to_model_in_place(crowd.blocks_mut()).expect("they fit");
        crowd
    };
    assert_eq!(models(None), models(Some(Backend::best())));
    if let Some(avx2) = Backend::avx2() {
        assert!(PORTABLE_FUSES || models(Some(avx2)) != models(Some(Backend::PORTABLE)));
        for subject in subjects() {
            // The same models for both, so that each kernel shows its own bits.
            let locals = scene.poses(1);
            let run = |backend| {
                let task = Task::new(&SMALL, backend);
                let models = subject.forward(&task, Given::InPlace, &locals);
                let backward = subject.backward(&task, None, &locals);
                [models, backward].map(|all| all.as_flattened().to_vec())
            };
            for (portable, fused) in run(Backend::PORTABLE).iter().zip(&run(avx2)) {
                assert!(PORTABLE_FUSES || !same_bits(portable, fused), "{}", subject.name());
            }
        }
    }
}
