//! First and second derivatives of an arm's effector, three ways.

use crate::{Arm, HyperDual};
use core::error::Error;
use dq8::{DualQuat, Hierarchy, Real, Twist};

/// Where the effector's origin is and its derivatives by the joint variables.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Derivatives {
    /// ∂p/∂qᵢ, a row a joint.
    pub first: [[f64; 3]; 6],
    /// ∂²p/∂qᵢ∂qⱼ.
    pub second: [[[f64; 3]; 6]; 6],
}

impl Derivatives {
    /// By hyper-dual numbers: ε₁ on joint i and ε₂ on joint j, for all 21 pairs i ≤ j (Fike
    /// & Alonso 2011). `step` is what is put on the units and divided out again; it makes no
    /// difference but for rounding, and 1 is as good as any.
    pub fn by_hyper_dual_numbers(arm: &Arm, variables: [f64; 6], step: f64) -> Self {
        let mut derivatives = Self::ZERO;
        for i in 0..6 {
            for j in i..6 {
                let position = arm.pose(seeded(variables, i, j, step)).translation();
                derivatives.first[i] = position.map(|c| c.dual.real / step);
                derivatives.first[j] = position.map(|c| c.real.dual / step);
                derivatives.second[i][j] = position.map(|c| c.dual.dual / (step * step));
                derivatives.second[j][i] = derivatives.second[i][j];
            }
        }
        derivatives
    }

    /// By central differences of positions: (f(q + h) − f(q − h))/2h, and for second
    /// derivatives the same by the second joint.
    pub fn by_central_differences(arm: &Arm, variables: [f64; 6], step: f64) -> Self {
        let at = |moves: &[(usize, f64)]| {
            let mut moved = variables;
            for &(joint, sign) in moves {
                moved[joint] += sign * step;
            }
            arm.pose(moved).translation()
        };
        let mut derivatives = Self::ZERO;
        for i in 0..6 {
            let (after, before) = (at(&[(i, 1.0)]), at(&[(i, -1.0)]));
            derivatives.first[i] = core::array::from_fn(|k| (after[k] - before[k]) / (2.0 * step));
            for j in i..6 {
                let [a, b, c, d] = [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)]
                    .map(|(first, second)| at(&[(i, first), (j, second)]));
                let difference = |k: usize| (a[k] - b[k]) - (c[k] - d[k]);
                let over = 4.0 * step * step;
                derivatives.second[i][j] = core::array::from_fn(|k| difference(k) / over);
                derivatives.second[j][i] = derivatives.second[i][j];
            }
        }
        derivatives
    }

    /// By screws: ∂p/∂qᵢ = Jᵢ at p, and with ∂Jᵢ/∂qⱼ = [Jⱼ, Jᵢ] for j < i, else
    /// zero (Murray, Li, Sastry 1994, §3.4), ∂²p/∂qᵢ∂qⱼ = (∂Jᵢ/∂qⱼ at p) +
    /// ωᵢ × ∂p/∂qⱼ.
    ///
    /// # Errors
    /// Those of [`columns`].
    pub fn by_screws(arm: &Arm, variables: [f64; 6]) -> Result<Self, Box<dyn Error>> {
        let columns = columns(arm, variables)?;
        let position = arm.pose(variables).translation();
        let mut derivatives =
            Self { first: columns.map(|c| c.velocity_at(position)), ..Self::ZERO };
        for i in 0..6 {
            for j in 0..6 {
                let turning = Twist { linear: [0.0; 3], ..columns[i] };
                let moved = turning.velocity_at(derivatives.first[j]);
                let changed = column_derivative(&columns, i, j).velocity_at(position);
                derivatives.second[i][j] = core::array::from_fn(|k| changed[k] + moved[k]);
            }
        }
        Ok(derivatives)
    }

    /// The largest difference of first derivatives and that of second ones; NaN if one is.
    pub fn distances(&self, other: &Self) -> [f64; 2] {
        let largest = |a: &[[f64; 3]], b: &[[f64; 3]]| {
            let pairs = a.as_flattened().iter().zip(b.as_flattened());
            pairs.fold(0.0, |most: f64, (a, b)| most.max_or_nan((a - b).abs()))
        };
        [
            largest(&self.first, &other.first),
            largest(self.second.as_flattened(), other.second.as_flattened()),
        ]
    }

    const ZERO: Self = Self { first: [[0.0; 3]; 6], second: [[[0.0; 3]; 6]; 6] };
}

/// The variables with ε₁ on joint i and ε₂ on joint j, both times `step`.
pub fn seeded(variables: [f64; 6], i: usize, j: usize, step: f64) -> [HyperDual<f64>; 6] {
    let mut seeded = variables.map(HyperDual::from_f64);
    seeded[i].dual.real = step;
    seeded[j].real.dual = step;
    seeded
}

/// The spatial Jacobian, from models of a hierarchy: Jᵢ = Ad of all joints before i on ξᵢ.
///
/// # Errors
/// Those of [`Hierarchy`], which six joints in a row do not meet.
pub fn columns(arm: &Arm, variables: [f64; 6]) -> Result<[Twist<f64>; 6], Box<dyn Error>> {
    let parents = [Hierarchy::ROOT, 0, 1, 2, 3, 4];
    let chain = Hierarchy::new(&parents)?;
    // Frames that all lie in the base at rest: then each local motion is that of the joint alone.
    let locals: [_; 6] = core::array::from_fn(|i| arm.joints[i].motion(variables[i]));
    let mut models = [DualQuat::IDENTITY; 6];
    chain.local_to_model(&locals, &mut models)?;
    Ok(core::array::from_fn(|i| models[i].adjoint(arm.joints[i].twist())))
}

/// ∂Jᵢ/∂qⱼ = [Jⱼ, Jᵢ] for j < i: what comes before joint i moves its screw, itself and
/// what comes after do not.
pub fn column_derivative(columns: &[Twist<f64>; 6], i: usize, j: usize) -> Twist<f64> {
    if j < i { bracket(columns[j], columns[i]) } else { Twist::from_array([0.0; 6]) }
}

/// [x, y] = ω×η + ε(ω×w + v×η), the Lie bracket of twists x = ω + εv and y = η + εw.
pub fn bracket(x: Twist<f64>, y: Twist<f64>) -> Twist<f64> {
    let turn = |angular, v| Twist { angular, linear: [0.0; 3] }.velocity_at(v);
    let (first, second) = (turn(x.angular, y.linear), turn(y.angular, x.linear));
    let linear = core::array::from_fn(|k| first[k] - second[k]);
    Twist { angular: turn(x.angular, y.angular), linear }
}
