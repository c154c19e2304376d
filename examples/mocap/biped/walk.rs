//! The biped's walk. The feet are planned in the world, so that they stand still on the ground; the
//! legs reach them by two-link inverse kinematics. Pelvis, trunk and arms swing as plain sines.

use std::f64::consts::{PI, TAU};

use dq8::{DualQuat, Quat};

use super::{HEEL, HIP, Part, SHIN, Side, THIGH, TOE};
use dq8_bvh::{Axis, Channel};

/// Metres from one step of a foot to its next.
const STRIDE: f64 = 1.2;
/// The part of a cycle in which a foot touches the ground.
const STANCE: f64 = 0.62;
/// The parts of a cycle at which the sole comes to lie flat and the heel leaves the ground.
const FLAT: f64 = 0.08;
const HEEL_OFF: f64 = 0.38;
/// Pitch of the foot in degrees, toes down is positive: when the heel strikes, and when the toes
/// leave.
const STRIKE: f64 = -18.0;
const TOE_OFF: f64 = 48.0;
/// How far ahead of the pelvis a foot is set down, in metres, measured as the ankle of the flat
/// foot.
const AHEAD: f64 = 0.30;
/// Feet stand closer together than the hips.
const TRACK: f64 = 0.06;
const PELVIS_HEIGHT: f64 = 0.94;

pub(crate) struct Walk {
    /// Seconds for a cycle of two steps.
    pub(crate) period: f64,
}

/// All that changes from frame to frame. Angles in degrees.
pub(crate) struct Pose {
    pelvis: Pelvis,
    legs: [Leg; 2],
    /// The cycle of the left foot in radians; zero where its heel strikes.
    cycle: f64,
}

struct Pelvis {
    position: [f64; 3],
    turn: f64,
    lean: f64,
    bend: f64,
}

struct Leg {
    hip_turn: f64,
    hip_lean: f64,
    hip_bend: f64,
    knee: f64,
    ankle: f64,
    sole: f64,
}

/// The ankle in the world and the pitch of the foot.
struct Step {
    ankle: [f64; 3],
    pitch: f64,
}

impl Walk {
    pub(crate) fn pose(&self, time: f64) -> Pose {
        let cycles = time / self.period;
        let cycle = TAU * cycles;
        let pelvis = Pelvis {
            // Lowest when both feet carry, highest over each leg in turn; it sways over the leg
            // that carries.
            position: [
                0.02 * (cycle - 0.6).sin(),
                PELVIS_HEIGHT - 0.02 * (2.0 * cycle - 0.6).cos(),
                STRIDE * cycles,
            ],
            // The hip of the forward leg comes along; the hip of the swinging leg drops.
            turn: -5.0 * cycle.cos(),
            lean: 3.0 * (cycle - 0.3).sin(),
            bend: 3.0,
        };
        let legs = [Side::Left, Side::Right].map(|side| pelvis.reach(side, &step(side, cycles)));
        Pose { pelvis, legs, cycle }
    }
}

impl Pose {
    pub(crate) fn value(&self, part: Part, channel: Channel) -> f64 {
        use Channel::{Position, Rotation};
        let pelvis = &self.pelvis;
        let swing = self.cycle.cos();
        match (part, channel) {
            (Part::Pelvis, Position(axis)) => pelvis.position[axis as usize],
            (Part::Pelvis, Rotation(Axis::Y)) => pelvis.turn,
            (Part::Pelvis, Rotation(Axis::Z)) => pelvis.lean,
            (Part::Pelvis, Rotation(Axis::X)) => pelvis.bend,
            // The trunk turns against the pelvis and holds itself upright.
            (Part::Abdomen, Rotation(Axis::Y)) => -0.9 * pelvis.turn,
            (Part::Abdomen, Rotation(Axis::Z)) => -0.7 * pelvis.lean,
            (Part::Abdomen, Rotation(Axis::X)) => 1.0,
            (Part::Chest, Rotation(Axis::Y)) => -0.9 * pelvis.turn,
            (Part::Chest, Rotation(Axis::Z)) => -0.4 * pelvis.lean,
            (Part::Chest, Rotation(Axis::X)) => 2.0 + (2.0 * self.cycle).cos(),
            // The eyes stay on the way.
            (Part::Head, Rotation(Axis::Y)) => 0.8 * pelvis.turn,
            (Part::Head, Rotation(_)) => -5.0 - (2.0 * self.cycle).cos(),
            // An arm goes with the leg of the other side. Forward is negative about x.
            (Part::UpperArm(side), Rotation(Axis::X)) => 4.0 + 24.0 * sign(side) * swing,
            (Part::UpperArm(side), Rotation(Axis::Y)) => 8.0 * sign(side),
            (Part::UpperArm(side), Rotation(Axis::Z)) => 6.0 * sign(side),
            (Part::Forearm(side), Rotation(_)) => {
                -24.0 + 14.0 * sign(side) * (self.cycle - 0.3).cos()
            }
            (Part::Hand(side), Rotation(_)) => -6.0 + 5.0 * sign(side) * (self.cycle - 0.8).cos(),
            (Part::Thigh(side), Rotation(Axis::Y)) => self.leg(side).hip_turn,
            (Part::Thigh(side), Rotation(Axis::Z)) => self.leg(side).hip_lean,
            (Part::Thigh(side), Rotation(Axis::X)) => self.leg(side).hip_bend,
            (Part::Shin(side), Rotation(_)) => self.leg(side).knee,
            (Part::Foot(side), Rotation(Axis::X)) => self.leg(side).ankle,
            (Part::Foot(side), Rotation(_)) => self.leg(side).sole,
            // Only the pelvis moves along an axis.
            (_, Position(_)) => 0.0,
        }
    }

