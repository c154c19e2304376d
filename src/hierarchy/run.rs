//! What every loop over a hierarchy is told. Lengths have been checked.

use super::locals::Motions;
use super::renormalize::Renormalize;
use crate::batch;
use crate::scalar::DualQuat;
use crate::storage::{self, Element, Number, Tile};
use core::ops::Range;
use dq8_simd::Level;

/// The fewest elements in a task of a thread: some microseconds of work, where starting a task
/// takes a fraction of one.
const GRAIN: usize = 2048;

/// The instances of a task; there are joints.
pub(super) fn grain(joints: usize) -> usize {
    GRAIN.div_ceil(joints)
}

/// The hierarchy, which joints of it, what they stand on, and when they are normalized.
#[derive(Clone, Debug)]
pub(super) struct Run<'a, E: Element<8>> {
    pub(super) parents: &'a [u32],
    pub(super) joints: Range<usize>,
    pub(super) root: Root<'a, E>,
    pub(super) renormalize: Renormalize,
}

/// The base that root joints stand on.
#[derive(Clone, Debug)]
pub enum Root<'a, E: Element<8>> {
    /// Nothing: their local pose is their model pose.
    None,
    /// The same motion for every instance.
    Same(DualQuat<Number<E, 8>>),
    /// A motion for each instance, one element for each instance (block).
    Each(&'a [E]),
}

impl<E: Element<8>> Root<'_, E> {
    /// The base of the root of `instance` (block); of so many instances as there are lanes where
    /// records are single things.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn load<V: Level>(
        &self,
        level: V,
        instance: usize,
        register: usize,
    ) -> Option<Motions<E, V>> {
        match *self {
            Self::None => None,
            Self::Same(root) => Some(batch::DualQuat::splat(level, root)),
            Self::Each(roots) => {
                let tile = Tile::at(instance, register);
                let roots = E::load(level, roots, tile, &storage::identity())?;
                Some(batch::DualQuat::from_array(roots))
            }
        }
    }

    /// The roots of some of the instances (blocks).
    pub(super) fn part(&self, instances: Range<usize>) -> Self {
        match *self {
            Self::Each(roots) => Self::Each(roots.get(instances).unwrap_or_default()),
            _ => self.clone(),
        }
    }
}

impl<E: Element<8>> Run<'_, E> {
    /// The same for some of the instances (blocks).
    pub(super) fn part(&self, instances: Range<usize>) -> Self {
        Self { root: self.root.part(instances), ..self.clone() }
    }

    /// The base of the root of one instance, where records are single things.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn root_of(&self, instance: usize) -> Option<[Number<E, 8>; 8]> {
        match self.root {
            Root::None => None,
            Root::Same(root) => Some(root.to_array()),
            Root::Each(roots) => E::plain(roots)?.get(instance).copied(),
        }
    }
}
