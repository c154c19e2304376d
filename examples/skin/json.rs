//! The JSON of a file: what poses vertices, as the crate gltf can read it. The crate refuses much
//! that moves no vertex: attributes and `extras` of applications, textures without a source,
//! channels without a node, accessors without a view.

use crate::refused;
use gltf::json::validation::{Error as Fault, Validate};
use gltf::json::{Path, Root, Value, deserialize};

/// What a file says that poses vertices.
#[derive(Debug)]
pub(crate) struct Json {
    pub(crate) root: Root,
    /// For each animation, the number in the file of each channel that is left.
    pub(crate) channels: Vec<Vec<usize>>,
}

impl Json {
    /// Structure and indices are checked.
    pub(crate) fn read(bytes: &[u8]) -> Result<Self, String> {
        let fail = |error: gltf::json::Error| error.to_string();
        let bytes = bytes.strip_prefix("\u{feff}".as_bytes()).unwrap_or(bytes);
        let mut value: Value = deserialize::from_slice(bytes).map_err(fail)?;
        check_version(&value)?;
        let mut channels = Vec::new();
        for animation in array(&mut value, "animations") {
            channels.push(keep_channels(animation));
        }
        strip(&mut value);
        check_indices(&value, "")?;
        let root: Root = deserialize::from_value(value).map_err(fail)?;
        refused::check(&root)?;
        validate(&root)?;
        Ok(Self { root, channels })
    }
}

fn array<'v>(value: &'v mut Value, name: &str) -> impl Iterator<Item = &'v mut Value> {
    value.get_mut(name).and_then(Value::as_array_mut).into_iter().flatten()
}

/// The elements of glTF 1.0 are named and not numbered.
fn check_version(value: &Value) -> Result<(), String> {
    let version = value.pointer("/asset/version").map(|version| match version {
        Value::String(text) => text.clone(),
        other => other.to_string(),
    });
    let version = match version {
        Some(version) => version,
        None if value.get("meshes").is_some_and(Value::is_object) => "1.0".into(),
        None => return Ok(()),
    };
    let two = version.trim().split('.').next() == Some("2");
    if two { Ok(()) } else { Err(format!("glTF {version}: only glTF 2.0 is read")) }
}

/// Leaves out what moves no joint: channels without a node "should be ignored" (glTF 2.0, §3.11),
/// and those of a pointer are an extension's. The numbers of the others.
fn keep_channels(animation: &mut Value) -> Vec<usize> {
    let moves = |channel: &Value| {
        let Some(target) = channel.get("target").and_then(Value::as_object) else { return true };
        target.contains_key("node") && target.get("path").is_none_or(|path| path != "pointer")
    };
    let mut numbers = Vec::new();
    if let Some(channels) = animation.get_mut("channels").and_then(Value::as_array_mut) {
        numbers = (0..channels.len()).filter(|&number| moves(&channels[number])).collect();
        channels.retain(moves);
    }
    numbers
}

/// Leaves out materials and cameras, attributes that are not posed, and whatever applications add.
fn strip(value: &mut Value) {
    for mesh in array(value, "meshes") {
        for primitive in array(mesh, "primitives") {
            remove(primitive, &["material"]);
            if let Some(attributes) = primitive.get_mut("attributes").and_then(Value::as_object_mut)
            {
                let posed = |name: &str| {
                    name == "POSITION"
                        || name.starts_with("JOINTS_")
                        || name.starts_with("WEIGHTS_")
                };
                attributes.retain(|name, _| posed(name));
            }
        }
    }
    for node in array(value, "nodes") {
        remove(node, &["camera"]);
    }
    remove(value, &["materials", "textures", "images", "samplers", "cameras", "extensions"]);
    strip_extras(value);
}

/// Refuses indices that the crate gltf would cut to 32 bits: 2⁴⁰ would be 0. Bytes may be more
/// than that.
fn check_indices(value: &Value, path: &str) -> Result<(), String> {
    match value {
        Value::Object(all) => all
            .iter()
            .filter(|(name, _)| !name.starts_with("byte"))
            .try_for_each(|(name, value)| check_indices(value, &format!("{path}.{name}"))),
        Value::Array(all) => {
            let mut all = all.iter().enumerate();
            all.try_for_each(|(i, value)| check_indices(value, &format!("{path}[{i}]")))
        }
        _ => match value.as_u64() {
            Some(number) if number > u32::MAX.into() => {
                Err(format!("{}: there is no number {number}", path.trim_start_matches('.')))
            }
            _ => Ok(()),
        },
    }
}

fn remove(value: &mut Value, names: &[&str]) {
    if let Some(object) = value.as_object_mut() {
        object.retain(|name, _| !names.contains(&name.as_str()));
    }
}

fn strip_extras(value: &mut Value) {
    remove(value, &["extras"]);
    let object = value.as_object_mut().into_iter().flat_map(|object| object.values_mut());
    object.for_each(strip_extras);
    value.as_array_mut().into_iter().flatten().for_each(strip_extras);
}

/// But for the bounds of positions, which are not needed, for accessors without a view, which are
/// zeros (glTF 2.0, §3.6.2.1), and for extensions, of which there is a list of our own.
fn validate(root: &Root) -> Result<(), String> {
    let mut faults = String::new();
    root.validate(root, Path::new, &mut |path, fault| {
        let path = path().to_string();
        let unneeded = fault == Fault::Missing
            && [".bufferView", ".min", ".max"].iter().any(|end| path.ends_with(end));
        if !unneeded && !path.starts_with("extensionsRequired") {
            faults += &format!(" {path}: {fault};");
        }
    });
    if faults.is_empty() { Ok(()) } else { Err(format!("invalid glTF:{faults}")) }
}
