//! Macros that write implementations from a list: errors, conversions, and a short `Debug`.

/// Defines an enum of errors. The input lists the variants, each with its documentation, its
/// message, and its fields with their documentation. A variant may have a source, which is either
/// an error that it wraps, or a field, whose name follows the keyword `from`. An error that a
/// variant wraps can be converted into the enum by `From`.
#[doc(hidden)]
#[macro_export]
macro_rules! __errors {
    ($(#[$of:meta])* $name:ident {$(
        $(#[$doc:meta])*
        $variant:ident $({ $($(#[$says:meta])* $field:ident: $type:ty $(= $told:literal)?),+ $(,)? })? $(($cause:ident: $other:ty))? $(from $named:ident)?
            => $message:literal $(, $part:expr)*;
    )*}) => {
        $(#[$of])*
        #[non_exhaustive]
        pub enum $name {$(
            $(#[$doc])*
            $variant $({ $($(#[$says])* $(#[doc = $told])? $field: $type),+ })? $(($other))?,
        )*}

        impl core::fmt::Display for $name {
            #[allow(unused_variables, reason = "not every message names all")]
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                match self {$(
                    Self::$variant $({ $($field),+ })? $(($cause))? => write!(f, $message $(, $part)*),
                )*}
            }
        }
        impl core::error::Error for $name {
            #[allow(unused_variables, reason = "most have no cause")]
            fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
                match self {$(
                    Self::$variant $({ $($field),+ })? $(($cause))? => {
                        $(return Some($cause);)?
                        $(return Some($named);)?
                        #[allow(unreachable_code, reason = "those with a cause have returned")]
                        None
                    }
                )*}
            }
        }
        $($(impl From<$other> for $name {
            fn from(cause: $other) -> Self {
                Self::$variant(cause)
            }
        })?)*
    };
}
pub use __errors as errors;

/// A number of things and the singular noun for them, written as "1 element" or "2 elements".
pub(crate) struct Count(pub(crate) usize, pub(crate) &'static str);

impl core::fmt::Display for Count {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let Self(number, name) = self;
        write!(f, "{number} {name}{}", if *number == 1 { "" } else { "s" })
    }
}

/// Implements [`From`] for a list of conversions, one in each line: `from => to: |value| made`.
/// `Self` in `made` is the type behind the arrow.
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

/// Implements `Debug` for types that hold many values: it writes one line with the number and the
/// kind of the values.
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

/// The macro `pod` implements `bytemuck::Pod` for structs that consist of numbers only. The proof
/// that this is sound, and the `unsafe` code, are in `dq8_simd`. Modules with such structs import
/// the macro from here, so they need not name that crate.
pub(crate) use dq8_simd::pod;
