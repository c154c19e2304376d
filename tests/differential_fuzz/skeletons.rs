//! Jobs of skeletons: the same bits together, in place, split, one by one, on threads, and in
//! blocks of every width.

use super::kernels::{Entries, Scene, of_motions, of_numbers};
use dq8::hierarchy::{
    Clip, Layered, Locals, PackedClips, Plan, PlanScratch, Poses, Renormalize, Root,
    RotationsTranslations, Sampled,
};
use dq8::law::{NlerpLerp, Sclerp};
use dq8::storage::{Block, Element, pack, unpack};
use dq8::{Backend, Crowd, DualQuat, Hierarchy, Scalar};
use dq8_simd::Row;
use std::iter::once;
use std::num::NonZeroU32;
use std::ops::Range;

/// What the roots of all instances stand on.
#[derive(Clone, Copy)]
enum On {
    Nothing,
    /// The first of the roots.
    One,
    Each,
}

/// A skeleton, and how its models are computed.
struct Run<'r, R> {
    tree: Hierarchy<'r>,
    backend: Backend,
    renormalize: Renormalize,
    on: On,
    /// One for each instance.
    roots: Vec<DualQuat<R>>,
    /// Where a slice is split: so many instances are in the first part.
    split: usize,
    /// The joints before this one are computed first, the others by another call.
    joint: usize,
    /// Whether threads compute it too, which takes many instances.
    #[cfg(feature = "rayon")]
    threads: bool,
}

impl<R: Scalar> Run<'_, R> {
    fn joints(&self) -> usize {
        self.tree.parents().len()
    }

    fn root<'a, E: Element<8>>(
        &self,
        one: DualQuat<dq8::storage::Number<E, 8>>,
        each: &'a [E],
    ) -> Root<'a, E> {
        match self.on {
            On::Nothing => Root::None,
            On::One => Root::Same(one),
            On::Each => Root::Each(each),
        }
    }
}

