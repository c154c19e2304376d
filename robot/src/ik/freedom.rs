//! [`Freedom`], a degree of freedom of a mechanism that a search may change, and [`Range`], the
//! values within its limits.

use super::goal::ReachError;
use crate::mechanism::joint::JointKind;
use crate::mechanism::step::{NONE, Step, unlimited};
use dq8::batch::{half_turns, vector};
use dq8::{Real, Scalar};
use dq8_simd::Lanes;

/// A degree of freedom of a search: one of the rates (components of the joint velocity) of a
/// mechanism, with its limits. A [`Reach`](super::Reach) borrows memory for one freedom per rate.
#[derive(Clone, Copy, Debug)]
pub struct Freedom<R> {
    pub(super) kind: Kind,
    pub(super) range: Range<R>,
    /// The index of the value that the freedom changes. For a floating joint it is the index of the
    /// first of the joint's seven values.
    pub(super) value: u32,
    /// The distance between two consecutive samples of this freedom in the sequence from which
    /// restarts draw, in units of 2⁻⁶⁴ of the range, modulo the range. It is zero if the
    /// range has no limits.
    pub(super) stride: u64,
    /// The index, among the freedoms that move a goal, of the freedom of rate `i`, where `i` is the
    /// index of this element in the array. All other fields of the element may belong to another
    /// rate, because the freedoms that move a goal are moved to the front of the array.
    pub(super) column: u32,
    /// The index of the next freedom on the path to the base, in the elimination tree of the sparse
    /// normal equations (see `tree.rs`).
    pub(super) parent: u32,
    /// The number of freedoms on the path to the base.
    pub(super) depth: u32,
    /// The index of the freedom's first entry in the sparse normal equations.
    pub(super) first_entry: u32,
    /// The index of the first of the six registers in the scratch with the twist of the joint that
    /// has this freedom. Joints that mimic this joint have twists of their own.
    pub(super) twist_row: u32,
}

/// The quantity that a freedom changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// The angle of a hinge or screw joint.
    Turn,
    /// The length of a slide.
    Slide,
    /// The rotation of a floating joint, about an axis of its link.
    FloatingTurn(u8),
    /// The translation of a floating joint, along an axis of its link.
    FloatingSlide(u8),
}

impl<R: Real> Default for Freedom<R> {
    /// Makes a placeholder, which [`Reach::new`](super::Reach::new) overwrites.
    fn default() -> Self {
        Self {
            kind: Kind::Turn,
            range: Range::NONE,
            value: NONE,
            stride: 0,
            column: NONE,
            parent: NONE,
            depth: 0,
            first_entry: 0,
            twist_row: 0,
        }
    }
}

impl<R: Real> Freedom<R> {
    /// Returns `true` if the freedom changes exactly one value. A freedom of a floating joint
    /// changes the joint's quaternion or its translation.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn is_single(&self) -> bool {
        matches!(self.kind, Kind::Turn | Kind::Slide)
    }

    /// Returns `true` if the freedom is a length and not an angle.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn is_slide(&self) -> bool {
        matches!(self.kind, Kind::Slide | Kind::FloatingSlide(_))
    }

    /// Returns `true` if the freedom's range has two finite ends, between which a restart can
    /// sample.
    pub(super) fn has_ends(&self) -> bool {
        let Range { low, high, .. } = self.range;
        (high - low).is_finite()
    }

    /// Returns the freedom's value in sample `number` of a sequence that covers its range evenly.
    pub(super) fn sample(&self, number: u64) -> R {
        // The product is a position in units of 2⁻⁶⁴ of the range, and wrapping drops its
        // whole multiples of the range. The fraction is converted in parts of 16 bits, each of
        // which is exact in any float.
        let stride = HALF.wrapping_add(number.wrapping_mul(self.stride));
        let (unit, mut sum) = (R::from(1.0 / 65_536.0), R::ZERO);
        for shift in [16, 32, 48] {
            sum = (sum + R::from(f32::from((stride >> shift) as u16))) * unit;
        }
        let [low, high] = self.range.sample_range();
        low + (high - low) * sum
    }

    /// Makes the freedom for one of a joint's rates, of which a floating joint has six. `index` is
    /// the index of the rate within the joint. The freedom has the limits of the joint.
    #[inline(never)]
    fn of(step: &Step<R>, index: usize) -> Self {
        let (kind, is_hinge, value) = match step.kind {
            JointKind::Prismatic { .. } => (Kind::Slide, false, 0),
            JointKind::Planar { .. } if index < 2 => (Kind::Slide, false, index),
            JointKind::Floating if index < 3 => (Kind::FloatingTurn(index as u8), false, 0),
            JointKind::Floating => (Kind::FloatingSlide(index as u8 - 3), false, 0),
            JointKind::Screw { pitch, .. } => (Kind::Turn, pitch == R::ZERO, 0),
            _ => (Kind::Turn, true, index),
        };
        let [low, high] = step.limits.unwrap_or(unlimited());
        let whole_turn = if is_hinge { WholeTurn::Blocked } else { WholeTurn::Differs };
        let value = step.value.saturating_add(value as u32);
        let range = Range { low, high, whole_turn };
        Self { kind, range, value, ..Self::default() }
    }
}

