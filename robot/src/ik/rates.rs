//! Resolved rates: the rates of joints that give links the requested velocities.

use super::freedom::{Freedom, Kind};
use super::job::ReachJob;
use super::model::{Configurations, Model, for_each_row};
use super::problem::Reach;
use super::report::Options;
use super::scratch::{GOAL, POSE, TARGET, check_scratch};
use dq8::batch::{DualQuat, vector};
use dq8::geometry::Twist;
use dq8::internal::errors;
use dq8::storage::same_length;
use dq8::{Kernel, Real, Scalar, ShapeError};
use dq8_simd::{Lanes, Level, Mask, Portable};

impl<R> Reach<'_, R>
where
    R: Scalar + Lanes<Real = R, Level = Portable, Mask = bool>,
{
    /// Computes the joint rates that give the links of the goals the velocities `twists`, as nearly
    /// as possible. They minimise |W(Jq̇ − v)|² + λ²|q̇|², where W has the weights, J is
    /// the Jacobian, v the velocities and q̇ the rates. λ is the `damping`, which keeps rates
    /// small near singular poses (Nakamura & Hanafusa 1986). A joint at a limit does not go beyond
    /// it, and the other joints make up for it. `twists[i]` is the velocity for goal i: the angular
    /// velocity of its link and the velocity of its point, in the axes of the base
    /// ([`WorldAligned`](crate::WorldAligned)). Weights are those of the goal, in the axes of its
    /// link. A length weighs as much as a radian if it is an eighth of the longest distance along
    /// the links to a goal. Rates of joints that move no goal are zero.
    ///
    /// ```
    /// use dq8::{DualQuat, Twist};
    /// use dq8_robot::ik::{Goal, OwnedReach};
    /// use dq8_robot::{Joint, OwnedMechanism};
    /// let out = DualQuat::from_translation([1.0_f64, 0.0, 0.0]);
    /// let joints = [(None, DualQuat::IDENTITY), (Some(0), out), (Some(1), out)]
    ///     .map(|(on, at)| Joint::revolute(on, at, [0.0, 0.0, 1.0]));
    /// let reach = OwnedReach::new(OwnedMechanism::new(&joints)?, [Goal::position(2)])?;
    /// let (reach, mut scratch) = (reach.view(), vec![0.0; reach.view().scratch_len()]);
    /// // Along y by 0.1 a second, with the elbow bent.
    /// let along = Twist { angular: [0.0; 3], linear: [0.0, 0.1, 0.0] };
    /// let mut rates = [0.0; 3];
    /// reach.rates(&[0.0, 1.0, 0.0], &[along], 0.0, &mut rates, &mut scratch)?;
    /// let y = rates[0] * (1.0 + 1_f64.cos()) + rates[1] * 1_f64.cos();
    /// assert!((y - 0.1).abs() < 1e-12);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// If a slice has the wrong length, an input is not finite, or the damping is negative; nothing
    /// is written.
    pub fn rates(
        &self,
        values: &[R],
        twists: &[Twist<R>],
        damping: R,
        rates: &mut [R],
        scratch: &mut [R],
    ) -> Result<(), RatesError> {
        same_length("rates", rates.len(), self.mechanism.rates)?;
        let work = Velocities { reach: self, values, twists, damping, rates, scratch };
        work.checked(1, self.scratch_len())?.solve::<R>(Portable);
        Ok(())
    }
}

impl<R: Scalar> ReachJob<'_, R> {
    /// Computes the rates of many configurations as [`Reach::rates`] does for one configuration, on
    /// the lanes of the CPU, without allocation and on the calling thread. `values` is
    /// `[configuration][value]`, `twists` is `[configuration][goal]`, `rates` is
    /// `[configuration][rate]`, and `scratch` must have at least the length
    /// [`batch_scratch_len`](Reach::batch_scratch_len).
    ///
    /// # Errors
    /// The errors of [`Reach::rates`].
    pub fn rates_in(
        &self,
        scratch: &mut [R],
        values: &[R],
        twists: &[Twist<R>],
        damping: R,
        rates: &mut [R],
    ) -> Result<(), RatesError> {
        let count =
            dq8::storage::whole_instances("rates", self.reach.mechanism.rates, rates.len())?;
        let work = Velocities { reach: &self.reach, values, twists, damping, rates, scratch };
        let work = work.checked(count, self.reach.batch_scratch_len())?;
        self.choice.instructions().run(work);
        Ok(())
    }
}

