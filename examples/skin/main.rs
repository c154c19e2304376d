//! A mesh follows its joints: linear blending, dual quaternion blending, and a mix of both.
//!
//! ```text
//! skin [--svg OUT]                     the built-in tube, bent and twisted: its volume and length,
//!                                      and a picture (skin.svg)
//! skin FILE.glb [--animation NAME] [--method lbs|dlb|mix=X] [--normalize] [--times T0,T1,…]
//!      [--obj DIR] [--pack OUT] [--svg OUT]
//! ```
//!
//! FILE is a binary or textual glTF file. The meshes of its scene are posed in world space, at each
//! time in seconds (by default four of the animation), in the order of nodes, primitives and
//! vertices of the file. A mesh with a skin follows its joints and not its own node (glTF 2.0,
//! §3.7.3.3); one without follows its node. `--pack` writes the animation of all nodes as a packed
//! clip, 30 frames a second. Weights of a vertex that do not sum to one are taken as they are, and
//! a warning says which are farthest off: linear blending makes the mesh smaller or larger by their
//! sum. `--normalize` divides them by it. X is the share of `dlb`, the default method, in [0, 1].
//! What else would put vertices somewhere is an error that names the mesh: weights of morph targets
//! that are not zero, compressed meshes, instances. What moves no vertex (materials, textures,
//! cameras, data of applications) is not looked at.

mod accessor;
mod args;
mod bones;
#[cfg(test)]
mod broken;
mod drawing;
mod error;
mod file;
mod json;
mod mesh;
mod obj;
mod pack;
mod pose;
#[cfg(test)]
mod readable;
mod refused;
mod sampler;
#[cfg(test)]
mod tests;
mod tube;
mod uri;

use args::Args;
use error::at;
use mocap::command;
use std::process::ExitCode;

fn main() -> ExitCode {
    // What panics is reported as an error.
    std::panic::set_hook(Box::new(|_| ()));
    command::execute("skin", args::USAGE, args::parse, |args| {
        let file = args.file.clone().unwrap_or_default();
        command::print(&error::guarded(&file, || run(args))?)
    })
}

/// What is to be printed.
fn run(args: &Args) -> Result<String, String> {
    let Some(path) = &args.file else {
        let (report, svg) = tube::report().map_err(|error| error.to_string())?;
        let to = args.svg.clone().unwrap_or_else(|| "skin.svg".into());
        error::write(&to, &svg)?;
        return Ok(format!("{report}{} written\n", to.display()));
    };
    let file = file::File::open(path)?;
    let of_file = |error| at(path, error);
    let animation = file.animation(args.animation.as_deref()).map_err(of_file)?;
    let times = args.times.clone().unwrap_or_else(|| animation.times());
    if let Some(directory) = &args.obj {
        std::fs::create_dir_all(directory).map_err(|error| at(directory, error))?;
    }
    let mut report = String::new();
    if let Some(to) = &args.pack {
        let (packed, text) = pack::pack(&file, &animation)?;
        error::write(to, packed.as_bytes())?;
        report += &text;
    }
    let (mut panels, mut meshes) = (Vec::new(), file.meshes().map_err(of_file)?);
    for mesh in &mut meshes {
        if args.normalize {
            mesh.normalize();
        } else if let Some(warning) = mesh.unbalanced() {
            eprintln!("skin: {}", at(path, warning));
        }
    }
    for (index, &time) in times.iter().enumerate() {
        let worlds = file.worlds(&animation, time).map_err(of_file)?;
        let mut posed = Vec::new();
        for mesh in &meshes {
            posed.push(mesh.pose(&worlds, args.method)?);
        }
        let vertices: usize = posed.iter().map(Vec::len).sum();
        let [low, high] = mesh::corners(posed.iter().flatten())
            .map(|[x, y, z]| format!("({x:.3}, {y:.3}, {z:.3})"));
        report += &format!("{time:8.3} s: {vertices} vertices, {low} … {high}\n");
        if let Some(directory) = &args.obj {
            let to = directory.join(format!("pose-{index:03}.obj"));
            error::write(&to, obj::text(time, &meshes, &posed))?;
        }
        panels.push(drawing::Panel::of(format!("{time:.3} s"), &meshes, &posed));
    }
    if let Some(to) = &args.svg {
        error::write(to, drawing::svg(&panels))?;
    }
    Ok(report)
}
