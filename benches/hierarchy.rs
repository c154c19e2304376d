//! Hierarchy concatenation: throughput in joints, dq8 and its peers on the same data.
//!
//! One skeleton of 64 joints, crowds of 1 to 8192 instances, out of place and in place, in every
//! layout and with every set of instructions that the CPU has. The groups `one-instance` have plans
//! too. The group `locals` writes down the locals of two clips, on skeletons small and large,
//! beside their models, which are more work.
//!
//! ```text
//! cargo bench --bench hierarchy -- crowd/1024/in-place
//! cargo bench --bench hierarchy -- '16 lanes AVX2'
//! cargo bench --bench hierarchy -- one-instance
//! cargo bench --bench hierarchy -- locals
//! ```

mod measurement;

use criterion::{Criterion, criterion_group, criterion_main};
use dq8_contest::task::{Shape, Task, Way};
use measurement::measure;

fn crowds(criterion: &mut Criterion) {
    for instances in [1, 8, 64, 1024, 8192] {
        for (name, way) in [("out-of-place", Way::Out), ("in-place", Way::In)] {
            let name = format!("crowd/{instances}/{name}");
            measure(criterion, &name, Task::Hierarchy(Shape::Crowd { instances }, way));
        }
    }
}

fn one_instance(criterion: &mut Criterion) {
    let mut measure = |name: String, shape| {
        let name = format!("one-instance/{name}");
        measure(criterion, &name, Task::Hierarchy(shape, Way::Out));
    };
    measure("skeleton".to_owned(), Shape::Crowd { instances: 1 });
    measure("biped".to_owned(), Shape::Biped);
    for count in [1, 4, 16] {
        measure(format!("chains-{count}"), Shape::Chains { count });
        measure(format!("tree-{count}"), Shape::Tree { children: count });
    }
    for joints in [8, 16, 24, 32, 64, 128, 1000, 10_000] {
        measure(format!("chain/{joints}"), Shape::Chain { joints });
    }
}

fn locals(criterion: &mut Criterion) {
    for joints in [16, 21, 32, 64] {
        measure(criterion, &format!("locals/{joints}"), Task::Locals(512, joints));
    }
}

criterion_group! { name = hierarchy; config = measurement::brief(); targets = crowds, one_instance, locals }
criterion_main!(hierarchy);
