//! Reads a file as one of the formats, and says how that ended: `read FORMAT FILE`. What it takes
//! is counted by `scripts/work.py`.

use dq8::DualQuat;
use dq8::hierarchy::PackedClips;
use dq8_robot::urdf::Robot;
use std::error::Error;
use std::path::Path;

fn main() {
    let arguments: Vec<_> = std::env::args().skip(1).collect();
    let ended = match &arguments[..] {
        [format, file] => read(format, Path::new(file)),
        _ => Err("read FORMAT FILE".into()),
    };
    match ended {
        Ok(what) => println!("{what}"),
        Err(error) => println!("{error}"),
    }
}

fn read(format: &str, file: &Path) -> Result<String, Box<dyn Error>> {
    let bytes = std::fs::read(file)?;
    Ok(match format {
        "packed" => format!("{:?}", PackedClips::from_bytes(&bytes)?),
        "urdf" => format!("{:?}", Robot::from_bytes(&bytes)?),
        "bvh" => format!("{} joints", mocap::load(file)?.joints.len()),
        "numbers" => format!("{}", str::from_utf8(&bytes)?.parse::<DualQuat<f64>>()?),
        other => return Err(format!("no format: {other}").into()),
    })
}
