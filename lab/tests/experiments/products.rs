//! Long products: what the report says of normalizing.

use lab::products::{Errors, METHODS, errors};

fn of<'a>(row: &'a [Errors; METHODS.len()], name: &str) -> &'a Errors {
    let position = METHODS.iter().position(|method| method.name == name);
    &row[position.unwrap_or_else(|| panic!("no method {name}"))]
}

#[test]
fn normalizing_keeps_the_norm_and_does_not_mend_the_rotation() {
    let [short, long] = errors(&[300, 10_000]).try_into().unwrap();
    let [never, exact] = ["never", "exact, every product"].map(|name| of(&long, name));
    assert!(exact[0] < 1e-7 && exact[1] < 1e-7, "{exact:?}");
    assert!(never[0] > 1e-6 && never[1] > 5e-7, "{never:?}");
    assert!(never[2] / exact[2] < 2.0 && exact[2] / never[2] < 2.0, "{never:?} {exact:?}");
    let [before, after] = [short, long].map(|row| of(&row, "never")[0]);
    assert!(after > 2.0 * before, "drift grows: {before:e} {after:e}");
    let wrong = of(&long, "wrong: real part only, every product");
    assert!(wrong[1] > 5e-7, "the part of q along p stays: {wrong:?}");
}
