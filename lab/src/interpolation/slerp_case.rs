use crate::arends;
use core::f32::consts::PI;
use dq8::Quat;

/// A pair of rotations that Arends' SLERP is asked for, in single precision as he computes.
#[derive(Clone, Copy, Debug)]
pub struct SlerpCase {
    /// What is special about the pair.
    pub name: &'static str,
    from: Quat<f32>,
    to: Quat<f32>,
    /// Ω, which his function is told.
    angle: f32,
    t: f32,
    /// The rotation that should come out.
    wanted: Quat<f32>,
    /// His function, or his formula without the test for equality.
    printed: fn(Quat<f32>, Quat<f32>, f32, f32) -> Quat<f32>,
}

/// What came out: the norm, and the angle to the rotation that should have, radians.
#[derive(Clone, Copy, Debug)]
pub struct Outcome {
    /// 1 for a rotation.
    pub norm: f32,
    /// In [0, π]; NaN for no rotation.
    pub error: f32,
}

impl SlerpCase {
    /// With his function.
    pub fn printed(&self) -> Outcome {
        self.outcome((self.printed)(self.from, self.to, self.t, self.angle))
    }

    /// With [`Quat::slerp`].
    pub fn dq8(&self) -> Outcome {
        self.outcome(self.from.slerp(self.to, self.t))
    }

    fn outcome(&self, result: Quat<f32>) -> Outcome {
        let between = self.wanted.conjugate() * result.normalize();
        let [x, y, z] = between.xyz();
        let sine = (x * x + y * y + z * z).sqrt();
        Outcome { norm: result.norm(), error: 2.0 * sine.atan2(between.w().abs()) }
    }
}

fn turn(degrees: f32) -> Quat<f32> {
    Quat::from_axis_angle([0.6, 0.0, 0.8], degrees.to_radians())
}

/// The cases in which it breaks, and two in which it does not.
pub fn slerp_cases() -> [SlerpCase; 7] {
    let half_turn = Quat::from_wxyz([0.0_f32, 1.0, 0.0, 0.0]);
    let case = |name, from, to, angle: f32, t, wanted| SlerpCase {
        name,
        from,
        to,
        angle,
        t,
        wanted,
        printed: arends::slerp::<f32>,
    };
    [
        case("40° to 100°", turn(40.0), turn(100.0), PI / 6.0, 0.25, turn(55.0)),
        SlerpCase {
            printed: arends::slerp_formula::<f32>,
            ..case("equal, by the formula, Ω = π/2", half_turn, half_turn, PI / 2.0, 0.5, half_turn)
        },
        case("equal, with his test", half_turn, half_turn, PI / 2.0, 0.5, half_turn),
        case(
            "120° to 240°, where only w differs",
            turn(120.0),
            turn(240.0),
            PI / 3.0,
            0.5,
            turn(180.0),
        ),
        case("opposite, q to −q, Ω = π", turn(40.0), -turn(40.0), PI, 0.25, turn(40.0)),
        case("40° to 400°, rounded, Ω = π", turn(40.0), turn(400.0), PI, 0.25, turn(40.0)),
        case(
            "40° to 360°, the longer way",
            turn(40.0),
            turn(360.0),
            160_f32.to_radians(),
            0.5,
            turn(20.0),
        ),
    ]
}

/// The largest norm that Arends' SLERP gives between rotations and the same after a whole turn,
/// which are opposite quaternions but for rounding, at a quarter of the way.
pub fn largest_norm() -> f32 {
    let norms = (1_u8..=90).map(|degrees| {
        let degrees = f32::from(degrees);
        arends::slerp(turn(degrees), turn(degrees + 360.0), 0.25, PI).norm()
    });
    norms.fold(0.0, f32::max)
}
