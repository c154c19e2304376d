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

/// Compiles for numbers only.
#[doc(hidden)]
pub const fn only<T, F: Numbers<T>>(_: &F) {}

/// Defines a struct that is generic over its number, and makes it `bytemuck::Pod`, which bytemuck derives for structs of
/// one field only. All fields are numbers, arrays of numbers, or plain themselves; anything else does not compile.
///
/// The macro writes `#[repr(C)]`, or `#[repr(transparent)]` for a tuple of one field. No name that it uses is looked up
/// where it is called. It takes documentation, `must_use`, derives and, for a feature, derives and what `serde` reads: no
/// other attribute, for one may change the layout or take the struct away.
///
/// ```
/// dq8_simd::plain! {
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
/// dq8_simd::plain! {
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
/// dq8_simd::plain! {
///     #[derive(Clone, Copy)]
///     #[repr(C, align(16))]
///     struct Point<T> {
///         position: [T; 3],
///     }
/// }
/// ```
#[macro_export]
macro_rules! plain {
    ($(#[$($attribute:tt)+])* $seen:vis struct $name:ident<$number:ident> {
        $($(#[$($about:tt)+])* $shown:vis $field:ident: $type:ty),+ $(,)?
    }) => {
        $crate::plain! {
            @define C [$($field)+] $(#[$($attribute)+])* $seen struct $name<$number> {
                $($(#[$($about)+])* $shown $field: $type),+
            }
        }
    };
    ($(#[$($attribute:tt)+])* $seen:vis struct $name:ident<$number:ident>($shown:vis $type:ty);) => {
        $crate::plain! {
            @define transparent [0] $(#[$($attribute)+])* $seen struct $name<$number>($shown $type);
        }
    };
    // Whoever calls this one himself is held to the same.
    (@define $layout:ident [$($field:tt)+] $(#[$($attribute:tt)+])*
        $seen:vis struct $name:ident<$number:ident> $fields:tt $($end:tt)?) => {
        $crate::plain! { @without_padding $layout }
        $($crate::plain! { @harmless $($attribute)+ })*
        $(#[$($attribute)+])*
        #[repr($layout)]
        $seen struct $name<$number> $fields $($end)?

        const _: () = {
            const fn only_numbers<$number>(plain: &$name<$number>) {
                let $name { $($field: _),+ } = plain;
                $($crate::plain::only::<$number, _>(&plain.$field);)+
            }
            let _ = only_numbers::<$crate::plain::Byte>;
        };
        // SAFETY: the struct above has its fields in this order, and no attribute that changes this. `only_numbers` compiles,
        // so every field is numbers and nothing else: all have the alignment of a number, and no padding lies between or
        // behind them.
        unsafe impl<$number> $crate::plain::Numbers<$number> for $name<$number> {}
        // SAFETY: all fields are zeroable where a number is.
        unsafe impl<$number: $crate::plain::Zeroable> $crate::plain::Zeroable for $name<$number> {}
        // SAFETY: numbers without padding, of which any bits are valid.
        unsafe impl<$number: $crate::plain::Pod> $crate::plain::Pod for $name<$number> {}
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

/// Programs of safe code that once made `Pod` of what has padding, or of a layout that nothing promises.
///
/// The struct only named, and `align_of` or `assert!` another one where the macro is called:
///
/// ```compile_fail
/// mod a {
///     const fn align_of<T>() -> usize { 1 }
///     #[derive(Clone, Copy)]
///     #[repr(C, align(16))]
///     pub struct Point<T> { pub position: [T; 3] }
///     dq8_simd::plain!(Point { position });
/// }
/// println!("{:x?}", bytemuck::bytes_of(&a::Point { position: [1.0_f32, 2.0, 3.0] }));
/// ```
/// ```compile_fail
/// mod a {
///     macro_rules! assert { ($($all:tt)*) => {} }
///     #[derive(Clone, Copy)]
///     #[repr(C, align(16))]
///     pub struct Point<T> { pub position: [T; 3] }
///     dq8_simd::plain!(Point { position });
/// }
/// println!("{:x?}", bytemuck::bytes_of(&a::Point { position: [1.0_f32, 2.0, 3.0] }));
/// ```
/// ```compile_fail
/// #[derive(Clone, Copy)]
/// struct Sphere<T> { centre: [T; 3], radius: T }
/// dq8_simd::plain!(Sphere { centre, radius });
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
/// dq8_simd::plain! {
///     #[cfg(any())]
///     struct Sphere<T> { centre: [T; 3], radius: T }
/// }
/// ```
/// ```compile_fail
/// dq8_simd::plain! {
///     #[derive(Clone, Copy)]
///     #[cfg_attr(all(), repr(align(16)))]
///     struct Point<T> { position: [T; 3] }
/// }
/// ```
///
/// A layout and a list of fields of the caller's:
///
/// ```compile_fail
/// dq8_simd::plain! {
///     @define Rust [centre radius] #[derive(Clone, Copy)] struct Sphere<T> { centre: [T; 3], radius: T }
/// }
/// ```
/// ```compile_fail
/// dq8_simd::plain! {
///     @define C [centre] #[derive(Clone, Copy)] struct Sphere<T> { centre: [T; 3], visible: bool }
/// }
/// ```
/// ```compile_fail,E0026
/// dq8_simd::plain! {
///     #[derive(Clone, Copy)]
///     struct Sphere<T> { centre: [T; 3], #[cfg(any())] radius: T }
/// }
/// ```
#[cfg(doctest)]
struct Refused;
