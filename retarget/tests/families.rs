//! Small robots in the styles of many humanoids: their names, the order of their hinges, and the
//! directions in which they face and hold their arms. All sizes are ours.

mod common;

use common::person;
use dq8::Quat;
use dq8_retarget::{Humanoid, RetargetError, Role, Settings, Source, retarget};
use mocap::biped;
use std::fmt::Write;

type Vector = [f64; 3];

/// A chain of hinges: for each the letter of its axis, and the name of the link that it carries.
/// The axis is that of pitch, roll or yaw of a body that stands, or `t` for the limb's direction.
/// In names, `@` is the side.
type Chain = &'static [(char, &'static str)];

#[derive(Clone, Copy)]
struct Family {
    name: &'static str,
    sides: [&'static str; 2],
    root: &'static str,
    waist: Chain,
    neck: Chain,
    leg: Chain,
    /// The places of knee and foot in the chain of the leg.
    knee: usize,
    foot: usize,
    arm: Chain,
    /// The place of the elbow in the chain of the arm, and that of the hand if there is one.
    elbow: usize,
    hand: Option<usize>,
    /// The direction of the arms with all joints at zero; y is away from the body.
    reach: Vector,
    /// The angle by which the robot is turned from x in its own file, degrees.
    yaw: f64,
    /// The sign of the axes of knees and elbows.
    sign: f64,
    fingers: usize,
}

const DOWN: Vector = [0.0, 0.0, -1.0];
const ASIDE: Vector = [0.0, 1.0, 0.0];
const AHEAD: Vector = [1.0, 0.0, 0.0];
const WORDS: [&str; 2] = ["left", "right"];
const LETTERS: [&str; 2] = ["l", "r"];
const CAPITALS: [&str; 2] = ["L", "R"];

const BASE: Family = Family {
    name: "",
    sides: WORDS,
    root: "pelvis",
    waist: &[('y', "torso_link")],
    neck: &[],
    leg: &[
        ('p', "@_hip_pitch_link"),
        ('r', "@_hip_roll_link"),
        ('y', "@_hip_yaw_link"),
        ('p', "@_knee_link"),
        ('p', "@_ankle_pitch_link"),
        ('r', "@_ankle_roll_link"),
    ],
    knee: 3,
    foot: 5,
    arm: &[
        ('p', "@_shoulder_pitch_link"),
        ('r', "@_shoulder_roll_link"),
        ('t', "@_shoulder_yaw_link"),
        ('p', "@_elbow_link"),
        ('t', "@_wrist_roll_link"),
        ('p', "@_wrist_pitch_link"),
        ('y', "@_wrist_yaw_link"),
    ],
    elbow: 3,
    hand: Some(6),
    reach: DOWN,
    yaw: 0.0,
    sign: 1.0,
    fingers: 0,
};

const FAMILIES: [Family; 22] = [
    Family {
        name: "roll and yaw waist",
        waist: &[('y', "waist_yaw_link"), ('r', "waist_roll_link"), ('p', "torso_link")],
        ..BASE
    },
    Family {
        name: "no wrists",
        leg: &[
            ('y', "@_hip_yaw_link"),
            ('r', "@_hip_roll_link"),
            ('p', "@_hip_pitch_link"),
            ('p', "@_knee_link"),
            ('p', "@_ankle_link"),
        ],
        foot: 4,
        arm: &[
            ('p', "@_shoulder_pitch_link"),
            ('r', "@_shoulder_roll_link"),
            ('t', "@_shoulder_yaw_link"),
            ('p', "@_elbow_link"),
        ],
        hand: None,
        ..BASE
    },
    Family {
        name: "hands with fingers",
        leg: &[
            ('y', "@_hip_yaw_link"),
            ('p', "@_hip_pitch_link"),
            ('r', "@_hip_roll_link"),
            ('p', "@_knee_link"),
            ('p', "@_ankle_pitch_link"),
            ('r', "@_ankle_roll_link"),
        ],
        fingers: 5,
        ..BASE
    },
    Family {
        name: "ankles that roll first",
        leg: &[
            ('p', "@_hip_pitch_link"),
            ('r', "@_hip_roll_link"),
            ('y', "@_hip_yaw_link"),
            ('p', "@_knee_link"),
            ('r', "@_ankle_roll_link"),
            ('p', "@_ankle_pitch_link"),
        ],
        neck: &[('y', "head_yaw_link"), ('p', "head_pitch_link")],
        ..BASE
    },
    Family {
        name: "small, arms ahead",
        sides: CAPITALS,
        root: "torso",
        waist: &[],
        neck: &[('y', "Neck"), ('p', "Head")],
        leg: &[
            ('y', "@Pelvis"),
            ('r', "@Hip"),
            ('p', "@Thigh"),
            ('p', "@Tibia"),
            ('p', "@AnklePitch"),
            ('r', "@_ankle"),
        ],
        arm: &[
            ('p', "@Shoulder"),
            ('y', "@Bicep"),
            ('t', "@Elbow"),
            ('y', "@ForeArm"),
            ('t', "@_wrist"),
        ],
        hand: Some(4),
        reach: AHEAD,
        fingers: 2,
        ..BASE
    },
    Family {
        name: "faces backward",
        sides: LETTERS,
        root: "root_link",
        waist: &[('p', "torso_1"), ('r', "torso_2"), ('y', "chest")],
        neck: &[('p', "neck_1"), ('r', "neck_2"), ('y', "head")],
        leg: &[
            ('p', "@_hip_1"),
            ('r', "@_hip_2"),
            ('y', "@_upper_leg"),
            ('p', "@_lower_leg"),
            ('p', "@_ankle_1"),
            ('r', "@_ankle_2"),
        ],
        arm: &[
            ('p', "@_shoulder_1"),
            ('r', "@_shoulder_2"),
            ('t', "@_upper_arm"),
            ('p', "@_elbow_1"),
            ('t', "@_forearm"),
            ('p', "@_wrist_1"),
            ('r', "@_hand"),
        ],
        yaw: 180.0,
        sign: -1.0,
        ..BASE
    },
    Family {
        name: "faces backward, numbers",
        sides: LETTERS,
        root: "root",
        waist: &[('p', "t1"), ('r', "t2"), ('y', "t3")],
        leg: &[
            ('p', "@leg1"),
            ('r', "@leg2"),
            ('y', "@leg3"),
            ('p', "@leg4"),
            ('p', "@leg5"),
            ('r', "@leg6"),
        ],
        arm: &[
            ('p', "@arm1"),
            ('r', "@arm2"),
            ('t', "@arm3"),
            ('p', "@arm4"),
            ('t', "@arm5"),
            ('p', "@arm6"),
            ('r', "@arm7"),
        ],
        yaw: 180.0,
        sign: -1.0,
        ..BASE
    },
    Family {
        name: "toes",
        sides: CAPITALS,
        root: "body",
        waist: &[('y', "trunk")],
        neck: &[('y', "NeckYaw"), ('p', "HeadPitch")],
        leg: &[
            ('y', "@HipYaw"),
            ('r', "@HipRoll"),
            ('p', "@HipPitch"),
            ('p', "@KneePitch"),
            ('p', "@AnklePitch"),
            ('r', "@AnkleRoll"),
            ('p', "@Toe"),
        ],
        arm: &[
            ('p', "@ShoulderPitch"),
            ('r', "@ShoulderYaw"),
            ('t', "@ElbowRoll"),
            ('p', "@ElbowYaw"),
            ('t', "@WristRoll"),
            ('p', "@WristPitch"),
        ],
        hand: Some(5),
        ..BASE
    },
    Family {
        name: "arms aside, palms",
        waist: &[('y', "torsoYawLink"), ('p', "torsoPitchLink"), ('r', "torso")],
        neck: &[('p', "lowerNeckPitchLink"), ('y', "neckYawLink"), ('p', "head")],
        leg: &[
            ('y', "@HipYawLink"),
            ('r', "@HipRollLink"),
            ('p', "@HipPitchLink"),
            ('p', "@KneePitchLink"),
            ('p', "@AnklePitchLink"),
            ('r', "@Foot"),
        ],
        arm: &[
            ('p', "@ShoulderPitchLink"),
            ('r', "@ShoulderRollLink"),
            ('t', "@ShoulderYawLink"),
            ('y', "@ElbowPitchLink"),
            ('t', "@ForearmLink"),
            ('r', "@WristRollLink"),
            ('y', "@Palm"),
        ],
        reach: ASIDE,
        fingers: 4,
        ..BASE
    },
    Family {
        name: "thighs in three",
        root: "base_link",
        leg: &[
            ('y', "@_thigh_yaw_link"),
            ('r', "@_thigh_roll_link"),
            ('p', "@_thigh_pitch_link"),
            ('p', "@_knee_link"),
            ('p', "@_ankle_pitch_link"),
            ('r', "@_ankle_roll_link"),
        ],
        arm: &[
            ('p', "@_arm_pitch_link"),
            ('r', "@_arm_roll_link"),
            ('t', "@_arm_yaw_link"),
            ('p', "@_elbow_pitch_link"),
            ('t', "@_elbow_yaw_link"),
        ],
        hand: Some(4),
        ..BASE
    },
    Family {
        name: "hinges for balls",
        root: "base",
        waist: &[('p', "chest_x"), ('r', "chest_y"), ('y', "chest")],
        neck: &[('p', "neck")],
        leg: &[
            ('p', "@_hip_x"),
            ('r', "@_hip_y"),
            ('y', "@_hip"),
            ('p', "@_knee"),
            ('p', "@_ankle_x"),
            ('r', "@_ankle"),
        ],
        arm: &[
            ('p', "@_shoulder_x"),
            ('r', "@_shoulder_y"),
            ('t', "@_shoulder"),
            ('p', "@_elbow"),
            ('p', "@_wrist"),
        ],
        hand: Some(4),
        ..BASE
    },
    Family {
        name: "numbered legs and arms",
        sides: LETTERS,
        root: "base_link",
        waist: &[],
        neck: &[('y', "zhead_1_link"), ('p', "zhead_2_link")],
        leg: &[
            ('r', "leg_@1_link"),
            ('y', "leg_@2_link"),
            ('p', "leg_@3_link"),
            ('p', "leg_@4_link"),
            ('p', "leg_@5_link"),
            ('r', "leg_@6_link"),
        ],
        arm: &[
            ('p', "zarm_@1_link"),
            ('r', "zarm_@2_link"),
            ('t', "zarm_@3_link"),
            ('p', "zarm_@4_link"),
            ('t', "zarm_@5_link"),
            ('r', "zarm_@6_link"),
            ('p', "zarm_@7_link"),
        ],
        ..BASE
    },
    Family {
        name: "calves",
        sides: LETTERS,
        root: "base_link",
        waist: &[('y', "waist_link")],
        leg: &[
            ('p', "@_hip_pitch_link"),
            ('r', "@_hip_roll_link"),
            ('y', "@_thigh_link"),
            ('p', "@_calf_link"),
            ('p', "@_ankle_pitch_link"),
            ('r', "@_ankle_roll_link"),
        ],
        arm: &[
            ('p', "@_shoulder_pitch_link"),
            ('r', "@_shoulder_roll_link"),
            ('t', "@_upper_arm_link"),
            ('p', "@_elbow_link"),
        ],
        hand: None,
        ..BASE
    },
    Family {
        name: "numbers after words",
        root: "base_link",
        waist: &[('y', "torso_1_link"), ('p', "torso_2_link")],
        neck: &[('p', "head_1_link"), ('y', "head_2_link")],
        leg: &[
            ('y', "leg_@_1_link"),
            ('r', "leg_@_2_link"),
            ('p', "leg_@_3_link"),
            ('p', "leg_@_4_link"),
            ('p', "leg_@_5_link"),
            ('r', "leg_@_6_link"),
        ],
        arm: &[
            ('y', "arm_@_1_link"),
            ('r', "arm_@_2_link"),
            ('t', "arm_@_3_link"),
            ('p', "arm_@_4_link"),
            ('t', "arm_@_5_link"),
            ('r', "arm_@_6_link"),
            ('p', "arm_@_7_link"),
        ],
        fingers: 2,
        ..BASE
    },
    Family {
        name: "bodies",
        sides: LETTERS,
        root: "waist_body",
        waist: &[('p', "chest0"), ('y', "chest1")],
        leg: &[
            ('r', "@leg_a"),
            ('p', "@leg_b"),
            ('y', "@leg_c"),
            ('p', "@leg_d"),
            ('p', "@leg_e"),
            ('r', "@leg_f"),
        ],
        arm: &[
            ('p', "@arm_a"),
            ('r', "@arm_b"),
            ('t', "@arm_c"),
            ('p', "@arm_d"),
            ('t', "@arm_e"),
            ('p', "@arm_f"),
        ],
        hand: Some(5),
        sign: -1.0,
        ..BASE
    },
    Family {
        name: "shanks",
        sides: LETTERS,
        root: "base",
        waist: &[('y', "waist_yaw"), ('p', "waist_pitch"), ('r', "waist_roll")],
        neck: &[('y', "head_yaw"), ('p', "head_pitch")],
        leg: &[
            ('r', "@_thigh_roll"),
            ('y', "@_thigh_yaw"),
            ('p', "@_thigh_pitch"),
            ('p', "@_shank_pitch"),
            ('p', "@_foot_pitch"),
            ('r', "@_foot_roll"),
        ],
        arm: &[
            ('p', "@_upper_arm_pitch"),
            ('r', "@_upper_arm_roll"),
            ('t', "@_upper_arm_yaw"),
            ('p', "@_lower_arm_pitch"),
            ('t', "@_hand_yaw"),
            ('r', "@_hand_roll"),
            ('p', "@_hand_pitch"),
        ],
        ..BASE
    },
    Family {
        name: "words in capitals",
        sides: ["Left", "Right"],
        root: "Base",
        waist: &[('y', "Waist_1"), ('p', "Waist_2")],
        leg: &[
            ('y', "@_Leg_Hip_Yaw"),
            ('r', "@_Leg_Hip_Roll"),
            ('p', "@_Leg_Upper"),
            ('p', "@_Leg_Lower"),
            ('p', "@_Leg_End"),
        ],
        foot: 4,
        arm: &[
            ('p', "@_Arm_1"),
            ('r', "@_Arm_2"),
            ('t', "@_Arm_3"),
            ('p', "@_Arm_4"),
            ('t', "@_Arm_5"),
        ],
        hand: Some(4),
        fingers: 5,
        ..BASE
    },
    Family {
        name: "three hinges in an arm",
        sides: LETTERS,
        root: "MP_BODY",
        waist: &[],
        neck: &[('y', "MP_NECK"), ('p', "MP_HEAD")],
        leg: &[
            ('y', "MP_PELVIS_@"),
            ('r', "MP_THIGH1_@"),
            ('p', "MP_THIGH2_@"),
            ('p', "MP_TIBIA_@"),
            ('p', "MP_ANKLE1_@"),
            ('r', "MP_ANKLE2_@"),
        ],
        arm: &[('p', "MP_SHOULDER_@"), ('r', "MP_ARM1_@"), ('y', "MP_ARM2_@")],
        elbow: 2,
        hand: None,
        reach: ASIDE,
        ..BASE
    },
    Family {
        name: "a chest that carries the hips",
        root: "torso_link",
        waist: &[],
        neck: &[('y', "head_link")],
        arm: &[
            ('p', "@_shoulder_pitch_link"),
            ('r', "@_shoulder_roll_link"),
            ('t', "@_shoulder_yaw_link"),
            ('p', "@_elbow_link"),
            ('t', "@_wrist_roll_link"),
        ],
        hand: Some(4),
        ..BASE
    },
    Family {
        name: "faces to the left",
        sides: LETTERS,
        root: "trunk",
        waist: &[('y', "upper")],
        leg: &[('p', "@a"), ('r', "@b"), ('y', "@c"), ('p', "@d"), ('p', "@e"), ('r', "@f")],
        arm: &[('p', "@g"), ('r', "@h"), ('t', "@i"), ('p', "@j"), ('t', "@k")],
        hand: Some(4),
        yaw: 90.0,
        ..BASE
    },
    Family {
        name: "collar bones",
        sides: LETTERS,
        waist: &[('y', "ltorso"), ('p', "mtorso"), ('r', "utorso")],
        neck: &[('p', "head")],
        leg: &[
            ('y', "@_uglut"),
            ('r', "@_lglut"),
            ('p', "@_uleg"),
            ('p', "@_lleg"),
            ('p', "@_talus"),
            ('r', "@_foot"),
        ],
        arm: &[
            ('y', "@_clav"),
            ('r', "@_scap"),
            ('t', "@_uarm"),
            ('y', "@_larm"),
            ('t', "@_ufarm"),
            ('r', "@_lfarm"),
            ('t', "@_hand"),
        ],
        reach: ASIDE,
        ..BASE
    },
    Family {
        name: "names that mislead",
        leg: &[
            ('p', "@_knee_motor_link"),
            ('r', "@_ankle_link"),
            ('y', "@_foot_mount"),
            ('p', "@_thigh"),
            ('p', "@_shin"),
            ('r', "@_hand_x"),
        ],
        arm: &[
            ('p', "@_a"),
            ('r', "@_b"),
            ('t', "@_c"),
            ('p', "@_wrist"),
            ('t', "@_d"),
            ('p', "@_elbow_cover"),
        ],
        hand: Some(5),
        ..BASE
    },
];

impl Family {
    fn link(&self, chain: Chain, place: usize, side: usize) -> String {
        chain[place].1.replace('@', self.sides[side])
    }

