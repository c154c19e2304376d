//! [`Solid`]: a box, a sphere or a cylinder, and how deep two of them are in each other.
//!
//! The distance from a solid to a point is exact. A solid is as deep in another one as its deepest
//! segments are: the edges of a box, the lines on the side of a cylinder, and rows of balls inside
//! of both. So two solids take a number of steps that grows with the sum of their segments.

use crate::collision::Form;
use dq8::scalar::vector::{add, dot, scale, sub};

pub(crate) type Vector = [f32; 3];

/// The number of lines on the side of a cylinder.
const LINES: usize = 8;

/// The number of halvings that find the deepest point of a segment.
const HALVINGS: usize = 8;

/// Inside, the way out changes its direction over this distance between sides, because a jump from
/// frame to frame would be smoothed away. Metres.
const SOFT: f32 = 0.02;

/// A convex shape in its own frame.
#[derive(Clone, Debug)]
pub(crate) struct Solid {
    surface: Surface,
    segments: Vec<Segment>,
    /// The radius of the ball about its origin that holds it.
    pub(crate) reach: f32,
}

#[derive(Clone, Copy, Debug)]
enum Surface {
    Box { half: Vector },
    Sphere { radius: f32 },
    Cylinder { half: f32, radius: f32 },
}

/// A row of balls in a solid: their centres are on a segment.
#[derive(Clone, Copy, Debug)]
struct Segment {
    middle: Vector,
    half: Vector,
    radius: f32,
}

/// The place of a solid in a frame: its origin, and its axes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Frame {
    pub(crate) origin: Vector,
    pub(crate) axes: [Vector; 3],
}

impl Frame {
    /// Returns a vector of this frame in the frame outside.
    pub(crate) fn out(&self, [x, y, z]: Vector) -> Vector {
        let [a, b, c] = self.axes;
        core::array::from_fn(|i| x * a[i] + y * b[i] + z * c[i])
    }

    /// Returns a vector of the frame outside in this frame.
    fn own(&self, vector: Vector) -> Vector {
        self.axes.map(|axis| dot(axis, vector))
    }

    /// Returns where `other` is in this frame.
    fn see(&self, other: &Self) -> Self {
        let origin = self.own(sub(other.origin, self.origin));
        Self { origin, axes: other.axes.map(|axis| self.own(axis)) }
    }
}

impl Solid {
    pub(crate) fn new(form: Form) -> Self {
        let (surface, reach) = match form {
            Form::Box { half } => {
                let half = half.map(|half| half as f32);
                (Surface::Box { half }, length(half))
            }
            Form::Sphere { radius } => (Surface::Sphere { radius: radius as f32 }, radius as f32),
            Form::Cylinder { half, radius } => {
                let (half, radius) = (half as f32, radius as f32);
                (Surface::Cylinder { half, radius }, half.hypot(radius))
            }
        };
        Self { surface, segments: surface.segments(), reach }
    }

    pub(crate) fn is_sphere(&self) -> bool {
        matches!(self.surface, Surface::Sphere { .. })
    }

    /// Returns how deep two solids are in each other, and the unit vector that leads `other` out.
    /// Returns `None` if that is less than `least`.
    pub(crate) fn overlap(
        &self,
        at: &Frame,
        other: &Self,
        other_at: &Frame,
        least: f32,
    ) -> Option<(f32, Vector)> {
        let seen = at.see(other_at);
        if self.surface.distance(seen.origin).0 > other.reach - least {
            return None;
        }
        let seen_back = other_at.see(at);
        if other.surface.distance(seen_back.origin).0 > self.reach - least {
            return None;
        }
        let mut found = None;
        let mut least = least;
        for segment in &other.segments {
            if let Some((depth, way)) = self.surface.depth(segment.seen(&seen), least) {
                (least, found) = (depth, Some(at.out(way)));
            }
        }
        for segment in &self.segments {
            if let Some((depth, way)) = other.surface.depth(segment.seen(&seen_back), least) {
                (least, found) = (depth, Some(other_at.out(way).map(|part| -part)));
            }
        }
        Some((least, found?))
    }
}

