//! Each form that a job can take has its record, or a reason why it has none: the list of forms is
//! read from the sources of the jobs.

use dq8_proofs::operations::Form;
use dq8_proofs::record::Record;
use dq8_proofs::table::bounds;
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

/// A form as the sources name it, the records of it, and why there is not more.
type Row = (&'static str, &'static [&'static str], &'static str);

const SAMPLED: &str = "not proved: the pose is interpolated first; the product is that of `bones` or `local_to_model`";
const FORMS: &[Row] = &[
    // Instances in blocks: by the product of `batch::DualQuat`.
    (
        "src/hierarchy/blocks.rs Blocks",
        &["local_to_model_blocks", "local_to_model_roots_blocks", "bones_blocks"],
        "",
    ),
    // Plain instances as many as there are lanes; and what is left over, or alone.
    ("src/hierarchy/plain.rs Instances", &["local_to_model_lanes", "bones_lanes"], ""),
    (
        "src/hierarchy/plain.rs product_in_lanes x 4",
        &["local_to_model_lanes", "local_to_model_roots_lanes"],
        "",
    ),
    ("src/hierarchy/plain.rs OneByOne", &["local_to_model", "bones"], ""),
    ("src/hierarchy/plain.rs product x 1", &["local_to_model", "local_to_model_roots"], ""),
    ("src/hierarchy/plain.rs PaletteInstances", &["palette_lanes"], ""),
    ("src/hierarchy/plan.rs InOrder", &["local_to_model_planned"], ""),
    ("src/hierarchy/plan.rs Begin", &["local_to_model_planned_root"], ""),
    (
        "src/hierarchy/plan.rs product x 3",
        &["local_to_model_planned", "local_to_model_planned_root"],
        "",
    ),
    ("src/hierarchy/plan.rs End", &["palette"], ""),
    // A step of each pass; a chain of segments as a whole is not proved.
    (
        "src/hierarchy/chain.rs Scan",
        &["chain_products", "chain_products_blocks", "local_to_model_planned_chain"],
        "",
    ),
    (
        "src/hierarchy/chain.rs packed_product x 3",
        &["chain_products_scan", "chain_products_rest", "local_to_model"],
        "the third is that of `product`, which other loops call",
    ),
    ("src/hierarchy/run.rs Palette", &["palette", "palette_lanes", "palette_blocks"], ""),
    ("src/hierarchy/run.rs NoEpilogue", &[], "not proved: computes nothing"),
    ("src/hierarchy/backward.rs Backward", &["model_to_local"], ""),
    (
        "src/hierarchy/backward.rs Write",
        &[],
        "not proved: only makes motions of locals, as `from_rotation_translation` does",
    ),
    (
        "src/hierarchy/limb.rs Check",
        &[],
        "not proved: asks for faults, and computes no pose that is kept",
    ),
    (
        "src/hierarchy/limb.rs Reach",
        &[],
        "not proved: a triangle's angles by roots; `tests/two_bone.rs` measures it",
    ),
    ("src/hierarchy/locals.rs Poses", &["local_to_model"], ""),
    ("src/hierarchy/locals.rs InPlace", &["local_to_model_blocks"], ""),
    ("src/hierarchy/locals.rs Bones", &["bones", "bones_lanes", "bones_blocks"], ""),
    ("src/hierarchy/layers.rs $Poses", &["bones"], "the law of what follows"),
    ("src/hierarchy/layers.rs RotationsTranslations", &["bones", "bones_blocks"], "the same law"),
    ("src/hierarchy/layers.rs Tracks", &["bones", "bones_blocks"], "the same law"),
    ("src/hierarchy/layers.rs Layered", &[], SAMPLED),
    ("src/hierarchy/clip.rs Sampled", &[], SAMPLED),
    ("src/hierarchy/layers.rs Either", &[], "not proved: one of two others"),
    (
        "src/skinning/job.rs Run",
        &[
            "linear_skin",
            "scaled_point",
            "dual_skin",
            "linear_normal",
            "unit_normal",
            "dual_normal",
            "scaled_normal",
        ],
        "",
    ),
    (
        "robot/src/mechanism/walk.rs Walk",
        &["link_jacobian", "jacobians", "link_placed", "poses_placed"],
        "",
    ),
    ("JointKind::Fixed", &["link_placed", "poses_placed"], ""),
    ("JointKind::Floating", &["link_slide", "poses_slide"], ""),
    ("JointKind::Prismatic", &["link_slide", "poses_slide"], ""),
    (
        "JointKind::Revolute",
        &["link_turn", "poses_turn"],
        "the tape alone: what its sine is off is measured",
    ),
    ("JointKind::Screw", &[], "not proved: the sums of a hinge and of a slide, and a sine"),
    ("JointKind::Planar", &[], "not proved: the sums of a hinge and of a point, and a sine"),
    ("robot/src/ik/job.rs Batch", &[], "not proved: a search"),
    ("robot/src/ik/rates.rs Velocities", &[], "not proved: solves a system"),
    ("robot/src/ik/six_axis.rs SolutionsKernel", &[], "not proved: angles by arcs"),
];

/// The text of a file of dq8 without its tests.
fn source(path: &Path) -> String {
    let text = fs::read_to_string(path).expect("a file of the repository");
    text.split("#[cfg(test)]").next().unwrap_or_default().to_string()
}

/// All that is written as `what` and a name: kernels are the loops of jobs, locals what a joint
/// adds.
fn forms() -> BTreeSet<String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut found = BTreeSet::new();
    for folder in ["src/hierarchy", "src/skinning", "robot/src/mechanism", "robot/src/ik"] {
        for entry in fs::read_dir(root.join(folder)).expect("a folder of the repository") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                continue;
            }
            let (text, file) = (source(&path), path.file_name().expect("a name").to_string_lossy());
            for line in text.lines().filter(|line| line.trim_start().starts_with("impl<")) {
                for what in [" Kernel for ", "> Locals<E> for ", "> Epilogue<E> for "] {
                    if let Some((_, name)) = line.split_once(what.trim_start_matches('>')) {
                        let name: String =
                            name.chars().take_while(|c| c.is_alphanumeric() || *c == '$').collect();
                        found.insert(format!("{folder}/{file} {name}"));
                    }
                }
            }
            for (_, line) in
                text.match_indices("\nlocals_by_law!(").map(|(at, _)| text[at..].split_at(1))
            {
                let name = line.split("] ").nth(1).unwrap_or_default();
                let name: String = name.chars().take_while(|c| c.is_alphanumeric()).collect();
                found.insert(format!("{folder}/{file} {name}"));
            }
            // The products that loops over single instances call: how many times each.
            for product in ["packed_product(", "product_in_lanes(", " product("] {
                let lines =
                    text.lines().filter(|line| !line.contains("fn ") && !line.contains("//"));
                let count: usize = lines.map(|line| line.matches(product).count()).sum();
                if count > 0 && folder == "src/hierarchy" {
                    let product = product.trim_matches([' ', '(']);
                    found.insert(format!("{folder}/{file} {product} x {count}"));
                }
            }
        }
    }
    let joints = source(&root.join("robot/src/mechanism/joint.rs"));
    let kinds = joints.split("pub enum JointKind").nth(1).and_then(|text| text.split("\n}").next());
    for line in kinds.expect("the kinds of joints").lines() {
        let name = line.strip_prefix("    ").unwrap_or_default();
        if name.starts_with(|c: char| c.is_uppercase()) {
            let name: String = name.chars().take_while(|c| c.is_alphanumeric()).collect();
            found.insert(format!("JointKind::{name}"));
        }
    }
    found
}

