//! An estimated trajectory against its reference: errors in a table, and both paths in a drawing.
//!
//! ```sh
//! cargo run --release --example compare_trajectories -- \
//!   REFERENCE ESTIMATE --align similarity --plot both.svg
//! ```
//!
//! Files are in the format of TUM, EuRoC or KITTI. Options: `--align
//! none|origin|yaw|rigid|similarity` (rigid), `--tolerance SECONDS` between stamps (0.01), `--step
//! 1f|1.5m|2s` of the relative errors (1f), `--plot SVG`.

mod plot;

use dq8::scalar::vector::{norm, sub};
use dq8_trajectory::compare::{Align, Errors, Pairs, Statistics, Step};
use dq8_trajectory::{OwnedTrajectory, files};
use std::error::Error;
use std::fmt::Write;

const USAGE: &str = "compare_trajectories REFERENCE ESTIMATE [--align none|origin|yaw|rigid|similarity] \
                     [--tolerance SECONDS] [--step 1f|1.5m|2s] [--plot SVG]";

fn main() -> Result<(), Box<dyn Error>> {
    print!("{}", run(std::env::args().skip(1))?);
    Ok(())
}

fn run(mut arguments: impl Iterator<Item = String>) -> Result<String, Box<dyn Error>> {
    let (mut names, mut plot) = (Vec::new(), None);
    let (mut how, mut tolerance, mut step) = (Align::Rigid, 0.01, Step::Frames(1));
    while let Some(argument) = arguments.next() {
        if !argument.starts_with("--") {
            names.push(argument);
            continue;
        }
        let value = arguments.next().ok_or(USAGE)?;
        match argument.as_str() {
            "--align" => how = alignment(&value).ok_or(USAGE)?,
            "--tolerance" => tolerance = value.parse()?,
            "--step" => step = parse_step(&value).ok_or(USAGE)?,
            "--plot" => plot = Some(value),
            _ => return Err(USAGE.into()),
        }
    }
    let [reference, estimate] = &names[..] else { return Err(USAGE.into()) };

    let mut text = String::new();
    let mut read = |name: &str| -> Result<OwnedTrajectory, Box<dyn Error>> {
        let file = files::read(name)?;
        for warning in &file.warnings {
            writeln!(text, "{name}: {warning}")?;
        }
        writeln!(text, "{name}: {}", describe(&file.trajectory))?;
        Ok(file.trajectory)
    };
    let [reference, estimate] = [read(reference)?, read(estimate)?];
    let pairs = reference.pair(&estimate, tolerance)?.align(how)?;
    writeln!(
        text,
        "{} pairs; aligned: {how:?}, scale {}",
        pairs.stamps().len(),
        pairs.alignment().scale
    )?;
    table(&mut text, &pairs.absolute(), &pairs.relative(step)?, step)?;
    if let Some(name) = plot {
        std::fs::write(&name, drawing(&pairs))?;
    }
    Ok(text)
}

fn alignment(name: &str) -> Option<Align> {
    let all = [Align::None, Align::Origin, Align::Yaw, Align::Rigid, Align::Similarity];
    all.into_iter().find(|how| format!("{how:?}").eq_ignore_ascii_case(name))
}

fn parse_step(text: &str) -> Option<Step> {
    let unit = text.chars().next_back()?;
    let number = text.strip_suffix(unit)?;
    match unit {
        'f' => number.parse().ok().map(Step::Frames),
        'm' => number.parse().ok().map(Step::Metres),
        's' => number.parse().ok().map(Step::Seconds),
        _ => None,
    }
}

fn describe(path: &OwnedTrajectory) -> String {
    let [first, last] = path.range();
    let way = |pair: &[dq8::DualQuat<f64>]| norm(sub(pair[1].translation(), pair[0].translation()));
    let length: f64 = path.poses().windows(2).map(way).sum();
    format!("{} poses, {:.3} s, {length:.3} m", path.stamps().len(), last - first)
}