impl Segment {
    fn seen(&self, frame: &Frame) -> Self {
        let middle = frame.out(self.middle);
        let middle = add(frame.origin, middle);
        Self { middle, half: frame.out(self.half), radius: self.radius }
    }
}

impl Surface {
    /// Returns the distance to a point, which is negative inside, and its gradient.
    fn distance(self, point: Vector) -> (f32, Vector) {
        let sign = |axis: usize, part: f32| part.copysign(point[axis]);
        match self {
            Self::Sphere { radius } => {
                let size = length(point);
                let way = if size > 0.0 { scale(point, 1.0 / size) } else { [1.0, 0.0, 0.0] };
                (size - radius, way)
            }
            Self::Box { half } => {
                let beyond: Vector = core::array::from_fn(|i| point[i].abs() - half[i]);
                let (distance, way) = to_corner(beyond);
                (distance, core::array::from_fn(|axis| sign(axis, way[axis])))
            }
            Self::Cylinder { half, radius } => {
                let across = point[0].hypot(point[1]);
                let (distance, [aside, along]) =
                    to_corner([across - radius, point[2].abs() - half]);
                let [x, y] =
                    if across > 0.0 { [point[0] / across, point[1] / across] } else { [1.0, 0.0] };
                (distance, [aside * x, aside * y, sign(2, along)])
            }
        }
    }

    /// Returns the depth of the deepest ball of a segment, and the unit vector that leads it out.
    /// Returns `None` if that is less than `least`.
    fn depth(self, segment: Segment, least: f32) -> Option<(f32, Vector)> {
        let Segment { middle, half, radius } = segment;
        let most = radius - least;
        let (mut distance, mut way) = self.distance(middle);
        // The distance changes at most by the length of the way.
        if distance - length(half) > most {
            return None;
        }
        let (mut best, mut out) = (distance, way);
        let (mut low, mut high, mut place) = (-1.0_f32, 1.0, 0.0);
        for _ in 0..HALVINGS {
            // The distance from a convex shape is convex along the segment, so the least one is on
            // the side to which it falls, and not below the tangent.
            let slope = dot(way, half);
            let left = if slope > 0.0 { place - low } else { high - place };
            if distance - slope.abs() * left > most.min(best - 1e-4) {
                break;
            }
            if slope > 0.0 {
                high = place
            } else {
                low = place
            };
            place = 0.5 * (low + high);
            (distance, way) = self.distance(add(middle, scale(half, place)));
            if distance < best {
                (best, out) = (distance, way);
            }
        }
        (best < most).then_some((radius - best, out))
    }

