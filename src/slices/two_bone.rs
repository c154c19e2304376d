//! The kernel over slices that bends limbs of two bones.

use super::sweep::GRAIN;
use crate::backend::{Backend, Kernel, Rows};
use crate::batch;
use crate::ik::{Asked, LimbsError, fault};
use crate::storage::shape::same_length;
use crate::storage::{self, Element, Layout, Register, Tile};
use core::ops::Range;
use dq8_simd::{Lanes, Level};

impl Backend {
    /// Computes the rotations of both bones of each limb so that its end reaches a target:
    /// `uppers[i]` and `lowers[i]` are the rotations that
    /// [`TwoBone::reach`](crate::ik::TwoBone::reach) finds for `roots[i]`, `lengths[i]`,
    /// `targets[i]` and `poles[i]`. Elements of `lengths` have two components, points three,
    /// rotations four. For the limbs of skeletons there is [`Job::two_bone`](crate::Job::two_bone).
    ///
    /// # Errors
    /// If the slices differ in length, or a limb cannot be bent; the error has the index of the
    /// first such limb. All limbs are checked before any rotation is written.
    ///
    /// ```
    /// use dq8::{Backend, Quat, ik::TwoBone};
    /// // Two legs of 0.4 and 0.4 under hips at a height of 0.7; the knees bend forward, +y.
    /// let (roots, lengths) = ([[-0.1_f32, 0.0, 0.7], [0.1, 0.0, 0.7]], [[0.4, 0.4]; 2]);
    /// let (targets, poles) = ([[-0.1, 0.2, 0.1], [0.1, -0.1, 0.0]], [[0.0, 1.0, 0.0]; 2]);
    /// let (mut uppers, mut lowers) = ([Quat::IDENTITY; 2], [Quat::IDENTITY; 2]);
    /// Backend::best().two_bone(&roots, &lengths, &targets, &poles, &mut uppers, &mut lowers)?;
    /// let (knee, shin) = (uppers[1].rotate([0.4, 0.0, 0.0]), lowers[1].rotate([0.4, 0.0, 0.0]));
    /// assert!((0.7 + knee[2] + shin[2]).abs() < 1e-6);
    /// let alone = TwoBone::reach(roots[1], lengths[1], targets[1], poles[1])?;
    /// assert!(alone.upper.abs_diff_eq(uppers[1], 1e-6));
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[doc(alias("IKTwoBoneJob"))]
    pub fn two_bone<P, N, Q>(
        self,
        roots: &[P],
        lengths: &[N],
        targets: &[P],
        poles: &[P],
        uppers: &mut [Q],
        lowers: &mut [Q],
    ) -> Result<(), LimbsError>
    where
        P: Element<3>,
        N: Element<2, Layout = P::Layout>,
        Q: Element<4, Layout = P::Layout>,
    {
        let count = roots.len();
        for (what, length) in [
            ("lengths", lengths.len()),
            ("targets", targets.len()),
            ("poles", poles.len()),
            ("uppers", uppers.len()),
            ("lowers", lowers.len()),
        ] {
            same_length(what, length, count)?;
        }
        let limbs = Limbs { roots, lengths, targets, poles };
        if let Some(fault) = self.run(Check(limbs)) {
            return Err(fault);
        }
        self.share(
            GRAIN,
            ((uppers, 1), (lowers, 1)),
            &|first, outputs: (Rows<'_, Q>, Rows<'_, Q>)| {
                let ((uppers, _), (lowers, _)) = outputs;
                let Some(limbs) = limbs.part(first..first + uppers.len()) else { return };
                self.run(Reach { limbs, uppers, lowers });
            },
        );
        Ok(())
    }
}

/// The input slices of a call; all have the same length.
#[derive(Clone, Copy)]
struct Limbs<'s, P, N> {
    roots: &'s [P],
    lengths: &'s [N],
    targets: &'s [P],
    poles: &'s [P],
}

impl<P: Element<3>, N: Element<2, Layout = P::Layout>> Limbs<'_, P, N> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn load<V: Level>(&self, level: V, tile: Tile) -> Option<Asked<Register<P, V, 3>>> {
        let point = storage::identity();
        Some((
            P::load(level, self.roots, tile, &point)?,
            N::load(level, self.lengths, tile, &storage::identity())?,
            P::load(level, self.targets, tile, &point)?,
            P::load(level, self.poles, tile, &point)?,
        ))
    }

    fn part(&self, limbs: Range<usize>) -> Option<Self> {
        Some(Self {
            roots: self.roots.get(limbs.clone())?,
            lengths: self.lengths.get(limbs.clone())?,
            targets: self.targets.get(limbs.clone())?,
            poles: self.poles.get(limbs)?,
        })
    }
}

/// The search for the first limb that cannot be bent.
struct Check<'s, P, N>(Limbs<'s, P, N>);

impl<P: Element<3>, N: Element<2, Layout = P::Layout>> Kernel for Check<'_, P, N> {
    type Output = Option<LimbsError>;
    const WIDE: bool = P::Layout::WIDE;

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn run<V: Level>(self, level: V) -> Self::Output {
        let Self(limbs) = self;
        let lanes = Register::<P, V, 3>::LANES;
        for tile in storage::tiles::<P, V, 3>(limbs.roots.len()) {
            let first = tile.element * P::Layout::THINGS + tile.register * lanes;
            let found = fault(limbs.load(level, tile)?, first);
            if found.is_some() {
                return found;
            }
        }
        None
    }
}

struct Reach<'s, P, N, Q> {
    limbs: Limbs<'s, P, N>,
    uppers: &'s mut [Q],
    lowers: &'s mut [Q],
}

impl<P, N, Q> Kernel for Reach<'_, P, N, Q>
where
    P: Element<3>,
    N: Element<2, Layout = P::Layout>,
    Q: Element<4, Layout = P::Layout>,
{
    type Output = ();
    // AVX-512 pays for plain limbs too: square roots and divisions take most of the time, and the
    // transposes little.
    const WIDE: bool = true;

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn run<V: Level>(self, level: V) {
        let Self { limbs, uppers, lowers } = self;
        for tile in storage::tiles::<Q, V, 4>(uppers.len()) {
            let Some((root, lengths, target, pole)) = limbs.load(level, tile) else { return };
            let found = batch::TwoBone::reach(root, lengths, target, pole);
            Q::store(found.upper.to_array(), uppers, tile);
            Q::store(found.lower.to_array(), lowers, tile);
        }
    }
}
