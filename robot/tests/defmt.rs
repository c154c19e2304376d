//! What a controller logs when something fails: every result of a search, and every error.
#![cfg(feature = "defmt")]

use dq8_robot::MechanismError;
use dq8_robot::ik::{Family, Outcome, RatesError, ReachError, Report, Solutions, SolutionsError};

#[test]
fn defmt_formats_errors_and_results() {
    // Writing needs a logger of the board: that the types have the trait is what a host can tell.
    fn formats<T: defmt::Format>() {}
    formats::<(Outcome, Report<f32>, MechanismError, ReachError)>();
    formats::<(Family, Solutions<f32>, SolutionsError, RatesError)>();
}
