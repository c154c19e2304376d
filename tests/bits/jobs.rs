//! Every job over slices, skeletons and skins, of one precision: `super::R`.

use super::R;
use super::robots::{robots, solutions};
use super::zeros;
use crate::deal::Hash;
use crate::random::Random;
use dq8::fit::{Fit, Maps, PairSets, Quality};
use dq8::hierarchy::{
    Clip, Layered, MatrixOrder, PackedClips, Plan, PlanScratch, Poses, Renormalize,
    RotationsTranslations, Sampled,
};
use dq8::ik::Limb;
use dq8::internal::{for_each_kernel, record};
use dq8::law::{Nlerp, NlerpLerp, Sclerp};
use dq8::skinning::{Blender, DualBlend, Linear, Skin, Surface, SurfaceMut};
use dq8::storage::{Block, Element, pack, pack_chain, unpack, unpack_chain};
use dq8::{Backend, DualQuat, Hierarchy, Twist};

pub(super) type M = DualQuat<R>;
type Motions = Block<R, 8>;

/// Seven joints, eight instances, and five motions more, so that no width of lanes divides them.
const JOINTS: usize = 7;
const INSTANCES: usize = 8;
pub(super) const N: usize = JOINTS * INSTANCES + 5;
const BLOCKS: usize = N.div_ceil(8);
const PARENTS: [u32; JOINTS] = [Hierarchy::ROOT, 0, 1, 0, 3, Hierarchy::ROOT, 4];

/// Types that consist of `R` alone. [`hash`] takes no other, because the cast would read each `f64`
/// as two `f32`, and then the hash would depend on the order of bytes.
pub(super) trait Numbers: bytemuck::Pod {}
impl Numbers for R {}
impl Numbers for M {}
impl Numbers for Twist<R> {}
impl<T: Numbers, const C: usize> Numbers for [T; C] {}

pub(super) fn hash<T: Numbers>(things: &[T]) -> u64 {
    let mut hash = Hash(1);
    bytemuck::cast_slice::<T, R>(things).iter().for_each(|&number| hash.number(number));
    hash.0
}

/// Things in blocks.
fn blocks<const C: usize, E>(things: &[E]) -> [Block<R, 8, C>; BLOCKS]
where
    E: Element<C, Layout = dq8::storage::Aos<R>>,
{
    let mut blocks = [Block::splat([0.0; C]); BLOCKS];
    pack(1, things, &mut blocks).expect("as many as there are");
    blocks
}

/// Of blocks the hash that single things would have.
fn hash_blocks<const C: usize, E>(blocks: &[Block<R, 8, C>], mut like: [E; N]) -> u64
where
    E: Element<C, Layout = dq8::storage::Aos<R>> + Numbers,
{
    unpack(1, blocks, &mut like).expect("as many as there are");
    hash(&like)
}

pub(crate) fn run(k: Backend, say: &mut dyn FnMut(&str, u64)) {
    let mut random = Random::new(88_172_645_463_325_252);
    let mut motions = || [(); N].map(|()| M::from_array(random.motion()));
    let (a, b, c) = (motions(), motions(), motions());
    let any = [(); N].map(|()| M::from_array(random.numbers()));
    let t: [R; N] = [(); N].map(|()| 0.5 + 0.5 * random.signed::<R>());
    let points: [[R; 3]; N] = [(); N].map(|()| random.numbers());
    let logs: [[R; 6]; N] = [(); N].map(|()| random.numbers());
    slices(k, say, [&a, &b, &c, &any], &t, &points, &logs);
    packed(k, say, &t);
    series(k, say, &a);
    hierarchies(k, say, [&a, &b, &c], &t);
    robots(k, say, [&a, &b], &mut random);
    solutions(k, say, &mut random.clone());
    skins(k, say, &a, &points, &mut random);
    limbs(k, say, [&a, &b], &points, &logs);
    fits(k, say, &points, &logs, &t);
    zeros::run(k, say);
}

/// A job over plain things and over blocks.
macro_rules! both {
    ($say:ident $name:expr, $to:ident: $zero:expr, $plain:expr, $blocked:expr) => {{
        let mut $to = $zero;
        $plain.expect("lengths fit");
        $say(concat!($name, ", plain"), hash(&$to));
        let mut $to = blocks(&$zero);
        $blocked.expect("lengths fit");
        $say(concat!($name, ", blocks"), hash_blocks(&$to, $zero));
    }};
}

