//! [`pod!`](crate::pod!): the promise that a struct is numbers and nothing else.

/// What is numbers `T` and nothing else, one after the other: no padding, and any bits are valid
/// where any bits of `T` are.
///
/// # Safety
/// The size must be a multiple of that of `T`, the alignment that of `T`, and every byte part of a
/// `T`.
#[doc(hidden)]
pub unsafe trait Numbers<T> {}

// SAFETY: a number is itself.
unsafe impl<T> Numbers<T> for T {}
// SAFETY: arrays have no padding between their elements.
unsafe impl<T, const N: usize> Numbers<T> for [T; N] {}
// SAFETY: as above, twice.
unsafe impl<T, const N: usize, const M: usize> Numbers<T> for [[T; N]; M] {}

/// The size in bytes of a field, which compiles for numbers only.
#[doc(hidden)]
pub const fn size_of_numbers<T, F: Numbers<T>>(_: &F) -> usize {
    size_of::<F>()
}

/// The bytes of a struct that are zero.
#[doc(hidden)]
pub const fn zeroed<P: Zeroable>() -> P {
    // SAFETY: `Zeroable` promises that zeros are a value.
    unsafe { core::mem::MaybeUninit::zeroed().assume_init() }
}

/// Checks the finished struct, whatever the attributes have done to it: it lies as close as bytes
/// do, and its fields fill it.
#[doc(hidden)]
pub const fn check_padding<P>(size_of_fields: usize) {
    assert!(align_of::<P>() == 1, "an attribute gives this struct an alignment of its own");
    assert!(size_of::<P>() == size_of_fields, "an attribute gives this struct padding");
}

/// Defines a struct that is generic over its number, and makes it `bytemuck::Pod`, which bytemuck
/// derives for structs of one field only. All fields are numbers, arrays of numbers, or plain
/// themselves; anything else does not compile.
///
/// The macro writes `#[repr(C)]`, or `#[repr(transparent)]` for a tuple of one field. It takes
/// documentation, `must_use`, derives and, for a feature, derives and what `serde` reads: no other
/// attribute, for one may change the layout or take the struct away. Where it is called, `derive`
/// and `serde` may be attributes that somebody else wrote; so the finished struct is checked: one
/// that has an alignment or padding of its own does not compile. No other name that the macro uses
/// is looked up there.
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
/// So is a layout of its own:
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
    // Whoever calls this one himself is held to the same.
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
        // SAFETY: `size_of_fields` compiles, so the finished struct has the fields above and no
        // other, and every one is numbers and nothing else: all have the alignment of a number, and
        // no padding lies between or behind them. Nor does an attribute add any, for the struct of
        // bytes, whose alignment and padding would be the same, has none.
        unsafe impl<$number> $crate::internal::pod::Numbers<$number> for $name<$number> {}
        // SAFETY: all fields are zeroable where a number is.
        unsafe impl<$number: $crate::internal::pod::Zeroable> $crate::internal::pod::Zeroable for $name<$number> {}
        // SAFETY: numbers without padding, of which any bits are valid.
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
/// A number that no name at the place of the call can stand for.
#[doc(hidden)]
pub type Byte = u8;
/// As above.
#[doc(hidden)]
pub type Size = usize;

/// Programs of safe code that once made `Pod` of what has padding, or of a layout that nothing
/// promises. Those with attributes of their own are in `tests/attributes`.
///
/// The struct only named, and `align_of` or `assert!` another one where the macro is called:
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
/// The struct away, another one of its name in its place:
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
/// A layout and a list of fields of the caller's:
///
/// ```compile_fail
/// dq8_simd::pod! {
///     @define Rust [centre radius] #[derive(Clone, Copy)] struct Sphere<T> { centre: [T; 3], radius: T }
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
