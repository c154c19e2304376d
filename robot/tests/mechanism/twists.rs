//! Twists with their linear part first.

use dq8::storage::{Block, LinearFirst, pack, unpack};
use dq8::{Backend, DualQuat, Twist};

#[test]
fn a_twist_with_its_linear_part_first_is_the_same_twist() {
    let twist = Twist { angular: [1.0, 2.0, 3.0], linear: [4.0, 5.0, 6.0] };
    let swapped = LinearFirst::from(twist);
    assert_eq!(swapped, LinearFirst([4.0, 5.0, 6.0, 1.0, 2.0, 3.0]));
    assert_eq!(Twist::from(swapped), twist);
    // Read as well as written, by any kernel, with what lies beyond the end.
    let motions: Vec<DualQuat<f64>> = (0..11)
        .map(|i| {
            let s = f64::from(i);
            DualQuat::from_array([s.sin(), 0.3, s.cos(), 0.9, 0.1 * s, 1.0, -0.5, 0.2]).normalize()
        })
        .collect();
    let twists: Vec<_> = (0..11).map(|i| [1.0, 2.0, 3.0, 4.0, 5.0, f64::from(i)]).collect();
    let swapped: Vec<_> =
        twists.iter().map(|&numbers| LinearFirst::from(Twist::from_array(numbers))).collect();
    for backend in Backend::available() {
        let (mut moved, mut moved_swapped) = (twists.clone(), swapped.clone());
        backend.transform_twists_each(&motions, &twists, &mut moved).unwrap();
        backend.transform_twists_each(&motions, &swapped, &mut moved_swapped).unwrap();
        let back: Vec<_> =
            moved_swapped.iter().map(|&twist| Twist::from(twist).to_array()).collect();
        assert_eq!(back, moved, "{backend}");
        let mut packed = [Block::<f64, 8, 6>::splat([0.0; 6]); 2];
        pack(1, &swapped, &mut packed).unwrap();
        let mut plain = vec![[0.0; 6]; 11];
        unpack(1, &packed, &mut plain).unwrap();
        assert_eq!(plain, twists);
    }
}
