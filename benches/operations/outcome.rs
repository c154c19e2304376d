//! [`Outcome`]: what an operation gives, as numbers that can be compared.

use crate::representation::{Representation, Rows};
use dq8::{DualQuat, DualVector, Lanes, Line, Portable, Real, batch, f32x8, f32x16};
use glam::{Affine3A, Vec3A};
use nalgebra::{DualQuaternion, Matrix4, Point3, Translation3, UnitDualQuaternion, Vector3};

/// Motions are given as the rows of their matrix: σ and −σ are one motion, and peers that have
/// matrices have nothing else.
pub(crate) trait Outcome: Copy {
    fn numbers(&self, lane: usize) -> Vec<f64>;
}

/// A number, or one a lane.
pub(crate) trait Number: Copy {
    fn lane(self, lane: usize) -> f64;
}

impl Number for f32 {
    fn lane(self, _: usize) -> f64 {
        self.into()
    }
}

impl Number for f64 {
    fn lane(self, _: usize) -> f64 {
        self
    }
}

impl Number for f32x8 {
    fn lane(self, lane: usize) -> f64 {
        self.to_array()[lane].into()
    }
}

impl Number for f32x16 {
    fn lane(self, lane: usize) -> f64 {
        self.to_array()[lane].into()
    }
}

impl<T: Number, const N: usize> Outcome for [T; N] {
    fn numbers(&self, lane: usize) -> Vec<f64> {
        self.iter().map(|number| number.lane(lane)).collect()
    }
}

impl<T: Number> Outcome for [[T; 4]; 3] {
    fn numbers(&self, lane: usize) -> Vec<f64> {
        self.iter().flat_map(|row| row.numbers(lane)).collect()
    }
}

impl<T: Number> Outcome for Line<T> {
    fn numbers(&self, lane: usize) -> Vec<f64> {
        [self.direction.numbers(lane), self.moment.numbers(lane)].concat()
    }
}

impl<T: Number> Outcome for DualVector<T> {
    fn numbers(&self, lane: usize) -> Vec<f64> {
        [self.real.numbers(lane), self.dual.numbers(lane)].concat()
    }
}

impl<R: Real> Outcome for DualQuat<R> {
    fn numbers(&self, _: usize) -> Vec<f64> {
        flat(DualQuat::<f64>::from_array(self.to_array().map(Into::into)).to_matrix3x4())
    }
}

impl<L: Number + Lanes<Level = Portable>> Outcome for batch::DualQuat<L> {
    fn numbers(&self, lane: usize) -> Vec<f64> {
        DualQuat::from_array(self.to_array().map(|number| number.lane(lane))).numbers(0)
    }
}

impl Outcome for Affine3A {
    fn numbers(&self, _: usize) -> Vec<f64> {
        flat(self.rows())
    }
}

impl Outcome for Vec3A {
    fn numbers(&self, _: usize) -> Vec<f64> {
        self.to_array().numbers(0)
    }
}

impl Outcome for UnitDualQuaternion<f32> {
    fn numbers(&self, _: usize) -> Vec<f64> {
        flat(self.rows())
    }
}

impl Outcome for DualQuaternion<f32> {
    fn numbers(&self, _: usize) -> Vec<f64> {
        UnitDualQuaternion::new_unchecked(*self).numbers(0)
    }
}

impl Outcome for Matrix4<f32> {
    fn numbers(&self, _: usize) -> Vec<f64> {
        let rows = self.fixed_rows::<3>(0);
        // nalgebra iterates by columns.
        rows.transpose().iter().map(|&number| number.into()).collect()
    }
}

impl Outcome for Translation3<f32> {
    fn numbers(&self, _: usize) -> Vec<f64> {
        self.vector.numbers(0)
    }
}

impl Outcome for Vector3<f32> {
    fn numbers(&self, _: usize) -> Vec<f64> {
        self.iter().map(|&number| number.into()).collect()
    }
}

impl Outcome for Point3<f32> {
    fn numbers(&self, _: usize) -> Vec<f64> {
        self.coords.numbers(0)
    }
}

fn flat(rows: Rows) -> Vec<f64> {
    rows.as_flattened().to_vec()
}
