//! Plans: the models are those of the Rust plan, bad memory is refused, and nothing is written then.

#[path = "support/answers.rs"]
mod answers;

use answers::answers;
use dq8::{DualQuat, Real, Scalar, Skeleton};
use dq8_capi::Status;
use dq8_capi::plan::{self, dq8_plan_make as make};
use std::ptr;

const PARENTS: [i32; 6] = [-1, 0, 1, 0, 3, -1];
const JOINTS: usize = PARENTS.len();

struct Memory {
    order: [u32; 2 * JOINTS],
    scratch: [u32; 6 * JOINTS],
}

/// Numbers that are no joint.
const EMPTY: Memory = Memory { order: [77; 2 * JOINTS], scratch: [78; 6 * JOINTS] };

fn made() -> Memory {
    let mut memory = EMPTY;
    let (order, scratch) = (memory.order.as_mut_ptr(), memory.scratch.as_mut_ptr());
    // SAFETY: arrays have as many numbers as they should.
    let status = unsafe { make(PARENTS.as_ptr(), JOINTS, order, scratch, ptr::null_mut()) };
    assert_eq!(status, Status::Ok);
    memory
}

fn poses<R: Scalar>(count: usize) -> Vec<DualQuat<R>> {
    let one = |i: usize| {
        let s = i as f64;
        let numbers = [s.sin(), 0.3, s.cos(), 0.9, 0.1 * s, 1.0, -0.5, 0.2];
        DualQuat::from_array(numbers.map(<R as Real>::from_f64)).normalize()
    };
    (0..count).map(one).collect()
}

macro_rules! agree {
    ($test:ident, $R:ident, $of:ident) => {
        #[test]
        fn $test() {
            use plan::$of as p;
            let rust = Skeleton::new(&PARENTS).unwrap();
            let memory = made();
            for instances in 0..3 {
                let count = instances * JOINTS;
                let (locals, mut wanted) = (poses::<$R>(count), poses::<$R>(count));
                rust.job().local_to_model_in_place(&mut wanted).unwrap();
                let mut models = vec![DualQuat::ZERO; count];
                let mut in_place = locals.clone();
                let (from, order) = (locals.as_ptr().cast(), memory.order.as_ptr());
                let (to, over) = (models.as_mut_ptr().cast(), in_place.as_mut_ptr().cast());
                // SAFETY: arrays have `count` motions, two numbers per joint.
                let done = unsafe {
                    [
                        p::local_to_model(PARENTS.as_ptr(), order, JOINTS, from, to, count),
                        p::local_to_model(PARENTS.as_ptr(), order, JOINTS, over, over, count),
                    ]
                };
                assert_eq!(done, [Status::Ok; 2]);
                assert_eq!(models, wanted);
                assert_eq!(in_place, wanted);
            }
        }
    };
}
agree!(floats_agree_with_the_rust_plan, f32, single);
agree!(doubles_agree_with_the_rust_plan, f64, double);

#[test]
fn an_order_that_was_not_made_is_refused_and_so_are_bad_pointers() {
    use plan::single as p;
    let (memory, locals) = (made(), poses::<f32>(JOINTS + 1));
    let mut models = locals.clone();
    let (from, to) = (locals.as_ptr().cast::<f32>(), models.as_mut_ptr().cast::<f32>());
    let (parents, order) = (PARENTS.as_ptr(), memory.order.as_ptr());
    // The same joints with other parents.
    let others = [-1, 0, 0, 0, 3, -1];
    let (other, forward) = (others.as_ptr(), [-1, 2, 0, 0, 0, 0]);
    // SAFETY: what is dereferenced is as long as it is said to be.
    let results = unsafe {
        [
            (
                p::local_to_model(parents, EMPTY.order.as_ptr(), JOINTS, from, to, JOINTS),
                Status::NoPlan,
            ),
            (p::local_to_model(parents, order, JOINTS, from, to, JOINTS + 1), Status::Length),
            (p::local_to_model(parents, order, JOINTS - 1, from, to, JOINTS - 1), Status::NoPlan),
            (p::local_to_model(other, order, JOINTS, from, to, JOINTS), Status::NoPlan),
            (
                p::local_to_model(forward.as_ptr(), order, JOINTS, from, to, JOINTS),
                Status::ParentNotBefore,
            ),
            (
                p::local_to_model(parents, ptr::null(), JOINTS, from, to, JOINTS),
                Status::NullPointer,
            ),
            (p::local_to_model(ptr::null(), order, JOINTS, from, to, JOINTS), Status::NullPointer),
            (
                p::local_to_model(parents, order, JOINTS, ptr::null(), to, JOINTS),
                Status::NullPointer,
            ),
            (p::local_to_model(parents, order, JOINTS, to.add(8), to, JOINTS - 1), Status::Overlap),
            (p::local_to_model(parents, to.cast(), JOINTS, from, to, JOINTS), Status::Overlap),
            (p::local_to_model(to.cast(), order, JOINTS, from, to, JOINTS), Status::Overlap),
            (
                p::local_to_model(parents, order, JOINTS, from, to.byte_add(1), JOINTS),
                Status::Misaligned,
            ),
            (p::local_to_model(ptr::null(), ptr::null(), 0, from, to, 0), Status::Ok),
        ]
    };
    answers(results);
    assert_eq!(models, locals);
}

#[test]
fn bad_parents_and_memory_are_refused_and_the_joint_is_named() {
    let mut memory = EMPTY;
    let (order, scratch) = (memory.order.as_mut_ptr(), memory.scratch.as_mut_ptr());
    let (parents, none) = (PARENTS.as_ptr(), ptr::null_mut());
    let mut bad = 99;
    let (forward, beyond) = ([-1, 2, 0, 0, 0, 0], [-1, 0, 0, 6, 0, 0]);
    // SAFETY: what is dereferenced is as long as it is said to be.
    unsafe {
        answers([
            (make(ptr::null(), JOINTS, order, scratch, none), Status::NullPointer),
            (make(parents, JOINTS, ptr::null_mut(), scratch, none), Status::NullPointer),
            (make(parents, JOINTS, order, ptr::null_mut(), none), Status::NullPointer),
            (make(parents, JOINTS, order.byte_add(2), scratch, none), Status::Misaligned),
            (make(parents, JOINTS, order, order, none), Status::Overlap),
            (make(order.cast(), JOINTS, order, scratch, none), Status::Overlap),
            (make(scratch.cast(), JOINTS, order, scratch, none), Status::Overlap),
            (make(parents, JOINTS, order, scratch, order.cast()), Status::Overlap),
            (make(parents, JOINTS, order, scratch, scratch.cast()), Status::Overlap),
            (make(parents, usize::MAX / 2, order, scratch, none), Status::TooLarge),
        ]);
        let status = make(forward.as_ptr(), JOINTS, order, scratch, &raw mut bad);
        assert_eq!((status, bad), (Status::ParentNotBefore, 1));
        let status = make(beyond.as_ptr(), JOINTS, order, scratch, &raw mut bad);
        assert_eq!((status, bad), (Status::ParentOutOfRange, 3));
    }
    assert_eq!(memory.order, EMPTY.order);
    assert_eq!(memory.scratch, EMPTY.scratch);
}
