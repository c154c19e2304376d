//! [`Polynomial`]: what a tape computes, in its inputs, and how large that can be by the lengths of
//! its arguments.

use std::collections::{BTreeMap, BTreeSet};

/// Variables of a monomial in rising order. Inputs are their nodes; a root that a tape computes of
/// a sum of squares is a variable of its own, and so is one over it.
pub(crate) type Monomial = Vec<u32>;

/// The variable √s of the `k`th sum of squares; the next is 1/√s.
pub(crate) fn root(k: usize) -> u32 {
    u32::MAX - 2 * (k as u32) - 1
}

/// (which, ±1) of a root or one over it.
pub(crate) fn as_root(variable: u32) -> Option<(usize, i32)> {
    let k = (u32::MAX - variable) as usize;
    (k < 64).then_some((k / 2, if k % 2 == 1 { 1 } else { -1 }))
}

/// Terms by the groups of their inputs, and by their roots.
pub(crate) type Kinds = BTreeMap<(Vec<usize>, Monomial), Vec<(Monomial, f64)>>;

/// What terms are made of, beside their coefficients.
pub trait Factors: Clone + Default + Ord {
    /// Those of a product.
    #[must_use]
    fn times(&self, other: &Self) -> Self;
}

/// A root times one over it is nothing.
impl Factors for Monomial {
    fn times(&self, other: &Self) -> Self {
        let mut all = [&self[..], &other[..]].concat();
        all.sort_unstable();
        let cancelled = |all: &Self| {
            let mut roots = all.iter().filter(|&&v| as_root(v).is_some_and(|(_, k)| k == 1));
            roots.find(|&&root| all.contains(&(root + 1))).copied()
        };
        while let Some(root) = cancelled(&all) {
            // One over a root is the number after it.
            let at = all.partition_point(|&v| v < root);
            let over = all.partition_point(|&v| v < root + 1);
            all.remove(over);
            all.remove(at);
        }
        all
    }
}

/// Powers of the lengths of arguments.
pub type Powers = Vec<(usize, i32)>;

impl Factors for Powers {
    fn times(&self, other: &Self) -> Self {
        let mut powers = BTreeMap::new();
        self.iter().chain(other).for_each(|&(group, k)| *powers.entry(group).or_default() += k);
        powers.retain(|_, k| *k != 0);
        powers.into_iter().collect()
    }
}

/// Coefficients by factors.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sum<K>(pub BTreeMap<K, f64>);
/// By variables.
pub(crate) type Polynomial = Sum<Monomial>;
/// By powers of lengths.
pub type Lengths = Sum<Powers>;

impl<K: Factors> Sum<K> {
    /// c
    pub(crate) fn constant(c: f64) -> Self {
        Self(if c == 0.0 { BTreeMap::new() } else { [(K::default(), c)].into() })
    }
    /// self + c other
    pub(crate) fn plus(&self, c: f64, other: &Self) -> Self {
        let mut sum = self.0.clone();
        for (factors, coefficient) in &other.0 {
            *sum.entry(factors.clone()).or_default() += c * coefficient;
        }
        sum.retain(|_, coefficient| *coefficient != 0.0);
        Self(sum)
    }
    /// self · other
    pub(crate) fn times(&self, other: &Self) -> Self {
        let mut product = BTreeMap::new();
        for (a, x) in &self.0 {
            for (b, y) in &other.0 {
                *product.entry(a.times(b)).or_default() += x * y;
            }
        }
        product.retain(|_, coefficient| *coefficient != 0.0);
        Self(product)
    }
    /// c self
    pub(crate) fn scaled(&self, c: f64) -> Self {
        Self::default().plus(c, self)
    }
}

impl Polynomial {
    /// x
    pub(crate) fn variable(x: u32) -> Self {
        Self([(vec![x], 1.0)].into())
    }
    /// All coefficients without their signs.
    pub(crate) fn magnitude(&self) -> Self {
        Self(self.0.iter().map(|(monomial, c)| (monomial.clone(), c.abs())).collect())
    }
    /// Each coefficient times `factor` of the powers of roots beside it.
    pub(crate) fn weighted(&self, factor: impl Fn(&BTreeMap<usize, i32>) -> f64) -> Self {
        let weighted = self.0.iter().map(|(monomial, c)| {
            let mut powers = BTreeMap::new();
            for (k, power) in monomial.iter().filter_map(|&v| as_root(v)) {
                *powers.entry(k).or_default() += power;
            }
            (monomial.clone(), c * factor(&powers))
        });
        Self(weighted.filter(|(_, c)| *c != 0.0).collect())
    }

    /// The terms by the groups of their inputs, and by their roots.
    pub(crate) fn kinds(&self, group: &dyn Fn(u32) -> usize) -> Kinds {
        let mut kinds = BTreeMap::<_, Vec<_>>::new();
        for (monomial, &c) in &self.0 {
            let (roots, inputs): (Monomial, Monomial) =
                monomial.iter().partition(|&&v| as_root(v).is_some());
            let mut groups: Vec<usize> = inputs.iter().map(|&v| group(v)).collect();
            groups.sort_unstable();
            kinds.entry((groups, roots)).or_default().push((inputs, c));
        }
        kinds
    }

