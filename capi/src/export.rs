//! Macros that define the exported functions.

/// Exports the functions of a module for `f32` and for `f64`. The macro `$functions` gets the
/// element type, and the two lane counts that blocks of this type may have.
macro_rules! for_both_numbers {
    ($functions:ident) => {
        /// The functions for `f32`. Their names in C end in `_f32`.
        pub mod single {
            use super::*;
            $functions!(f32 [8 16]);
        }
        /// The functions for `f64`. Their names in C end in `_f64`.
        pub mod double {
            use super::*;
            $functions!(f64 [4 8]);
        }
    };
}

/// Exports two functions: `$plain` on plain arrays, and `$blocks` on blocks. Both call the generic
/// function `$plain` of the module, whose type parameter is the layout of the arrays.
macro_rules! export {
    (
        $R:ident [$few:literal $many:literal]
        $(#[doc = $about:literal])*
        $plain:ident, $blocks:ident ($($argument:ident: $type:ty),* $(,)?)
    ) => {
        $(#[doc = $about])*
        ///
        /// # Safety
        /// Each array must have the length that the description states. No other thread may use the
        /// outputs or write the inputs during the call.
        #[unsafe(export_name = concat!("dq8_", stringify!($plain), "_", stringify!($R)))]
        pub unsafe extern "C" fn $plain($($argument: $type,)* count: usize) -> Status {
            // SAFETY: the generic function needs arrays of the stated lengths that no other thread
            // uses, which the caller guarantees.
            Status::of(unsafe { super::$plain::<Aos<$R>>($($argument,)* count) })
        }

        #[doc = concat!(
            " Does what dq8_", stringify!($plain), "_", stringify!($R), " does, on blocks of ",
            stringify!($few), " or ", stringify!($many),
            " `lanes`. `count` is the number of blocks."
        )]
        ///
        /// # Safety
        /// Each array must have the length that the description states, counted in blocks. No other
        /// thread may use the outputs or write the inputs during the call.
        #[unsafe(export_name = concat!("dq8_", stringify!($blocks), "_", stringify!($R)))]
        pub unsafe extern "C" fn $blocks(
            lanes: usize,
            $($argument: $type,)*
            count: usize,
        ) -> Status {
            Status::of(match lanes {
                // SAFETY: the generic function needs arrays of the stated lengths that no other
                // thread uses, which the caller guarantees.
                $few => unsafe { super::$plain::<AoSoA<[$R; $few]>>($($argument,)* count) },
                // SAFETY: the generic function needs arrays of the stated lengths that no other
                // thread uses, which the caller guarantees.
                $many => unsafe { super::$plain::<AoSoA<[$R; $many]>>($($argument,)* count) },
                _ => Err(Status::Lanes),
            })
        }
    };
}

/// Exports a function that has no form on blocks: a function of one motion, mechanism or skin, or
/// of plain arrays. `$body` is its code, an unsafe expression of the type
/// [`Done`](crate::status::Done).
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
        /// Each array must have the length that the description states. Mechanisms, skins and clips
        /// must be zeroed, or made by the library and unchanged since. No other thread may use the
        /// outputs or write the inputs during the call.
        #[unsafe(export_name = $export)]
        pub unsafe extern "C" fn $name($($argument: $type),*) -> Status {
            // SAFETY: `$body` needs arrays of the stated lengths that no other thread uses, and
            // structs that are zeroed or made, which the caller guarantees.
            Status::of(unsafe { $body })
        }
    };
}
