//! Records of numbers: where blocks keep them, and whether two are the same.

use dq8::Real;

/// How records lie in memory: `[instance block][joint][component][lane]`, one lane where things are
/// plain.
#[derive(Clone, Copy, Debug)]
pub struct Place {
    pub joints: usize,
    pub components: usize,
    pub lanes: usize,
}

impl Place {
    /// `[instance][joint]` records as they lie, rounded; `padding` in lanes without an instance.
    pub fn lay<R: Real>(self, records: &[f64], padding: &[R]) -> Vec<R> {
        let instances = records.len().div_ceil((self.joints * self.components).max(1));
        let places = instances.div_ceil(self.lanes) * self.lanes * self.joints;
        let mut numbers = vec![R::ZERO; places * self.components];
        for index in 0..places {
            let first = self.first(index);
            for component in 0..self.components {
                let given = records.get(index * self.components + component);
                numbers[first + component * self.lanes] =
                    given.map_or(padding[component], |&number| R::from_f64(number));
            }
        }
        numbers
    }

    /// Back to `[instance][joint]`, lanes without an instance included.
    pub fn read<R: Real>(self, numbers: &[R]) -> Vec<f64> {
        let mut records = vec![0.0; numbers.len()];
        for index in 0..numbers.len() / self.components {
            let first = self.first(index);
            for component in 0..self.components {
                records[index * self.components + component] =
                    numbers[first + component * self.lanes].into();
            }
        }
        records
    }

    /// Where the first number of record `index` is.
    fn first(self, index: usize) -> usize {
        let (instance, joint) = (index / self.joints.max(1), index % self.joints.max(1));
        let block = instance / self.lanes * self.joints + joint;
        block * self.components * self.lanes + instance % self.lanes
    }
}

/// Equal, or both NaN. Zeros of either sign are equal: the order of a sum decides about them.
pub fn equal(a: &[f64], b: &[f64]) -> bool {
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| a == b || a.is_nan() && b.is_nan())
}

/// To the last bit; of NaN there is one.
pub fn same_bits(a: &[f64], b: &[f64]) -> bool {
    let same = |(a, b): (&f64, &f64)| a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan();
    a.len() == b.len() && a.iter().zip(b).all(same)
}

/// Whether a record holds what no number is.
pub fn is_finite(record: &[f64]) -> bool {
    record.iter().all(|c| c.is_finite())
}
