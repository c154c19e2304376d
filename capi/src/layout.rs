//! [`Layout`]: how things lie in memory, one an element or in blocks, so that each function is
//! written once.

use core::marker::PhantomData;
use dq8::hierarchy::PaletteEntry;
use dq8::{
    Block, DualQuat, Float, MatrixBlock, NumberBlock, Place, PointBlock, Pose, Quat, Real,
    RotationBlock, RotationTranslationBlock, place,
};
use dq8_simd::Row;

/// The types of all that is in one layout. All are numbers through and through: any bits are a value.
pub(crate) trait Layout {
    type Real: Real + Float;
    /// What `dq8` calls this layout.
    type Lanes: place::Layout<Real = Self::Real>;
    type Number: Place<1, Layout = Self::Lanes>;
    type Point: Place<3, Layout = Self::Lanes>;
    type Rotation: Copy;
    type RotationTranslation: Copy;
    type Motion: Place<8, Layout = Self::Lanes>
        + Pose<
            Real = Self::Real,
            Rotation = Self::Rotation,
            RotationTranslation = Self::RotationTranslation,
        > + PaletteEntry<Self::Motion>;
    type Matrix3x4: Place<12, Layout = Self::Lanes> + PaletteEntry<Self::Motion>;
    type Matrix4x4: Place<16, Layout = Self::Lanes>;
}

/// One thing an element.
pub(crate) struct Plain<R>(PhantomData<R>);

impl<R: Real + Float> Layout for Plain<R>
where
    R: Place<1, Layout = place::Plain<R>>,
{
    type Real = R;
    type Lanes = place::Plain<R>;
    type Number = R;
    type Point = [R; 3];
    type Rotation = Quat<R>;
    type RotationTranslation = [R; 7];
    type Motion = DualQuat<R>;
    type Matrix3x4 = [[R; 4]; 3];
    type Matrix4x4 = [[R; 4]; 4];
}

/// `N` things an element.
pub(crate) struct Blocks<R, const N: usize>(PhantomData<R>);

impl<R: Real + Float, const N: usize> Layout for Blocks<R, N>
where
    [R; N]: Row<Real = R>,
{
    type Real = R;
    type Lanes = place::InBlocks<[R; N]>;
    type Number = NumberBlock<R, N>;
    type Point = PointBlock<R, N>;
    type Rotation = RotationBlock<R, N>;
    type RotationTranslation = RotationTranslationBlock<R, N>;
    type Motion = Block<R, N>;
    type Matrix3x4 = MatrixBlock<R, N>;
    type Matrix4x4 = dq8_simd::Block<[R; N], 16>;
}
