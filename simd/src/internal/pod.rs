//! [`pod!`](crate::pod!): structs that consist of numbers and nothing else, as `bytemuck::Pod`.
//!
//! `bytemuck` derives `Pod` for a generic struct only if it has one field. The macro here proves it
//! for any number of fields, at compile time, from two facts about the finished struct:
//!
//! 1. Every field has a type that implements [`Numbers<T>`], so it consists of numbers `T`.
//! 2. With `T = u8` the struct has alignment 1 and the size of its fields. So nothing adds padding
//!    or an alignment: for another `T`, all sizes and alignments grow by the same factor.

/// A type that consists of numbers `T` and nothing else. It has no padding, and any bits are valid
/// if any bits of `T` are.
///
/// # Safety
/// The size must be a multiple of that of `T`, the alignment must be that of `T`, and every byte
/// must be part of a `T`.
#[doc(hidden)]
pub unsafe trait Numbers<T> {}

// SAFETY: a number consists of itself.
unsafe impl<T> Numbers<T> for T {}
// SAFETY: arrays have no padding between their elements.
unsafe impl<T, const N: usize> Numbers<T> for [T; N] {}
// SAFETY: an array of arrays has no padding either.
unsafe impl<T, const N: usize, const M: usize> Numbers<T> for [[T; N]; M] {}

/// The size of a field in bytes. This compiles only if the field consists of numbers.
#[doc(hidden)]
pub const fn size_of_numbers<T, F: Numbers<T>>(_: &F) -> usize {
    size_of::<F>()
}

/// A value whose bytes are all zero.
#[doc(hidden)]
pub const fn zeroed<P: Zeroable>() -> P {
    // SAFETY: `Zeroable` promises that zeros are a valid value.
    unsafe { core::mem::MaybeUninit::zeroed().assume_init() }
}

/// Checks the layout of a finished struct of bytes, whatever attributes have done to it: its
/// alignment is 1, and its fields fill it.
#[doc(hidden)]
pub const fn check_padding<P>(size_of_fields: usize) {
    assert!(align_of::<P>() == 1, "an attribute gives this struct an alignment of its own");
    assert!(size_of::<P>() == size_of_fields, "an attribute gives this struct padding");
}

