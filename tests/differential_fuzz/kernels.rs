//! Jobs, of which clips and skins are here: the same bits for many at once, one by one, and in
//! blocks of any width.

use super::Findings;
use dq8::hierarchy::{Clip, Sampled};
use dq8::law::{Law, Nlerp, Sclerp};
use dq8::skinning::{Blender, DualBlend, Linear, Skin, Surface, SurfaceMut};
use dq8::storage::{Block, pack, unpack};
use dq8::{Backend, Crowd, DualQuat, Hierarchy, Scalar};
use dq8_contract::fusing::fuses;
use dq8_contract::random::{Random, bits};
use dq8_simd::Row;
use std::marker::PhantomData;
use std::ops::Range;

/// Ways to compute the same numbers, and the bits of what they give.
pub(crate) type Entries = Vec<(&'static str, Vec<u64>)>;

/// Blocks have 4, 8 and `W` lanes.
pub(crate) fn round<R, const W: usize>(random: &mut Random, seed: u64, findings: &mut Findings)
where
    [R; 4]: Row<Real = R>,
    [R; 8]: Row<Real = R>,
    [R; W]: Row<Real = R>,
    R: Scalar,
{
    let state = random.0;
    // What the first backend without fused instructions gave, job by job.
    let mut unfused: Option<Vec<Vec<u64>>> = None;
    for backend in backends() {
        // The same numbers for each.
        random.0 = state;
        let mut scene = Scene::<R, W> { random, backend, real: PhantomData };
        let jobs = [
            ("clip, NLERP", scene.clip(Nlerp)),
            ("clip, ScLERP", scene.clip(Sclerp)),
            ("skin", scene.skin()),
            ("skeleton", scene.skeleton()),
            ("packed clip", scene.packed()),
            ("product", scene.slices()),
            ("limb", scene.limbs()),
        ];
        let mut find = |job: &str, other: &str, got: &[u64], wanted: &[u64]| {
            assert_eq!(got.len(), wanted.len());
            if let Some(at) = got.iter().zip(wanted).position(|(got, wanted)| got != wanted) {
                let what = format!("{job}, {backend}, {other}: other bits");
                findings.add(what, 1.0, || format!("seed {seed}: number {at}"));
            }
        };
        let mut all = Vec::new();
        for (job, groups) in &jobs {
            for entries in groups {
                let (first, wanted) = &entries[0];
                for (entry, got) in &entries[1..] {
                    find(job, &format!("{entry} and {first}"), got, wanted);
                }
                all.extend(entries.iter().map(|(entry, numbers)| (*job, *entry, numbers)));
            }
        }
        if !fuses(backend) {
            let first =
                unfused.get_or_insert_with(|| all.iter().map(|each| each.2.clone()).collect());
            for ((job, entry, got), wanted) in all.iter().zip(first) {
                find(job, &format!("{entry} and other lanes"), got, wanted);
            }
        }
        findings.calls += all.iter().map(|each| each.2.len() as u64).sum::<u64>();
    }
}

/// With the feature `reproducible`, each without fused instructions too.
pub(crate) fn backends() -> impl Iterator<Item = Backend> {
    #[cfg(feature = "reproducible")]
    return Backend::available().flat_map(|backend| [backend, backend.unfused()]);
    #[cfg(not(feature = "reproducible"))]
    return Backend::available();
}

pub(crate) struct Scene<'r, R, const W: usize> {
    pub(crate) random: &'r mut Random,
    pub(crate) backend: Backend,
    real: PhantomData<R>,
}

