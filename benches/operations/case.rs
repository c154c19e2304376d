//! [`Case`]: what operations are applied to, in any implementation of [`Motion`](dq8::Motion).

use dq8::{DualQuat, DualVector, Line, Quat};
use dq8_contract::random::Random;
use dq8_contract::sample::Sample;

/// A whole number of every lane type. The largest input and output, of `product` with matrices, are
/// 24 KiB together: they fit in any L1.
pub(crate) const ELEMENTS: usize = 128;

/// Numbers for one of each.
pub(crate) struct Element {
    a: [f64; 8],
    b: [f64; 8],
    scaled: [f64; 8],
    rotation: [f64; 4],
    translation: [f64; 3],
    vector: [f64; 3],
    moment: [f64; 3],
    log: [[f64; 3]; 2],
    t: f64,
}

/// One value for each lane of `M`.
pub(crate) struct Case<M: Sample> {
    pub(crate) a: M,
    /// From a, a turn of 0.3 to 2.2 radians and a shift of at most 1: no way is ambiguous, and none
    /// so short that nalgebra's ScLERP in `f32` stands still.
    pub(crate) b: M,
    /// A real multiple of a, which is all that nalgebra normalizes as this crate does.
    pub(crate) scaled: M,
    pub(crate) rotation: M::Quat,
    pub(crate) translation: [M::Real; 3],
    /// A point or a direction.
    pub(crate) vector: [M::Real; 3],
    pub(crate) line: Line<M::Real>,
    pub(crate) log: DualVector<M::Real>,
    pub(crate) t: M::Real,
}

impl Element {
    fn random(random: &mut Random) -> Self {
        let (a, way) = (motion(random, -3.0, 3.0), motion(random, 0.3, 2.2));
        let [rotation, vector] = [(); 2].map(|()| random.direction());
        let rotation = Quat::from_axis_angle(rotation, random.between(-3.0, 3.0));
        let [translation, point] = [(); 2].map(|()| random.direction());
        let log = a.log();
        Self {
            a: a.to_array(),
            b: (a * way).to_array(),
            scaled: a.scale(random.between(0.5, 2.0)).to_array(),
            rotation: rotation.to_array(),
            translation,
            vector,
            moment: cross(point, vector),
            log: [log.real, log.dual],
            t: random.between(0.0, 1.0),
        }
    }

    pub(crate) fn all() -> Vec<Self> {
        let mut random = Random(8);
        (0..ELEMENTS).map(|_| Self::random(&mut random)).collect()
    }
}

fn motion(random: &mut Random, least: f64, most: f64) -> DualQuat<f64> {
    let turn = Quat::from_axis_angle(random.direction(), random.between(least, most));
    let shift = random.between(0.0, 1.0);
    DualQuat::from_rotation_translation(turn, random.direction().map(|c| c * shift))
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|i| a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3])
}

impl<M: Sample> Case<M> {
    /// Lane i from element i.
    fn gather(elements: &[Element]) -> Self {
        let motions = |of: fn(&Element) -> [f64; 8]| -> M {
            M::gather(&elements.iter().map(of).collect::<Vec<_>>())
        };
        let vectors =
            |of: fn(&Element) -> [f64; 3]| M::vector(&elements.iter().map(of).collect::<Vec<_>>());
        let reals =
            |of: &dyn Fn(&Element) -> f64| M::real(&elements.iter().map(of).collect::<Vec<_>>());
        Self {
            a: motions(|e| e.a),
            b: motions(|e| e.b),
            scaled: motions(|e| e.scaled),
            rotation: M::quat([0, 1, 2, 3].map(|c| reals(&|e| e.rotation[c]))),
            translation: vectors(|e| e.translation),
            vector: vectors(|e| e.vector),
            line: Line { direction: vectors(|e| e.vector), moment: vectors(|e| e.moment) },
            log: DualVector { real: vectors(|e| e.log[0]), dual: vectors(|e| e.log[1]) },
            t: reals(&|e| e.t),
        }
    }
}

/// The cases of one implementation.
pub(crate) struct Cases<M: Sample> {
    all: Vec<Case<M>>,
    /// The same motion in every lane, for operations of many by one.
    pub(crate) one: M,
}

impl<M: Sample> Cases<M> {
    pub(crate) fn new(elements: &[Element]) -> Self {
        let all = elements.chunks_exact(M::LANES).map(Case::gather).collect();
        Self { all, one: M::gather(&vec![elements[0].a; M::LANES]) }
    }

    /// Only what an operation reads, close together.
    pub(crate) fn select<I>(&self, input: impl Fn(&Case<M>) -> I) -> Vec<I> {
        self.all.iter().map(input).collect()
    }
}
