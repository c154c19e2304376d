//! One configuration of floats by the [plan](super::plan): what `f32` and `f64` compute instead of
//! the products of the book. A frame is kept nowhere: what branches off is turned back from the
//! pose that has been written.

use super::factor::Factor;
use super::frame::Frame;
use super::joint::JointKind;
use super::step::{NONE, Step};
use super::tree::Mechanism;
use super::turned::{Turned, load, splat};
use super::turns::Turns;
use core::ops::Range;
use dq8::Real;
use dq8::geometry::Twist;
use dq8::scalar::{DualQuat, vector};
use dq8::seams::{Number, Quick};
use dq8_simd::Lanes;

/// The steps from the base to a link.
#[inline(always)]
fn way<'s, R: Copy>(
    mechanism: &Mechanism<'s, R>,
    link: usize,
) -> impl Iterator<Item = &'s Step<R>> {
    let end = mechanism.steps.get(link).map_or(NONE, |step| step.position) as usize;
    // No steps, if there is no such link: the base.
    let steps = mechanism.steps.get(..=end).unwrap_or_default().iter().enumerate();
    // What a step carries follows it.
    steps.filter(move |(position, step)| end - position < step.size as usize).map(|(_, step)| step)
}

/// What a [`Mechanism`] asks of floats, by name: where a number is any `Real`, a function over
/// [`Number`] cannot be named, but what it is to be called with can.
macro_rules! quick {
    ($($name:ident { $($field:ident: $type:ty),+ } -> $output:ty;)*) => {$(
        pub(crate) struct $name<'s, R> {
            pub(crate) mechanism: &'s Mechanism<'s, R>,
            pub(crate) values: &'s [R],
            $(pub(crate) $field: $type),+
        }

        impl<R: Real> Quick<R> for $name<'_, R> {
            type Output = $output;

            #[inline]
            fn compute(self) -> Option<$output>
            where
                R: Number,
            {
                Some(self.run())
            }
        }
    )*};
}
quick! {
    LinkPoses { poses: &'s mut [DualQuat<R>] } -> ();
    LinkPose { link: usize } -> DualQuat<R>;
    LinkJacobian { link: usize, frame: Frame, columns: &'s mut [Twist<R>] } -> DualQuat<R>;
    LinkPoints { points: &'s [Point<R>], places: &'s mut [[R; 3]] } -> ();
}

/// For any value: NaN where an angle is too far for lanes.
impl<R: Real + Number> LinkPoses<'_, R> {
    #[inline(always)]
    fn run(self) {
        let mut turns = Turns::new(self.values);
        turns.begin(self.mechanism.steps.first());
        let base = Turned::base();
        let (mut last, mut at) = (NONE, base);
        for step in self.mechanism.steps {
            // The children of a link but the first come after what the others carry.
            if step.parent != last {
                let link = step.parent as usize;
                at = match (self.poses.get(link), self.mechanism.step(link)) {
                    (Some(pose), Some(parent)) => Turned::of_pose(pose, &parent.planned.own),
                    _ => base,
                };
            }
            at = at.placed(step).joined(step, &mut turns);
            last = step.link;
            if let Some(slot) = self.poses.get_mut(step.link as usize) {
                *slot = at.pose(&step.planned.own);
            }
        }
    }
}

impl<R: Real + Number> LinkPose<'_, R> {
    #[inline(always)]
    fn run(self) -> DualQuat<R> {
        let mut turns = Turns::new(self.values);
        turns.begin(way(self.mechanism, self.link).next());
        let (mut at, mut own) = (Turned::base(), &Factor::ONE);
        for step in way(self.mechanism, self.link) {
            at = at.placed(step).joined(step, &mut turns);
            own = &step.planned.own;
        }
        at.pose(own)
    }
}

impl<R: Real + Number> LinkJacobian<'_, R> {
    #[inline(always)]
    fn run(self) -> DualQuat<R> {
        self.columns.fill(Twist::from_array([R::ZERO; 6]));
        let mut turns = Turns::new(self.values);
        turns.begin(way(self.mechanism, self.link).next());
        let (mut at, mut own) = (Turned::base(), &Factor::ONE);
        for step in way(self.mechanism, self.link) {
            let before = at.placed(step);
            at = before.joined(step, &mut turns);
            own = &step.planned.own;
            let columns = self.columns.get_mut(step.rate as usize..).unwrap_or_default();
            let frames = [before, at].map(|frame| DualQuat::from_array(frame.to_array()));
            for (index, column) in columns.iter_mut().take(step.kind.rates()).enumerate() {
                // What others mimic is moved by all of them.
                *column = *column + step.screw(index, frames, self.values);
            }
        }
        let pose = at.pose(own);
        let (back, origin) = (pose.conjugate(), pose.translation());
        for column in self.columns {
            // Of a joint that does not carry the link, wherever that is.
            if column.to_array() == [R::ZERO; 6] {
                continue;
            }
            match self.frame {
                Frame::World => break,
                Frame::Body => *column = back.adjoint(*column),
                Frame::WorldAligned => column.linear = column.velocity_at(origin),
            }
        }
        pose
    }
}

