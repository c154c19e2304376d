//! Covariances of poses: in another frame, of inverses, of products.
//!
//! # Which frame, which side, which order
//!
//! The error of a pose σ̄ is a small twist ξ = (ω, v) *on the right*, σ = σ̄ exp(ξ): in the
//! axes of the moving body, in radians and lengths, as
//! [`DualQuat::from_twist`](dq8::DualQuat::from_twist) takes it. Its covariance P, the mean of
//! ξξᵀ, is 6×6, by rows, *angular first*. GTSAM has the same.
//!
//! | memory | order |
//! |---|---|
//! | `[R; 36]`, `[[R; 6]; 6]`, blocks of 36 rows | angular first |
//! | `[LinearFirst<R>; 6]` | linear first: rows and columns (Barfoot, Solà, Sophus, ROS) |
//!
//! Elsewhere the error stands on the *left*, σ = exp(ζ)σ̄: in the axes of the world and about
//! its origin (Barfoot and Furgale 2014). As ζ = Ad ξ, [`carry_covariances`] by σ̄ makes the
//! one of the other, and by σ̄⁻¹ goes back. The messages of ROS have a third form: turns about
//! the axes of the world, and the error of the *position*. Those are (R̄ω, R̄v), so carrying by
//! the rotation of σ̄ alone makes them, and by its inverse goes back.
//!
//! A covariance is symmetric; of two entries that mirror each other one is read, and both are
//! written. All is of first order in the errors: exact for linear maps, and for motions as good as
//! the errors are small (Barfoot and Furgale have terms of fourth order).
//!
//! Sources: Solà, Deray, Atchuthan 2018, *A micro Lie theory for state estimation in robotics*,
//! §II-E and III; Barfoot and Furgale 2014, *Associating Uncertainty with Three-Dimensional Poses
//! for Use in Estimation Problems*.

use dq8::batch::{self, vector};
use dq8::internal::Rows;
use dq8::storage::{self, Element, Register, Tile, same_length};
use dq8::{Backend, Kernel, Lanes, Level, ShapeError};

/// `carried[i]` = Ad P Adᵀ of the unit `motions[i]` and the covariance P = `covariances[i]` of a
/// twist: that of the twist Ad ξ, which is ξ in the frame that the motion leads into.
/// [The module](self) says which order.
///
/// ```
/// use dq8::{Backend, DualQuat};
/// use dq8_trajectory::covariance::carry_covariances;
/// // A robot ten metres ahead is not sure of its yaw. In the world that turns about the origin,
/// // and moves along y.
/// let robot = [DualQuat::from_translation([10.0, 0.0, 0.0])];
/// let mut unsure = [[[0.0_f64; 6]; 6]];
/// unsure[0][2][2] = 0.01;
/// let mut world = unsure;
/// carry_covariances(Backend::best(), &robot, &unsure, &mut world)?;
/// assert_eq!([world[0][2][2], world[0][2][4], world[0][4][4]], [0.01, -0.1, 1.0]);
/// # Ok::<(), dq8::ShapeError>(())
/// ```
///
/// # Errors
/// If the slices differ in length; `carried` is untouched.
pub fn carry_covariances<M: Element<8>, P: Element<36, Layout = M::Layout>>(
    backend: Backend,
    motions: &[M],
    covariances: &[P],
    carried: &mut [P],
) -> Result<(), ShapeError> {
    let none: Option<&[P]> = None;
    same_length("covariances", covariances.len(), motions.len())?;
    same_length("carried", carried.len(), motions.len())?;
    Carry::<_, _, false> { motions, covariances, added: none }.share(backend, carried);
    Ok(())
}

/// `inverses[i]` = Ad P Adᵀ: the covariance of σ⁻¹, of the pose σ̄ = `poses[i]` with the
/// covariance P = `covariances[i]`. For (σ̄ exp ξ)⁻¹ = exp(−ξ) σ̄⁻¹ = σ̄⁻¹
/// exp(−Ad ξ), it is Ad of the pose and not of its inverse.
///
/// ```
/// use dq8::{Backend, DualQuat};
/// use dq8_trajectory::covariance::inverse_covariances;
/// let robot = [DualQuat::from_translation([10.0_f32, 0.0, 0.0])];
/// let mut unsure = [[[0.0; 6]; 6]];
/// unsure[0][2][2] = 0.01;
/// let mut inverse = unsure;
/// inverse_covariances(Backend::best(), &robot, &unsure, &mut inverse)?;
/// // Seen from the robot, the world ten metres behind swings along y.
/// assert!((inverse[0][4][4] - 1.0).abs() < 1e-6);
/// # Ok::<(), dq8::ShapeError>(())
/// ```
///
/// # Errors
/// If the slices differ in length; `inverses` is untouched.
pub fn inverse_covariances<M: Element<8>, P: Element<36, Layout = M::Layout>>(
    backend: Backend,
    poses: &[M],
    covariances: &[P],
    inverses: &mut [P],
) -> Result<(), ShapeError> {
    same_length("inverses", inverses.len(), poses.len())?;
    carry_covariances(backend, poses, covariances, inverses)
}

