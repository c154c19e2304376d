//! [`Tape`]: the operations that a computation did, in order; and what computes them again.

use dq8::Real;
use std::cell::RefCell;

/// A number of a tape.
pub type Node = u32;

/// What a number is made by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Op {
    /// Given.
    Input,
    /// Written in the code.
    Const(f64),
    /// a + b
    Add(Node, Node),
    /// a − b
    Sub(Node, Node),
    /// ab
    Mul(Node, Node),
    /// ab + c, rounded once where the hardware fuses.
    Fma(Node, Node, Node),
    /// c − ab, rounded once where the hardware fuses.
    Nfma(Node, Node, Node),
    /// a / b
    Div(Node, Node),
    /// √a
    Sqrt(Node),
    /// −a
    Neg(Node),
    /// |a|
    Abs(Node),
}

impl Op {
    /// What it is computed from.
    #[must_use]
    pub fn operands(self) -> Vec<Node> {
        let mut operands = vec![];
        let _ = self.of(|node| {
            operands.push(node);
            node
        });
        operands
    }

    /// The same of other numbers.
    #[must_use]
    pub(crate) fn of(self, mut n: impl FnMut(Node) -> Node) -> Self {
        match self {
            Self::Input | Self::Const(_) => self,
            Self::Add(a, b) => Self::Add(n(a), n(b)),
            Self::Sub(a, b) => Self::Sub(n(a), n(b)),
            Self::Mul(a, b) => Self::Mul(n(a), n(b)),
            Self::Div(a, b) => Self::Div(n(a), n(b)),
            Self::Fma(a, b, c) => Self::Fma(n(a), n(b), n(c)),
            Self::Nfma(a, b, c) => Self::Nfma(n(a), n(b), n(c)),
            Self::Sqrt(a) => Self::Sqrt(n(a)),
            Self::Neg(a) => Self::Neg(n(a)),
            Self::Abs(a) => Self::Abs(n(a)),
        }
    }
}

/// A comparison.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Order {
    /// a < b
    Less,
    /// a ≤ b
    LessOrEqual,
    /// a = b
    Equal,
}

/// A comparison and how it came out: what must hold for the tape to be what the code does.
#[derive(Clone, Copy, Debug)]
pub struct Branch {
    /// Of these two numbers.
    pub sides: [Node; 2],
    /// Which.
    pub order: Order,
    /// How it came out.
    pub holds: bool,
}

/// The operations of one computation on one path.
#[derive(Clone, Debug, Default)]
pub struct Tape {
    /// By node.
    pub ops: Vec<Op>,
    /// The numbers that chose the path.
    values: Vec<f64>,
    /// What chose it.
    pub branches: Vec<Branch>,
    /// The answers.
    pub outputs: Vec<Node>,
}

/// 0, 1, 2, ½, π, ε of `f32`, ε of `f64`, NaN: the first nodes of every tape, for constants of
/// traits.
const CONSTANTS: [f64; 8] =
    [0.0, 1.0, 2.0, 0.5, core::f64::consts::PI, f32::EPSILON as f64, f64::EPSILON, f64::NAN];

/// How many nodes come before the inputs.
pub const FIRST_INPUT: usize = CONSTANTS.len();

thread_local! {
    static TAPE: RefCell<Tape> = RefCell::default();
}

/// The tape of `work`, on the path that inputs of these `values` take.
pub fn record(values: &[f64], work: impl FnOnce(&[Node]) -> Vec<Node>) -> Tape {
    let ops =
        CONSTANTS.into_iter().map(Op::Const).chain(values.iter().map(|_| Op::Input)).collect();
    let all = CONSTANTS.into_iter().chain(values.iter().copied()).collect();
    TAPE.set(Tape { ops, values: all, ..Tape::default() });
    let inputs: Vec<Node> = (0..values.len()).map(|i| (FIRST_INPUT + i) as Node).collect();
    let outputs = work(&inputs);
    Tape { outputs, ..TAPE.take() }
}

/// The number that chose the path.
pub(crate) fn value(node: Node) -> f64 {
    TAPE.with_borrow(|tape| tape.values[node as usize])
}

/// A comparison, written down.
pub(crate) fn compare(a: Node, order: Order, b: Node) -> bool {
    let holds = holds(&value(a), order, &value(b));
    TAPE.with_borrow_mut(|tape| tape.branches.push(Branch { sides: [a, b], order, holds }));
    holds
}

fn holds<F: PartialOrd>(a: &F, order: Order, b: &F) -> bool {
    match order {
        Order::Less => a < b,
        Order::LessOrEqual => a <= b,
        Order::Equal => a == b,
    }
}

