//! `Debug` of what holds many numbers: on a line, how many of what. Whoever prints a struct that
//! holds a clip wants to read it.

/// `Debug` for each type: its name, and names with values.
#[doc(hidden)]
#[macro_export]
macro_rules! __brief {
    ($([$($generics:tt)*] $Type:ty $(, where [$($bounds:tt)*])?: $name:ident |$it:ident| {
        $($field:ident: $value:expr),+ $(,)?
    })*) => {$(
        impl<$($generics)*> core::fmt::Debug for $Type $(where $($bounds)*)? {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                let $it = self;
                f.debug_struct(stringify!($name))$(.field(stringify!($field), &$value))+.finish()
            }
        }
    )*};
}
pub use __brief as brief;
