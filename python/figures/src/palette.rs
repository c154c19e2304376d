//! Skinning palettes, from arrays of motions or matrices.

use crate::argument::Input;
use crate::error::misshapen;
use crate::method::Method;
use crate::number::Number;
use crate::threads::{GRAIN, Threads};
use dq8::skinning::{
    DualBlend, Linear, Mixed, Skin, SkinningError, StretchedDualBlend, Surface, SurfaceMut,
    split_palette,
};
use dq8::{Backend, DualQuat};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

type Matrix3x4<R> = [[R; 4]; 3];

/// A palette for each pose.
#[derive(Debug)]
pub(crate) struct Palette<R> {
    /// The dimensions before those of one palette.
    pub(crate) poses: Vec<usize>,
    pub(crate) joints: usize,
    entries: Entries<R>,
}

/// What joints move vertices by, `[pose][joint]`.
#[derive(Debug)]
enum Entries<R> {
    Linear(Vec<Matrix3x4<R>>),
    Dual(Dual<R>),
    Mixed(Vec<Matrix3x4<R>>, Dual<R>),
}

/// Motions, of matrices with what is left of them.
#[derive(Debug)]
enum Dual<R> {
    Rigid(Vec<DualQuat<R>>),
    Stretched { motions: Vec<DualQuat<R>>, stretches: Vec<Matrix3x4<R>> },
}

impl<R: Number> Palette<R> {
    /// From `(..., joints, 8)`, `(..., joints, 3, 4)` or `(..., joints, 4, 4)`, as a method needs
    /// it.
    pub(crate) fn new(given: Input<'_, R>, method: Method, threads: &Threads) -> PyResult<Self> {
        let full = given.full_leading().to_vec();
        let (poses, joints, rows) = match full[..] {
            [ref poses @ .., joints, 8] => (poses.to_vec(), joints, None),
            [ref poses @ .., joints, rows @ (3 | 4), 4] => (poses.to_vec(), joints, Some(rows)),
            _ => {
                let expected = "(..., joints, 8), (..., joints, 3, 4) or (..., joints, 4, 4)";
                return Err(misshapen("palette", expected, &full));
            }
        };
        let given = given.in_full()?;
        let numbers = given.records::<1>().as_flattened();
        let entries = threads.run(given.py(), || {
            let matrices =
                |rows| matrices(threads, numbers, rows).map_err(|error| of_one_pose(error, joints));
            Ok(match (rows, method) {
                (None, Method::Dual) => Entries::Dual(Dual::Rigid(motions(numbers))),
                (None, Method::Linear) => Entries::Linear(matrices_of(&motions(numbers))),
                (None, Method::Mixed) => {
                    let motions = motions(numbers);
                    Entries::Mixed(matrices_of(&motions), Dual::Rigid(motions))
                }
                (Some(rows), Method::Linear) => Entries::Linear(matrices(rows)?),
                (Some(rows), Method::Dual) => Entries::Dual(split(threads, &matrices(rows)?)),
                (Some(rows), Method::Mixed) => {
                    let matrices = matrices(rows)?;
                    let dual = split(threads, &matrices);
                    Entries::Mixed(matrices, dual)
                }
            })
        })?;
        Ok(Self { poses, joints, entries })
    }

    /// A part of a mesh in one of the poses; where both blends are mixed, by `shares`.
    pub(crate) fn pose(
        &self,
        skin: &Skin<'_, u32, R>,
        shares: &[R],
        pose: usize,
        rest: Surface<'_, [R; 3]>,
        posed: SurfaceMut<'_, [R; 3]>,
    ) -> Result<(), SkinningError> {
        let backend = Backend::best();
        let of = pose * self.joints..(pose + 1) * self.joints;
        macro_rules! by {
            ($blend:expr) => {
                skin.job().backend(backend).pose($blend, rest, posed)
            };
        }
        match &self.entries {
            Entries::Linear(matrices) => by!(Linear::new(&matrices[of])),
            Entries::Dual(Dual::Rigid(motions)) => by!(DualBlend::new(&motions[of])),
            Entries::Dual(Dual::Stretched { motions, stretches }) => {
                by!(StretchedDualBlend::new(&motions[of.clone()], &stretches[of]))
            }
            Entries::Mixed(matrices, dual) => {
                let linear = Linear::new(&matrices[of.clone()]);
                match dual {
                    Dual::Rigid(motions) => {
                        by!(Mixed::new(linear, DualBlend::new(&motions[of]), shares)?)
                    }
                    Dual::Stretched { motions, stretches } => {
                        let dual = StretchedDualBlend::new(&motions[of.clone()], &stretches[of]);
                        by!(Mixed::new(linear, dual, shares)?)
                    }
                }
            }
        }
    }
}

