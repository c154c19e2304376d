use crate::accessor::read;
use crate::bones::affine;
use crate::sampler::{Sampler, lerp, slerp};
use dq8::{DualQuat, Quat, representation::Affine};
use gltf::accessor::Dimensions;
use gltf::animation::Property;
use std::collections::HashMap;
use std::rc::Rc;

/// What moves the nodes of a file.
#[derive(Debug, Default)]
pub(crate) struct Animation {
    channels: Vec<(usize, Channel)>,
}

#[derive(Clone, Debug)]
enum Channel {
    Translation(Rc<Sampler<3>>),
    Rotation(Rc<Sampler<4>>),
    Scale(Rc<Sampler<3>>),
}

impl Animation {
    pub(crate) fn read(
        buffers: &[Vec<u8>],
        animation: &gltf::Animation<'_>,
        numbers: &[usize],
    ) -> Result<Self, String> {
        let (mut channels, mut moved) = (Vec::new(), HashMap::new());
        // All channels may have one sampler, whose keys are read once.
        let mut known: HashMap<_, Channel> = HashMap::new();
        for (index, channel) in numbers.iter().zip(animation.channels()) {
            let place = |what| format!("animation {}, channel {index}: {what}", animation.index());
            let (target, sampler) = (channel.target(), channel.sampler());
            let (node, property) = (target.node().index(), target.property());
            // "Different channels of the same animation MUST NOT have identical targets" (glTF 2.0,
            // §3.11).
            if let Some(first) = moved.insert((node, property as u8), index) {
                let path = path(property);
                return Err(place(format!(
                    "the {path} of node {node} is what channel {first} moves"
                )));
            }
            let accessors = (sampler.input().index(), sampler.output().index());
            let key = (accessors, sampler.interpolation() as u8, property as u8);
            if let Some(channel) = known.get(&key) {
                channels.push((node, channel.clone()));
                continue;
            }
            let vector = || Sampler::read(buffers, &sampler, Dimensions::Vec3).map(Rc::new);
            let read = match property {
                Property::Translation => vector().map(Channel::Translation),
                Property::Scale => vector().map(Channel::Scale),
                Property::Rotation => Sampler::read(buffers, &sampler, Dimensions::Vec4)
                    .and_then(Sampler::of_rotations)
                    .map(|sampler| Channel::Rotation(Rc::new(sampler))),
                Property::MorphTargetWeights => {
                    check_weights(buffers, &channel).map_err(place)?;
                    continue;
                }
            };
            let channel = read.map_err(place)?;
            known.insert(key, channel.clone());
            channels.push((node, channel));
        }
        Ok(Self { channels })
    }

    /// When the last of it ends.
    pub(crate) fn end(&self) -> f64 {
        let ends = self.channels.iter().map(|(_, channel)| match channel {
            Channel::Translation(sampler) | Channel::Scale(sampler) => sampler.end(),
            Channel::Rotation(sampler) => sampler.end(),
        });
        ends.fold(0.0, f64::max)
    }

    /// Four, from the beginning on.
    pub(crate) fn times(&self) -> Vec<f64> {
        let end = self.end();
        if end > 0.0 { [0.0, 0.25, 0.5, 0.75].map(|t| t * end).to_vec() } else { vec![0.0] }
    }

    /// The local maps of all nodes.
    pub(crate) fn locals(&self, nodes: &[Local], time: f64) -> Vec<Affine<f64>> {
        let mut nodes = nodes.to_vec();
        for (node, channel) in &self.channels {
            let Some(node) = nodes.get_mut(*node) else { continue };
            let (mut translation, mut rotation, mut scale) = node.parts();
            match channel {
                Channel::Translation(sampler) => translation = sampler.at(time, lerp),
                Channel::Scale(sampler) => scale = sampler.at(time, lerp),
                Channel::Rotation(sampler) => rotation = sampler.at(time, slerp),
            }
            *node = Local::Parts { translation, rotation, scale };
        }
        nodes.iter().map(Local::map).collect()
    }
}

/// The name of a path in a file.
fn path(property: Property) -> &'static str {
    match property {
        Property::Translation => "translation",
        Property::Rotation => "rotation",
        Property::Scale => "scale",
        Property::MorphTargetWeights => "weights",
    }
}

/// Morph targets move no joints, and no vertices whose weights are all zero.
fn check_weights(
    buffers: &[Vec<u8>],
    channel: &gltf::animation::Channel<'_>,
) -> Result<(), String> {
    let mesh = channel.target().node().mesh();
    let mut primitives = mesh.iter().flat_map(|mesh| mesh.primitives());
    let moves = |primitive: gltf::Primitive<'_>| {
        primitive.morph_targets().any(|target| target.positions().is_some())
    };
    if !primitives.any(moves) {
        return Ok(());
    }
    let weights = read::<1>(buffers, &channel.sampler().output(), Dimensions::Scalar)?;
    match weights.iter().find(|weight| **weight != [0.0]) {
        Some([weight]) => Err(format!("morph targets (weight {weight}) are not done here")),
        None => Ok(()),
    }
}

/// Where a node is in its parent.
#[derive(Clone, Debug)]
pub(crate) enum Local {
    Matrix(Affine<f64>),
    Parts { translation: [f64; 3], rotation: [f64; 4], scale: [f64; 3] },
}

impl Local {
    pub(crate) fn of(node: &gltf::Node<'_>) -> Result<Self, String> {
        let place = |what: &str| format!("node {}: {what}", node.index());
        let local = match node.transform() {
            gltf::scene::Transform::Matrix { matrix } => {
                let columns = affine(matrix.map(|column| column.map(f64::from)))
                    .map_err(|what| place(&format!("its matrix has {what}")))?;
                let row = |row: usize| columns.map(|column| column[row]);
                Self::Matrix(Affine::from_matrix3x4([row(0), row(1), row(2)]))
            }
            gltf::scene::Transform::Decomposed { translation, rotation, scale } => Self::Parts {
                translation: translation.map(f64::from),
                rotation: rotation.map(f64::from),
                scale: scale.map(f64::from),
            },
        };
        let finite = local.map().to_matrix3x4().as_flattened().iter().all(|c| c.is_finite());
        if finite { Ok(local) } else { Err(place("its transform is not finite")) }
    }

    /// Translation, rotation and scale, of a matrix only what an animation does not replace anyway:
    /// files animate no nodes that have one.
    fn parts(&self) -> ([f64; 3], [f64; 4], [f64; 3]) {
        match *self {
            Self::Parts { translation, rotation, scale } => (translation, rotation, scale),
            Self::Matrix(map) => match map.try_decompose() {
                Ok((motion, stretch)) => (
                    map.translation,
                    motion.rotation().to_array(),
                    [stretch[0][0], stretch[1][1], stretch[2][2]],
                ),
                Err(_) => (map.translation, Quat::IDENTITY.to_array(), [1.0; 3]),
            },
        }
    }

    fn map(&self) -> Affine<f64> {
        match *self {
            Self::Matrix(map) => map,
            Self::Parts { translation, rotation, scale } => {
                let turn = Quat::from_array(rotation).normalize();
                let motion = DualQuat::from_rotation_translation(turn, translation);
                let rigid = Affine { translation, ..Affine::from_motion(motion) };
                rigid * Affine::scale(scale)
            }
        }
    }
}
