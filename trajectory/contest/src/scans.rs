//! Points of a scan, each moved by the pose at its own time.

use crate::peers::{Number, Path, Pose};
use crate::sizes::{POINTS, POSES};
use crate::table::{Contender, Goal, Table};
use crate::{array, array_mut, drive, numbers, sevens};
use dq8::{Backend, DualQuat, Real, Twist};
use dq8_fixtures::random::Random;
use dq8_trajectory::{Frame, OwnedTrajectory};

pub(crate) fn rows(table: &Table) {
    let scan = Scan::<f32>::new(true, 4.0);
    let eigen = "Eigen: slerp and lerp, f32";
    let contenders = vec![
        scan.own(),
        scan.peer(eigen, 14.0, f32::SLERP_LERP, 1e-4),
        scan.two_calls(),
        scan.copy(1.4),
    ];
    table.contest("points, rising times, f32", POINTS, contenders);

    // So near to each other that Eigen's slerp takes no sine.
    let car = Scan::<f32>::new(true, 0.5);
    let contenders = vec![car.own(), car.peer(eigen, 0.0, f32::SLERP_LERP, 1e-4)];
    table.contest(
        "the same on a car, which turns by 0.5 mrad from pose to pose",
        POINTS,
        contenders,
    );

    let shuffled = Scan::<f32>::new(false, 4.0);
    let contenders = vec![shuffled.own(), shuffled.peer(eigen, 16.0, f32::SLERP_LERP, 1e-4)];
    table.contest("points, times in any order, f32", POINTS, contenders);

    let double = Scan::<f64>::new(true, 4.0);
    let contenders = vec![
        scan.own_twist(),
        scan.kiss_icp("KISS-ICP's loop, f32", Goal::Peer(18.0), 1e-4),
        double.kiss_icp("KISS-ICP's loop, f64", Goal::Peer(45.0), 1e-4),
        scan.copy(1.15),
    ];
    table.contest("points, one twist, f32", POINTS, contenders);
    let kiss_icp = double.kiss_icp("KISS-ICP's loop, f64", Goal::None, 1e-11);
    table.contest("points, one twist, f64", POINTS, vec![double.own_twist(), kiss_icp]);

    let screws = "Sophus' formulas: screws, f64";
    let contenders = vec![double.own(), double.peer(screws, 18.0, f64::SCREWS, 1e-11)];
    table.contest("points, rising times, f64", POINTS, contenders);
}

/// A scanner that sees up to 60 metres, on a body that turns by so many radians in a second. The
/// unit of time is a tenth of a second, in which the scanner turns once.
struct Scan<R> {
    path: OwnedTrajectory,
    sevens: Vec<Pose>,
    rises: bool,
    times: Vec<R>,
    points: Vec<[R; 3]>,
}

/// The motion of the body within a scan, for KISS-ICP.
const TWIST: [f64; 6] = [0.02, -0.01, 0.1, 1.0, 0.05, -0.02];

impl<R: Number> Scan<R> {
    fn new(rises: bool, turns: f64) -> Self {
        let stamps = (0..POSES).map(|k| k as f64 / (POSES - 1) as f64).collect();
        let poses = drive(2, POSES, 1e-3, turns);
        let sevens = sevens(&poses);
        let path = OwnedTrajectory::new(stamps, poses).expect("a trajectory");
        let mut random = Random(1);
        // Rounded first: both kinds of numbers are the same scan.
        let mut number = |low: f64, high| f64::from(random.between(low, high) as f32);
        let mut times: Vec<_> = (0..POINTS).map(|_| number(0.0, 1.0)).collect();
        if rises {
            times.sort_by(f64::total_cmp);
        }
        let times = times.into_iter().map(<R as Real>::from_f64).collect();
        let mut point = || [(); 3].map(|()| <R as Real>::from_f64(number(-60.0, 60.0)));
        let points = (0..POINTS).map(|_| point()).collect();
        Self { path, sevens, rises, times, points }
    }

    fn own(&self) -> Contender<'_> {
        let job = self.path.job();
        moves("dq8", Goal::None, 0.0, move |moved| {
            job.deskew(&self.times, &self.points, moved).expect("a scan");
        })
    }

    fn own_twist(&self) -> Contender<'_> {
        moves("dq8", Goal::None, 0.0, move |moved| {
            let path = OwnedTrajectory::of_twist(Twist::from_array(TWIST), 0.0..1.0);
            let path = path.expect("a twist");
            let job = path.job().frame(Frame::End);
            job.deskew(&self.times, &self.points, moved).expect("a scan");
        })
    }

    fn peer(&self, name: &'static str, goal: f64, path: Path<R>, tolerance: f64) -> Contender<'_> {
        let (stamps, poses) = (array(self.path.stamps()), array(&self.sevens));
        let goal = if goal > 0.0 { Goal::Peer(goal) } else { Goal::None };
        moves(name, goal, tolerance, move |moved| {
            let (times, points) = (array(&self.times), array(&self.points));
            path(stamps, poses, self.rises, times, points, array_mut(moved));
        })
    }

    fn kiss_icp(&self, name: &'static str, goal: Goal, tolerance: f64) -> Contender<'_> {
        moves(name, goal, tolerance, |moved| {
            R::CONSTANT_TWIST(&TWIST, array(&self.times), array(&self.points), array_mut(moved));
        })
    }

    /// A pose for each point goes through memory.
    fn two_calls(&self) -> Contender<'_> {
        let pass = |(poses, moved): &mut (Vec<DualQuat<R>>, Vec<[R; 3]>)| {
            self.path.job().sample(&self.times, poses).expect("times");
            let done = Backend::best().transform_points_each(poses, &self.points, moved);
            done.expect("as many");
        };
        let output = (vec![DualQuat::<R>::IDENTITY; POINTS], nothing());
        let name = "dq8: `sample`, then `transform_points_each`";
        Contender::new(name, Goal::None, Some(1e-4), output, pass, |(_, moved)| numbers(moved))
    }

    /// A loop that copies points and times.
    fn copy(&self, goal: f64) -> Contender<'_> {
        let pass = |(times, moved): &mut (Vec<R>, Vec<[R; 3]>)| {
            let from = self.times.iter().zip(&self.points);
            for ((time, point), (t, p)) in times.iter_mut().zip(moved).zip(from) {
                (*time, *point) = (*t, *p);
            }
        };
        let output = (vec![R::NAN; POINTS], nothing());
        let name = "a copy of points and times";
        Contender::new(name, Goal::Own(goal), None, output, pass, |(_, moved)| numbers(moved))
    }
}

/// A contender that moves points.
fn moves<'a, R: Number + 'a>(
    name: &'static str,
    goal: Goal,
    tolerance: f64,
    pass: impl Fn(&mut Vec<[R; 3]>) + 'a,
) -> Contender<'a> {
    Contender::new(name, goal, Some(tolerance), nothing(), pass, |moved| numbers(moved))
}

/// Points that a contender has to write.
fn nothing<R: Number>() -> Vec<[R; 3]> {
    vec![[R::NAN; 3]; POINTS]
}
