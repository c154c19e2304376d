//! `pod!`, called where the names that it uses mean something else.
#![forbid(unsafe_code)]
#![allow(dead_code, unused_macros, non_camel_case_types, reason = "names in the way")]
#![allow(clippy::extra_unused_type_parameters, reason = "names in the way")]

extern crate dq8_simd as core;
extern crate dq8_simd as std;

/// Names with which a macro could be made to lie about a struct: alignments of one, traits that
/// every type has, checks that check nothing.
mod names_in_the_way {
    pub(super) const fn align_of<T>() -> usize {
        usize
    }
    pub(super) const fn size_of<T>() -> usize {
        usize
    }
    pub(super) const fn size_of_numbers<T>(_: &T) -> u8 {
        u8
    }
    pub(super) const fn check_padding<T>(_: u8) {}
    pub(super) struct u8;
    pub(super) struct usize;
    pub(super) trait Numbers<T> {}
    pub(super) trait Pod {}
    pub(super) trait Zeroable {}
    impl<T, S> Numbers<S> for T {}
    impl<T> Pod for T {}
    impl<T> Zeroable for T {}
    macro_rules! assert {
        ($($all:tt)*) => {};
    }
    macro_rules! pod {
        ($($all:tt)*) => {};
    }
    dq8_simd::pod! {
        #[derive(Clone, Copy)]
        pub struct Sphere<T> {
            pub centre: [T; 3],
            pub radius: T,
        }
    }
    dq8_simd::pod! {
        #[derive(Clone, Copy)]
        pub struct Ball<only_numbers>(pub Sphere<only_numbers>);
    }
}

#[test]
fn plain_structs_are_their_numbers_whatever_the_names_about_them_mean() {
    use names_in_the_way::{Ball, Sphere};
    let sphere = Sphere { centre: [1.0_f64, 2.0, 3.0], radius: 4.0 };
    let numbers: [f64; 4] = bytemuck::cast(Ball(sphere));
    assert_eq!(numbers, [1.0, 2.0, 3.0, 4.0]);
}
