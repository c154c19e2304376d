//! All cores give what one gives.

use super::*;
use dq8_robot::ik::Outcome;

/// Goals of the hand and the elbow; poses that the arm reaches, with some that it does not and some that are none; random
/// starts.
fn drawn(count: usize) -> (OwnedReach<f64>, Vec<DualQuat<f64>>, Vec<f64>) {
    let (joints, mut random) = (seven(), Random(11));
    let reach = problem(&joints, [Goal::pose(7), Goal::position(3)]);
    let targets = (0..count).flat_map(|index| {
        let values = draw(&mut random, &joints);
        let hand = match index % 97 {
            5 => at(3.0, 0.0, 0.0),
            6 => at(f64::NAN, 0.0, 0.0),
            _ => pose(&reach, &values, 7),
        };
        [hand, pose(&reach, &values, 3)]
    });
    let targets = targets.collect();
    (reach, targets, (0..count).flat_map(|_| draw(&mut random, &joints)).collect())
}

#[test]
fn all_cores_give_every_bit_of_what_one_gives() {
    let options = Options { max_iterations: 12, ..Options::default() };
    for count in [0, 1, 150] {
        let (reach, targets, starts) = drawn(count);
        for (backend, values, reports) in solved(&reach, &targets, &starts, &options) {
            let (mut all, mut of_all) = (starts.clone(), vec![Report::default(); count]);
            let job = reach.job().backend(backend).threads(usize::MAX);
            job.solve(&targets, &mut all, &mut of_all, &options).unwrap();
            // NaN is not equal to itself.
            let same = of_all.iter().zip(&reports).all(|(a, b)| {
                a == b || a.outcome == Outcome::Invalid && format!("{a:?}") == format!("{b:?}")
            });
            assert!(all == values && same, "{backend}, {count}");
            let has = |outcome| reports.iter().any(|report| report.outcome == outcome);
            assert!(count < 100 || has(Outcome::Converged) && has(Outcome::Invalid));
        }
    }
}
