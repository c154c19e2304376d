//! The macro that defines a trait which scalars and lanes share. From one list of methods it makes
//! the trait, and a macro that writes the `impl` of the trait for a type by calls of the type's
//! inherent methods.

/// Defines the trait, and the macro `$delegate` that implements it for a type. The type must have
/// every method of the list `inherent` as an inherent method: in the `impl`, `Self::name` resolves
/// to the inherent method and not to that of the trait.
macro_rules! shared_trait {
    (
        $(#[$about:meta])*
        trait $Trait:ident: $($bound:path),*;
        delegate by $delegate:ident;
        types { $($types:tt)* }
        by_hand { $(
            $(#[$own:meta])*
            fn $of_each:ident($($given:ident $(: $kind:ty)?),*) -> $outcome:ty;
        )* }
        inherent { $(
            $(#[$method:meta])*
            fn $name:ident($($argument:ident $(: $type:ty)?),* $(,)?) -> $result:ty;
        )* }
    ) => {
        $(#[$about])*
        #[allow(clippy::double_must_use, reason = "some results are so by themselves")]
        pub trait $Trait: crate::contract::sealed::Sealed $(+ $bound)* {
            $($types)*

            /// The names of all methods of the trait, in the order of the definition.
            const METHODS: &'static [&'static str] =
                &[$(stringify!($of_each),)* $(stringify!($name)),*];

            $(
                $(#[$own])*
                #[must_use]
                fn $of_each($($given $(: $kind)?),*) -> $outcome;
            )*
            $(
                $(#[$method])*
                #[must_use]
                fn $name($($argument $(: $type)?),*) -> $result;
            )*
        }

        /// Writes the methods of the list `inherent` for an `impl` of the trait. The file with the
        /// `impl` must import the types of `geometry` that the list names.
        macro_rules! $delegate {
            () => { $(
                #[inline(always)]
                fn $name($($argument $(: $type)?),*) -> $result {
                    Self::$name($($argument),*)
                }
            )* };
        }
        pub(crate) use $delegate;
    };
}
pub(crate) use shared_trait;

pub(crate) mod sealed {
    /// The supertrait of the contracts, which other crates cannot name. So they cannot implement a
    /// contract, and a new method of a contract breaks no other crate.
    pub trait Sealed {}
}

/// Implements sums, differences and negation for types with a real and a dual part. The operators
/// act on each part.
macro_rules! sums_by_part {
    ($(#[$of_sum:meta])* [$($number:tt)+] #[$inlined:meta] $Thing:ty: ($($real:tt)+) ($($dual:tt)+)) => {
        $(#[$of_sum])*
        impl<$($number)+> core::ops::Add for $Thing {
            type Output = Self;
            #[$inlined]
            fn add(self, other: Self) -> Self {
                Self::new(self.$($real)+ + other.$($real)+, self.$($dual)+ + other.$($dual)+)
            }
        }
        impl<$($number)+> core::ops::Sub for $Thing {
            type Output = Self;
            #[$inlined]
            fn sub(self, other: Self) -> Self {
                Self::new(self.$($real)+ - other.$($real)+, self.$($dual)+ - other.$($dual)+)
            }
        }
        impl<$($number)+> core::ops::Neg for $Thing {
            type Output = Self;
            #[$inlined]
            fn neg(self) -> Self {
                Self::new(-self.$($real)+, -self.$($dual)+)
            }
        }
    };
}
pub(crate) use sums_by_part;