fn motions<R: Number>(numbers: &[R]) -> Vec<DualQuat<R>> {
    numbers.as_chunks().0.iter().map(|&motion| DualQuat::from_array(motion)).collect()
}

fn matrices_of<R: Number>(motions: &[DualQuat<R>]) -> Vec<Matrix3x4<R>> {
    motions.iter().map(|motion| motion.to_matrix3x4()).collect()
}

/// Matrices of finite numbers, taken apart.
fn split<R: Number>(threads: &Threads, matrices: &[Matrix3x4<R>]) -> Dual<R> {
    let mut motions = vec![DualQuat::IDENTITY; matrices.len()];
    let mut stretches = matrices.to_vec();
    let parts = motions.chunks_mut(GRAIN).zip(stretches.chunks_mut(GRAIN));
    threads.each(matrices.chunks(GRAIN).zip(parts), &|(matrices, (motions, stretches))| {
        split_palette(matrices, motions, stretches).is_ok()
    });
    Dual::Stretched { motions, stretches }
}

/// Affine matrices of finite numbers, from those of 3 or 4 rows; fewer where the call is
/// interrupted.
fn matrices<R: Number>(
    threads: &Threads,
    numbers: &[R],
    rows: usize,
) -> Result<Vec<Matrix3x4<R>>, SkinningError> {
    let lines = numbers.as_chunks::<4>().0;
    let matrix = |(joint, matrix): (usize, &[[R; 4]])| {
        if let Some(&value) = matrix.as_flattened().iter().find(|value| !value.is_finite()) {
            return Err(SkinningError::NotFinite { joint, value: value.into() });
        }
        let last = matrix.get(3).into_iter().flatten().zip([R::ZERO, R::ZERO, R::ZERO, R::ONE]);
        for (column, (&value, wanted)) in last.enumerate() {
            if value != wanted {
                return Err(SkinningError::NotAffine { joint, column, value: value.into() });
            }
        }
        Ok([matrix[0], matrix[1], matrix[2]])
    };
    let going_on = |(joint, _): &(usize, _)| joint % GRAIN != 0 || !threads.interrupted();
    lines.chunks_exact(rows).enumerate().take_while(going_on).map(matrix).collect()
}

/// An error about a joint of all palettes, as one about a joint of its pose.
fn of_one_pose(error: SkinningError, joints: usize) -> PyErr {
    let split = |at: usize| (at / joints.max(1), at % joints.max(1));
    let (pose, error) = match error {
        SkinningError::NotFinite { joint, value } => {
            let (pose, joint) = split(joint);
            (pose, SkinningError::NotFinite { joint, value })
        }
        SkinningError::NotAffine { joint, column, value } => {
            let (pose, joint) = split(joint);
            (pose, SkinningError::NotAffine { joint, column, value })
        }
        error => return named(error),
    };
    PyValueError::new_err(format!("`palette`: pose {pose}: {error}."))
}

/// With the name of the argument that it is about.
pub(crate) fn named(error: SkinningError) -> PyErr {
    let argument = match error {
        SkinningError::NoInfluences | SkinningError::JointOutOfRange { .. } => "`joints`: ",
        SkinningError::Weight { .. } | SkinningError::Total { .. } => "`weights`: ",
        SkinningError::Share { .. } => "`shares`: ",
        _ => "",
    };
    PyValueError::new_err(format!("{argument}{error}."))
}
