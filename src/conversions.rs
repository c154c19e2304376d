//! [`From`] as a list of conversions, one a line.

macro_rules! conversions {
    ($($(#[$of:meta])* [$($number:tt)*] $from:ty => $to:ty: |$value:pat_param| $made:expr;)*) => {$(
        $(#[$of])*
        impl<$($number)*> From<$from> for $to {
            #[inline]
            fn from($value: $from) -> Self {
                $made
            }
        }
    )*};
}
pub(crate) use conversions;
