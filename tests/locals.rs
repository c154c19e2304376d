//! Locals that are less than a motion, and skinning palettes: on every backend and layout, what the
//! products of plain motions are.

mod memory;

use dq8::hierarchy::PaletteEntry;
use dq8::{
    Backend, DualQuat, Hierarchy, Motions, Pose, Quat, Rotations, RotationsTranslations, ShapeError,
};
use dq8_contract::kinematics;
use dq8_simd::{Block, Row};
use memory::Memory;

const JOINTS: usize = 11;
const PARENTS: [u32; JOINTS] = [Hierarchy::ROOT, 0, 1, 1, 3, 0, Hierarchy::ROOT, 6, 7, 8, 7];

fn wave(i: usize, f: f64) -> f64 {
    (i as f64 * f + 0.3).sin()
}

fn rotation(i: usize) -> Quat<f64> {
    Quat::from_parts([wave(i, 0.7), wave(i, 1.3), wave(i, 1.9)], 1.5).normalize()
}

fn offset(joint: usize) -> [f64; 3] {
    [wave(joint, 0.9), 0.5, wave(joint, 2.3)]
}

fn inverse_bind(joint: usize) -> DualQuat<f64> {
    DualQuat::from_rotation_translation(rotation(joint + 100), offset(joint + 5))
}

/// A pose layout, with the layouts of what belongs to it.
trait Layout: Pose + PaletteEntry<Self> + Memory<8, Number = <Self as Pose>::Real> {
    type Rotations: Memory<4, Number = <Self as Pose>::Real> + Into<Self::Rotation>;
    type Both: Memory<7, Number = <Self as Pose>::Real> + Into<Self::RotationTranslation>;
    type Matrix: Memory<12, Number = <Self as Pose>::Real> + PaletteEntry<Self>;
    const LANES: usize;
}

impl Layout for DualQuat<f32> {
    type Rotations = Quat<f32>;
    type Both = [f32; 7];
    type Matrix = [[f32; 4]; 3];
    const LANES: usize = 1;
}
impl Layout for DualQuat<f64> {
    type Rotations = Quat<f64>;
    type Both = [f64; 7];
    type Matrix = [[f64; 4]; 3];
    const LANES: usize = 1;
}
impl<A: Row<Real: dq8::Real>> Layout for Block<A, 8> {
    type Rotations = Block<A, 4>;
    type Both = Block<A, 7>;
    type Matrix = Block<A, 12>;
    const LANES: usize = A::LANES;
}

/// `[instance][joint]` into `[instance block][joint]`, lanes without an instance repeating the first.
fn pack<M: Memory<C>, const C: usize>(lanes: usize, records: &[[f64; C]]) -> Vec<M> {
    let instances = records.len() / JOINTS;
    let mut packed = Vec::new();
    for block in 0..instances.div_ceil(lanes) {
        for joint in 0..JOINTS {
            let here = (block * lanes..instances.min((block + 1) * lanes))
                .map(|instance| records[instance * JOINTS + joint].map(dq8::Real::from_f64));
            packed.extend(M::pack(&here.collect::<Vec<_>>()));
        }
    }
    packed
}

/// What is in `elements` for each instance and joint.
fn unpack<M: Memory<C>, const C: usize>(lanes: usize, elements: &[M]) -> Vec<Vec<[f64; C]>> {
    let of_element = |element| {
        let records = M::unpack(std::slice::from_ref(element), lanes);
        records.into_iter().map(|record| record.map(Into::into)).collect()
    };
    elements.iter().map(of_element).collect()
}

#[track_caller]
fn close<const C: usize>(what: &str, single: bool, got: [f64; C], wanted: [f64; C]) {
    let bound = if single { 4e-6 } else { 8e-15 };
    for (a, b) in got.iter().zip(wanted) {
        assert!((a - b).abs() <= bound, "{what}: {got:?} is not {wanted:?}");
    }
}