    fn urdf(&self) -> String {
        let mut text = format!("<robot name='{}'><link name='{}'/>", self.name, self.root);
        let mut trunk = self.root.to_owned();
        for &(axis, link) in self.waist {
            self.hinge(&mut text, &trunk, link, [0.0, 0.0, 0.05], axis, DOWN, [-1.0, 1.0]);
            trunk = link.to_owned();
        }
        let mut above = trunk.clone();
        for (place, &(axis, link)) in self.neck.iter().enumerate() {
            let up = if place == 0 { 0.45 } else { 0.05 };
            self.hinge(&mut text, &above, link, [0.0, 0.0, up], axis, DOWN, [-1.0, 1.0]);
            above = link.to_owned();
        }
        // The right side comes first, so that the order tells nothing about left and right.
        for (side, left) in [(1, -1.0), (0, 1.0)] {
            let mut above = self.root.to_owned();
            for (place, &(axis, _)) in self.leg.iter().enumerate() {
                let at = match place {
                    0 => [0.0, 0.1 * left, -0.05],
                    place if place < self.knee => [0.0, 0.01 * left, -0.03],
                    place if place == self.knee => [0.0, 0.0, -0.35],
                    place if place == self.knee + 1 => [0.0, 0.0, -0.4],
                    place if place > self.foot => [0.14, 0.0, -0.04],
                    _ => [0.0, 0.0, -0.02],
                };
                let bends = place == self.knee;
                let limits = if bends { [0.0, 2.4] } else { [-2.0, 2.0] };
                let link = self.link(self.leg, place, side);
                let limits = if bends && self.sign < 0.0 { [-2.4, 0.0] } else { limits };
                self.hinge(&mut text, &above, &link, at, axis, DOWN, limits);
                above = link;
            }
            let mut above = trunk.clone();
            let reach = [self.reach[0], left * self.reach[1], self.reach[2]];
            for (place, &(axis, _)) in self.arm.iter().enumerate() {
                let along = |length: f64| reach.map(|part| length * part);
                let at = match place {
                    0 => [0.0, 0.16 * left, 0.33],
                    place if place < self.elbow => along(0.03),
                    place if place == self.elbow => along(0.22),
                    place if place == self.elbow + 1 => along(0.1),
                    place if place == self.elbow + 2 => along(0.13),
                    _ => along(0.02),
                };
                let link = self.link(self.arm, place, side);
                self.hinge(&mut text, &above, &link, at, axis, reach, [-2.4, 2.4]);
                above = link;
            }
            for finger in 0..self.fingers {
                let at = [0.05, 0.01 * finger as f64, 0.01 * finger as f64];
                let names = [1, 2].map(|n| format!("{}_finger_{finger}_{n}", self.sides[side]));
                self.hinge(&mut text, &above, &names[0], at, 'p', reach, [0.0, 1.5]);
                self.hinge(
                    &mut text,
                    &names[0],
                    &names[1],
                    [0.03, 0.0, 0.0],
                    'p',
                    reach,
                    [0.0, 1.5],
                );
            }
        }
        text + "</robot>"
    }

