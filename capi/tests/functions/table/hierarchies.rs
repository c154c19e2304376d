//! Hierarchies, their palettes, and plans.

use crate::argument::{Of, Read, Written, count, names, reads, writes};
use crate::function::Function;
use crate::shape::Shape;
use dq8::hierarchy::{Bones, Plan, PlanScratch, Poses, Root, RotationsTranslations};
use dq8::storage::Layout;
use dq8::{DualQuat, Hierarchy, Job, ShapeError};
use dq8_capi::{Status, hierarchy, plan};

pub(super) fn parents(shape: &Shape) -> Of<i32, Read> {
    let (parents, joints) = (shape.parents.clone(), shape.parents.len());
    let any = shape.any % joints.max(1);
    reads::<i32>(joints)
        .only(move |joint| parents[joint])
        .fault(Status::ParentOutOfRange, Some(0), |parents| parents[0] = -2)
        .fault(Status::ParentOutOfRange, Some(1), |parents| parents[1] = parents.len() as i32)
        .fault(Status::ParentNotBefore, Some(any), move |parents| parents[any] = any as i32)
}

/// The parents in Rust.
pub(super) fn unsigned(parents: &[i32]) -> Vec<u32> {
    parents.iter().map(|&parent| parent as u32).collect()
}

fn run<L: Layout>(
    parents: &[i32],
    root: &[DualQuat<L::Real>],
    run: impl FnOnce(Job<'_, Root<'_, L::Record<8>>>) -> Result<(), ShapeError>,
) -> Result<(), Status> {
    let parents = unsigned(parents);
    let root = root.first().map_or(Root::None, |root| Root::Same(*root));
    Ok(run(Hierarchy::new(&parents)?.job().on(root))?)
}

macro_rules! layout {
    ($shape:ident $list:ident $R:ident $of:ident $L:ty [$($lanes:literal)?]) => {{
        type Motion = DualQuat<$R>;
        fn of<const C: usize>(count: usize) -> Of<<$L as Layout>::Record<C>, Read> {
            reads(count)
        }
        fn to<const C: usize>(count: usize) -> Of<<$L as Layout>::Record<C>, Written> {
            writes(count)
        }
        let joints = $shape.parents.len();
        let n = $shape.instances.div_ceil(<$L as Layout>::THINGS) * joints;
        let (of_joints, root) = (|| parents($shape), || reads::<Motion>(1).unless_null(0));
        let all = || count(n).wrong(n + 1, Status::Length);
        of_arrays! { $list $R $of [$($lanes)?]:
            hierarchy local_to_model blocks_local_to_model (
                parents: of_joints(), joints: count(joints), root: root(),
                locals: of::<8>(n), models: to::<8>(n).over("locals"), count: all(),
            ) => run::<$L>(parents, root, |job| job.locals_to_model(Poses(locals), models));
            hierarchy model_to_local blocks_model_to_local (
                parents: of_joints(), joints: count(joints), root: root(),
                models: of::<8>(n), locals: to::<8>(n).over("models"), count: all(),
            ) => run::<$L>(parents, root, |job| job.model_to_local(models, locals));
            hierarchy rotations_to_model blocks_rotations_to_model (
                parents: of_joints(), joints: count(joints), root: root(),
                rotations: of::<4>(n), offsets: reads::<[$R; 3]>(joints), models: to::<8>(n), count: all(),
            ) => run::<$L>(parents, root, |job| job.locals_to_model(Bones { rotations, offsets }, models));
            hierarchy rotations_translations_to_model blocks_rotations_translations_to_model (
                parents: of_joints(), joints: count(joints), root: root(),
                locals: of::<7>(n), models: to::<8>(n), count: all(),
            ) => run::<$L>(parents, root, |job| job.locals_to_model(RotationsTranslations(locals), models));
            hierarchy palette blocks_palette (
                parents: of_joints(), joints: count(joints), root: root(), locals: of::<8>(n),
                binds: reads::<Motion>(joints), models: to::<8>(n), palette: to::<8>(n), count: all(),
            ) => run::<$L>(parents, root, |job| job.palette_and_models(Poses(locals), models, binds, palette));
            hierarchy palette_matrices blocks_palette_matrices (
                parents: of_joints(), joints: count(joints), root: root(), locals: of::<8>(n),
                binds: reads::<Motion>(joints), models: to::<8>(n), palette: to::<12>(n), count: all(),
            ) => run::<$L>(parents, root, |job| job.palette_and_models(Poses(locals), models, binds, palette));
        }
        layout! { @plain $shape $list $R $of [$($lanes)?] }
    }};
    (@plain $shape:ident $list:ident $R:ident $of:ident []) => {
        let (joints, n) = ($shape.parents.len(), $shape.poses());
        let order = planned($shape);
        of_numbers! { $list $R $of:
            "plan_" plan local_to_model (
                // Others: the order is not theirs.
                parents: parents($shape).fault(Status::NoPlan, None, |parents| parents[1] = -1 - parents[1]),
                order: reads::<[u32; 2]>(joints).only(move |at| order[at])
                    .fault(Status::NoPlan, None, |order| order.fill([77; 2]))
                    .fault(Status::NoPlan, None, |order| order[1] = [0; 2]),
                joints: count(joints),
                locals: reads::<[$R; 8]>(n), models: writes::<[$R; 8]>(n).over("locals"),
                count: count(n).wrong(n + 1, Status::Length),
            ) => run::<dq8::storage::Aos<$R>>(parents, &[], |job| job.locals_to_model(Poses(locals), models));
        }
    };
    (@plain $shape:ident $list:ident $R:ident $of:ident [$lanes:literal]) => {};
}
mod layouts {
    use super::*;
    crate::table::for_all_layouts!(layout);
}

/// The order of a plan.
fn planned(shape: &Shape) -> Vec<[u32; 2]> {
    let joints = shape.parents.len();
    let (parents, mut order) = (unsigned(&shape.parents), vec![[0; 2]; joints]);
    let mut scratch = vec![PlanScratch::default(); joints];
    let hierarchy = Hierarchy::new(&parents).expect("a hierarchy");
    Plan::new(&hierarchy, &mut order, &mut scratch).expect("as many");
    order
}

pub(super) fn add(shape: &Shape, to: &mut Vec<Function>) {
    layouts::add(shape, to);
    let joints = shape.parents.len();
    functions! { to:
        "dq8_check_parents", hierarchy::dq8_check_parents =
            (parents: parents(shape), joints: count(joints), bad_joint: names())
            => Hierarchy::new(&unsigned(parents));
        "dq8_plan_make", plan::dq8_plan_make = (
            parents: parents(shape), joints: count(joints), order: writes::<[u32; 2]>(joints),
            scratch: writes::<[u32; 6]>(joints).untold(), bad_joint: names(),
        ) => {
            let parents = unsigned(parents);
            let mut scratch = vec![PlanScratch::default(); scratch.len()];
            Plan::new(&Hierarchy::new(&parents)?, order, &mut scratch).map(|_| ())?
        };
    }
}
