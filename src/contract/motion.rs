//! [`Motion`]: the contract that the motions of the scalar reference and of the lanes share.

use crate::contract::DualNumber;
use crate::contract::Quaternion;
use crate::contract::shared_trait;
use crate::geometry::{DualVector, Line, Mean, Plane, Screw, Twist, Wrench};
use core::fmt::Debug;
use core::ops::{Add, Mul, Neg, Sub};

shared_trait! {
    /// Dual quaternions σ = p + εq: a single dual quaternion ([`DualQuat`](crate::DualQuat)), or
    /// many, one per lane ([`batch::DualQuat`](crate::batch::DualQuat)).
    ///
    /// # Conventions
    ///
    /// - ε² = 0; p and q are quaternions. If |p| = 1 and p·q = 0, σ is called *unit* and is a
    ///   rigid motion.
    /// - The motion is *rotate by r, then translate by t*: σ = r + ½εtr, so r = p and t = 2qp*.
    /// - `a * b` lets `b` act first: `(a * b).transform_point(v)` is
    ///   `a.transform_point(b.transform_point(v))`, as with matrices on column vectors.
    /// - Points v move by σ(1 + εv)σ⋄, directions by the rotation r, lines by σ(l + εm)σ*.
    /// - σ and −σ are the same motion.
    /// - Angles are in radians, and lengths in the user's own unit. Vectors are `[T; 3]`, and
    ///   matrices are arrays of rows.
    ///
    /// Every rigid motion is a screw (Chasles): a turn about one line and a slide along it.
    ///
    #[doc = include_str!("screw.svg")]
    ///
    /// # Laws
    ///
    /// The laws hold up to rounding for finite values; the tests have a table of the tolerances.
    /// Names in the table are those of methods, and *unit* means that the motions must be unit.
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
    /// The laws above for *unit* σ hold only if |p| = 1 and p·q = 0 within rounding. They are the
    /// laws of rotation and translation, matrices, screws, `log`, `pow`, `sclerp`, points,
    /// directions, lines, planes, twists, distances, and `conjugate` as an inverse.
    /// `from_axis_angle` needs a unit axis, and `from_rotation` and other methods that take a
    /// rotation need a unit rotation. Products, sums, conjugates, `norm`, `normalize`, `inverse`,
    /// `nlerp` and `dlb` take any σ with p ≠ 0.
    ///
    /// By default no build checks that motions are unit: a kernel never panics, and a check of
    /// every motion would cost more than most operations. Debug builds with
    /// `RUSTFLAGS="--cfg dq8_debug_assert_unit"` check single motions: methods of
    /// [`DualQuat`](crate::DualQuat) and [`Quat`](crate::Quat) that need unit input panic at the
    /// caller's line where |p|² differs from 1 by more than 0.1, or p·q from 0 by more than 0.1
    /// max(1, |q|). A σ of norm 1 + δ gives results with a relative error of up to about 2δ; for
    /// a norm far from 1 the results of implementations may differ. Input from outside should be
    /// checked where it enters: `is_unit(tolerance)` and `is_normalized` test, `normalize` repairs,
    /// the methods `try_from_…` of matrices refuse, and `ik` and `dq8-robot` refuse joints and
    /// targets that are not unit.
    ///
    /// Constructors and interpolations return unit motions. Each product adds an error of about one
    /// rounding to the norm; `needs_renormalization` tells when it has become too large.
    ///
    /// The documentation of [`DualQuat`](crate::DualQuat) has the formula and the source of each
    /// operation. Users need not import this trait, because both types have every operation as a
    /// method of their own. No type outside this crate can implement it.
    trait Motion: Copy, Debug, Add<Output = Self>, Sub<Output = Self>, Mul<Output = Self>, Neg<Output = Self>;

    delegate by delegate_motion;

    types {
        /// The type of the value that functions need to make constants. It is `()` for scalars. For
        /// lanes it is a level, the proof that the CPU has their instructions.
        type Level: Copy;
        /// A real number, or a vector with a real number per lane.
        type Real: Copy
            + Debug
            + Add<Output = Self::Real>
            + Sub<Output = Self::Real>
            + Mul<Output = Self::Real>
            + Neg<Output = Self::Real>;
        /// A `bool`, or a mask with a truth value per lane.
        type Mask: Copy + Debug;
        /// A dual number, or one dual number per lane.
        type Dual: DualNumber<Real = Self::Real>;
        /// A quaternion, or one quaternion per lane.
        type Quat: Quaternion<Level = Self::Level, Real = Self::Real, Mask = Self::Mask>;
    }

    by_hand {
        /// Returns the identity motion, 1 + ε0.
        fn identity(level: Self::Level) -> Self;
        /// Returns σ/√(σσ*), and a mask that is `true` where this quotient does not exist,
        /// because p is zero or a component is not finite. There the first result is NaN.
        fn normalize_checked(self) -> (Self, Self::Mask);
        /// Returns σ⁻¹, and a mask that is `true` where the inverse does not exist, because p
        /// is zero or a component is not finite. There the first result is NaN.
        fn inverse_checked(self) -> (Self, Self::Mask);
    }

    inherent {
        /// Returns r + ε0, the rotation r about the origin.
        fn from_rotation(rotation: Self::Quat) -> Self;
        /// Returns 1 + ½εt, the translation by t.
        fn from_translation(translation: [Self::Real; 3]) -> Self;
        /// Returns r + ½εtr, which rotates by r, then translates by t.
        fn from_rotation_translation(rotation: Self::Quat, translation: [Self::Real; 3]) -> Self;
        /// Returns r + ½εrt, which translates by t, then rotates by r.
        fn from_translation_rotation(translation: [Self::Real; 3], rotation: Self::Quat) -> Self;
        /// Returns the product σ(r + ½εtr) with the motion of a rotation r and a translation t.
        fn mul_rotation_translation(self, rotation: Self::Quat, translation: [Self::Real; 3]) -> Self;
        /// Returns the motion of a rigid matrix, with p_w ≥ 0.
        fn from_matrix3x4(rows: [[Self::Real; 4]; 3]) -> Self;
        /// Returns cos(θ̂/2) + sin(θ̂/2)(l + εm), the motion of a screw.
        fn from_screw(screw: Screw<Self::Real>) -> Self;

        /// Returns the rotation r = p.
        fn rotation(self) -> Self::Quat;
        /// Returns the translation t = 2qp*.
        fn translation(self) -> [Self::Real; 3];
        /// Returns the rows of the matrix [R | t].
        fn to_matrix3x4(self) -> [[Self::Real; 4]; 3];
        /// Returns the rows of the matrix [R | t] and the row 0 0 0 1.
        fn to_matrix4(self) -> [[Self::Real; 4]; 4];
        /// Returns the screw of the canonical choice of ±σ.
        fn to_screw(self) -> Screw<Self::Real>;

        /// Returns σ• = p − εq.
        fn conjugate_dual(self) -> Self;
        /// Returns σ* = p* + εq*.
        fn conjugate(self) -> Self;
        /// Returns σ⋄ = p* − εq*.
        fn conjugate_both(self) -> Self;
        /// Returns whichever of σ and −σ has a positive first component, where components that
        /// are zero are skipped, in the order p_w, p_x, p_y, p_z.
        fn canonical(self) -> Self;
        /// Returns sσ for the real number s = `factor`.
        fn scale(self, factor: Self::Real) -> Self;
        /// Returns (a + εb)σ for the dual number a + εb = `factor`.
        fn scale_dual(self, factor: Self::Dual) -> Self;
        /// Returns the scalar product p_a·p_b + ε(p_a·q_b + q_a·p_b) of the motions a and b.
        fn dot(self, other: Self) -> Self::Dual;

        /// Returns the dual norm √(σσ*).
        fn norm(self) -> Self::Dual;
        /// Returns σ/√(σσ*), or NaN where this quotient does not exist.
        fn normalize(self) -> Self;
        /// Returns `true` where ||p| − 1| ≤ `tolerance` and |p·q| ≤
        /// `tolerance`·max(1, |q|).
        fn is_unit(self, tolerance: Self::Real) -> Self::Mask;
        /// Returns σ⁻¹; some component is NaN or infinite where σ⁻¹ does not exist.
        fn inverse(self) -> Self;
        /// Returns `true` where every component of `self` differs from that of `other` by at most
        /// `tolerance`.
        fn abs_diff_eq(self, other: Self, tolerance: Self::Real) -> Self::Mask;

        /// Returns the point Rv + t, with the rotation R and the translation t of σ.
        fn transform_point(self, point: [Self::Real; 3]) -> [Self::Real; 3];
        /// Returns the direction Rv, with the rotation R of σ.
        fn transform_vector(self, vector: [Self::Real; 3]) -> [Self::Real; 3];
        /// Returns the moved line Rl + ε(Rm + t × Rl), with the rotation R and the translation t
        /// of σ.
        fn transform_line(self, line: Line<Self::Real>) -> Line<Self::Real>;
        /// Returns the moved plane, with the normal n′ = Rn and the offset d′ = d + n′·t (R
        /// and t are the rotation and the translation of σ).
        fn transform_plane(self, plane: Plane<Self::Real>) -> Plane<Self::Real>;

        /// Returns normalize((1−t)a ± tb) with a = `self` and b = `other`, and the sign for
        /// which the way is shorter.
        fn nlerp(self, other: Self, t: Self::Real) -> Self;
        /// Returns normalize(Σ ±wᵢσᵢ) for influences (σᵢ, wᵢ), where each sign puts
        /// ±σᵢ on the side of the first motion; `None` if there are no influences.
        fn dlb(influences: &[(Self, Self::Real)]) -> Option<Self>;
        /// Returns normalize(Σ ±wᵢσᵢ) for influences (σᵢ, wᵢ), where each sign puts
        /// ±σᵢ on the side of the sum of the earlier influences; `None` if there are no
        /// influences.
        fn dlb_running(influences: &[(Self, Self::Real)]) -> Option<Self>;
        /// Returns the intrinsic mean b of influences (σᵢ, wᵢ), with Σ wᵢ log(b*σᵢ) = 0,
        /// by an iteration that ends when a step is at most `tolerance`; `None` if there are no
        /// influences.
        fn dib(
            influences: &[(Self, Self::Real)],
            tolerance: Self::Real,
            max_iterations: u32,
        ) -> Option<Mean<Self, Self::Real, Self::Mask>>;
        /// Returns the motion with the rotation slerp(r_a, r_b, t) and the translation (1−t)t_a +
        /// t t_b, which serves for comparisons with `sclerp`.
        fn slerp_lerp(self, other: Self, t: Self::Real) -> Self;

        /// Returns the logarithm (θ̂/2)(l + εm), with the dual angle θ̂ and the axis l + εm
        /// of the screw.
        fn log(self) -> DualVector<Self::Real>;
        /// Returns cos ĥ + sin ĥ (l + εm) for the logarithm ĥ(l + εm). On lanes, and for `f32`
        /// and `f64`, the result is NaN beyond a half angle of 2¹⁶ rad (`f32`) or 2⁴⁵ rad
        /// (`f64`). Powers and interpolations that reach such angles are NaN too.
        fn exp(log: DualVector<Self::Real>) -> Self;
        /// Returns the power σᵗ.
        fn pow(self, t: Self::Real) -> Self;
        /// Returns the square root √σ.
        fn sqrt(self) -> Self;
        /// Returns a(a*b)ᵗ, from a = `self` to b = `other` by the shorter way.
        fn sclerp(self, other: Self, t: Self::Real) -> Self;
        /// Returns a(a*b)ᵗ from a = `self` to b = `other`, and does not replace b by −b if the
        /// way to −b is shorter.
        fn sclerp_long(self, other: Self, t: Self::Real) -> Self;
        /// Returns sclerp(sclerp(σ₀, σ₁, t), sclerp(s₀, s₁, t), 2t(1−t)) from σ₀ =
        /// `self` to σ₁ = `end`, with the control poses s₀ and s₁.
        fn squad(self, control_start: Self, control_end: Self, end: Self, t: Self::Real) -> Self;
        /// Returns the control pose σ exp(−(log(σ*σ₊) + log(σ*σ₋))/4) of the key σ =
        /// `current` between the keys σ₋ = `previous` and σ₊ = `next`.
        fn squad_control(previous: Self, current: Self, next: Self) -> Self;

        /// Returns θ, the angle in [0, π] radians of the rotation p_a*p_b from a = `self` to b =
        /// `other`.
        fn angle_to(self, other: Self) -> Self::Real;
        /// Returns d = |t_a − t_b|, the distance between the translations.
        fn distance_to(self, other: Self) -> Self::Real;
        /// Returns √((λθ)² + d²) with θ from `angle_to`, d from `distance_to` and λ =
        /// `length_per_radian`.
        fn distance_weighted(self, other: Self, length_per_radian: Self::Real) -> Self::Real;
        /// Returns |av − bv|, the distance between the images of a point v under a = `self` and
        /// b = `other`.
        fn point_error(self, other: Self, point: [Self::Real; 3]) -> Self::Real;
        /// Returns d + 2 r sin(θ/2) with r = `radius`, which is at least |av − bv| for every
        /// point v with |v| ≤ r.
        fn shell_error(self, other: Self, radius: Self::Real) -> Self::Real;
        /// Returns the negation of `is_unit` with this tolerance.
        fn needs_renormalization(self, tolerance: Self::Real) -> Self::Mask;

        /// Returns the derivative σ̇ = ½ξσ for the spatial twist ξ.
        fn derivative_spatial(self, twist: Twist<Self::Real>) -> Self;
        /// Returns the derivative σ̇ = ½σξ for the body twist ξ.
        fn derivative_body(self, twist: Twist<Self::Real>) -> Self;
        /// Returns the spatial twist 2σ̇σ* for the derivative σ̇.
        fn spatial_twist(self, derivative: Self) -> Twist<Self::Real>;
        /// Returns the body twist 2σ*σ̇ for the derivative σ̇.
        fn body_twist(self, derivative: Self) -> Twist<Self::Real>;
        /// Returns the derivative σ̇ = ½ωr + ½ε(ṫr + ½tωr) for the velocities ω =
        /// `angular` and ṫ = `linear`.
        fn derivative_from_velocity(self, angular: [Self::Real; 3], linear: [Self::Real; 3]) -> Self;
        /// Returns the velocities (ω, ṫ) for the derivative σ̇ = `derivative`: the angular
        /// velocity and the velocity of the origin.
        fn velocity(self, derivative: Self) -> ([Self::Real; 3], [Self::Real; 3]);
        /// Returns exp(½ξ), the motion of a constant twist ξ in unit time.
        fn from_twist(twist: Twist<Self::Real>) -> Self;
        /// Returns 2 log σ, the constant twist that makes the motion in unit time.
        fn to_twist(self) -> Twist<Self::Real>;
        /// Returns the body twist 2 log(a*b) that takes a = `self` to b = `other` by the shorter
        /// way.
        fn twist_to(self, other: Self) -> Twist<Self::Real>;
        /// Returns exp(½ξ dt) σ for a constant spatial twist ξ.
        fn integrate_spatial(self, twist: Twist<Self::Real>, dt: Self::Real) -> Self;
        /// Returns σ exp(½ξ dt) for a constant body twist ξ.
        fn integrate_body(self, twist: Twist<Self::Real>, dt: Self::Real) -> Self;
        /// Returns the moved twist, ω′ = Rω and v′ = Rv + t × ω′, with the rotation R and
        /// the translation t of σ.
        fn adjoint(self, twist: Twist<Self::Real>) -> Twist<Self::Real>;
        /// Returns the moved wrench, f′ = Rf and τ′ = Rτ + t × f′, with the rotation R and
        /// the translation t of σ.
        fn coadjoint(self, wrench: Wrench<Self::Real>) -> Wrench<Self::Real>;
        /// Returns the left Jacobian J_l(x) applied to y, with x = `at`, y = `along` and exp(½(x +
        /// δy)) ≈ exp(½δ J_l(x) y) exp(½x) for small δ.
        fn left_jacobian(at: Twist<Self::Real>, along: Twist<Self::Real>) -> Twist<Self::Real>;
        /// Returns the right Jacobian J_r(x) applied to y, with x = `at`, y = `along` and
        /// exp(½(x + δy)) ≈ exp(½x) exp(½δ J_r(x) y) for small δ.
        fn right_jacobian(at: Twist<Self::Real>, along: Twist<Self::Real>) -> Twist<Self::Real>;
        /// Returns the inverse left Jacobian J_l⁻¹(x) applied to y, with x = `at` = ω + εv and
        /// y = `along`. It is infinite at |ω| = 2π.
        fn left_jacobian_inverse(at: Twist<Self::Real>, along: Twist<Self::Real>) -> Twist<Self::Real>;
        /// Returns the inverse right Jacobian J_r⁻¹(x) applied to y, with x = `at` = ω + εv
        /// and y = `along`. It is infinite at |ω| = 2π.
        fn right_jacobian_inverse(at: Twist<Self::Real>, along: Twist<Self::Real>)
        -> Twist<Self::Real>;
    }
}
