/// The things that a register reads: register `register` of the block `element`; or, where a record
/// is one thing, those at `element`, `element + stride`, `element + 2·stride`, … one in each
/// lane.
#[derive(Clone, Copy, Debug)]
pub struct Tile {
    pub(crate) element: usize,
    pub(crate) register: usize,
    /// `None` is 1, which the compiler can see.
    pub(crate) stride: Option<usize>,
}

impl Tile {
    /// The lanes of one register of the block `element`, or as many records as it reads from there
    /// on.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn at(element: usize, register: usize) -> Self {
        Self { element, register, stride: None }
    }

    /// The same, of plain records that lie `stride` records apart; of blocks, the register alone
    /// counts.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn strided(self, stride: usize) -> Self {
        Self { stride: Some(stride), ..self }
    }
}