/// Writes a freedom for each rate, first the freedoms that move a goal. Returns the number of
/// freedoms that move a goal.
pub(super) fn freedoms<R: Real>(
    steps: &[Step<R>],
    freedoms: &mut [Freedom<R>],
    carries: impl Fn(usize) -> bool,
) -> Result<usize, ReachError> {
    let leaders = || steps.iter().filter(|step| !step.mimics);
    for step in leaders() {
        for index in 0..step.kind.rates() {
            if let Some(slot) = freedoms.get_mut(step.rate as usize + index) {
                *slot = Freedom::of(step, index);
            }
        }
    }
    // Only rates that move a goal get a column in the Jacobian.
    for (position, step) in steps.iter().enumerate() {
        if carries(position) {
            let rates = step.rate as usize..step.rate as usize + step.kind.rates();
            for slot in freedoms.get_mut(rates).unwrap_or_default() {
                slot.column = 0;
            }
        }
    }
    // Limits are checked only for joints that move a goal and for joints that mimic these. In many
    // URDF files the limits of other joints are wrong.
    for (_, step) in steps.iter().enumerate().filter(|(at, step)| step.mimics && carries(*at)) {
        if let Some(slot) = moving(freedoms, step.rate as usize) {
            slot.range = narrowed(slot.range, step);
        }
    }
    for step in leaders() {
        for index in 0..step.kind.rates() {
            if let Some(slot) = moving(freedoms, step.rate as usize + index) {
                let Range { low, high, whole_turn } = slot.range;
                let (is_hinge, is_angle) =
                    (whole_turn != WholeTurn::Differs, slot.kind == Kind::Turn);
                slot.range = Range::within([low, high], is_hinge, is_angle)
                    .ok_or_else(|| limits_error(step, [low, high]))?;
            }
        }
    }
    // The freedoms with a column move to the front of the slice, in order, and the element of each
    // rate keeps the index of its column. The index of a column is at most that of its rate, so no
    // element is overwritten before it is read.
    let mut count = 0;
    for rate in 0..freedoms.len() {
        let Some(&freedom) = freedoms.get(rate) else { continue };
        if freedom.column == NONE {
            continue;
        }
        if let Some(slot) = freedoms.get_mut(count) {
            *slot = Freedom { column: slot.column, ..freedom };
        }
        if let Some(slot) = freedoms.get_mut(rate) {
            slot.column = count as u32;
        }
        count += 1;
    }
    spread(freedoms.get_mut(..count).unwrap_or_default());
    Ok(count)
}

/// Sets the strides of a sequence of low discrepancy over the N ranges that have two ends. Sample k
/// of range j is at ½ + kαⱼ modulo 1 with αⱼ = g⁻ʲ, where g is the positive root of
/// gᴺ⁺¹ = g + 1, which generalises the golden ratio (Roberts 2018). The arithmetic uses
/// integers, because a microcontroller has no `f64`, and `f32` would lose the digits in which later
/// samples differ.
fn spread<R: Real>(freedoms: &mut [Freedom<R>]) {
    let count = freedoms.iter().filter(|freedom| freedom.has_ends()).count();
    let factor = spacing(count);
    let mut power = factor;
    for freedom in freedoms.iter_mut().filter(|freedom| freedom.has_ends()) {
        freedom.stride = power;
        power = times(power, factor);
    }
}

/// ½ in units of 2⁻⁶⁴.
const HALF: u64 = 1 << 63;

