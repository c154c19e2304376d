//! [`Motion`]: the contract that the scalar reference and the lanes share.

use crate::contract::DualNumber;
use crate::contract::Quaternion;
use crate::contract::shared_trait;
use crate::geometry::{DualVector, Line, Mean, Plane, Screw, Twist, Wrench};
use core::fmt::Debug;
use core::ops::{Add, Mul, Neg, Sub};

shared_trait! {
    /// Dual quaternions σ = p + εq, one ([`DualQuat`](crate::DualQuat)) or many at a time
    /// ([`batch::DualQuat`](crate::batch::DualQuat)).
    ///
    /// # Conventions
    ///
    /// - ε² = 0; p and q are quaternions. σ is *unit*, and then a rigid motion, if |p| = 1 and
    ///   p·q = 0.
    /// - The motion is *rotate by r, then translate by t*: σ = r + ½εtr, so r = p and t = 2qp*.
    /// - `a * b` lets `b` act first: `(a * b).transform_point(v)` is
    ///   `a.transform_point(b.transform_point(v))`, as with matrices on column vectors.
    /// - Points move by σ(1 + εv)σ⋄, directions by the rotation, lines by σ(l + εm)σ*.
    /// - σ and −σ are the same motion.
    /// - Angles are radians, lengths the user's own unit. Vectors are `[T; 3]`, matrices rows.
    ///
    /// Every rigid motion is a screw (Chasles): a turn about one line and a slide along it.
    ///
    #[doc = include_str!("screw.svg")]
    ///
    /// # Laws
    ///
    /// They hold up to rounding for finite values (the table of tolerances is in the tests):
    ///
    /// | law | for |
    /// |---|---|
    /// | (ab)c = a(bc), a·1 = 1·a = a, a(b + c) = ab + ac | all |
    /// | (ab)• = a•b•, (ab)* = b*a*, (ab)⋄ = b⋄a⋄, σ⋄ = (σ*)• | all |
    /// | σσ* = norm², norm(ab) = norm(a) norm(b) | p ≠ 0 |
    /// | normalize(σ) is unit; normalize(cσ) = normalize(σ) for real c > 0 | p ≠ 0 |
    /// | σσ⁻¹ = 1; σ⁻¹ = σ* for unit σ | p ≠ 0 |
    /// | from_rotation_translation(rotation(σ), translation(σ)) = σ | unit |
    /// | from_matrix(to_matrix(σ)) = ±σ | unit |
    /// | (ab)v = a(bv) for points, directions, lines and planes | unit |
    /// | distances and incidences are kept | unit |
    /// | exp(log σ) = ±σ, (√σ)² = ±σ | unit |
    /// | σˢσᵗ = σˢ⁺ᵗ, σ¹ = ±σ, σ⁰ = 1 | unit |
    /// | sclerp(a, b, 0) = a, sclerp(a, b, 1) = ±b, sclerp(ca, cb, t) = c sclerp(a, b, t) | unit |
    /// | nlerp(a, b, t) = nlerp(a, −b, t), the same for sclerp | unit |
    /// | dib({(a, 1−t), (b, t)}) = ±sclerp(a, b, t) | unit |
    /// | dib, dlb and sclerp of cσᵢ and σᵢc are those of σᵢ times c | unit |
    /// | distance_weighted, angle_to and distance_to keep the triangle inequality | unit |
    /// | the same three do not see the sign of σ | unit |
    /// | point_error(a, b, v) ≤ shell_error(a, b, r) for \|v\| ≤ r | unit |
    /// | from_screw(to_screw(σ)) = ±σ | unit; \|t\| over the angle is finite |
    /// | spatial_twist(derivative_spatial(σ, ξ)) = ξ | unit |
    /// | adjoint(σ, body_twist(derivative_spatial(σ, ξ))) = ξ | unit |
    /// | velocity(derivative_from_velocity(σ, ω, ṫ)) = (ω, ṫ) | unit |
    /// | integrate_body(a, twist_to(a, b), 1) = ±b | unit |
    /// | from_twist(to_twist(σ)) = ±σ | unit |
    /// | integrate_body(σ, ξ, s + t) = integrate_body(integrate_body(σ, ξ, s), ξ, t) | unit |
    /// | adjoint(ab) = adjoint(a) adjoint(b), the same for coadjoint | unit |
    /// | the power of a wrench on a twist is kept | unit |
    /// | left_jacobian(x) = adjoint(from_twist(x)) right_jacobian(x) | \|ω\| < 2π |
    /// | left_jacobian(x) = left_jacobian_inverse(x)⁻¹ | \|ω\| < 2π |
    ///
    /// # Where unit length is a precondition
    ///
    /// The promises of the laws above for *unit* σ need |p| = 1 and p·q = 0 within rounding:
    /// rotation and translation, matrices, screws, `log`, `pow`, `sclerp`, points, directions,
    /// lines, planes, twists, distances, and `conjugate` as an inverse. `from_axis_angle` needs a
    /// unit axis, and `from_rotation` and its kin need a unit rotation. Products, sums, conjugates,
    /// `norm`, `normalize`, `inverse`, `nlerp` and `dlb` take any σ with p ≠ 0.
    ///
    /// No build checks it unless it is asked to: a kernel never panics, and a test per motion would
    /// cost more than most operations. Debug builds with `RUSTFLAGS="--cfg dq8_debug_assert_unit"`
    /// do for one motion at a time: methods of [`DualQuat`](crate::DualQuat) and
    /// [`Quat`](crate::Quat) that need unit input panic at the caller's line where the square
    /// of |p| is off 1 by more than 0.1, or p·q off 0 by more than 0.1 max(1, |q|). A σ of norm
    /// 1 + δ gives results that are off by up to about 2δ, relatively; far from 1 they may differ
    /// between implementations. What comes from outside is checked where it comes in:
    /// `is_unit(tolerance)` and `is_normalized` test, `normalize` repairs, `try_from_matrix3x4` and
    /// its kin refuse, and `ik` and `dq8-robot` refuse joints and targets that are not unit.
    ///
    /// Constructors and interpolations return unit motions. Each product adds about a rounding to
    /// the norm (`needs_renormalization`).
    ///
    /// The documentation of each operation, with formula and source, stands on the scalar type.
    /// Users need not import this trait, because both types have every operation as a method of
    /// their own. No other type can implement it.
    trait Motion: Copy, Debug, Add<Output = Self>, Sub<Output = Self>, Mul<Output = Self>, Neg<Output = Self>;

    delegate by delegate_motion;

    types {
        /// The value from which constants are made: `()` for scalars, and for lanes the proof that
        /// the CPU has their instructions.
        type Level: Copy;
        /// A real number, or one per lane.
        type Real: Copy
            + Debug
            + Add<Output = Self::Real>
            + Sub<Output = Self::Real>
            + Mul<Output = Self::Real>
            + Neg<Output = Self::Real>;
        /// A truth value, or one per lane.
        type Mask: Copy + Debug;
        /// A dual number, or one per lane.
        type Dual: DualNumber<Real = Self::Real>;
        /// A quaternion, or one per lane.
        type Quat: Quaternion<Level = Self::Level, Real = Self::Real, Mask = Self::Mask>;
    }

    by_hand {
        /// The identity motion, 1 + ε0.
        fn identity(level: Self::Level) -> Self;
        /// σ/√(σσ*), and where that failed: p zero, or a component not finite. There the
        /// result is NaN.
        fn normalize_checked(self) -> (Self, Self::Mask);
        /// σ⁻¹, and where that failed: p zero, or a component not finite. There the result is
        /// NaN.
        fn inverse_checked(self) -> (Self, Self::Mask);
    }

    inherent {
        /// r + ε0
        fn from_rotation(rotation: Self::Quat) -> Self;
        /// 1 + ½εt
        fn from_translation(translation: [Self::Real; 3]) -> Self;
        /// r + ½εtr
        fn from_rotation_translation(rotation: Self::Quat, translation: [Self::Real; 3]) -> Self;
        /// r + ½εrt
        fn from_translation_rotation(translation: [Self::Real; 3], rotation: Self::Quat) -> Self;
        /// σ(r + ½εtr)
        fn mul_rotation_translation(self, rotation: Self::Quat, translation: [Self::Real; 3]) -> Self;
        /// The motion of a rigid matrix, p_w ≥ 0.
        fn from_matrix3x4(rows: [[Self::Real; 4]; 3]) -> Self;
        /// cos(θ̂/2) + sin(θ̂/2)(l + εm)
        fn from_screw(screw: Screw<Self::Real>) -> Self;

        /// r = p
        fn rotation(self) -> Self::Quat;
        /// t = 2qp*
        fn translation(self) -> [Self::Real; 3];
        /// The rows of [R | t].
        fn to_matrix3x4(self) -> [[Self::Real; 4]; 3];
        /// The rows of [R | t] and 0 0 0 1.
        fn to_matrix4(self) -> [[Self::Real; 4]; 4];
        /// The screw of the canonical one of ±σ.
        fn to_screw(self) -> Screw<Self::Real>;

        /// p − εq
        fn conjugate_dual(self) -> Self;
        /// p* + εq*
        fn conjugate(self) -> Self;
        /// p* − εq*
        fn conjugate_both(self) -> Self;
        /// The one of ±σ whose first of (p_w, p_x, p_y, p_z) that is not zero is positive.
        fn canonical(self) -> Self;
        /// sσ
        fn scale(self, factor: Self::Real) -> Self;
        /// (a + εb)σ
        fn scale_dual(self, factor: Self::Dual) -> Self;
        /// p_a·p_b + ε(p_a·q_b + q_a·p_b)
        fn dot(self, other: Self) -> Self::Dual;

        /// √(σσ*)
        fn norm(self) -> Self::Dual;
        /// σ/√(σσ*), or NaN.
        fn normalize(self) -> Self;
        /// ||p| − 1| ≤ tolerance and |p·q| ≤ tolerance·max(1, |q|)
        fn is_unit(self, tolerance: Self::Real) -> Self::Mask;
        /// σ⁻¹, or NaN.
        fn inverse(self) -> Self;
        /// Every component differs by at most `tolerance`.
        fn abs_diff_eq(self, other: Self, tolerance: Self::Real) -> Self::Mask;

        /// Rv + t
        fn transform_point(self, point: [Self::Real; 3]) -> [Self::Real; 3];
        /// Rv
        fn transform_vector(self, vector: [Self::Real; 3]) -> [Self::Real; 3];
        /// Rl + ε(Rm + t × Rl)
        fn transform_line(self, line: Line<Self::Real>) -> Line<Self::Real>;
        /// n′ = Rn, d′ = d + n′·t
        fn transform_plane(self, plane: Plane<Self::Real>) -> Plane<Self::Real>;

        /// normalize((1−t)a ± tb)
        fn nlerp(self, other: Self, t: Self::Real) -> Self;
        /// normalize(Σ ±wᵢσᵢ), signs toward the first; `None` without influences.
        fn dlb(influences: &[(Self, Self::Real)]) -> Option<Self>;
        /// normalize(Σ ±wᵢσᵢ), signs toward the sum so far; `None` without influences.
        fn dlb_running(influences: &[(Self, Self::Real)]) -> Option<Self>;
        /// b with Σ wᵢ log(b*σᵢ) = 0, steps of at most `tolerance` being none; `None` without
        /// influences.
        fn dib(
            influences: &[(Self, Self::Real)],
            tolerance: Self::Real,
            max_iterations: u32,
        ) -> Option<Mean<Self, Self::Real, Self::Mask>>;
        /// slerp(r_a, r_b, t) and (1−t)t_a + t t_b, to compare with.
        fn slerp_lerp(self, other: Self, t: Self::Real) -> Self;

        /// (θ̂/2)(l + εm)
        fn log(self) -> DualVector<Self::Real>;
        /// cos ĥ + sin ĥ (l + εm). On lanes, and for `f32` and `f64`, NaN beyond a half angle of
        /// 2¹⁶ rad (`f32`) or 2⁴⁵ rad (`f64`), as are the powers and interpolations that go
        /// so far.
        fn exp(log: DualVector<Self::Real>) -> Self;
        /// σᵗ
        fn pow(self, t: Self::Real) -> Self;
        /// √σ
        fn sqrt(self) -> Self;
        /// a(a*b)ᵗ by the shorter way
        fn sclerp(self, other: Self, t: Self::Real) -> Self;
        /// a(a*b)ᵗ without turning b to −b
        fn sclerp_long(self, other: Self, t: Self::Real) -> Self;
        /// sclerp(sclerp(σ₀, σ₁, t), sclerp(s₀, s₁, t), 2t(1−t)) from `self` to `end`
        fn squad(self, control_start: Self, control_end: Self, end: Self, t: Self::Real) -> Self;
        /// σ exp(−(log(σ*σ₊) + log(σ*σ₋))/4)
        fn squad_control(previous: Self, current: Self, next: Self) -> Self;

        /// θ, the angle of p_a*p_b, radians in [0, π]
        fn angle_to(self, other: Self) -> Self::Real;
        /// d = |t_a − t_b|
        fn distance_to(self, other: Self) -> Self::Real;
        /// √((λθ)² + d²)
        fn distance_weighted(self, other: Self, length_per_radian: Self::Real) -> Self::Real;
        /// |av − bv|
        fn point_error(self, other: Self, point: [Self::Real; 3]) -> Self::Real;
        /// d + 2 r sin(θ/2), at least |av − bv| for |v| ≤ r
        fn shell_error(self, other: Self, radius: Self::Real) -> Self::Real;
        /// The opposite of `is_unit`, within the tolerance.
        fn needs_renormalization(self, tolerance: Self::Real) -> Self::Mask;

        /// ½ξσ, ξ the spatial twist
        fn derivative_spatial(self, twist: Twist<Self::Real>) -> Self;
        /// ½σξ, ξ the body twist
        fn derivative_body(self, twist: Twist<Self::Real>) -> Self;
        /// 2σ̇σ*
        fn spatial_twist(self, derivative: Self) -> Twist<Self::Real>;
        /// 2σ*σ̇
        fn body_twist(self, derivative: Self) -> Twist<Self::Real>;
        /// ½ωr + ½ε(ṫr + ½tωr)
        fn derivative_from_velocity(self, angular: [Self::Real; 3], linear: [Self::Real; 3]) -> Self;
        /// (ω, ṫ)
        fn velocity(self, derivative: Self) -> ([Self::Real; 3], [Self::Real; 3]);
        /// exp(½ξ)
        fn from_twist(twist: Twist<Self::Real>) -> Self;
        /// 2 log σ
        fn to_twist(self) -> Twist<Self::Real>;
        /// 2 log(a*b) by the shorter way, a body twist
        fn twist_to(self, other: Self) -> Twist<Self::Real>;
        /// exp(½ξ dt) σ
        fn integrate_spatial(self, twist: Twist<Self::Real>, dt: Self::Real) -> Self;
        /// σ exp(½ξ dt)
        fn integrate_body(self, twist: Twist<Self::Real>, dt: Self::Real) -> Self;
        /// ω′ = Rω, v′ = Rv + t × ω′
        fn adjoint(self, twist: Twist<Self::Real>) -> Twist<Self::Real>;
        /// f′ = Rf, τ′ = Rτ + t × f′
        fn coadjoint(self, wrench: Wrench<Self::Real>) -> Wrench<Self::Real>;
        /// J_l(x) y, exp(½(x + δy)) ≈ exp(½δ J_l(x) y) exp(½x)
        fn left_jacobian(at: Twist<Self::Real>, along: Twist<Self::Real>) -> Twist<Self::Real>;
        /// J_r(x) y, exp(½(x + δy)) ≈ exp(½x) exp(½δ J_r(x) y)
        fn right_jacobian(at: Twist<Self::Real>, along: Twist<Self::Real>) -> Twist<Self::Real>;
        /// J_l⁻¹(x) y, infinite at |ω| = 2π
        fn left_jacobian_inverse(at: Twist<Self::Real>, along: Twist<Self::Real>) -> Twist<Self::Real>;
        /// J_r⁻¹(x) y, infinite at |ω| = 2π
        fn right_jacobian_inverse(at: Twist<Self::Real>, along: Twist<Self::Real>)
        -> Twist<Self::Real>;
    }
}
