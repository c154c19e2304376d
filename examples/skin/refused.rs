//! What changes where vertices are and is not done here: it is refused, because the mesh would be posed wrongly.

use crate::error::Error;
use gltf::json::Root;
use gltf::json::mesh::Primitive;

const DRACO: &str = "KHR_draco_mesh_compression";
const MESHOPT: [&str; 2] = ["EXT_meshopt_compression", "KHR_meshopt_compression"];
const INSTANCES: &str = "EXT_mesh_gpu_instancing";

/// Extensions that [`check`] refuses where they are used.
pub(crate) const NAMES: [&str; 4] = [DRACO, MESHOPT[0], MESHOPT[1], INSTANCES];

/// Each mesh and primitive of a file that nobody has checked yet: the crate gltf takes what Draco leaves out for a mistake.
pub(crate) fn check(root: &Root) -> Result<(), Error> {
    for (mesh, of) in root.meshes.iter().enumerate() {
        for (primitive, of) in of.primitives.iter().enumerate() {
            if let Some(what) = of_primitive(root, of) {
                return Err(Error(format!("mesh {mesh}, primitive {primitive}: {what}")));
            }
        }
    }
    for (node, of) in root.nodes.iter().enumerate() {
        let instances =
            of.extensions.as_ref().is_some_and(|all| all.others.contains_key(INSTANCES));
        if let (Some(mesh), true) = (of.mesh, instances) {
            let mesh = mesh.value();
            return Err(Error(format!("node {node}, mesh {mesh}: {INSTANCES} is not done here")));
        }
    }
    Ok(())
}

fn of_primitive(root: &Root, primitive: &Primitive) -> Option<String> {
    let mut targets = primitive.targets.iter().flatten();
    if targets.any(|target| target.positions.is_some()) {
        return Some("morph targets are not done here".into());
    }
    let accessors = primitive.attributes.values().copied().chain(primitive.indices);
    let mut views =
        accessors.filter_map(|at| root.accessors.get(at.value())).map(|a| a.buffer_view);
    // Without a view the numbers are in the compressed data only.
    let draco = primitive.extensions.as_ref().is_some_and(|all| all.others.contains_key(DRACO));
    if draco && views.clone().any(|view| view.is_none()) {
        return Some(format!("{DRACO} is not done here"));
    }
    // A file that can do without the extension has the numbers in the view itself.
    let needed =
        MESHOPT.into_iter().filter(|name| root.extensions_required.iter().any(|r| r == name));
    let name = views.find_map(|view| {
        let extensions = root.buffer_views.get(view?.value())?.extensions.as_ref()?;
        needed.clone().find(|name| extensions.others.contains_key(*name))
    })?;
    Some(format!("{name} is not done here"))
}
