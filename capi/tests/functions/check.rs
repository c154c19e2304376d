//! The rules that every function of the table keeps. Each takes a call that is right; the tests try
//! all rules with all functions.

use crate::argument::{Array, Value};
use crate::function::Function;
use crate::memory::Call;
use dq8_capi::Status;
use dq8_fixtures::random::Random;
use std::collections::BTreeSet;
use std::ptr::null_mut;

/// The C function returns and writes what the Rust function does, bit by bit, and writes nothing
/// else. This holds with null for what may be null, with all allowed numbers, and in place.
pub(crate) fn agrees(call: &Call<'_>) {
    let function = call.function;
    same(call, |_| (), "as it is", true);
    for absent in function.arrays().filter_map(|(_, array)| array.group).collect::<BTreeSet<_>>() {
        let group = || function.arrays().filter(|(_, array)| array.group == Some(absent));
        let without = |call: &mut Call<'_>| group().for_each(|(at, _)| call.pass(at, null_mut()));
        same(call, without, &format!("without {absent}"), true);
    }
    for (at, scalar) in function.scalars() {
        for (choice, value) in scalar.values.iter().enumerate().skip(1) {
            same(call, |call| call.given[at] = value.clone(), &format!("choice {choice}"), true);
        }
    }
    for (output, array) in function.arrays() {
        if let Some(input) = function.over(array) {
            same_as(call, |call| call.join(input, output), |_| (), "in place", true);
        }
    }
}

fn same(call: &Call<'_>, change: impl Fn(&mut Call<'_>), what: &str, changes: bool) {
    same_as(call, &change, &change, what, changes);
}