fn check<P: Layout>(backend: Backend, instances: usize) {
    let hierarchy = Hierarchy::new(&PARENTS).expect("a hierarchy");
    let job = || hierarchy.job::<P>().backend(backend);
    let single = size_of::<<P as Pose>::Real>() == 4;
    let name = format!("{backend}, {} lanes, {instances} instances", P::LANES);

    let count = instances * JOINTS;
    let motion = |i: usize| DualQuat::from_rotation_translation(rotation(i), offset(i % JOINTS));
    let locals: Vec<_> = (0..count).map(motion).collect();
    let mut models = locals.clone();
    kinematics::local_to_model(&PARENTS, &locals, &mut models);
    let matches = |what: &str, got: &[P]| {
        for (element, lanes) in unpack::<P, 8>(P::LANES, got).into_iter().enumerate() {
            let (block, joint) = (element / JOINTS, element % JOINTS);
            for (lane, got) in lanes.into_iter().enumerate() {
                let instance = block * P::LANES + lane;
                if instance < instances {
                    let wanted = models[instance * JOINTS + joint].to_array();
                    close(&format!("{name}: {what}"), single, got, wanted);
                }
            }
        }
    };

    let locals: Vec<_> = (0..count).map(|i| motion(i).to_array()).collect();
    let locals: Vec<P> = pack(P::LANES, &locals);
    let rotations: Vec<_> = (0..count).map(|i| rotation(i).to_array()).collect();
    let rotations: Vec<P::Rotation> =
        pack::<P::Rotations, 4>(P::LANES, &rotations).into_iter().map(Into::into).collect();
    let both = |i: usize| {
        let ([x, y, z, w], [tx, ty, tz]) = (rotation(i).to_array(), offset(i % JOINTS));
        [x, y, z, w, tx, ty, tz]
    };
    let both: Vec<_> = (0..count).map(both).collect();
    let both: Vec<P::RotationTranslation> =
        pack::<P::Both, 7>(P::LANES, &both).into_iter().map(Into::into).collect();
    let offsets: Vec<_> = (0..JOINTS).map(|j| offset(j).map(dq8::Real::from_f64)).collect();

    let mut out = locals.clone();
    job().locals_to_model(Motions(&locals), &mut out).expect("they fit");
    matches("motions", &out);
    job().locals_to_model(RotationsTranslations(&both), &mut out).expect("they fit");
    matches("rotations and translations", &out);
    let turned = Rotations { rotations: &rotations, offsets: &offsets };
    job().locals_to_model(turned, &mut out).expect("they fit");
    matches("rotations", &out);

    let binds: Vec<_> = (0..JOINTS)
        .map(|j| DualQuat::from_array(inverse_bind(j).to_array().map(dq8::Real::from_f64)))
        .collect();
    let mut palette = locals.clone();
    job().locals_to_palette(turned, &mut out, &binds, &mut palette).expect("they fit");
    matches("models beside a palette", &out);
    let mut matrices: Vec<P::Matrix> = pack(P::LANES, &vec![[0.0; 12]; count]);
    job().locals_to_palette(turned, &mut out, &binds, &mut matrices).expect("they fit");
    let palette = unpack::<P, 8>(P::LANES, &palette);
    let matrices = unpack::<P::Matrix, 12>(P::LANES, &matrices);
    for instance in 0..instances {
        for joint in 0..JOINTS {
            let (element, lane) = (instance / P::LANES * JOINTS + joint, instance % P::LANES);
            let wanted = models[instance * JOINTS + joint] * inverse_bind(joint);
            close(&format!("{name}: palette"), single, palette[element][lane], wanted.to_array());
            let rows = wanted.to_matrix3x4();
            let rows = std::array::from_fn(|i| rows[i / 4][i % 4]);
            close(&format!("{name}: matrices"), single, matrices[element][lane], rows);
        }
    }
}

#[test]
fn every_form_of_locals_gives_the_models_and_palettes_of_plain_motions() {
    for backend in Backend::available() {
        for instances in [0, 1, 2, 5, 8, 17] {
            check::<DualQuat<f32>>(backend, instances);
            check::<DualQuat<f64>>(backend, instances);
            check::<Block<[f32; 4], 8>>(backend, instances);
            check::<Block<[f32; 8], 8>>(backend, instances);
            check::<Block<[f32; 16], 8>>(backend, instances);
            check::<Block<[f64; 2], 8>>(backend, instances);
            check::<Block<[f64; 4], 8>>(backend, instances);
            check::<Block<[f64; 8], 8>>(backend, instances);
        }
    }
}

#[test]
fn what_does_not_fit_is_refused_and_nothing_is_written() {
    let hierarchy = Hierarchy::new(&PARENTS).expect("a hierarchy");
    let job = hierarchy.job::<DualQuat<f32>>();
    let turns = [Quat::<f32>::IDENTITY; JOINTS];
    let offsets = [[0.0_f32; 3]; JOINTS];
    let binds = [DualQuat::<f32>::IDENTITY; JOINTS];
    let seven = DualQuat::from_translation([7.0_f32; 3]);
    let (mut models, mut palette) = ([seven; JOINTS], [seven; JOINTS]);
    let rotations =
        |n: usize, m: usize| Rotations { rotations: &turns[..n], offsets: &offsets[..m] };
    let length = |what, length, expected| Err(ShapeError::Length { what, length, expected });
    let not_whole = Err(ShapeError::NotWhole { what: "rotations", length: 10, joints: JOINTS });

    assert_eq!(job.locals_to_model(rotations(JOINTS, 10), &mut models), length("offsets", 10, 11));
    assert_eq!(job.locals_to_model(rotations(10, JOINTS), &mut models), not_whole);
    let all = rotations(JOINTS, JOINTS);
    assert_eq!(job.locals_to_model(all, &mut models[1..]), length("models", 10, 11));
    assert_eq!(
        job.locals_to_palette(all, &mut models, &binds[1..], &mut palette),
        length("inverse_binds", 10, 11)
    );
    assert_eq!(
        job.locals_to_palette(all, &mut models, &binds, &mut palette[1..]),
        length("palette", 10, 11)
    );
    assert_eq!((models, palette), ([seven; JOINTS], [seven; JOINTS]));
}

/// A palette of joints that are not computed stays as it was.
#[test]
fn a_range_of_joints_writes_its_own_entries_only() {
    let hierarchy = Hierarchy::new(&PARENTS).expect("a hierarchy");
    let locals = [DualQuat::from_translation([1.0_f32, 0.0, 0.0]); JOINTS];
    let binds = [DualQuat::<f32>::IDENTITY; JOINTS];
    let (mut models, mut palette) = (locals, [DualQuat::ZERO; JOINTS]);
    let job = hierarchy.job().joints(1..3);
    job.locals_to_palette(Motions(&locals), &mut models, &binds, &mut palette).expect("they fit");
    assert_eq!(palette[0], DualQuat::ZERO);
    assert_eq!(palette[2].translation(), [3.0, 0.0, 0.0]);
    assert_eq!(palette[3..], [DualQuat::ZERO; JOINTS - 3]);
}
