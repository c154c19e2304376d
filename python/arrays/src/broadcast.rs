//! NumPy's broadcasting of leading dimensions, without copies of what is the same for many.

use crate::shape::tuple;
use crate::sweep::Which;
use pyo3::PyErr;
use pyo3::exceptions::PyValueError;

/// The leading dimensions of the result, as runs of elements that lie one after the other.
#[derive(Debug)]
pub struct Broadcast {
    /// The leading dimensions of the result.
    pub shape: Vec<usize>,
    /// The elements of a run.
    pub run: usize,
    /// Which arguments have an element for each of a run, where the others have one for all.
    pub each: Which,
    /// The dimensions over which runs are repeated, the last one fastest.
    outer: Vec<Repeat>,
}

/// A dimension over runs.
#[derive(Clone, Copy, Debug)]
struct Repeat {
    size: usize,
    /// How many elements of each argument there are from one step to the next.
    strides: [usize; 3],
}

impl Broadcast {
    /// Of arguments with these leading dimensions; `None` if they do not fit each other. `once` are
    /// the same dimensions, with a 1 for each along which memory has one element, repeated without
    /// a stride.
    pub fn of(arguments: [&[usize]; 3], once: [&[usize]; 3]) -> Option<Self> {
        let shape = common(arguments.into_iter())?;
        let (mut run, mut each) = (1, [true; 3]);
        let mut outer = Vec::new();
        // How many elements each argument has in the dimensions behind the present one.
        let mut behind = [1; 3];
        for (from_end, &size) in shape.iter().rev().enumerate() {
            if size == 1 {
                continue;
            }
            let own: [usize; 3] = std::array::from_fn(|i| {
                let argument = once[i];
                argument.len().checked_sub(from_end + 1).map_or(1, |axis| argument[axis])
            });
            let full = own.map(|own| own == size);
            if outer.is_empty() && (run == 1 || full == each) {
                (run, each) = (run * size, full);
            } else {
                let strides = std::array::from_fn(|i| if full[i] { behind[i] } else { 0 });
                outer.push(Repeat { size, strides });
            }
            for (behind, own) in behind.iter_mut().zip(own) {
                *behind *= own;
            }
        }
        outer.reverse();
        Some(Self { shape, run, each, outer })
    }

    /// One run of all elements.
    pub fn flat(shape: Vec<usize>, each: Which) -> Self {
        let run = shape.iter().product();
        Self { shape, run, each, outer: Vec::new() }
    }

    /// How many runs there are.
    pub fn runs(&self) -> usize {
        self.outer.iter().map(|repeat| repeat.size).product()
    }

    /// Where in each argument run number `index` begins.
    pub fn begin(&self, mut index: usize) -> [usize; 3] {
        let mut begin = [0; 3];
        for repeat in self.outer.iter().rev() {
            let step = index % repeat.size;
            index /= repeat.size;
            for (begin, stride) in begin.iter_mut().zip(repeat.strides) {
                *begin += step * stride;
            }
        }
        begin
    }
}

/// The leading dimensions that all of these broadcast to; `None` if they do not fit each other.
pub fn common<'a>(arguments: impl Iterator<Item = &'a [usize]>) -> Option<Vec<usize>> {
    let mut shape = Vec::new();
    for argument in arguments {
        if shape.len() < argument.len() {
            shape.splice(0..0, vec![1; argument.len() - shape.len()]);
        }
        for (size, &own) in shape.iter_mut().rev().zip(argument.iter().rev()) {
            match (*size, own) {
                (_, 1) => {}
                (1, own) => *size = own,
                (size, own) if size == own => {}
                _ => return None,
            }
        }
    }
    Some(shape)
}

/// Whether an argument with these leading dimensions is the same elements over and over in `shape`,
/// to which it broadcasts.
pub fn cycles(argument: &[usize], shape: &[usize]) -> bool {
    let own =
        argument.iter().position(|&size| size != 1).map_or(&[][..], |first| &argument[first..]);
    shape.ends_with(own)
}

/// Leading dimensions that do not fit each other, with the names of their arguments.
pub fn misfit<'a>(arguments: impl Iterator<Item = (&'a str, &'a [usize])>) -> PyErr {
    let given: Vec<_> =
        arguments.map(|(name, shape)| format!("`{name}` {}", tuple(shape))).collect();
    PyValueError::new_err(format!(
        "operands could not be broadcast together: leading dimensions {}",
        given.join(", ")
    ))
}