/// The same of what C is given and of what Rust is, which never lies over anything; and not
/// nothing.
fn same_as(
    call: &Call<'_>,
    in_c: impl Fn(&mut Call<'_>),
    in_rust: impl Fn(&mut Call<'_>),
    what: &str,
    changes: bool,
) {
    let (function, mut c, mut rust) = (call.function, call.copy(), call.copy());
    in_c(&mut c);
    in_rust(&mut rust);
    let (name, before) = (function.name, c.now());
    let beside = (c.around(), function.kept());
    let bits = |array: &Array, value: &Value| match value.pointer() {
        start if start.is_null() => Vec::new(),
        start => (array.bits)(start),
    };
    let outputs = || function.arrays().filter(|(_, array)| array.writes && !array.untold);
    let was: Vec<_> = outputs().map(|(at, array)| bits(array, &rust.given[at])).collect();
    let said = (function.c)(&c.given);
    let wanted = (function.rust)(&rust.given).err().unwrap_or(Status::Ok);
    assert_eq!(said, wanted, "{name}, {what}");
    // Which index is wrong, others say.
    let is_told = |array: &Array| said == Status::Ok || !array.names;
    for ((at, array), was) in outputs().zip(was).filter(|((_, array), _)| is_told(array)) {
        let (argument, now) = (function.arguments[at].name, bits(array, &c.given[at]));
        let wanted = bits(array, &rust.given[at]);
        let differs = now.iter().zip(&wanted).position(|(now, wanted)| now != wanted);
        assert_eq!(differs, None, "{name}, {what}: {argument}, the first number that differs");
        let nothing = now == was && !now.is_empty() && !array.names && said == Status::Ok;
        assert!(!changes || !nothing, "{name}, {what}: {argument} is as before");
    }
    assert!(
        (c.around(), function.kept()) == beside,
        "{name}, {what}: something beside its arrays was written"
    );
    let now = c.now();
    for (at, _) in function.arrays().filter(|(_, array)| !array.writes) {
        assert!(
            now[at] == before[at],
            "{name}, {what}: {} was written",
            function.arguments[at].name
        );
    }
}

/// The call is refused, and nothing has been written but the index that is wrong, and scratch.
fn refused(call: &Call<'_>, status: Status, index: Option<usize>, what: &str) {
    let (function, name) = (call.function, call.function.name);
    let before = (call.now(), function.kept());
    assert_eq!((function.c)(&call.given), status, "{name}, {what}");
    let now = call.now();
    for (at, array) in function.arrays().filter(|(_, array)| !array.scratch) {
        if let (true, Some(index)) = (array.names, index) {
            // SAFETY: one index.
            assert_eq!(unsafe { call.start(at).cast::<usize>().read() }, index, "{name}, {what}");
        } else {
            let argument = function.arguments[at].name;
            assert!(now[at] == before.0[at], "{name}, {what}: {argument} was written");
        }
    }
    assert!(function.kept() == before.1, "{name}, {what}: what is kept was written");
}

/// The faults of a call, with the number of the argument, and of its own faults.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Wrong {
    Null(usize),
    Misaligned(usize),
    Number(usize, usize),
    Contents(usize, usize),
}

pub(crate) fn wrongs(function: &Function) -> Vec<Wrong> {
    let mut all = Vec::new();
    for (at, array) in function.arrays().filter(|(_, array)| array.bytes > 0) {
        let alone = function.arrays().filter(|(_, other)| other.group == array.group).count() == 1;
        if array.group.is_none() || !alone {
            all.push(Wrong::Null(at));
        }
        if array.align > 1 {
            all.push(Wrong::Misaligned(at));
        }
        all.extend((0..array.faults.len()).map(|fault| Wrong::Contents(at, fault)));
    }
    for (at, scalar) in function.scalars() {
        all.extend((0..scalar.wrong.len()).map(|wrong| Wrong::Number(at, wrong)));
    }
    all
}

/// It has an error of its own, which names what is wrong, and writes nothing.
pub(crate) fn refuses(call: &Call<'_>, wrong: Wrong) {
    let (function, mut call) = (call.function, call.copy());
    let (at, status, index) = match wrong {
        Wrong::Null(at) => {
            call.pass(at, null_mut());
            (at, Status::NullPointer, None)
        }
        Wrong::Misaligned(at) => {
            call.pass(at, call.start(at).wrapping_add(function.array(at).align / 2));
            (at, Status::Misaligned, None)
        }
        Wrong::Number(at, wrong) => {
            let (value, status) = &function.scalar(at).wrong[wrong];
            call.given[at] = value.clone();
            (at, *status, None)
        }
        Wrong::Contents(at, fault) => {
            let fault = &function.array(at).faults[fault];
            (fault.change)(call.start(at));
            (at, fault.status, fault.index)
        }
    };
    let what = format!("{}: {wrong:?}", function.arguments[at].name);
    refused(&call, status, index, &what);
    // Nobody need ask which index it is.
    if index.is_some() {
        let names = function.arrays().filter(|(_, array)| array.names);
        names.for_each(|(at, _)| call.pass(at, null_mut()));
        assert_eq!((function.c)(&call.given), status, "{}, {what}", function.name);
    }
}

/// Outputs must not overlap inputs, each other, or memory that inputs point to. A function may
/// allow that an output is exactly an input, or that it overlaps inputs.
pub(crate) fn lies_apart(call: &Call<'_>) {
    let function = call.function;
    let arrays = || function.arrays().filter(|(_, array)| array.bytes > 0);
    for (output, to) in arrays().filter(|(_, array)| array.writes) {
        for (other, array) in arrays().filter(|(other, _)| *other != output) {
            slides(call, (other, array), (output, to));
        }
        for (start, bytes) in function.arrays().flat_map(|(_, array)| array.keeps.clone()) {
            let within = start.wrapping_add(start.align_offset(to.align));
            assert!(within < start.wrapping_add(bytes), "{}: too little is kept", function.name);
            let mut over = call.copy();
            over.pass(output, within);
            refused(&over, Status::Overlap, None, "what is kept");
        }
    }
}

/// Tries each place of an output relative to another array, from just before that to just after it.
fn slides(call: &Call<'_>, (other, array): (usize, &Array), (output, to): (usize, &Array)) {
    let (function, over) = (call.function, call.function.over(to));
    let [own, bytes, step] = [array.bytes, to.bytes, array.align].map(|bytes| bytes as isize);
    let (before, last) = (-(own + step - 1) / step * step, (bytes - 1) / step * step);
    let places = [
        (before, true),
        (before + step, false),
        (0, false),
        (step, step >= bytes),
        (last, false),
        (last + step, true),
    ];
    for (offset, apart) in places {
        if offset == 0 && over == Some(other) {
            continue;
        }
        let [moved, fixed] = [other, output].map(|at| function.arguments[at].name);
        let what = format!("{moved}, {offset} bytes from {fixed}");
        let slide = |call: &mut Call<'_>| call.slide(other, output, offset);
        if apart || (to.free && !array.writes) {
            same_as(call, slide, |_| (), &what, true);
            continue;
        }
        let mut slid = call.copy();
        slide(&mut slid);
        refused(&slid, Status::Overlap, None, &what);
        // Where the output is an input, the others must be apart still.
        if let Some(input) = over.filter(|input| *input != other) {
            let mut slid = call.copy();
            slid.join(input, output);
            slide(&mut slid);
            refused(&slid, Status::Overlap, None, &format!("{what}, in place"));
        }
    }
}

/// Pointers to arrays without elements may be null.
pub(crate) fn may_lie_nowhere(call: &Call<'_>) {
    let nothing = || call.function.arrays().filter(|(_, array)| array.bytes == 0);
    let nowhere = |call: &mut Call<'_>| nothing().for_each(|(at, _)| call.pass(at, null_mut()));
    same(call, nowhere, "nowhere", true);
}

/// A call with any numbers, or one that is wrong.
pub(crate) fn any(function: &Function, random: &mut Random) {
    let (wrongs, good) = (wrongs(function), Call::new(function, None));
    // If it is not refused as it is.
    let is_good = random.below(3) == 0 && (function.c)(&good.copy().given) == Status::Ok;
    if is_good && !wrongs.is_empty() {
        return refuses(&good, random.one_of(&wrongs));
    }
    let mut call = Call::new(function, Some(random));
    for (at, scalar) in function.scalars() {
        call.given[at] = scalar.values[random.below(scalar.values.len())].clone();
    }
    same(&call, |_| (), "any numbers", false);
}
