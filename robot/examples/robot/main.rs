//! A robot from a URDF file: where its links are, for many configurations.
//!
//! ```text
//! cargo run --release --example robot -- FILE.urdf \
//!   [--random N | --configurations IN.csv] [--poses OUT.csv] [--svg OUT]
//!     [--reach X,Y,Z[,QX,QY,QZ,QW] [--link NAME]]
//! ```
//!
//! Without configurations, all joints are at zero, or as near as their limits allow. The poses of
//! the first one are printed: the position of each link and its rotation, a unit quaternion with
//! its real part last. The heading of IN is the names of the joints, in any order. OUT has a row
//! for each configuration and, for every link,
//! `NAME.x,NAME.y,NAME.z,NAME.qx,NAME.qy,NAME.qz,NAME.qw`. The picture is where the tool can be:
//! the link with the most joints between it and the base. `--reach` asks for joint values that
//! bring the tool, or the link of that name, to a point or a pose, and starts from the first
//! configuration.

mod arguments;
mod configurations;
mod picture;
mod reach;
mod table;
mod tool;

use arguments::{Arguments, Configurations};
use dq8::{Backend, DualQuat};
use dq8_robot::urdf::Robot;
use std::error::Error;
use std::process::ExitCode;
use std::time::Instant;

fn main() -> ExitCode {
    if std::env::args().skip(1).any(|word| word == "-h" || word == "--help") {
        println!("{}", arguments::USAGE);
        return ExitCode::SUCCESS;
    }
    let parsed = Arguments::parse(std::env::args().skip(1));
    let parsed = parsed.map_err(|message| format!("{message}\n\n{}", arguments::USAGE).into());
    match parsed.and_then(|arguments| run(&arguments)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

fn run(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    let robot = Robot::from_file(&arguments.file)?;
    let mechanism = robot.mechanism();
    let (links, count) = (mechanism.links(), mechanism.values());
    println!("{}: {links} links, {count} values", robot.name());
    if let [first, rest @ ..] = robot.warnings() {
        println!("not read, {} in all: {first}", rest.len() + 1);
    }
    let values = match &arguments.configurations {
        Configurations::Zero => configurations::nearest_zero(&robot),
        Configurations::Random(number) => configurations::random(&robot, *number),
        Configurations::File(path) => table::read(&robot, path)?,
    };
    let configurations = values.len().checked_div(count).unwrap_or(1);
    let mut poses = vec![DualQuat::IDENTITY; configurations * links];
    let backend = Backend::best();
    // The first run pays for memory that the system has only promised.
    let mut seconds = f64::INFINITY;
    for _ in 0..5 {
        let start = Instant::now();
        mechanism.job().backend(backend).poses(&values, &mut poses)?;
        seconds = seconds.min(start.elapsed().as_secs_f64());
    }
    if let Some(first) = poses.get(..links) {
        print!("\nthe first configuration:\n{}", table::text(&robot, first));
    }
    println!(
        "\n{configurations} configurations, {:.0} per second on one thread ({backend}, f64)",
        configurations as f64 / seconds
    );
    if let Some(target) = arguments.reach {
        let link = match &arguments.link {
            Some(name) => robot.link(name).ok_or(format!("the robot has no link {name:?}"))?,
            None => tool::tool(&robot),
        };
        let start = values.get(..count).ok_or("no configuration to start from")?;
        print!("\n{}", reach::reach(&robot, link, target, start)?);
    }
    if let Some(path) = &arguments.poses {
        table::write(&robot, &poses, path)?;
        println!("poses: {}", path.display());
    }
    if let Some(path) = &arguments.svg {
        picture::write(&robot, backend, path)?;
        println!("picture: {}", path.display());
    }
    Ok(())
}
