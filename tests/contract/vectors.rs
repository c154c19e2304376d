//! Reference vectors: JSON lines, known answers that were computed with 60 digits or more. The
//! operations of `reference.jsonl` have its names; those of `more.jsonl`, which
//! `scripts/make_vectors.py` writes, have the names of the methods, and those of its
//! `geometry.jsonl`, which are of the tables in [`geometry`], the names of types before them.

use crate::bound::{Bound, Kind, find};
use crate::case::{Case, NUMBERS, length};
use crate::geometry;
use crate::implementation::On;
use crate::operation::{Held, Operation, Sign, rows};
use crate::operations::OPERATIONS;
use serde_json::Value;
use std::fmt;

/// One known answer.
#[derive(Clone, Debug)]
pub struct Vector {
    /// Its line in the file, from 1.
    pub row: usize,
    pub op: String,
    pub kind: String,
    /// The inputs by name, flattened, w first as in the file.
    inputs: Vec<(String, Vec<f64>)>,
    known: Known,
    /// The answer, flattened.
    pub out: Vec<f64>,
}

/// A row that cannot be read.
#[derive(Debug)]
pub struct RowError {
    pub row: usize,
    pub reason: String,
}

impl fmt::Display for RowError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "row {}: {}", self.row, self.reason)
    }
}

impl std::error::Error for RowError {}

impl Vector {
    /// An input, or nothing where the operation has none of that name.
    pub fn input(&self, name: &str) -> &[f64] {
        self.inputs.iter().find(|(n, _)| n == name).map_or(&[], |(_, values)| values)
    }

    pub fn norm(&self, name: &str) -> f64 {
        length(self.input(name))
    }

    /// |p|
    pub fn real_norm(&self, name: &str) -> f64 {
        length(&self.input(name)[..4])
    }

