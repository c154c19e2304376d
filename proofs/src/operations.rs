//! The operations that are recorded: one line each, for single motions and for lanes alike, as dq8 has them.

/// An operation: what goes in and comes out, in groups of numbers whose length is that of a vector.
#[derive(Clone, Copy, Debug)]
pub struct Operation {
    /// As in dq8.
    pub name: &'static str,
    /// Its arguments: letter, and how many numbers.
    pub inputs: &'static [(&'static str, usize)],
    /// Its answer, part by part.
    pub parts: &'static [(&'static str, usize)],
}

impl Operation {
    /// The argument that each number belongs to.
    #[must_use]
    pub fn groups(&self) -> Vec<usize> {
        let groups = self.inputs.iter().enumerate();
        groups.flat_map(|(group, &(_, count))| std::iter::repeat_n(group, count)).collect()
    }
    /// The part that each number of the answer belongs to.
    pub fn names(&self) -> impl Iterator<Item = &'static str> + use<> {
        self.parts.iter().flat_map(|&(name, count)| std::iter::repeat_n(name, count))
    }
}

/// Which code computes it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Form {
    /// One motion of floats.
    Single,
    /// Lanes, of which one is recorded.
    Lanes,
    /// A job over slices, on the packed lanes of one motion.
    Job,
    /// Functions of one number on lanes, in the range of their polynomials.
    Function,
}

impl Form {
    /// Those that are bounded by lengths.
    pub const BY_LENGTHS: [Self; 3] = [Self::Single, Self::Lanes, Self::Job];
    /// All.
    pub const ALL: [Self; 4] = [Self::Single, Self::Lanes, Self::Job, Self::Function];
    /// As in `bounds.toml`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Single => "single",
            Self::Lanes => "lanes",
            Self::Job => "job",
            Self::Function => "function",
        }
    }
    /// What there is in this form.
    #[must_use]
    pub fn operations(self) -> &'static [Operation] {
        match self {
            Self::Job => jobs::OPERATIONS,
            Self::Function => functions::OPERATIONS,
            _ => OPERATIONS,
        }
    }
}

fn three<T: Copy>(rows: impl IntoIterator<Item = impl IntoIterator<Item = T>>) -> Vec<T> {
    rows.into_iter().flatten().collect()
}

/// Rows of the table: names, arguments and answers.
macro_rules! rows { ($($name:ident($($input:ident $count:literal),*) -> ($($part:ident $parts:literal),*);)*) => {
    &[$(Operation {
        name: stringify!($name),
        inputs: &[$((stringify!($input), $count)),*],
        parts: &[$((stringify!($part), $parts)),*],
    }),*]
} }

macro_rules! table { ($($name:ident($($input:ident $count:literal),*) -> ($($part:ident $parts:literal),*) = $body:expr;)*) => {
    /// Every operation that is one path of + − · / √.
    pub const OPERATIONS: &[Operation] =
        rows! { $($name($($input $count),*) -> ($($part $parts),*);)* };
    operations! { single dq8::Scalar; dq8::DualQuat; dq8::Quat; dq8::Dual; dq8::Motion; $($name($($input $count),*) = $body;)* }
    operations! { lanes dq8::Lanes; dq8::batch::DualQuat; dq8::batch::Quat; dq8::batch::Dual; dq8::Motion; $($name($($input $count),*) = $body;)* }
} }

macro_rules! operations {
    ($form:ident $number:path; $motion:path; $quat:path; $dual:path; $contract:path; $($name:ident($($input:ident $count:literal),*) = $body:expr;)*) => {
        /// The operations in one form.
        pub mod $form {
            use super::three;
            use $number as Number;
            use $motion as DualQuat;
            use $quat as Quat;
            use $dual as Dual;
            use $contract as Motion;
            use dq8::geometry::Wrench;
            use dq8::{Line, Plane, Twist};

            fn motion<T: Number>([px, py, pz, pw]: [T; 4], [qx, qy, qz, qw]: [T; 4]) -> DualQuat<T> {
                DualQuat::from_array([px, py, pz, pw, qx, qy, qz, qw])
            }
            fn quat<T: Number>(p: [T; 4]) -> Quat<T> {
                Quat::from_array(p)
            }
            fn numbers<T: Number>(motion: DualQuat<T>) -> Vec<T> {
                motion.to_array().to_vec()
            }
            fn taken<T: Copy, const N: usize>(from: &mut &[T]) -> [T; N] {
                let (first, rest) = from.split_first_chunk().expect("as many as the table says");
                *from = rest;
                *first
            }

            /// The numbers of the answer.
            ///
            /// # Panics
            /// Of a name that is not in the table.
            #[inline(always)]
            pub fn run<T: Number>(name: &str, mut from: &[T]) -> Vec<T> {
                match name {
                    $(stringify!($name) => {
                        $(let $input: [T; $count] = taken(&mut from);)*
                        $body
                    })*
                    _ => panic!("no operation {name}"),
                }
            }
        }
    };
}

