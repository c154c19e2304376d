use core::num::NonZeroU32;

/// The joints at which a run over a hierarchy normalizes model poses exactly.
///
/// Products of unit motions are unit up to rounding, and rounding adds up: about 10⁻⁷ √n
/// (`f32`) in the norm after n products, less than a skeleton can show. `lab/src/products.rs`
/// measures it; in short:
///
/// - normalizing does **not** make rotations more accurate, it only keeps the norm;
/// - chains of up to thousands of joints do not need it: [`Never`](Self::Never) is the default;
/// - where a product goes on for long (odometry, physics), normalize exactly and rarely:
///   [`Every`](Self::Every) 64 joints is as good as every one;
/// - dividing by the norm of the real part alone does not normalize: it leaves the dual part with a
///   component that is not a translation.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Renormalize {
    /// Products only.
    #[default]
    Never,
    /// The model of every n-th joint, counted along the parent array: joints n − 1, 2n − 1, …
    Every(NonZeroU32),
}

impl Renormalize {
    /// `true` if the model of this joint is normalized.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn applies_to(self, joint: usize) -> bool {
        match self {
            Self::Never => false,
            Self::Every(n) => (joint + 1).is_multiple_of(n.get() as usize),
        }
    }
}
