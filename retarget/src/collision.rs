//! The boxes, spheres and cylinders that a robot's file gives for collisions. `dq8-robot` does not
//! read them, because they do not say where links are.

use dq8::scalar::vector::{add, scale, sub};
use dq8::{DualQuat, Quat};
use dq8_robot::urdf::Robot;
use roxmltree::{Document, Node};

type Vector = [f64; 3];

/// A shape on a link.
#[derive(Clone, Debug)]
pub(crate) struct Shape {
    pub(crate) link: usize,
    /// The pose of the shape on the link.
    pub(crate) pose: DualQuat<f64>,
    pub(crate) form: Form,
}

#[derive(Clone, Copy, Debug)]
pub(crate) enum Form {
    Box {
        half: Vector,
    },
    Sphere {
        radius: f64,
    },
    /// Along z.
    Cylinder {
        half: f64,
        radius: f64,
    },
}

/// The shapes of a file.
#[derive(Clone, Debug, Default)]
pub(crate) struct Shapes {
    pub(crate) all: Vec<Shape>,
    /// The links that have a shape which was not read.
    unread: Vec<usize>,
}

impl Shapes {
    /// Reads the shapes of a file. Meshes are not read, and an element that is not understood is
    /// left out, because a robot can be moved without shapes.
    pub(crate) fn read(urdf: &str, robot: &Robot) -> Self {
        let mut shapes = Self::default();
        let Ok(document) = Document::parse(urdf) else { return shapes };
        let links = document.root_element().children().filter(|child| child.has_tag_name("link"));
        for node in links {
            let Some(link) = node.attribute("name").and_then(|name| robot.link(name)) else {
                continue;
            };
            for collision in node.children().filter(|child| child.has_tag_name("collision")) {
                match Shape::read(link, collision) {
                    Some(shape) => shapes.all.push(shape),
                    None => shapes.unread.push(link),
                }
            }
        }
        shapes
    }

    /// Returns how many of the links that move have shapes. A link counts for all that is fixed to
    /// it.
    pub(crate) fn known(&self, robot: &Robot) -> KnownShapes {
        let moving = moving(robot);
        let count = |links: &mut dyn Iterator<Item = usize>| {
            let mut links: Vec<_> = links.map(|link| moving[link]).collect();
            links.sort_unstable();
            links.dedup();
            links.len()
        };
        let read = || self.all.iter().map(|shape| shape.link);
        let unread = || self.unread.iter().copied();
        KnownShapes { links: count(&mut read().chain(unread())), unread: count(&mut unread()) }
    }
}

/// Returns, for each link, the nearest link above it, or the link itself, that moves relative to
/// its parent.
pub(crate) fn moving(robot: &Robot) -> Vec<usize> {
    let mut moving = Vec::new();
    for (link, joint) in robot.joints().iter().enumerate() {
        let moves = joint.kind.values() > 0 || joint.mimic.is_some();
        moving.push(joint.parent.filter(|_| !moves).map_or(link, |parent| moving[parent]));
    }
    moving
}

/// The number of links of a robot that have collision shapes, and of those whose shapes are not all
/// known. Links that are fixed to another one are parts of it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct KnownShapes {
    /// The number of links that have collision shapes of any kind.
    pub links: usize,
    /// The number of those that have a shape which is not read: a mesh, or an element that is not
    /// understood.
    pub unread: usize,
}

impl Shape {
    fn read(link: usize, collision: Node<'_, '_>) -> Option<Self> {
        let three = |text: Option<&str>| -> Option<Vector> {
            let words: Option<Vec<f64>> =
                text?.split_whitespace().map(|word| word.parse().ok()).collect();
            words?.try_into().ok()
        };
        let origin = collision.children().find(|child| child.has_tag_name("origin"));
        // What is not there is zero; what cannot be read leaves the element out.
        let part = |name: &str| match origin.and_then(|origin| origin.attribute(name)) {
            Some(text) => three(Some(text)),
            None => Some([0.0; 3]),
        };
        let [roll, pitch, yaw] = part("rpy")?;
        let turn = Quat::from_rpy(roll, pitch, yaw);
        let pose = DualQuat::from_rotation_translation(turn, part("xyz")?);
        let geometry = collision.children().find(|child| child.has_tag_name("geometry"))?;
        let shape = geometry.children().find(Node::is_element)?;
        let number = |name: &str| shape.attribute(name)?.trim().parse::<f64>().ok();
        let form = match shape.tag_name().name() {
            "box" => Form::Box { half: scale(three(shape.attribute("size"))?, 0.5) },
            "sphere" => Form::Sphere { radius: number("radius")? },
            "cylinder" => {
                Form::Cylinder { half: 0.5 * number("length")?, radius: number("radius")? }
            }
            _ => return None,
        };
        let sizes = match form {
            Form::Box { half } => half,
            Form::Sphere { radius } => [radius; 3],
            Form::Cylinder { half, radius } => [half, radius, radius],
        };
        let is_size = |size: f64| size > 0.0 && size.is_finite();
        let finite = pose.to_array().iter().all(|number| number.is_finite());
        (finite && sizes.into_iter().all(is_size)).then_some(Self { link, pose, form })
    }

