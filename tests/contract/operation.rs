//! [`Operation`]: what one line of the [table](crate::operations) becomes: a caller by name, its
//! inputs, the scale of its errors, and its bounds.

use crate::bound::{Bound, Kind, Scale, distance};
use crate::case::Case;
use crate::implementation::{On, scalar_f64};
use crate::lanes::Row;
use crate::vectors::Vector;

/// An operation of one implementation: the rows of each argument in, those of the answer out.
pub type Call = fn(&[Vec<Row>]) -> Answer;

/// One operation of the contract.
#[derive(Debug)]
pub struct Operation {
    pub name: &'static str,
    pub arguments: &'static [Argument],
    /// What its error is measured against: the size that the answer, or a term of the sum that it
    /// is, can have.
    pub scale: fn(&Case) -> Scale,
    pub bounds: &'static [Held],
    /// The kind of its answer, as the table calls it.
    pub answers: &'static str,
    pub(crate) index: usize,
}

/// One argument, taken from a case.
#[derive(Debug)]
pub struct Argument {
    pub domain: Domain,
    /// How many numbers it is, or a multiple of that.
    pub numbers: usize,
    pub pick: fn(&Case, On) -> Vec<f64>,
}

/// Which dual quaternions an argument may be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Domain {
    /// Any numbers.
    Any,
    /// A unit one.
    Unit,
    /// The rotation of a unit one.
    Rotation,
    /// No dual quaternion.
    Other,
}

/// What the answers are held against, and for which arguments.
#[derive(Debug)]
pub enum Held {
    /// Any motions may be given, though the bounds are those of unit ones.
    TakesAny { reason: &'static str },
    /// Lanes against the scalar reference of the same precision. About 1.6 times the worst of 150
    /// 000 random cases of each kind, built for SSE2 and for AVX2 with fused multiplication.
    Scalar(Bound),
    /// Every implementation against the scalar path in `f64`, on the same rounded input: the truth
    /// of what has no reference vectors, though to `f64` itself it is another way only.
    Double { inputs: Inputs, sign: Sign, bounds: &'static [Bound] },
    /// Every implementation against answers of 60 digits: about one and a half times the worst of
    /// the vectors in the files, which other input may pass.
    Digits {
        /// What the file calls it.
        name: &'static str,
        /// The fields of each argument, with lengths where there are several; none for what is the
        /// same in every case.
        fields: &'static [&'static str],
        sign: Sign,
        /// From max(1, |t|), |t| the largest translation, vector or moment among the inputs, to
        /// what the error is measured against.
        scale: fn(&Vector, f64) -> f64,
        bounds: &'static [Bound],
    },
}

/// Which inputs a bound against `f64` was measured on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Inputs {
    /// Twists of every angle, and poses.
    Twists,
    /// The same with |ω| clearly below a whole turn, where the answer is finite.
    Turns,
    /// Poses about a common one.
    Clusters,
}

/// σ and −σ are the same motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sign {
    Kept,
    /// The sign of a p_w near zero is a matter of rounding.
    Either,
}

/// What an operation answers, a row of lanes for each number and a bit of a mask for each lane.
#[derive(Clone, Debug, Default)]
pub struct Answer {
    /// Whether there is no answer, for want of influences.
    pub none: bool,
    pub numbers: Vec<(Kind, Row)>,
    pub masks: Vec<u32>,
}

impl Answer {
    /// What lane `lane` answers.
    pub fn lane(&self, lane: usize) -> (Vec<(Kind, f64)>, Vec<bool>) {
        let numbers = self.numbers.iter().map(|(kind, row)| (*kind, row[lane])).collect();
        (numbers, self.masks.iter().map(|mask| mask >> lane & 1 == 1).collect())
    }
}

impl Operation {
    /// The numbers of each argument in a case.
    pub fn given(&self, on: On, case: &Case) -> Vec<Vec<f64>> {
        self.arguments.iter().map(|argument| (argument.pick)(case, on)).collect()
    }

    /// The answer to the arguments of each lane.
    pub fn answer_given(&self, on: On, lanes: &[&Vec<Vec<f64>>]) -> Answer {
        let argument = |i: usize| rows(on, lanes.iter().map(|lane| &lane[i][..]));
        on.call(self.index, &(0..self.arguments.len()).map(argument).collect::<Vec<_>>())
    }

