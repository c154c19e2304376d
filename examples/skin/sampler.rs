use crate::accessor::read;
use dq8::Quat;
use gltf::accessor::Dimensions;
use gltf::animation::Interpolation;

/// A curve of `N` numbers over time.
#[derive(Debug)]
pub(crate) struct Sampler<const N: usize> {
    times: Vec<f64>,
    values: Vec<[f64; N]>,
    interpolation: Interpolation,
}

impl<const N: usize> Sampler<N> {
    pub(crate) fn read(
        buffers: &[Vec<u8>],
        sampler: &gltf::animation::Sampler<'_>,
        dimensions: Dimensions,
    ) -> Result<Self, String> {
        let place = format!("accessor {}", sampler.input().index());
        let times = read::<1>(buffers, &sampler.input(), Dimensions::Scalar)?;
        let times: Vec<f64> = times.into_iter().map(|[time]| time).collect();
        let values = read(buffers, &sampler.output(), dimensions)?;
        let interpolation = sampler.interpolation();
        let each = if interpolation == Interpolation::CubicSpline { 3 } else { 1 };
        if times.is_empty() || times.len().checked_mul(each) != Some(values.len()) {
            let (times, values) = (times.len(), values.len());
            return Err(format!("{place}: {times} times for {values} values"));
        }
        if let Some(late) = times.windows(2).position(|pair| pair[0] >= pair[1]) {
            return Err(format!("{place}: time {} is not after the one before", late + 1));
        }
        Ok(Self { times, values, interpolation })
    }

    pub(crate) fn end(&self) -> f64 {
        self.times.last().copied().unwrap_or(0.0)
    }

    /// The value of a key: a key of a spline is a tangent in, a value and a tangent out.
    fn value(&self, key: usize) -> [f64; N] {
        let cubic = self.interpolation == Interpolation::CubicSpline;
        self.values[if cubic { 3 * key + 1 } else { key }]
    }

    /// The value at a time; before and after the curve, its ends. `between` is how values are
    /// interpolated linearly.
    pub(crate) fn at(
        &self,
        time: f64,
        between: impl Fn([f64; N], [f64; N], f64) -> [f64; N],
    ) -> [f64; N] {
        let cubic = self.interpolation == Interpolation::CubicSpline;
        let value = |key| self.value(key);
        let after = self.times.partition_point(|&key| key <= time);
        let Some(key) = after.checked_sub(1) else { return value(0) };
        if after == self.times.len() || self.interpolation == Interpolation::Step {
            return value(key);
        }
        let length = self.times[after] - self.times[key];
        let t = (time - self.times[key]) / length;
        if !cubic {
            return between(value(key), value(after), t);
        }
        let (out, into) = (self.values[3 * key + 2], self.values[3 * after]);
        let (a, b) = (value(key), value(after));
        let (square, cube) = (t * t, t * t * t);
        core::array::from_fn(|c| {
            (2.0 * cube - 3.0 * square + 1.0) * a[c]
                + length * (cube - 2.0 * square + t) * out[c]
                + (3.0 * square - 2.0 * cube) * b[c]
                + length * (cube - square) * into[c]
        })
    }
}

impl Sampler<4> {
    /// Checks that each key is a rotation, of whatever norm.
    pub(crate) fn of_rotations(self) -> Result<Self, String> {
        match (0..self.times.len()).find(|&key| self.value(key) == [0.0; 4]) {
            Some(key) => Err(format!("key {key} is a quaternion of zeros, which is no rotation")),
            None => Ok(self),
        }
    }
}

pub(crate) fn lerp(a: [f64; 3], b: [f64; 3], t: f64) -> [f64; 3] {
    core::array::from_fn(|c| (1.0 - t) * a[c] + t * b[c])
}

/// By the shorter way.
pub(crate) fn slerp(a: [f64; 4], b: [f64; 4], t: f64) -> [f64; 4] {
    let unit = |q| Quat::from_array(q).normalize();
    unit(a).slerp(unit(b), t).to_array()
}