table! {
    from_rotation(p 4) -> (real 4, dual 4) = numbers(DualQuat::from_rotation(quat(p)));
    from_translation(v 3) -> (real 4, dual 4) = {
        let translation = DualQuat::from_translation(v).to_array();
        translation.to_vec()
    };
    from_rotation_translation(p 4, v 3) -> (real 4, dual 4) = numbers(DualQuat::from_rotation_translation(quat(p), v));
    from_translation_rotation(p 4, v 3) -> (real 4, dual 4) = numbers(DualQuat::from_translation_rotation(v, quat(p)));
    mul_rotation_translation(p 4, q 4, r 4, v 3) -> (real 4, dual 4) =
        numbers(motion(p, q).mul_rotation_translation(quat(r), v));
    rotation(p 4, q 4) -> (rotation 4) = motion(p, q).rotation().to_array().to_vec();
    translation(p 4, q 4) -> (translation 3) = motion(p, q).translation().to_vec();
    to_matrix3x4(p 4, q 4) -> (rotation 3, translation 1, rotation 3, translation 1, rotation 3, translation 1) = three(motion(p, q).to_matrix3x4());
    to_matrix4(p 4, q 4) -> (rotation 3, translation 1, rotation 3, translation 1, rotation 3, translation 1) = three(motion(p, q).to_matrix4())[..12].to_vec();
    conjugate_dual(p 4, q 4) -> (real 4, dual 4) = numbers(motion(p, q).conjugate_dual());
    conjugate(p 4, q 4) -> (real 4, dual 4) = numbers(motion(p, q).conjugate());
    conjugate_both(p 4, q 4) -> (real 4, dual 4) = numbers(motion(p, q).conjugate_both());
    canonical(p 4, q 4) -> (real 4, dual 4) = numbers(motion(p, q).canonical());
    scale(p 4, q 4, c 1) -> (real 4, dual 4) = numbers(motion(p, q).scale(c[0]));
    scale_dual(p 4, q 4, c 1, d 1) -> (real 4, dual 4) = numbers(motion(p, q).scale_dual(Dual::new(c[0], d[0])));
    dot(p 4, q 4, r 4, s 4) -> (real 1, dual 1) = {
        let dot = motion(p, q).dot(motion(r, s));
        vec![dot.real, dot.dual]
    };
    norm(p 4, q 4) -> (real 1, dual 1) = {
        let norm = motion(p, q).norm();
        vec![norm.real, norm.dual]
    };
    normalize(p 4, q 4) -> (real 4, dual 4) = numbers(motion(p, q).normalize());
    normalize_checked(p 4, q 4) -> (real 4, dual 4) = numbers(Motion::normalize_checked(motion(p, q)).0);
    inverse(p 4, q 4) -> (real 4, dual 4) = numbers(Motion::inverse(motion(p, q)));
    inverse_checked(p 4, q 4) -> (real 4, dual 4) = numbers(Motion::inverse_checked(motion(p, q)).0);
    add(p 4, q 4, r 4, s 4) -> (real 4, dual 4) = numbers(motion(p, q) + motion(r, s));
    sub(p 4, q 4, r 4, s 4) -> (real 4, dual 4) = numbers(motion(p, q) - motion(r, s));
    neg(p 4, q 4) -> (real 4, dual 4) = numbers(-motion(p, q));
    mul(p 4, q 4, r 4, s 4) -> (real 4, dual 4) = numbers(motion(p, q) * motion(r, s));
    nlerp(p 4, q 4, r 4, s 4, t 1) -> (real 4, dual 4) = numbers(motion(p, q).nlerp(motion(r, s), t[0]));
    dlb(p 4, q 4, r 4, s 4, v 4, w 4, a 1, b 1, c 1) -> (real 4, dual 4) = {
        let influences = [(motion(p, q), a[0]), (motion(r, s), b[0]), (motion(v, w), c[0])];
        numbers(DualQuat::dlb(&influences).expect("three"))
    };
    dlb_running(p 4, q 4, r 4, s 4, v 4, w 4, a 1, b 1, c 1) -> (real 4, dual 4) = {
        let influences = [(motion(p, q), a[0]), (motion(r, s), b[0]), (motion(v, w), c[0])];
        numbers(DualQuat::dlb_running(&influences).expect("three"))
    };
    quat_nlerp(p 4, r 4, t 1) -> (quaternion 4) = quat(p).nlerp(quat(r), t[0]).to_array().to_vec();
    transform_point(p 4, q 4, v 3) -> (point 3) = motion(p, q).transform_point(v).to_vec();
    transform_vector(p 4, q 4, v 3) -> (vector 3) = motion(p, q).transform_vector(v).to_vec();
    transform_line(p 4, q 4, v 3, w 3) -> (direction 3, moment 3) = {
        let line = motion(p, q).transform_line(Line { direction: v, moment: w });
        three([line.direction, line.moment])
    };
    transform_plane(p 4, q 4, v 3, d 1) -> (normal 3, offset 1) = {
        let plane = motion(p, q).transform_plane(Plane { normal: v, offset: d[0] });
        let [x, y, z] = plane.normal;
        vec![x, y, z, plane.offset]
    };
    derivative_spatial(p 4, q 4, v 3, w 3) -> (real 4, dual 4) =
        numbers(motion(p, q).derivative_spatial(Twist { angular: v, linear: w }));
    derivative_body(p 4, q 4, v 3, w 3) -> (real 4, dual 4) =
        numbers(motion(p, q).derivative_body(Twist { angular: v, linear: w }));
    spatial_twist(p 4, q 4, r 4, s 4) -> (angular 3, linear 3) = motion(p, q).spatial_twist(motion(r, s)).to_array().to_vec();
    body_twist(p 4, q 4, r 4, s 4) -> (angular 3, linear 3) = motion(p, q).body_twist(motion(r, s)).to_array().to_vec();
    derivative_from_velocity(p 4, q 4, v 3, w 3) -> (real 4, dual 4) = numbers(motion(p, q).derivative_from_velocity(v, w));
    velocity(p 4, q 4, r 4, s 4) -> (angular 3, linear 3) = {
        let (angular, linear) = motion(p, q).velocity(motion(r, s));
        three([angular, linear])
    };
    adjoint(p 4, q 4, v 3, w 3) -> (angular 3, linear 3) =
        motion(p, q).adjoint(Twist { angular: v, linear: w }).to_array().to_vec();
    coadjoint(p 4, q 4, v 3, w 3) -> (force 3, torque 3) = {
        let wrench = motion(p, q).coadjoint(Wrench { force: v, torque: w });
        three([wrench.force, wrench.torque])
    };
    quat_mul(p 4, r 4) -> (quaternion 4) = (quat(p) * quat(r)).to_array().to_vec();
    quat_rotate(p 4, v 3) -> (vector 3) = quat(p).rotate(v).to_vec();
    quat_normalize(p 4) -> (quaternion 4) = quat(p).normalize().to_array().to_vec();
    quat_dot(p 4, r 4) -> (dot 1) = vec![quat(p).dot(quat(r))];
}

