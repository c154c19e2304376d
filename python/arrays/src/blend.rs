//! Blends: means of `count` motions each. Of few, lanes are blends, whose influences lie apart in
//! memory; of many, lanes are influences.

use crate::law::load;
use crate::number::Number;
use crate::threads::{GRAIN, Threads};
use dq8::simd::{MAX_LANES, Records};
use dq8::{
    Backend, DualQuat, Kernel, Lanes, Level, Real, Twist, batch, geometry::DualVector, storage,
};

/// From so many influences on, lanes are influences: a blend is then some registers of them, and
/// what is left empty at the end does not count.
const MANY: usize = 64;

/// Which mean.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Mean {
    Linear,
    /// With a tolerance that is NaN for the usual one.
    Intrinsic {
        tolerance: f64,
        max_iterations: u32,
    },
}

impl Mean {
    fn tolerance<R: Number>(tolerance: f64) -> f64 {
        let usual = if R::SINGLE { 1e-6 } else { 1e-14 };
        if tolerance.is_nan() { usual } else { tolerance }
    }
}

/// What is blended: `count` motions for each result; those of one begin `apart` motions after those
/// of the one before.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Influences<'s, R> {
    pub(crate) count: usize,
    pub(crate) apart: usize,
    pub(crate) motions: &'s [[R; 8]],
    pub(crate) weights: Option<&'s [[R; 1]]>,
    /// Whether each result has its own weights.
    pub(crate) own: bool,
}

impl<R: Number> Influences<'_, R> {
    /// How many results are a piece of work.
    pub(crate) fn grain(&self, mean: Mean) -> usize {
        let rounds = match mean {
            Mean::Linear => 1,
            Mean::Intrinsic { max_iterations, .. } => max_iterations as usize / 32 + 1,
        };
        // Whole registers: the neighbours of a lane are the same as without pieces.
        (GRAIN / self.count / rounds).max(1).next_multiple_of(MAX_LANES)
    }

    /// Writes the means, as far as the call is not interrupted.
    pub(crate) fn blend(self, threads: &Threads, mean: Mean, to: &mut [[R; 8]]) {
        let backend = Backend::best();
        if self.count < MANY {
            return backend.run(Blend { mean, influences: self, to });
        }
        for (index, to) in to.iter_mut().enumerate() {
            let Self { count, motions, weights, .. } = self.from(index);
            let motions = motions.get(..count).unwrap_or_default();
            let weights = weights.and_then(|weights| weights.get(..count));
            *to = blend_of_many(threads, backend, mean, motions, weights).to_array();
        }
    }

    /// Those of the results from `first` on.
    pub(crate) fn from(self, first: usize) -> Self {
        let motions = self.motions.get(first * self.apart..).unwrap_or_default();
        let weights = self.weights.map(|weights| {
            if self.own { weights.get(first * self.count..).unwrap_or_default() } else { weights }
        });
        Self { motions, weights, ..self }
    }
}

struct Blend<'s, R> {
    mean: Mean,
    influences: Influences<'s, R>,
    to: &'s mut [[R; 8]],
}

impl<R: Number> Kernel for Blend<'_, R> {
    type Output = ();
    const WIDE: bool = false;

    #[inline(always)]
    fn run<V: Level>(self, level: V) {
        let Self { mean, influences, to } = self;
        let Influences { count, apart, motions, weights, own } = influences;
        let one = R::Lanes::<V>::splat(level, R::ONE);
        let mut blended = vec![(batch::DualQuat::<R::Lanes<V>>::identity(level), one); count];
        let mut first = 0;
        while let Some(rest) = to.get_mut(first..).filter(|rest| !rest.is_empty()) {
            for (i, (motion, weight)) in blended.iter_mut().enumerate() {
                let Some(from) = motions.get(first * apart + i..) else { return };
                *motion = batch::DualQuat::from_array(R::Lanes::<V>::load_strided(
                    level,
                    from,
                    Some(apart),
                    &storage::identity(),
                ));
                if let Some(weights) = weights {
                    let at = if own { first * count + i } else { i };
                    let Some(from) = weights.get(at..) else { return };
                    *weight = if own {
                        let [weight] =
                            R::Lanes::<V>::load_strided(level, from, Some(count), &[R::ONE]);
                        weight
                    } else {
                        let Some(&[weight]) = from.first() else { return };
                        R::Lanes::<V>::splat(level, weight)
                    };
                }
            }
            let result = match mean {
                Mean::Linear => batch::DualQuat::dlb(&blended),
                Mean::Intrinsic { tolerance, max_iterations } => {
                    let tolerance = one.constant(Mean::tolerance::<R>(tolerance));
                    batch::DualQuat::dib(&blended, tolerance, max_iterations)
                        .map(|mean| mean.motion)
                }
            };
            let Some(result) = result else { return };
            result.store_records(rest);
            first += R::Lanes::<V>::LANES;
        }
    }
}

