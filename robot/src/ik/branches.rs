//! All solutions of an arm of one of the two families, up to eight in each lane. Names of points
//! and links are those of the drawing in `family.rs`.
//!
//! All axes and points are those of the arm whose values are all zero. A pose of the arm is then
//! the product of six turns eᵢ, one about each axis, and of the pose with all values zero
//! (Brockett 1984). So the product of the turns follows from the target. The angles are found one
//! after the other, from quantities that a turn about a given axis does not change (Paden and
//! Kahan; Elias and Wen, *IK-Geo*, 2022):
//!
//! ```text
//! spherical wrist
//!     for each of 2 shoulders          so that the wrist is at its height
//!         for each of 2 elbows         so that it is at its distance from axis 2
//!             the upper arm            so that it is at its place
//!             for each of 2 wrists     so that axis 6 has its angle to axis 4
//!                 axis 4, axis 6       the rest of the rotation
//!
//! three parallel axes
//!     for each of 2 shoulders          so that the wrist is at its height
//!         for each of 2 wrists         so that axis 6 has its angle to axis 2
//!             axis 6                   so that axis 2 has its direction
//!             for each of 2 elbows     so that axis 4 is at its distance from axis 2
//!                 the upper arm        so that axis 4 is at its place
//!                 axis 4               the rest of the rotation
//! ```
//!
//! Each equation for an angle has two solutions, one or none, or any angle solves it. The last
//! angle of each group is computed from the rounded angles before it, so it makes up for their
//! rounding, and no solution needs to be improved afterwards.
//!
//! Each angle θ is kept as the complex number e^{iθ}, one in each lane. So angles are added by
//! multiplications, and only the final values need an arctangent.

use super::family::{Family, Geometry};
use dq8::batch::{DualQuat, atan2, vector};
use dq8::{Real, Scalar};
use dq8_simd::{Float, Lanes};

/// A target counts as reachable if it is beyond the reach of the arm by at most this number of
/// units. A unit is the roundoff times the arm's size, and the rounding error of a computed pose is
/// about ten units.
const REACH_SLACK: f64 = 64.0;
/// Two solutions count as one if the target is within this distance of the edge of the reach, in
/// units of the roundoff times the arm's size.
const MERGE_SLACK: f64 = 16.0;
/// Two axes count as parallel if the sine of the angle between them is at most this, in units of
/// roundoff.
const PARALLEL_SLACK: f64 = 32.0;
/// Two solutions count as singular if the square of half the angle between them is at most this, in
/// units of roundoff.
const SINGULAR_SLACK: f64 = 4096.0;

/// The four constants above, such as [`REACH_SLACK`], multiplied by their units and copied to all
/// lanes of a register. `reach` and `merge` are lengths.
#[derive(Clone, Copy)]
struct Slack<L> {
    reach: L,
    merge: L,
    parallel: L,
    singular: L,
}

/// One of the eight solutions of the arm. Each lane holds this solution for its own target.
#[derive(Clone, Copy, Debug)]
pub(super) struct Branch<L: Lanes> {
    /// The six angles, as complex numbers of any absolute value.
    pub(super) turns: [Complex<L>; 6],
    /// The lanes in which this solution exists.
    pub(super) exists: L::Mask,
    /// The rounding error of the angles that are found before the angles of the wrist, in units of
    /// the roundoff of their inputs.
    error_gain: L,
    /// The lanes in which this solution coincides with another solution or is one of infinitely
    /// many, because of the shoulder (element 0), the elbow (1) or the wrist (2).
    pub(super) singular: [L::Mask; 3],
}

impl<L: Lanes> Branch<L> {
    /// Returns the rounding error of this branch's angles, at most `most`. `rounding` is the
    /// rounding error of an angle in branches whose `error_gain` is zero.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn rounding(&self, rounding: L, most: L) -> L {
        let rounding = rounding * (most.constant(1.0) + self.error_gain);
        L::select(most.lt(rounding), most, rounding)
    }
}

