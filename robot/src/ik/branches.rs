//! All solutions of the two families of arms, up to eight in each lane.
//!
//! With axes and points where all values are zero, the arm is a product of turns e₁ … e₆ that
//! is the target times [`Geometry::back`] (Brockett 1984). What a turn about its own axis does not
//! change leaves equations of one angle at a time (Paden and Kahan; Elias and Wen, *IK-Geo*, 2022),
//! each of which has two solutions, or one, or is free. Every angle but the last of a group makes
//! up for what the ones before were rounded by, so nothing has to be improved afterwards.
//!
//! Angles are complex numbers e^{iθ}, one in each lane: turns are products, and only answers need an
//! arctangent.

use super::family::{Family, Geometry};
use dq8::batch::{DualQuat, atan2, vector};
use dq8::{Real, Scalar};
use dq8_simd::{Float, Lanes};

/// An angle, or a point in a plane.
#[derive(Clone, Copy, Debug)]
pub(super) struct Complex<L> {
    pub(super) re: L,
    pub(super) im: L,
}

impl<L: Lanes> Complex<L> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn splat(level: L::Level, [re, im]: [L::Real; 2]) -> Self {
        Self { re: L::splat(level, re), im: L::splat(level, im) }
    }

    /// The angle of a point; NaN at zero.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn unit(re: L, im: L) -> Self {
        let over = re.constant(1.0) / re.mul_add(re, im * im).sqrt();
        Self { re: re * over, im: im * over }
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn norm(self) -> L {
        self.re.mul_add(self.re, self.im * self.im).sqrt()
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn times(self, other: Self) -> Self {
        Self {
            re: self.im.neg_mul_add(other.im, self.re * other.re),
            im: self.im.mul_add(other.re, self.re * other.im),
        }
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn plus(self, other: Self) -> Self {
        Self { re: self.re + other.re, im: self.im + other.im }
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn conj(self) -> Self {
        Self { re: self.re, im: -self.im }
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn select(mask: L::Mask, yes: Self, no: Self) -> Self {
        Self { re: L::select(mask, yes.re, no.re), im: L::select(mask, yes.im, no.im) }
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn angle(self) -> L {
        atan2(self.im, self.re)
    }

    /// The vector turned about a unit axis (Rodrigues).
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn about(self, axis: [L; 3], v: [L; 3]) -> [L; 3] {
        let along = (v[0].constant(1.0) - self.re) * vector::dot(axis, v);
        let turned = vector::scale_onto(vector::cross(axis, v), self.im, vector::scale(v, self.re));
        vector::scale_onto(axis, along, turned)
    }

    /// The turn about a unit axis that brings `v` onto `w`, or as near as it can; NaN where one of
    /// them is along the axis.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn onto(axis: [L; 3], v: [L; 3], w: [L; 3]) -> Self {
        // Only what is across the axis counts. Where that is little, products of the whole vectors
        // would have lost it.
        let (v, w) = (vector::cross(axis, v), vector::cross(axis, w));
        Self::unit(vector::dot(v, w), vector::dot(axis, vector::cross(v, w)))
    }
}

/// The two solutions of an equation in one angle, or the first where they are one.
#[derive(Clone, Copy, Debug)]
pub(super) struct Fork<L: Lanes> {
    pub(super) turns: [Complex<L>; 2],
    pub(super) exists: [L::Mask; 2],
    /// Whether they are one, or hardly apart.
    pub(super) is_singular: L::Mask,
    /// By how much an angle is off, for a unit of roundoff of what it is computed from: much where
    /// the two meet.
    pub(super) blur: L,
}

impl<L: Lanes> Fork<L> {
    /// The angles of base·(re ± i·im), all of any length. An im that is less than `part` of the
    /// whole, both squared, is hardly any. The roundoff of `re` is that of numbers as large as
    /// `size`.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn new(
        base: Complex<L>,
        [re, im]: [L; 2],
        exists: L::Mask,
        is_double: L::Mask,
        [part, size]: [L; 2],
    ) -> Self {
        let way = Complex { re, im };
        let [one, other] = [base.times(way), base.times(way.conj())];
        let turns = [Complex::unit(one.re, one.im), Complex::unit(other.re, other.im)];
        let square = im * im;
        let is_singular = is_double | square.le(part * re.mul_add(re, square));
        // Where they meet, the angle is the root of a roundoff.
        let least = size * size.constant(root_of_epsilon::<L>());
        let blur = size / L::select(im.lt(least), least, im);
        Self { turns, exists: [exists, exists & !is_double], is_singular, blur }
    }
}

/// The root of the distance from 1 to the next larger number, rounded up to a power of two.
fn root_of_epsilon<L: Lanes>() -> f64 {
    if L::Real::SINGLE { 1.0 / 2048.0 } else { 1.0 / 67_108_864.0 }
}

/// The angle between two unit vectors.
#[derive(Clone, Copy, Debug)]
pub(super) struct Apart<L: Lanes> {
    cosine: L,
    sine: L,
    square: L,
    slack: [L; 2],
    pub(super) is_along: L::Mask,
}

impl<L: Lanes> Apart<L> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn new(v: [L; 3], w: [L; 3], slack: [L; 2]) -> Self {
        let across = vector::cross(v, w);
        let square = vector::dot(across, across);
        let sine = square.sqrt();
        Self { cosine: vector::dot(v, w), sine, square, slack, is_along: sine.le(slack[0]) }
    }

    /// Turns about `axis` that bring `v` as far from `to`. All are unit vectors.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn bend(&self, to: [L; 3], axis: [L; 3], v: [L; 3]) -> Fork<L> {
        let Self { cosine, sine, square, slack: [slack, part], .. } = *self;
        let (one, other) = (vector::dot(to, axis), vector::dot(axis, v));
        let both = one * other;
        let base =
            Complex { re: vector::dot(to, v) - both, im: vector::dot(to, vector::cross(axis, v)) };
        // 1 − cos² − a² − b² + 2ab cos for the cosines a and b to the axis, without its
        // rounding where the sine is small and they are alike.
        let is_back = cosine.lt(sine.constant(0.0));
        let (away, other) = (both + both, L::select(is_back, -other, other));
        let away = L::select(is_back, -away, away) * square / (sine.constant(1.0) + cosine.abs());
        let differ = one - other;
        let left = differ.neg_mul_add(differ, square) - away;
        let least = L::select(sine.lt(slack), slack, sine) * slack;
        // Of axes along each other, the root of a rounding.
        let root = L::select(self.is_along, sine.constant(0.0), positive(left).sqrt());
        let parts = [cosine - both, root];
        Fork::new(base, parts, (-least).le(left), left.le(least), [part, sine.constant(1.0)])
    }
}

