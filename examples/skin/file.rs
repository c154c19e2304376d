use crate::accessor::read;
use crate::bones::{Bones, IDENTITY, affine};
use crate::error::at;
use crate::json::Json;
use crate::mesh::Mesh;
use crate::pose::{Animation, Local};
use crate::uri;
use dq8::representation::Affine;
use gltf::accessor::Dimensions;
use gltf::buffer::Source;
use gltf::json::validation::Checked;
use std::path::Path;

/// A glTF file with its buffers.
#[derive(Debug)]
pub(crate) struct File {
    document: gltf::Document,
    buffers: Vec<Vec<u8>>,
    /// For each animation, the numbers of its channels in the file.
    channels: Vec<Vec<usize>>,
    nodes: Vec<Local>,
    /// Parents before children, each with its parent.
    order: Vec<(usize, Option<usize>)>,
}

impl File {
    pub(crate) fn open(path: &Path) -> Result<Self, String> {
        let bytes = std::fs::read(path).map_err(|error| at(path, error))?;
        Self::parse(path, &bytes).map_err(|error| at(path, error))
    }

    pub(crate) fn parse(path: &Path, bytes: &[u8]) -> Result<Self, String> {
        let (json, mut blob) = match bytes {
            [b'g', b'l', b'T', b'F', 1, 0, 0, 0, ..] => {
                return Err("glTF 1.0: only glTF 2.0 is read".into());
            }
            [b'g', b'l', b'T', b'F', ..] => {
                let glb = gltf::Glb::from_slice(bytes).map_err(|error| error.to_string())?;
                (Json::read(&glb.json)?, glb.bin.map(|bytes| bytes.into_owned()))
            }
            _ => (Json::read(bytes)?, None),
        };
        let Json { root, channels } = json;
        let document = gltf::Document::from_json_without_validation(root);
        let mut buffers = Vec::new();
        for buffer in document.buffers() {
            let place = |what: String| format!("buffer {}: {what}", buffer.index());
            let bytes = match buffer.source() {
                Source::Bin => blob.take().ok_or_else(|| place("the file has no bytes".into()))?,
                Source::Uri(uri) => match uri::data(uri) {
                    Some(data) => data.map_err(|what| place(what.into()))?,
                    None => {
                        let from = uri::file(uri, path).map_err(|what| place(what.into()))?;
                        std::fs::read(&from)
                            .map_err(|error| place(format!("{}: {error}", from.display())))?
                    }
                },
            };
            if bytes.len() < buffer.length() {
                let (have, need) = (bytes.len(), buffer.length());
                return Err(place(format!("{have} bytes where {need} are needed")));
            }
            buffers.push(bytes);
        }
        let nodes = document.nodes().map(|node| Local::of(&node)).collect::<Result<_, _>>()?;
        let order = order(&document)?;
        Ok(Self { document, buffers, channels, nodes, order })
    }