/// An arm, and a target in each lane.
pub(super) struct Arm<'s, L: Lanes> {
    level: L::Level,
    geometry: &'s Geometry<L::Real>,
    /// The product of the six turns whose angles are sought.
    product: DualQuat<L>,
    /// The angles of the start that the caller gave. If any angle solves an equation, the solution
    /// takes the angle of the start.
    start: [Complex<L>; 6],
    slack: Slack<L>,
    /// The direction of the second axis.
    normal: [L; 3],
    /// Two directions at right angles to the second axis, which span the plane of the elbow.
    plane: [[L; 3]; 2],
}

impl<'s, L: Lanes<Real: Scalar>> Arm<'s, L> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn new(
        level: L::Level,
        geometry: &'s Geometry<L::Real>,
        target: DualQuat<L>,
        start: [Complex<L>; 6],
    ) -> Self {
        let home_inverse = vector::splat(level, geometry.home_inverse.to_array());
        let (epsilon, zero) = (vector::epsilon::<L>(), start[0].re.constant(0.0));
        let (size, [right, up]) = (L::splat(level, geometry.size), geometry.plane);
        let slack = Slack {
            reach: size * zero.constant(REACH_SLACK * epsilon),
            merge: size * zero.constant(MERGE_SLACK * epsilon),
            parallel: zero.constant(PARALLEL_SLACK * epsilon),
            singular: zero.constant(SINGULAR_SLACK * epsilon),
        };
        Self {
            level,
            geometry,
            product: target * DualQuat::from_array(home_inverse),
            start,
            slack,
            normal: vector::splat(level, geometry.axes[1]),
            plane: [vector::splat(level, right), vector::splat(level, up)],
        }
    }

    /// Returns a branch that exists in no lane, to be overwritten.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn empty(&self) -> Branch<L> {
        let zero = self.slack.reach;
        let never = zero.lt(zero);
        let turn = Complex { re: zero, im: zero };
        Branch { turns: [turn; 6], exists: never, error_gain: zero, singular: [never; 3] }
    }

    /// Returns all solutions, without regard to the limits of the joints.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn solve(&self) -> [Branch<L>; 8] {
        let mut branches = [self.empty(); 8];
        match self.geometry.family {
            Family::SphericalWrist => self.spherical_wrist(&mut branches),
            Family::ThreeParallel => self.three_parallel(&mut branches),
            Family::Other => {}
        }
        branches
    }

    /// Solves an arm with a spherical wrist. The wrist stays in place when the last three axes
    /// turn, so the first three axes bring it into place, and the last three turn the tool.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn spherical_wrist(&self, branches: &mut [Branch<L>; 8]) {
        let last = self.product.transform_vector(self.axis(5));
        let [across, across_too] = self.geometry.across_last;
        let [across, across_too] = [self.vector(across), self.vector(across_too)];
        let turned = self.product.transform_vector(across);
        let (mut places, mut rest) = ([self.empty(); 4], branches.iter_mut());
        if self.geometry.crosses {
            self.crossing_shoulder(&mut places);
        } else {
            self.parallel_elbow(&mut places);
        }
        for Branch { mut turns, exists, error_gain, mut singular } in places {
            let (mut last, mut turned) = (last, turned);
            for (index, turn) in turns.into_iter().enumerate().take(3) {
                let (axis, back) = (self.axis(index), turn.conj());
                (last, turned) = (back.about(axis, last), back.about(axis, turned));
            }
            let (wrist, is_free) =
                self.wrist(last, self.vector(self.geometry.wrist_reference), error_gain);
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
                *branch = Branch { turns, exists: exists & is_wrist, error_gain, singular };
            }
        }
    }

    /// Finds the first three angles, which put the wrist into place, for an arm whose second and
    /// third axis are parallel: the shoulder, and two links in a plane.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn parallel_elbow(&self, places: &mut [Branch<L>; 4]) {
        let to_wrist = self.relative_to_base(self.vector(self.geometry.wrist));
        let shoulder = self.shoulder(to_wrist);
        let mut rest = places.iter_mut();
        for (first, exists) in shoulder.turns.into_iter().zip(shoulder.exists) {
            let end = self.in_plane(first, to_wrist);
            let elbow = self.elbow(end.norm());
            for (third, is_elbow) in elbow.turns.into_iter().zip(elbow.exists) {
                let Some(place) = rest.next() else { return };
                place.turns[0] = first;
                place.turns[1] = self.upper_arm(end, third);
                place.turns[2] = self.signed(0, third);
                place.exists = exists & is_elbow;
                place.error_gain = shoulder.error_gain + elbow.error_gain;
                (place.singular[0], place.singular[1]) = (shoulder.is_singular, elbow.is_singular);
            }
        }
    }

    /// Finds the first three angles, which put the wrist into place, if the first two axes
    /// intersect. The angle of the elbow sets the distance of the wrist from the intersection, then
    /// the first two angles set its direction from there.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn crossing_shoulder(&self, places: &mut [Branch<L>; 4]) {
        let to_wrist = self.relative_to_base(self.vector(self.geometry.wrist));
        let [upper, lower] =
            [self.vector(self.geometry.upper_arm), self.vector(self.geometry.lower_arm)];
        let distance = vector::dot(to_wrist, to_wrist).sqrt();
        let elbow = self.elbow(distance);
        let one = distance.constant(1.0);
        let direction = vector::scale(to_wrist, one / distance);
        // If the wrist is at the intersection of the first two axes, they do not move it, so their
        // angles are free.
        let is_free = distance.le(self.slack.reach);
        let mut rest = places.iter_mut();
        for (third, exists) in elbow.turns.into_iter().zip(elbow.exists) {
            let end = vector::add(upper, third.about(self.axis(2), lower));
            let end = vector::scale(end, one / vector::dot(end, end).sqrt());
            let separation = Separation::new(
                direction,
                self.axis(0),
                [self.slack.parallel, self.slack.singular],
            );
            let shoulder = separation.turns_about(self.axis(0), self.axis(1), end);
            for (second, is_shoulder) in shoulder.turns.into_iter().zip(shoulder.exists) {
                let first = Complex::onto(self.axis(0), second.about(self.axis(1), end), direction);
                let Some(place) = rest.next() else { return };
                place.turns[0] =
                    Complex::select(separation.is_along | is_free, self.start[0], first);
                place.turns[1] = Complex::select(is_free, self.start[1], second);
                place.turns[2] = third;
                place.exists = exists & (is_shoulder | is_free);
                place.error_gain = shoulder.error_gain + elbow.error_gain;
                (place.singular[0], place.singular[1]) = (shoulder.is_singular, elbow.is_singular);
            }
        }
    }

    /// Solves an arm with three parallel axes. Turns about these axes change neither the height of
    /// a point along them nor the angle between a direction and them. These two invariants give the
    /// other three angles. Then the two links and the hand move in a plane.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn three_parallel(&self, branches: &mut [Branch<L>; 8]) {
        let to_wrist = self.relative_to_base(self.vector(self.geometry.wrist));
        let shoulder = self.shoulder(to_wrist);
        let last = self.product.transform_vector(self.axis(5));
        let rotation = self.product.rotation();
        let hand = self.vector(self.geometry.hand);
        let mut rest = branches.iter_mut();
        for (first, exists) in shoulder.turns.into_iter().zip(shoulder.exists) {
            let normal = first.about(self.axis(0), self.normal);
            let (wrist, is_free) = self.wrist(last, normal, shoulder.error_gain);
            let normal = rotation.conjugate().rotate(normal);
            for (fifth, is_wrist) in wrist.turns.into_iter().zip(wrist.exists) {
                let back = fifth.conj();
                let swung = back.about(self.axis(4), self.normal);
                let sixth = Complex::onto(self.axis(5), normal, swung);
                let sixth = Complex::select(is_free, self.start[5], sixth);
                let hand = sixth.conj().about(self.axis(5), back.about(self.axis(4), hand));
                let along = back.about(self.axis(4), self.plane[0]);
                let along = rotation.rotate(sixth.conj().about(self.axis(5), along));
                let all = self.directions(first, along);
                let all = Complex::unit(all.re, all.im);
                let hand = self.in_plane(first, vector::add(to_wrist, rotation.rotate(hand)));
                let elbow = self.elbow(hand.norm());
                for (third, is_elbow) in elbow.turns.into_iter().zip(elbow.exists) {
                    let second = self.upper_arm(hand, third);
                    let fourth = second.times(third).conj().times(all);
                    let (third, fourth) = (self.signed(0, third), self.signed(1, fourth));
                    let Some(branch) = rest.next() else { return };
                    *branch = Branch {
                        turns: [first, second, third, fourth, fifth, sixth],
                        exists: exists & is_elbow & is_wrist,
                        error_gain: shoulder.error_gain,
                        singular: [shoulder.is_singular, elbow.is_singular, wrist.is_singular],
                    };
                }
            }
        }
    }

    /// Returns the two solutions for the first angle. If the target is turned back about the first
    /// axis by either solution, its wrist is at the height of the arm's wrist along the second
    /// axis.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn shoulder(&self, to_wrist: [L; 3]) -> Fork<L> {
        let axis = self.axis(0);
        let (tilt, height) = (self.number(self.geometry.tilt), self.number(self.geometry.height));
        let along = tilt * vector::dot(axis, to_wrist);
        let base = Complex {
            re: vector::dot(self.normal, to_wrist) - along,
            im: vector::dot(axis, vector::cross(self.normal, to_wrist)),
        };
        let (radius, height) = (base.norm(), height - along);
        let gap = radius - height.abs();
        let Slack { reach, merge, singular, .. } = self.slack;
        let root = positive(gap * (radius + height.abs())).sqrt();
        let is_free = radius.le(reach);
        // If the wrist is on the first axis, any angle solves the equation, so one solution is
        // kept.
        let is_double = gap.le(merge) | is_free;
        let size = self.number(self.geometry.size);
        let mut fork =
            Fork::new(base, [height, root], (-reach).le(gap), is_double, [singular, size]);
        fork.turns[0] = Complex::select(is_free, self.start[0], fork.turns[0]);
        fork
    }

    /// Returns the two solutions for the angle of the elbow. They put the end of the lower arm at
    /// `distance` from the second axis, or from the intersection of the first two axes (Heron's
    /// formula).
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn elbow(&self, distance: L) -> Fork<L> {
        let [shortest, longest] = self.geometry.elbow_reach;
        let [shortest, longest] = [self.number(shortest), self.number(longest)];
        let (inner, outer) = (distance - shortest, longest - distance);
        let Slack { reach, merge, singular, .. } = self.slack;
        let (inner_too, outer_too) = (distance + shortest, longest + distance);
        let cosine = inner.mul_add(inner_too, -(outer * outer_too)) * distance.constant(0.5);
        let mut root = positive(inner * inner_too * (outer * outer_too)).sqrt();
        let mut is_double = inner.le(merge) | outer.le(merge);
        if self.geometry.crosses {
            // At the edge of the reach the root is set to zero. A computed root would be the square
            // root of a rounding error, which is large enough to turn the end of the arm in a wrong
            // direction.
            is_double = inner.le(reach) | outer.le(reach);
            root = L::select(is_double, root.constant(0.0), root);
        }
        let exists = (-reach).le(inner) & (-reach).le(outer);
        let base = Complex::splat(self.level, self.geometry.elbow_at_zero);
        let size = self.number(self.geometry.size);
        Fork::new(base, [cosine, root], exists, is_double, [singular, size * size])
    }

    /// Returns the second angle, which brings the end of the arm to its place.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn upper_arm(&self, end: Complex<L>, third: Complex<L>) -> Complex<L> {
        let [upper, lower] = self.geometry.links_in_plane;
        let (upper, lower) = (Complex::splat(self.level, upper), Complex::splat(self.level, lower));
        let turn = end.times(upper.plus(third.times(lower)).conj());
        let is_free = end.norm().le(self.slack.reach);
        Complex::select(is_free, self.start[1], Complex::unit(turn.re, turn.im))
    }

    /// Returns the two solutions for the fifth angle, and the lanes in which `last` and `against`
    /// are parallel. At the fifth angle, the angle between the last axis and the wrist reference
    /// equals the angle between `last` and `against`. The tolerance within which axes count as
    /// parallel grows with the error of the earlier angles, `error_gain`. A nearly stretched elbow
    /// amplifies rounding, so axes that are parallel may be computed as different directions.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn wrist(&self, last: [L; 3], against: [L; 3], error_gain: L) -> (Fork<L>, L::Mask) {
        let before = self.vector(self.geometry.wrist_reference);
        let one = error_gain.constant(1.0);
        // A solution may have an error of 16 tolerances (`SixAxisArm::tolerance`). This is half of
        // it.
        let most = self.number(self.geometry.tolerance * L::Real::from(8.0));
        let slack = self.slack.parallel * (one + error_gain);
        let slack = L::select(most.lt(slack), most, slack);
        let separation = Separation::new(last, against, [slack, self.slack.singular]);
        (separation.turns_about(before, self.axis(4), self.axis(5)), separation.is_along)
    }

    /// Returns the vector from the base to a point of the tool at its target. `point` is its
    /// position where all values are zero.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn relative_to_base(&self, point: [L; 3]) -> [L; 3] {
        vector::sub(self.product.transform_point(point), self.vector(self.geometry.base))
    }

    /// Turns a direction back by the first angle, and returns its components in the plane of the
    /// elbow.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn directions(&self, first: Complex<L>, v: [L; 3]) -> Complex<L> {
        let v = first.conj().about(self.axis(0), v);
        Complex { re: vector::dot(self.plane[0], v), im: vector::dot(self.plane[1], v) }
    }

    /// Turns a point back by the first angle, and returns its components in the plane of the elbow.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn in_plane(&self, first: Complex<L>, way: [L; 3]) -> Complex<L> {
        self.directions(first, way).plus(Complex::splat(self.level, self.geometry.base_in_plane))
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

