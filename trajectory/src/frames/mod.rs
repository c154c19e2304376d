//! [`Frames`]: where frames are in each other, as time goes on.

mod error;
mod lookup;

pub use error::FramesError;

use crate::Trajectory;
use crate::along::{SAMPLES, Samples};
use crate::job::Job;
use crate::segments::{Outside, Segments};
use crate::stretches::segments;
use alloc::borrow::ToOwned;
use alloc::collections::BTreeMap;
use alloc::string::String;
use alloc::vec::Vec;
use dq8::{Backend, DualQuat};

/// An edge of [`Frames`]: where a frame is in its parent.
#[derive(Clone, Copy, Debug)]
pub struct Edge<'a> {
    frame: &'a str,
    parent: &'a str,
    pose: Pose<'a>,
}

#[derive(Clone, Copy, Debug)]
enum Pose<'a> {
    Fixed(DualQuat<f64>),
    Moving(Trajectory<'a>),
}

impl<'a> Edge<'a> {
    /// A frame that does not move in its parent: `parent = pose.transform_point(frame)`.
    #[must_use]
    pub fn fixed(frame: &'a str, parent: &'a str, pose: DualQuat<f64>) -> Self {
        Self { frame, parent, pose: Pose::Fixed(pose) }
    }

    /// A frame that moves in its parent, into which the poses of the trajectory lead.
    #[must_use]
    pub fn moving(frame: &'a str, parent: &'a str, path: impl Into<Trajectory<'a>>) -> Self {
        Self { frame, parent, pose: Pose::Moving(path.into()) }
    }
}

/// A tree of frames with names, or several trees: each frame moves along a trajectory in its
/// parent, or is fixed there.
///
/// It answers the question of tf2's `lookupTransform(target, source, time)` for many times at once:
/// [`lookup`](Job::lookup). All that depends on the edges alone is computed when the tree is made;
/// a lookup allocates nothing.
///
/// ```
/// use dq8::{DualQuat, Quat};
/// use dq8_trajectory::{Edge, Frames, Trajectory};
/// // A car drives ten metres along x within a second. Its scanner is two metres above it and
/// // looks to the left.
/// let drive = [0.0, 10.0].map(|x| DualQuat::from_translation([x, 0.0, 0.0]));
/// let left = Quat::from_rotation_z(core::f64::consts::FRAC_PI_2);
/// let frames = Frames::new([
///     Edge::moving("car", "map", Trajectory::new(&[0.0, 1.0], &drive)?),
///     Edge::fixed("scanner", "car", DualQuat::from_rotation_translation(left, [0.0, 0.0, 2.0])),
///     Edge::fixed("tower", "map", DualQuat::from_translation([5.0, 5.0, 0.0])),
/// ])?;
/// // Where is the scanner, seen from the tower?
/// let mut poses = [DualQuat::<f32>::IDENTITY; 3];
/// frames.job().lookup("tower", "scanner", &[0.0, 0.25, 1.0], &mut poses)?;
/// assert_eq!(poses.map(|pose| pose.translation()[0]), [-5.0, -2.5, 5.0]);
/// let [x, y, z] = poses[1].transform_point([1.0, 0.0, 0.0]);
/// assert!((x + 2.5).abs() < 1e-6 && (y + 4.0).abs() < 1e-6 && (z - 2.0).abs() < 1e-6);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Frames {
    names: BTreeMap<String, usize>,
    nodes: Vec<Node>,
}

#[derive(Debug)]
struct Node {
    name: String,
    parent: Option<usize>,
    /// The number of its ancestors.
    depth: usize,
    motion: Motion,
}

#[derive(Debug)]
enum Motion {
    Fixed(DualQuat<f64>),
    Moving(Moving),
}

#[derive(Debug)]
struct Moving {
    /// They go on outside the stamps; a job whose frames stand there says so itself.
    segments: Segments<f64, SAMPLES>,
    range: [f64; 2],
}