/// Zero below it.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn positive<L: Lanes>(number: L) -> L {
    let zero = number.constant(0.0);
    L::select(number.lt(zero), zero, number)
}

/// What is none, in units of the last place; poses themselves are computed to some ten. By how much
/// of the arm's size a target may be out of reach; the same within reach, where two solutions are
/// one; the sine between axes that are along each other; and the square of half the angle between
/// solutions that are hardly two.
const SLACK: [f64; 4] = [64.0, 16.0, 32.0, 4096.0];

/// One of the eight.
#[derive(Clone, Copy, Debug)]
pub(super) struct Branch<L: Lanes> {
    /// Of any length.
    pub(super) turns: [Complex<L>; 6],
    pub(super) exists: L::Mask,
    /// By how much the angles before the wrist are off, for a unit of roundoff.
    blur: L,
    /// Whether it meets another, or is one of many: at the shoulder, the elbow and the wrist.
    pub(super) singular: [L::Mask; 3],
}

impl<L: Lanes> Branch<L> {
    /// What its angles are rounded by, where others are by `rounding`, and `most` at the most.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn rounding(&self, rounding: L, most: L) -> L {
        let rounding = rounding * (most.constant(1.0) + self.blur);
        L::select(most.lt(rounding), most, rounding)
    }
}

/// Geometry and targets on lanes.
pub(super) struct Arm<'s, L: Lanes> {
    level: L::Level,
    geometry: &'s Geometry<L::Real>,
    /// The motion of what is fixed to the tool.
    goal: DualQuat<L>,
    /// Where every angle will do.
    start: [Complex<L>; 6],
    slack: [L; 4],
    normal: [L; 3],
    across: [[L; 3]; 2],
}