    /// The bound of its kind.
    pub fn bound(&self) -> Option<&'static Bound> {
        find(self.known.bounds, &self.kind)
    }

    /// What vectors that are computed together have in common: how many influences there are, and
    /// what is one number for all lanes, an order of Euler angles or an exponent.
    pub fn shape(&self) -> (usize, i32) {
        let of_all = [self.input("order"), self.input("n")].concat();
        (self.input("w").len(), of_all.first().map_or(0, |&number| number as i32))
    }

    /// Whether `on` has the operation.
    pub fn is_on(&self, on: On) -> bool {
        match self.known.of {
            Of::Motions(_) => true,
            Of::Geometry(place) => place.is_on(on),
        }
    }

    /// The answers of `on` to vectors of one operation and shape, at most as many as it has lanes.
    pub fn answers(&self, on: On, vectors: &[&Self]) -> Vec<Vec<f64>> {
        match self.known.of {
            Of::Motions(of) => self.answers_of_motions(of, on, vectors),
            Of::Geometry(place) => place.answers(on, vectors),
        }
    }

    fn answers_of_motions(&self, of: OfMotions, on: On, vectors: &[&Self]) -> Vec<Vec<f64>> {
        let operation = of.operation;
        // Lanes without a vector repeat the first one.
        let lane = |i: usize| *vectors.get(i).unwrap_or(&self);
        let given = operation.arguments.iter().enumerate().map(|(index, argument)| {
            let lanes = (0..on.lanes).map(|i| lane(i).argument(of, index, on)).collect::<Vec<_>>();
            let lanes = lanes.iter().map(|numbers| &numbers[..]);
            on.in_domain(argument.domain, rows(on, lanes))
        });
        let answer = on.call(operation.index, &given.collect::<Vec<_>>());
        let numbers = answer.numbers.into_iter().filter(|(kind, _)| *kind != Kind::Count);
        let columns: Vec<_> = numbers.map(|(_, row)| row).collect();
        let order = if columns.len() == 8 && operation.name != "to_screw" {
            vec![3, 0, 1, 2, 7, 4, 5, 6]
        } else {
            (0..columns.len()).collect()
        };
        let of_lane = |lane: usize| order.iter().map(|&c| columns[c][lane]).collect();
        (0..vectors.len()).map(of_lane).collect()
    }

    /// Argument `index`, w behind x, y and z; one without a field is that of every case.
    fn argument(&self, of: OfMotions, index: usize, on: On) -> Vec<f64> {
        if of.fields[index].is_empty() {
            let pick = of.operation.arguments[index].pick;
            return pick(&Case::of_numbers(&[0.0; NUMBERS]), on);
        }
        let fields: Vec<_> = of.fields(index).map(|(name, _)| self.input(name)).collect();
        let xyzw = |quat: &[f64]| [quat[1], quat[2], quat[3], quat[0]];
        match of.operation.arguments[index].numbers {
            9 => {
                let pairs = fields[0].chunks_exact(8).zip(fields[1]);
                pairs.flat_map(|(s, &w)| [&xyzw(s)[..], &xyzw(&s[4..]), &[w]].concat()).collect()
            }
            8 if fields.len() == 1 => fields[0].chunks_exact(4).flat_map(xyzw).collect(),
            4 if fields.len() == 1 => xyzw(fields[0]).to_vec(),
            _ => fields.concat(),
        }
    }

    /// The largest error of `answer` over its components, relative to the scale of the operation.
    /// NaN counts as infinite.
    pub fn error(&self, answer: &[f64]) -> f64 {
        match self.known.of {
            Of::Motions(of) => self.error_of_motions(of, answer),
            Of::Geometry(place) => place.error(self, answer),
        }
    }

    fn error_of_motions(&self, of: OfMotions, answer: &[f64]) -> f64 {
        let distance = |sign: f64| {
            let pairs = answer.iter().zip(&self.out);
            pairs.map(|(a, b)| (sign * a - b).abs()).fold(0.0, |worst: f64, error| {
                if error.is_nan() { f64::INFINITY } else { worst.max(error) }
            })
        };
        let absolute = match of.sign {
            Sign::Kept => distance(1.0),
            Sign::Either => distance(1.0).min(distance(-1.0)),
        };
        absolute / (of.scale)(self, self.far())
    }

    /// max(1, |t|), |t| the largest translation, vector or moment among the inputs.
    fn far(&self) -> f64 {
        let mut far = 1.0_f64;
        for (name, numbers) in &self.inputs {
            match (name.as_str(), numbers.len()) {
                ("a" | "b" | "c" | "d" | "s", _) => {
                    far = numbers.chunks_exact(8).map(translation).fold(far, f64::max);
                }
                ("t" | "v" | "m", 3) => far = far.max(length(numbers)),
                _ => {}
            }
        }
        far
    }
}

/// |t| of σ with w first, for σ of any length; none without a real part: the scale would be
/// infinite
/// and no error seen.
pub fn translation(sigma: &[f64]) -> f64 {
    let t = 2.0 * length(&sigma[4..]) / length(&sigma[..4]);
    if t.is_finite() { t } else { 0.0 }
}

/// An operation that a file has answers for.
#[derive(Clone, Copy, Debug)]
pub struct Known {
    pub name: &'static str,
    pub bounds: &'static [Bound],
    of: Of,
}

#[derive(Clone, Copy, Debug)]
enum Of {
    Motions(OfMotions),
    Geometry(geometry::Place),
}

/// One of the table of [`OPERATIONS`].
#[derive(Clone, Copy, Debug)]
struct OfMotions {
    operation: &'static Operation,
    fields: &'static [&'static str],
    sign: Sign,
    scale: fn(&Vector, f64) -> f64,
}

/// All of them.
pub fn known() -> impl Iterator<Item = Known> {
    let of_motions = OPERATIONS.iter().flat_map(|operation| {
        operation.bounds.iter().filter_map(move |held| match *held {
            Held::Digits { name, fields, sign, scale, bounds } => {
                let of = Of::Motions(OfMotions { operation, fields, sign, scale });
                Some(Known { name, bounds, of })
            }
            _ => None,
        })
    });
    let of_geometry = geometry::operations().map(|(place, operation)| Known {
        name: operation.name,
        bounds: operation.bounds,
        of: Of::Geometry(place),
    });
    of_motions.chain(of_geometry)
}