    /// Returns points of the link, and a radius around each, whose hull is the shape. They tell
    /// where the shape touches the ground.
    pub(crate) fn corners(&self) -> (Vec<Vector>, f64) {
        let at = |point: Vector| self.pose.transform_point(point);
        match self.form {
            Form::Sphere { radius } => (vec![at([0.0; 3])], radius),
            Form::Box { half: [a, b, c] } => {
                let signs = |index: u8, bit: u8| if index & (1 << bit) == 0 { -1.0 } else { 1.0 };
                let corner = |i: u8| at([a * signs(i, 0), b * signs(i, 1), c * signs(i, 2)]);
                ((0..8).map(corner).collect(), 0.0)
            }
            Form::Cylinder { half, radius } => {
                let rim = |i: u32| {
                    let (sin, cos) = (f64::from(i / 2) * core::f64::consts::FRAC_PI_4).sin_cos();
                    at([radius * cos, radius * sin, if i.is_multiple_of(2) { half } else { -half }])
                };
                ((0..16).map(rim).collect(), 0.0)
            }
        }
    }
}

/// The sole of a foot: points in the frame of the foot's link, each with a radius around it.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Sole {
    points: Vec<(Vector, f64)>,
}

impl Sole {
    /// Takes the sole of `foot` from the lowest points of the shapes that it carries rigidly, or
    /// from the origin of a link that is called sole. `poses` are those of the robot with all
    /// joints at zero, where it stands on its soles. `None` if there are neither.
    pub(crate) fn of(
        robot: &Robot,
        shapes: &[Shape],
        poses: &[DualQuat<f64>],
        foot: usize,
    ) -> Option<Self> {
        let onto = |link: usize| poses[foot].conjugate() * poses[link];
        let own = |link: usize| carried_rigidly(robot, foot, link);
        let names = robot.link_names().iter().enumerate();
        let mut named = names.filter(|(link, name)| own(*link) && name.contains("sole"));
        let shaped = shapes.iter().filter(|shape| own(shape.link)).flat_map(|shape| {
            let (points, radius) = shape.corners();
            let moved =
                points.into_iter().map(move |p| (onto(shape.link).transform_point(p), radius));
            moved.collect::<Vec<_>>()
        });
        let mut all: Vec<(Vector, f64)> = shaped.collect();
        all.extend(named.next().map(|(link, _)| (onto(link).translation(), 0.0)));
        let bottom = |(at, radius): &(Vector, f64)| height(poses[foot], *at) - radius;
        let lowest = all.iter().map(bottom).reduce(f64::min)?;
        // Points within a centimetre of the lowest touch the ground.
        all.retain(|point| bottom(point) < lowest + 0.01);
        Some(Self { points: all })
    }

    /// Makes a sole of one point so far below the foot's origin as the foot hangs with all joints
    /// at zero.
    pub(crate) fn below(pose: DualQuat<f64>, origin: Vector, depth: f64) -> Self {
        let down = pose.rotation().conjugate().rotate([0.0, 0.0, -depth]);
        Self { points: vec![(add(origin, down), 0.0)] }
    }

    /// Returns `true` if no edges of the sole are known.
    pub(crate) fn is_point(&self) -> bool {
        matches!(self.points[..], [(_, 0.0)])
    }

