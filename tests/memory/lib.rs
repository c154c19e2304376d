//! Plans and skins, whose numbers are checked once and read without a check from then on: any
//! order, any joints, any lengths, by safe code. All memory is of exactly its length, so that the
//! address sanitizer sees a number too far; what is computed is what indexing finds.
//! `DQ8_FUZZ_SECONDS` says how long (a fifth of one by default), `DQ8_FUZZ_SEED` from where.
#![cfg(test)]
#![forbid(unsafe_code)]

use dq8::hierarchy::{Plan, PlanScratch};
use dq8::skinning::{DualBlend, Linear, Skin, Surface, SurfaceMut};
use dq8::{Backend, DualQuat, Hierarchy};
use dq8_fixtures::fuzz;
use dq8_fixtures::random::Random;

/// Sums of a few dozen numbers in `f32`, relative to the largest.
const ROUNDING: f32 = 1e-4;

type Motion = DualQuat<f32>;

fn translation(random: &mut Random) -> Motion {
    DualQuat::from_translation(random.vector().map(|c: f64| c as f32))
}

#[track_caller]
fn near(got: [f32; 3], wanted: [f32; 3]) {
    let size = wanted.iter().fold(1.0_f32, |most, c| most.max(c.abs()));
    let off = got.iter().zip(wanted).fold(0.0_f32, |most, (a, b)| most.max((a - b).abs()));
    assert!(off <= ROUNDING * size, "{got:?} is not {wanted:?}");
}

/// A length as it should be, mostly.
fn length(random: &mut Random, right: usize) -> usize {
    match random.below(12) {
        0 => right.saturating_sub(1),
        1 => right + 1,
        2 => random.below(2 * right + 2),
        _ => right,
    }
}

/// Any pairs as the order of a plan: that of the parents, the same in disorder and with doubles,
/// and what is none.
fn plans(random: &mut Random) {
    let joints = random.below(40);
    let chain = random.below(4) == 0;
    let parents: Box<[u32]> = (0..joints)
        .map(|joint| match random.below(8) {
            0 if !chain => Hierarchy::ROOT,
            _ if joint == 0 => Hierarchy::ROOT,
            _ if chain => joint as u32 - 1,
            _ => random.below(joint) as u32,
        })
        .collect();
    let hierarchy = Hierarchy::new(&parents).expect("parents come first");
    let mut order: Box<[[u32; 2]]> = vec![[0; 2]; joints].into();
    let mut scratch: Box<[PlanScratch]> = vec![PlanScratch::default(); joints].into();
    Plan::new(&hierarchy, &mut order, &mut scratch).expect("an element per joint");
    for _ in 0..random.below(3) * joints {
        // A pair of the parents in another place, once or more often.
        let (to, from) = (random.below(joints), random.below(joints));
        if random.below(3) == 0 { order[to] = order[from] } else { order.swap(to, from) }
    }
    if random.below(3) == 0 && joints > 0 {
        let any = [0, joints as u32, joints as u32 + 1, u32::MAX, u32::MAX - 1, 1 << 16];
        order[random.below(joints)][random.below(2)] = any[random.below(any.len())];
    }
    let is_root = |pair: &&[u32; 2]| pair[1] == Hierarchy::ROOT;
    let roots = order.iter().take_while(is_root).count();
    let is_pair = |&[joint, parent]: &[u32; 2]| parents.get(joint as usize) == Some(&parent);
    let fits = order.iter().all(is_pair) && !order[roots..].iter().any(|pair| is_root(&pair));
    let plan = Plan::of_order(&hierarchy, &order);
    assert_eq!(plan.is_ok(), fits, "{order:?}");
    let Ok(plan) = plan else { return };
    let (inputs, outputs) = (length(random, joints), length(random, joints));
    let locals: Box<[Motion]> = (0..inputs).map(|_| translation(random)).collect();
    let mut models: Box<[Motion]> = vec![DualQuat::IDENTITY; outputs].into();
    let job = hierarchy.job().plan(&plan);
    let done = job.local_to_model(&locals, &mut models);
    let whole = if joints == 0 { inputs == 0 } else { inputs.is_multiple_of(joints) };
    assert_eq!(done.is_ok(), inputs == outputs && whole);
    let mut wanted: Box<[Motion]> = vec![DualQuat::IDENTITY; outputs].into();
    if done.is_ok() && inputs == joints {
        for &[joint, parent] in &order {
            let above = models_of(&wanted, parent);
            wanted[joint as usize] = above * locals[joint as usize];
        }
        for (got, wanted) in models.iter().zip(&wanted) {
            near(got.translation(), wanted.translation());
        }
    }
    let _ = job.local_to_model_in_place(&mut models);
}

/// The model of a parent; the identity above roots.
fn models_of(models: &[Motion], parent: u32) -> Motion {
    models.get(parent as usize).copied().unwrap_or(DualQuat::IDENTITY)
}

/// Any joints as those of a skin, over palettes and meshes of any length.
fn skins(random: &mut Random) {
    let (joints, vertices) = (random.below(12), random.below(40));
    let influences = random.below(10);
    let mut who: Box<[u16]> =
        (0..vertices * influences).map(|_| random.below(joints) as u16).collect();
    if random.below(3) == 0 && !who.is_empty() {
        let any = [joints as u16, joints as u16 + 1, u16::MAX];
        who[random.below(who.len())] = any[random.below(any.len())];
    }
    let part = 1.0 / influences.max(1) as f32;
    let weights: Box<[f32]> = vec![part; length(random, who.len())].into();
    let fits = influences > 0
        && weights.len() == who.len()
        && who.iter().all(|&joint| usize::from(joint) < joints);
    let skin = Skin::new(joints, influences, &who, &weights);
    assert_eq!(skin.is_ok(), fits, "{joints} joints, {influences} influences, {who:?}");
    let Ok(skin) = skin else { return };
    let palette: Box<[Motion]> = (0..length(random, joints)).map(|_| translation(random)).collect();
    let matrices: Box<[[[f32; 4]; 3]]> =
        palette.iter().map(|motion| motion.to_matrix3x4()).collect();
    let rest: Box<[[f32; 3]]> = vec![[0.0; 3]; length(random, vertices)].into();
    let mut posed: Box<[[f32; 3]]> = vec![[7.0; 3]; length(random, rest.len())].into();
    let (from, linear, dual) =
        (Surface::positions(&rest), Linear::new(&matrices), DualBlend::new(&palette));
    let backends: Vec<_> = Backend::available().collect();
    let backend = backends[random.below(backends.len())];
    let is_linear = random.below(2) == 0;
    let to = SurfaceMut::positions(&mut posed);
    let done = match is_linear {
        true => skin.job().backend(backend).pose(linear, from, to),
        false => skin.job().backend(backend).pose(dual, from, to),
    };
    if done.is_err() {
        assert!(posed.iter().all(|&point| point == [7.0; 3]));
        return;
    }
    assert!(rest.len() == vertices && posed.len() == vertices);
    for (who, &got) in who.chunks(influences).zip(&posed) {
        // A blend of translations, dual or linear, is that of their vectors.
        let moved = who.iter().map(|&joint| palette[usize::from(joint)].translation());
        let add = |sum: [f32; 3], v: [f32; 3]| std::array::from_fn(|i| part.mul_add(v[i], sum[i]));
        near(got, moved.fold([0.0; 3], add));
    }
}

#[test]
fn nothing_is_read_or_written_that_is_not_there() {
    fuzz::rounds(|seed| {
        let mut random = fuzz::random(seed);
        for _ in 0..20 {
            plans(&mut random);
            skins(&mut random);
        }
        40
    });
}