/// Jobs over slices.
pub mod jobs {
    use super::Operation;
    use dq8::hierarchy::{Hierarchy, Poses};
    use dq8::skinning::{Blender, DualBlend, Linear, Skin, Surface, SurfaceMut, Weight};
    use dq8::storage::Aos;
    use dq8::{Backend, DualQuat, Quat, Scalar, Twist};
    use dq8_robot::{Joint, JointValues, Mechanism, Step, World};

    /// A joint under its parent: what forward kinematics repeats; a model times its inverse bind, as a matrix; skins of four
    /// joints, all of whose real parts are an argument, and all of whose dual parts; and what such a sum does to a point.
    pub const OPERATIONS: &[Operation] = rows! {
        local_to_model(p 4, q 4, r 4, s 4) -> (real 4, dual 4);
        palette(p 4, q 4, r 4, s 4) ->
            (rotation 3, translation 1, rotation 3, translation 1, rotation 3, translation 1);
        linear_skin(a 12, b 12, c 12, d 12, w 4, v 3) -> (point 3);
        scaled_point(p 4, q 4, v 3) -> (point 3);
        dual_skin(p 16, q 16, w 4, v 3) -> (point 3);
        linear_normal(a 12, b 12, c 12, d 12, w 4, v 3) -> (normal 3);
        unit_normal(v 3) -> (unit 3);
        dual_normal(p 16, w 4, v 3) -> (normal 3);
        scaled_normal(p 4, v 3) -> (normal 3);
        link_jacobian(p 4, v 3) -> (angular 3, linear 3);
        jacobians(p 4, v 3) -> (angular 3, linear 3);
    };

