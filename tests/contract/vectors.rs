//! Reference vectors: JSON lines, known answers that were computed with 60 digits or more. The
//! operations of `reference.jsonl` have its names; those of `more.jsonl`, which
//! `scripts/make_vectors.py` writes, have the names of the methods.

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
}

/// Names and lengths.
type Inputs = &'static [(&'static str, usize)];

/// The shape of each operation: inputs with their lengths (0 for any multiple of 8 or any number),
/// and the length of the answer.
const SHAPES: &[(&str, Inputs, usize)] = &[
    ("mul", &[("a", 8), ("b", 8)], 8),
    ("conj_dual", &[("a", 8)], 8),
    ("conj_quat", &[("a", 8)], 8),
    ("conj_both", &[("a", 8)], 8),
    ("norm", &[("a", 8)], 2),
    ("normalize", &[("a", 8)], 8),
    ("inverse", &[("a", 8)], 8),
    ("from_rotation_translation", &[("r", 4), ("t", 3)], 8),
    ("translation", &[("a", 8)], 3),
    ("point", &[("a", 8), ("v", 3)], 3),
    ("vector", &[("a", 8), ("v", 3)], 3),
    ("matrix", &[("a", 8)], 12),
    ("line", &[("a", 8), ("l", 3), ("m", 3)], 6),
    ("log", &[("a", 8)], 6),
    ("exp", &[("v", 3), ("m", 3)], 8),
    ("pow", &[("a", 8), ("t", 1)], 8),
    ("sclerp", &[("a", 8), ("b", 8), ("t", 1)], 8),
    ("screw", &[("a", 8)], 8),
    ("dlb", &[("s", 0), ("w", 0)], 8),
    ("from_screw", &[("l", 3), ("m", 3), ("angle", 1), ("slide", 1)], 8),
    ("from_matrix3x4", &[("rows", 12)], 8),
    ("to_matrix4", &[("a", 8)], 16),
    ("transform_plane", &[("a", 8), ("n", 3), ("offset", 1)], 4),
    ("from_translation_rotation", &[("t", 3), ("r", 4)], 8),
    ("mul_rotation_translation", &[("a", 8), ("r", 4), ("t", 3)], 8),
    ("sqrt", &[("a", 8)], 8),
    ("sclerp_long", &[("a", 8), ("b", 8), ("t", 1)], 8),
    ("nlerp", &[("a", 8), ("b", 8), ("t", 1)], 8),
    ("slerp_lerp", &[("a", 8), ("b", 8), ("t", 1)], 8),
    ("squad", &[("a", 8), ("b", 8), ("c", 8), ("d", 8), ("t", 1)], 8),
    ("squad_control", &[("a", 8), ("b", 8), ("c", 8)], 8),
    ("dot", &[("a", 8), ("b", 8)], 2),
    ("add", &[("a", 8), ("b", 8)], 8),
    ("sub", &[("a", 8), ("b", 8)], 8),
    ("scale", &[("a", 8), ("factor", 1)], 8),
    ("scale_dual", &[("a", 8), ("factor", 2)], 8),
    ("canonical", &[("a", 8)], 8),
];

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
    let shape = SHAPES.iter().find(|(name, ..)| *name == op);
    let (_, names, out_length) = shape.ok_or_else(|| format!("unknown operation \"{op}\""))?;
    let numbers = |name: &str, length: usize| -> Result<Vec<f64>, String> {
        let field = value.get(name).ok_or_else(|| format!("{op} needs the field \"{name}\""))?;
        let mut flat = Vec::new();
        flatten(field, &mut flat).map_err(|reason| format!("\"{name}\": {reason}"))?;
        if length != 0 && flat.len() != length {
            return Err(format!("\"{name}\" holds {} numbers, not {length}", flat.len()));
        }
        Ok(flat)
    };
    let inputs = names
        .iter()
        .map(|&(name, length)| Ok((name.to_owned(), numbers(name, length)?)))
        .collect::<Result<Vec<_>, String>>()?;
    let out = numbers("out", *out_length)?;
    let vector = Vector { row, op, kind, inputs, out };
    let (motions, weights) = (vector.input("s").len(), vector.input("w").len());
    if motions != 8 * weights || (vector.op == "dlb" && weights == 0) {
        return Err(format!("{motions} numbers in \"s\" for {weights} weights"));
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
