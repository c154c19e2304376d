use crate::accessor::read;
use crate::error::Error;
use crate::mesh::Mesh;
use crate::pose::{Animation, Local};
use dq8::Affine;
use gltf::accessor::Dimensions;
use gltf::buffer::Source;
use gltf::json::validation::Checked;
use std::path::{Path, PathBuf};

/// A glTF file with its buffers.
#[derive(Debug)]
pub(crate) struct File {
    path: PathBuf,
    document: gltf::Document,
    buffers: Vec<Vec<u8>>,
    nodes: Vec<Local>,
    /// Parents before children, each with its parent.
    order: Vec<(usize, Option<usize>)>,
}

impl File {
    pub(crate) fn open(path: &Path) -> Result<Self, Error> {
        let bytes = std::fs::read(path).map_err(|error| Error::at(path, error))?;
        Self::parse(path, &bytes).map_err(|error| Error::at(path, error))
    }

    pub(crate) fn parse(path: &Path, bytes: &[u8]) -> Result<Self, Error> {
        let gltf::Gltf { document, mut blob } =
            gltf::Gltf::from_slice(bytes).map_err(|error| Error(error.to_string()))?;
        let mut buffers = Vec::new();
        for buffer in document.buffers() {
            let place = |what: String| Error(format!("buffer {}: {what}", buffer.index()));
            let bytes = match buffer.source() {
                Source::Bin => blob.take().ok_or_else(|| place("the file has no bytes".into()))?,
                Source::Uri(uri) => match uri.strip_prefix("data:") {
                    Some(data) => base64(data).ok_or_else(|| place("bad base64".into()))?,
                    None => {
                        let from = path.with_file_name(uri);
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
        Ok(Self { path: path.into(), document, buffers, nodes, order })
    }

    /// The animation of this name or number, the first one without, or rest.
    pub(crate) fn animation(&self, name: Option<&str>) -> Result<Animation, Error> {
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
                let none = || {
                    let names = names.join(", ");
                    Error::at(&self.path, format!("no animation {name}; there are: {names}"))
                };
                all.find(is).ok_or_else(none)?
            }
        };
        // The crate gltf does not.
        let json = &self.document.as_json().animations[found.index()];
        let unknown =
            |c: &gltf::json::animation::Channel| matches!(c.target.path, Checked::Invalid);
        if let Some(channel) = json.channels.iter().position(unknown) {
            let place = format!("animation {}, channel {channel}", found.index());
            return Err(Error::at(&self.path, format!("{place}: its path is unknown")));
        }
        Animation::read(&self.buffers, &found).map_err(|error| Error::at(&self.path, error))
    }

    /// The maps of all nodes into the world.
    pub(crate) fn worlds(
        &self,
        animation: &Animation,
        time: f64,
    ) -> Result<Vec<Affine<f64>>, Error> {
        let mut worlds = animation.locals(&self.nodes, time);
        for &(node, parent) in &self.order {
            if let Some(parent) = parent {
                worlds[node] = worlds[parent] * worlds[node];
            }
            if worlds[node].to_matrix3x4().as_flattened().iter().any(|c| !c.is_finite()) {
                let what = format!("node {node} is nowhere at {time} s");
                return Err(Error::at(&self.path, what));
            }
        }
        Ok(worlds)
    }

    /// The meshes that have a skin, in the order of nodes and primitives.
    pub(crate) fn skinned_meshes(&self) -> Result<Vec<Mesh>, Error> {
        let mut meshes = Vec::new();
        for node in self.document.nodes() {
            let (Some(mesh), Some(skin)) = (node.mesh(), node.skin()) else { continue };
            let joints: Vec<_> = skin.joints().map(|joint| joint.index()).collect();
            let at = |Error(what)| Error::at(&self.path, format!("skin {}: {what}", skin.index()));
            let inverse_binds = match skin.inverse_bind_matrices() {
                Some(accessor) => {
                    read::<16>(&self.buffers, &accessor, Dimensions::Mat4).map_err(at)?
                }
                None => {
                    let identity = |i: usize| if i.is_multiple_of(5) { 1.0 } else { 0.0 };
                    vec![core::array::from_fn(identity); joints.len()]
                }
            };
            if inverse_binds.len() < joints.len() {
                let (have, need) = (inverse_binds.len(), joints.len());
                return Err(at(Error(format!("{have} inverse binds for {need} joints"))));
            }
            for primitive in mesh.primitives() {
                let read = Mesh::read(&self.buffers, &primitive, &joints, &inverse_binds);
                let place = format!("mesh {}, primitive {}", mesh.index(), primitive.index());
                meshes.push(
                    read.map_err(|Error(what)| Error::at(&self.path, format!("{place}: {what}")))?,
                );
            }
        }
        if meshes.is_empty() {
            return Err(Error::at(&self.path, "no mesh has a skin"));
        }
        Ok(meshes)
    }
}

/// All nodes, parents before children.
fn order(document: &gltf::Document) -> Result<Vec<(usize, Option<usize>)>, Error> {
    let count = document.nodes().len();
    let mut parents = vec![None; count];
    for node in document.nodes() {
        for child in node.children() {
            if let Some(other) = parents[child.index()].replace(node.index()) {
                let (child, node) = (child.index(), node.index());
                return Err(Error(format!("node {child} is a child of {other} and of {node}")));
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
        Some(node) => Err(Error(format!("node {node} is an ancestor of itself, or below one"))),
        None => Ok(order),
    }
}

/// What comes after `;base64,` in a data URI.
fn base64(data: &str) -> Option<Vec<u8>> {
    let (_, text) = data.split_once(";base64,")?;
    let (mut bytes, mut bits, mut held) = (Vec::new(), 0_u32, 0);
    for letter in text.trim_end_matches('=').bytes() {
        let value = match letter {
            b'A'..=b'Z' => letter - b'A',
            b'a'..=b'z' => letter - b'a' + 26,
            b'0'..=b'9' => letter - b'0' + 52,
            b'+' => 62,
            b'/' => 63,
            _ => return None,
        };
        (bits, held) = ((bits << 6 | u32::from(value)) & 0xff_ffff, held + 6);
        if held >= 8 {
            held -= 8;
            bytes.push((bits >> held) as u8);
        }
    }
    Some(bytes)
}