    /// The answer to each case, as many as there are lanes; lanes without a case repeat the first.
    pub fn answer(&self, on: On, cases: &[Case]) -> Answer {
        let given: Vec<_> = cases.iter().map(|case| self.given(on, case)).collect();
        let lanes: Vec<_> = (0..on.lanes).map(|i| given.get(i).unwrap_or(&given[0])).collect();
        self.answer_given(on, &lanes)
    }

    /// The worst error over `cases` against the scalar path in `f64`, in units of u · scale, and
    /// where; NaN is infinite.
    pub fn worst_error(&self, on: On, sign: Sign, cases: &[Case]) -> (f64, Case) {
        let mut worst = (0.0, cases[0]);
        for chunk in cases.chunks(on.lanes) {
            let answer = self.answer(on, chunk);
            for (lane, case) in chunk.iter().enumerate() {
                let case = case.rounded(on);
                let (wanted, _) = self.answer(scalar_f64(), &[case]).lane(0);
                let error = self.error(on, sign, &answer.lane(lane).0, &wanted, &case);
                if error > worst.0 {
                    worst = (error, case);
                }
            }
        }
        worst
    }

    fn error(
        &self,
        on: On,
        sign: Sign,
        got: &[(Kind, f64)],
        wanted: &[(Kind, f64)],
        case: &Case,
    ) -> f64 {
        let scale = (self.scale)(case);
        let with_sign = |sign: f64| {
            let pairs = got.iter().zip(wanted).filter(|((kind, _), _)| *kind != Kind::Count);
            pairs.fold(0.0, |worst: f64, (&(kind, got), &(_, wanted))| {
                worst.max(distance(sign * got, wanted, scale.of(kind), on.single))
            })
        };
        match sign {
            Sign::Kept => with_sign(1.0),
            Sign::Either => with_sign(1.0).min(with_sign(-1.0)),
        }
    }

    /// Whether its answers are unit, or NaN.
    pub fn answers_units(&self) -> bool {
        self.name == "normalize_checked"
            || matches!(self.answers, "unit" | "small_motion" | "blend" | "mean")
    }

    /// Whether all dual quaternions among its arguments may be any, and there are some.
    pub fn is_algebra(&self) -> bool {
        let domains = || self.arguments.iter().map(|argument| argument.domain);
        let restricted = domains().any(|d| matches!(d, Domain::Unit | Domain::Rotation));
        !restricted && domains().any(|d| d == Domain::Any)
    }

    /// Whether it takes motions that are not unit, though its bounds are those of unit ones.
    pub fn takes_any(&self) -> bool {
        self.bounds.iter().any(|held| matches!(held, Held::TakesAny { .. }))
    }

    /// Whether both ways between two motions of the case are equally long up to rounding: either is
    /// right.
    pub fn is_a_tie(&self, on: On, case: &Case) -> bool {
        let apart = |other: &[f64; 8]| {
            let dot: f64 = case.a.iter().zip(other).take(4).map(|(a, b)| a * b).sum();
            dot.abs() < 16.0 * on.roundoff()
        };
        match self.name {
            "nlerp" | "sclerp" | "sclerp_long" | "slerp_lerp" | "twist_to" => apart(&case.b),
            "dlb" => apart(&case.b) || apart(&case.c),
            _ => false,
        }
    }

    /// The bounds against the scalar path in `f64`, and how they are measured.
    pub fn double(&self) -> Option<(Inputs, Sign, &'static [Bound])> {
        self.bounds.iter().find_map(|held| match *held {
            Held::Double { inputs, sign, bounds } => Some((inputs, sign, bounds)),
            _ => None,
        })
    }

    /// The bound of lanes against scalar.
    pub fn agreement(&self) -> Option<&Bound> {
        self.bounds.iter().find_map(|held| match held {
            Held::Scalar(bound) => Some(bound),
            _ => None,
        })
    }
}

/// Rows of numbers, rounded, lane `i` from the flat numbers of element `i`.
pub(crate) fn rows<'n>(on: On, lanes: impl Iterator<Item = &'n [f64]>) -> Vec<Row> {
    let mut rows = Vec::new();
    for (lane, numbers) in lanes.enumerate() {
        rows.resize(numbers.len(), Row::default());
        for (row, &number) in rows.iter_mut().zip(numbers) {
            row[lane] = on.round(number);
        }
    }
    rows
}
