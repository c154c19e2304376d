//! The kernels that compute each element from one element of every input, declared once in
//! [`for_each_kernel`](crate::__for_each_kernel), and the macros that make methods of that list.

use super::sweep::{SliceKernel, Things, sweep};
use crate::backend::Backend;
use crate::batch::DualQuat;
use crate::storage::shape::{ShapeError, same_length};
use crate::storage::{Element, Number, Register, Source, Tile, identity};
use core::ops::Range;
use dq8_simd::{Lanes, Level};

/// Calls the macro `callback` with the given tokens and the list of all kernels, each in this form:
///
/// ```text
/// /// Sentences about the output, which C users read too.
/// name as "name in C" [E: numbers of a record, T: numbers of another]
///     (input: kind E, other: kind T; parameter) -> output: kind E, in place name_in_place
///     = one element of the output, {
///     /// The rest of the documentation.
/// }
/// ```
///
/// The type `E` of the first input decides on the layout of all slices. Kinds are those of
/// [`__record`]. The formula is the same text for one motion and for lanes. This list makes the
/// methods of [`Backend`] with their documentation, the table in the documentation of `slices`, the
/// functions in C, the page of operations, and the tests of all of them.
#[macro_export]
#[doc(hidden)]
macro_rules! __for_each_kernel {
    ($($callback:ident)::+ $(, $($given:tt)*)?) => {
        $($callback)::+! { $($($given)*,)?

    /// Computes the products `a[i] b[i]`, in which b acts first.
    mul[M: 8](a: any M, b: any M) -> products: any M, in place mul_in_place = a * b, {
        /// Each product is `products[i]` = aᵢbᵢ.
        ///
        /// ```
        /// use dq8::{Backend, DualQuat};
        /// let step = [DualQuat::from_translation([1.0_f32, 0.0, 0.0]); 3];
        /// let mut two = [DualQuat::IDENTITY; 3];
        /// Backend::best().mul(&step, &step, &mut two)?;
        /// assert_eq!(two[2].translation(), [2.0, 0.0, 0.0]);
        /// # Ok::<(), dq8::ShapeError>(())
        /// ```
    }

    /// Normalizes `motions` to unit motions, exactly; NaN where there is none.
    normalize[M: 8](motions: any M) -> units: unit M, in place normalize_in_place
        = motions.normalize(), {
        /// Each result is `units[i]` = σᵢ/√(σᵢσᵢ*) of the motion σᵢ. Some component
        /// is NaN where this unit motion does not exist (see
        /// [`Motion::normalize_checked`](crate::Motion::normalize_checked)).
        ///
        /// ```
        /// use dq8::{Backend, DualQuat};
        /// let twice = [DualQuat::from_translation([1.0_f32, 2.0, 3.0]).scale(2.0); 5];
        /// let mut units = [DualQuat::ZERO; 5];
        /// Backend::best().normalize(&twice, &mut units)?;
        /// assert_eq!(units[4].translation(), [1.0, 2.0, 3.0]);
        /// # Ok::<(), dq8::ShapeError>(())
        /// ```
    }

    /// Computes the inverses of `motions` of any norm; NaN or infinite where there is none.
    inverse[M: 8](motions: any M) -> inverses: any M, in place inverse_in_place
        = motions.inverse(), {
        /// Each result is `inverses[i]` = σᵢ⁻¹ of the motion σᵢ. Some component is NaN or
        /// infinite where the inverse does not exist (see
        /// [`Motion::inverse_checked`](crate::Motion::inverse_checked)).
        ///
        /// ```
        /// use dq8::{Backend, DualQuat};
        /// let far = [DualQuat::from_translation([1.0_f32, 2.0, 4.0]).scale(2.0); 5];
        /// let (mut inverses, mut one) = (far, far);
        /// Backend::best().inverse(&far, &mut inverses)?;
        /// Backend::best().mul(&far, &inverses, &mut one)?;
        /// assert_eq!(one, [DualQuat::IDENTITY; 5]);
        /// # Ok::<(), dq8::ShapeError>(())
        /// ```
    }

    /// Computes the inverses of unit `motions`, which only flips signs.
    conjugate[M: 8](motions: any M) -> conjugates: any M, in place conjugate_in_place
        = motions.conjugate(), {
        /// Each result is `conjugates[i]` = σᵢ* = p* + εq* of the motion σᵢ = p + εq.
        ///
        /// ```
        /// use dq8::{Backend, DualQuat};
        /// let there = [DualQuat::from_translation([1.0_f32, 2.0, 3.0]); 5];
        /// let mut back = there;
        /// Backend::best().conjugate(&there, &mut back)?;
        /// assert_eq!(back[4].translation(), [-1.0, -2.0, -3.0]);
        /// # Ok::<(), dq8::ShapeError>(())
        /// ```
    }

    /// Interpolates linearly from `a[i]` (t = 0) to `b[i]` (t = 1) by the shorter way, and
    /// normalizes.
    nlerp[M: 8](a: unit M, b: unit M; t) -> between: unit M = a.nlerp(b, t), {
        /// Each result is `between[i]` = normalize((1−t)aᵢ ± tbᵢ), with the sign that takes
        /// the shorter way; see [`DualQuat::nlerp`](crate::DualQuat::nlerp).
        ///
        /// ```
        /// use dq8::{Backend, DualQuat};
        /// let at = |x| [DualQuat::from_translation([x, 0.0_f32, 0.0]); 5];
        /// let mut between = at(0.0);
        /// Backend::best().nlerp(&at(0.0), &at(4.0), 0.25, &mut between)?;
        /// assert_eq!(between[4].translation(), [1.0, 0.0, 0.0]);
        /// # Ok::<(), dq8::ShapeError>(())
        /// ```
    }

    /// Interpolates like `nlerp`, with a number `t[i]` for each pair.
    nlerp_each[M: 8, T: 1](a: unit M, b: unit M, t: number T) -> between: unit M
        = a.nlerp(b, t), {
        /// The values of `t` have the element type of the motions: for `f32` write `&[0.5_f32; 4]`,
        /// because literals without a suffix are `f64`. See [`nlerp`](Self::nlerp).
    }

    /// Interpolates from unit `a[i]` (t = 0) to unit `b[i]` (t = 1) by the shorter way, along
    /// one screw at constant speed.
    sclerp[M: 8](a: unit M, b: unit M; t) -> between: unit M = a.sclerp(b, t), {
        /// Each result is `between[i]` = aᵢ(aᵢ*bᵢ)ᵗ; see
        /// [`DualQuat::sclerp`](crate::DualQuat::sclerp).
        ///
        /// ```
        /// use dq8::{Backend, DualQuat};
        /// let at = |x| [DualQuat::from_translation([x, 0.0_f32, 0.0]); 5];
        /// let (a, b) = (at(0.0), at(4.0));
        /// let mut between = a;
        /// Backend::best().sclerp(&a, &b, 0.25, &mut between)?;
        /// assert_eq!(between[4].translation(), [1.0, 0.0, 0.0]);
        /// let t = [0.0_f32, 0.25, 0.5, 0.75, 1.0];
        /// Backend::best().sclerp_each(&a, &b, &t, &mut between)?;
        /// assert_eq!(between[3].translation(), [3.0, 0.0, 0.0]);
        /// # Ok::<(), dq8::ShapeError>(())
        /// ```
    }

    /// Interpolates like `sclerp`, with a number `t[i]` for each pair.
    sclerp_each[M: 8, T: 1](a: unit M, b: unit M, t: number T) -> between: unit M
        = a.sclerp(b, t), {
        /// The values of `t` have the element type of the motions. The example of
        /// [`sclerp`](Self::sclerp) calls this method too.
    }

    /// Interpolates from unit `a[i]` (t = 0) to unit `b[i]` (t = 1): rotations turn at
    /// constant speed, translations go straight.
    slerp_lerp[M: 8](a: unit M, b: unit M; t) -> between: unit M = a.slerp_lerp(b, t), {
        /// Interpolates the rotations by SLERP and, independently, the translations by LERP; see
        /// [`DualQuat::slerp_lerp`](crate::DualQuat::slerp_lerp).
        ///
        /// ```
        /// use dq8::{Backend, DualQuat, Quat};
        /// let turn = Quat::from_rotation_z(core::f32::consts::FRAC_PI_2);
        /// let b = [DualQuat::from_rotation_translation(turn, [4.0, 0.0, 0.0]); 3];
        /// let mut between = b;
        /// Backend::best().slerp_lerp(&[DualQuat::IDENTITY; 3], &b, 0.25, &mut between)?;
        /// let [x, y, _] = between[2].translation();
        /// // Straight, where `sclerp` goes on an arc.
        /// assert!((x - 1.0).abs() < 1e-6 && y.abs() < 1e-6);
        /// # Ok::<(), dq8::ShapeError>(())
        /// ```
    }

    /// Interpolates like `slerp_lerp`, with a number `t[i]` for each pair.
    slerp_lerp_each[M: 8, T: 1](a: unit M, b: unit M, t: number T) -> between: unit M
        = a.slerp_lerp(b, t), {
        /// The values of `t` have the element type of the motions. See
        /// [`slerp_lerp`](Self::slerp_lerp).
    }

    /// Raises the unit `motions[i]` to the power `t[i]`: the same screw axis, t times the
    /// angle and the slide.
    pow_each[M: 8, T: 1](motions: unit M, t: number T) -> powers: unit M
        = motions.pow(t), {
        /// Each result is the power `powers[i]` = σᵢᵗ of the motion σᵢ, with its own t =
        /// `t[i]`; see [`DualQuat::pow`](crate::DualQuat::pow).
        ///
        /// ```
        /// use dq8::{Backend, DualQuat};
        /// let steps = [DualQuat::from_translation([2.0_f32, 4.0, 6.0]); 3];
        /// let mut powers = steps;
        /// Backend::best().pow_each(&steps, &[0.0_f32, 0.5, 1.0], &mut powers)?;
        /// assert_eq!(powers[1].translation(), [1.0, 2.0, 3.0]);
        /// # Ok::<(), dq8::ShapeError>(())
        /// ```
    }

    /// Computes the unit motions whose logarithms are `logs`, six numbers each.
    exp[L: 6, M: 8](logs: log L) -> motions: unit M = DualQuat::exp(logs), {
        /// Each result is `motions[i]` = exp(a + εb), where `logs[i]` has the three components of
        /// a, then those of b; see [`DualQuat::exp`](crate::DualQuat::exp). The example of
        /// [`log`](Self::log) calls this method too.
    }

    /// Computes the motions to which `twists`, six numbers each, angular part first, lead in
    /// one second.
    from_twist[T: 6, M: 8](twists: twist T) -> motions: unit M
        = DualQuat::from_twist(twists), {
        /// Each result is `motions[i]` = exp(½ξᵢ) of the twist ξᵢ; see
        /// [`DualQuat::from_twist`](crate::DualQuat::from_twist). The example of
        /// [`to_twist`](Self::to_twist) calls this method too.
    }

    /// Moves the unit `motions[i]` on by `dt` seconds of the body twists `twists[i]`, six
    /// numbers each, angular part first.
    integrate_body[M: 8, T: 6](motions: unit M, twists: twist T; dt) -> later: unit M
        = motions.integrate_body(twists, dt), {
        /// Each result is `later[i]` = σᵢ exp(½ξᵢ dt) of the motion σᵢ and the twist
        /// ξᵢ; see [`DualQuat::integrate_body`](crate::DualQuat::integrate_body).
        ///
        /// ```
        /// use dq8::{Backend, DualQuat, Twist};
        /// let poses = [DualQuat::from_translation([1.0_f32, 0.0, 0.0]); 3];
        /// let twists = [Twist { angular: [0.0; 3], linear: [0.0, 2.0, 0.0] }; 3];
        /// let mut later = poses;
        /// Backend::best().integrate_body(&poses, &twists, 0.5, &mut later)?;
        /// assert_eq!(later[2].translation(), [1.0, 1.0, 0.0]);
        /// # Ok::<(), dq8::ShapeError>(())
        /// ```
    }

    /// Computes the logarithms of unit `motions`, six numbers each: half the angle times the
    /// axis, and its moment. Twice that is the twist that leads there in one second.
    log[M: 8, L: 6](motions: unit M) -> logs: log L = motions.log(), {
        /// Each result is `logs[i]` = log σᵢ = (θ̂/2)(l + εm) = a + εb, where θ̂ is the
        /// dual angle and l + εm the screw axis of σᵢ. It is stored as the three components of
        /// a, then those of b; see [`DualQuat::log`](crate::DualQuat::log).
        ///
        /// ```
        /// use dq8::{Backend, DualQuat};
        /// let steps = [DualQuat::from_translation([2.0_f32, 4.0, 6.0]); 5];
        /// let (mut logs, mut back) = ([[0.0; 6]; 5], [DualQuat::ZERO; 5]);
        /// Backend::best().log(&steps, &mut logs)?;
        /// assert_eq!(logs[4], [0.0, 0.0, 0.0, 1.0, 2.0, 3.0]);
        /// Backend::best().exp(&logs, &mut back)?;
        /// assert_eq!(back, steps);
        /// # Ok::<(), dq8::ShapeError>(())
        /// ```
    }

    /// Computes the twists, six numbers each, angular part first, that lead to unit `motions`
    /// in one second.
    to_twist[M: 8, T: 6](motions: unit M) -> twists: twist T = motions.to_twist(), {
        /// Each result is the twist `twists[i]` = 2 log σᵢ of the motion σᵢ; see
        /// [`DualQuat::to_twist`](crate::DualQuat::to_twist).
        ///
        /// ```
        /// use dq8::{Backend, DualQuat, Twist};
        /// let steps = [DualQuat::from_translation([2.0_f32, 4.0, 6.0]); 5];
        /// let (mut twists, mut back) = ([Twist::ZERO; 5], [DualQuat::ZERO; 5]);
        /// Backend::best().to_twist(&steps, &mut twists)?;
        /// assert_eq!(twists[4].linear, [2.0, 4.0, 6.0]);
        /// Backend::best().from_twist(&twists, &mut back)?;
        /// assert_eq!(back, steps);
        /// # Ok::<(), dq8::ShapeError>(())
        /// ```
    }

    /// Computes the angles between unit `a[i]` and unit `b[i]`, radians in 0 to π, one number
    /// each.
    angles[M: 8, T: 1](a: unit M, b: unit M) -> angles: number T = a.angle_to(b), {
        /// Each angle is that of [`DualQuat::angle_to`](crate::DualQuat::angle_to).
        ///
        /// ```
        /// use dq8::{Backend, DualQuat, Quat};
        /// let turned = DualQuat::from_rotation(Quat::from_rotation_z(0.5_f32));
        /// let mut angles = [0.0_f32; 5];
        /// Backend::best().angles(&[DualQuat::IDENTITY; 5], &[turned; 5], &mut angles)?;
        /// assert!((angles[4] - 0.5).abs() < 1e-6);
        /// # Ok::<(), dq8::ShapeError>(())
        /// ```
    }

    /// Computes the distances between the translations of unit `a[i]` and unit `b[i]`, one
    /// number each.
    distances[M: 8, T: 1](a: unit M, b: unit M) -> distances: number T
        = a.distance_to(b), {
        /// Each result is `distances[i]` = |t_a − t_b| of the two translations; see
        /// [`DualQuat::distance_to`](crate::DualQuat::distance_to).
        ///
        /// ```
        /// use dq8::{Backend, DualQuat};
        /// let there = DualQuat::from_translation([0.0_f32, 3.0, 4.0]);
        /// let mut distances = [0.0_f32; 5];
        /// Backend::best().distances(&[DualQuat::IDENTITY; 5], &[there; 5], &mut distances)?;
        /// assert_eq!(distances, [5.0; 5]);
        /// # Ok::<(), dq8::ShapeError>(())
        /// ```
    }

    /// Moves `points[i]`, three numbers each, by the unit `motions[i]`.
    transform_points_each as "points_each" [M: 8, P: 3](motions: unit M, points: point P)
        -> moved: point P = motions.transform_point(points), {
        /// Each result is `moved[i]` = Rᵢ·`points[i]` + tᵢ, with the rotation Rᵢ and
        /// translation tᵢ of the motion.
        ///
        /// ```
        /// use dq8::{Backend, DualQuat};
        /// let steps = [1.0_f32, 2.0, 3.0].map(|x| DualQuat::from_translation([x, 0.0, 0.0]));
        /// let mut moved = [[0.0; 3]; 3];
        /// Backend::best().transform_points_each(&steps, &[[10.0, 0.0, 5.0]; 3], &mut moved)?;
        /// assert_eq!(moved[2], [13.0, 0.0, 5.0]);
        /// # Ok::<(), dq8::ShapeError>(())
        /// ```
    }

    /// Turns `vectors[i]`, three numbers each, by the unit `motions[i]`.
    transform_vectors_each as "vectors_each" [M: 8, P: 3](motions: unit M, vectors: vector P)
        -> turned: vector P = motions.transform_vector(vectors), {
        /// Each result is `turned[i]` = Rᵢ·`vectors[i]`, with the rotation Rᵢ of the motion.
        ///
        /// ```
        /// use dq8::{Backend, DualQuat, Quat};
        /// let half = DualQuat::from_rotation(Quat::from_xyzw(0.0_f32, 0.0, 1.0, 0.0));
        /// let mut turned = [[0.0; 3]; 5];
        /// let vectors = [[1.0, 2.0, 3.0]; 5];
        /// Backend::best().transform_vectors_each(&[half; 5], &vectors, &mut turned)?;
        /// assert_eq!(turned[4], [-1.0, -2.0, 3.0]);
        /// # Ok::<(), dq8::ShapeError>(())
        /// ```
    }

    /// Moves `lines[i]` by the unit `motions[i]`. A line is six numbers: its direction, and
    /// its moment p x direction of any point p on it (Plücker coordinates).
    transform_lines_each as "lines_each" [M: 8, P: 6](motions: unit M, lines: line P)
        -> moved: line P = motions.transform_line(lines), {
        /// Each result is `moved[i]` = Rᵢl + ε(Rᵢm + tᵢ × Rᵢl) of the line l + εm with
        /// direction l and moment m, where Rᵢ and tᵢ are the rotation and the translation of
        /// the motion; see [`Line`](crate::Line).
        ///
        /// ```
        /// use dq8::{Backend, DualQuat};
        /// // The axis x, carried up by 2: its moment is (0, 0, 2) × x.
        /// let up = [DualQuat::from_translation([0.0_f32, 0.0, 2.0])];
        /// let axis = [1.0, 0.0, 0.0, 0.0, 0.0, 0.0];
        /// let mut moved = [[0.0; 6]];
        /// Backend::best().transform_lines_each(&up, &[axis], &mut moved)?;
        /// assert_eq!(moved[0], [1.0, 0.0, 0.0, 0.0, 2.0, 0.0]);
        /// # Ok::<(), dq8::ShapeError>(())
        /// ```
    }

    /// Moves `planes[i]` by the unit `motions[i]`. A plane is four numbers: its unit normal
    /// n, and n . p of any point p on it.
    transform_planes_each as "planes_each" [M: 8, P: 4](motions: unit M, planes: plane P)
        -> moved: plane P = motions.transform_plane(planes), {
        /// Each result is the plane `moved[i]` = (n′, d′) of the plane (n, d) and the motion
        /// with rotation Rᵢ and translation tᵢ: n′ = Rᵢn and d′ = d + n′·tᵢ; see
        /// [`Plane`](crate::Plane).
        ///
        /// ```
        /// use dq8::{Backend, DualQuat};
        /// // The ground, carried up by 2.
        /// let up = [DualQuat::from_translation([5.0_f32, 0.0, 2.0])];
        /// let mut moved = [[0.0; 4]];
        /// Backend::best().transform_planes_each(&up, &[[0.0, 0.0, 1.0, 0.0]], &mut moved)?;
        /// assert_eq!(moved[0], [0.0, 0.0, 1.0, 2.0]);
        /// # Ok::<(), dq8::ShapeError>(())
        /// ```
    }

    /// Applies the adjoint of the unit `motions[i]` to `twists[i]`, six numbers, angular part
    /// first, which turns a body twist into the spatial one.
    transform_twists_each as "twists_each" [M: 8, T: 6](motions: unit M, twists: twist T)
        -> moved: twist T = motions.adjoint(twists), {
        /// Each result is the twist `moved[i]` = (ω′, v′) of the twist (ω, v) and the motion
        /// with rotation Rᵢ and translation tᵢ: ω′ = Rᵢω and v′ = Rᵢv + tᵢ ×
        /// ω′; see [`DualQuat::adjoint`](crate::DualQuat::adjoint).
        ///
        /// ```
        /// use dq8::{Backend, DualQuat, Twist};
        /// let away = [DualQuat::from_translation([1.0_f32, 0.0, 0.0])];
        /// let turning = Twist { angular: [0.0, 0.0, 1.0], linear: [0.0; 3] };
        /// let mut moved = [Twist::ZERO];
        /// Backend::best().transform_twists_each(&away, &[turning], &mut moved)?;
        /// assert_eq!(moved[0].linear, [0.0, -1.0, 0.0]);
        /// # Ok::<(), dq8::ShapeError>(())
        /// ```
    }
        }
    };
}

