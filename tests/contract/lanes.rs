//! [`Reals`] and [`Motions`]: the numbers and motions of any implementation, one a lane, under one
//! type. What they compute is computed by the implementation that they belong to.
//!
//! So a law is compiled once, and not for each of sixteen implementations.

use crate::case::Flat;
use crate::implementation::On;
use std::ops::{Add, Mul, Neg, Sub};

/// The most lanes there are.
pub const MAX_LANES: usize = 16;

/// A number a lane, every number of `f32` and `f64` among them; lanes that are not there hold 0.
pub type Row = [f64; MAX_LANES];

/// Real numbers.
#[derive(Clone, Copy, Debug)]
pub struct Reals {
    pub(crate) on: On,
    pub(crate) row: Row,
}

/// Dual quaternions, `[px, py, pz, pw, qx, qy, qz, qw]`.
#[derive(Clone, Copy, Debug)]
pub struct Motions {
    pub(crate) on: On,
    pub(crate) rows: [Row; 8],
}

impl Reals {
    pub fn lanes(&self) -> Vec<f64> {
        self.row[..self.on.lanes].to_vec()
    }

    pub fn first(&self) -> f64 {
        self.row[0]
    }

    /// A sum or product of two `f32` in `f64`, rounded, is the one of `f32`.
    fn with(self, other: Self, operation: fn(f64, f64) -> f64) -> Self {
        let row = std::array::from_fn(|i| self.on.round(operation(self.row[i], other.row[i])));
        Self { row, ..self }
    }
}

impl Add for Reals {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        self.with(other, f64::add)
    }
}

impl Sub for Reals {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self.with(other, f64::sub)
    }
}

impl Mul for Reals {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        self.with(other, f64::mul)
    }
}

impl Neg for Reals {
    type Output = Self;
    fn neg(self) -> Self {
        Self { row: self.row.map(f64::neg), ..self }
    }
}

impl Flat<Reals> for Motions {
    fn put(&self, flat: &mut Vec<Reals>) {
        self.components().put(flat);
    }
    fn take(next: &mut impl FnMut() -> Reals) -> Self {
        Self::from_components(std::array::from_fn(|_| next()))
    }
}

impl Motions {
    pub fn from_components(components: [Reals; 8]) -> Self {
        Self { on: components[0].on, rows: components.map(|reals| reals.row) }
    }

    /// Whose they are.
    pub fn on(&self) -> On {
        self.on
    }

    pub fn components(self) -> [Reals; 8] {
        self.rows.map(|row| Reals { on: self.on, row })
    }

    pub fn lane(&self, lane: usize) -> [f64; 8] {
        self.rows.map(|row| row[lane])
    }

    /// Each lane.
    pub fn scatter(&self) -> Vec<[f64; 8]> {
        (0..self.on.lanes).map(|lane| self.lane(lane)).collect()
    }
}

impl Add for Motions {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::add(self, other)
    }
}

impl Sub for Motions {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self::sub(self, other)
    }
}

impl Mul for Motions {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self::mul(self, other)
    }
}

impl Neg for Motions {
    type Output = Self;
    fn neg(self) -> Self {
        Self::neg(self)
    }
}