    /// Returns the segments that stand for a shape.
    fn segments(self) -> Vec<Segment> {
        let mut segments = Vec::new();
        match self {
            Self::Sphere { radius } => {
                segments.push(Segment { middle: [0.0; 3], half: [0.0; 3], radius });
            }
            Self::Box { half } => {
                let unit =
                    |axis: usize| core::array::from_fn(|i| if i == axis { 1.0 } else { 0.0 });
                for axis in 0..3 {
                    let [a, b] = [(axis + 1) % 3, (axis + 2) % 3];
                    for (s, t) in [(-1.0, -1.0), (-1.0, 1.0), (1.0, -1.0), (1.0, 1.0)] {
                        let corner = add(scale(unit(a), s * half[a]), scale(unit(b), t * half[b]));
                        let half = scale(unit(axis), half[axis]);
                        segments.push(Segment { middle: corner, half, radius: 0.0 });
                    }
                }
                let mut axes = [0, 1, 2];
                axes.sort_by(|&a, &b| half[a].total_cmp(&half[b]));
                let [thin, wide, long] = axes;
                let radius = half[thin];
                // Rows beside each other, at most three halves of a radius apart where a plate is
                // not so thin that there would be too many of them.
                let way = half[wide] - radius;
                let rows = (4.0 * way / (3.0 * radius)).ceil().clamp(0.0, 4.0) as u8;
                let along = scale(unit(long), half[long] - radius);
                for row in 0..=rows {
                    let share = 2.0 * f32::from(row) / f32::from(rows.max(1)) - 1.0;
                    let aside = if rows == 0 { 0.0 } else { share * way };
                    let middle = scale(unit(wide), aside);
                    segments.push(Segment { middle, half: along, radius });
                }
            }
            Self::Cylinder { half, radius } => {
                let around = |index: usize, size: f32| {
                    let angle = core::f32::consts::TAU * index as f32 / LINES as f32;
                    let (sin, cos) = angle.sin_cos();
                    [size * cos, size * sin, 0.0]
                };
                for line in 0..LINES {
                    let middle = around(line, radius);
                    segments.push(Segment { middle, half: [0.0, 0.0, half], radius: 0.0 });
                }
                let middle = [0.0; 3];
                if half >= radius {
                    segments.push(Segment { middle, half: [0.0, 0.0, half - radius], radius });
                } else {
                    // A disc has rows across it.
                    segments.extend((0..LINES / 2).map(|line| Segment {
                        middle,
                        half: around(line, radius - half),
                        radius: half,
                    }));
                }
            }
        }
        segments
    }
}

/// Returns the distance of a point to all that is negative in each part, and its gradient.
fn to_corner<const N: usize>(beyond: [f32; N]) -> (f32, [f32; N]) {
    let outside = beyond.map(|part| part.max(0.0));
    let size = outside.iter().map(|part| part * part).sum::<f32>().sqrt();
    if size > 0.0 {
        return (size, outside.map(|part| part / size));
    }
    let most = beyond.into_iter().fold(f32::NEG_INFINITY, f32::max);
    let parts = beyond.map(|part| (1.0 + (part - most) / SOFT).max(0.0));
    let size = parts.iter().map(|part| part * part).sum::<f32>().sqrt();
    (most, parts.map(|part| part / size))
}

/// Returns the length of a vector that is neither tiny nor huge.
fn length(a: Vector) -> f32 {
    dot(a, a).sqrt()
}

#[cfg(test)]
mod tests {
    use super::{Form, Frame, Solid, Vector, add, dot, length, scale, sub};
    use dq8::scalar::vector::cross;
    use dq8::{DualQuat, Quat};

    /// Numbers from 0 to 1 that look random.
    struct Random(u64);

    impl Random {
        fn next(&mut self) -> f64 {
            self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (self.0 >> 33) as f64 / (1_u64 << 31) as f64
        }

        fn between(&mut self, low: f64, high: f64) -> f64 {
            low + (high - low) * self.next()
        }

        fn form(&mut self) -> Form {
            let mut size = || self.between(0.02, 0.15);
            let (a, b, c) = (size(), size(), size());
            match self.next() {
                share if share < 0.5 => Form::Box { half: [a, b, c] },
                share if share < 0.85 => Form::Cylinder { half: a, radius: b },
                _ => Form::Sphere { radius: a },
            }
        }

        fn pose(&mut self, way: f64) -> DualQuat<f64> {
            let mut turn = || self.between(-1.0, 1.0);
            let turn = Quat::from_array([turn(), turn(), turn(), turn()]).normalize();
            let place = [0; 3].map(|_| self.between(-way, way));
            DualQuat::from_rotation_translation(turn, place)
        }
    }

    fn frame(pose: DualQuat<f64>) -> Frame {
        let axis = |vector| pose.transform_vector(vector).map(|part| part as f32);
        Frame {
            origin: pose.translation().map(|part| part as f32),
            axes: [axis([1.0, 0.0, 0.0]), axis([0.0, 1.0, 0.0]), axis([0.0, 0.0, 1.0])],
        }
    }

