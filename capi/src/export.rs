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

/// A function on one motion, whose body is what it returns inside.
macro_rules! export_one {
    (
        $R:ident
        $(#[doc = $about:literal])*
        $name:ident($($argument:ident: $type:ty),* $(,)?) = $body:expr
    ) => {
        $(#[doc = $about])*
        ///
        /// # Safety
        /// Pointers are to as many numbers as named.
        #[unsafe(export_name = concat!("dq8_motion_", stringify!($name), "_", stringify!($R)))]
        pub unsafe extern "C" fn $name($($argument: $type),*) -> Status {
            // SAFETY: promised.
            Status::of(unsafe { $body })
        }
    };
}

/// A function on one configuration of a mechanism, whose body is what it returns inside.
macro_rules! export_mechanism {
    (
        $R:ident
        $(#[doc = $about:literal])*
        $name:ident($($argument:ident: $type:ty),* $(,)?) = $body:expr
    ) => {
        $(#[doc = $about])*
        ///
        /// # Safety
        /// Arrays have the lengths named, and mechanisms are zero or have been made.
        #[unsafe(export_name = concat!("dq8_mechanism_", stringify!($name), "_", stringify!($R)))]
        pub unsafe extern "C" fn $name($($argument: $type),*) -> Status {
            // SAFETY: promised.
            Status::of(unsafe { $body })
        }
    };
}

/// A function on a skin, whose body is what it returns inside.
macro_rules! export_skin {
    (
        $R:ident
        $(#[doc = $about:literal])*
        $name:ident($($argument:ident: $type:ty),* $(,)?) = $body:expr
    ) => {
        $(#[doc = $about])*
        ///
        /// # Safety
        /// Arrays have the lengths named, and skins are zero or have been made.
        #[unsafe(export_name = concat!("dq8_skin_", stringify!($name), "_", stringify!($R)))]
        #[expect(clippy::allow_attributes, reason = "not every function has so many")]
        #[allow(clippy::too_many_arguments, reason = "one per line of the C function")]
        pub unsafe extern "C" fn $name($($argument: $type),*) -> Status {
            // SAFETY: promised.
            Status::of(unsafe { $body })
        }
    };
}

/// The generic function, plain or in blocks, that a kernel over slices is in C: two arrays, of so many numbers per element,
/// make a third one.
macro_rules! from_two {
    ($name:ident: $a:literal, $b:literal -> $c:literal by $kernel:ident $(, $number:ident)?) => {
        /// # Safety
        /// As for [`two_to`](crate::memory::two_to).
        unsafe fn $name<L: Layout>(
            a: *const L::Real,
            b: *const L::Real,
            $($number: L::Real,)?
            out: *mut L::Real,
            count: usize,
        ) -> Done {
            let run = |a: &[L::Record<$a>], b: &[L::Record<$b>], to: &mut [L::Record<$c>]| {
                dq8::Backend::best().$kernel(a, b, $($number,)? to)
            };
            // SAFETY: promised.
            unsafe { crate::memory::two_to(a, b, out, count, run) }
        }
    };
}