#[test]
fn each_form_of_a_job_has_its_record_or_says_why_not() {
    let rows: BTreeSet<String> = FORMS.iter().map(|row| row.0.to_string()).collect();
    let found = forms();
    let (new, gone) = (found.difference(&rows), rows.difference(&found));
    assert!(
        found == rows,
        "without a row: {:#?}\nrows of nothing: {:#?}",
        new.collect::<Vec<_>>(),
        gone.collect::<Vec<_>>()
    );
    let jobs = Record::all().iter().filter(|record| record.form == Form::Job);
    let jobs: BTreeSet<&str> = jobs.map(|record| record.operation.name).collect();
    let named: BTreeSet<&str> = FORMS.iter().flat_map(|row| row.1).copied().collect();
    assert_eq!(jobs, named, "records of jobs, and those that rows name");
    for (form, records, why) in FORMS {
        assert!(!records.is_empty() || why.starts_with("not proved"), "{form}: {why}");
    }
}

/// The chain of `coq/chain.v` stands on the bounds of today's steps: twice as long as each of four
/// components, plain ones or in blocks.
#[test]
fn the_numbers_of_the_chain_are_those_of_the_bounds() {
    let theorem = include_str!("../coq/chain.v");
    // The largest factor of a part, with |p||s| or |q||r| in it.
    let worst = |names: &[&str], part: &str, lengths: &[usize]| -> f64 {
        let records = Record::all().iter().filter(|record| {
            names.contains(&record.operation.name)
                && matches!(record.form, Form::Job | Form::Lanes | Form::Single)
        });
        let terms = records.flat_map(bounds).filter(|one| one.name == part).flat_map(|one| {
            let bound = one.bound.expect("products are bounded");
            bound
                .0
                .into_iter()
                .filter(|(powers, _)| powers.iter().map(|p| p.0).eq(lengths.iter().copied()))
        });
        terms.map(|(_, c)| (c * 1000.0).ceil() / 1000.0).fold(0.0, f64::max)
    };
    const PLAIN: &[&str] = &[
        "local_to_model",
        "local_to_model_lanes",
        "local_to_model_roots",
        "local_to_model_roots_lanes",
        "local_to_model_planned",
        "local_to_model_planned_root",
    ];
    const BLOCKS: &[&str] = &["local_to_model_blocks", "local_to_model_roots_blocks"];
    let (real, q) = (worst(PLAIN, "real", &[0, 2]), worst(PLAIN, "dual", &[1, 2]));
    assert_eq!([real, q], [worst(BLOCKS, "real", &[0, 2]), worst(BLOCKS, "dual", &[1, 2])]);
    let (least, most) = (worst(PLAIN, "dual", &[0, 3]), worst(BLOCKS, "dual", &[0, 3]));
    for hypothesis in [
        format!("Hypothesis D : {} <= d <= {}.", 2.0 * least, 2.0 * most),
        format!("Hypothesis ES : forall n, e (S n) <= e n + {} * u * (1 + e n).", 2.0 * real),
        format!("+ {} * (INR n * (b / 2) + f n)).", 2.0 * q),
        format!(
            "+ {} * u * ((1 + e n) * (INR n * (b / 2) + f n)) ->",
            worst(&["translation"], "translation", &[0, 1])
        ),
    ] {
        assert!(theorem.contains(&hypothesis), "not in chain.v: {hypothesis}");
    }
}
