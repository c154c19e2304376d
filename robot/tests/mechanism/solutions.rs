use dq8::{Backend, DualQuat, Real, Scalar};
use dq8_arms::{Axis, Plan, Random, exact, puma, rounded, ur5};
use dq8_robot::ik::{SixAxisArm, Solutions};

fn explore<R: Scalar>(name: &str, plan: Plan<6>) {
    let plan = plan.with_axes(|axis| Axis { limits: [-3.2, 3.2], ..axis });
    let arm = plan.arm::<R>();
    let six = SixAxisArm::new(arm.0.view()).unwrap();
    println!("{name} {:?}", six.family());
    let mut random = Random(5);
    let n = 10_003;
    let goals: Vec<[f64; 6]> = (0..n).map(|_| plan.draw(&mut random)).collect();
    let targets: Vec<DualQuat<R>> = goals.iter().map(|&g| arm.forward(&rounded(g))).collect();
    let starts: Vec<[R; 6]> = goals.iter().map(|&g| rounded(g)).collect();
    let mut found = vec![Solutions::default(); n];
    let t = std::time::Instant::now();
    six.job().solutions(&targets, &starts, &mut found).unwrap();
    println!("{:?} ns per pose", t.elapsed().as_nanos() / n as u128);
    let mut counts = [0; 9];
    let mut worst = [0.0_f64; 2];
    let mut dist = 0.0_f64;
    let mut sing = 0;
    for ((all, goal), target) in found.iter().zip(&goals).zip(&targets) {
        counts[all.len()] += 1;
        for s in all.iter() {
            let real = dq8::DualQuat::<f64>::from_array(exact(target.to_array()));
            let iso = plan.isometry(&exact(s.values));
            let t = real.translation();
            let q = real.rotation().to_array();
            let q = nalgebra::UnitQuaternion::from_quaternion(nalgebra::Quaternion::new(
                q[3], q[0], q[1], q[2],
            ));
            let d = (iso.translation.vector - nalgebra::Vector3::from(t)).norm();
            worst[0] = worst[0].max(iso.rotation.angle_to(&q));
            worst[1] = worst[1].max(d);
            sing += s.singular.any() as usize;
        }
        let d: f64 = all.first().map_or(9.0, |s| s.distance.into());
        dist = dist.max(d);
    }
    println!("{name}: {counts:?} worst {worst:?} dist {dist} singular {sing}");
}

#[test]
fn explore_all() {
    explore::<f64>("ur5", ur5());
    explore::<f64>("puma", puma());
    explore::<f32>("ur5", ur5());
    explore::<f32>("puma", puma());
}