    /// The animation of this name or number, the first one without, or rest.
    pub(crate) fn animation(&self, name: Option<&str>) -> Result<Animation, String> {
        let mut all = self.document.animations();
        let found = match name {
            None => match all.next() {
                Some(first) => first,
                None => return Ok(Animation::default()),
            },
            Some(name) => {
                let is = |a: &gltf::Animation<'_>| {
                    a.name() == Some(name) || name.parse() == Ok(a.index())
                };
                let names: Vec<_> = self
                    .document
                    .animations()
                    .map(|a| a.name().unwrap_or("?").to_owned())
                    .collect();
                all.find(is).ok_or_else(|| {
                    format!("no animation {name}; there are: {}", names.join(", "))
                })?
            }
        };
        // The crate gltf does not check these.
        let json = &self.document.as_json().animations[found.index()];
        let numbers = &self.channels[found.index()];
        for (channel, gltf::json::animation::Channel { target, .. }) in
            numbers.iter().zip(&json.channels)
        {
            let what = match target.path {
                Checked::Invalid => "its path is unknown".into(),
                _ if target.node.value() >= self.nodes.len() => {
                    format!("there is no node {}", target.node.value())
                }
                _ => continue,
            };
            return Err(format!("animation {}, channel {channel}: {what}", found.index()));
        }
        Animation::read(&self.buffers, &found, numbers)
    }

    /// The maps of all nodes into their parents.
    pub(crate) fn locals(&self, animation: &Animation, time: f64) -> Vec<Affine<f64>> {
        animation.locals(&self.nodes, time)
    }

    /// The maps of all nodes into the world.
    pub(crate) fn worlds(
        &self,
        animation: &Animation,
        time: f64,
    ) -> Result<Vec<Affine<f64>>, String> {
        let mut worlds = self.locals(animation, time);
        for &(node, parent) in &self.order {
            if let Some(parent) = parent {
                worlds[node] = worlds[parent] * worlds[node];
            }
            if worlds[node].to_matrix3x4().as_flattened().iter().any(|c| !c.is_finite()) {
                return Err(format!("node {node} is nowhere at {time} s"));
            }
        }
        Ok(worlds)
    }

    /// The meshes of the scene, in the order of nodes and primitives. One without a skin follows
    /// its node.
    pub(crate) fn meshes(&self) -> Result<Vec<Mesh>, String> {
        let mut meshes = Vec::new();
        let seen = self.seen();
        for node in self.document.nodes().filter(|node| seen[node.index()]) {
            let Some(mesh) = node.mesh() else { continue };
            let bones = match node.skin() {
                Some(skin) => {
                    self.bones(&skin).map_err(|what| format!("skin {}: {what}", skin.index()))?
                }
                None => Bones::node(node.index()),
            };
            for primitive in mesh.primitives() {
                let place = format!("mesh {}, primitive {}", mesh.index(), primitive.index());
                let skinned = node.skin().is_some();
                let read = Mesh::read(&place, &self.buffers, &primitive, &bones, skinned);
                meshes.push(read.map_err(|what| format!("{place}: {what}"))?);
            }
        }
        if meshes.is_empty() {
            return Err("its scene has no mesh".into());
        }
        Ok(meshes)
    }

    fn bones(&self, skin: &gltf::Skin<'_>) -> Result<Bones, String> {
        let nodes: Vec<_> = skin.joints().map(|joint| joint.index()).collect();
        let Some(accessor) = skin.inverse_bind_matrices() else {
            return Ok(Bones { inverse_binds: vec![IDENTITY; nodes.len()], nodes });
        };
        let read = read::<16>(&self.buffers, &accessor, Dimensions::Mat4)?;
        if read.len() < nodes.len() {
            let (have, need) = (read.len(), nodes.len());
            return Err(format!("{have} inverse binds for {need} joints"));
        }
        let mut inverse_binds = Vec::new();
        for (joint, matrix) in read[..nodes.len()].iter().enumerate() {
            let columns = core::array::from_fn(|c| core::array::from_fn(|r| matrix[4 * c + r]));
            let place = |what| format!("inverse bind {joint}: {what}");
            inverse_binds.push(affine(columns).map_err(place)?);
        }
        Ok(Bones { nodes, inverse_binds })
    }

    /// For each node whether it is in the scene: the default one, or else the first; all nodes
    /// without scenes.
    fn seen(&self) -> Vec<bool> {
        let Some(scene) = self.document.default_scene().or_else(|| self.document.scenes().next())
        else {
            return vec![true; self.nodes.len()];
        };
        let mut seen = vec![false; self.nodes.len()];
        for node in scene.nodes() {
            seen[node.index()] = true;
        }
        for &(node, parent) in &self.order {
            seen[node] |= parent.is_some_and(|parent| seen[parent]);
        }
        seen
    }
}

/// All nodes, parents before children.
fn order(document: &gltf::Document) -> Result<Vec<(usize, Option<usize>)>, String> {
    let count = document.nodes().len();
    let mut parents = vec![None; count];
    for node in document.nodes() {
        for child in node.children() {
            if let Some(other) = parents[child.index()].replace(node.index()) {
                let (child, node) = (child.index(), node.index());
                return Err(format!("node {child} is a child of {other} and of {node}"));
            }
        }
    }
    let roots = (0..count).filter(|&node| parents[node].is_none());
    let mut order: Vec<_> = roots.map(|node| (node, None)).collect();
    let nodes: Vec<_> = document.nodes().collect();
    let mut next = 0;
    while let Some(&(node, _)) = order.get(next) {
        order.extend(nodes[node].children().map(|child| (child.index(), Some(node))));
        next += 1;
    }
    // What no root reaches goes round.
    let mut reached = vec![false; count];
    for &(node, _) in &order {
        reached[node] = true;
    }
    match reached.iter().position(|reached| !reached) {
        Some(node) => Err(format!("node {node} is an ancestor of itself, or below one")),
        None => Ok(order),
    }
}