    #[expect(clippy::too_many_arguments, reason = "they are the parts of a joint")]
    fn hinge(
        &self,
        text: &mut String,
        parent: &str,
        link: &str,
        at: Vector,
        axis: char,
        limb: Vector,
        [lower, upper]: [f64; 2],
    ) {
        let turn = Quat::from_axis_angle([0.0, 0.0, 1.0], self.yaw.to_radians());
        let axis = match axis {
            'p' => [0.0, self.sign, 0.0],
            'r' => [1.0, 0.0, 0.0],
            'y' => [0.0, 0.0, 1.0],
            _ => limb,
        };
        let ([x, y, z], [a, b, c]) = (turn.rotate(at), turn.rotate(axis));
        write!(
            text,
            "<link name='{link}'/><joint name='{link}_joint' type='revolute'><parent link='{parent}'/><child link='{link}'/>\
             <origin xyz='{x} {y} {z}'/><axis xyz='{a} {b} {c}'/>\
             <limit lower='{lower}' upper='{upper}' velocity='20' effort='1'/></joint>"
        )
        .unwrap();
    }

    /// The links that have these roles, and the places in the chains that a hip or shoulder may
    /// have.
    fn expected(&self) -> Vec<(Role, Vec<String>)> {
        let mut all = vec![(Role::Pelvis, vec![self.root.to_owned()])];
        for [left, right] in Role::PAIRS {
            for (side, role) in [left, right].into_iter().enumerate() {
                let one = |chain: Chain, place: usize| vec![self.link(chain, place, side)];
                let until = |chain: Chain, end: usize| {
                    (0..end).map(|place| self.link(chain, place, side)).collect()
                };
                let links: Vec<String> = match left {
                    Role::LeftHip => until(self.leg, self.knee),
                    Role::LeftKnee => one(self.leg, self.knee),
                    Role::LeftFoot => one(self.leg, self.foot),
                    Role::LeftShoulder => until(self.arm, self.elbow),
                    Role::LeftElbow => one(self.arm, self.elbow),
                    _ => match self.hand {
                        Some(hand) => (self.elbow + 1..=hand)
                            .map(|place| self.link(self.arm, place, side))
                            .collect(),
                        None => Vec::new(),
                    },
                };
                all.push((role, links));
            }
        }
        all
    }
}

#[test]
fn families_run_without_a_table_and_no_role_is_wrong() {
    let person = person(&biped::clip());
    let settings = Settings { fps: 10.0, ..Settings::default() };
    let (mut ran, mut wrong) = (Vec::new(), Vec::new());
    for family in FAMILIES {
        let humanoid = match Humanoid::from_urdf(&family.urdf()) {
            Ok(humanoid) => humanoid,
            Err(error) => {
                println!("{}: refused: {error}", family.name);
                continue;
            }
        };
        for (role, links) in family.expected() {
            let found = humanoid.part(role).map(|part| {
                [part.link, part.centre].map(|link| humanoid.robot().link_names()[link].clone())
            });
            let fits = match &found {
                Some(names) => names.iter().all(|name| links.contains(name)),
                None => links.is_empty(),
            };
            if !fits {
                wrong.push(format!("{}: {role} is {found:?}, not of {links:?}", family.name));
            }
        }
        let report = retarget(&person, &humanoid, &settings).unwrap().report;
        println!("{}: {:.1} mm", family.name, report.residual);
        if report.residual > 35.0 {
            wrong.push(format!("{}: {report}", family.name));
        }
        ran.push(family.name);
    }
    assert_eq!(wrong, [""; 0]);
    assert!(ran.len() >= 20, "{ran:?}");
}

#[test]
fn a_robot_faces_where_its_knees_say() {
    for family in FAMILIES.iter().filter(|family| family.yaw != 0.0) {
        let humanoid = Humanoid::from_urdf(&family.urdf()).unwrap();
        let motion = retarget(&person(&biped::clip()), &humanoid, &Settings::default()).unwrap();
        assert!(motion.report.residual < 35.0, "{}: {}", family.name, motion.report);
    }
}

#[test]
fn names_come_before_shapes_and_tables_before_both() {
    let [named, shaped] = [FAMILIES[0], FAMILIES[11]];
    let part = |family: Family, table: Option<&str>, role: Role| {
        let humanoid = Humanoid::from_bytes(family.urdf().as_bytes(), table).unwrap();
        let part = humanoid.part(role).unwrap();
        (humanoid.robot().link_names()[part.link].clone(), part.source, humanoid)
    };
    let (_, source, _) = part(named, None, Role::LeftKnee);
    assert_eq!(source, Source::Name);
    let (link, source, humanoid) = part(shaped, None, Role::LeftKnee);
    assert_eq!((link.as_str(), source), ("leg_l4_link", Source::Shape));
    assert!(humanoid.to_string().contains("left_knee       leg_l4_link, by the shape\n"));
    let table = "[links]\nleft_hand = { link = \"zarm_l6_link\", centre = \"zarm_l5_link\" }\n";
    let (link, source, humanoid) = part(shaped, Some(table), Role::LeftHand);
    assert_eq!((link.as_str(), source), ("zarm_l6_link", Source::Table));
    // What it prints as a table, it reads as a table.
    let again = Humanoid::from_bytes(shaped.urdf().as_bytes(), Some(&humanoid.table())).unwrap();
    assert_eq!(again.table(), humanoid.table());
    // A joint has no centre of its own.
    let person = person(&biped::clip());
    let table = "[joints]\nleft_hand = { link = \"LeftHand\", centre = \"LeftHand\" }\n";
    let error = person.with_table(table).unwrap_err();
    assert!(matches!(error, RetargetError::Table { .. }), "{error}");
    // A wrong table does not pass.
    let table = "[links]\nleft_foot = \"zarm_l6_link\"\n";
    let error = Humanoid::from_bytes(shaped.urdf().as_bytes(), Some(table)).unwrap_err();
    assert!(matches!(error, RetargetError::NoLegs { .. }), "{error}");
}

#[test]
fn robots_that_do_not_stand_on_two_legs_are_refused() {
    let armed = FAMILIES[0].urdf();
    // A trunk on wheels: the legs are fixed, as if they were a column.
    let mut wheels = armed.clone();
    for side in ["left", "right"] {
        for part in ["hip_pitch", "hip_roll", "hip_yaw", "knee", "ankle_pitch", "ankle_roll"] {
            let name = format!("'{side}_{part}_link_joint' type='revolute'");
            let fixed = format!("'{side}_{part}_link_joint' type='fixed'");
            assert!(wheels.contains(&name));
            wheels = wheels.replace(&name, &fixed);
        }
    }
    // Four legs, named as those of a quadruped are.
    let leg = |name: &str, at: [f64; 2]| {
        let mut text = String::new();
        let links = ["hip", "thigh", "calf"].map(|part| format!("{name}_{part}"));
        let mut above = "trunk".to_owned();
        for (place, link) in links.into_iter().enumerate() {
            let at = if place == 0 { [at[0], at[1], 0.0] } else { [0.0, 0.0, -0.2] };
            let axis = if place == 0 { 'r' } else { 'p' };
            BASE.hinge(&mut text, &above, &link, at, axis, DOWN, [-2.0, -0.5]);
            above = link;
        }
        text
    };
    let legs: String =
        [("FL", [0.2, 0.1]), ("FR", [0.2, -0.1]), ("RL", [-0.2, 0.1]), ("RR", [-0.2, -0.1])]
            .map(|(name, at)| leg(name, at))
            .concat();
    let quadruped = format!("<robot name='four'><link name='trunk'/>{legs}</robot>");
    // The upper half of a body, whose arms hang down as legs do.
    let arm = |side: usize, y: f64| {
        let (mut text, mut above, mut at) = (String::new(), "chest".to_owned(), [0.0, y, 0.0]);
        for (place, (axis, _)) in BASE.arm.iter().enumerate() {
            let link = BASE.link(BASE.arm, place, side);
            BASE.hinge(&mut text, &above, &link, at, *axis, DOWN, [-2.0, 0.5]);
            (above, at) = (link, [0.0, 0.0, -0.1]);
        }
        text
    };
    let arms = [arm(0, 0.2), arm(1, -0.2)].concat();
    let bust = format!("<robot name='bust'><link name='chest'/>{arms}</robot>");
    for urdf in [wheels, quadruped, bust] {
        let made = Humanoid::from_urdf(&urdf);
        let Err(RetargetError::NoLegs { missing, .. }) = made else { panic!("{made:?}") };
        assert!(!missing.is_empty());
    }
}
