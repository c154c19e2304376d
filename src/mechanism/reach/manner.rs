//! Where the searches of arms and of mechanisms differ. All else is one text.

/// The squared error must fall to this part of itself where there is another beginning.
pub(super) const PROGRESS: f32 = 0.4;

/// What a search does where steps lead nowhere.
#[derive(Clone, Copy, Debug)]
pub(super) struct Manner {
    /// A step that limits cut so short that even its own linear model leaves more than this part of the
    /// squared error is the last, where there is another beginning.
    pub(super) hope: f32,
    /// Whether that model goes straight on as everything begins to move, or along the bent columns of the step.
    pub(super) hopes_straight: bool,
    /// Whether the last twelfth of the iterations is for the nearest pose that was found, where none has
    /// arrived until then.
    pub(super) settles: bool,
    /// Whether steps are damped more after one that led away, where there is no other beginning (Marquardt
    /// 1963).
    pub(super) is_cautious: bool,
    /// Whether slides are no longer than a step may be. What slides without end may have a long way to go.
    pub(super) shortens_slides: bool,
}

impl Manner {
    /// An arm has a plain search beside it that takes the same steps, `tests/ik/reference.rs`. It begins again
    /// from the poses that it keeps, of which the next is always another: nothing has to be tried for longer.
    pub(super) const ARM: Self = Self {
        hope: PROGRESS,
        hopes_straight: true,
        settles: false,
        is_cautious: false,
        shortens_slides: true,
    };

    /// Of 10,000 random targets of an arm of seven axes it is 9,997 that are reached; with the part that is
    /// progress as the hope 9,993. Straight on, searches begin again twice as often.
    pub(super) const MECHANISM: Self = Self {
        hope: 0.2,
        hopes_straight: false,
        settles: true,
        is_cautious: true,
        shortens_slides: false,
    };
}