    /// The numbers of the answer.
    ///
    /// # Panics
    /// Of a name that is not in the table.
    pub fn run<R: Scalar + Weight + JointValues<Aos<R>>>(
        name: &str,
        backend: Backend,
        from: &[R],
    ) -> Vec<R> {
        let quat = |at: usize| core::array::from_fn::<R, 4, _>(|i| from[at + i]);
        let real = |at: usize| Quat::from_array(quat(at));
        let motion = |real: usize, dual: usize| {
            let ([px, py, pz, pw], [qx, qy, qz, qw]) = (quat(real), quat(dual));
            DualQuat::from_array([px, py, pz, pw, qx, qy, qz, qw])
        };
        let (parents, mut models) = ([Hierarchy::ROOT, 0], [DualQuat::IDENTITY; 2]);
        let job =
            |joints: usize| Hierarchy::new(&parents[..joints]).expect("a root, and its child");
        match name {
            "local_to_model" => {
                let locals = [motion(0, 4), motion(8, 12)];
                job(2)
                    .job()
                    .backend(backend)
                    .local_to_model(&locals, &mut models)
                    .expect("two of each");
                models[1].to_array().to_vec()
            }
            "palette" => {
                let (locals, binds, mut matrix) =
                    ([motion(0, 4)], [motion(8, 12)], [[[R::ZERO; 4]; 3]]);
                let job = job(1).job().backend(backend);
                job.palette(Poses(&locals), &mut models[..1], &binds, &mut matrix)
                    .expect("one each");
                matrix.as_flattened().as_flattened().to_vec()
            }
            "linear_skin" | "linear_normal" => {
                let palette = [0, 12, 24, 36].map(|at| [0, 4, 8].map(|row| quat(at + row)));
                skinned(name, Linear::new(&palette), quat(48), &from[52..], backend)
            }
            "unit_normal" => {
                let identity = DualQuat::IDENTITY.to_matrix3x4();
                let weights = [R::ONE, R::ZERO, R::ZERO, R::ZERO];
                skinned(name, Linear::new(&[identity; 4]), weights, from, backend)
            }
            "dual_skin" => {
                let palette = [0, 4, 8, 12].map(|at| motion(at, 16 + at));
                skinned(name, DualBlend::new(&palette), quat(32), &from[36..], backend)
            }
            "dual_normal" => {
                let palette = [0, 4, 8, 12].map(|at| DualQuat::from_rotation(real(at)));
                skinned(name, DualBlend::new(&palette), quat(16), &from[20..], backend)
            }
            // With a joint that adds nothing, so that its weight is not all there is.
            "scaled_point" | "scaled_normal" => {
                let none = DualQuat::ZERO;
                let (first, rest) = match name {
                    "scaled_point" => (motion(0, 4), &from[8..]),
                    _ => (DualQuat::from_rotation(real(0)), &from[4..]),
                };
                let (palette, weights) =
                    ([first, none, none, none], [R::ZERO, R::ZERO, R::ONE, R::ONE]);
                skinned(name, DualBlend::new(&palette), weights, rest, backend)
            }
            // A hinge about z on a body at p and v, and no need to know how it is turned.
            "link_jacobian" | "jacobians" => {
                let z = [R::ZERO, R::ZERO, R::ONE];
                let joints = [
                    Joint::floating(None, DualQuat::IDENTITY),
                    Joint::revolute(Some(0), DualQuat::IDENTITY, z),
                ];
                let mut steps = [Step::default(); 2];
                let arm = Mechanism::new(&joints, &mut steps).expect("a body and a hinge");
                let (values, zero) = ([from, &[R::ONE]].concat(), Twist::from_array([R::ZERO; 6]));
                let (mut columns, mut pose) = ([zero; 7], [DualQuat::IDENTITY]);
                if name == "jacobians" {
                    let job = arm.job().backend(backend).links(&[1]);
                    job.jacobians(World, &values, &mut pose, &mut columns).expect("one");
                } else {
                    arm.link_jacobian(World, &values, 1, &mut columns).expect("one");
                }
                columns[6].to_array().to_vec()
            }
            _ => panic!("no job {name}"),
        }
    }

