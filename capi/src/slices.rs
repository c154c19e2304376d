//! Kernels over arrays, plain or in blocks: the kernels of the list in dq8's
//! `src/slices/kernels.rs`, the kernels that move all elements by one motion, and conversions to
//! matrices.

use crate::status::{Done, Status};
use dq8::hierarchy::MatrixOrder;
use dq8::internal::{for_each_kernel, record};
use dq8::storage::{AoSoA, Aos, Layout};

/// The order of the components of a matrix in memory.
#[repr(i32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// Row by row, as in C arrays.
    Rows = 0,
    /// Column by column, as in OpenGL and in GPU buffers.
    Columns = 1,
}

impl Order {
    /// Converts a value of enum dq8_matrix_order from C.
    pub(crate) fn known(order: i32) -> Result<MatrixOrder, Status> {
        match order {
            rows if rows == Self::Rows as i32 => Ok(MatrixOrder::Rows),
            columns if columns == Self::Columns as i32 => Ok(MatrixOrder::Columns),
            _ => Err(Status::UnknownValue),
        }
    }
}

kernel_or_in_place! {
    points(points: 3) of one motion by transform_points, transform_points_in_place
}
kernel_or_in_place! {
    vectors(vectors: 3) of one motion by transform_vectors, transform_vectors_in_place
}
kernel! { matrices_3x4(motions: 8; order: i32 = Order::known(order)?) -> 12 by matrices }
kernel! { matrices_4x4(motions: 8; order: i32 = Order::known(order)?) -> 16 by matrices }

/// The functions of the kernels in dq8's `src/slices/kernels.rs`, generic over the layout of the
/// arrays.
mod of_each {
    use super::*;

    macro_rules! kernels {
        ($(
            $(#[doc = $brief:literal])+
            $name:ident $(as $c:literal)? [$($types:tt)*]
            ($input:ident: $kind:ident $I:ident $(, $other:ident: $others:ident $O:ident)* $(; $parameter:ident)?)
                -> $output:ident: $result:ident $Q:ident $(, in place $in_place:ident)? = $one:expr, {
                $($more:tt)*
            }
        )*) => {$(
            elsewhere_or! {
                $($in_place)? $name($input: { record!($kind) } $(, $other: { record!($others) })*
                    $(; $parameter: L::Real)?) -> { record!($result) }
            }
        )*};
    }
    macro_rules! elsewhere_or {
        ($name:ident($($inputs:tt)*) -> $out:tt) => {
            kernel! { $name($($inputs)*) -> $out by $name }
        };
        ($in_place:ident $name:ident($($inputs:tt)*) -> $out:tt) => {
            kernel_or_in_place! { $name($($inputs)*) by $name, $in_place }
        };
    }
    for_each_kernel!(kernels);
}

/// Exports, for one element type, the functions of the kernels in dq8's `src/slices/kernels.rs`: on
/// plain arrays, and in the submodule `blocks` on blocks.
macro_rules! exports {
    ($R:ident [$few:literal $many:literal], $(
        $(#[doc = $brief:literal])+
        $name:ident $(as $c:literal)? [$($types:tt)*]
        ($input:ident: $kind:ident $I:ident $(, $other:ident: $others:ident $O:ident)* $(; $parameter:ident)?)
            -> $output:ident: $result:ident $Q:ident $(, in place $in_place:ident)? = $one:expr, {
            $($more:tt)*
        }
    )*) => {
        $(
            $(#[doc = $brief])+
            $(#[doc = out_may_be!($in_place $input)])?
            ///
            /// # Safety
            /// Each array must have the length that the description states. No other thread may use
            /// the output or write the inputs during the call.
            #[unsafe(export_name = concat!("dq8_", name!($name $($c)?), "_", stringify!($R)))]
            pub unsafe extern "C" fn $name(
                $input: *const $R,
                $($other: *const $R,)*
                $($parameter: $R,)?
                out: *mut $R,
                count: usize,
            ) -> Status {
                // SAFETY: the generic function needs arrays of the stated lengths that no other
                // thread uses, which the caller guarantees.
                Status::of(unsafe { of_each::$name::<Aos<$R>>($input, $($other,)* $($parameter,)? out, count) })
            }
        )*

        /// The functions on blocks. Their names in C begin with `dq8_blocks_`.
        pub mod blocks {
            use super::*;
            $(
                #[doc = concat!(
                    " Does what dq8_", name!($name $($c)?), "_", stringify!($R), " does, on blocks of ",
                    stringify!($few), " or ", stringify!($many), " `lanes`. `count` is the number of blocks."
                )]
                ///
                /// # Safety
                /// Each array must have the length that the description states, counted in blocks.
                /// No other thread may use the output or write the inputs during the call.
                #[unsafe(export_name = concat!("dq8_blocks_", name!($name $($c)?), "_", stringify!($R)))]
                pub unsafe extern "C" fn $name(
                    lanes: usize,
                    $input: *const $R,
                    $($other: *const $R,)*
                    $($parameter: $R,)?
                    out: *mut $R,
                    count: usize,
                ) -> Status {
                    Status::of(match lanes {
                        // SAFETY: the generic function needs arrays of the stated lengths that no
                        // other thread uses, which the caller guarantees.
                        $few => unsafe {
                            of_each::$name::<AoSoA<[$R; $few]>>($input, $($other,)* $($parameter,)? out, count)
                        },
                        // SAFETY: the generic function needs arrays of the stated lengths that no
                        // other thread uses, which the caller guarantees.
                        $many => unsafe {
                            of_each::$name::<AoSoA<[$R; $many]>>($input, $($other,)* $($parameter,)? out, count)
                        },
                        _ => Err(Status::Lanes),
                    })
                }
            )*
        }
    };
}

/// Expands to the name in C, without `dq8_` and the element type.
macro_rules! name {
    ($name:ident) => {
        stringify!($name)
    };
    ($name:ident $c:literal) => {
        $c
    };
}

macro_rules! out_may_be {
    ($in_place:ident $input:ident) => {
        concat!(" `out` may be `", stringify!($input), "`.")
    };
}

macro_rules! functions {
    ($R:ident $lanes:tt) => {
        for_each_kernel!(exports, $R $lanes);

        export! { $R $lanes
            /// Moves `points`, three components each, by one unit `motion`. `out` may be `points`.
            points, blocks_points(motion: *const $R, points: *const $R, out: *mut $R)
        }
        export! { $R $lanes
            /// Turns `vectors`, three components each, by one unit `motion`. Vectors are
            /// directions, which the motion does not translate. `out` may be `vectors`.
            vectors, blocks_vectors(motion: *const $R, vectors: *const $R, out: *mut $R)
        }
        export! { $R $lanes
            /// Writes the matrices `[R | t]` of unit `motions`. A matrix has twelve components in
            /// `order`, one of enum dq8_matrix_order.
            matrices_3x4, blocks_matrices_3x4(motions: *const $R, order: i32, out: *mut $R)
        }
        export! { $R $lanes
            /// Writes the 4x4 matrices of unit `motions`, with the last row 0 0 0 1. A matrix has
            /// sixteen components in `order`, one of enum dq8_matrix_order.
            matrices_4x4, blocks_matrices_4x4(motions: *const $R, order: i32, out: *mut $R)
        }
    };
}
for_both_numbers!(functions);