    fn leg(&self, side: Side) -> &Leg {
        &self.legs[side as usize]
    }
}

/// Left is +x for one who looks along +z.
fn sign(side: Side) -> f64 {
    match side {
        Side::Left => 1.0,
        Side::Right => -1.0,
    }
}

/// Where a foot is after so many cycles of the left one.
fn step(side: Side, cycles: f64) -> Step {
    // The pelvis is at STRIDE · cycles of the *left* foot: half a stride less for the right one.
    let before = if side == Side::Left { 0.0 } else { 0.5 };
    let phase = (cycles + before).rem_euclid(1.0);
    let start = (cycles + before).floor() - before;
    let ground = |start: f64| STRIDE * start + AHEAD;
    let x = TRACK * sign(side);
    let [height, forward, pitch] = if phase < STANCE {
        stance(phase, ground(start))
    } else {
        let t = (phase - STANCE) / (1.0 - STANCE);
        let from = stance(STANCE, ground(start));
        let to = stance(0.0, ground(start + 1.0));
        swing(t, from, to)
    };
    Step { ankle: [x, height, forward], pitch }
}

/// Height and forward place of the ankle and pitch of the foot that stands with its ankle over
/// `place`: it rolls over the heel, lies flat, and rolls over the toes.
fn stance(phase: f64, place: f64) -> [f64; 3] {
    let (pivot, pitch) = if phase < FLAT {
        (HEEL, STRIKE * (1.0 - ease(phase / FLAT)))
    } else if phase < HEEL_OFF {
        (TOE, 0.0)
    } else {
        // Slow at first, fast when the toes push off.
        (TOE, TOE_OFF * ((phase - HEEL_OFF) / (STANCE - HEEL_OFF)).powf(1.7))
    };
    let (sin, cos) = pitch.to_radians().sin_cos();
    // From the pivot back to the ankle, turned about x by the pitch.
    let (up, forward) = (-pivot[1], -pivot[2]);
    [up * cos - forward * sin, place + pivot[2] + up * sin + forward * cos, pitch]
}

/// Between the toes' leaving and the heel's strike. Cubic, with speeds at both ends that continue
/// the stance.
fn swing(t: f64, from: [f64; 3], to: [f64; 3]) -> [f64; 3] {
    let leaving = [0.25, 0.45, 110.0];
    let arriving = [-0.10, 0.30, 0.0];
    let mut place = [0.0; 3];
    for (index, value) in place.iter_mut().enumerate() {
        let (a, b) = (1.0 - t, t);
        *value = a * a * (1.0 + 2.0 * b) * from[index]
            + b * b * (1.0 + 2.0 * a) * to[index]
            + a * a * b * leaving[index]
            - b * b * a * arriving[index];
    }
    place
}

fn ease(t: f64) -> f64 {
    t * t * (3.0 - 2.0 * t)
}

impl Pelvis {
    /// The joint angles that bring the foot to its step: hip and ankle are two corners of a
    /// triangle with sides thigh and shin, the knee is the third.
    fn reach(&self, side: Side, step: &Step) -> Leg {
        let turned = |axis, degrees: f64| Quat::from_axis_angle(axis, degrees.to_radians());
        let rotation = turned([0.0, 1.0, 0.0], self.turn)
            * turned([0.0, 0.0, 1.0], self.lean)
            * turned([1.0, 0.0, 0.0], self.bend);
        let pelvis = DualQuat::from_rotation_translation(rotation, self.position);
        // The leg keeps its plane along the way while the pelvis turns.
        let hip_turn = -self.turn;
        let hip = DualQuat::from_rotation_translation(
            turned([0.0, 1.0, 0.0], hip_turn),
            [HIP[0] * sign(side), HIP[1], HIP[2]],
        );
        let [aside, up, forward] = (pelvis * hip).inverse().transform_point(step.ankle);

        let lean = aside.atan2(-up);
        let down = aside.hypot(up);
        let reach = down.hypot(forward).min(0.9999 * (THIGH + SHIN));
        let corner = |a: f64, b: f64, opposite: f64| {
            ((a * a + b * b - opposite * opposite) / (2.0 * a * b)).clamp(-1.0, 1.0).acos()
        };
        let knee = PI - corner(THIGH, SHIN, reach);
        let bend = -(forward.atan2(down) + corner(THIGH, reach, SHIN));
        Leg {
            hip_turn,
            hip_lean: lean.to_degrees(),
            hip_bend: bend.to_degrees(),
            knee: knee.to_degrees(),
            ankle: step.pitch - self.bend - (bend + knee).to_degrees(),
            sole: -self.lean - lean.to_degrees(),
        }
    }
}
