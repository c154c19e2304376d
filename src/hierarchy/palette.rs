//! [`Epilogue`]: what is computed from a model, for example a palette, while it is in registers.

use super::locals::Motions;
use super::slot::JointSlot;
use crate::batch;
use crate::palette_entry::{MatrixOrder, PaletteEntry};
use crate::scalar::DualQuat;
use crate::storage::{Element, Layout, Number};
use dq8_simd::Level;

/// A computation from a model once it is known, as in the epilogue of a matrix product.
pub(super) trait Epilogue<E: Element<8>>: Sized + Send {
    /// `true` if there is anything to do.
    const ACTIVE: bool;
    fn run<V: Level>(&mut self, level: V, slot: JointSlot, model: Motions<E, V>);
    /// That of the models before number `at`, and that of the others.
    #[cfg_attr(not(feature = "rayon"), expect(dead_code, reason = "threads take parts"))]
    fn split(self, at: usize) -> (Self, Self);
}

/// Nothing.
pub(super) struct NoEpilogue;

impl<E: Element<8>> Epilogue<E> for NoEpilogue {
    const ACTIVE: bool = false;
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn run<V: Level>(&mut self, _: V, _: JointSlot, _: Motions<E, V>) {}
    fn split(self, _: usize) -> (Self, Self) {
        (Self, Self)
    }
}

/// model(j) · inverse bind(j), from the mesh in its rest pose to the posed mesh.
pub(super) struct Palette<'s, R, M, const C: usize> {
    pub(super) inverse_binds: &'s [DualQuat<R>],
    pub(super) order: MatrixOrder,
    pub(super) entries: &'s mut [M],
}

impl<E, M, const C: usize> Epilogue<E> for Palette<'_, Number<E, 8>, M, C>
where
    E: Element<8>,
    M: PaletteEntry<C, Layout = E::Layout>,
{
    const ACTIVE: bool = true;
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn run<V: Level>(&mut self, level: V, slot: JointSlot, model: Motions<E, V>) {
        let Some(bind) = slot.of_joint(level, bytemuck::must_cast_slice(self.inverse_binds)) else {
            return;
        };
        slot.prefetch(level, self.entries, E::Layout::records::<V>());
        let (entry, entries) = (model * batch::DualQuat::from_array(bind), &mut *self.entries);
        // Not one store of either order: where the two ways join, the compiler would move twelve
        // registers.
        match self.order {
            MatrixOrder::Rows => {
                M::store(M::of(entry, MatrixOrder::Rows), slot.within(entries), slot.tile());
            }
            MatrixOrder::Columns => {
                M::store(M::of(entry, MatrixOrder::Columns), slot.within(entries), slot.tile());
            }
        }
    }
    fn split(self, at: usize) -> (Self, Self) {
        let (begin, end) = self.entries.split_at_mut(at.min(self.entries.len()));
        let of = |entries| Self { entries, ..self };
        (of(begin), of(end))
    }
}