/// `products[i]` = Ad⁻¹ A Ad⁻ᵀ + B: the covariance of the product ab, where the pose a has
/// the covariance A = `first[i]`, b has B = `second[i]`, and Ad⁻¹ is that of b̄⁻¹, b̄ =
/// `poses[i]`. For ā exp(α) b̄ exp(β) = ā b̄ exp(Ad⁻¹ α) exp(β), ā does not count. The
/// errors of a and of b must be independent.
///
/// ```
/// use dq8::{Backend, DualQuat};
/// use dq8_trajectory::covariance::product_covariances;
/// // A scanner four metres ahead of a car whose yaw is unsure, and mounted to within a centimetre.
/// let mount = [DualQuat::from_translation([4.0_f64, 0.0, 0.0])];
/// let (mut car, mut scanner) = ([[[0.0; 6]; 6]], [[[0.0; 6]; 6]]);
/// (car[0][2][2], scanner[0][4][4]) = (0.01, 1e-4);
/// let mut product = car;
/// product_covariances(Backend::best(), &mount, &car, &scanner, &mut product)?;
/// assert!((product[0][4][4] - (0.16 + 1e-4)).abs() < 1e-15);
/// # Ok::<(), dq8::ShapeError>(())
/// ```
///
/// # Errors
/// If the slices differ in length; `products` is untouched.
pub fn product_covariances<M: Element<8>, P: Element<36, Layout = M::Layout>>(
    backend: Backend,
    poses: &[M],
    first: &[P],
    second: &[P],
    products: &mut [P],
) -> Result<(), ShapeError> {
    same_length("first", first.len(), poses.len())?;
    same_length("second", second.len(), poses.len())?;
    same_length("products", products.len(), poses.len())?;
    let carry = Carry::<_, _, true> { motions: poses, covariances: first, added: Some(second) };
    carry.share(backend, products);
    Ok(())
}

/// Ad P Adᵀ, or of the inverse motion, and what is added to it.
#[derive(Clone, Copy)]
struct Carry<'s, M, P, const BACK: bool> {
    motions: &'s [M],
    covariances: &'s [P],
    added: Option<&'s [P]>,
}

/// The fewest elements in a task, of some dozens of nanoseconds each.
const GRAIN: usize = 512;

impl<M: Element<8>, P: Element<36, Layout = M::Layout>, const BACK: bool> Carry<'_, M, P, BACK> {
    /// The lengths have been checked.
    fn share(self, backend: Backend, carried: &mut [P]) {
        let work = |first: usize, (carried, _): Rows<'_, P>| {
            let part = first..first + carried.len();
            let (motions, covariances) =
                (&self.motions[part.clone()], &self.covariances[part.clone()]);
            let added = self.added.map(|added| &added[part.clone()]);
            backend.run(Part { carry: Self { motions, covariances, added }, carried });
        };
        backend.share(GRAIN, (carried, 1), &work);
    }
}

struct Part<'s, C, P> {
    carry: C,
    carried: &'s mut [P],
}

impl<M, P, const BACK: bool> Kernel for Part<'_, Carry<'_, M, P, BACK>, P>
where
    M: Element<8>,
    P: Element<36, Layout = M::Layout>,
{
    type Output = ();

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn run<V: Level>(self, level: V) {
        let Self { carry, carried } = self;
        for tile in storage::tiles::<P, V, 36>(carried.len()) {
            // The lengths were checked, so this always is something.
            let Some(covariance) = carry.tile(level, tile) else { return };
            P::store(covariance, carried, tile);
        }
    }
}

