//! Every C function keeps what the head of the header promises of all functions. [`table`] has the
//! arguments of each and its Rust function, from which the tests make
//! - calls that are right: the function returns and writes what the Rust function does, bit by bit,
//!   and writes nothing else;
//! - calls that are wrong in every way: each has an error of its own and sets the index that is
//!   wrong, and nothing is written;
//! - random calls. Arrays have exactly the length that is passed, so the address sanitizer notices
//!   a read or a write beyond their end:
//!
//! ```text
//! RUSTC_BOOTSTRAP=1 RUSTFLAGS=-Zsanitizer=address DQ8_FUZZ_SECONDS=60 \
//!   cargo test --release -p dq8-capi --test functions --target x86_64-unknown-linux-gnu
//! ```

#[macro_use]
mod function;
mod argument;
mod check;
mod element;
mod memory;
mod shape;
mod table;

use dq8_fixtures::fuzz;
use memory::Call;
use shape::Shape;
use std::collections::BTreeSet;
use table::table;

/// Calls `check` with a right call of each function, for arrays of several lengths.
fn of_all(check: impl Fn(&Call<'_>)) {
    let functions = Shape::all().iter().flat_map(table).collect::<Vec<_>>();
    functions.iter().for_each(|function| check(&Call::new(function, None)));
}

#[test]
fn functions_agree_with_those_of_rust() {
    of_all(check::agrees);
}

#[test]
fn what_is_wrong_has_an_error_of_its_own_and_nothing_is_written() {
    of_all(|call| {
        check::wrongs(call.function).into_iter().for_each(|wrong| check::refuses(call, wrong))
    });
}

#[test]
fn outputs_lie_apart_from_all_else() {
    of_all(check::lies_apart);
}

#[test]
fn where_there_is_nothing_pointers_may_be_null() {
    let functions = table(&Shape::nothing());
    functions.iter().for_each(|function| check::may_lie_nowhere(&Call::new(function, None)));
}

#[test]
fn random_calls_stay_within_their_arrays() {
    fuzz::rounds(|seed| {
        let mut random = fuzz::random(seed);
        let functions = table(&Shape::any(&mut random));
        functions.iter().for_each(|function| check::any(function, &mut random));
        functions.len() as u64
    });
}

/// The table has each function of the header once, by its own name, but those that have a test of
/// their own.
#[test]
fn the_table_has_every_function_of_the_header() {
    const OWN: [&str; 6] = [
        "dq8_backend_limit",
        "dq8_backend_name",
        "dq8_block_size_f32",
        "dq8_block_size_f64",
        "dq8_set_reproducible",
        "dq8_status_text",
    ];
    let header = include_str!("../../include/dq8.h");
    let declared: BTreeSet<_> = header
        .split("static inline")
        .enumerate()
        // Functions that are defined in the header itself are not in the library.
        .flat_map(|(at, text)| {
            if at == 0 { text } else { text.split_once("\n}\n").expect("an end").1 }.lines()
        })
        .filter(|line| !line.starts_with([' ', '/', '#', '*']))
        .filter_map(|line| {
            line.split(' ').find_map(|word| word.trim_start_matches('*').split_once('('))
        })
        .map(|(name, _)| name)
        // They are there with a feature alone, and have tests of their own.
        .filter(|name| !name.starts_with("dq8_urdf_"))
        .collect();
    let functions = table(&Shape::all()[0]);
    let named: BTreeSet<_> =
        functions.iter().map(|function| (function.name, function.path)).collect();
    let paths: BTreeSet<_> = functions.iter().map(|function| function.path).collect();
    assert_eq!(named.len(), paths.len(), "a function has two names, or a name two functions");
    for (name, path) in &named {
        let own = path.rsplit("::").next().expect("a name").trim_start_matches("dq8_");
        let own = own.trim_start_matches("transform_");
        let number = if path.contains("::single::") {
            "_f32"
        } else if path.contains("::double::") {
            "_f64"
        } else {
            ""
        };
        assert!(name.ends_with(number) && name.contains(own), "{name} is no name of {path}");
    }
    let named: BTreeSet<_> = named.into_iter().map(|(name, _)| name).chain(OWN).collect();
    assert_eq!(declared, named);
}