    /// Bounds by powers of lengths: |self| ≤ Σ c·Π lengthᵏ, of the group of each input and
    /// of what each root is the length.
    pub(crate) fn by_lengths(
        &self,
        group: &dyn Fn(u32) -> usize,
        length_of: &dyn Fn(usize) -> usize,
    ) -> Lengths {
        let mut bounds = Lengths::default();
        for ((groups, roots), terms) in self.kinds(group) {
            let mut powers = BTreeMap::<usize, i32>::new();
            for &group in &groups {
                *powers.entry(group).or_default() += 1;
            }
            for (k, power) in roots.iter().filter_map(|&v| as_root(v)) {
                *powers.entry(length_of(k)).or_default() += power;
            }
            powers.retain(|_, power| *power != 0);
            *bounds.0.entry(powers.into_iter().collect()).or_default() +=
                form_norm(&groups, &terms, group);
        }
        bounds
    }
}

impl Lengths {
    /// The value for these lengths.
    #[must_use]
    pub fn at(&self, lengths: &[f64]) -> f64 {
        let of = |powers: &Vec<(usize, i32)>| {
            powers.iter().map(|&(g, k)| lengths[g].powi(k)).product::<f64>()
        };
        self.0.iter().map(|(powers, c)| c * of(powers)).sum()
    }
    /// The larger of each coefficient.
    pub(crate) fn worst(&mut self, other: &Self) {
        for (powers, &c) in &other.0 {
            let worst = self.0.entry(powers.clone()).or_default();
            *worst = worst.max(c);
        }
    }
}

/// A matrix by monomials of its rows and columns.
pub(crate) type Matrix = BTreeMap<(Monomial, Monomial), f64>;

/// No less than the largest value of a multilinear form on unit vectors, one per group: the least
/// norm of its unfoldings to matrices, and the sum of its coefficients.
fn form_norm(groups: &[usize], terms: &[(Monomial, f64)], group: &dyn Fn(u32) -> usize) -> f64 {
    let sum = terms.iter().map(|(_, c)| c.abs()).sum();
    unfoldings(groups, terms, group).map(|matrix| norm(&matrix)).fold(sum, f64::min)
}

/// The form as matrices: by which factors are rows. A vector is a matrix of one column, and a
/// transpose has the same norm.
pub(crate) fn unfoldings(
    groups: &[usize],
    terms: &[(Monomial, f64)],
    group: &dyn Fn(u32) -> usize,
) -> impl Iterator<Item = Matrix> {
    let orders: Vec<_> = terms.iter().map(|(term, c)| (orders(groups, term, group), c)).collect();
    (1_u32..1 << (groups.len().max(1) - usize::from(groups.len() > 1))).map(move |rows| {
        let mut cells = Matrix::new();
        for (orders, c) in &orders {
            for order in orders {
                let part = |side: u32| {
                    (0..order.len()).filter(|i| rows >> i & 1 == side).map(|i| order[i]).collect()
                };
                *cells.entry((part(1), part(0))).or_default() += *c / orders.len() as f64;
            }
        }
        cells
    })
}

/// The variables in every order in which they are of these groups; equal ones once.
fn orders(groups: &[usize], of: &[u32], group: &dyn Fn(u32) -> usize) -> BTreeSet<Monomial> {
    let Some((&first, groups)) = groups.split_first() else { return [vec![]].into() };
    let firsts = (0..of.len()).filter(|&i| group(of[i]) == first);
    let each = firsts.flat_map(|i| {
        let rest = [&of[..i], &of[i + 1..]].concat();
        orders(groups, &rest, group).into_iter().map(move |rest| [&[of[i]], &rest[..]].concat())
    });
    each.collect()
}

/// No less than ‖M‖₂, by ‖M‖₂² = ‖MᵀM‖₂ ≤ ‖(MᵀM)ⁿ‖∞^(1/n), n =
/// 2²⁰; but for the rounding of this computation, for which there is a margin.
pub(crate) fn norm(cells: &Matrix) -> f64 {
    let (mut rows, mut columns) = (BTreeMap::new(), BTreeMap::new());
    for (row, column) in cells.keys() {
        let (r, c) = (rows.len(), columns.len());
        rows.entry(row).or_insert(r);
        columns.entry(column).or_insert(c);
    }
    let by_rows = rows.len() <= columns.len();
    let (n, m) = if by_rows { (rows.len(), columns.len()) } else { (columns.len(), rows.len()) };
    // Cubes of this many take too long.
    if n > 24 {
        return f64::INFINITY;
    }
    let mut matrix = vec![vec![0.0; m]; n];
    for ((row, column), c) in cells {
        let (r, c_) = (rows[row], columns[column]);
        if by_rows { matrix[r][c_] = *c } else { matrix[c_][r] = *c }
    }
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let mut gram: Vec<Vec<f64>> =
        matrix.iter().map(|a| matrix.iter().map(|b| dot(a, b)).collect()).collect();
    if n == 1 {
        return gram[0][0].sqrt() * (1.0 + 1e-9);
    }
    // log₂ of what the power was divided by.
    let (mut scale, mut power) = (0.0_f64, 1.0_f64);
    for _ in 0..20 {
        let size = gram.iter().flatten().fold(0.0_f64, |size, c| size.max(c.abs()));
        for c in gram.iter_mut().flatten() {
            *c /= size;
        }
        scale = 2.0 * (scale + size.log2());
        // Symmetric.
        gram = gram.iter().map(|a| gram.iter().map(|b| dot(a, b)).collect()).collect();
        power *= 2.0;
    }
    let sum = gram.iter().map(|row| row.iter().map(|c| c.abs()).sum::<f64>()).fold(0.0, f64::max);
    ((scale + sum.log2()) / (2.0 * power)).exp2() * (1.0 + 1e-9)
}