/// Defines a struct that is generic over its number type, and implements `bytemuck::Pod` for it.
/// All fields must be numbers, arrays of numbers, or structs that this macro defined.
///
/// The macro writes `#[repr(C)]`, or `#[repr(transparent)]` for a tuple of one field. It accepts
/// documentation, `must_use`, derives and, behind a feature, derives and `serde` attributes. It
/// rejects any other attribute, because one could change the layout or remove the struct. `derive`
/// and `serde` are looked up where the macro is called, and somebody may have defined attributes of
/// these names there. So the finished struct is checked as well, and one with an alignment or
/// padding of its own does not compile. Nothing else that the macro uses is looked up at the call.
///
/// ```
/// dq8_simd::pod! {
///     /// A ball.
///     #[derive(Clone, Copy)]
///     struct Sphere<T> {
///         centre: [T; 3],
///         radius: T,
///     }
/// }
/// let sphere = Sphere { centre: [1.0_f32, 2.0, 3.0], radius: 4.0 };
/// assert_eq!(bytemuck::cast::<_, [f32; 4]>(sphere), [1.0, 2.0, 3.0, 4.0]);
/// ```
///
/// A field that is not made of the struct's numbers is an error:
///
/// ```compile_fail,E0277
/// dq8_simd::pod! {
///     #[derive(Clone, Copy)]
///     struct Sphere<T> {
///         centre: [T; 3],
///         visible: bool,
///     }
/// }
/// ```
///
/// A layout of its own is an error too:
///
/// ```compile_fail
/// dq8_simd::pod! {
///     #[derive(Clone, Copy)]
///     #[repr(C, align(16))]
///     struct Point<T> {
///         position: [T; 3],
///     }
/// }
/// ```
#[doc(hidden)]
#[macro_export]
macro_rules! pod {
    ($(#[$($attribute:tt)+])* $seen:vis struct $name:ident<$number:ident> {
        $($(#[$($about:tt)+])* $shown:vis $field:ident: $type:ty),+ $(,)?
    }) => {
        $crate::pod! {
            @define C [$($field)+] $(#[$($attribute)+])* $seen struct $name<$number> {
                $($(#[$($about)+])* $shown $field: $type),+
            }
        }
    };
    ($(#[$($attribute:tt)+])* $seen:vis struct $name:ident<$number:ident>($shown:vis $type:ty);) => {
        $crate::pod! {
            @define transparent [0] $(#[$($attribute)+])* $seen struct $name<$number>($shown $type);
        }
    };
    // A direct call of this rule is checked like any other.
    (@define $layout:ident [$($field:tt)+] $(#[$($attribute:tt)+])*
        $seen:vis struct $name:ident<$number:ident> $fields:tt $($end:tt)?) => {
        $crate::pod! { @without_padding $layout }
        $($crate::pod! { @harmless $($attribute)+ })*
        $(#[$($attribute)+])*
        #[repr($layout)]
        $seen struct $name<$number> $fields $($end)?

        const _: () = {
            const fn size_of_fields<$number>(plain: &$name<$number>) -> $crate::internal::pod::Size {
                let $name { $($field: _),+ } = plain;
                0 $(+ $crate::internal::pod::size_of_numbers::<$number, _>(&plain.$field))+
            }
            let plain = $crate::internal::pod::zeroed::<$name<$crate::internal::pod::Byte>>();
            $crate::internal::pod::check_padding::<$name<$crate::internal::pod::Byte>>(size_of_fields(&plain));
        };
        // SAFETY: `size_of_fields` compiles, so the finished struct has exactly the fields above,
        // and each consists of numbers. So all have the alignment of a number, and there is no
        // padding between or after them. Attributes add none either: the struct of bytes would have
        // the same padding and alignment, and `check_padding` finds that it has none.
        unsafe impl<$number> $crate::internal::pod::Numbers<$number> for $name<$number> {}
        // SAFETY: all fields are zeroable if a number is.
        unsafe impl<$number: $crate::internal::pod::Zeroable> $crate::internal::pod::Zeroable for $name<$number> {}
        // SAFETY: the struct is numbers without padding, for which any bits are valid.
        unsafe impl<$number: $crate::internal::pod::Pod> $crate::internal::pod::Pod for $name<$number> {}
    };
    (@without_padding C) => {};
    (@without_padding transparent) => {};
    (@harmless doc $($text:tt)+) => {};
    (@harmless must_use) => {};
    (@harmless derive($($traits:tt)*)) => {};
    (@harmless cfg_attr(feature = $feature:literal, derive($($traits:tt)*))) => {};
    (@harmless cfg_attr(feature = $feature:literal, serde($($how:tt)*))) => {};
}

#[doc(hidden)]
pub use bytemuck::{Pod, Zeroable};
/// `u8`, by a path that means the same wherever the macro is called.
#[doc(hidden)]
pub type Byte = u8;
/// `usize`, by such a path.
#[doc(hidden)]
pub type Size = usize;

/// Programs of safe code that earlier versions of the macro accepted, although they implement `Pod`
/// for a struct with padding or with an unspecified layout. `tests/attributes` has more, with
/// attributes of their own.
///
/// The struct is defined elsewhere, and the macro, which once took its name only, finds another
/// `align_of` or `assert!` where it is called:
///
/// ```compile_fail
/// mod a {
///     const fn align_of<T>() -> usize { 1 }
///     #[derive(Clone, Copy)]
///     #[repr(C, align(16))]
///     pub struct Point<T> { pub position: [T; 3] }
///     dq8_simd::pod!(Point { position });
/// }
/// println!("{:x?}", bytemuck::bytes_of(&a::Point { position: [1.0_f32, 2.0, 3.0] }));
/// ```
/// ```compile_fail
/// mod a {
///     macro_rules! assert { ($($all:tt)*) => {} }
///     #[derive(Clone, Copy)]
///     #[repr(C, align(16))]
///     pub struct Point<T> { pub position: [T; 3] }
///     dq8_simd::pod!(Point { position });
/// }
/// println!("{:x?}", bytemuck::bytes_of(&a::Point { position: [1.0_f32, 2.0, 3.0] }));
/// ```
/// ```compile_fail
/// #[derive(Clone, Copy)]
/// struct Sphere<T> { centre: [T; 3], radius: T }
/// dq8_simd::pod!(Sphere { centre, radius });
/// ```
///
/// An attribute removes the struct, and another one has its name:
///
/// ```compile_fail
/// mod other {
///     #[derive(Clone, Copy)]
///     pub struct Sphere<T> { pub centre: [T; 3], pub radius: T }
/// }
/// use other::Sphere;
/// dq8_simd::pod! {
///     #[cfg(any())]
///     struct Sphere<T> { centre: [T; 3], radius: T }
/// }
/// ```
/// ```compile_fail
/// dq8_simd::pod! {
///     #[derive(Clone, Copy)]
///     #[cfg_attr(all(), repr(align(16)))]
///     struct Point<T> { position: [T; 3] }
/// }
/// ```
///
/// The caller passes a layout and a list of fields to a rule that is meant for the macro itself:
///
/// ```compile_fail
/// dq8_simd::pod! {
///     @define Rust [centre radius]
///     #[derive(Clone, Copy)] struct Sphere<T> { centre: [T; 3], radius: T }
/// }
/// ```
/// ```compile_fail
/// dq8_simd::pod! {
///     @define C [centre] #[derive(Clone, Copy)] struct Sphere<T> { centre: [T; 3], visible: bool }
/// }
/// ```
/// ```compile_fail,E0026
/// dq8_simd::pod! {
///     #[derive(Clone, Copy)]
///     struct Sphere<T> { centre: [T; 3], #[cfg(any())] radius: T }
/// }
/// ```
#[cfg(doctest)]
struct Refused;