/// The inputs and outputs of [`Reach::rates`]: values, the velocities of the goals, and the slice
/// for the rates.
struct Velocities<'s, R> {
    reach: &'s Reach<'s, R>,
    values: &'s [R],
    twists: &'s [Twist<R>],
    damping: R,
    rates: &'s mut [R],
    scratch: &'s mut [R],
}

impl<R: Real> Velocities<'_, R> {
    /// Returns `self` if all lengths fit `count` configurations and all inputs are finite, and
    /// otherwise an error.
    fn checked(self, count: usize, scratch: usize) -> Result<Self, RatesError> {
        let (goals, values) = (self.reach.goals.len(), self.reach.mechanism.values);
        check_scratch(self.scratch.len(), scratch)?;
        same_length("values", self.values.len(), count.saturating_mul(values))?;
        same_length("twists", self.twists.len(), count.saturating_mul(goals))?;
        if !(self.damping >= R::ZERO && self.damping.is_finite()) {
            return Err(RatesError::Damping { value: self.damping.into() });
        }
        for (index, &value) in self.values.iter().enumerate() {
            if !value.is_finite() {
                return Err(RatesError::Value { index, value: value.into() });
            }
        }
        for (index, twist) in self.twists.iter().enumerate() {
            for number in twist.to_array() {
                if !number.is_finite() {
                    return Err(RatesError::Twist { index, value: number.into() });
                }
            }
        }
        Ok(self)
    }
}

impl<R: Scalar> Kernel for Velocities<'_, R> {
    type Output = ();

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn run<V: Level>(self, level: V) {
        self.solve::<R::Lanes<V>>(level);
    }
}

impl<R: Scalar> Velocities<'_, R> {
    /// Computes the rates of all configurations, with a configuration in each lane.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn solve<L: Lanes<Real = R>>(self, level: L::Level) {
        // The posture is ignored, because it is a configuration and has no velocity.
        let Self { values, twists, rates, .. } = self;
        let reach = &Reach { posture: None, ..*self.reach };
        let options = Options { damping: self.damping, ..Options::track() };
        let model = Model::<L, true>::new(level, reach, (&options).into(), self.scratch);
        let Some(mut model) = model else { return };
        let length = reach.facts.size * L::Real::from(0.125);
        model.scales.length = L::splat(level, length);
        model.scales.radians_per_length = L::splat(level, L::Real::ONE / length);
        let (value_count, rate_count) = (reach.mechanism.values, reach.mechanism.rates);
        let configurations = rates.len().checked_div(rate_count).unwrap_or(0);
        for first in (0..configurations).step_by(L::LANES) {
            // Lanes without a configuration repeat the last configuration.
            for lane in 0..L::LANES {
                let from = (first + lane).min(configurations - 1);
                let values = values.get(from * value_count..).unwrap_or_default();
                for (row, &value) in values.iter().enumerate().take(value_count) {
                    model.scratch.values.set_number(row, lane, value);
                }
            }
            model.place(Configurations::Current);
            model.set_velocities(twists, first, configurations);
            model.rates();
            for rate in 0..rate_count {
                let freedom = reach.freedoms.get(reach.column(rate));
                let unit =
                    if freedom.is_some_and(Freedom::is_slide) { length } else { L::Real::ONE };
                for lane in 0..L::LANES {
                    // The change is zero for a rate that moves no goal.
                    let radians = model.scratch.radians.number(reach.column(rate), lane);
                    if let Some(slot) = rates.get_mut((first + lane) * rate_count + rate) {
                        *slot = radians * unit;
                    }
                }
            }
        }
    }
}

