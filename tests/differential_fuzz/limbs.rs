//! Limbs of two bones: the same bits for many at once, one by one, single, and in blocks of any
//! width.

use super::kernels::{Entries, Scene, from, of_motions, of_numbers};
use dq8::ik::{Limb, TwoBone};
use dq8::storage::{Block, pack, unpack};
use dq8::{Backend, Crowd, DualQuat, Hierarchy, Quat, Scalar};
use dq8_contract::fusing::fuses;
use dq8_simd::Row;

const PARENTS: [u32; 4] = [Hierarchy::ROOT, 0, 1, 2];
const JOINTS: usize = PARENTS.len();

/// Root, lengths, target, pole.
type Asked<R> = ([R; 3], [R; 2], [R; 3], [R; 3]);

impl<R, const W: usize> Scene<'_, R, W>
where
    [R; 4]: Row<Real = R>,
    [R; 8]: Row<Real = R>,
    [R; W]: Row<Real = R>,
    R: Scalar,
{
    /// Of any bits, as far as there is an answer; now and then with its target at the root, and
    /// equal bones.
    fn limb(&mut self) -> Asked<R> {
        loop {
            let [root, target, pole] = [(); 3].map(|()| [(); 3].map(|()| self.number()));
            let lengths = [(); 2].map(|()| self.number().abs());
            let limb = match self.random.below(8) {
                0 => (root, lengths, root, pole),
                1 => (root, [lengths[0]; 2], target, pole),
                2 => (root, lengths, target, [R::ZERO; 3]),
                _ => (root, lengths, target, pole),
            };
            if TwoBone::reach(limb.0, limb.1, limb.2, limb.3).is_ok() {
                return limb;
            }
        }
    }

    pub(crate) fn limbs(&mut self) -> Vec<Entries> {
        let (count, backend) = (1 + self.random.below(40), self.backend);
        let limbs: Vec<_> = (0..count).map(|_| self.limb()).collect();
        let mut slices = vec![
            ("together", together(backend, &limbs)),
            ("one by one", limbs.chunks(1).flat_map(|limb| together(backend, limb)).collect()),
            ("blocks of 4", in_blocks::<R, 4>(backend, &limbs)),
            ("blocks of 8", in_blocks::<R, 8>(backend, &limbs)),
            ("blocks of another width", in_blocks::<R, W>(backend, &limbs)),
        ];
        if !fuses(backend) {
            slices.push(("single", limbs.iter().flat_map(single).collect()));
        }
        vec![slices, self.legs(&limbs)]
    }

    /// A leg in each of the instances.
    fn legs(&mut self, limbs: &[Asked<R>]) -> Entries {
        let (count, backend) = (limbs.len(), self.backend);
        let locals: Vec<_> = (0..count * JOINTS)
            .map(|_| DualQuat::from_array(self.random.motion(2.0).to_array().map(from)))
            .collect();
        let hinge = [(); 3].map(|()| from(self.random.signed()));
        let limb = Limb { joints: [1, 2, 3], hinge };
        // Places of any bits have no answer where a sum has none.
        let within = |point: [R; 3]| point.map(|c| if c.abs() < from(1e6) { c } else { R::ONE });
        let targets: Vec<_> = limbs.iter().map(|limb| within(limb.2)).collect();
        let poles: Vec<_> = limbs.iter().map(|limb| within(limb.3)).collect();
        let tree = Hierarchy::new(&PARENTS).unwrap();
        let job = tree.job().backend(backend);
        let mut models = locals.clone();
        job.local_to_model_in_place(&mut models).unwrap();
        let (mut all, mut alone) = (locals.clone(), locals.clone());
        job.two_bone(&limb, &models, &targets, &poles, &mut all).unwrap();
        for (i, locals) in alone.chunks_mut(JOINTS).enumerate() {
            let models = &models[i * JOINTS..][..JOINTS];
            job.two_bone(&limb, models, &targets[i..=i], &poles[i..=i], locals).unwrap();
        }
        macro_rules! blocks {
            ($n:expr) => {{
                let crowd = |of: &[_]| Crowd::<R, $n>::from_slice(JOINTS, of).unwrap();
                let points = |of: &[_]| Crowd::<R, $n, 3>::from_slice(1, of).unwrap();
                let (mut new, models) = (crowd(&locals), crowd(&models));
                let (targets, poles) = (points(&targets), points(&poles));
                let (targets, poles) = (targets.blocks(), poles.blocks());
                job.two_bone(&limb, models.blocks(), targets, poles, new.blocks_mut()).unwrap();
                of_motions(&new.to_vec())
            }};
        }
        vec![
            ("skeletons together", of_motions(&all)),
            ("skeletons one by one", of_motions(&alone)),
            ("skeletons in blocks of 4", blocks!(4)),
            ("skeletons in blocks of 8", blocks!(8)),
            ("skeletons in blocks of another width", blocks!(W)),
        ]
    }
}

fn single<R: Scalar>(&(root, lengths, target, pole): &Asked<R>) -> Vec<u64> {
    let limb = TwoBone::reach(root, lengths, target, pole).unwrap();
    of_numbers(&[limb.upper.to_array(), limb.lower.to_array()].concat())
}

/// Upper and lower in turns.
fn in_turns<R: Scalar>(uppers: &[[R; 4]], lowers: &[[R; 4]]) -> Vec<u64> {
    uppers.iter().zip(lowers).flat_map(|(a, b)| of_numbers(&[*a, *b].concat())).collect()
}

fn together<R: Scalar>(backend: Backend, limbs: &[Asked<R>]) -> Vec<u64> {
    let of = |point: fn(&Asked<R>) -> [R; 3]| limbs.iter().map(point).collect::<Vec<_>>();
    let lengths: Vec<_> = limbs.iter().map(|limb| limb.1).collect();
    let (roots, targets, poles) = (of(|limb| limb.0), of(|limb| limb.2), of(|limb| limb.3));
    let mut uppers = vec![Quat::IDENTITY.to_array(); limbs.len()];
    let mut lowers = uppers.clone();
    backend.two_bone(&roots, &lengths, &targets, &poles, &mut uppers, &mut lowers).unwrap();
    in_turns(&uppers, &lowers)
}

fn in_blocks<R: Scalar, const N: usize>(backend: Backend, limbs: &[Asked<R>]) -> Vec<u64>
where
    [R; N]: Row<Real = R>,
{
    let count = limbs.len().div_ceil(N);
    let of = |point: fn(&Asked<R>) -> [R; 3]| {
        let mut blocks = vec![Block::<R, N, 3>::splat([R::ZERO; 3]); count];
        pack(1, &limbs.iter().map(point).collect::<Vec<_>>(), &mut blocks).unwrap();
        blocks
    };
    let mut lengths = vec![Block::<R, N, 2>::splat([R::ZERO; 2]); count];
    pack(1, &limbs.iter().map(|limb| limb.1).collect::<Vec<_>>(), &mut lengths).unwrap();
    let (roots, targets, poles) = (of(|limb| limb.0), of(|limb| limb.2), of(|limb| limb.3));
    let mut uppers = vec![Block::<R, N, 4>::splat([R::ZERO; 4]); count];
    let mut lowers = uppers.clone();
    backend.two_bone(&roots, &lengths, &targets, &poles, &mut uppers, &mut lowers).unwrap();
    let plain = |blocks: &[Block<R, N, 4>]| {
        let mut turns = vec![[R::ZERO; 4]; limbs.len()];
        unpack(1, blocks, &mut turns).unwrap();
        turns
    };
    in_turns(&plain(&uppers), &plain(&lowers))
}