/// The kinds of records that kernels read and write. For each kind the macro gives the count of its
/// components, a record `from` an array of components, and the array `of` a record. Motions of the
/// kind `any` need not be unit. `DualQuat` is the scalar type or the type on lanes, as the caller
/// imports it.
#[macro_export]
#[doc(hidden)]
macro_rules! __record {
    (any) => {
        8
    };
    (unit) => {
        8
    };
    (number) => {
        1
    };
    (point) => {
        3
    };
    (vector) => {
        3
    };
    (plane) => {
        4
    };
    (line) => {
        6
    };
    (twist) => {
        6
    };
    (log) => {
        6
    };
    (any from $numbers:expr) => {
        DualQuat::from_array($numbers)
    };
    (unit from $numbers:expr) => {
        DualQuat::from_array($numbers)
    };
    (number from $numbers:expr) => {{
        let [number] = $numbers;
        number
    }};
    (point from $numbers:expr) => {
        $numbers
    };
    (vector from $numbers:expr) => {
        $numbers
    };
    (plane from $numbers:expr) => {{
        let [x, y, z, offset] = $numbers;
        $crate::Plane { normal: [x, y, z], offset }
    }};
    (line from $numbers:expr) => {{
        let [a, b, c, d, e, f] = $numbers;
        $crate::Line { direction: [a, b, c], moment: [d, e, f] }
    }};
    (twist from $numbers:expr) => {
        $crate::Twist::from_array($numbers)
    };
    (log from $numbers:expr) => {{
        let [a, b, c, d, e, f] = $numbers;
        $crate::geometry::DualVector { real: [a, b, c], dual: [d, e, f] }
    }};
    (number of $one:expr) => {
        [$one]
    };
    (point of $one:expr) => {
        $one
    };
    (vector of $one:expr) => {
        $one
    };
    (plane of $one:expr) => {{
        let $crate::Plane { normal: [x, y, z], offset } = $one;
        [x, y, z, offset]
    }};
    (line of $one:expr) => {{
        let $crate::Line { direction: [a, b, c], moment: [d, e, f] } = $one;
        [a, b, c, d, e, f]
    }};
    (log of $one:expr) => {{
        let $crate::geometry::DualVector { real: [a, b, c], dual: [d, e, f] } = $one;
        [a, b, c, d, e, f]
    }};
    // Motions and twists convert by a method.
    ($kind:ident of $one:expr) => {
        $one.to_array()
    };
}