    /// Returns how far a shape reaches in a direction.
    fn extent(form: Form, at: &Frame, way: Vector) -> f32 {
        let [x, y, z] = at.axes.map(|axis| dot(axis, way));
        dot(at.origin, way)
            + match form {
                Form::Sphere { radius } => radius as f32,
                Form::Box { half: [a, b, c] } => {
                    x.abs() * a as f32 + y.abs() * b as f32 + z.abs() * c as f32
                }
                Form::Cylinder { half, radius } => {
                    z.abs() * half as f32 + x.hypot(y) * radius as f32
                }
            }
    }

    /// Returns the shortest way that leads the second shape out of the first one, by trying many
    /// directions. It is negative if they are apart.
    fn depth([(form, at), (other, other_at)]: [(Form, Frame); 2]) -> f32 {
        let way_out = |way: Vector| {
            let way = scale(way, 1.0 / length(way));
            extent(form, &at, way) + extent(other, &other_at, scale(way, -1.0))
        };
        let mut ways: Vec<Vector> = [at.axes, other_at.axes].concat();
        ways.extend(at.axes.iter().flat_map(|&a| other_at.axes.map(|b| cross(a, b))));
        ways.push(sub(other_at.origin, at.origin));
        ways.extend((0..600).map(|index| {
            let (z, turn) = ((index as f32 + 0.5) / 300.0 - 1.0, 2.399_963 * index as f32);
            let size = (1.0 - z * z).sqrt();
            [size * turn.cos(), size * turn.sin(), z]
        }));
        ways.retain(|&way| length(way) > 1e-3);
        let both: Vec<Vector> = ways.iter().flat_map(|&way| [way, scale(way, -1.0)]).collect();
        let mut found: Vec<_> = both.into_iter().map(|way| (way_out(way), way)).collect();
        found.sort_by(|a, b| a.0.total_cmp(&b.0));
        let refined = found.into_iter().take(5).map(|(mut least, way)| {
            let (mut way, mut step) = (scale(way, 1.0 / length(way)), 0.1_f32);
            while step > 1e-4 {
                let near = (0..6).map(|index| {
                    let sign = if index % 2 == 0 { step } else { -step };
                    add(way, core::array::from_fn(|i| if i == index / 2 { sign } else { 0.0 }))
                });
                let best = near.map(|way| (way_out(way), way)).min_by(|a, b| a.0.total_cmp(&b.0));
                match best {
                    Some((depth, better)) if depth < least => (least, way) = (depth, better),
                    _ => step *= 0.5,
                }
            }
            least
        });
        refined.fold(f32::INFINITY, f32::min)
    }

    #[test]
    fn overlaps_are_found_in_boxes_with_their_corners_and_cylinders_with_their_ends() {
        let mut random = Random(7);
        let (mut met, mut missed, mut short) = (0, 0.0_f32, 0.0_f32);
        for _ in 0..500 {
            let forms = [random.form(), random.form()];
            let frames = [random.pose(0.0), random.pose(0.15)].map(frame);
            let [solid, other] = forms.map(Solid::new);
            let real = depth([(forms[0], frames[0]), (forms[1], frames[1])]);
            let found = solid.overlap(&frames[0], &other, &frames[1], 0.0);
            let Some((found, way)) = found else {
                missed = missed.max(real);
                continue;
            };
            // It is never too deep, and so shapes that are apart never meet.
            assert!(found < real + 1e-4, "{found} of {real}: {forms:?}, {frames:?}");
            assert!((length(way) - 1.0).abs() < 1e-4);
            met += 1;
            if real < 0.05 {
                short = short.max(real - found);
            }
        }
        println!("{met} met, {missed} m missed, {short} m too shallow");
        assert!(met > 300 && missed < 0.005 && short < 0.02, "{met}, {missed}, {short}");
    }
}
