//! The operations that are recorded: one line each, for single motions and for lanes alike, as dq8
//! has them.

use dq8::batch::even;
use dq8::geometry::{DualVector, Wrench};
use dq8::hierarchy::{Bones, Hierarchy, Plan, PlanScratch, Poses};
use dq8::skinning::{Blender, DualBlend, Linear, Skin, Surface, SurfaceMut, Weight};
use dq8::{Backend, Lanes, Line, Plane, Scalar, ShapeError, Twist};
use dq8_robot::{Joint, Mechanism, Step, World};

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
    /// Functions on lanes that have polynomials in them, in the range of these: of one number, and
    /// of motions.
    Function,
}

impl Form {
    /// All.
    pub(crate) const ALL: [Self; 4] = [Self::Single, Self::Lanes, Self::Job, Self::Function];
    /// As in `bounds.toml`.
    #[must_use]
    pub fn name(self) -> &'static str {
        ["single", "lanes", "job", "function"][self as usize]
    }
    /// What there is in this form.
    #[must_use]
    pub fn operations(self) -> &'static [Operation] {
        [single::OPERATIONS, lanes::OPERATIONS, jobs::OPERATIONS, functions::OPERATIONS]
            [self as usize]
    }
    /// What computes an operation by its name: the numbers of the answer.
    #[must_use]
    pub fn run<R: Number + Lanes>(self) -> fn(&str, Backend, &[R]) -> Vec<R> {
        [single::run, lanes::run, jobs::run, functions::run][self as usize]
    }
}

/// What jobs compute with.
pub trait Number: Scalar + Weight {}
impl<R: Scalar + Weight> Number for R {}

