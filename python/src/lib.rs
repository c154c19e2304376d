//! The kernels of dq8 on NumPy arrays: the module `dq8._core`. What users import is in
//! `package/dq8`.
//!
//! Functions on arrays are in `arrays`, skeletons and meshes in `figures`, mechanisms in `robots`,
//! the motions of people on robots in `retarget`, trajectories in `trajectories`.

use dq8::Backend;
use pyo3::prelude::*;

/// The instructions that compute, found at run time: ``"portable"``, ``"AVX2"`` or ``"AVX-512"``,
/// with ``", unfused"`` where they are `set_reproducible`.
#[pyfunction]
fn backend() -> String {
    Backend::best().to_string()
}

/// Whether results have the same bits on every machine, from now on and in all threads, for 1.0 to
/// 1.5 times the time; where dq8 was built from source without lanes for it, for about twice the
/// time. Not those of `dlb` and `mean` over many motions, which are sums over the lanes of whatever
/// there is.
#[pyfunction]
fn set_reproducible(reproducible: bool) {
    // Without lanes of its own, SSE2, which fuses nothing (`Cargo.toml` adds them where portable
    // lanes do).
    #[cfg(all(
        not(feature = "reproducible"),
        target_arch = "x86_64",
        not(target_feature = "fma")
    ))]
    Backend::limit(reproducible.then_some(Backend::PORTABLE));
    #[cfg(not(all(
        not(feature = "reproducible"),
        target_arch = "x86_64",
        not(target_feature = "fma")
    )))]
    Backend::set_reproducible(reproducible);
}

/// dq8 on NumPy arrays. A Python without the global interpreter lock switches it on for this
/// module, and says so: no such interpreter has run the tests.
#[pymodule(gil_used = true)]
mod _core {
    #[pymodule_export]
    use super::{backend, set_reproducible};
    #[pymodule_export]
    use dq8_python_arrays::functions::actions::{
        adjoint, coadjoint, transform_lines, transform_planes, transform_points, transform_vectors,
    };
    #[pymodule_export]
    use dq8_python_arrays::functions::algebra::{
        compose, conjugate, inverse, mul, normalize, unit_or_identity,
    };
    #[pymodule_export]
    use dq8_python_arrays::functions::between::{nlerp, sclerp};
    #[pymodule_export]
    use dq8_python_arrays::functions::chains::chain_products;
    #[pymodule_export]
    use dq8_python_arrays::functions::conversions::{
        from_rotation_translation, from_translation, rigidity, to_matrix, translation,
    };
    #[pymodule_export]
    use dq8_python_arrays::functions::distances::{
        angle_to, distance_to, distance_weighted, point_error, unit_defect,
    };
    #[pymodule_export]
    use dq8_python_arrays::functions::matrices::from_matrix;
    #[pymodule_export]
    use dq8_python_arrays::functions::means::{dlb, mean};
    #[pymodule_export]
    use dq8_python_arrays::functions::screws::{
        exp, from_screw, from_twist, integrate_body, integrate_spatial, left_jacobian,
        left_jacobian_inverse, log, pow, to_screw, to_twist,
    };
    #[pymodule_export]
    use dq8_python_arrays::functions::squad::{squad, squad_control};
    #[pymodule_export]
    use dq8_python_arrays::functions::windows::dib_windows;
    #[pymodule_export]
    use dq8_python_arrays::interrupt::tell_progress;
    #[pymodule_export]
    use dq8_python_arrays::plain::real_array;
    #[pymodule_export]
    use dq8_python_arrays::threads::{forget_threads, get_num_threads, set_num_threads};
    #[pymodule_export]
    use dq8_python_figures::hierarchy::Hierarchy;
    #[pymodule_export]
    use dq8_python_figures::packed_clip::PackedClip;
    #[pymodule_export]
    use dq8_python_figures::skin::skin;
    #[pymodule_export]
    use dq8_python_ik::reach_report::ReachReport;
    #[pymodule_export]
    use dq8_python_retarget::humanoid::Humanoid;
    #[pymodule_export]
    use dq8_python_retarget::motion::{Stop, check_settings, retarget_motion, retarget_report};
    #[pymodule_export]
    use dq8_python_retarget::person::Person;
    #[pymodule_export]
    use dq8_python_robots::mechanism::Mechanism;
    #[pymodule_export]
    use dq8_python_robots::rates::{manipulability, rates_for, velocity};
    #[pymodule_export]
    use dq8_python_robots::solutions::solutions;
    #[pymodule_export]
    use dq8_python_robots::track::track;
    #[pymodule_export]
    use dq8_python_trajectories::compare::compare;
    #[pymodule_export]
    use dq8_python_trajectories::fit::fit_pairs;
    #[pymodule_export]
    use dq8_python_trajectories::hand_eye::hand_eye_pairs;
    #[pymodule_export]
    use dq8_python_trajectories::resample::resample;
    #[pymodule_export]
    use dq8_python_trajectories::spline::Spline;
    #[pymodule_export]
    use dq8_python_trajectories::trajectory::Trajectory;
}
