use crate::errors::errors;

errors! {
    /// What [`TwoBone`](crate::ik::TwoBone) cannot bend.
    #[derive(Clone, Copy, Debug, PartialEq)]
    #[cfg_attr(feature = "defmt", derive(defmt::Format))]
    LimbError {
        /// A bone of negative or infinite length, or NaN.
        Length { bone: usize = "The bone, 0 for the one at the root.", value: f64 = "Its length." }
            => "bone {bone} cannot have the length {value}";
        /// A coordinate that is not finite.
        NotFinite { what: &'static str = "Of what.", index: usize = "The axis.", value: f64 = "The coordinate." }
            => "the {what} is not finite: coordinate {index} is {value}";
    }
}
