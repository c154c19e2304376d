//! What changes where vertices are and is not done here: it is refused, because the mesh would be
//! posed wrongly.

use gltf::json::Root;
use gltf::json::mesh::Primitive;

const DRACO: &str = "KHR_draco_mesh_compression";
const MESHOPT: [&str; 2] = ["EXT_meshopt_compression", "KHR_meshopt_compression"];
const INSTANCES: &str = "EXT_mesh_gpu_instancing";

/// Extensions that files may not be able to do without, and that are no reason to refuse them:
/// numbers of all types are read here, [`check`] looks for some where they are used, and the rest
/// says nothing about vertices.
const REQUIRED: [&str; 14] = [
    "KHR_mesh_quantization",
    DRACO,
    MESHOPT[0],
    MESHOPT[1],
    INSTANCES,
    "KHR_xmp",
    "KHR_xmp_json_ld",
    "KHR_techniques_webgl",
    "KHR_node_visibility",
    "EXT_mesh_features",
    "EXT_instance_features",
    "EXT_structural_metadata",
    "FB_ngon_encoding",
    "CESIUM_primitive_outline",
];

/// After the name of the vendor: kinds of extensions that say how a surface looks.
const LOOKS: [&str; 4] = ["materials_", "texture_", "lights_", "packing_"];

/// Each mesh and primitive of a file that nobody has checked yet: the crate gltf takes what Draco
/// leaves out for a mistake.
pub(crate) fn check(root: &Root) -> Result<(), String> {
    let looks = |name: &str| {
        let kind = name.split_once('_').map_or("", |(_, kind)| kind);
        LOOKS.iter().any(|look| kind.starts_with(look))
    };
    let mut required = root.extensions_required.iter();
    if let Some(name) = required.find(|name| !(REQUIRED.contains(&name.as_str()) || looks(name))) {
        return Err(format!("extensionsRequired: {name} is not done here"));
    }
    for (mesh, of) in root.meshes.iter().enumerate() {
        let weights = weights(root, mesh);
        for (primitive, of) in of.primitives.iter().enumerate() {
            let moved = of.targets.iter().flatten().enumerate().any(|(target, of)| {
                of.positions.is_some()
                    && weights.iter().any(|w| w.get(target).is_some_and(|w| *w != 0.0))
            });
            let morphs = moved.then(|| "morph targets are not done here".into());
            if let Some(what) = morphs.or_else(|| of_primitive(root, of)) {
                return Err(format!("mesh {mesh}, primitive {primitive}: {what}"));
            }
        }
    }
    for (node, of) in root.nodes.iter().enumerate() {
        let instances =
            of.extensions.as_ref().is_some_and(|all| all.others.contains_key(INSTANCES));
        if let (Some(mesh), true) = (of.mesh, instances) {
            let mesh = mesh.value();
            return Err(format!("node {node}, mesh {mesh}: {INSTANCES} is not done here"));
        }
    }
    Ok(())
}

/// The weights of the morph targets of a mesh, and of the nodes that have their own. What is not
/// said is zero.
fn weights(root: &Root, mesh: usize) -> Vec<&[f32]> {
    let of = &root.meshes[mesh];
    if of.primitives.iter().all(|primitive| primitive.targets.is_none()) {
        return Vec::new();
    }
    let nodes = root.nodes.iter().filter(|node| node.mesh.is_some_and(|of| of.value() == mesh));
    let own = of.weights.as_deref().unwrap_or_default();
    nodes.map(|node| node.weights.as_deref().unwrap_or(own)).collect()
}

fn of_primitive(root: &Root, primitive: &Primitive) -> Option<String> {
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
