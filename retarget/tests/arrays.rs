//! People from arrays: positions of joints alone, and body models.

mod common;

use common::{humanoid, person};
use dq8_retarget::{BodyModel, Person, RetargetError, Role, Settings, Targets, retarget};
use mocap::biped;

/// The names and the parents of joints.
type Joints = Vec<(String, Option<usize>)>;

/// The walk of the biped as the positions of its joints.
fn positions() -> (Joints, Vec<[f64; 3]>) {
    let clip = biped::clip();
    let joints = clip.joints.iter().map(|joint| (joint.name.clone(), joint.parent)).collect();
    (joints, clip.models().unwrap().iter().map(|pose| pose.translation()).collect())
}

fn from_positions(at: &[[f64; 3]]) -> Result<Person, RetargetError> {
    let (joints, _) = positions();
    let joints: Vec<_> = joints.iter().map(|(name, parent)| (name.as_str(), *parent)).collect();
    Person::from_positions("positions", &joints, at, biped::clip().frame_time)
}

#[test]
fn positions_alone_are_followed_nearly_as_well_as_poses() {
    let (_, at) = positions();
    let own = retarget(&person(&biped::clip()), &humanoid(), &Settings::default()).unwrap();
    let motion =
        retarget(&from_positions(&at).unwrap(), &humanoid(), &Settings::default()).unwrap();
    assert!(motion.report.residual < own.report.residual + 8.0, "{}{}", own.report, motion.report);
    assert!(motion.report.slide < 25.0, "{}", motion.report);
}

#[test]
fn the_positions_of_a_person_from_positions_are_the_given_ones() {
    let (_, at) = positions();
    let settings = Settings { fps: 60.0, ..Settings::plain() };
    let given = from_positions(&at).unwrap();
    let [a, b] = [given, person(&biped::clip())]
        .map(|person| Targets::new(&person, &humanoid(), &settings).unwrap().skeleton);
    assert_eq!(a.len(), b.len());
    // The rests differ, and so do the sizes and the ground, but not the lengths on the way.
    let way = |all: &[[f64; 3]]| all[200 * 21][0] - all[0][0];
    assert!((way(&a) / way(&b) - 1.0).abs() < 0.05, "{} {}", way(&a), way(&b));
}

#[test]
fn wrong_arrays_of_positions_are_named() {
    let (_, mut at) = positions();
    let error = from_positions(&at[..at.len() - 1]).unwrap_err();
    assert!(matches!(error, RetargetError::Lengths { array: "positions", .. }), "{error}");
    at[21 * 30 + 2][1] = f64::NAN;
    let error = from_positions(&at).unwrap_err();
    assert!(matches!(error, RetargetError::NotFinite { frame: 30, .. }), "{error}");
    let error = Person::from_positions("x", &[("a", Some(0))], &[[0.0; 3]], 0.1).unwrap_err();
    assert!(matches!(error, RetargetError::Parent { joint: 0, parent: 0 }), "{error}");
}

/// A model of 22 vertices, one for each joint, whose one shape makes it taller.
struct Model {
    template: Vec<[f64; 3]>,
    shapes: Vec<f64>,
    regressor: Vec<f64>,
}

impl Model {
    fn new() -> Self {
        // Pelvis, hips, spine, knees, ankles, chest, toes, neck, collars, head and arms, y up.
        let left: [[f64; 3]; 8] = [
            [0.1, -0.08, 0.0],
            [0.1, -0.48, 0.0],
            [0.1, -0.9, 0.0],
            [0.1, -0.95, 0.13],
            [0.06, 0.45, 0.0],
            [0.18, 0.45, 0.0],
            [0.44, 0.45, 0.0],
            [0.69, 0.45, 0.0],
        ];
        let right = left.map(|[x, y, z]| [-x, y, z]);
        let mid = |y: f64| [0.0, y, 0.0];
        let (l, r) = (left, right);
        let template = vec![
            mid(0.0),
            l[0],
            r[0],
            mid(0.12),
            l[1],
            r[1],
            mid(0.25),
            l[2],
            r[2],
            mid(0.35),
            l[3],
            r[3],
            mid(0.52),
            l[4],
            r[4],
            mid(0.62),
            l[5],
            r[5],
            l[6],
            r[6],
            l[7],
            r[7],
        ];
        let shapes = template.iter().flat_map(|&[_, y, _]| [0.0, 0.1 * y, 0.0]).collect();
        let regressor = (0..22 * 22).map(|i| if i % 23 == 0 { 1.0 } else { 0.0 }).collect();
        Self { template, shapes, regressor }
    }