/// An angle θ as the complex number e^{iθ}, or a point in a plane.
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

    /// Returns the complex number of length 1 in the direction of re + i·im; NaN at zero.
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

    /// Turns a vector about a unit axis by this angle (Rodrigues).
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn about(self, axis: [L; 3], v: [L; 3]) -> [L; 3] {
        let along = (v[0].constant(1.0) - self.re) * vector::dot(axis, v);
        let turned = vector::scale_onto(vector::cross(axis, v), self.im, vector::scale(v, self.re));
        vector::scale_onto(axis, along, turned)
    }

    /// Returns the turn about a unit axis that brings `v` onto `w`, or as near to `w` as possible.
    /// It is NaN if `v` or `w` is parallel to the axis.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn onto(axis: [L; 3], v: [L; 3], w: [L; 3]) -> Self {
        // Only the parts of `v` and `w` at right angles to the axis matter. If they are small,
        // products of the whole vectors would lose them by rounding.
        let (v, w) = (vector::cross(axis, v), vector::cross(axis, w));
        Self::unit(vector::dot(v, w), vector::dot(axis, vector::cross(v, w)))
    }
}

/// The two solutions of an equation in one angle. If they coincide, only the first one exists.
#[derive(Clone, Copy, Debug)]
pub(super) struct Fork<L: Lanes> {
    /// The two angles, as complex numbers of absolute value 1.
    pub(super) turns: [Complex<L>; 2],
    /// The lanes in which each of the two angles is a solution.
    pub(super) exists: [L::Mask; 2],
    /// The lanes in which the two solutions are equal or nearly equal.
    pub(super) is_singular: L::Mask,
    /// The rounding error of an angle, in units of the roundoff of its inputs. It is large where
    /// the two solutions nearly coincide.
    pub(super) error_gain: L,
}

