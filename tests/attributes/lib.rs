//! Attributes by the names that `dq8_simd::pod!` lets through, and that are looked up where it is
//! called. They give what they are put on an alignment of its own, and so padding: the programs
//! below read memory that is not theirs if it compiles.
#![forbid(unsafe_code)]

use proc_macro::TokenStream;

fn with(attributes: &str, item: TokenStream) -> TokenStream {
    let mut all: TokenStream = attributes.parse().expect("attributes are tokens");
    all.extend(item);
    all
}

/// Derives `Clone` and `Copy`, and aligns to 64 bytes:
///
/// ```
/// use dq8_attributes::derive;
/// #[derive(Clone, Copy)]
/// #[repr(C)]
/// struct Point<T> { position: [T; 3] }
/// assert_eq!((size_of::<Point<f32>>(), align_of::<Point<f32>>()), (64, 64));
/// ```
///
/// ```compile_fail,E0080
/// use dq8_attributes::derive;
/// dq8_simd::pod! {
///     #[derive(Clone, Copy)]
///     struct Point<T> { position: [T; 3] }
/// }
/// println!("{:x?}", bytemuck::bytes_of(&Point { position: [1.0_f32, 2.0, 3.0] }));
/// ```
///
/// ```compile_fail,E0692
/// use dq8_attributes::derive;
/// dq8_simd::pod! {
///     #[derive(Clone, Copy)]
///     struct Number<T>(T);
/// }
/// println!("{:x?}", bytemuck::bytes_of(&Number(1.0_f32)));
/// ```
#[proc_macro_attribute]
pub fn derive(_: TokenStream, item: TokenStream) -> TokenStream {
    with("#[::core::prelude::v1::derive(Clone, Copy)] #[repr(align(64))]", item)
}

/// Aligns to 16 bytes:
///
/// ```
/// use dq8_attributes::serde;
/// #[cfg_attr(feature = "serde", serde(transparent))]
/// #[repr(C)]
/// struct Point<T> { position: [T; 3] }
/// assert_eq!((size_of::<Point<f32>>(), align_of::<Point<f32>>()), (16, 16));
/// ```
///
/// ```compile_fail,E0080
/// use dq8_attributes::serde;
/// dq8_simd::pod! {
///     #[derive(Clone, Copy)]
///     #[cfg_attr(feature = "serde", serde(transparent))]
///     struct Point<T> { position: [T; 3] }
/// }
/// println!("{:x?}", bytemuck::bytes_of(&Point { position: [1.0_f32, 2.0, 3.0] }));
/// ```
#[proc_macro_attribute]
pub fn serde(_: TokenStream, item: TokenStream) -> TokenStream {
    with("#[repr(align(16))]", item)
}
