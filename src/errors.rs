//! Errors as lists: of each what it is, what it names, and what it says.

/// An enum of errors. Each has documentation and a message, and fields, documented too, that the
/// message names; one that has another error as its cause holds it, is made from it, and has it as
/// its source; so has one that says `from` one of its fields.
#[doc(hidden)]
#[macro_export]
macro_rules! __errors {
    ($(#[$of:meta])* $name:ident {$(
        $(#[$doc:meta])*
        $variant:ident $({ $($field:ident: $type:ty = $says:literal),+ })? $(($cause:ident: $other:ty))? $(from $named:ident)?
            => $message:literal $(, $part:expr)*;
    )*}) => {
        $(#[$of])*
        #[non_exhaustive]
        pub enum $name {$(
            $(#[$doc])*
            $variant $({ $(#[doc = $says] $field: $type),+ })? $(($other))?,
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

/// A number of things, by their name: "1 element", "2 elements".
pub(crate) struct Count(pub(crate) usize, pub(crate) &'static str);

impl core::fmt::Display for Count {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let Self(number, name) = self;
        write!(f, "{number} {name}{}", if *number == 1 { "" } else { "s" })
    }
}
