//! Twists and Jacobians of hierarchies.

use crate::sample::{COUNT, JOINTS, PARENTS, block, for_all_lanes, motions, numbers, same, vector};
use dq8::simd;
use dq8::storage::Block;
use dq8::{Hierarchy, Twist};
use dq8_capi::velocity;

macro_rules! agree {
    ($test:ident, $R:ident, $of:ident, $lanes:literal) => {
        #[test]
        fn $test() {
            use velocity::$of as v;
            let parents = PARENTS.map(|parent| parent as u32);
            let skeleton = Hierarchy::new(&parents).unwrap();
            let twist = |i| Twist::<$R> { angular: vector(i, 1.0), linear: vector(i, 2.0) };
            let (models, rates) = (motions(0.0), (0..COUNT).map(twist).collect::<Vec<_>>());
            let (p, none) = (PARENTS.as_ptr(), [Twist::from_array([9.0; 6]); COUNT]);
            let (pm, pr, axes) = (numbers(&models), numbers(&rates), &rates[..JOINTS]);
            let job = skeleton.job();
            type Twists = simd::Block<[$R; $lanes], 6>;
            let of = |k: usize| block(|i| models[(i + k) % COUNT].to_array());
            let blocks: [Block<$R, $lanes>; JOINTS] = std::array::from_fn(of);
            let rates_of = |k: usize| block(|i| twist(i + k).to_array());
            let rates_in: [Twists; JOINTS] = std::array::from_fn(rates_of);
            let (bm, br, empty) =
                (numbers(&blocks), numbers(&rates_in), [Twists::splat([9.0; 6]); JOINTS]);
            // SAFETY: arrays have COUNT or JOINTS elements, as they should.
            unsafe {
                same! { |o|
                    "velocities": &none, v::velocities(p, JOINTS, pm, pr, o, COUNT)
                        => job.velocities(&models, &rates, o).unwrap();
                    "in blocks": &empty, v::blocks_velocities($lanes, p, JOINTS, bm, br, o, JOINTS)
                        => skeleton.job().velocities(&blocks, &rates_in, o).unwrap();
                }
                for effector in 0..JOINTS {
                    same! { |o|
                        "jacobian": &none, v::jacobian(p, JOINTS, pm, pr, effector, o, COUNT)
                            => job.jacobian(&models, axes, effector, o).unwrap();
                        "jacobian in blocks": &empty,
                            v::blocks_jacobian($lanes, p, JOINTS, bm, pr, effector, o, JOINTS)
                            => skeleton.job().jacobian(&blocks, axes, effector, o).unwrap();
                    }
                }
            }
        }
    };
}
for_all_lanes!(agree);