    /// Returns the height of the lowest point if the foot has this pose.
    pub(crate) fn lowest(&self, foot: DualQuat<f64>) -> f64 {
        let bottoms = self.points.iter().map(|&(point, radius)| height(foot, point) - radius);
        bottoms.fold(f64::INFINITY, f64::min)
    }

    /// Returns the corners of the sole, in order around it; `up` points up from a flat sole.
    pub(crate) fn outline(&self, up: Vector) -> Vec<Vector> {
        let flat = Quat::from_rotation_arc(up, [0.0, 0.0, 1.0]);
        let bottoms = self.points.iter().map(|&(at, radius)| sub(at, scale(up, radius)));
        let mut all: Vec<_> = bottoms.map(|bottom| (flat.rotate(bottom), bottom)).collect();
        all.sort_by(|([a, b, _], _), ([c, d, _], _)| a.total_cmp(c).then(b.total_cmp(d)));
        let mut corners = half_of_the_hull(all.iter());
        corners.extend(half_of_the_hull(all.iter().rev()));
        // A sole of one point has no halves.
        if corners.is_empty() {
            corners.extend(self.points.first().map(|&(at, radius)| sub(at, scale(up, radius))));
        }
        corners
    }

    /// Returns the place of the middle of the sole if the foot has this pose.
    pub(crate) fn middle(&self, foot: DualQuat<f64>) -> Vector {
        let sum = self.points.iter().fold([0.0; 3], |sum, &(point, _)| add(sum, point));
        foot.transform_point(scale(sum, 1.0 / self.points.len() as f64))
    }
}

/// Returns half of the hull of points as they are on the ground, each with what it comes from: from
/// the first point, with all others to the left, to the last one, which begins the other half.
fn half_of_the_hull<'p>(points: impl Iterator<Item = &'p (Vector, Vector)>) -> Vec<Vector> {
    let mut hull: Vec<(Vector, Vector)> = Vec::new();
    for &point in points {
        while let [.., (a, _), (b, _)] = hull[..] {
            let c = point.0;
            // Square metres; edges of soles are longer than a millimetre.
            if (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) > 1e-9 {
                break;
            }
            hull.pop();
        }
        hull.push(point);
    }
    hull.pop();
    hull.into_iter().map(|(_, corner)| corner).collect()
}

fn height(pose: DualQuat<f64>, point: Vector) -> f64 {
    pose.transform_point(point)[2]
}

/// Returns `true` if `link` is `foot`, or hangs on it by fixed joints alone.
fn carried_rigidly(robot: &Robot, foot: usize, mut link: usize) -> bool {
    while link != foot {
        let joint = &robot.joints()[link];
        match joint.parent {
            Some(parent) if joint.kind.values() == 0 => link = parent,
            _ => return false,
        }
    }
    true
}

#[cfg(test)]
mod tests {
    use super::Sole;
    use dq8::DualQuat;

    #[test]
    fn each_point_of_a_sole_has_a_radius_of_its_own() {
        // The corner of a box, and a ball that ends as low.
        let sole = Sole { points: vec![([0.0, 0.0, -0.05], 0.0), ([0.0, 0.0, -0.03], 0.02)] };
        assert_eq!(sole.lowest(DualQuat::IDENTITY), -0.05);
    }

    #[test]
    fn the_outline_of_a_sole_goes_around_it_and_leaves_out_what_is_inside() {
        let square = [[1.0, 1.0], [-1.0, -1.0], [0.0, 0.3], [1.0, -1.0], [0.0, -1.0], [-1.0, 1.0]];
        let points = square.map(|[x, y]| ([0.1 * x, 0.1 * y, -0.02], 0.01)).to_vec();
        let outline = Sole { points }.outline([0.0, 0.0, 1.0]);
        let around = [[-0.1, -0.1], [0.1, -0.1], [0.1, 0.1], [-0.1, 0.1]];
        assert_eq!(outline, around.map(|[x, y]| [x, y, -0.03]));
        let line = [0.0, 0.1, 0.2].map(|x| ([x, 0.0, 0.0], 0.0)).to_vec();
        assert_eq!(Sole { points: line }.outline([0.0, 0.0, 1.0]), [[0.0; 3], [0.2, 0.0, 0.0]]);
        let point = Sole { points: vec![([0.0, 0.0, 0.5], 0.5)] };
        assert_eq!(point.outline([0.0, 0.0, 1.0]), [[0.0; 3]]);
    }
}