impl<M: Element<8>, P: Element<36, Layout = M::Layout>, const BACK: bool> Carry<'_, M, P, BACK> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn tile<V: Level>(&self, level: V, tile: Tile) -> Option<[Register<P, V, 36>; 36]> {
        let motion = M::load(level, self.motions, tile, &storage::identity())?;
        let mut motion = batch::DualQuat::from_array(motion);
        if BACK {
            motion = motion.conjugate();
        }
        let covariance = P::load(level, self.covariances, tile, &storage::identity())?;
        let mut carried = Halves::of(&covariance).carried(motion.to_matrix3x4());
        if let Some(added) = self.added {
            let added = Halves::of(&P::load(level, added, tile, &storage::identity())?);
            carried.add(&added);
        }
        Some(carried.numbers())
    }
}

type Matrix<L> = [[L; 3]; 3];

/// A covariance in 3×3 matrices: of ω with itself, of ω by rows with v, and of v with itself. Of
/// the first and the last the upper half counts.
struct Halves<L> {
    angular: Matrix<L>,
    mixed: Matrix<L>,
    linear: Matrix<L>,
}

impl<L: Lanes> Halves<L> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn of(numbers: &[L; 36]) -> Self {
        let zero = [[numbers[0]; 3]; 3];
        let mut halves = Self { angular: zero, mixed: zero, linear: zero };
        for i in 0..3 {
            for j in 0..3 {
                let (low, high) = (i.min(j), i.max(j));
                halves.angular[i][j] = numbers[6 * low + high];
                halves.mixed[i][j] = numbers[6 * i + j + 3];
                halves.linear[i][j] = numbers[6 * (low + 3) + high + 3];
            }
        }
        halves
    }

    /// With M = RAR*, N = RBR*, Q = RCR* (* the transpose), and T the cross product with t: M in
    /// place of A, N + MT* of B, and Q + W + W* of C, W = T(N + ½MT*).
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn carried(self, rows: [[L; 4]; 3]) -> Self {
        let [[a, b, c, x], [d, e, f, y], [g, h, i, z]] = rows;
        let (turn, translation) = ([[a, b, c], [d, e, f], [g, h, i]], [x, y, z]);
        let angular = turned(turn, self.angular);
        let mut mixed = turned(turn, self.mixed);
        let mut linear = turned(turn, self.linear);
        let mut half = mixed;
        for row in 0..3 {
            let moved = vector::cross(translation, angular[row]);
            mixed[row] = vector::add(mixed[row], moved);
            half[row] = vector::scale_onto(moved, x.constant(0.5), half[row]);
        }
        let half = transposed(half);
        let mut carried = linear;
        for row in 0..3 {
            carried[row] = vector::cross(translation, half[row]);
        }
        for row in 0..3 {
            for column in row..3 {
                let both = carried[row][column] + carried[column][row];
                linear[row][column] = linear[row][column] + both;
            }
        }
        Self { angular, mixed, linear }
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn add(&mut self, other: &Self) {
        for row in 0..3 {
            self.angular[row] = vector::add(self.angular[row], other.angular[row]);
            self.mixed[row] = vector::add(self.mixed[row], other.mixed[row]);
            self.linear[row] = vector::add(self.linear[row], other.linear[row]);
        }
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn numbers(self) -> [L; 36] {
        let mut numbers = [self.mixed[0][0]; 36];
        for i in 0..3 {
            for j in 0..3 {
                let (low, high) = (i.min(j), i.max(j));
                numbers[6 * i + j] = self.angular[low][high];
                numbers[6 * i + j + 3] = self.mixed[i][j];
                numbers[6 * (j + 3) + i] = self.mixed[i][j];
                numbers[6 * (i + 3) + j + 3] = self.linear[low][high];
            }
        }
        numbers
    }
}

/// R X R*
#[cfg_attr(not(opt_level_0), inline(always))]
fn turned<L: Lanes>(turn: Matrix<L>, matrix: Matrix<L>) -> Matrix<L> {
    // The rows of XR* are R times those of X.
    let columns = transposed(rows_by(turn, matrix));
    transposed(rows_by(turn, columns))
}

/// A matrix times each of these vectors.
#[cfg_attr(not(opt_level_0), inline(always))]
fn rows_by<L: Lanes>(matrix: Matrix<L>, vectors: Matrix<L>) -> Matrix<L> {
    let mut images = vectors;
    for index in 0..3 {
        for row in 0..3 {
            images[index][row] = vector::dot(matrix[row], vectors[index]);
        }
    }
    images
}

#[cfg_attr(not(opt_level_0), inline(always))]
fn transposed<L: Copy>([[a, b, c], [d, e, f], [g, h, i]]: Matrix<L>) -> Matrix<L> {
    [[a, d, g], [b, e, h], [c, f, i]]
}