/// Returns 1/g in units of 2⁻⁶⁴, where gᴺ⁺¹ = g + 1 and N is `count`. This is the
/// largest x for which xᴺ + xᴺ⁺¹ is less than 1. The loop finds one bit of x after the
/// other.
fn spacing(count: usize) -> u64 {
    let mut x = 0;
    for bit in (0..64).rev() {
        let next = x | 1 << bit;
        let mut power = u64::MAX;
        for _ in 0..count {
            power = times(power, next);
        }
        if power.checked_add(times(power, next)).is_some() {
            x = next;
        }
    }
    x
}

/// Returns the product of two fractions in units of 2⁻⁶⁴, with an error of at most three
/// units. It is built from products of 32 bits, which microcontrollers have. It is not inlined, so
/// that firmware contains its code only once.
#[inline(never)]
fn times(a: u64, b: u64) -> u64 {
    let low = |number: u64| number & u64::from(u32::MAX);
    let (high, cross) = ((a >> 32) * (b >> 32), [(a >> 32) * low(b), low(a) * (b >> 32)]);
    high + (cross[0] >> 32) + (cross[1] >> 32)
}

/// Returns the freedom of a rate if it moves a goal.
fn moving<R>(freedoms: &mut [Freedom<R>], rate: usize) -> Option<&mut Freedom<R>> {
    freedoms.get_mut(rate).filter(|freedom| freedom.column != NONE)
}

/// Narrows the range of a joint by the limits of a joint that mimics it, the follower. The range
/// still allows whole turns only if the follower has the same pose after a whole turn of the joint
/// that it follows. So it must be a hinge with an integer as its multiplier.
fn narrowed<R: Real>(range: Range<R>, step: &Step<R>) -> Range<R> {
    let is_hinge = match step.kind {
        JointKind::Screw { pitch, .. } => pitch == R::ZERO,
        kind => matches!(kind, JointKind::Revolute { .. }),
    };
    let keeps = is_hinge && is_whole(step.multiplier);
    let range =
        Range { whole_turn: if keeps { range.whole_turn } else { WholeTurn::Differs }, ..range };
    match step.narrowed([range.low, range.high]) {
        Some([low, high]) => Range { low, high, ..range },
        // If the limits have no value in common, the limits of the follower are ignored.
        None => range,
    }
}

/// Returns `true` if a float is an integer. All floats of 1/ε and more are integers.
fn is_whole<R: Real>(number: R) -> bool {
    let shift = R::ONE / R::EPSILON;
    let size = number.abs();
    size >= shift || (size + shift) - shift == size
}

fn limits_error<R: Real>(step: &Step<R>, [low, high]: [R; 2]) -> ReachError {
    ReachError::Limits { joint: step.link as usize, low: low.into(), high: high.into() }
}

/// Finds the place of each of the first `count` freedoms in the elimination tree of the normal
/// equations JᵀJ: two freedoms with a nonzero entry are on one path to the base. Without joints
/// that mimic it is the tree of the joints. Returns the number of entries between a freedom and
/// those on its path. Returns zero if the goals have at most six weighted components, for which the
/// dense equations JJᵀ are quicker. `moves` tells which joints move a goal.
pub(super) fn tree_shape<R: Real>(
    steps: &[Step<R>],
    rows: usize,
    by_rate: &mut [Freedom<R>],
    count: usize,
    moves: impl Fn(usize) -> bool,
) -> usize {
    if rows <= 6 {
        return 0;
    }
    let column = |by_rate: &[Freedom<R>], step: &Step<R>, index: usize| {
        by_rate.get(step.rate as usize + index).map_or(NONE, |freedom| freedom.column)
    };
    let any_mimics = steps.iter().any(|step| step.mimics);
    for (_, step) in steps.iter().enumerate().filter(|(position, _)| moves(*position)) {
        // The freedoms of all joints that carry this one are already on one path, and the last of
        // them is the freedom with the largest column. Without joints that mimic it belongs to the
        // nearest of these joints.
        let (mut last, mut above) = (None, carrier(steps, step));
        while let Some(other) = above {
            if other.kind.rates() > 0 {
                last = last.max(Some(column(by_rate, other, other.kind.rates() - 1)));
                if !any_mimics {
                    break;
                }
            }
            above = carrier(steps, other);
        }
        for index in 0..step.kind.rates() {
            let own = column(by_rate, step, index);
            join(by_rate, own, last.unwrap_or(own));
            last = last.max(Some(own));
            if let Some(freedom) = by_rate.get_mut(own as usize).filter(|_| !step.mimics) {
                freedom.twist_row = (step.twist + index as u32) * 6;
            }
        }
    }
    let mut entries = 0;
    for column in 0..count {
        let above = by_rate.get(column).map_or(NONE, |freedom| freedom.parent);
        let depth = by_rate.get(above as usize).map_or(0, |carrier| carrier.depth + 1);
        if let Some(freedom) = by_rate.get_mut(column) {
            (freedom.depth, freedom.first_entry) = (depth, entries);
            entries += depth + 1;
        }
    }
    entries as usize
}