impl<'s, L: Lanes<Real: Scalar>> Arm<'s, L> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn new(
        level: L::Level,
        geometry: &'s Geometry<L::Real>,
        target: DualQuat<L>,
        start: [Complex<L>; 6],
    ) -> Self {
        let back = DualQuat::from_array(vector::splat(level, geometry.back.to_array()));
        let [reach, merge, angle, square] = SLACK.map(
            #[cfg_attr(not(opt_level_0), inline(always))]
            |units| start[0].re.constant(units * vector::epsilon::<L>()),
        );
        let (size, [right, up]) = (L::splat(level, geometry.size), geometry.across);
        Self {
            level,
            geometry,
            goal: target * back,
            start,
            slack: [size * reach, size * merge, angle, square],
            normal: vector::splat(level, geometry.axes[1]),
            across: [vector::splat(level, right), vector::splat(level, up)],
        }
    }

    /// Memory to be written.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn nowhere(&self) -> Branch<L> {
        let [zero, ..] = self.slack;
        let never = zero.lt(zero);
        let turn = Complex { re: zero, im: zero };
        Branch { turns: [turn; 6], exists: never, blur: zero, singular: [never; 3] }
    }

    /// The solutions, but for limits.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn solve(&self) -> [Branch<L>; 8] {
        let mut branches = [self.nowhere(); 8];
        match self.geometry.family {
            Family::SphericalWrist => self.spherical_wrist(&mut branches),
            Family::ThreeParallel => self.three_parallel(&mut branches),
            Family::Other => {}
        }
        branches
    }

    /// Turns of the wrist leave its centre where it is: first an arm of three axes for that, then
    /// the wrist.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn spherical_wrist(&self, branches: &mut [Branch<L>; 8]) {
        let last = self.goal.transform_vector(self.axis(5));
        let [across, across_too] = self.geometry.end;
        let [across, across_too] = [self.vector(across), self.vector(across_too)];
        let turned = self.goal.transform_vector(across);
        let (mut places, mut rest) = ([self.nowhere(); 4], branches.iter_mut());
        if self.geometry.crosses {
            self.crossing_shoulder(&mut places);
        } else {
            self.parallel_elbow(&mut places);
        }
        for Branch { mut turns, exists, blur, mut singular } in places {
            let (mut last, mut turned) = (last, turned);
            for (index, turn) in turns.into_iter().enumerate().take(3) {
                let (axis, back) = (self.axis(index), turn.conj());
                (last, turned) = (back.about(axis, last), back.about(axis, turned));
            }
            let (wrist, is_free) = self.wrist(last, self.vector(self.geometry.against), blur);
            singular[2] = wrist.is_singular;
            for (fifth, is_wrist) in wrist.turns.into_iter().zip(wrist.exists) {
                let swung = fifth.about(self.axis(4), self.axis(5));
                let fourth = Complex::onto(self.axis(3), swung, last);
                let fourth = Complex::select(is_free, self.start[3], fourth);
                let left = fourth.conj().about(self.axis(3), turned);
                let left = fifth.conj().about(self.axis(4), left);
                let sixth =
                    Complex { re: vector::dot(across, left), im: vector::dot(across_too, left) };
                (turns[3], turns[4], turns[5]) = (fourth, fifth, sixth);
                let Some(branch) = rest.next() else { return };
                *branch = Branch { turns, exists: exists & is_wrist, blur, singular };
            }
        }
    }

    /// The centre of the wrist by a shoulder, and two links in a plane.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn parallel_elbow(&self, places: &mut [Branch<L>; 4]) {
        let way = self.way(self.vector(self.geometry.centre));
        let shoulder = self.shoulder(way);
        let mut rest = places.iter_mut();
        for (first, exists) in shoulder.turns.into_iter().zip(shoulder.exists) {
            let end = self.in_plane(first, way);
            let elbow = self.elbow(end.norm());
            for (third, is_elbow) in elbow.turns.into_iter().zip(elbow.exists) {
                let Some(place) = rest.next() else { return };
                place.turns[0] = first;
                place.turns[1] = self.upper_arm(end, third);
                place.turns[2] = self.signed(0, third);
                place.exists = exists & is_elbow;
                place.blur = shoulder.blur + elbow.blur;
                (place.singular[0], place.singular[1]) = (shoulder.is_singular, elbow.is_singular);
            }
        }
    }

    /// The same where the first two axes cross: the distance from there, then the direction.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn crossing_shoulder(&self, places: &mut [Branch<L>; 4]) {
        let way = self.way(self.vector(self.geometry.centre));
        let [upper, lower] = [self.vector(self.geometry.upper), self.vector(self.geometry.lower)];
        let distance = vector::dot(way, way).sqrt();
        let elbow = self.elbow(distance);
        let one = distance.constant(1.0);
        let direction = vector::scale(way, one / distance);
        // With the centre in the crossing, both axes turn about it.
        let is_free = distance.le(self.slack[0]);
        let mut rest = places.iter_mut();
        for (third, exists) in elbow.turns.into_iter().zip(elbow.exists) {
            let end = vector::add(upper, third.about(self.axis(2), lower));
            let end = vector::scale(end, one / vector::dot(end, end).sqrt());
            let apart = Apart::new(direction, self.axis(0), [self.slack[2], self.slack[3]]);
            let shoulder = apart.bend(self.axis(0), self.axis(1), end);
            for (second, is_shoulder) in shoulder.turns.into_iter().zip(shoulder.exists) {
                let first = Complex::onto(self.axis(0), second.about(self.axis(1), end), direction);
                let Some(place) = rest.next() else { return };
                place.turns[0] = Complex::select(apart.is_along | is_free, self.start[0], first);
                place.turns[1] = Complex::select(is_free, self.start[1], second);
                place.turns[2] = third;
                place.exists = exists & (is_shoulder | is_free);
                place.blur = shoulder.blur + elbow.blur;
                (place.singular[0], place.singular[1]) = (shoulder.is_singular, elbow.is_singular);
            }
        }
    }

    /// The three parallel axes change neither the height along them nor a direction along them:
    /// that gives the others; then a chain of two links and a hand in the plane.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn three_parallel(&self, branches: &mut [Branch<L>; 8]) {
        let way = self.way(self.vector(self.geometry.centre));
        let shoulder = self.shoulder(way);
        let last = self.goal.transform_vector(self.axis(5));
        let rotation = self.goal.rotation();
        let hand = self.vector(self.geometry.lower);
        let mut rest = branches.iter_mut();
        for (first, exists) in shoulder.turns.into_iter().zip(shoulder.exists) {
            let normal = first.about(self.axis(0), self.normal);
            let (wrist, is_free) = self.wrist(last, normal, shoulder.blur);
            let normal = rotation.conjugate().rotate(normal);
            for (fifth, is_wrist) in wrist.turns.into_iter().zip(wrist.exists) {
                let back = fifth.conj();
                let swung = back.about(self.axis(4), self.normal);
                let sixth = Complex::onto(self.axis(5), normal, swung);
                let sixth = Complex::select(is_free, self.start[5], sixth);
                let hand = sixth.conj().about(self.axis(5), back.about(self.axis(4), hand));
                let along = back.about(self.axis(4), self.across[0]);
                let along = rotation.rotate(sixth.conj().about(self.axis(5), along));
                let all = self.directions(first, along);
                let all = Complex::unit(all.re, all.im);
                let hand = self.in_plane(first, vector::add(way, rotation.rotate(hand)));
                let elbow = self.elbow(hand.norm());
                for (third, is_elbow) in elbow.turns.into_iter().zip(elbow.exists) {
                    let second = self.upper_arm(hand, third);
                    let fourth = second.times(third).conj().times(all);
                    let (third, fourth) = (self.signed(0, third), self.signed(1, fourth));
                    let Some(branch) = rest.next() else { return };
                    *branch = Branch {
                        turns: [first, second, third, fourth, fifth, sixth],
                        exists: exists & is_elbow & is_wrist,
                        blur: shoulder.blur,
                        singular: [shoulder.is_singular, elbow.is_singular, wrist.is_singular],
                    };
                }
            }
        }
    }

    /// The first angle, whose turn back brings the centre to its height along the second axis.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn shoulder(&self, way: [L; 3]) -> Fork<L> {
        let axis = self.axis(0);
        let (tilt, height) = (self.number(self.geometry.tilt), self.number(self.geometry.height));
        let along = tilt * vector::dot(axis, way);
        let base = Complex {
            re: vector::dot(self.normal, way) - along,
            im: vector::dot(axis, vector::cross(self.normal, way)),
        };
        let (radius, height) = (base.norm(), height - along);
        let gap = radius - height.abs();
        let [slack, merge, _, part] = self.slack;
        let root = positive(gap * (radius + height.abs())).sqrt();
        let is_free = radius.le(slack);
        // Where the centre is on the axis, both heights are zero.
        let is_double = gap.le(merge) | is_free;
        let size = self.number(self.geometry.size);
        let mut fork = Fork::new(base, [height, root], (-slack).le(gap), is_double, [part, size]);
        fork.turns[0] = Complex::select(is_free, self.start[0], fork.turns[0]);
        fork
    }

    /// The turn of the lower arm against the upper one, by the distance of the end (Heron).
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn elbow(&self, distance: L) -> Fork<L> {
        let [shortest, longest] = self.geometry.spans;
        let [shortest, longest] = [self.number(shortest), self.number(longest)];
        let (inner, outer) = (distance - shortest, longest - distance);
        let [slack, merge, _, part] = self.slack;
        let (inner_too, outer_too) = (distance + shortest, longest + distance);
        let cosine = inner.mul_add(inner_too, -(outer * outer_too)) * distance.constant(0.5);
        let mut root = positive(inner * inner_too * (outer * outer_too)).sqrt();
        let mut is_double = inner.le(merge) | outer.le(merge);
        if self.geometry.crosses {
            // The direction of the end is asked for afterwards, and the root of a rounding leads it
            // astray.
            is_double = inner.le(slack) | outer.le(slack);
            root = L::select(is_double, root.constant(0.0), root);
        }
        let exists = (-slack).le(inner) & (-slack).le(outer);
        let base = Complex::splat(self.level, self.geometry.between);
        let size = self.number(self.geometry.size);
        Fork::new(base, [cosine, root], exists, is_double, [part, size * size])
    }

    /// The second angle: where the upper arm is when the end is where it should be.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn upper_arm(&self, end: Complex<L>, third: Complex<L>) -> Complex<L> {
        let [upper, lower] = self.geometry.links;
        let (upper, lower) = (Complex::splat(self.level, upper), Complex::splat(self.level, lower));
        let turn = end.times(upper.plus(third.times(lower)).conj());
        let is_free = end.norm().le(self.slack[0]);
        Complex::select(is_free, self.start[1], Complex::unit(turn.re, turn.im))
    }

    /// The fifth angle, which brings the last axis to where it is to what it is turned against; and
    /// where that is along it, as far as the angles before tell: those of a nearly stretched elbow
    /// are off by much more than a roundoff, and where the axes are along each other but for that,
    /// the direction in which they are apart says nothing.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn wrist(&self, last: [L; 3], against: [L; 3], blur: L) -> (Fork<L>, L::Mask) {
        let before = self.vector(self.geometry.against);
        let one = blur.constant(1.0);
        // Half of what values may miss the target by at the most.
        let most = self.number(self.geometry.fit * L::Real::from(8.0));
        let slack = self.slack[2] * (one + blur);
        let slack = L::select(most.lt(slack), most, slack);
        let apart = Apart::new(last, against, [slack, self.slack[3]]);
        (apart.bend(before, self.axis(4), self.axis(5)), apart.is_along)
    }

    /// From the first axis to a point of the tool.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn way(&self, point: [L; 3]) -> [L; 3] {
        vector::sub(self.goal.transform_point(point), self.vector(self.geometry.base))
    }

    /// A direction in the plane of the elbow.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn directions(&self, first: Complex<L>, v: [L; 3]) -> Complex<L> {
        let v = first.conj().about(self.axis(0), v);
        Complex { re: vector::dot(self.across[0], v), im: vector::dot(self.across[1], v) }
    }

    /// A point there.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn in_plane(&self, first: Complex<L>, way: [L; 3]) -> Complex<L> {
        self.directions(first, way).plus(Complex::splat(self.level, self.geometry.origin))
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn signed(&self, which: usize, turn: Complex<L>) -> Complex<L> {
        let sign = self.geometry.signs.get(which).copied().unwrap_or(L::Real::ONE);
        Complex { re: turn.re, im: turn.im * self.number(sign) }
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn axis(&self, index: usize) -> [L; 3] {
        self.vector(self.geometry.axes.get(index).copied().unwrap_or_default())
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn vector(&self, vector: [L::Real; 3]) -> [L; 3] {
        vector::splat(self.level, vector)
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn number(&self, number: L::Real) -> L {
        L::splat(self.level, number)
    }
}