/// One blend.
fn blend_of_many<R: Number>(
    threads: &Threads,
    backend: Backend,
    mean: Mean,
    motions: &[[R; 8]],
    weights: Option<&[[R; 1]]>,
) -> DualQuat<R> {
    let pivot = motions.first().copied().unwrap_or_default();
    let Sums { sum, total, longest } = backend.run(Linear { pivot, motions, weights });
    let mut motion = DualQuat::from_array(sum).normalize();
    let Mean::Intrinsic { tolerance, max_iterations } = mean else { return motion };
    let tolerance = <R as Real>::from_f64(Mean::tolerance::<R>(tolerance));
    for _ in 0..max_iterations {
        if threads.interrupted() {
            break;
        }
        let inverse = motion.conjugate().to_array();
        let step = backend.run(Logs { threads, inverse, motions, weights });
        // Logarithms are half of twists, and so is the turn.
        let step = Twist::from_array(step).scale(R::ONE / total);
        let turn = length(step.angular) + length(step.angular);
        if turn <= tolerance && length(step.linear) <= tolerance * longest {
            break;
        }
        motion = motion * DualQuat::exp(DualVector { real: step.angular, dual: step.linear });
    }
    motion
}

fn length<R: Number>([x, y, z]: [R; 3]) -> R {
    (x * x + y * y + z * z).sqrt()
}

/// Σ ±wᵢσᵢ with the signs toward the pivot, Σ wᵢ, and the length of the longest dual
/// part.
struct Linear<'s, R> {
    pivot: [R; 8],
    motions: &'s [[R; 8]],
    weights: Option<&'s [[R; 1]]>,
}

struct Sums<R> {
    sum: [R; 8],
    total: R,
    longest: R,
}

impl<R: Number> Kernel for Linear<'_, R> {
    type Output = Sums<R>;
    const WIDE: bool = false;

    #[inline(always)]
    fn run<V: Level>(self, level: V) -> Sums<R> {
        let zero = R::Lanes::<V>::splat(level, R::ZERO);
        let pivot = batch::DualQuat::<R::Lanes<V>>::splat(level, self.pivot);
        let (mut sum, mut total, mut longest) = ([zero; 8], zero, zero);
        let mut first = 0;
        while let Some((motion, weight)) = influence(level, self.motions, self.weights, first) {
            let away = motion.real().dot(pivot.real()).lt(zero);
            let signed = R::Lanes::<V>::select(away, -weight, weight);
            for (sum, component) in sum.iter_mut().zip(motion.to_array()) {
                *sum = component.mul_add(signed, *sum);
            }
            total = total + weight;
            let [x, y, z, w] = motion.dual().to_array();
            let square = x * x + y * y + z * z + w * w;
            longest = R::Lanes::<V>::select(longest.lt(square), square, longest);
            first += R::Lanes::<V>::LANES;
        }
        let mut largest = R::ZERO;
        for &square in longest.to_array().as_ref() {
            if largest < square {
                largest = square;
            }
        }
        Sums { sum: across(sum), total: across([total])[0], longest: largest.sqrt() }
    }
}

/// Σ wᵢ log(b*σᵢ), given b*.
struct Logs<'s, R> {
    threads: &'s Threads,
    inverse: [R; 8],
    motions: &'s [[R; 8]],
    weights: Option<&'s [[R; 1]]>,
}

impl<R: Number> Kernel for Logs<'_, R> {
    type Output = [R; 6];

    #[inline(always)]
    fn run<V: Level>(self, level: V) -> [R; 6] {
        let inverse = batch::DualQuat::<R::Lanes<V>>::splat(level, self.inverse);
        let mut sum = [R::Lanes::<V>::splat(level, R::ZERO); 6];
        let mut first = 0;
        while let Some((motion, weight)) = influence(level, self.motions, self.weights, first) {
            let log = (inverse * motion).log();
            let ([a, b, c], [d, e, f]) = (log.real, log.dual);
            for (sum, component) in sum.iter_mut().zip([a, b, c, d, e, f]) {
                *sum = component.mul_add(weight, *sum);
            }
            first += R::Lanes::<V>::LANES;
            if first % (16 * GRAIN) == 0 && self.threads.interrupted() {
                break;
            }
        }
        across(sum)
    }
}

/// A motion and its weight, per lane.
type Weighted<L> = (batch::DualQuat<L>, L);

/// The influences from `first` on, one per lane; those beyond the last have no weight.
#[inline(always)]
fn influence<R: Number, V: Level>(
    level: V,
    motions: &[[R; 8]],
    weights: Option<&[[R; 1]]>,
    first: usize,
) -> Option<Weighted<R::Lanes<V>>> {
    let rest = motions.get(first..).filter(|rest| !rest.is_empty())?;
    let motion = batch::DualQuat::from_array(load(level, rest)?);
    let weight = match weights {
        Some(weights) => load(level, weights.get(first..)?)?[0],
        None if rest.len() >= R::Lanes::<V>::LANES => R::Lanes::<V>::splat(level, R::ONE),
        None => {
            let mut ones = R::Lanes::<V>::splat(level, R::ZERO).to_array();
            for one in ones.as_mut().iter_mut().take(rest.len()) {
                *one = R::ONE;
            }
            R::Lanes::<V>::load(level, &ones)
        }
    };
    Some((motion, weight))
}

/// The sums over all lanes.
#[inline(always)]
fn across<L: Lanes, const C: usize>(lanes: [L; C]) -> [L::Real; C]
where
    L::Real: core::ops::Add<Output = L::Real>,
{
    let mut sums = [L::Real::default(); C];
    for (sum, lanes) in sums.iter_mut().zip(lanes) {
        for &number in lanes.to_array().as_ref() {
            *sum = *sum + number;
        }
    }
    sums
}
