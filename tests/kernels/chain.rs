//! The products of a chain, in every layout on every backend, against one product after the other.

use crate::scene::{chain, motions, rounded, walk};
use crate::subject::for_every_subject;
use dq8::{Backend, DualQuat, ShapeError};
use dq8_contract::random::Random;

/// Each product adds some roundings of its factors, whose dual parts are as long as the way so far.
#[track_caller]
pub(crate) fn assert_close(got: &[[f64; 8]], wanted: &[[f64; 8]], single: bool, what: &str) {
    let unit = if single { f64::from(f32::EPSILON) } else { f64::EPSILON };
    assert!(got.len() >= wanted.len(), "{what}");
    for (index, (got, wanted)) in got.iter().zip(wanted).enumerate() {
        let size = wanted.iter().fold(1.0, |size, c| f64::max(size, c.abs()));
        let allowed = unit * (8.0 + index.min(1000) as f64) * size;
        for (got, wanted) in got.iter().zip(wanted) {
            let error = (got - wanted).abs();
            assert!(error <= allowed, "{what}, {index}: off by {error:e}, not {allowed:e}");
        }
    }
}

#[test]
fn a_chain_of_any_length_is_the_product_of_all_links_before() {
    for length in (0..70).chain([127, 128, 129, 1000, 1023]) {
        let links = motions(&mut Random(3), length);
        for_every_subject(|subject, backend| {
            let exact = walk(&chain(length as u32), &rounded(subject.single(), &links));
            let what = format!("{length} on {backend}, {}", subject.name());
            let products = subject.chain(backend, &links);
            assert_close(&products, &exact, subject.single(), &what);
        });
    }
}

#[test]
fn links_that_do_not_fit_are_left_as_they_are() {
    let links = [DualQuat::<f32>::IDENTITY; 17];
    let mut products = [DualQuat::ZERO; 16];
    let error = Backend::best().chain_products(&links, &mut products).unwrap_err();
    assert_eq!(error, ShapeError::Length { what: "products", length: 16, expected: 17 });
    assert_eq!(products, [DualQuat::ZERO; 16]);
}