/// Returns the step of the joint that carries the joint of `step`.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn carrier<'s, R>(steps: &'s [Step<R>], step: &Step<R>) -> Option<&'s Step<R>> {
    steps.get(steps.get(step.parent as usize)?.position as usize)
}

/// Brings two freedoms, and all that are on their paths to the base, onto one path. Columns fall
/// along every path.
fn join<R>(freedoms: &mut [Freedom<R>], a: u32, b: u32) {
    let (mut below, mut above) = (a.max(b), a.min(b));
    while below != above {
        let Some(freedom) = freedoms.get_mut(below as usize) else { return };
        match freedom.parent {
            NONE => return freedom.parent = above,
            next if next < above => {
                freedom.parent = above;
                (below, above) = (above, next);
            }
            next => below = next,
        }
    }
}

/// The width of a range, in turns, above which a hinge counts as endless.
const ENDLESS_TURNS: f32 = 16.0;
/// The largest absolute value of an endless hinge in `f32`, radians. It is about ten turns. Floats
/// of this size are 4e-6 apart, which is less than the default tolerance of 10⁻⁵.
const FAR_SINGLE: f32 = 64.0;
/// The largest absolute value of an endless hinge in `f64`, 2²⁰ radians. It is about 167,000
/// turns. Floats of this size are 10⁻¹⁰ apart.
const FAR_DOUBLE: f32 = 1_048_576.0;

/// The values that a search may give a joint.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Range<R> {
    pub(crate) low: R,
    pub(crate) high: R,
    pub(crate) whole_turn: WholeTurn,
}

/// The effect on the pose of a joint if its value changes by a whole turn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum WholeTurn {
    /// A whole turn gives another pose.
    Differs,
    /// A whole turn gives the same pose, but the limits are less than a turn apart.
    Blocked,
    /// A whole turn gives the same pose, and the limits are a turn apart or more, so they stop no
    /// motion.
    Allowed,
    /// A whole turn gives the same pose, and the limits span so many turns that restarts sample
    /// only the turn nearest to zero.
    Endless,
}

impl<R: Real> Range<R> {
    /// The range that contains only zero.
    pub(crate) const NONE: Self =
        Self { low: R::ZERO, high: R::ZERO, whole_turn: WholeTurn::Differs };

    /// Returns the range between two limits. The range of an endless hinge ends where floats become
    /// too coarse. Returns `None` if the limits are not in order, or are so large that floats do
    /// not distinguish the angles between them.
    pub(crate) fn within([low, high]: [R; 2], is_hinge: bool, is_angle: bool) -> Option<Self> {
        let turn = R::TWO * R::PI;
        let whole_turn = match high - low {
            _ if !is_hinge => WholeTurn::Differs,
            width if width > R::from(ENDLESS_TURNS) * turn => WholeTurn::Endless,
            width if width >= turn => WholeTurn::Allowed,
            _ => WholeTurn::Blocked,
        };
        let is_single = R::EPSILON > R::from(1e-10);
        let far = R::from(if is_single { FAR_SINGLE } else { FAR_DOUBLE });
        let ends = if whole_turn == WholeTurn::Endless {
            around_zero(low, high, far)
        } else {
            [low, high]
        };
        // Beyond 2¹⁷ radians in `f32`, and 2⁴⁶ radians in `f64`, the sine of a register of
        // lanes is NaN.
        let is_near = |value: R| value.abs() * R::from(64.0) * R::EPSILON <= R::ONE;
        let fits = |value: R| !is_angle || !value.is_finite() || is_near(value);
        // If a limit is NaN, the comparison `low <= high` is false.
        let is_range = low <= high && (low.is_finite() || low < R::ZERO);
        let is_range = is_range && (high.is_finite() || high > R::ZERO);
        if !(is_range && ends.into_iter().all(fits)) {
            return None;
        }
        let [low, high] = ends;
        Some(Self { low, high, whole_turn })
    }

