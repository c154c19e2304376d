//! A person who kneels down: feet that wander while they seem to stand.

mod common;

use common::with_soles;
use dq8_retarget::{Humanoid, Person, Role, Settings, Targets, retarget};

type Vector = [f64; 3];

const JOINTS: [(&str, Option<usize>); 17] = [
    ("Hips", None),
    ("Spine", Some(0)),
    ("Head", Some(1)),
    ("LeftUpLeg", Some(0)),
    ("LeftLeg", Some(3)),
    ("LeftFoot", Some(4)),
    ("LeftToeBase", Some(5)),
    ("RightUpLeg", Some(0)),
    ("RightLeg", Some(7)),
    ("RightFoot", Some(8)),
    ("RightToeBase", Some(9)),
    ("LeftArm", Some(1)),
    ("LeftForeArm", Some(11)),
    ("LeftHand", Some(12)),
    ("RightArm", Some(1)),
    ("RightForeArm", Some(14)),
    ("RightHand", Some(15)),
];

const FRAMES: usize = 180;
const STEP: f64 = 1.0 / 30.0;

/// Returns the places of the joints if the hips are so low, and the left foot so far behind.
/// `thigh` and `shank` are lengths.
fn places(drop: f64, behind: f64, [thigh, shank]: [f64; 2]) -> [Vector; JOINTS.len()] {
    let mut at = [[0.0; 3]; JOINTS.len()];
    let hips = 0.92 - drop;
    at[0] = [0.0, 0.0, hips];
    at[1] = [0.0, 0.0, hips + 0.3];
    at[2] = [0.0, 0.0, hips + 0.6];
    for (first, arm, side, ankle) in [(3, 11, 0.1, -behind), (7, 14, -0.1, 0.0)] {
        let (hip, foot) = ([0.0, side, hips], [ankle, side, 0.08]);
        // The knee is ahead of the way from the hip to the foot.
        let (x, z) = (foot[0] - hip[0], foot[2] - hip[2]);
        let way = x.hypot(z);
        let along = (way * way + thigh * thigh - shank * shank) / (2.0 * way);
        let bend = (thigh * thigh - along * along).sqrt();
        let [cos, sin] = [along / way, bend / way];
        let knee = [hip[0] + cos * x - sin * z, side, hip[2] + cos * z + sin * x];
        let toes = [foot[0] + 0.13, side, 0.03];
        at[first..first + 4].copy_from_slice(&[hip, knee, foot, toes]);
        for (joint, down) in [0.0, 0.28, 0.53].into_iter().enumerate() {
            at[arm + joint] = [0.0, 2.0 * side, hips + 0.5 - down];
        }
    }
    at
}

/// The person stands for two seconds, lowers the hips within two seconds while the left foot moves
/// behind, and stays so for two.
fn kneeling(drop: f64, behind: f64, lengths: [f64; 2]) -> Person {
    let course: Vec<_> = (0..FRAMES)
        .flat_map(|frame| {
            let share = ((frame as f64 - 60.0) / 60.0).clamp(0.0, 1.0);
            let share = share * share * (3.0 - 2.0 * share);
            places(drop * share, behind * share, lengths)
        })
        .collect();
    Person::from_positions("kneeling", &JOINTS, &course, STEP).unwrap()
}

/// Returns the distances of the left knee from its target in all frames, metres.
fn knee(humanoid: &Humanoid, values: &[f64], targets: &Targets) -> Vec<f64> {
    let goal = targets.places.iter().position(|place| place.role == Role::LeftKnee).unwrap();
    let (count, goals) = (humanoid.robot().mechanism().values(), targets.goals.len());
    let frames = values.chunks_exact(count).enumerate();
    let apart = frames.map(|(frame, values)| {
        let pose =
            humanoid.robot().mechanism().link_pose(values, targets.goals[goal].link).unwrap();
        let [a, b] = [
            pose.transform_point(targets.goals[goal].point),
            targets.poses[frame * goals + goal].translation(),
        ];
        (0..3).map(|axis| (a[axis] - b[axis]).powi(2)).sum::<f64>().sqrt()
    });
    apart.collect()
}

#[test]
fn a_foot_that_wanders_while_it_seems_to_stand_is_let_go() {
    let humanoid = Humanoid::from_urdf(&with_soles()).unwrap();
    let (person, settings) = (kneeling(0.08, 0.25, [0.43; 2]), Settings::default());
    let targets = Targets::new(&person, &humanoid, &settings).unwrap();
    let motion = retarget(&person, &humanoid, &settings).unwrap();
    let knee = knee(&humanoid, &motion.values, &targets);
    let most = knee.iter().copied().fold(0.0, f64::max);
    // It stands before and after, and not on the way.
    let stands = |frame: usize| motion.contacts[frame][0];
    assert!(stands(30) && stands(150) && !stands(90));
    assert!(motion.contacts.iter().all(|[_, right]| *right));
    // Held in one place for all six seconds, the foot pulls the knee 54 mm off.
    assert!(most < 0.025, "{most}: {knee:.3?}");
    assert!(motion.report.slide < 5.0 && motion.report.sink < 3.0, "{}", motion.report);
}

#[test]
fn frames_whose_hips_are_lower_than_upright_make_no_part_of_the_rest_pose() {
    let humanoid = Humanoid::from_urdf(&with_soles()).unwrap();
    let person = kneeling(0.2, 0.0, [0.43; 2]);
    let told = Targets::new(&person, &humanoid, &Settings::default()).unwrap().told;
    // A twentieth of the hips' height above the ankles, 0.84 m, is lost in frame 78.
    let wanted =
        "the rest pose is the mean of 78 of 180 frames, in which the person stands upright";
    assert!(told.iter().any(|sentence| sentence == wanted), "{told:?}");
}

#[test]
fn a_body_of_other_proportions_kneels_where_its_feet_stand() {
    let humanoid = Humanoid::from_urdf(&with_soles()).unwrap();
    // The robot's thighs and shanks are equally long.
    let (person, settings) = (kneeling(0.2, 0.0, [0.33, 0.53]), Settings::default());
    let targets = Targets::new(&person, &humanoid, &settings).unwrap();
    let motion = retarget(&person, &humanoid, &settings).unwrap();
    let knee = knee(&humanoid, &motion.values, &targets);
    let most = knee.iter().copied().fold(0.0, f64::max);
    // With a pelvis as high as the person's, feet that stand pull the knee 22 mm off.
    assert!(most < 0.006 && motion.report.residual < 2.5, "{most}: {}", motion.report);
    assert!(motion.report.sink < 1.0, "{}", motion.report);
}
