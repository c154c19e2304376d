//! All cores give what one gives.

use crate::tree::{mechanism, tree, values};
use dq8::{Backend, Block, DualQuat};
use dq8_fixtures::random::Random;
use dq8_robot::Body;

#[test]
fn all_cores_give_every_bit_of_what_one_gives() {
    let mut random = Random(10);
    for count in [1, 7, 30] {
        let joints = tree(&mut random, count);
        let configurations = 5000;
        let values: Vec<f64> =
            (0..configurations).flat_map(|_| values(&mut random, &joints)).collect();
        let owned = mechanism::<f64>(&joints);
        let robot = owned.view();
        assert!(robot.values() > 0);
        let backend = Backend::best();
        let mut poses = [(); 2].map(|()| vec![DualQuat::IDENTITY; configurations * count]);
        let [one, all] = &mut poses;
        robot.job().backend(backend).poses(&values, one).unwrap();
        robot.job().backend(backend).threads(usize::MAX).poses(&values, all).unwrap();
        assert!(one == all, "{count}");
        let empty = Block::<f64, 8>::splat([0.0; 8]);
        let mut blocks = [(); 2].map(|()| vec![empty; configurations / 8 * count]);
        let [one, all] = &mut blocks;
        robot.job().backend(backend).poses(&values, one).unwrap();
        robot.job().backend(backend).threads(usize::MAX).poses(&values, all).unwrap();
        assert!(one == all, "{count}, blocks");
        let links = [count - 1, 0];
        let mut poses = [(); 2].map(|()| vec![DualQuat::IDENTITY; configurations * 2]);
        let [one, all] = &mut poses;
        robot.job().links(&links).backend(backend).poses(&values, one).unwrap();
        robot.job().links(&links).backend(backend).threads(usize::MAX).poses(&values, all).unwrap();
        assert!(one == all, "{count}, chosen");
        let points = [(0, [0.5; 3]), (count - 1, [0.1, 0.2, 0.3])];
        let mut places = [(); 2].map(|()| vec![[0.0; 3]; configurations * 2]);
        let [one, all] = &mut places;
        robot.job().backend(backend).points(&points, &values, one).unwrap();
        robot.job().backend(backend).threads(usize::MAX).points(&points, &values, all).unwrap();
        assert!(one == all, "{count}, points");
        let mut tools = [(); 2].map(|()| vec![DualQuat::IDENTITY; 2 * configurations]);
        let mut columns = [(); 2].map(|()| vec![[0.0; 6]; 2 * configurations * robot.rates()]);
        let ([one, all], [columns, all_columns]) = (&mut tools, &mut columns);
        robot.job().links(&links).backend(backend).jacobians(Body, &values, one, columns).unwrap();
        robot
            .job()
            .links(&links)
            .backend(backend)
            .threads(usize::MAX)
            .jacobians(Body, &values, all, all_columns)
            .unwrap();
        assert!(one == all && columns == all_columns, "{count}, Jacobians");
        let rates = vec![0.5; configurations * robot.rates()];
        let second: Vec<f64> =
            rates.iter().zip(&values).map(|(rate, value)| rate * value).collect();
        let mut poses = [(); 2].map(|()| vec![DualQuat::IDENTITY; configurations * count]);
        let mut twists = [(); 4].map(|()| vec![[0.0; 6]; configurations * count]);
        let ([one, all], [a, b, c, d]) = (&mut poses, &mut twists);
        robot.job().backend(backend).velocities(&values, &rates, one, a).unwrap();
        robot
            .job()
            .backend(backend)
            .threads(usize::MAX)
            .velocities(&values, &rates, all, b)
            .unwrap();
        assert!(one == all && a == b, "{count}, velocities");
        let second = [&second[..], &rates].concat();
        let second = &second[..rates.len()];
        robot.job().backend(backend).accelerations(&values, &rates, second, one, a, c).unwrap();
        all.fill(DualQuat::IDENTITY);
        robot
            .job()
            .backend(backend)
            .threads(usize::MAX)
            .accelerations(&values, &rates, second, all, b, d)
            .unwrap();
        assert!(one == all && a == b && c == d, "{count}, accelerations");
        for (fewer, rates) in [(count, &rates[..]), (0, &rates[1..])] {
            let (all, b) = (&mut all[fewer..], &mut b[fewer..]);
            b.fill([7.0; 6]);
            assert!(
                robot
                    .job()
                    .backend(backend)
                    .threads(usize::MAX)
                    .velocities(&values, rates, all, b)
                    .is_err()
            );
            assert!(b.iter().all(|twist| *twist == [7.0; 6]), "{count}, refused");
        }
    }
}
