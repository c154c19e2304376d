//! [`plain!`](crate::plain!): the promise that a struct is numbers and nothing else.

/// What is numbers `T` and nothing else, one after the other: no padding, and any bits are valid where any
/// bits of `T` are.
///
/// # Safety
/// The size must be a multiple of that of `T`, the alignment that of `T`, and every byte part of a `T`.
#[doc(hidden)]
pub unsafe trait Numbers<T> {}

// SAFETY: a number is itself.
unsafe impl<T> Numbers<T> for T {}
// SAFETY: arrays have no padding between their elements.
unsafe impl<T, const N: usize> Numbers<T> for [T; N] {}
// SAFETY: as above, twice.
unsafe impl<T, const N: usize, const M: usize> Numbers<T> for [[T; N]; M] {}

/// Implements `bytemuck::Pod` for structs that are generic over their number, which bytemuck derives for
/// structs of one field only. The struct is `#[repr(C)]`, and named with all of its fields, which are numbers, arrays of numbers, or
/// plain themselves; anything else does not compile.
///
/// ```
/// #[derive(Clone, Copy)]
/// #[repr(C)]
/// struct Sphere<T> {
///     centre: [T; 3],
///     radius: T,
/// }
/// dq8_simd::plain!(Sphere { centre, radius });
///
/// let sphere = Sphere { centre: [1.0_f32, 2.0, 3.0], radius: 4.0 };
/// assert_eq!(bytemuck::cast::<_, [f32; 4]>(sphere), [1.0, 2.0, 3.0, 4.0]);
/// ```
///
/// A field that is not listed, or that is not made of the struct's numbers, is an error:
///
/// ```compile_fail,E0027
/// #[derive(Clone, Copy)]
/// #[repr(C)]
/// struct Sphere<T> {
///     centre: [T; 3],
///     radius: T,
/// }
/// dq8_simd::plain!(Sphere { centre });
/// ```
/// ```compile_fail,E0277
/// #[derive(Clone, Copy)]
/// #[repr(C)]
/// struct Sphere<T> {
///     centre: [T; 3],
///     visible: bool,
/// }
/// dq8_simd::plain!(Sphere { centre, visible });
/// ```
/// ```compile_fail,E0080
/// #[derive(Clone, Copy)]
/// #[repr(C, align(16))]
/// struct Point<T> {
///     position: [T; 3],
/// }
/// dq8_simd::plain!(Point { position });
/// ```
#[macro_export]
macro_rules! plain {
    ($name:ident { $($field:tt),+ }) => {
        const _: () = {
            // An alignment of its own would be padding.
            assert!(align_of::<$name<u8>>() == 1);
            const fn numbers<T, F: $crate::plain::Numbers<T>>(_: &F) {}
            const fn only_numbers<T>(plain: &$name<T>) {
                let $name { $($field: _),+ } = plain;
                $(numbers::<T, _>(&plain.$field);)+
            }
            let _ = only_numbers::<u8>;
        };
        // SAFETY: `only_numbers` compiles, so every field is `T`s and nothing else. All fields then have one alignment, and
        // no padding lies between or behind them.
        unsafe impl<T> $crate::plain::Numbers<T> for $name<T> {}
        // SAFETY: all fields are zeroable where `T` is.
        unsafe impl<T: $crate::plain::Zeroable> $crate::plain::Zeroable for $name<T> {}
        // SAFETY: `T`s without padding, of which any bits are valid.
        unsafe impl<T: $crate::plain::Pod> $crate::plain::Pod for $name<T> {}
    };
}

#[doc(hidden)]
pub use bytemuck::{Pod, Zeroable};