/// A link, and a point in its frame.
pub(crate) type Point<R> = (usize, [R; 3]);

/// Points, of which those of one link are looked for after the other.
#[derive(Clone, Copy)]
pub(crate) struct Found<'p, R> {
    pub(crate) points: &'p [Point<R>],
    in_order: bool,
    /// Where those of the next link are likely to begin.
    next: usize,
}

impl<'p, R> Found<'p, R> {
    pub(crate) fn new(points: &'p [Point<R>]) -> Self {
        let in_order = points.is_sorted_by(|(a, _), (b, _)| a <= b);
        Self { points, in_order, next: 0 }
    }

    /// Those of a link are among these.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn of(&mut self, link: usize) -> Range<usize> {
        if !self.in_order {
            return 0..self.points.len();
        }
        let is_of = |point: Option<&Point<R>>| matches!(point, Some((of, _)) if *of == link);
        let mut end = self.next;
        // `next` is where the points of the last link ended, so never in the middle of a link's
        // own.
        if !is_of(self.points.get(end)) {
            end = self.points.partition_point(|(of, _)| *of < link);
        }
        let start = end;
        while is_of(self.points.get(end)) {
            end += 1;
        }
        self.next = end;
        start..end
    }
}

impl<R: Real + Number> LinkPoints<'_, R> {
    #[inline(always)]
    fn run(self) {
        let mut turns = Turns::new(self.values);
        turns.begin(self.mechanism.steps.first());
        let mut found = Found::new(self.points);
        let (mut last, mut at) = (NONE, Turned::base());
        for step in self.mechanism.steps {
            if step.parent != last {
                // Again, from the base: there is no memory for frames, and few branch off far from
                // it.
                at = Turned::base();
                for step in way(self.mechanism, step.parent as usize) {
                    at = at.placed(step).joined(step, &mut turns);
                }
            }
            at = at.placed(step).joined(step, &mut turns);
            last = step.link;
            let some = found.of(step.link as usize);
            if some.is_empty() {
                continue;
            }
            let [a, b, c] = at.pose(&step.planned.own).to_matrix3x4();
            let column = |k: usize| load([a[k], b[k], c[k], R::ZERO]);
            let (across, origin) = ([column(0), column(1), column(2)], column(3));
            for index in some {
                if let (Some(&(link, [x, y, z])), Some(place)) =
                    (self.points.get(index), self.places.get_mut(index))
                    && link == step.link as usize
                {
                    let at = across[2] * splat(z) + origin;
                    let at = across[0] * splat(x) + (across[1] * splat(y) + at);
                    [place[0], place[1], place[2], _] = at.to_array();
                }
            }
        }
    }
}

impl<R: Real> Step<R> {
    /// The spatial twist of the link for a rate of one of the joint alone, number `index`, from the
    /// turned frames of the joint and of the link. Where a hinge is, is known also where its angle
    /// is too far.
    #[inline(always)]
    fn screw(&self, index: usize, [before, after]: [DualQuat<R>; 2], values: &[R]) -> Twist<R> {
        let (own, zero) = (self.planned.own.quaternion(), [R::ZERO; 3]);
        let axis = self.planned.axis.vector;
        let slide = |along| Twist { angular: zero, linear: along };
        let hinge = |angular, at| Twist { angular, linear: vector::cross(at, angular) };
        let screw = match self.kind {
            JointKind::Planar { .. } => {
                let directions = self.plane.map(|direction| own.rotate(direction));
                if let Some(&direction) = directions.get(index) {
                    slide(before.transform_vector(direction))
                } else {
                    let [x, y, _] = Self::numbers(self.value, values);
                    let [first, second] = directions;
                    let at = vector::add(vector::scale(first, x), vector::scale(second, y));
                    hinge(before.transform_vector(axis), before.transform_point(at))
                }
            }
            JointKind::Floating => {
                let mut unit = zero;
                unit[index % 3] = R::ONE;
                let axis = after.transform_vector(own.rotate(unit));
                if index < 3 { hinge(axis, after.translation()) } else { slide(axis) }
            }
            kind => {
                let axis = before.transform_vector(axis);
                match kind {
                    JointKind::Prismatic { .. } => slide(axis),
                    JointKind::Screw { pitch, .. } => {
                        let Twist { angular, linear } = hinge(axis, before.translation());
                        Twist { angular, linear: vector::add(linear, vector::scale(axis, pitch)) }
                    }
                    _ => hinge(axis, before.translation()),
                }
            }
        };
        if self.mimics { screw.scale(self.multiplier) } else { screw }
    }
}