fn table(text: &mut String, absolute: &Errors, relative: &Errors, step: Step) -> std::fmt::Result {
    let names = ["rmse", "mean", "median", "std", "min", "max"];
    write!(text, "{:26}", "")?;
    for name in names {
        write!(text, "{name:>13}")?;
    }
    writeln!(text)?;
    let over = format!("over {step:?}");
    for (of, errors) in [("absolute", absolute), (&*over, relative)] {
        let degrees = 1_f64.to_degrees();
        for (unit, factor, s) in
            [("m", 1.0, errors.translation()), ("degrees", degrees, errors.rotation())]
        {
            write!(text, "{of:18}{unit:8}")?;
            let Statistics { rmse, mean, median, std, min, max, .. } = s;
            for number in [rmse, mean, median, std, min, max] {
                write!(text, "{:13.9}", factor * number)?;
            }
            writeln!(text)?;
        }
    }
    Ok(())
}

/// Both paths, seen along the axis on which they are shortest; and the errors over time.
fn drawing(pairs: &Pairs) -> String {
    let reference: Vec<_> = pairs.reference().iter().map(|pose| pose.translation).collect();
    let estimate: Vec<_> = pairs.estimate().iter().map(|pose| pose.translation).collect();
    let extent = |axis: usize| {
        let along = || reference.iter().map(|point| point[axis]);
        along().fold(f64::MIN, f64::max) - along().fold(f64::MAX, f64::min)
    };
    let mut axes = [0, 1, 2];
    axes.sort_by(|&a, &b| extent(b).total_cmp(&extent(a)));
    let [a, b] = [axes[0].min(axes[1]), axes[0].max(axes[1])];
    let flat = |points: &[[f64; 3]]| points.iter().map(|point| [point[a], point[b]]).collect();
    let errors = pairs.absolute();
    let first = pairs.stamps()[0];
    let over_time = { errors.stamps().iter() }
        .zip(errors.translations())
        .map(|(stamp, error)| [stamp - first, *error])
        .collect();
    let names = ["x", "y", "z"];
    let mut drawing = plot::Drawing::default();
    drawing.panel(
        [names[a], names[b]].map(|name| format!("{name} in m")),
        true,
        &[("reference", flat(&reference)), ("estimate", flat(&estimate))],
    );
    let labels = ["time in s", "distance in m"].map(str::to_owned);
    drawing.panel(labels, false, &[("", Vec::new()), ("absolute error", over_time)]);
    drawing.svg()
}

#[test]
fn a_square_that_drifts_is_compared() {
    let folder = std::env::temp_dir().join(format!("dq8-compare-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let name = |name: &str| folder.join(name).to_str().unwrap().to_owned();
    // Ten metres along x, then ten along y; the estimate is a fifth longer.
    let lines = |scale: f64| -> String {
        let at = |k: i32| [f64::from(k.min(10)), f64::from((k - 10).max(0))].map(|c| c * scale);
        (0..=20).map(|k| format!("{k} {} {} 0 0 0 0 1\n", at(k)[0], at(k)[1])).collect()
    };
    std::fs::write(name("reference"), lines(1.0)).unwrap();
    std::fs::write(name("estimate"), lines(1.2)).unwrap();
    let run = |more: &[&str]| {
        let arguments = [name("reference"), name("estimate")].into_iter();
        run(arguments.chain(more.iter().map(|&text| text.to_owned())))
    };
    let plot = name("plot");
    let text = run(&["--align", "origin", "--step", "2s", "--plot", &plot]).unwrap();
    assert!(text.contains("reference: 21 poses, 20.000 s, 20.000 m"), "{text}");
    assert!(text.contains("21 pairs; aligned: Origin, scale 1\n"), "{text}");
    // Every two metres are 0.4 m too long, but for those that are on both sides of the corner.
    let row = text.lines().find(|line| line.starts_with("over Seconds(2.0) m")).unwrap();
    assert!(row.contains("  0.400000000"), "{text}");
    let text = run(&["--align", "similarity"]).unwrap();
    assert!(text.contains("scale 0.83333333"), "{text}");
    let svg = std::fs::read_to_string(plot).unwrap();
    assert!(svg.starts_with("<svg") && svg.matches("<polyline").count() == 3);
    for wrong in
        [&["--align", "no"][..], &["--step", "1"], &["--what", "1"], &["more"], &["--plot"]]
    {
        assert_eq!(run(wrong).unwrap_err().to_string(), USAGE);
    }
    std::fs::remove_dir_all(&folder).unwrap();
}