/// The inputs of kernels.
struct Given {
    a: [[R; 8]; N],
    b: [[R; 8]; N],
    any: [[R; 8]; N],
    t: [[R; 1]; N],
    points: [[R; 3]; N],
    planes: [[R; 4]; N],
    /// Lines, twists and logarithms.
    six: [[R; 6]; N],
}

/// The kernels of the list.
macro_rules! of_each {
    ($(
        $(#[doc = $brief:literal])+
        $name:ident $(as $c:literal)? [$($types:tt)*]
        ($($input:ident: $kind:ident $I:ident),+ $(; $parameter:ident)?)
            -> $output:ident: $result:ident $Q:ident $(, in place $in_place:ident)? = $one:expr, {
            $($more:tt)*
        }
    )*) => {
        fn of_each(k: Backend, say: &mut dyn FnMut(&str, u64), x: &Given) {$(
            both!(say stringify!($name), to: [[0.0; record!($result)]; N],
                k.$name($(given!(x $input $kind),)+ $(given!(x $parameter),)? &mut to),
                k.$name($(&blocks(given!(x $input $kind)),)+ $(given!(x $parameter),)? &mut to));
        )*}
    };
}

/// The input of that name and kind, and the parameter of that name.
macro_rules! given {
    ($x:ident t) => {
        $x.t[0][0]
    };
    ($x:ident dt) => {
        $x.t[1][0]
    };
    ($x:ident a $kind:ident) => {
        &$x.a
    };
    ($x:ident b unit) => {
        &$x.b
    };
    ($x:ident $name:ident any) => {
        &$x.any
    };
    ($x:ident $name:ident unit) => {
        &$x.a
    };
    ($x:ident $name:ident number) => {
        &$x.t
    };
    ($x:ident $name:ident point) => {
        &$x.points
    };
    ($x:ident $name:ident vector) => {
        &$x.points
    };
    ($x:ident $name:ident plane) => {
        &$x.planes
    };
    ($x:ident $name:ident $six:ident) => {
        &$x.six
    };
}

for_each_kernel!(of_each);

fn slices(
    k: Backend,
    say: &mut dyn FnMut(&str, u64),
    [a, b, c, any]: [&[M; N]; 4],
    t: &[R; N],
    points: &[[R; 3]; N],
    logs: &[[R; 6]; N],
) {
    let planes = logs.map(|[x, y, z, d, ..]| [x, y, z, d]);
    let [first, second, any] = [a, b, any].map(|motions| motions.map(M::to_array));
    let t_each = t.map(|t| [t]);
    of_each(
        k,
        say,
        &Given { a: first, b: second, any, t: t_each, points: *points, planes, six: *logs },
    );
    let (ba, bb, bc, bt, bp) =
        (blocks(a), blocks(b), blocks(c), blocks::<1, _>(&t_each), blocks(points));
    both!(say "dlb", to: [M::IDENTITY; N],
        k.dlb([(&a[..], &t[..]), (b, t), (c, t)], &mut to),
        k.dlb([(&ba[..], &bt[..]), (&bb, &bt), (&bc, &bt)], &mut to));
    both!(say "matrices", to: [[[0.0; 4]; 3]; N], k.matrices(a, MatrixOrder::Rows, &mut to),
        k.matrices(&ba, MatrixOrder::Rows, &mut to));
    both!(say "transform_points", to: *points, k.transform_points(a[0], points, &mut to),
        k.transform_points(a[0], &bp, &mut to));
    both!(say "transform_vectors", to: *points, k.transform_vectors(a[0], points, &mut to),
        k.transform_vectors(a[0], &bp, &mut to));
}

fn series(k: Backend, say: &mut dyn FnMut(&str, u64), a: &[M; N]) {
    let mut to = [M::IDENTITY; N];
    let mut matrices = [[[0.0; 4]; 3]; N];
    k.matrices(a, MatrixOrder::Rows, &mut matrices).expect("lengths fit");
    k.from_matrices(&matrices, MatrixOrder::Rows, &mut to).expect("lengths fit");
    say("from_matrices", hash(&to));
    k.dib_windows(a, &[0.5, 1.0, 0.5], 1e-6, 8, &mut to[2..]).expect("lengths fit");
    say("dib_windows", hash(&to));
    to = *a;
    k.chain_products_in_place(&mut to);
    say("chain_products, plain", hash(&to));
    let mut chain = [Motions::splat([0.0; 8]); BLOCKS];
    pack_chain(a, &mut chain).expect("as many as there are");
    k.chain_products_in_place(&mut chain);
    unpack_chain(&chain, &mut to).expect("as many as there are");
    say("chain_products, blocks", hash(&to));
}

fn hierarchies(k: Backend, say: &mut dyn FnMut(&str, u64), [a, b, c]: [&[M; N]; 3], t: &[R; N]) {
    const ALL: usize = JOINTS * INSTANCES;
    let tree = Hierarchy::new(&PARENTS).expect("parents come first");
    let job = || tree.job().backend(k);
    let (locals, roots, binds, shares) =
        (&a[..ALL], &b[..INSTANCES], &c[..JOINTS], &t[..INSTANCES]);
    let (mut to, mut matrices) = ([M::IDENTITY; ALL], [[[0.0; 4]; 3]; ALL]);
    let mut crowd = [Motions::splat([0.0; 8]); JOINTS];
    let mut root = [Motions::splat([0.0; 8])];
    pack(JOINTS, locals, &mut crowd).expect("whole instances");
    pack(1, roots, &mut root).expect("whole instances");
    macro_rules! many {
        ($name:literal, $job:expr, $locals:expr, $blocks:expr) => {{
            $job.locals_to_model($locals, &mut to).expect("lengths fit");
            say(concat!($name, ", plain"), hash(&to));
            let mut models = crowd;
            $job.locals_to_model($blocks, &mut models).expect("lengths fit");
            unpack(JOINTS, &models, &mut to).expect("whole instances");
            say(concat!($name, ", blocks"), hash(&to));
        }};
    }
    many!("local_to_model", job(), Poses(locals), Poses(&crowd));
    let every = job().renormalize(Renormalize::Every(core::num::NonZeroU32::MIN));
    many!("renormalize", every, Poses(locals), Poses(&crowd));
    let seven: [[R; 7]; ALL] = core::array::from_fn(|i| {
        let (r, t) = (locals[i].rotation().to_array(), locals[i].translation());
        [r[0], r[1], r[2], r[3], t[0], t[1], t[2]]
    });
    let mut pairs: [Block<R, 8, 7>; JOINTS] = [Block::splat([0.0; 7]); JOINTS];
    pack(JOINTS, &seven, &mut pairs).expect("whole instances");
    many!(
        "RotationsTranslations",
        job(),
        RotationsTranslations(&seven),
        RotationsTranslations(&pairs)
    );

    // One by one, with a plan and without, and in a chain that a plan cuts into segments.
    let (mut order, mut scratch) = ([[0; 2]; JOINTS], [PlanScratch::default(); JOINTS]);
    let plan = Plan::new(&tree, &mut order, &mut scratch).expect("lengths fit");
    to.copy_from_slice(locals);
    for models in to.chunks_mut(JOINTS) {
        job().local_to_model_in_place(models).expect("lengths fit");
    }
    say("local_to_model, one by one", hash(&to));
    to.copy_from_slice(locals);
    for models in to.chunks_mut(JOINTS) {
        job().plan(&plan).local_to_model_in_place(models).expect("lengths fit");
    }
    say("local_to_model, plan", hash(&to));
    let line: [u32; N] = core::array::from_fn(|joint| (joint as u32).wrapping_sub(1));
    let line = Hierarchy::new(&line).expect("parents come first");
    let (mut order, mut scratch) = ([[0; 2]; N], [PlanScratch::default(); N]);
    let plan = Plan::new(&line, &mut order, &mut scratch).expect("lengths fit");
    let mut chain = *a;
    line.job().backend(k).plan(&plan).local_to_model_in_place(&mut chain).expect("lengths fit");
    say("local_to_model, plan of a chain", hash(&chain));
    job().model_to_local(locals, &mut to).expect("lengths fit");
    say("model_to_local", hash(&to));

    let on_roots = job().roots(roots);
    on_roots.palette(Poses(locals), &mut to, binds, &mut matrices).expect("lengths fit");
    say("palette, plain", hash(&matrices));
    let mut entries: [Block<R, 8, 12>; JOINTS] = [Block::splat([0.0; 12]); JOINTS];
    let (mut scratch, on_roots) = (crowd, job().roots(&root));
    on_roots.palette(Poses(&crowd), &mut scratch, binds, &mut entries).expect("lengths fit");
    unpack(JOINTS, &entries, &mut matrices).expect("whole instances");
    say("palette, blocks", hash(&matrices));

    let frames: [u32; INSTANCES] = core::array::from_fn(|i| (5 * i % 7) as u32);
    let of = |keys| Clip::new(JOINTS, keys).expect("whole frames");
    macro_rules! clips {
        ($name:literal, $law:expr) => {{
            let sampled = |keys| Sampled::new($law, of(keys), &frames, shares).expect("frames");
            let layers = Layered::blend($law, sampled(locals), sampled(&b[..ALL]), shares);
            let layers = layers.mask(&t[..JOINTS]);
            many!($name, job(), layers, layers);
        }};
    }
    clips!("clips, Nlerp", Nlerp);
    clips!("clips, Sclerp", Sclerp);
    let clip = Clip::new(JOINTS, &seven).expect("whole frames");
    let sampled = Sampled::new(NlerpLerp, clip, &frames, shares).expect("frames");
    many!("clips, NlerpLerp", job(), sampled, sampled);
    job().locals(sampled, &mut to).expect("lengths fit");
    say("clips, locals", hash(&to));
    let round = clip.with_rate(30.0).looping();
    let moved = shares.iter().filter_map(|&t| round.between(NlerpLerp, 1, -t, 7.0 * t));
    to.iter_mut().zip(moved).for_each(|(to, moved)| *to = moved);
    say("clips, between", hash(&to));
}

/// Sets of points, two of them without a best map.
fn fits(
    k: Backend,
    say: &mut dyn FnMut(&str, u64),
    points: &[[R; 3]; N],
    numbers: &[[R; 6]; N],
    weights: &[R; N],
) {
    const COUNTS: [usize; 11] = [4, 5, 9, 3, 0, 2, 11, 8, 7, 5, 7];
    let moved = numbers.map(|[x, y, z, ..]| [x, y, z]);
    let sets = PairSets::weighted(points, &moved, weights, &COUNTS).expect("lengths fit");
    for (name, maps) in [
        ("fit_each, rigid", Maps::Rigid),
        ("fit_each, similarity", Maps::Similarity),
        ("fit_each, about", Maps::About([0.6, 0.0, 0.8])),
    ] {
        let mut fits = [Fit::NONE; COUNTS.len()];
        let mut qualities = [Quality::NONE; COUNTS.len()];
        k.fit_each(sets, maps, &mut fits, &mut qualities).expect("lengths fit");
        let mut hash = Hash(1);
        for (fit, quality) in fits.iter().zip(&qualities) {
            let known = fit.motion.to_array().into_iter().chain(fit.from).chain(fit.to);
            let known = known.chain([fit.scale, quality.rms, quality.condition]);
            known.chain([quality.rank as R]).for_each(|number| hash.number(number));
        }
        say(name, hash.0);
    }
}

/// Limbs of two bones, alone and in a skeleton.
fn limbs(
    k: Backend,
    say: &mut dyn FnMut(&str, u64),
    [a, b]: [&[M; N]; 2],
    roots: &[[R; 3]; N],
    numbers: &[[R; 6]; N],
) {
    let targets: [[R; 3]; N] = numbers.map(|[x, y, z, ..]| [x, y, z]);
    let poles: [[R; 3]; N] = numbers.map(|[.., x, y, z]| [x, y, z]);
    let lengths: [[R; 2]; N] = numbers.map(|[x, .., y]| [x.abs(), y.abs()]);
    let aims = (blocks(roots), blocks(&lengths), blocks(&targets), blocks(&poles));
    let zero = [[0.0; 4]; N];
    let mut lowers = zero;
    both!(say "two_bone", to: zero,
        k.two_bone(roots, &lengths, &targets, &poles, &mut to, &mut lowers),
        k.two_bone(&aims.0, &aims.1, &aims.2, &aims.3, &mut to, &mut blocks(&zero)));
    say("two_bone, lower", hash(&lowers));

    const ALL: usize = JOINTS * INSTANCES;
    let tree = Hierarchy::new(&PARENTS).expect("parents come first");
    let limb = Limb { joints: [3, 4, 6], hinge: [0.6, 0.0, 0.8] };
    let (mut to, mut models) = ([M::IDENTITY; ALL], [M::IDENTITY; ALL]);
    let (targets, poles) = (&targets[..INSTANCES], &poles[..INSTANCES]);
    to.copy_from_slice(&a[..ALL]);
    let job = tree.job().backend(k).roots(&b[..INSTANCES]);
    job.local_to_model(&to, &mut models).expect("lengths fit");
    job.two_bone(&limb, &models, targets, poles, &mut to).expect("a limb");
    say("two_bone, locals", hash(&to));
    let (mut crowd, mut stands) = ([Motions::splat([0.0; 8]); JOINTS], [Motions::splat([0.0; 8])]);
    let mut aims = [[Block::<R, 8, 3>::splat([0.0; 3])]; 2];
    let mut laid = crowd;
    pack(JOINTS, &models, &mut laid).expect("whole instances");
    pack(JOINTS, &a[..ALL], &mut crowd).expect("whole instances");
    pack(1, &b[..INSTANCES], &mut stands).expect("whole instances");
    pack(1, targets, &mut aims[0]).expect("whole instances");
    pack(1, poles, &mut aims[1]).expect("whole instances");
    let job = tree.job().backend(k).roots(&stands);
    job.two_bone(&limb, &laid, &aims[0], &aims[1], &mut crowd).expect("a limb");
    unpack(JOINTS, &crowd, &mut to).expect("whole instances");
    say("two_bone, locals in blocks", hash(&to));
}

/// A stride of 21 joints, which mocap has packed.
fn packed(k: Backend, say: &mut dyn FnMut(&str, u64), t: &[R; N]) {
    const JOINTS: usize = 21;
    let stride = include_bytes!("../firmware/jobs/src/stride.clips");
    let clips = PackedClips::from_bytes(stride).expect("what mocap has packed");
    let places: [_; 5] = core::array::from_fn(|i| clips.place(0, 32.0 * t[i]).expect("a clip"));
    let line: [u32; JOINTS] = core::array::from_fn(|joint| (joint as u32).wrapping_sub(1));
    let job = Hierarchy::new(&line).expect("parents come first").job().backend(k);
    let (at, t) = (places.map(|place| place.0), places.map(|place| place.1));
    let sampled = Sampled::new(NlerpLerp, clips, &at, &t).expect("as many as there are");
    let mut to = [M::IDENTITY; 5 * JOINTS];
    job.locals_to_model(sampled, &mut to).expect("lengths fit");
    say("clips, packed", hash(&to));
}

fn skins(
    k: Backend,
    say: &mut dyn FnMut(&str, u64),
    a: &[M; N],
    points: &[[R; 3]; N],
    random: &mut Random,
) {
    const EACH: usize = 4;
    let who: [u16; EACH * N] = [(); EACH * N].map(|()| random.below(20) as u16);
    let mut weights: [R; EACH * N] = [(); EACH * N].map(|()| 1.125 + random.signed::<R>());
    for weights in weights.chunks_mut(EACH) {
        let sum = (weights[0] + weights[1]) + (weights[2] + weights[3]);
        weights.iter_mut().for_each(|weight| *weight /= sum);
    }
    let skin = Skin::new(20, EACH, &who, &weights).expect("weights are sound");
    let motions = &a[..20];
    let matrices: [[[R; 4]; 3]; 20] = core::array::from_fn(|i| a[i].to_matrix3x4());
    let names = ["Linear, plain", "Linear, normals", "Linear, blocks"];
    skinned(k, say, names, &skin, Linear::new(&matrices), points);
    let names = ["DualBlend, plain", "DualBlend, normals", "DualBlend, blocks"];
    skinned(k, say, names, &skin, DualBlend::new(motions), points);
}

fn skinned(
    k: Backend,
    say: &mut dyn FnMut(&str, u64),
    [plain, with_normals, in_blocks]: [&str; 3],
    skin: &Skin<'_, u16, R>,
    blend: impl Blender<R>,
    points: &[[R; 3]; N],
) {
    let job = skin.job().backend(k);
    let (mut to, mut normals) = (*points, *points);
    job.pose(blend, Surface::positions(points), SurfaceMut::positions(&mut to))
        .expect("lengths fit");
    say(plain, hash(&to));
    let both = SurfaceMut::positions(&mut to).normals(&mut normals);
    job.pose(blend, Surface::positions(points).normals(points), both).expect("lengths fit");
    say(with_normals, hash(&[to, normals]));
    let rest = blocks(points);
    let mut posed = rest;
    job.pose(blend, Surface::positions(&rest), SurfaceMut::positions(&mut posed))
        .expect("lengths fit");
    say(in_blocks, hash_blocks(&posed, *points));
}
