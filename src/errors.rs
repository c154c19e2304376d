//! Errors as lists: of each what it is, what it names, and what it says.

/// An enum of errors. Each has documentation and a message, and fields, documented too, that the message names; one that has another
/// error as its cause holds it, and is made from it.
#[doc(hidden)]
#[macro_export]
macro_rules! __errors {
    ($(#[$of:meta])* $name:ident {$(
        $(#[$doc:meta])*
        $variant:ident $({ $($field:ident: $type:ty = $says:literal),+ })? $(($cause:ident: $other:ty))?
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
        $($(impl From<$other> for $name {
            fn from(cause: $other) -> Self {
                Self::$variant(cause)
            }
        })?)*
    };
}
pub use __errors as errors;
