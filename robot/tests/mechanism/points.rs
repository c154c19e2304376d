//! Points on links: those of one configuration, by the book and not, and those of lanes.

use crate::tree::{mechanism, tree, values};
use dq8::{Backend, Block, DualQuat, Real, ShapeError};
use dq8_fixtures::random::Random;
use dq8_fixtures::textbook::Textbook;
use dq8_robot::{Joint, OwnedMechanism};

/// Up to thirty products, and points as far away; the same in `f32`.
const PLACES: f64 = 1e-13;
const IN_SINGLE: f64 = 1e-4;

type Points<R> = Vec<(usize, [R; 3])>;

/// In the order of their links, or in none.
fn points(random: &mut Random, links: usize, in_order: bool) -> Points<f64> {
    let count = random.below(3 * links);
    let mut points: Points<f64> =
        (0..count).map(|_| (random.below(links), random.vector())).collect();
    if in_order {
        points.sort_by_key(|(link, _)| *link);
    }
    points
}

fn wrapped<R: Real>(points: &[(usize, [f64; 3])]) -> Points<R> {
    points.iter().map(|&(link, point)| (link, point.map(<R as Real>::from_f64))).collect()
}

fn single<R: Real>(
    joints: &[Joint<f64>],
    values: &[f64],
    points: &[(usize, [f64; 3])],
) -> Vec<[f64; 3]> {
    let values: Vec<R> = values.iter().map(|&value| <R as Real>::from_f64(value)).collect();
    let mut places = vec![[R::NAN; 3]; points.len()];
    mechanism::<R>(joints).view().link_points(&values, &wrapped(points), &mut places).unwrap();
    places.into_iter().map(|place| place.map(Into::into)).collect()
}

fn close(found: [f64; 3], wanted: [f64; 3], bound: f64, what: &str) {
    let error = (0..3).map(|i| (found[i] - wanted[i]).abs()).fold(0.0, f64::max);
    assert!(error < bound, "{what}: {found:?}, {wanted:?}");
}

#[test]
fn points_are_where_the_poses_of_their_links_take_them() {
    let mut random = Random(37);
    for count in 1..30 {
        let joints = tree(&mut random, count);
        let configurations = [1_usize, 2, 7, 8, 9, 17][count % 6];
        let many: Vec<f64> =
            (0..configurations).flat_map(|_| values(&mut random, &joints)).collect();
        let points = points(&mut random, count, count % 3 > 0);
        let (owned, floats) = (mechanism::<f64>(&joints), mechanism::<f32>(&joints));
        let robot = owned.view();
        if robot.values() == 0 || points.is_empty() {
            continue;
        }
        let mut wanted = Vec::new();
        for values in many.chunks(robot.values()) {
            let by_the_book = single::<Textbook<f64>>(&joints, values, &points);
            let found = single::<f64>(&joints, values, &points);
            let rounded = single::<f32>(&joints, values, &points);
            for (index, &(link, point)) in points.iter().enumerate() {
                let place = robot.link_pose(values, link).unwrap().transform_point(point);
                close(by_the_book[index], place, PLACES, "the book");
                close(found[index], place, PLACES, "f64");
                close(rounded[index], place, IN_SINGLE, "f32");
            }
            wanted.extend(found);
        }
        let narrow: Vec<f32> = many.iter().map(|&value| value as f32).collect();
        for backend in Backend::available() {
            let what = format!("{backend}, {count} joints, {configurations} configurations");
            let mut places = vec![[f64::NAN; 3]; wanted.len()];
            robot.job().backend(backend).points(&points, &many, &mut places).unwrap();
            let mut rounded = vec![[f32::NAN; 3]; wanted.len()];
            let job = floats.view().job().backend(backend);
            job.points(&wrapped(&points), &narrow, &mut rounded).unwrap();
            let mut blocks = vec![
                Block::<f64, 8, 3>::splat([f64::NAN; 3]);
                configurations.div_ceil(8) * points.len()
            ];
            robot.job().backend(backend).points(&points, &many, &mut blocks).unwrap();
            for (index, &wanted) in wanted.iter().enumerate() {
                close(places[index], wanted, PLACES, &what);
                close(rounded[index].map(f64::from), wanted, IN_SINGLE, &what);
                let (configuration, point) = (index / points.len(), index % points.len());
                let block = blocks[configuration / 8 * points.len() + point];
                close(block.get(configuration % 8).unwrap(), wanted, PLACES, &what);
            }
        }
    }
}

#[test]
fn points_on_links_that_there_are_not_are_refused_and_nothing_is_written() {
    let hinge = Joint::revolute(None, DualQuat::IDENTITY, [0.0, 0.0, 1.0]);
    let robot = OwnedMechanism::new(&[hinge, hinge]).unwrap();
    let (robot, mut places) = (robot.view(), [[5.0_f64; 3]; 2]);
    let (none, origin) = (ShapeError::NoLink { link: 2, links: 2 }, [0.0; 3]);
    let beyond = [(0, origin), (2, origin)];
    assert_eq!(robot.link_points(&[0.0; 2], &beyond, &mut places), Err(none.clone()));
    assert_eq!(robot.job().points(&beyond, &[0.0; 2], &mut places), Err(none));
    let points = [(0, origin), (1, origin)];
    assert!(robot.link_points(&[0.0; 3], &points, &mut places).is_err());
    assert!(robot.link_points(&[0.0; 2], &points, &mut places[..1]).is_err());
    assert!(robot.job().points(&points, &[0.0; 3], &mut places).is_err());
    assert!(robot.job().points(&points, &[0.0; 2], &mut places[..1]).is_err());
    assert_eq!(places, [[5.0; 3]; 2]);
}
