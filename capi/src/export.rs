//! Macros that write the functions C sees.

/// The functions of a file for both number types, each with the lanes that its blocks may have.
macro_rules! for_both_numbers {
    ($functions:ident) => {
        /// The functions for `f32`, whose names in C end in `_f32`.
        pub mod single {
            use super::*;
            $functions!(f32 [8 16]);
        }
        /// The functions for `f64`, whose names in C end in `_f64`.
        pub mod double {
            use super::*;
            $functions!(f64 [4 8]);
        }
    };
}

/// A function on plain arrays and its sibling on blocks, from the generic one of that name
/// in the file, which has the layout as its type parameter.
macro_rules! export {
    (
        $R:ident [$few:literal $many:literal]
        $(#[doc = $about:literal])*
        $plain:ident, $blocks:ident ($($argument:ident: $type:ty),* $(,)?)
    ) => {
        $(#[doc = $about])*
        ///
        /// # Safety
        /// Arrays have the lengths named.
        #[unsafe(export_name = concat!("dq8_", stringify!($plain), "_", stringify!($R)))]
        pub unsafe extern "C" fn $plain($($argument: $type,)* count: usize) -> Status {
            // SAFETY: promised.
            Status::of(unsafe { super::$plain::<Aos<$R>>($($argument,)* count) })
        }

        #[doc = concat!(
            " dq8_", stringify!($plain), "_", stringify!($R), " on blocks of ", stringify!($few),
            " or ", stringify!($many), " `lanes`; `count` is a number of blocks."
        )]
        ///
        /// # Safety
        /// Arrays have the lengths named, in blocks.
        #[unsafe(export_name = concat!("dq8_", stringify!($blocks), "_", stringify!($R)))]
        pub unsafe extern "C" fn $blocks(
            lanes: usize,
            $($argument: $type,)*
            count: usize,
        ) -> Status {
            Status::of(match lanes {
                // SAFETY: promised.
                $few => unsafe { super::$plain::<AoSoA<[$R; $few]>>($($argument,)* count) },
                // SAFETY: promised.
                $many => unsafe { super::$plain::<AoSoA<[$R; $many]>>($($argument,)* count) },
                _ => Err(Status::Lanes),
            })
        }
    };
}

/// A function of which there is one form, whose body is what it returns inside; on one thing,
/// `motion`, `mechanism` or `skin`, or on plain arrays.
macro_rules! export_one {
    ($R:ident $(#[doc = $about:literal])* $thing:ident::$name:ident($($arguments:tt)*) = $body:expr) => {
        export_one! {
            concat!("dq8_", stringify!($thing), "_", stringify!($name), "_", stringify!($R)),
            $(#[doc = $about])* $name($($arguments)*) = $body
        }
    };
    ($R:ident $(#[doc = $about:literal])* $name:ident($($arguments:tt)*) = $body:expr) => {
        export_one! {
            concat!("dq8_", stringify!($name), "_", stringify!($R)),
            $(#[doc = $about])* $name($($arguments)*) = $body
        }
    };
    (
        $export:expr,
        $(#[doc = $about:literal])*
        $name:ident($($argument:ident: $type:ty),* $(,)?) = $body:expr
    ) => {
        $(#[doc = $about])*
        ///
        /// # Safety
        /// Arrays have the lengths named; mechanisms and skins are zero or have been made.
        #[unsafe(export_name = $export)]
        pub unsafe extern "C" fn $name($($argument: $type),*) -> Status {
            // SAFETY: promised.
            Status::of(unsafe { $body })
        }
    };
}