impl<L: Lanes> Fork<L> {
    /// Returns the two solutions, which are the angles of the complex numbers base·(re ± i·im).
    /// The absolute values of these numbers do not matter. The solutions are singular if im² is at
    /// most `part` of re² + im². `size` is the magnitude that determines the rounding error of
    /// `re`.
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
        // Where the two solutions coincide, the error of the angle is the square root of a
        // roundoff.
        let least = size * size.constant(root_of_epsilon::<L>());
        let error_gain = size / L::select(im.lt(least), least, im);
        Self { turns, exists: [exists, exists & !is_double], is_singular, error_gain }
    }
}

/// Returns the square root of the distance from 1 to the next larger float, rounded up to a power
/// of two.
fn root_of_epsilon<L: Lanes>() -> f64 {
    if L::Real::SINGLE { 1.0 / 2048.0 } else { 1.0 / 67_108_864.0 }
}

/// The angle between two unit vectors, as its cosine, its sine and the square of its sine.
#[derive(Clone, Copy, Debug)]
pub(super) struct Separation<L: Lanes> {
    cosine: L,
    sine: L,
    square: L,
    slack: [L; 2],
    pub(super) is_along: L::Mask,
}

impl<L: Lanes> Separation<L> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn new(v: [L; 3], w: [L; 3], slack: [L; 2]) -> Self {
        let across = vector::cross(v, w);
        let square = vector::dot(across, across);
        let sine = square.sqrt();
        Self { cosine: vector::dot(v, w), sine, square, slack, is_along: sine.le(slack[0]) }
    }

    /// Returns the turns about `axis` after which the angle between `v` and `to` is `self`
    /// (subproblem 4 of IK-Geo, a circle and a plane). `axis`, `v` and `to` are unit vectors.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn turns_about(&self, to: [L; 3], axis: [L; 3], v: [L; 3]) -> Fork<L> {
        let Self { cosine, sine, square, slack: [slack, part], .. } = *self;
        let (one, other) = (vector::dot(to, axis), vector::dot(axis, v));
        let both = one * other;
        let base =
            Complex { re: vector::dot(to, v) - both, im: vector::dot(to, vector::cross(axis, v)) };
        // `left` is 1 − cos² − a² − b² + 2ab cos, where a and b are the cosines of the
        // angles of `to` and `v` with the axis. This form keeps its digits if the sine is small and
        // a and b are nearly equal.
        let is_back = cosine.lt(sine.constant(0.0));
        let (away, other) = (both + both, L::select(is_back, -other, other));
        let away = L::select(is_back, -away, away) * square / (sine.constant(1.0) + cosine.abs());
        let differ = one - other;
        let left = differ.neg_mul_add(differ, square) - away;
        let least = L::select(sine.lt(slack), slack, sine) * slack;
        // For parallel axes the root is set to zero. A computed root would be the square root of a
        // rounding error.
        let root = L::select(self.is_along, sine.constant(0.0), positive(left).sqrt());
        let parts = [cosine - both, root];
        Fork::new(base, parts, (-least).le(left), left.le(least), [part, sine.constant(1.0)])
    }
}

/// Returns the value, or zero if it is negative.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn positive<L: Lanes>(number: L) -> L {
    let zero = number.constant(0.0);
    L::select(number.lt(zero), zero, number)
}