    /// Returns `true` if the limits stop no motion: a value beyond a limit can be replaced by a
    /// value within the limits that gives the same pose, a whole turn away.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn wraps(&self) -> bool {
        matches!(self.whole_turn, WholeTurn::Allowed | WholeTurn::Endless)
    }

    /// Returns the range in which restarts sample.
    pub(super) fn sample_range(&self) -> [R; 2] {
        match self.whole_turn {
            WholeTurn::Endless => around_zero(self.low, self.high, R::PI),
            _ => [self.low, self.high],
        }
    }
}

/// Returns the part of a range that is at most `far` from zero. If no part is that near, it returns
/// the part of one turn that is nearest to zero.
fn around_zero<R: Real>(low: R, high: R, far: R) -> [R; 2] {
    let turn = R::TWO * R::PI;
    let least = |a: R, b: R| if b < a { b } else { a };
    let most = |a: R, b: R| if b > a { b } else { a };
    [most(low, least(-far, high - turn)), least(high, most(far, low + turn))]
}

impl<R: Scalar> Range<R> {
    /// Calls [`wrap_within`](Self::wrap_within), with the rounding error of one operation as the
    /// slack.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn wrap<L: Lanes<Real = R>>(&self, value: L, to: L) -> L {
        self.wrap_within(value, to, Self::rounding(value))
    }

    /// Returns a bound on the rounding error of a computed angle that is about `value`.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn rounding<L: Lanes<Real = R>>(value: L) -> L {
        (value.abs() + value.constant(4.0)) * value.constant(4.0 * vector::epsilon::<L>())
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn ends<L: Lanes<Real = R>>(&self, level: L::Level) -> [L; 2] {
        vector::splat(level, [self.low, self.high])
    }

    /// Returns the value within the range that gives the same pose as `value` and is nearest to
    /// `to`, which must be within the range. If no value in the range gives this pose, it returns
    /// the value of the range that is nearest to `value`. A value that is beyond an end by at most
    /// `slack` becomes that end, and is not moved by a turn.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn wrap_within<L: Lanes<Real = R>>(&self, value: L, to: L, slack: L) -> L {
        let clamped = self.clamp(value);
        if self.whole_turn == WholeTurn::Differs {
            return clamped;
        }
        let [low, high] = self.ends(value.level());
        let (turn, half) = (value.constant(core::f64::consts::TAU), value.constant(0.5));
        // A value that is less than half a turn from `to` is kept with all its bits, because
        // computing it again from `rest` would round it.
        let way = value - to;
        let (_, rest) = half_turns(way * half);
        let is_far = (turn * half).lt(way.abs());
        let near = L::select(is_far, (rest + rest) + to, value);
        let near = L::select(near.lt(low) & low.le(near + slack), low, near);
        let near = L::select(high.lt(near) & (near - slack).le(high), high, near);
        // `near` is at most half a turn from `to`, so it is less than a turn beyond an end, and one
        // turn is enough.
        let near = L::select(near.lt(low), near + turn, near);
        let near = L::select(high.lt(near), near - turn, near);
        L::select(low.le(near) & near.le(high), near, clamped)
    }

    /// Returns the lanes in which a step to `value` stops at a limit, because no whole turn brings
    /// the value back within the range.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn stops<L: Lanes<Real = R>>(&self, value: L) -> L::Mask {
        let [low, high] = self.ends(value.level());
        let outside = value.lt(low) | high.lt(value);
        if self.whole_turn == WholeTurn::Differs {
            return outside;
        }
        let turn = value.constant(core::f64::consts::TAU);
        let (less, more) = (value - turn, value + turn);
        outside & (less.lt(low) | high.lt(less)) & (more.lt(low) | high.lt(more))
    }

    /// Returns the value within the range that is nearest to `value`.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn clamp<L: Lanes<Real = R>>(&self, value: L) -> L {
        let [low, high] = self.ends(value.level());
        let value = L::select(value.lt(low), low, value);
        L::select(high.lt(value), high, value)
    }
}