/// A module with the rows of a table in one form.
macro_rules! operations {
    ($form:ident, |$backend:ident|, $number:path, $motion:path, $quat:path, $dual:path, $contract:path;
        $($name:ident($($input:ident $count:literal),*) -> ($($part:ident $parts:literal),*) = $body:expr;)*) => {
        #[allow(dead_code, unused_imports, reason = "not all of it in every form")]
        #[doc = concat!("The operations of the form `", stringify!($form), "`.")]
        pub mod $form {
            use super::*;
            use $number as Number;
            use $motion as DualQuat;
            use $quat as Quat;
            use $dual as Dual;
            use $contract as Motion;

            /// Names, arguments and answers.
            pub const OPERATIONS: &[Operation] = &[$(Operation {
                name: stringify!($name),
                inputs: &[$((stringify!($input), $count)),*],
                parts: &[$((stringify!($part), $parts)),*],
            }),*];

            fn motion<T: Number>([px, py, pz, pw]: [T; 4], [qx, qy, qz, qw]: [T; 4]) -> DualQuat<T> {
                DualQuat::from_array([px, py, pz, pw, qx, qy, qz, qw])
            }
            fn quat<T: Number>(p: [T; 4]) -> Quat<T> {
                Quat::from_array(p)
            }
            fn numbers<T: Number>(motion: DualQuat<T>) -> Vec<T> {
                motion.to_array().to_vec()
            }

            /// The numbers of the answer.
            ///
            /// # Panics
            /// Of a name that is not in the table.
            #[inline(always)]
            pub fn run<T: Number>(name: &str, $backend: Backend, mut from: &[T]) -> Vec<T> {
                let _ = $backend;
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

/// For single motions and for lanes alike.
macro_rules! table { ($($rows:tt)*) => {
    operations! { single, |backend|, dq8::Scalar, dq8::DualQuat, dq8::Quat, dq8::Dual, dq8::Motion; $($rows)* }
    operations! { lanes, |backend|, dq8::Lanes, dq8::batch::DualQuat, dq8::batch::Quat, dq8::batch::Dual, dq8::Motion; $($rows)* }
} }

fn three<T: Copy>(rows: impl IntoIterator<Item = impl IntoIterator<Item = T>>) -> Vec<T> {
    rows.into_iter().flatten().collect()
}
fn taken<T: Copy, const N: usize>(from: &mut &[T]) -> [T; N] {
    let (first, rest) = from.split_first_chunk().expect("as many as the table says");
    *from = rest;
    *first
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

// Jobs over slices. A joint under its parent: what forward kinematics repeats; a model times its
// inverse bind, as a matrix; skins of four joints, all of whose real parts are an argument, and all
// of whose dual parts; what such sums do to a point and a normal; and the column of a hinge about
// z, on a body at p and v.
operations! { jobs, |backend|, super::Number, dq8::DualQuat, dq8::Quat, dq8::Dual, dq8::Motion;
    local_to_model(p 4, q 4, r 4, s 4) -> (real 4, dual 4) = {
        let skeleton = Hierarchy::new(&[Hierarchy::ROOT, 0]).expect("a root, and its child");
        let (locals, mut models) = ([motion(p, q), motion(r, s)], [DualQuat::IDENTITY; 2]);
        skeleton.job().backend(backend).local_to_model(&locals, &mut models).expect("two of each");
        numbers(models[1])
    };
    local_to_model_lanes(p 4, q 4, r 4, s 4) -> (real 4, dual 4) = {
        let locals = [motion(p, q), motion(r, s)].repeat(MANY);
        let mut models = locals.clone();
        LEG.job().backend(backend).local_to_model(&locals, &mut models).expect("two of each");
        numbers(models[1])
    };
    local_to_model_blocks(p 4, q 4, r 4, s 4) -> (real 4, dual 4) = {
        let mut models = [block(motion(p, q)), block(motion(r, s))];
        LEG.job().backend(backend).local_to_model_in_place(&mut models).expect("two");
        lane(&models[1])
    };
    local_to_model_roots(p 4, q 4, r 4, s 4) -> (real 4, dual 4) = {
        let mut models = [motion(r, s), DualQuat::IDENTITY];
        LEG.job().backend(backend).root(motion(p, q)).local_to_model_in_place(&mut models).expect("two");
        numbers(models[0])
    };
    local_to_model_roots_lanes(p 4, q 4, r 4, s 4) -> (real 4, dual 4) = {
        let mut models = [motion(r, s), DualQuat::IDENTITY].repeat(MANY);
        LEG.job().backend(backend).root(motion(p, q)).local_to_model_in_place(&mut models).expect("two");
        numbers(models[0])
    };
    local_to_model_roots_blocks(p 4, q 4, r 4, s 4) -> (real 4, dual 4) = {
        let mut models = [block(motion(r, s)), block(DualQuat::IDENTITY)];
        LEG.job().backend(backend).root(motion(p, q)).local_to_model_in_place(&mut models).expect("two");
        lane(&models[0])
    };
    local_to_model_planned(p 4, q 4, r 4, s 4) -> (real 4, dual 4) = {
        let mut models = [motion(p, q), motion(r, s)];
        planned(&LEG, backend, &mut models, None);
        numbers(models[1])
    };
    local_to_model_planned_root(p 4, q 4, r 4, s 4) -> (real 4, dual 4) = {
        let mut models = [motion(r, s), DualQuat::IDENTITY];
        planned(&LEG, backend, &mut models, Some(motion(p, q)));
        numbers(models[0])
    };
    local_to_model_planned_chain(p 4, q 4, r 4, s 4) -> (real 4, dual 4) = {
        let mut models = [DualQuat::IDENTITY; 24];
        (models[0], models[1]) = (motion(p, q), motion(r, s));
        let parents: Vec<u32> = (0..24_u32).map(|joint| joint.wrapping_sub(1)).collect();
        planned(&Hierarchy::new(&parents).expect("a chain"), backend, &mut models, None);
        numbers(models[1])
    };
    chain_products(p 4, q 4, r 4, s 4) -> (real 4, dual 4) = chain(backend, motion(p, q), motion(r, s), [0, 1], 1);
    chain_products_scan(p 4, q 4, r 4, s 4) -> (real 4, dual 4) = chain(backend, motion(p, q), motion(r, s), [1, 3], 5);
    chain_products_rest(p 4, q 4, r 4, s 4) -> (real 4, dual 4) = chain(backend, motion(p, q), motion(r, s), [0, 16], 16);
    chain_products_blocks(p 4, q 4, r 4, s 4) -> (real 4, dual 4) = {
        let mut products = [block(motion(p, q)), block(motion(r, s))];
        backend.chain_products_in_place(&mut products);
        lane(&products[1])
    };
    bones(p 4, q 4, r 4, v 3) -> (real 4, dual 4) = {
        let (locals, mut models) = (Bones { rotations: &[quat(r)], offsets: &[v] }, [DualQuat::IDENTITY]);
        let job = Hierarchy::new(&[Hierarchy::ROOT]).expect("a root");
        job.job().backend(backend).root(motion(p, q)).locals_to_model(locals, &mut models).expect("one each");
        numbers(models[0])
    };
    bones_lanes(p 4, q 4, r 4, v 3) -> (real 4, dual 4) = {
        let rotations = [quat(r)].repeat(MANY);
        let (locals, mut models) = (Bones { rotations: &rotations, offsets: &[v] }, [DualQuat::IDENTITY].repeat(MANY));
        let job = Hierarchy::new(&[Hierarchy::ROOT]).expect("a root");
        job.job().backend(backend).root(motion(p, q)).locals_to_model(locals, &mut models).expect("one each");
        numbers(models[0])
    };
    bones_blocks(p 4, q 4, r 4, v 3) -> (real 4, dual 4) = {
        // The first is at p, q, by its root and no turn of its own.
        let rotations = [quat([T::ZERO, T::ZERO, T::ZERO, T::ONE]), quat(r)].map(|r| dq8_simd::Block::<[T; 4], 4>::splat(r.to_array()));
        let locals = Bones { rotations: &rotations, offsets: &[[T::ZERO; 3], v] };
        let mut models = [block(DualQuat::IDENTITY); 2];
        LEG.job().backend(backend).root(motion(p, q)).locals_to_model(locals, &mut models).expect("two");
        lane(&models[1])
    };
    palette(p 4, q 4, r 4, s 4) -> (rotation 3, translation 1, rotation 3, translation 1, rotation 3, translation 1) = {
        let root = Hierarchy::new(&[Hierarchy::ROOT]).expect("a root");
        let (locals, binds) = ([motion(p, q)], [motion(r, s)]);
        let (mut models, mut matrix) = ([DualQuat::IDENTITY], [[[T::ZERO; 4]; 3]]);
        let job = root.job().backend(backend);
        job.palette(Poses(&locals), &mut models, &binds, &mut matrix).expect("one each");
        three(matrix[0])
    };
    palette_lanes(p 4, q 4, r 4, s 4) -> (rotation 3, translation 1, rotation 3, translation 1, rotation 3, translation 1) = {
        let root = Hierarchy::new(&[Hierarchy::ROOT]).expect("a root");
        let (locals, mut matrices) = ([motion(p, q)].repeat(MANY), vec![[[T::ZERO; 4]; 3]; MANY]);
        let mut models = locals.clone();
        root.job().backend(backend).palette(Poses(&locals), &mut models, &[motion(r, s)], &mut matrices).expect("one each");
        three(matrices[0])
    };
    palette_blocks(p 4, q 4, r 4, s 4) -> (rotation 3, translation 1, rotation 3, translation 1, rotation 3, translation 1) = {
        let root = Hierarchy::new(&[Hierarchy::ROOT]).expect("a root");
        let (locals, mut models) = ([block(motion(p, q))], [block(DualQuat::IDENTITY)]);
        let mut matrices = [dq8_simd::Block::<[T; 4], 12>::splat([T::ZERO; 12])];
        root.job().backend(backend).palette(Poses(&locals), &mut models, &[motion(r, s)], &mut matrices).expect("one each");
        matrices[0].get(0).expect("four lanes").to_vec()
    };
    model_to_local(p 4, q 4, r 4, s 4) -> (real 4, dual 4) = {
        let (models, mut locals) = ([motion(p, q), motion(r, s)], [DualQuat::IDENTITY; 2]);
        LEG.job().backend(backend).model_to_local(&models, &mut locals).expect("two of each");
        numbers(locals[1])
    };
    linear_skin(a 12, b 12, c 12, d 12, w 4, v 3) -> (point 3) =
        skinned(Linear::new(&[a, b, c, d].map(rows)), w, v, backend, false);
    scaled_point(p 4, q 4, v 3) -> (point 3) = skinned(DualBlend::new(&alone(motion(p, q))), LAST.map(T::from), v, backend, false);
    dual_skin(p 16, q 16, w 4, v 3) -> (point 3) = {
        let [p, q] = [p, q].map(quats);
        skinned(DualBlend::new(&[0, 1, 2, 3].map(|i| motion(p[i], q[i]))), w, v, backend, false)
    };
    linear_normal(a 12, b 12, c 12, d 12, w 4, v 3) -> (normal 3) =
        skinned(Linear::new(&[a, b, c, d].map(rows)), w, v, backend, true);
    unit_normal(v 3) -> (unit 3) = {
        let identity = DualQuat::IDENTITY.to_matrix3x4();
        skinned(Linear::new(&[identity; 4]), [1.0, 0.0, 0.0, 0.0].map(T::from), v, backend, true)
    };
    dual_normal(p 16, w 4, v 3) -> (normal 3) =
        skinned(DualBlend::new(&quats(p).map(|p| DualQuat::from_rotation(quat(p)))), w, v, backend, true);
    scaled_normal(p 4, v 3) -> (normal 3) =
        skinned(DualBlend::new(&alone(DualQuat::from_rotation(quat(p)))), LAST.map(T::from), v, backend, true);
    link_placed(p 4, v 3, c 2) -> (real 4, dual 4) = link(&[&p, &v], Joint::fixed(Some(0), about_z(c)), None);
    poses_placed(p 4, v 3, c 2) -> (real 4, dual 4) = link(&[&p, &v], Joint::fixed(Some(0), about_z(c)), Some(backend));
    link_slide(p 4, v 3, d 1) -> (real 4, dual 4) = link(&[&p, &v, &d], Joint::prismatic(Some(0), DualQuat::IDENTITY, z()), None);
    poses_slide(p 4, v 3, d 1) -> (real 4, dual 4) = link(&[&p, &v, &d], Joint::prismatic(Some(0), DualQuat::IDENTITY, z()), Some(backend));
    link_turn(p 4, v 3, d 1) -> (real 4, dual 4) = link(&[&p, &v, &d], Joint::revolute(Some(0), DualQuat::IDENTITY, z()), None);
    poses_turn(p 4, v 3, d 1) -> (real 4, dual 4) = link(&[&p, &v, &d], Joint::revolute(Some(0), DualQuat::IDENTITY, z()), Some(backend));
    link_jacobian(p 4, v 3) -> (angular 3, linear 3) = hinge(p, v, |arm, values, columns| {
        arm.link_jacobian(World, values, 1, columns).map(|_| ())
    });
    jacobians(p 4, v 3) -> (angular 3, linear 3) = hinge(p, v, |arm, values, columns| {
        // A column for each value, of one configuration.
        let values: Vec<_> = values.chunks(1).collect();
        let mut poses = [DualQuat::IDENTITY];
        arm.job().backend(backend).links(&[1]).jacobians(World, &values, &mut poses, columns)
    });
}

/// Instances enough to fill lanes of any level.
const MANY: usize = 16;

/// A root, and its child.
static LEG: std::sync::LazyLock<Hierarchy<'static>> = std::sync::LazyLock::new(|| {
    Hierarchy::new(&[Hierarchy::ROOT, 0]).expect("a root, and its child")
});

type Block<T> = dq8_simd::Block<[T; 4], 8>;
fn block<T: Scalar>(motion: dq8::DualQuat<T>) -> Block<T> {
    Block::splat(motion.to_array())
}
fn lane<T: Scalar>(block: &Block<T>) -> Vec<T> {
    block.get(0).expect("four lanes").to_vec()
}

/// In place, in the order of a plan.
fn planned<T: Scalar>(
    hierarchy: &Hierarchy<'_>,
    backend: Backend,
    models: &mut [dq8::DualQuat<T>],
    root: Option<dq8::DualQuat<T>>,
) {
    let (mut order, mut scratch) =
        (vec![[0; 2]; models.len()], vec![PlanScratch::default(); models.len()]);
    let plan = Plan::new(hierarchy, &mut order, &mut scratch).expect("as long as it is");
    let job = hierarchy.job().backend(backend).plan(&plan);
    match root {
        Some(root) => job.root(root).local_to_model_in_place(models),
        None => job.local_to_model_in_place(models),
    }
    .expect("a model each");
}

/// Product number `i` of a chain of eight segments and one link more, of which two links are not
/// the identity.
fn chain<T: Scalar>(
    backend: Backend,
    a: dq8::DualQuat<T>,
    b: dq8::DualQuat<T>,
    at: [usize; 2],
    i: usize,
) -> Vec<T> {
    let mut links = [dq8::DualQuat::IDENTITY; 17];
    (links[at[0]], links[at[1]]) = (a, b);
    backend.chain_products_in_place(&mut links);
    links[i].to_array().to_vec()
}

/// Four weights: with joints that add nothing, so that one weight is not all there is.
const LAST: [f32; 4] = [0.0, 0.0, 1.0, 1.0];

fn alone<T: Scalar>(motion: dq8::DualQuat<T>) -> [dq8::DualQuat<T>; 4] {
    [motion, dq8::DualQuat::ZERO, dq8::DualQuat::ZERO, dq8::DualQuat::ZERO]
}
fn rows<T: Copy>(numbers: [T; 12]) -> [[T; 4]; 3] {
    let mut from = &numbers[..];
    [(); 3].map(|()| taken(&mut from))
}
fn quats<T: Copy>(numbers: [T; 16]) -> [[T; 4]; 4] {
    let mut from = &numbers[..];
    [(); 4].map(|()| taken(&mut from))
}

/// A point, or a normal.
fn skinned<T: Number>(
    blend: impl Blender<T>,
    weights: [T; 4],
    v: [T; 3],
    backend: Backend,
    is_normal: bool,
) -> Vec<T> {
    // Weights of either sign, for all that draws numbers; the last first, for the recorded one is
    // the greatest.
    let [d, c, b, a] = weights.map(|w| if w < T::ZERO { -w } else { w });
    let weights = [a, b, c, d];
    let skin = Skin::new(4, 4, &[0_u8, 1, 2, 3], &weights).expect("four joints");
    let (v, mut point, mut normal) = ([v], [[T::ZERO; 3]], [[T::ZERO; 3]]);
    let (mut rest, mut posed) = (Surface::positions(&v), SurfaceMut::positions(&mut point));
    if is_normal {
        (rest, posed) = (rest.normals(&v), posed.normals(&mut normal));
    }
    skin.job().backend(backend).pose(blend, rest, posed).expect("one vertex");
    three(if is_normal { normal } else { point })
}

fn z<T: Scalar>() -> [T; 3] {
    [T::ZERO, T::ZERO, T::ONE]
}
fn about_z<T: Scalar>([cos, sin]: [T; 2]) -> dq8::DualQuat<T> {
    dq8::DualQuat::from_rotation(dq8::Quat::from_xyzw(T::ZERO, T::ZERO, sin, cos))
}

/// The pose of what a joint carries on a body that its first values place: of one configuration, or
/// on lanes.
fn link<T: Number>(values: &[&[T]], joint: Joint<T>, backend: Option<Backend>) -> Vec<T> {
    let joints = [Joint::floating(None, dq8::DualQuat::IDENTITY), joint];
    let mut steps = [Step::default(); 2];
    let arm = Mechanism::new(&joints, &mut steps).expect("a body and a joint");
    let values = values.concat();
    let pose = match backend {
        None => arm.link_pose(&values, 1).expect("two links"),
        Some(backend) => {
            let mut poses = [dq8::DualQuat::IDENTITY; 2 * MANY];
            // A column for each value.
            let columns: Vec<_> = values.iter().map(|&value| vec![value; MANY]).collect();
            let columns: Vec<_> = columns.iter().map(|column| &column[..]).collect();
            let job = arm.job().backend(backend);
            job.poses(&columns, &mut poses).expect("as many configurations");
            poses[1]
        }
    };
    pose.to_array().to_vec()
}

/// The last column of `jacobian`, of a hinge about z on a body: where that is and how the hinge
/// stands are the values.
fn hinge<T: Number>(
    p: [T; 4],
    v: [T; 3],
    jacobian: impl Fn(&Mechanism<'_, T>, &[T], &mut [Twist<T>]) -> Result<(), ShapeError>,
) -> Vec<T> {
    let (z, still) = ([T::ZERO, T::ZERO, T::ONE], dq8::DualQuat::IDENTITY);
    let joints = [Joint::floating(None, still), Joint::revolute(Some(0), still, z)];
    let mut steps = [Step::default(); 2];
    let arm = Mechanism::new(&joints, &mut steps).expect("a body and a hinge");
    let (values, mut columns) =
        ([&p[..], &v, &[T::ONE]].concat(), [Twist::from_array([T::ZERO; 6]); 7]);
    jacobian(&arm, &values, &mut columns).expect("7 rates");
    columns[6].to_array().to_vec()
}

operations! { functions, |backend|, dq8::Lanes, dq8::batch::DualQuat, dq8::batch::Quat, dq8::batch::Dual, dq8::Motion;
    arc_over_chord(v 1) -> (arc 1) = vec![even::arc_over_chord(number(v)).real];
    cos_sinc(v 1) -> (cos 1, sinc 1) = both(even::cos_sinc(number(v)));
    integrals(v 1) -> (first 1, second 1) = both(even::exponential_integrals(number(v)));
    half_cotangent(v 1) -> (half 1) = vec![even::half_cotangent(number(v)).real];
    log(p 4, q 4) -> (real 3, dual 3) = {
        let log = motion(p, q).log();
        three([log.real, log.dual])
    };
    exp(v 3, w 3) -> (real 4, dual 4) = numbers(DualQuat::exp(DualVector { real: v, dual: w }));
    pow(p 4, q 4, t 1) -> (real 4, dual 4) = numbers(motion(p, q).pow(t[0]));
    sqrt(p 4, q 4) -> (real 4, dual 4) = numbers(motion(p, q).sqrt());
    sclerp(p 4, q 4, r 4, s 4, t 1) -> (real 4, dual 4) = numbers(motion(p, q).sclerp(motion(r, s), t[0]));
}

// Functions of one number, without their derivatives.
fn number<L: Lanes>([v]: [L; 1]) -> dq8::batch::Dual<L> {
    dq8::batch::Dual::new(v, v.constant(0.0))
}
fn both<L: Lanes>((a, b): (dq8::batch::Dual<L>, dq8::batch::Dual<L>)) -> Vec<L> {
    vec![a.real, b.real]
}

/// From 0 to where the range of the polynomials of a function of one number ends.
#[must_use]
pub fn end(name: &str) -> f64 {
    match name {
        "arc_over_chord" => 2.0,
        "cos_sinc" => 2.5,
        _ => 10.0,
    }
}