impl Frames {
    /// The frames that the edges name, in any order.
    ///
    /// # Errors
    /// If two edges say where a frame is, a frame lies in itself, or a fixed pose is not finite.
    pub fn new<'a>(edges: impl IntoIterator<Item = Edge<'a>>) -> Result<Self, FramesError> {
        let mut frames = Self { names: BTreeMap::new(), nodes: Vec::new() };
        for Edge { frame, parent, pose } in edges {
            let motion = match pose {
                Pose::Fixed(pose) if !pose.to_array().iter().all(|number| number.is_finite()) => {
                    return Err(FramesError::NotFinite { frame: frame.to_owned() });
                }
                Pose::Fixed(pose) => Motion::Fixed(pose),
                Pose::Moving(path) => Motion::Moving(Moving::new(path)),
            };
            let parent = frames.insert(parent);
            let index = frames.insert(frame);
            let node = &mut frames.nodes[index];
            if node.parent.is_some() {
                return Err(FramesError::TwoParents { frame: frame.to_owned() });
            }
            (node.parent, node.motion) = (Some(parent), motion);
        }
        for index in 0..frames.nodes.len() {
            let depth = frames.ancestors(index).take(frames.nodes.len() + 1).count() - 1;
            if depth == frames.nodes.len() {
                return Err(FramesError::Loop { frame: frames.looped(index) });
            }
            frames.nodes[index].depth = depth;
        }
        Ok(frames)
    }

    /// The number of a frame, which is a root until an edge says where it is.
    fn insert(&mut self, name: &str) -> usize {
        if let Some(&index) = self.names.get(name) {
            return index;
        }
        let index = self.nodes.len();
        self.names.insert(name.to_owned(), index);
        let motion = Motion::Fixed(DualQuat::IDENTITY);
        self.nodes.push(Node { name: name.to_owned(), parent: None, depth: 0, motion });
        index
    }

    /// The name of a frame of the loop that the ancestors of a frame lead into.
    fn looped(&self, frame: usize) -> String {
        let inside = self.ancestors(frame).nth(self.nodes.len()).unwrap_or(frame);
        self.nodes[inside].name.clone()
    }

    /// A run over many times.
    pub fn job(&self) -> Job<&Self> {
        Job::new(self)
    }

    /// The first time and the last, in seconds, at which no edge between the frames is outside its
    /// stamps: infinite where none moves. The first is the later one if there is no such time.
    ///
    /// # Errors
    /// If there is no such frame, or no edges lead from one to the other.
    pub fn range(&self, target: &str, source: &str) -> Result<[f64; 2], FramesError> {
        let way = self.way(target, source)?;
        let all = [f64::NEG_INFINITY, f64::INFINITY];
        let both = |[a, b]: [f64; 2], (_, edge): (_, &Moving)| {
            [a.max(edge.range[0]), b.min(edge.range[1])]
        };
        Ok(self.moving(way).fold(all, both))
    }

    /// A frame, its parent, and so on.
    fn ancestors(&self, frame: usize) -> impl Iterator<Item = usize> {
        core::iter::successors(Some(frame), |&frame| self.nodes[frame].parent)
    }

    /// From a frame to below one of its ancestors.
    fn climb(&self, frame: usize, ancestor: usize) -> impl Iterator<Item = &Node> {
        let below = self.ancestors(frame).take_while(move |&frame| frame != ancestor);
        below.map(|frame| &self.nodes[frame])
    }

    /// The edges of a way that move, and the names of their frames.
    fn moving(&self, way: Way) -> impl Iterator<Item = (&str, &Moving)> {
        let Way { target, source, ancestor } = way;
        let nodes = self.climb(target, ancestor).chain(self.climb(source, ancestor));
        nodes.filter_map(|node| match &node.motion {
            Motion::Moving(moving) => Some((node.name.as_str(), moving)),
            Motion::Fixed(_) => None,
        })
    }

    fn way(&self, target: &str, source: &str) -> Result<Way, FramesError> {
        let find = |name: &str| {
            let index = self.names.get(name).copied();
            index.ok_or_else(|| FramesError::Unknown { frame: name.to_owned() })
        };
        let (mut a, mut b) = (find(target)?, find(source)?);
        let (into, of) = (a, b);
        while a != b {
            let deeper = if self.nodes[a].depth < self.nodes[b].depth { &mut b } else { &mut a };
            let Some(parent) = self.nodes[*deeper].parent else {
                let (target, source) = (target.to_owned(), source.to_owned());
                return Err(FramesError::NotConnected { target, source });
            };
            *deeper = parent;
        }
        Ok(Way { target: into, source: of, ancestor: a })
    }
}

/// From one frame to another by the nearest frame that both lie in.
#[derive(Clone, Copy)]
struct Way {
    target: usize,
    source: usize,
    ancestor: usize,
}

impl Moving {
    fn new(path: Trajectory<'_>) -> Self {
        let range = path.range();
        // One pose has no way to go on, and a job that asks for it is refused.
        let outside = if path.stamps().len() > 1 { Outside::Continue } else { Outside::Hold };
        let (into, backend) = (DualQuat::IDENTITY, Backend::best());
        Self { segments: segments::<_, Samples, SAMPLES>(path, outside, into, backend), range }
    }

    fn is_one_pose(&self) -> bool {
        self.range[0] == self.range[1]
    }
}