/// An operation, written down. What changes no finite number but in the sign of a zero is none:
/// sums with 0, products with ±1, and what is on the tape already.
pub(crate) fn push(op: Op) -> Node {
    TAPE.with_borrow_mut(|tape| {
        let constant = |node: Node| match tape.ops[node as usize] {
            Op::Const(c) => Some(c),
            _ => None,
        };
        let is = |node: Node, c: f64| constant(node) == Some(c);
        // As a comparison has said.
        let is_negative = |node: Node| {
            let mut less = tape.branches.iter().filter(|branch| branch.order == Order::Less);
            less.find_map(|branch| match branch.sides {
                [left, 0] if left == node => Some(branch.holds),
                [0, right] if right == node && branch.holds => Some(false),
                _ => None,
            })
        };
        let op = match op {
            Op::Fma(a, b, c) if is(c, 0.0) => Op::Mul(a, b),
            op => op,
        };
        let op = match op {
            Op::Mul(a, b) if is(a, 1.0) => return b,
            Op::Mul(a, b) if is(b, 1.0) => return a,
            Op::Mul(a, b) if is(a, 0.0) || is(b, 0.0) => return 0,
            Op::Mul(a, b) if is(a, -1.0) => Op::Neg(b),
            Op::Mul(a, b) if is(b, -1.0) => Op::Neg(a),
            Op::Add(a, b) if is(a, 0.0) => return b,
            Op::Add(a, b) | Op::Sub(a, b) if is(b, 0.0) => return a,
            Op::Sub(a, b) if is(a, 0.0) => Op::Neg(b),
            Op::Fma(a, b, c) | Op::Nfma(a, b, c) if is(a, 0.0) || is(b, 0.0) => return c,
            op => op,
        };
        let op = match op {
            Op::Neg(a) | Op::Abs(a) if is(a, 0.0) => return 0,
            Op::Neg(a) => match tape.ops[a as usize] {
                Op::Neg(b) => return b,
                Op::Const(c) => Op::Const(-c),
                _ => op,
            },
            Op::Abs(a) => match (constant(a), tape.ops[a as usize]) {
                (Some(c), _) => Op::Const(c.abs()),
                (_, Op::Neg(b)) if is_negative(b) == Some(true) => return a,
                _ if is_negative(a) == Some(false) => return a,
                _ => op,
            },
            op => op,
        };
        let same = |other: &Op| match (*other, op) {
            (Op::Const(a), Op::Const(b)) => a.to_bits() == b.to_bits(),
            (a, b) => a == b,
        };
        if let Some(at) = tape.ops.iter().position(same) {
            return at as Node;
        }
        let value = compute(op, &tape.values, true);
        tape.ops.push(op);
        tape.values.push(value);
        (tape.ops.len() - 1) as Node
    })
}

/// A number that a tape is computed with.
pub trait Computed: Real {
    /// ab + c, rounded once.
    fn fused(self, b: Self, c: Self) -> Self;
}
impl Computed for f32 {
    fn fused(self, b: Self, c: Self) -> Self {
        self.mul_add(b, c)
    }
}
impl Computed for f64 {
    fn fused(self, b: Self, c: Self) -> Self {
        self.mul_add(b, c)
    }
}

fn compute<F: Computed>(op: Op, numbers: &[F], fused: bool) -> F {
    let n = |node: Node| numbers[node as usize];
    match op {
        Op::Input => unreachable!("inputs are given"),
        Op::Const(c) => F::from_f64(c),
        Op::Add(a, b) => n(a) + n(b),
        Op::Sub(a, b) => n(a) - n(b),
        Op::Mul(a, b) => n(a) * n(b),
        Op::Fma(a, b, c) if fused => n(a).fused(n(b), n(c)),
        Op::Nfma(a, b, c) if fused => (-n(a)).fused(n(b), n(c)),
        Op::Fma(a, b, c) => n(a) * n(b) + n(c),
        Op::Nfma(a, b, c) => n(c) - n(a) * n(b),
        Op::Div(a, b) => n(a) / n(b),
        Op::Sqrt(a) => n(a).sqrt(),
        Op::Neg(a) => -n(a),
        Op::Abs(a) => n(a).abs(),
    }
}

impl Tape {
    /// All numbers of the tape for these inputs, into `numbers`; false where the inputs take
    /// another path.
    pub fn run<F: Computed>(&self, inputs: &[F], fused: bool, numbers: &mut Vec<F>) -> bool {
        numbers.clear();
        let mut inputs = inputs.iter();
        for &op in &self.ops {
            let number = match op {
                Op::Input => *inputs.next().expect("an input each"),
                op => compute(op, numbers, fused),
            };
            numbers.push(number);
        }
        self.branches.iter().all(|branch| {
            let [a, b] = branch.sides.map(|node| &numbers[node as usize]);
            holds(a, branch.order, b) == branch.holds
        })
    }

