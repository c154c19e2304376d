//! Calls and what they should say.

use std::fmt::Debug;

/// Every call said what it should.
#[track_caller]
pub(crate) fn answers<T: PartialEq + Debug>(calls: impl IntoIterator<Item = (T, T)>) {
    for (at, (got, wanted)) in calls.into_iter().enumerate() {
        assert_eq!(got, wanted, "case {at}");
    }
}
