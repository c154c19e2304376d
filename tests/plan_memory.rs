//! Plans in memory of the caller's: the order is that of list scheduling, the models are those of a
//! skeleton, and what is no order of these parents is refused.

use dq8::hierarchy::{Plan, PlanScratch};
use dq8::{DualQuat, Hierarchy, ShapeError, Skeleton};
use dq8_contract::random::Random;

/// How many other joints are begun before a joint whose parent is being computed.
const BETWEEN: usize = 4;

/// A tree, a chain, a bush, a forest.
fn all_parents() -> Vec<Vec<u32>> {
    let mut random = Random(11);
    let mut all = vec![vec![], vec![Hierarchy::ROOT], vec![Hierarchy::ROOT; 9]];
    all.extend([2, 23, 24, 70].map(|joints| (0..joints).map(|j: u32| j.wrapping_sub(1)).collect()));
    for joints in [3, 17, 64, 200] {
        for reach in [1, 2, 7, 1000] {
            let mut parent = |joint: usize| match joint {
                0 => Hierarchy::ROOT,
                _ if random.below(20) == 0 => Hierarchy::ROOT,
                _ => (joint - 1 - random.below(joint.min(reach))) as u32,
            };
            all.push((0..joints).map(&mut parent).collect());
        }
    }
    all
}

fn motions(count: usize) -> Vec<DualQuat<f32>> {
    let one = |i: usize| {
        let s = i as f32;
        DualQuat::from_array([s.sin(), 0.3, s.cos(), 0.9, 0.1 * s, 1.0, -0.5, 0.2]).normalize()
    };
    (0..count).map(one).collect()
}

/// Time step by time step, with a look at all joints in each: those whose parent has been begun
/// long enough, and of them the one with the longest way down, the first among equals.
fn list_scheduling(parents: &[u32]) -> Vec<[u32; 2]> {
    let mut heights = vec![0; parents.len()];
    for (joint, &parent) in parents.iter().enumerate().rev() {
        if parent != Hierarchy::ROOT {
            heights[parent as usize] = heights[parent as usize].max(heights[joint] + 1);
        }
    }
    let mut begun: Vec<Option<usize>> = vec![None; parents.len()];
    let mut order = Vec::new();
    for time in 0.. {
        if order.len() == parents.len() {
            break;
        }
        let is_able = |joint: &usize| {
            let after = |parent: usize| begun[parent].is_some_and(|at| at + BETWEEN <= time);
            begun[*joint].is_none()
                && (parents[*joint] == Hierarchy::ROOT || after(parents[*joint] as usize))
        };
        let able = (0..parents.len()).filter(is_able);
        if let Some(joint) = able.max_by_key(|&joint| (heights[joint], std::cmp::Reverse(joint))) {
            begun[joint] = Some(time);
            order.push([joint as u32, parents[joint]]);
        }
    }
    // Those without a parent come first.
    order.sort_by_key(|pair| pair[1] != Hierarchy::ROOT);
    order
}

#[test]
fn the_order_is_that_of_list_scheduling_by_the_longest_way_down() {
    for parents in all_parents() {
        let hierarchy = Hierarchy::new(&parents).unwrap();
        let mut order = vec![[7; 2]; parents.len()];
        let mut scratch = vec![PlanScratch::default(); parents.len()];
        Plan::new(&hierarchy, &mut order, &mut scratch).unwrap();
        assert_eq!(order, list_scheduling(&parents), "{parents:?}");
        // What has been in the scratch does not matter.
        let mut again = vec![[9; 2]; parents.len()];
        Plan::new(&hierarchy, &mut again, &mut scratch).unwrap();
        assert_eq!(again, order);
    }
}

#[test]
fn models_are_those_of_a_skeleton_to_the_last_bit() {
    for parents in all_parents() {
        let hierarchy = Hierarchy::new(&parents).unwrap();
        let owned = Skeleton::new(&parents).unwrap();
        let mut order = vec![[0; 2]; parents.len()];
        let mut scratch = vec![PlanScratch::default(); parents.len()];
        Plan::new(&hierarchy, &mut order, &mut scratch).unwrap();
        let plan = Plan::of_order(&hierarchy, &order).unwrap();
        for instances in 0..3 {
            let locals = motions(instances * parents.len());
            let mut models =
                [vec![DualQuat::ZERO; locals.len()], vec![DualQuat::ZERO; locals.len()]];
            owned.local_to_model(&locals, &mut models[0]).unwrap();
            let job = hierarchy.job().plan(&plan);
            job.local_to_model(&locals, &mut models[1]).unwrap();
            assert_eq!(models[0], models[1], "{parents:?}");
            models[1].copy_from_slice(&locals);
            job.local_to_model_in_place(&mut models[1]).unwrap();
            assert_eq!(models[0], models[1], "{parents:?}, in place");
        }
    }
}