    /// A point, or a normal.
    fn skinned<R: Scalar + Weight>(
        name: &str,
        blend: impl Blender<R>,
        weights: [R; 4],
        vector: &[R],
        backend: Backend,
    ) -> Vec<R> {
        // Weights of either sign, for all that draws numbers; the last first, for the recorded one is the greatest.
        let [d, c, b, a] = weights.map(|w| if w < R::ZERO { -w } else { w });
        let weights = [a, b, c, d];
        let skin = Skin::new(4, 4, &[0_u8, 1, 2, 3], &weights).expect("four joints");
        let (vector, zero) = ([*vector.first_chunk().expect("three numbers")], [[R::ZERO; 3]]);
        let (mut point, mut normal) = (zero, zero);
        let (mut rest, mut posed) =
            (Surface::positions(&vector), SurfaceMut::positions(&mut point));
        if name.contains("normal") {
            (rest, posed) = (rest.normals(&vector), posed.normals(&mut normal));
        }
        skin.job().backend(backend).pose(blend, rest, posed).expect("one vertex");
        if name.contains("normal") { normal[0].to_vec() } else { point[0].to_vec() }
    }
}

/// Functions on lanes that have polynomials in them: of one number, and of motions.
pub mod functions {
    use super::Operation;
    use dq8::Lanes;
    use dq8::batch::{Dual, DualQuat, even};
    use dq8::geometry::DualVector;

    /// From 0 to where the range of the polynomials ends.
    #[must_use]
    pub fn end(name: &str) -> f64 {
        match name {
            "arc_over_chord" => 2.0,
            "cos_sinc" => 2.5,
            _ => 10.0,
        }
    }

    /// Of one number without their derivatives.
    pub const OPERATIONS: &[Operation] = rows! {
        arc_over_chord(v 1) -> (arc 1);
        cos_sinc(v 1) -> (cos 1, sinc 1);
        integrals(v 1) -> (first 1, second 1);
        half_cotangent(v 1) -> (half 1);
        log(p 4, q 4) -> (real 3, dual 3);
        exp(v 3, w 3) -> (real 4, dual 4);
        pow(p 4, q 4, t 1) -> (real 4, dual 4);
        sqrt(p 4, q 4) -> (real 4, dual 4);
        sclerp(p 4, q 4, r 4, s 4, t 1) -> (real 4, dual 4);
    };

    /// The numbers of the answer.
    ///
    /// # Panics
    /// Of a name that is not in the table.
    #[inline(always)]
    pub fn run<L: Lanes>(name: &str, from: &[L]) -> Vec<L> {
        let v = Dual::new(from[0], from[0].constant(0.0));
        let both = |(a, b): (Dual<L>, Dual<L>)| vec![a.real, b.real];
        let motion =
            |at: usize| DualQuat::from_array(*from[at..].first_chunk().expect("8 numbers"));
        let numbers = |motion: DualQuat<L>| motion.to_array().to_vec();
        match name {
            "arc_over_chord" => vec![even::arc_over_chord(v).real],
            "cos_sinc" => both(even::cos_sinc(v)),
            "integrals" => both(even::exponential_integrals(v)),
            "half_cotangent" => vec![even::half_cotangent(v).real],
            "log" => {
                let log = motion(0).log();
                [log.real, log.dual].concat()
            }
            "exp" => {
                let [real, dual] = [0, 3].map(|at| *from[at..].first_chunk().expect("6 numbers"));
                numbers(DualQuat::exp(DualVector { real, dual }))
            }
            "pow" => numbers(motion(0).pow(from[8])),
            "sqrt" => numbers(motion(0).sqrt()),
            "sclerp" => numbers(motion(0).sclerp(motion(8), from[16])),
            _ => panic!("no function {name}"),
        }
    }
}