/// The rows of the table in the documentation of `slices`.
#[macro_export]
#[doc(hidden)]
macro_rules! __kernels_table {
    ($(
        $(#[doc = $brief:literal])+
        $name:ident $(as $c:literal)? [$($types:tt)*] ($($inputs:tt)*)
            -> $output:ident: $result:ident $Q:ident $(, in place $in_place:ident)? = $one:expr, {
            $($more:tt)*
        }
    )*) => {
        concat!($(
            "| [`", stringify!($name), "`](crate::Backend::", stringify!($name), ")",
            $(", [`", stringify!($in_place), "`](crate::Backend::", stringify!($in_place), ")",)?
            " |", $($brief,)+ " |\n",
        )*)
    };
}

/// Defines the methods of [`Backend`], and for each a kernel in [`of_each`] with the method's name.
macro_rules! methods {
    ($(
        $(#[doc = $brief:literal])+
        $name:ident $(as $c:literal)? [$E:ident: $size:literal $(, $T:ident: $numbers:literal)?]
        ($input:ident: $kind:ident $I:ident $(, $other:ident: $others:ident $O:ident)* $(; $parameter:ident)?)
            -> $output:ident: $result:ident $Q:ident $(, in place $in_place:ident)? = $one:expr, {
            $(#[doc = $more:literal])*
        }
    )*) => {
        impl Backend {$(
            $(#[doc = $brief])+
            ///
            $(#[doc = $more])*
            ///
            /// # Errors
            #[doc = concat!("If the slices differ in length; `", stringify!($output), "` is untouched.")]
            #[inline]
            pub fn $name<$E: Element<$size> $(, $T: Element<$numbers, Layout = $E::Layout>)?>(
                self,
                $input: &[$I],
                $($other: &[$O],)*
                $($parameter: Number<$E, $size>,)?
                $output: &mut [$Q],
            ) -> Result<(), ShapeError> {
                $(same_length(stringify!($other), $other.len(), $input.len())?;)*
                same_length(stringify!($output), $output.len(), $input.len())?;
                let $input = input!($($in_place)? of $input);
                sweep(self, $output, of_each::$name { $input $(, $other)* $(, $parameter)? });
                Ok(())
            }

            in_place! {
                $name $($in_place)?
                [$E: $size]($input: $I $(, $other: $O)* $(; $parameter)?)
            }
        )*}

        /// The kernels, which have the names of their methods.
        #[allow(non_camel_case_types, reason = "they are called as their methods are")]
        mod of_each {
            use super::*;
            $(
                pub(super) struct $name<'s, $E: Element<$size> $(, $other)*> {
                    pub(super) $input: input!($($in_place)? as 's $I),
                    $(pub(super) $other: &'s [$other],)*
                    $(pub(super) $parameter: Number<$E, $size>,)?
                }

                impl<$E: Element<$size> $(, $T: Element<$numbers, Layout = $E::Layout>)?>
                    SliceKernel<$Q, { __record!($result) }> for $name<'_, $E $(, $O)*>
                {
                    fn reads_output(&self) -> bool {
                        input!($($in_place)? in self.$input)
                    }
                    #[cfg_attr(not(opt_level_0), inline(always))]
                    fn compute<V: Level>(
                        &self,
                        level: V,
                        output: &[$Q],
                        tile: Tile,
                    ) -> Things<$Q, V, { __record!($result) }> {
                        let _ = output;
                        let $input = input!($($in_place)? at self.$input, output);
                        let $input = __record!($kind from $I::load(level, $input, tile, &identity())?);
                        $(
                            let $other = $O::load(level, self.$other, tile, &identity())?;
                            let $other = __record!($others from $other);
                        )*
                        $(let $parameter = Register::<$E, V, $size>::splat(level, self.$parameter);)?
                        Some(__record!($result of $one))
                    }
                    fn part(&self, elements: Range<usize>) -> Option<Self> {
                        Some(Self {
                            $($other: self.$other.get(elements.clone())?,)*
                            $($parameter: self.$parameter,)?
                            $input: input!($($in_place)? part self.$input, elements)?,
                        })
                    }
                }
            )*
        }
    };
}

/// The first input of a kernel. If the kernel also has a method that works in place, its input is a
/// [`Source`]: a slice or the output itself. Otherwise it is a slice.
#[rustfmt::skip]
macro_rules! input {
    (of $slice:expr) => { $slice };
    (as $life:lifetime $I:ident) => { &$life [$I] };
    (in $input:expr) => { false };
    (at $input:expr, $output:expr) => { $input };
    (part $input:expr, $elements:expr) => { $input.get($elements) };
    ($in_place:ident of $slice:expr) => { Source::Slice($slice) };
    ($in_place:ident as $life:lifetime $I:ident) => { Source<$life, $I> };
    ($in_place:ident in $input:expr) => { $input.is_output() };
    ($in_place:ident at $input:expr, $output:expr) => { $input.or($output) };
    ($in_place:ident part $input:expr, $elements:expr) => { $input.part($elements) };
}

/// Defines the method that works in place, if the list of kernels names one. A method that takes no
/// other slice cannot fail, because no lengths can differ.
macro_rules! in_place {
    ($name:ident [$E:ident: $size:literal] $($inputs:tt)*) => {};
    ($name:ident $in_place:ident [$E:ident: $size:literal]($input:ident: $I:ident)) => {
        #[doc = concat!(
            "[`", stringify!($name), "`](Self::", stringify!($name), ") over `", stringify!($input),
            "` themselves."
        )]
        #[inline]
        pub fn $in_place<$E: Element<$size>>(self, $input: &mut [$I]) {
            sweep(self, $input, of_each::$name { $input: Source::Output });
        }
    };
    (
        $name:ident $in_place:ident [$E:ident: $size:literal]
        ($input:ident: $I:ident $(, $other:ident: $O:ident)+)
    ) => {
        #[doc = concat!(
            "[`", stringify!($name), "`](Self::", stringify!($name), ") over `", stringify!($input),
            "` itself."
        )]
        ///
        /// # Errors
        #[doc = concat!("If the slices differ in length; `", stringify!($input), "` is untouched.")]
        #[inline]
        pub fn $in_place<$E: Element<$size>>(
            self,
            $input: &mut [$I],
            $($other: &[$O],)+
        ) -> Result<(), ShapeError> {
            $(same_length(stringify!($other), $other.len(), $input.len())?;)+
            sweep(self, $input, of_each::$name { $input: Source::Output $(, $other)+ });
            Ok(())
        }
    };
}

__for_each_kernel!(methods);