impl<R, const W: usize> Scene<'_, R, W>
where
    [R; 4]: Row<Real = R>,
    [R; 8]: Row<Real = R>,
    [R; W]: Row<Real = R>,
    R: Scalar,
{
    /// An ordinary number, and seldom one of any bits.
    pub(crate) fn number(&mut self) -> R {
        from(self.random.number(R::SINGLE, 0.01))
    }

    /// Unit; seldom with numbers of any bits. One in three turns about a coordinate axis, as joints
    /// do, so that motions are at right angles, and has zeros of both signs.
    fn motion(&mut self) -> DualQuat<R> {
        if self.random.below(3) == 0 {
            return self.random.turned();
        }
        let motion = self.random.motion(2.0).to_array().map(from);
        let hostile = self.random.below(16) == 0;
        DualQuat::from_array(motion.map(|number| if hostile { self.number() } else { number }))
    }

    pub(crate) fn motions(&mut self, count: usize) -> Vec<DualQuat<R>> {
        (0..count).map(|_| self.motion()).collect()
    }

    fn clip(&mut self, law: impl Law<8>) -> Vec<Entries> {
        let (joints, frames, instances) = (5, 4, 1 + self.random.below(20));
        let parents = [Hierarchy::ROOT, 0, 1, 0, 3];
        let tree = Hierarchy::new(&parents).unwrap();
        let keys = self.motions(joints * frames);
        let clip = Clip::new(joints, &keys).unwrap();
        let at: Vec<_> = (0..instances).map(|_| self.random.below(frames - 1) as u32).collect();
        let t: Vec<_> = (0..instances).map(|_| self.number()).collect();
        let sampled =
            |range: Range<usize>| Sampled::new(law, clip, &at[range.clone()], &t[range]).unwrap();
        let (all, backend) = (sampled(0..instances), self.backend);
        let mut together = vec![DualQuat::IDENTITY; instances * joints];
        tree.job().backend(backend).locals_to_model(all, &mut together).unwrap();
        let mut alone = together.clone();
        for (i, models) in alone.chunks_mut(joints).enumerate() {
            tree.job().backend(backend).locals_to_model(sampled(i..i + 1), models).unwrap();
        }
        let mut four = Crowd::<R, 4>::new(joints, instances);
        let mut eight = Crowd::<R, 8>::new(joints, instances);
        let mut other = Crowd::<R, W>::new(joints, instances);
        tree.job().backend(backend).locals_to_model(all, four.blocks_mut()).unwrap();
        tree.job().backend(backend).locals_to_model(all, eight.blocks_mut()).unwrap();
        tree.job().backend(backend).locals_to_model(all, other.blocks_mut()).unwrap();
        vec![
            vec![("together", of_motions(&together)), ("one by one", of_motions(&alone))],
            vec![
                ("blocks of 4", of_motions(&four.to_vec())),
                ("blocks of 8", of_motions(&eight.to_vec())),
                ("blocks of another width", of_motions(&other.to_vec())),
            ],
        ]
    }

    fn skin(&mut self) -> Vec<Entries> {
        let (joints, vertices) = (12, 1 + self.random.below(40));
        let influences = [1, 3, 4, 6][self.random.below(4)];
        let (mut who, mut weights) = (Vec::new(), Vec::new());
        for _ in 0..vertices {
            let some: Vec<_> = (0..influences).map(|_| self.random.between(0.1, 1.0)).collect();
            let total: f64 = some.iter().sum();
            who.extend(some.iter().map(|_| self.random.below(joints) as u16));
            weights.extend(some.iter().map(|weight| from::<f32>(weight / total)));
        }
        let motions = self.motions(joints);
        let matrices: Vec<_> = motions.iter().map(|motion| motion.to_matrix3x4()).collect();
        let rest: Vec<[R; 3]> = (0..vertices).map(|_| [(); 3].map(|()| self.number())).collect();
        let mesh = Mesh { backend: self.backend, joints, influences, who, weights, rest };
        vec![mesh.entries::<W>(Linear::new(&matrices)), mesh.entries::<W>(DualBlend::new(&motions))]
    }
}

struct Mesh<R> {
    backend: Backend,
    joints: usize,
    influences: usize,
    who: Vec<u16>,
    weights: Vec<f32>,
    rest: Vec<[R; 3]>,
}

impl<R: Scalar> Mesh<R>
where
    [R; 4]: Row<Real = R>,
    [R; 8]: Row<Real = R>,
{
    fn entries<const W: usize>(&self, blend: impl Blender<R>) -> Entries
    where
        [R; W]: Row<Real = R>,
    {
        let skin = Skin::new(self.joints, self.influences, &self.who, &self.weights).unwrap();
        let mut together = self.rest.clone();
        let (rest, posed) = (Surface::positions(&self.rest), SurfaceMut::positions(&mut together));
        skin.job().backend(self.backend).pose(blend, rest, posed).unwrap();
        let mut alone = self.rest.clone();
        let (who, weights) =
            (self.who.chunks(self.influences), self.weights.chunks(self.influences));
        let each = who.zip(weights).zip(self.rest.chunks(1)).zip(alone.chunks_mut(1));
        for (((who, weights), rest), posed) in each {
            let skin = Skin::new(self.joints, self.influences, who, weights).unwrap();
            let (rest, posed) = (Surface::positions(rest), SurfaceMut::positions(posed));
            skin.job().backend(self.backend).pose(blend, rest, posed).unwrap();
        }
        vec![
            ("together", of_numbers(together.as_flattened())),
            ("one by one", of_numbers(alone.as_flattened())),
            ("blocks of 4", self.in_blocks::<4>(&skin, blend)),
            ("blocks of 8", self.in_blocks::<8>(&skin, blend)),
            ("blocks of another width", self.in_blocks::<W>(&skin, blend)),
        ]
    }

    fn in_blocks<const N: usize>(
        &self,
        skin: &Skin<'_, u16, f32>,
        blend: impl Blender<R>,
    ) -> Vec<u64>
    where
        [R; N]: Row<Real = R>,
    {
        let mut rest = vec![Block::<R, N, 3>::splat([R::ZERO; 3]); self.rest.len().div_ceil(N)];
        pack(1, &self.rest, &mut rest).unwrap();
        let mut posed = rest.clone();
        let surface = SurfaceMut::positions(&mut posed);
        skin.job().backend(self.backend).pose(blend, Surface::positions(&rest), surface).unwrap();
        let mut points = self.rest.clone();
        unpack(1, &posed, &mut points).unwrap();
        of_numbers(points.as_flattened())
    }
}

pub(crate) fn from<R: Scalar>(number: f64) -> R {
    <R as dq8::Real>::from_f64(number)
}

pub(crate) fn of_numbers<R: Scalar>(numbers: &[R]) -> Vec<u64> {
    numbers.iter().map(|&number| bits(number.into())).collect()
}

pub(crate) fn of_motions<R: Scalar>(motions: &[DualQuat<R>]) -> Vec<u64> {
    motions.iter().flat_map(|motion| motion.to_array()).map(|number| bits(number.into())).collect()
}
