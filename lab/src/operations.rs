//! Operation counts, measured by computing with [`Counted`] numbers, compared with those that are
//! printed.

mod measured;

pub use measured::{Operation, operations};

use crate::counted::Counted;
use crate::matrix::Matrix;
use crate::report::{Section, Table, paragraph};
use dq8::{Dual, DualQuat, Quat};
use std::error::Error;

/// The measured operation of this name.
pub fn find<'a>(list: &'a [Operation], name: &str) -> Option<&'a Operation> {
    list.iter().find(|operation| operation.name == name)
}

/// Counts and writes up.
///
/// # Errors
/// If an operation that is written about is not in the list.
pub fn section() -> Result<Section, Box<dyn Error>> {
    let list = operations();
    let mut body = paragraph(
        "Every operation that is written counts, those with 0, 1, 2 or ½ too. Sums and differences are \
         additions. Negations are apart: they are mostly free, and Arends counts them as \
         multiplications. Trig is sines, cosines and arctangents; \
         tests are comparisons, absolute values and the question whether a number is finite. Blank is none. \
         Kenwright's ten percent (§11) is a time, not a count: the example compare measures times.",
    );
    body += &table(&list);
    body += &memory().to_html();
    let headlines = HEADLINES.iter().map(|name| {
        find(&list, name).map(sentence).ok_or_else(|| format!("{name} is not measured"))
    });
    let found = headlines.collect::<Result<_, _>>()?;
    Ok(Section {
        title: "Operation counts",
        tried: "The scalar code of dq8, and the sources' formulas where dq8 has none, are computed with a \
                number that counts its own operations. Nothing in the columns of numbers is typed in."
            .to_owned(),
        claimed: vec![
            "Kenwright §11: 4×4 matrices take 64 multiplications and 48 additions, 4×3 matrices 48 and 32, \
             dual quaternions 42 and 38.",
            "Arends §2.6, §3.4, §4.5, §5.5 and ch. 7: a table of operations for Euler angles, keyframes, \
             quaternions, dual quaternions, hyper-dual quaternions and SLERP.",
            "Kenwright §4: dual quaternions are the most compact form for rigid transforms, 8 floats to 12.",
        ],
        found,
        verdict: "The dual quaternion product takes more multiplications than Kenwright prints, and more \
                  than the product of 3×4 matrices, which takes fewer than he prints: by this count \
                  matrices, and a quaternion with a vector, are cheaper to concatenate. Arends' table is \
                  right for 4×4 matrices, quaternion products, SLERP and element-wise keyframes; he counts \
                  negations as multiplications, sines once a component, and forgets the sums in dual parts. \
                  A dual quaternion is smaller than a matrix, but a quaternion with a vector is smaller still.",
        body,
    })
}

/// What is written about.
const HEADLINES: [&str; 10] = [
    "matrix 4×4 product",
    "matrix 3×4 product",
    "quaternion + vector, product",
    "dual quaternion product",
    "dual quaternion, point by qpq†",
    "hyper-dual quaternion product, written out",
    "SLERP of quaternions, angle given",
    "ScLERP",
    "matrix 3×3, Gram–Schmidt",
    "dual quaternion normalized, unguarded",
];

/// A row of the table in words.
pub fn sentence(operation: &Operation) -> String {
    let Operation { name, counts, .. } = operation;
    let kinds = [
        (counts.multiplications, "mul"),
        (counts.additions, "add"),
        (counts.divisions, "div"),
        (counts.square_roots, "sqrt"),
        (counts.trigonometric, "trig"),
    ];
    let taken = kinds.iter().filter(|(number, _)| *number > 0);
    let taken: Vec<_> = taken.map(|(number, kind)| format!("{number} {kind}")).collect();
    format!("{name}: {}.", taken.join(", "))
}

fn table(list: &[Operation]) -> String {
    let mut table = Table::new(
        "Measured operations",
        &[
            "operation",
            "mul",
            "add",
            "neg",
            "div",
            "sqrt",
            "trig",
            "exp",
            "ln",
            "tests",
            "source",
            "printed",
            "remark",
        ],
    );
    for Operation { name, source, printed, reason, counts } in list {
        let numbers = [
            counts.multiplications,
            counts.additions,
            counts.negations,
            counts.divisions,
            counts.square_roots,
            counts.trigonometric,
            counts.exponentials,
            counts.logarithms,
            counts.comparisons,
        ];
        // Zeros would hide the others.
        let numbers =
            numbers.map(|number| if number == 0 { String::new() } else { number.to_string() });
        let texts = [source, printed, reason].map(|text| (*text).to_owned());
        table.row(core::iter::once((*name).to_owned()).chain(numbers).chain(texts));
    }
    table.to_html()
}

/// Numbers stored for a motion.
fn memory() -> Table {
    fn numbers<T>() -> String {
        (size_of::<T>() / size_of::<Counted>()).to_string()
    }
    type R = Counted;
    let mut table = Table::new(
        "Numbers stored; a rigid motion has six degrees of freedom",
        &["representation", "numbers"],
    );
    for (name, stored) in [
        ("Euler angles + vector", numbers::<[[R; 3]; 2]>()),
        ("quaternion", numbers::<Quat<R>>()),
        ("quaternion + vector", numbers::<(Quat<R>, [R; 3])>()),
        ("dual quaternion", numbers::<DualQuat<R>>()),
        ("matrix 3×4", numbers::<Matrix<R, 3, 4>>()),
        ("matrix 4×4", numbers::<Matrix<R, 4, 4>>()),
        ("hyper-dual quaternion", numbers::<Quat<Dual<Dual<R>>>>()),
    ] {
        table.row([name.to_owned(), stored]);
    }
    table
}
