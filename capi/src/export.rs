//! Macros that write the exported functions.

/// Exports the functions of a file for both number types, with the lanes that blocks of each may
/// have.
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

/// Exports a function of plain arrays and its sibling of blocks. Both call the function of the same
/// name in the file, whose type parameter is the layout.
macro_rules! export {
    (
        $R:ident [$few:literal $many:literal]
        $(#[doc = $about:literal])*
        $plain:ident, $blocks:ident ($($argument:ident: $type:ty),* $(,)?)
    ) => {
        $(#[doc = $about])*
        ///
        /// # Safety
        /// Arrays must have the lengths that are named.
        #[unsafe(export_name = concat!("dq8_", stringify!($plain), "_", stringify!($R)))]
        pub unsafe extern "C" fn $plain($($argument: $type,)* count: usize) -> Status {
            // SAFETY: the caller keeps the conditions under `# Safety`, which are those of the
            // functions called here.
            Status::of(unsafe { super::$plain::<Aos<$R>>($($argument,)* count) })
        }

        #[doc = concat!(
            " Does what dq8_", stringify!($plain), "_", stringify!($R), " does, on blocks of ",
            stringify!($few), " or ", stringify!($many),
            " `lanes`. `count` is the number of blocks."
        )]
        ///
        /// # Safety
        /// Arrays must have the lengths that are named, in blocks.
        #[unsafe(export_name = concat!("dq8_", stringify!($blocks), "_", stringify!($R)))]
        pub unsafe extern "C" fn $blocks(
            lanes: usize,
            $($argument: $type,)*
            count: usize,
        ) -> Status {
            Status::of(match lanes {
                // SAFETY: the caller keeps the conditions under `# Safety`, which are those of the
                // functions called here.
                $few => unsafe { super::$plain::<AoSoA<[$R; $few]>>($($argument,)* count) },
                // SAFETY: the caller keeps the conditions under `# Safety`, which are those of the
                // functions called here.
                $many => unsafe { super::$plain::<AoSoA<[$R; $many]>>($($argument,)* count) },
                _ => Err(Status::Lanes),
            })
        }
    };
}

/// Exports a function that has only one form, for one motion, mechanism or skin, or for plain
/// arrays. `$body` is a [`Done`](crate::status::Done).
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
        /// Arrays must have the lengths that are named, and mechanisms and skins must be zeroed or
        /// made.
        #[unsafe(export_name = $export)]
        pub unsafe extern "C" fn $name($($argument: $type),*) -> Status {
            // SAFETY: the caller keeps the conditions under `# Safety`, which are those of the
            // functions called here.
            Status::of(unsafe { $body })
        }
    };
}