    /// What the outputs are made of, and nothing else: numbered anew.
    fn alone(&self) -> (Vec<Op>, Vec<Node>) {
        let needed = self.needed(&self.outputs);
        let (mut ops, mut names) = (vec![], vec![0; self.ops.len()]);
        for (node, op) in self.ops.iter().enumerate() {
            if needed[node] || *op == Op::Input {
                names[node] = ops.len() as Node;
                ops.push(op.of(|n| names[n as usize]));
            }
        }
        (ops, self.outputs.iter().map(|&output| names[output as usize]).collect())
    }

    /// Whether the two do the same.
    #[must_use]
    pub fn is_same_as(&self, other: &Self) -> bool {
        self.alone() == other.alone()
    }

    /// A number that changes with any operation that the outputs are made of: FNV-1a, 32 bits.
    #[must_use]
    pub fn fingerprint(&self) -> u32 {
        format!("{:?}", self.alone())
            .bytes()
            .fold(0x811c_9dc5, |hash, byte| (hash ^ u32::from(byte)).wrapping_mul(0x0100_0193))
    }

    /// Whether any answer differs where hardware fuses.
    #[must_use]
    pub fn fuses(&self) -> bool {
        self.alone().0.iter().any(|op| matches!(op, Op::Fma(..) | Op::Nfma(..)))
    }

    /// Which nodes these are made of.
    #[must_use]
    pub fn needed(&self, outputs: &[Node]) -> Vec<bool> {
        let mut needed = vec![false; self.ops.len()];
        for &output in outputs {
            needed[output as usize] = true;
        }
        for node in (0..self.ops.len()).rev() {
            if needed[node] {
                for operand in self.ops[node].operands() {
                    needed[operand as usize] = true;
                }
            }
        }
        needed
    }

    /// What this tape gives to `inner` where it ends in it: its nodes that stand for the inputs of
    /// the other.
    #[must_use]
    pub fn ends_in(&self, inner: &Self) -> Option<Vec<Node>> {
        let mut given = vec![None; inner.ops.len()];
        let mut pairs: Vec<(Node, Node)> =
            self.outputs.iter().copied().zip(inner.outputs.iter().copied()).collect();
        while let Some((mine, theirs)) = pairs.pop() {
            match given[theirs as usize] {
                Some(known) if known == mine => continue,
                Some(_) => return None,
                None => given[theirs as usize] = Some(mine),
            }
            let (op, other) = (self.ops[mine as usize], inner.ops[theirs as usize]);
            if other == Op::Input || (theirs as usize) < FIRST_INPUT && mine == theirs {
                continue;
            }
            let same = match (op, other) {
                (Op::Const(a), Op::Const(b)) => a == b,
                (a, b) => std::mem::discriminant(&a) == std::mem::discriminant(&b),
            };
            if !same {
                return None;
            }
            pairs.extend(op.operands().into_iter().zip(other.operands()));
        }
        let inputs = (0..inner.ops.len()).filter(|&node| inner.ops[node] == Op::Input);
        inputs.map(|node| given[node]).collect()
    }

    /// The inputs that these are made of.
    #[must_use]
    pub fn inputs(&self, outputs: &[Node]) -> Vec<Node> {
        let needed = self.needed(outputs);
        let is_input = |&node: &Node| needed[node as usize] && self.ops[node as usize] == Op::Input;
        (0..self.ops.len() as Node).filter(is_input).collect()
    }

    /// Whether an operation rounds a product before it is added to something, and whether it rounds
    /// the result. Products with ±2ᵏ, no smaller than `least`, are exact.
    #[must_use]
    pub fn roundings(&self, node: Node, fused: bool, least: f64) -> [bool; 2] {
        let is_power = |node: Node| {
            matches!(self.ops[node as usize], Op::Const(c)
                if c != 0.0 && c.abs() >= least && c.abs().log2().fract() == 0.0)
        };
        match self.ops[node as usize] {
            Op::Input | Op::Const(_) | Op::Neg(_) | Op::Abs(_) => [false, false],
            Op::Add(a, b) => [false, a != b],
            Op::Mul(a, b) => [false, !is_power(a) && !is_power(b)],
            Op::Fma(a, b, _) | Op::Nfma(a, b, _) => [!fused && !is_power(a) && !is_power(b), true],
            Op::Sub(..) | Op::Div(..) | Op::Sqrt(_) => [false, true],
        }
    }
}