#[test]
fn memory_of_another_length_is_refused_and_left_alone() {
    let parents = [Hierarchy::ROOT, 0, 0];
    let hierarchy = Hierarchy::new(&parents).unwrap();
    for (order, scratch) in [(2, 3), (4, 3), (3, 2), (3, 4)] {
        let (mut order, mut scratch) = (vec![[7; 2]; order], vec![PlanScratch::default(); scratch]);
        let plan = Plan::new(&hierarchy, &mut order, &mut scratch);
        assert!(matches!(plan, Err(ShapeError::Length { .. })), "{plan:?}");
        assert!(order.iter().all(|pair| *pair == [7; 2]));
    }
}

#[test]
fn an_order_of_other_parents_is_refused_and_the_pair_named() {
    let root = Hierarchy::ROOT;
    let parents = [root, 0, 0];
    let hierarchy = Hierarchy::new(&parents).unwrap();
    let place = |order: &[[u32; 2]]| Plan::of_order(&hierarchy, order).map(|_| ()).unwrap_err();
    assert!(Plan::of_order(&hierarchy, &[[0, root], [2, 0], [1, 0]]).is_ok());
    // A joint that there is not, another parent, and a parent where there is none.
    for bad in [[3, 0], [2, 1], [2, 3], [2, root], [root, root], [root, 0]] {
        let order = [[0, root], [1, 0], bad];
        assert_eq!(place(&order), ShapeError::NotOrder { place: 2 }, "{bad:?}");
    }
    assert_eq!(place(&[[0, 0], [1, 0], [2, 0]]), ShapeError::NotOrder { place: 0 });
    let expected = 3;
    for order in [&[][..], &[[0, root], [1, 0]], &[[0, root], [1, 0], [2, 0], [2, 0]]] {
        let length = order.len();
        assert_eq!(place(order), ShapeError::Length { what: "order", length, expected });
    }
    // A root behind the others.
    let forest = [root, 0, root];
    let forest = Hierarchy::new(&forest).unwrap();
    let order = [[0, root], [1, 0], [2, root]];
    let refused = Plan::of_order(&forest, &order).map(|_| ()).unwrap_err();
    assert_eq!(refused, ShapeError::NotOrder { place: 1 });
    assert!(Plan::of_order(&forest, &[[2, root], [0, root], [1, 0]]).is_ok());
}

#[test]
fn the_plan_of_other_parents_is_refused_and_nothing_written() {
    let root = Hierarchy::ROOT;
    let (parents, same, other, longer) =
        ([root, 0, 0], [root, 0, 0], [root, 0, 1], [root, 0, 0, 0]);
    let hierarchy = Hierarchy::new(&parents).unwrap();
    let (locals, mut models) = (motions(3), motions(3));
    for (parents, fits) in [(&same[..], true), (&other, false), (&longer, false)] {
        let (mut order, mut scratch) = ([[0; 2]; 4], [PlanScratch::default(); 4]);
        let count = parents.len();
        let of = Hierarchy::new(parents).unwrap();
        let plan = Plan::new(&of, &mut order[..count], &mut scratch[..count]).unwrap();
        let job = hierarchy.job().plan(&plan);
        let refused = Err(ShapeError::OtherPlan);
        if fits {
            job.local_to_model(&locals, &mut models).unwrap();
            models.copy_from_slice(&locals);
            continue;
        }
        assert_eq!(job.local_to_model(&locals, &mut models), refused);
        assert_eq!(job.local_to_model_in_place(&mut models), refused);
        assert_eq!(job.model_to_local(&locals, &mut models), refused);
        assert_eq!(models, locals);
    }
}

#[test]
fn poses_of_another_length_are_refused_and_left_alone() {
    let parents = [Hierarchy::ROOT, 0, 0];
    let (mut order, mut scratch) = ([[0; 2]; 3], [PlanScratch::default(); 3]);
    let hierarchy = Hierarchy::new(&parents).unwrap();
    let plan = Plan::new(&hierarchy, &mut order, &mut scratch).unwrap();
    let (locals, mut models) = (motions(4), motions(4));
    let job = hierarchy.job().plan(&plan);
    assert!(job.local_to_model(&locals, &mut models).is_err());
    assert!(job.local_to_model(&locals[..3], &mut models).is_err());
    assert!(job.local_to_model_in_place(&mut models).is_err());
    assert_eq!(models, locals);
}