impl<R: Scalar> Run<'_, R>
where
    [R; 4]: Row<Real = R>,
    [R; 8]: Row<Real = R>,
{
    /// Calls `job` for the instances of each range.
    fn parts(
        &self,
        ranges: impl IntoIterator<Item = Range<usize>>,
        mut job: impl FnMut(Range<usize>, Root<'_, DualQuat<R>>),
    ) {
        for range in ranges {
            job(range.clone(), self.root(self.roots[0], &self.roots[range]));
        }
    }

    /// All instances; each part of them; each of them.
    fn cuts(&self) -> [(&'static str, Vec<Range<usize>>); 3] {
        let count = self.roots.len();
        [
            ("together", once(0..count).collect()),
            ("split", vec![0..self.split, self.split..count]),
            ("one by one", (0..count).map(|i| i..i + 1).collect()),
        ]
    }

    fn models<L: Locals<DualQuat<R>>>(&self, locals: impl Fn(Range<usize>) -> L) -> Entries {
        let (joints, job) = (self.joints(), self.tree.job().backend(self.backend));
        let job = job.renormalize(self.renormalize);
        let mut entries = Entries::new();
        for (cut, ranges) in self.cuts() {
            let mut models = vec![DualQuat::IDENTITY; joints * self.roots.len()];
            self.parts(ranges, |range, root| {
                let models = &mut models[range.start * joints..range.end * joints];
                job.clone().on(root).locals_to_model(locals(range), models).unwrap();
            });
            entries.push((cut, of_motions(&models)));
        }
        entries
    }

    /// [`models`](Self::models) of motions, and whatever else computes the same: in place, and
    /// joint by joint.
    fn poses(&self, locals: &[DualQuat<R>]) -> Entries {
        let (joints, job) = (self.joints(), self.tree.job().backend(self.backend));
        let job = job.renormalize(self.renormalize);
        let mut entries =
            self.models(|range| Poses(&locals[range.start * joints..range.end * joints]));
        for (cut, ranges) in self.cuts() {
            let mut models = locals.to_vec();
            self.parts(ranges, |range, root| {
                let models = &mut models[range.start * joints..range.end * joints];
                job.clone().on(root).local_to_model_in_place(models).unwrap();
            });
            entries.push((cut, of_motions(&models)));
        }
        self.parts(once(0..self.roots.len()), |_, root| {
            let mut models = vec![DualQuat::IDENTITY; locals.len()];
            let job = job.clone().on(root);
            job.clone().joints(..self.joint).local_to_model(locals, &mut models).unwrap();
            job.joints(self.joint..).local_to_model(locals, &mut models).unwrap();
            entries.push(("some joints first", of_motions(&models)));
        });
        #[cfg(feature = "rayon")]
        if self.threads {
            entries.push(("three threads", self.on_threads(locals)));
        }
        entries
    }

    /// All instances again and again, as many as more than one thread takes; threads may part in
    /// the midst of a turn.
    #[cfg(feature = "rayon")]
    fn on_threads(&self, locals: &[DualQuat<R>]) -> Vec<u64> {
        let times = 6000_usize.div_ceil(locals.len());
        let (many, roots) = (locals.repeat(times), self.roots.repeat(times));
        let mut models = many.clone();
        let job = self.tree.job().backend(self.backend).renormalize(self.renormalize).threads(3);
        let root = self.root(self.roots[0], &roots);
        job.on(root).local_to_model(&many, &mut models).unwrap();
        let mut turns = models.chunks(locals.len()).map(of_motions);
        let first = turns.next().unwrap();
        // An odd one shows itself in place of the first.
        turns.find(|turn| *turn != first).unwrap_or(first)
    }

    /// Palettes alone, with scratch for few and for many instances, and beside the models.
    fn palettes(&self, locals: &[DualQuat<R>], binds: &[DualQuat<R>]) -> Entries {
        let joints = self.joints();
        let job = self.tree.job().backend(self.backend).renormalize(self.renormalize);
        let mut entries = Entries::new();
        for (name, instances) in [("scratch of 1", 1), ("scratch of 3", 3), ("scratch of 16", 16)] {
            self.parts(once(0..self.roots.len()), |_, root| {
                let mut scratch = vec![DualQuat::IDENTITY; instances * joints];
                let mut matrices = vec![[[R::ZERO; 4]; 3]; locals.len()];
                let job = job.clone().on(root);
                job.palette(Poses(locals), &mut scratch, binds, &mut matrices).unwrap();
                entries.push((name, of_numbers(matrices.as_flattened().as_flattened())));
            });
        }
        for (cut, ranges) in self.cuts() {
            let mut matrices = vec![[[R::ZERO; 4]; 3]; locals.len()];
            self.parts(ranges, |range, root| {
                let range = range.start * joints..range.end * joints;
                let mut models = vec![DualQuat::IDENTITY; range.len()];
                let (locals, to) = (Poses(&locals[range.clone()]), &mut matrices[range]);
                job.clone().on(root).palette_and_models(locals, &mut models, binds, to).unwrap();
            });
            entries.push((cut, of_numbers(matrices.as_flattened().as_flattened())));
        }
        entries
    }

    fn model_to_local(&self, models: &[DualQuat<R>]) -> Entries {
        let (joints, job) = (self.joints(), self.tree.job().backend(self.backend));
        let cuts = self.cuts().into_iter().map(|(cut, ranges)| {
            let mut locals = models.to_vec();
            self.parts(ranges, |range, root| {
                let poses = &mut locals[range.start * joints..range.end * joints];
                job.clone().on(root).model_to_local_in_place(poses).unwrap();
            });
            (cut, of_motions(&locals))
        });
        cuts.collect()
    }

    /// Models of locals in blocks, and a palette of motions.
    fn in_blocks<const N: usize, L>(&self, locals: L, binds: &[DualQuat<R>]) -> [Vec<u64>; 2]
    where
        [R; N]: Row<Real = R>,
        L: Locals<Block<R, N>>,
    {
        let (joints, count) = (self.joints(), self.roots.len());
        let roots = Crowd::<R, N>::from_slice(1, &self.roots).unwrap();
        let (mut models, mut palette) =
            (Crowd::<R, N>::new(joints, count), Crowd::<R, N>::new(joints, count));
        let job = self.tree.job().backend(self.backend).renormalize(self.renormalize);
        let (to, entries) = (models.blocks_mut(), palette.blocks_mut());
        job.on(self.root(self.roots[0], roots.blocks()))
            .palette_and_models(locals, to, binds, entries)
            .unwrap();
        [of_motions(&models.to_vec()), of_motions(&palette.to_vec())]
    }

    /// A plan computes one instance; what it cuts into segments is multiplied in another order than
    /// by a loop.
    fn plan(&self, locals: &[DualQuat<R>]) -> Entries {
        let joints = self.joints();
        let (mut order, mut scratch) = (vec![[0; 2]; joints], vec![PlanScratch::default(); joints]);
        let plan = Plan::new(&self.tree, &mut order, &mut scratch).unwrap();
        let job = self.tree.job().backend(self.backend).plan(&plan);
        let mut models = locals.to_vec();
        let ranges = (0..self.roots.len()).map(|i| i..i + 1);
        self.parts(ranges, |range, root| {
            let models = &mut models[range.start * joints..range.end * joints];
            job.clone().on(root).local_to_model_in_place(models).unwrap();
        });
        let mut chain = locals.to_vec();
        self.backend.chain_products_in_place(&mut chain);
        let mut other = vec![DualQuat::IDENTITY; locals.len()];
        self.backend.chain_products(locals, &mut other).unwrap();
        // Each only against other lanes: the two are of different things.
        let [models, chain, other] = [models, chain, other].map(|motions| of_motions(&motions));
        assert!(chain == other, "a chain in place has other bits");
        vec![("plan, and a chain", [models, chain].concat())]
    }
}

impl<R, const W: usize> Scene<'_, R, W>
where
    [R; 4]: Row<Real = R>,
    [R; 8]: Row<Real = R>,
    [R; W]: Row<Real = R>,
    R: Scalar,
{
    /// Random parents, some of them farther back than a loop keeps models.
    fn parents(&mut self) -> Vec<u32> {
        let (joints, near) = (1 + self.random.below(24), self.random.below(2) == 0);
        let parent = |joint: usize| match self.random.below(8) {
            _ if joint == 0 => Hierarchy::ROOT,
            0 => Hierarchy::ROOT,
            _ if near => joint as u32 - 1,
            _ => self.random.below(joint) as u32,
        };
        (0..joints).map(parent).collect()
    }

    fn run<'p>(&mut self, parents: &'p [u32]) -> Run<'p, R> {
        let instances = 1 + self.random.below(33);
        let every = NonZeroU32::new(self.random.below(4) as u32);
        Run {
            tree: Hierarchy::new(parents).unwrap(),
            backend: self.backend,
            renormalize: every.map_or(Renormalize::Never, Renormalize::Every),
            on: self.random.one_of(&[On::Nothing, On::One, On::Each]),
            roots: self.motions(instances),
            split: self.random.below(instances + 1),
            joint: self.random.below(parents.len() + 1),
            #[cfg(feature = "rayon")]
            threads: self.random.below(8) == 0,
        }
    }

    /// Models, palettes and locals of motions, of rotations with translations, and of layers of
    /// clips.
    pub(crate) fn skeleton(&mut self) -> Vec<Entries> {
        let parents = self.parents();
        let run = self.run(&parents);
        let (joints, instances) = (parents.len(), run.roots.len());
        let (locals, binds) = (self.motions(joints * instances), self.motions(joints));
        let seven: Vec<[R; 7]> =
            locals.iter().map(|local| local.to_array()[..7].try_into().unwrap()).collect();
        let keys = [(); 2].map(|()| self.motions(joints * FRAMES));
        let at: Vec<_> = (0..instances).map(|_| self.random.below(FRAMES - 1) as u32).collect();
        let [t, weights] =
            [(); 2].map(|()| (0..instances).map(|_| self.number()).collect::<Vec<_>>());
        let mask: Vec<_> = (0..joints).map(|_| self.number()).collect();
        let layers = |range: Range<usize>| {
            let [base, layer] = [&keys[0], &keys[1]].map(|keys| {
                let clip = Clip::new(joints, keys).unwrap();
                Sampled::new(Sclerp, clip, &at[range.clone()], &t[range.clone()]).unwrap()
            });
            Layered::blend(Sclerp, base, layer, &weights[range]).mask(&mask)
        };
        let pairs = |range: Range<usize>| {
            RotationsTranslations(&seven[range.start * joints..range.end * joints])
        };
        let mut groups = vec![
            run.poses(&locals),
            run.models(pairs),
            run.models(layers),
            run.palettes(&locals, &binds),
            run.model_to_local(&locals),
            run.plan(&locals),
        ];
        let four = Crowd::<R, 4>::from_slice(joints, &locals).unwrap();
        let eight = Crowd::<R, 8>::from_slice(joints, &locals).unwrap();
        let other = Crowd::<R, W>::from_slice(joints, &locals).unwrap();
        let of_poses = [
            run.in_blocks(Poses(four.blocks()), &binds),
            run.in_blocks(Poses(eight.blocks()), &binds),
            run.in_blocks(Poses(other.blocks()), &binds),
        ];
        let all = layers(0..instances);
        let of_layers = [
            run.in_blocks::<4, _>(all, &binds),
            run.in_blocks::<8, _>(all, &binds),
            run.in_blocks::<W, _>(all, &binds),
        ];
        let names = ["blocks of 4", "blocks of 8", "blocks of another width"];
        for blocks in [of_poses, of_layers] {
            let entries = names.into_iter().zip(blocks.map(|both| both.concat()));
            groups.push(entries.collect());
        }
        groups
    }

    /// A stride that is packed: keys of 16 bits.
    pub(crate) fn packed(&mut self) -> Vec<Entries> {
        let clips = PackedClips::from_bytes(STRIDE).unwrap();
        let parents: Vec<u32> =
            (0..clips.joints()).map(|joint| (joint as u32).wrapping_sub(1)).collect();
        let run = self.run(&parents);
        let times = (0..run.roots.len())
            .map(|_| <R as dq8::Real>::from_f64(self.random.between(0.0, 32.0)));
        let (at, t): (Vec<_>, Vec<_>) = times.map(|time| clips.place(0, time).unwrap()).unzip();
        let sampled = |range: Range<usize>| {
            Sampled::new(NlerpLerp, clips, &at[range.clone()], &t[range]).unwrap()
        };
        let binds = vec![DualQuat::IDENTITY; parents.len()];
        let all = sampled(0..run.roots.len());
        let [four, eight] =
            [run.in_blocks::<4, _>(all, &binds), run.in_blocks::<8, _>(all, &binds)];
        let blocks = [("blocks of 4", four.concat()), ("blocks of 8", eight.concat())];
        vec![run.models(sampled), blocks.into()]
    }

    /// Kernels over slices: together, one by one, and in blocks.
    pub(crate) fn slices(&mut self) -> Vec<Entries> {
        let count = 1 + self.random.below(33);
        let (a, b) = (self.motions(count), self.motions(count));
        let backend = self.backend;
        let (mut together, mut alone) = (a.clone(), a.clone());
        backend.mul(&a, &b, &mut together).unwrap();
        for i in 0..count {
            backend.mul(&a[i..=i], &b[i..=i], &mut alone[i..=i]).unwrap();
        }
        let (four, eight) = (product::<R, 4>(backend, &a, &b), product::<R, 8>(backend, &a, &b));
        vec![vec![
            ("together", of_motions(&together)),
            ("one by one", of_motions(&alone)),
            ("blocks of 4", four),
            ("blocks of 8", eight),
            ("blocks of another width", product::<R, W>(backend, &a, &b)),
        ]]
    }
}

fn product<R: Scalar, const N: usize>(
    backend: Backend,
    a: &[DualQuat<R>],
    b: &[DualQuat<R>],
) -> Vec<u64>
where
    [R; N]: Row<Real = R>,
{
    let [mut left, mut right, mut both] =
        [(); 3].map(|()| vec![Block::<R, N>::splat([R::ZERO; 8]); a.len().div_ceil(N)]);
    pack(1, a, &mut left).unwrap();
    pack(1, b, &mut right).unwrap();
    backend.mul(&left, &right, &mut both).unwrap();
    let mut products = a.to_vec();
    unpack(1, &both, &mut products).unwrap();
    of_motions(&products)
}

/// The frames of a clip.
const FRAMES: usize = 4;

const STRIDE: &[u8] = include_bytes!("../firmware/jobs/src/stride.clips");