impl Known {
    /// All fields with their lengths, 0 for those that repeat.
    fn fields(&self) -> Vec<(&'static str, usize)> {
        match self.of {
            Of::Motions(of) => (0..of.fields.len()).flat_map(|index| of.fields(index)).collect(),
            Of::Geometry(place) => place.fields().collect(),
        }
    }
}

impl OfMotions {
    /// The fields of argument `index` with their lengths, 0 for those that repeat.
    fn fields(&self, index: usize) -> impl Iterator<Item = (&'static str, usize)> {
        let numbers = self.operation.arguments[index].numbers;
        let all = self.fields[index].split_whitespace();
        let repeats = all.clone().count() > 1;
        all.map(move |field| match field.split_once(':') {
            Some((name, length)) => (name, length.parse().expect("a length")),
            None => (field, if repeats { 0 } else { numbers }),
        })
    }
}

/// Every row of `text`; the first that cannot be read is the error.
pub fn parse(text: &str) -> Result<Vec<Vector>, RowError> {
    let numbered = text.lines().enumerate().map(|(index, line)| (index + 1, line));
    numbered
        .filter(|(_, line)| !line.trim().is_empty())
        .map(|(row, line)| parse_row(row, line).map_err(|reason| RowError { row, reason }))
        .collect()
}

fn parse_row(row: usize, line: &str) -> Result<Vector, String> {
    let value: Value = serde_json::from_str(line).map_err(|error| error.to_string())?;
    let text = |name: &str| {
        let field = value.get(name).and_then(Value::as_str);
        field.map(str::to_owned).ok_or_else(|| format!("no text field \"{name}\""))
    };
    let (op, kind) = (text("op")?, text("kind")?);
    let known = known().find(|known| known.name == op);
    let known = known.ok_or_else(|| format!("unknown operation \"{op}\""))?;
    let numbers = |name: &str, length: usize| -> Result<Vec<f64>, String> {
        let field = value.get(name).ok_or_else(|| format!("{op} needs the field \"{name}\""))?;
        let mut flat = Vec::new();
        flatten(field, &mut flat).map_err(|reason| format!("\"{name}\": {reason}"))?;
        if length != 0 && flat.len() != length {
            return Err(format!("\"{name}\" holds {} numbers, not {length}", flat.len()));
        }
        Ok(flat)
    };
    let fields = known.fields();
    let influences = fields.ends_with(&[("s", 0), ("w", 0)]);
    let inputs = fields
        .into_iter()
        .map(|(name, length)| Ok((name.to_owned(), numbers(name, length)?)))
        .collect::<Result<Vec<_>, String>>()?;
    let out = numbers("out", 0)?;
    let vector = Vector { row, op, kind, inputs, known, out };
    if let Some(order) = vector.input("order").iter().find(|order| !(0.0..24.0).contains(*order)) {
        return Err(format!("there is no order {order} of Euler angles"));
    }
    let (motions, weights) = (vector.input("s").len(), vector.input("w").len());
    if influences && (motions != 8 * weights || weights == 0) {
        return Err(format!("{motions} numbers in \"s\" for {weights} weights"));
    }
    let (answered, held) =
        (vector.answers(crate::implementation::scalar_f64(), &[&vector]), vector.out.len());
    if answered[0].len() != held {
        return Err(format!("\"out\" holds {held} numbers, not {}", answered[0].len()));
    }
    Ok(vector)
}

/// Numbers, or numbers as text, in arrays of any depth. Both are read with correct rounding.
fn flatten(value: &Value, flat: &mut Vec<f64>) -> Result<(), String> {
    match value {
        Value::Array(values) => values.iter().try_for_each(|value| flatten(value, flat)),
        Value::Number(number) => {
            flat.push(number.as_f64().ok_or_else(|| format!("{number} is no f64"))?);
            Ok(())
        }
        Value::String(text) => {
            let number: f64 = text.parse().map_err(|_| format!("\"{text}\" is no number"))?;
            flat.push(number);
            Ok(())
        }
        other => Err(format!("{other} is no number")),
    }
}
