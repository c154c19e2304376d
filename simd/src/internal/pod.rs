//! [`pod!`](crate::pod!): generic structs, all of whose fields consist of values of one element
//! type `T`, as `bytemuck::Pod`.
//!
//! `bytemuck` derives `Pod` for a generic struct only if the struct has one field. The macro here
//! proves at compile time that a struct of several fields has no padding, from two facts:
//!
//! 1. Every field has a type that implements [`Numbers<T>`], so it consists of values of type `T`.
//! 2. With `T = u8` the struct has alignment 1 and the size of its fields. So no attribute adds
//!    padding or an alignment. For another `T`, the sizes of all fields grow by the same factor.

/// A type that consists of values of type `T` and of nothing else. It has no padding, and any bits
/// are valid if any bits are a valid `T`.
///
/// # Safety
/// The size must be a multiple of that of `T`, the alignment must be that of `T`, and every byte
/// must be part of a `T`.
#[doc(hidden)]
pub unsafe trait Numbers<T> {}

// SAFETY: a `T` consists of one `T`, so size and alignment are those of `T`.
unsafe impl<T> Numbers<T> for T {}
// SAFETY: an array has no padding between its elements, and the alignment of an element.
unsafe impl<T, const N: usize> Numbers<T> for [T; N] {}
// SAFETY: an array of arrays has no padding between its elements, and the alignment of an element.
unsafe impl<T, const N: usize, const M: usize> Numbers<T> for [[T; N]; M] {}

/// Returns the size of a field in bytes. The call compiles only if the field consists of values of
/// type `T`.
#[doc(hidden)]
pub const fn size_of_numbers<T, F: Numbers<T>>(_: &F) -> usize {
    size_of::<F>()
}

/// Returns a value whose bytes are all zero.
#[doc(hidden)]
pub const fn zeroed<P: Zeroable>() -> P {
    // SAFETY: `P: Zeroable` guarantees that zero bytes are a valid `P`.
    unsafe { core::mem::MaybeUninit::zeroed().assume_init() }
}

/// Checks the layout of the struct with `T = u8`, after attributes have acted on it: its alignment
/// is 1, and its size is the sum of its fields' sizes.
#[doc(hidden)]
pub const fn check_padding<P>(size_of_fields: usize) {
    assert!(align_of::<P>() == 1, "an attribute gives this struct an alignment of its own");
    assert!(size_of::<P>() == size_of_fields, "an attribute gives this struct padding");
}

/// Defines a struct that is generic over its element type, and implements `bytemuck::Pod` for it.
/// All fields must be values of the element type, arrays of such values, or structs that this macro
/// defined.
///
/// The macro writes `#[repr(C)]`, or `#[repr(transparent)]` for a tuple of one field. It accepts
/// documentation, `must_use`, derives and, behind a feature, derives and `serde` attributes. It
/// rejects any other attribute, because one could change the layout or remove the struct. The names
/// `derive` and `serde` are resolved where the macro is called, and the calling crate may have
/// attributes of its own with these names. So the macro also checks the struct after all attributes
/// have acted on it, and a struct with padding or with an alignment of its own does not compile. No
/// other name in the macro is resolved where the macro is called.
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
/// A field that does not consist of values of type `T` is an error:
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
/// An attribute that changes the layout is an error too:
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
    // If code outside of the macro calls this rule directly, the same checks are made as for the
    // other rules.
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
        // SAFETY: `size_of_fields` takes the struct apart by its fields, so it compiles only if the
        // struct has exactly the fields above, each of which consists of values of the type
        // `$number`. So all fields have the alignment of `$number`, and there is no padding between
        // or after them. An attribute that added padding or an alignment would add it to
        // `$name<Byte>` too, in which `check_padding` finds none.
        unsafe impl<$number> $crate::internal::pod::Numbers<$number> for $name<$number> {}
        // SAFETY: all fields consist of values of the type `$number`, for which zero bytes are
        // valid.
        unsafe impl<$number: $crate::internal::pod::Zeroable> $crate::internal::pod::Zeroable for $name<$number> {}
        // SAFETY: the struct consists of values of the type `$number` without padding, and any bits
        // are a valid `$number`.
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
/// The type `u8`, by a path that the caller of the macro cannot shadow.
#[doc(hidden)]
pub type Byte = u8;
/// The type `usize`, by a path that the caller of the macro cannot shadow.
#[doc(hidden)]
pub type Size = usize;

/// Programs of safe code that must not compile, because they would implement `Pod` for a struct
/// with padding or with an unspecified layout. Earlier versions of the macro accepted them. The
/// package `tests/attributes` has more such programs, which define attributes.
///
/// These programs define the struct outside of the macro. Earlier versions of the macro took only
/// the names of the struct and of its fields. The programs then shadow the `align_of` or the
/// `assert!` that the macro used:
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
/// These programs remove the struct by an attribute, with another struct of the same name, or
/// change the layout by an attribute:
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
/// These programs pass a layout and a list of fields to a rule that only the macro itself should
/// call, or remove a field:
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