    fn view(&self) -> BodyModel<'_> {
        let Self { template, shapes, regressor } = self;
        BodyModel { template, shapes, regressor }
    }
}

/// Turns of a model that stands in a world with z up and swings its left knee.
fn turns(frames: usize) -> Vec<[f64; 3]> {
    let mut turns = vec![[0.0; 3]; 22 * frames];
    for (frame, turns) in turns.chunks_exact_mut(22).enumerate() {
        turns[0] = [core::f64::consts::FRAC_PI_2, 0.0, 0.0];
        turns[4] = [0.6 - 0.6 * (0.1 * frame as f64).cos(), 0.0, 0.0];
        // Arms hang.
        turns[16] = [0.0, 0.0, -1.2];
        turns[17] = [0.0, 0.0, 1.2];
    }
    turns
}

#[test]
fn a_body_model_stands_upright_and_bends_its_knee() {
    let (model, frames) = (Model::new(), 90);
    let places = vec![[0.0, 0.0, 0.9]; frames];
    let person =
        Person::from_body_model("model", model.view(), &[], &turns(frames), &places, 1.0 / 30.0);
    let person = person.unwrap();
    assert_eq!(person.joint_names()[person.joint(Role::LeftFoot).unwrap()], "left_ankle");
    assert!(Role::ALL.into_iter().all(|role| person.joint(role).is_some()));
    let motion = retarget(&person, &humanoid(), &Settings::default()).unwrap();
    assert!(motion.report.residual < 25.0, "{}", motion.report);
    let humanoid = humanoid();
    let knee = humanoid.robot().value("left_knee_joint").unwrap();
    let count = humanoid.robot().mechanism().values();
    let angles: Vec<_> = motion.values.iter().skip(knee).step_by(count).collect();
    let bend = angles[31] - angles[0];
    assert!((0.9..1.4).contains(&bend), "{bend}");
    // The right foot stands all the time, and the left one does not.
    assert!(motion.contacts.iter().all(|[_, right]| *right));
    assert!(!motion.contacts.iter().all(|[left, _]| *left));
}

#[test]
fn betas_move_joints_and_arrays_that_do_not_fit_are_named() {
    let model = Model::new();
    let [plain, tall] = [&[][..], &[1.0]].map(|betas| model.view().joints(betas).unwrap()[15][1]);
    assert!((tall - 1.1 * plain).abs() < 1e-12);
    let array = |model: BodyModel<'_>, betas: &[f64]| match model.joints(betas) {
        Err(RetargetError::Lengths { array, .. }) => array,
        other => panic!("{other:?}"),
    };
    assert_eq!(array(model.view(), &[1.0, 2.0]), "betas");
    assert_eq!(array(BodyModel { template: &[], ..model.view() }, &[]), "template");
    assert_eq!(array(BodyModel { shapes: &model.shapes[1..], ..model.view() }, &[]), "shapes");
    let regressor = &model.regressor[22..];
    assert_eq!(array(BodyModel { regressor, ..model.view() }, &[]), "regressor");
    let person = |turns: &[[f64; 3]], places: &[[f64; 3]]| {
        Person::from_body_model("x", model.view(), &[], turns, places, 0.1)
    };
    let error = person(&turns(2)[1..], &[[0.0; 3]; 2]).unwrap_err();
    assert!(matches!(error, RetargetError::Lengths { array: "turns", .. }), "{error}");
    let error = person(&turns(2), &[[0.0; 3], [f64::NAN; 3]]).unwrap_err();
    assert!(matches!(error, RetargetError::NotFinite { frame: 1, .. }), "{error}");
}