impl<L: Lanes<Real: Scalar>> Model<'_, L, true> {
    /// Writes the velocities to the memory of the errors. Then the equations that find changes for
    /// errors find rates for velocities.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn set_velocities(&mut self, twists: &[Twist<L::Real>], first: usize, configurations: usize) {
        let (level, reach) = (self.level, self.reach);
        let zero = L::splat(level, L::Real::ZERO);
        let (goals, mut row) = (reach.goals.len(), 0);
        for (index, goal) in reach.goals.iter().enumerate() {
            // Weights that differ from axis to axis are for the axes of the link, so the velocity
            // is converted to these axes below.
            let motion = self.pose(index).to_motion();
            self.scratch.goals.set_record(index * GOAL, motion);
            self.scratch.goals.set_record(index * GOAL + TARGET + POSE, [zero; 3]);
            let mut numbers = [zero.to_array(); 6];
            for lane in 0..L::LANES {
                let from = (first + lane).min(configurations - 1);
                let twist = twists.get(from * goals + index).copied().unwrap_or_default();
                for (array, number) in numbers.iter_mut().zip(twist.to_array()) {
                    if let Some(slot) = array.as_mut().get_mut(lane) {
                        *slot = number;
                    }
                }
            }
            let [a, b, c, x, y, z] = numbers;
            let of = |array| L::load(level, array);
            let (mut angular, mut linear) = ([of(&a), of(&b), of(&c)], [of(&x), of(&y), of(&z)]);
            if !goal.is_even() {
                let to_link = DualQuat::from_array(motion).real().conjugate();
                (angular, linear) = (to_link.rotate(angular), to_link.rotate(linear));
            }
            let linear = vector::scale(linear, self.scales.radians_per_length);
            row = for_each_row(
                goal,
                angular,
                linear,
                row,
                #[cfg_attr(not(opt_level_0), inline(always))]
                |row, component| self.scratch.error.set(row, component),
            );
        }
    }

    /// Solves for the rates in radians. A joint that is at a limit gets no rate that leads beyond
    /// it.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn rates(&mut self) {
        let (level, zero) = (self.level, self.scales.least_damping.constant(0.0));
        let one = zero.constant(1.0);
        self.release_all();
        let rows = self.rows();
        if self.uses_tree() {
            self.assemble();
        } else {
            self.linearize(false);
        }
        // Each round but the final one holds at least one more freedom at its limit in some lane,
        // so this number of rounds suffices.
        for _ in 0..=self.reach.freedoms.len() {
            self.solve(self.scales.least_damping);
            let mut stopped = zero.lt(zero);
            for (index, freedom) in self.reach.freedoms.iter().enumerate() {
                if freedom.range.wraps() || !matches!(freedom.kind, Kind::Turn | Kind::Slide) {
                    continue;
                }
                let scratch = &mut self.scratch;
                let value = scratch.values.get(level, freedom.value as usize);
                let rate = scratch.radians.get(level, index);
                let [low, high] = vector::splat(level, [freedom.range.low, freedom.range.high]);
                let is_held = scratch.held.get(level, index).eq(one);
                let stops = (value.le(low) & rate.lt(zero)) | (high.le(value) & zero.lt(rate));
                let stops = stops & !is_held;
                if !stops.any() {
                    continue;
                }
                stopped = stopped | stops;
                scratch.held.set(index, L::select(stops, one, scratch.held.get(level, index)));
                scratch.hold_column(level, index, rows, stops);
            }
            if !stopped.any() {
                break;
            }
        }
    }
}

errors! {
    /// The error of inputs from which no rates can be computed.
    #[derive(Clone, Debug, PartialEq)]
    #[cfg_attr(feature = "defmt", derive(defmt::Format))]
    RatesError {
        /// The lengths of the slices do not fit the problem or each other.
        Shape(error: ShapeError) => "{error}";
        /// The damping is negative or not finite.
        Damping { value: f64 = "The damping." } => "the damping is negative or not finite: {value}";
        /// A joint value is not finite.
        Value { index: usize = "The index of the value.", value: f64 = "The value." } => "value {index} is not finite: {value}";
        /// A velocity is not finite.
        Twist { index: usize = "The index of the twist.", value: f64 = "The component that is not finite." } => "twist {index} is not finite: it has the number {value}";
    }
}
