//! The native library's answers to what `tests/package.test.mjs` asks of the module: floats from
//! standard input, in the order in which they are read below, to floats on standard output. On the
//! instructions of the build target, which round as simd128 does.

use bytemuck::{Pod, cast_slice};
use dq8::hierarchy::{Clip, Layered, Locals, MatrixOrder, PackedClip, Poses, Sampled, Tolerance};
use dq8::law::NlerpLerp;
use dq8::skinning::{DualBlend, Linear, Mixed, Skin, Surface, SurfaceMut};
use dq8::{Backend, Crowd, DualQuat, Quat, Skeleton};
use dq8_robot::World;
use dq8_robot::ik::{Goal, Options, OwnedReach};
use std::error::Error;
use std::io::{Read, Write};

type Motion = DualQuat<f32>;
type Columns = [[f32; 4]; 4];

const JOINTS: usize = 23;
const INSTANCES: usize = 21;
const FRAMES: usize = 5;
const VERTICES: usize = 333;
const CONFIGURATIONS: usize = 9;

struct Given(std::vec::IntoIter<f32>);

impl Given {
    fn numbers(&mut self, count: usize) -> Vec<f32> {
        self.0.by_ref().take(count).collect()
    }
    fn records<const C: usize>(&mut self, count: usize) -> Vec<[f32; C]> {
        self.numbers(C * count).chunks_exact(C).map(|of| std::array::from_fn(|i| of[i])).collect()
    }
    fn motions(&mut self, count: usize) -> Vec<Motion> {
        let of = |[x, y, z, w, a, b, c]: [f32; 7]| {
            let rotation = Quat::from_xyzw(x, y, z, w).normalize();
            Motion::from_rotation_translation(rotation, [a, b, c])
        };
        self.records(count).into_iter().map(of).collect()
    }
}

fn write<T: Pod>(answers: &[T]) -> Result<(), Box<dyn Error>> {
    let numbers: &[f32] = cast_slice(answers);
    let bytes: Vec<u8> = numbers.iter().flat_map(|number| number.to_le_bytes()).collect();
    Ok(std::io::stdout().write_all(&bytes)?)
}

fn main() -> Result<(), Box<dyn Error>> {
    Backend::limit(Some(Backend::PORTABLE));
    let mut bytes = Vec::new();
    std::io::stdin().read_to_end(&mut bytes)?;
    let numbers =
        bytes.chunks_exact(4).map(|of| f32::from_le_bytes(std::array::from_fn(|i| of[i])));
    let mut given = Given(numbers.collect::<Vec<_>>().into_iter());
    skeletons(&mut given)?;
    if let Some(file) = std::env::args().nth(1) {
        robot(&mut given, &file)?;
    }
    Ok(())
}

/// A skeleton and what it stands on: writes models and palettes of any locals.
struct Posed<'a> {
    skeleton: &'a Skeleton,
    roots: &'a [Motion],
    binds: &'a [Motion],
}

impl Posed<'_> {
    fn models(&self, locals: impl Locals<Motion>, instances: usize) -> Result<(), Box<dyn Error>> {
        let mut models = vec![Motion::IDENTITY; instances * JOINTS];
        self.skeleton.job().locals_to_model(locals, &mut models)?;
        write(&models)
    }
    fn palette(&self, locals: impl Locals<Motion>, instances: usize) -> Result<(), Box<dyn Error>> {
        let mut scratch = vec![Motion::IDENTITY; 16 * JOINTS];
        let mut palette = vec![Columns::default(); instances * JOINTS];
        let job = self.skeleton.job().matrix_order(MatrixOrder::Columns);
        if self.roots.is_empty() {
            job.palette(locals, &mut scratch, self.binds, &mut palette)?;
        } else {
            job.roots(self.roots).palette(locals, &mut scratch, self.binds, &mut palette)?;
        }
        write(&palette)
    }
}

fn skeletons(given: &mut Given) -> Result<(), Box<dyn Error>> {
    let parents: Vec<i32> = (0..JOINTS as i32).map(|joint| (joint + 1) / 2 - 1).collect();
    let skeleton = Skeleton::new(&parents)?;
    let poses = INSTANCES * JOINTS;
    let (locals, roots, binds) =
        (given.motions(poses), given.motions(INSTANCES), given.motions(JOINTS));
    let posed = Posed { skeleton: &skeleton, roots: &roots, binds: &binds };
    let (a, b) = (given.records::<7>(FRAMES * JOINTS), given.records::<7>(FRAMES * JOINTS));
    let [at_a, at_b, weights] = std::array::from_fn(|_| given.numbers(INSTANCES));
    let (mask, numbers) = (given.numbers(JOINTS), given.numbers(INSTANCES));

    write(&locals)?;
    let mut models = locals.clone();
    skeleton.local_to_model(&locals, &mut models)?;
    write(&models)?;
    let plain = models.clone();
    skeleton.job().roots(&roots).local_to_model(&locals, &mut models)?;
    write(&models)?;
    posed.palette(Poses(&locals), INSTANCES)?;

    let (a, b) = (Clip::new(JOINTS, &a)?, Clip::new(JOINTS, &b)?);
    // Steps of more than 60°, which packing divides.
    let turning = PackedClip::library(
        &[a.with_rate(30.0), b.looping()],
        Tolerance { angle: 1e-3, length: 0.5 },
    )?;
    let (frames_a, t_a): (Vec<_>, Vec<_>) = at_a.iter().map(|&at| a.place(at)).unzip();
    let (frames_b, t_b): (Vec<_>, Vec<_>) = at_b.iter().map(|&at| b.place(at)).unzip();
    let a = Sampled::new(NlerpLerp, a, &frames_a, &t_a)?;
    let b = Sampled::new(NlerpLerp, b, &frames_b, &t_b)?;
    posed.models(a, INSTANCES)?;
    posed.palette(Layered::blend(NlerpLerp, a, b, &weights), INSTANCES)?;
    posed.palette(Layered::blend(NlerpLerp, a, b, &weights).mask(&mask), INSTANCES)?;
    posed.models(Layered::add(NlerpLerp, a, b, &weights), INSTANCES)?;

    let library = library()?;
    for packed in [&library, &turning] {
        let mut bytes = packed.as_bytes().to_vec();
        write(&[bytes.len() as f32])?;
        bytes.resize(bytes.len().next_multiple_of(4), 0);
        std::io::stdout().write_all(&bytes)?;
    }
    let clips = library.clips();
    let place = |clip, at| clips.place(clip, at).ok_or("there is no such clip");
    let at = numbers.iter().zip(&at_a).map(|(&clip, &at)| place(clip as usize, at));
    let (places, t): (Vec<_>, Vec<_>) = at.collect::<Result<Vec<_>, _>>()?.into_iter().unzip();
    let packed = Sampled::new(NlerpLerp, clips, &places, &t)?;
    let at = at_b.iter().map(|&at| place(1, at));
    let (places, t): (Vec<_>, Vec<_>) = at.collect::<Result<Vec<_>, _>>()?.into_iter().unzip();
    let second = Sampled::new(NlerpLerp, clips, &places, &t)?;
    posed.models(packed, INSTANCES)?;
    posed.palette(Layered::blend(NlerpLerp, packed, second, &weights), INSTANCES)?;
    let loose = Posed { roots: &[], ..posed };
    loose.palette(Layered::add(NlerpLerp, a, packed, &weights).mask(&mask), INSTANCES)?;
    let (places, t) = place(1, 1.25)?;
    let (places, t) = ([places], [t]);
    let one = Sampled::new(NlerpLerp, clips, &places, &t)?;
    loose.models(one, 1)?;
    loose.palette(one, 1)?;

    let mut crowd = Crowd::<f32, 4>::from_slice(JOINTS, &locals)?;
    skeleton.job().local_to_model_in_place(crowd.blocks_mut())?;
    write(&crowd.to_vec())?;

    let backend = Backend::best();
    backend.mul(&locals, &plain, &mut models)?;
    write(&models)?;
    let t: Vec<[f32; 1]> = given.records(poses);
    backend.sclerp_each(&locals, &plain, &t, &mut models)?;
    write(&models)?;
    let points = given.records::<3>(poses);
    let mut moved = points.clone();
    backend.transform_points_each(&plain, &points, &mut moved)?;
    write(&moved)?;
    let mut palette = vec![Columns::default(); poses];
    backend.matrices(&plain, MatrixOrder::Columns, &mut palette)?;
    write(&palette)?;
    skin(given, &plain[..JOINTS])
}

/// Two clips: every third joint keeps still, and others do in one clip; some translate.
fn library() -> Result<PackedClip, Box<dyn Error>> {
    let key = |clip: usize, frame: usize, joint: usize| -> [f32; 7] {
        let still = joint % 3 == 1 || joint % 5 == clip;
        let time = if still { 0.0 } else { frame as f32 * 0.3 + clip as f32 };
        let turn = Quat::from_rotation_x(0.1 * joint as f32) * Quat::from_rotation_z(time.sin());
        let shift = if joint.is_multiple_of(4) { 0.1 * time.cos() } else { 0.0 };
        let ([x, y, z, w], offset) = (turn.to_array(), 0.02 * joint as f32);
        [x, y, z, w, offset + shift, 0.3, shift]
    };
    let frames = [0, 1].map(|clip| -> Vec<_> {
        (0..FRAMES * JOINTS).map(|at| key(clip, at / JOINTS, at % JOINTS)).collect()
    });
    let [a, b] = &frames;
    let clips =
        [Clip::new(JOINTS, a)?.with_rate(2.0), Clip::new(JOINTS, b)?.with_rate(0.5).looping()];
    Ok(PackedClip::library(&clips, Tolerance::default())?)
}

fn skin(given: &mut Given, motions: &[Motion]) -> Result<(), Box<dyn Error>> {
    let (rest, normals) = (given.records::<3>(VERTICES), given.records::<3>(VERTICES));
    let joints: Vec<u16> =
        given.numbers(4 * VERTICES).into_iter().map(|joint| joint as u16).collect();
    let (weights, shares) = (given.numbers(4 * VERTICES), given.numbers(VERTICES));
    let skin = Skin::new(JOINTS, 4, &joints, &weights)?;
    let mut matrices = vec![[[0.0_f32; 4]; 3]; JOINTS];
    Backend::best().matrices(motions, MatrixOrder::Rows, &mut matrices)?;
    let (dual, linear) = (DualBlend::new(motions), Linear::new(&matrices));
    let (mut posed, mut posed_normals) = (rest.clone(), normals.clone());
    let from = || Surface::positions(&rest).normals(&normals);
    for blend in 0..3 {
        let to = SurfaceMut::positions(&mut posed).normals(&mut posed_normals);
        match blend {
            0 => skin.pose(dual, from(), to)?,
            1 => skin.pose(linear, from(), to)?,
            _ => skin.pose(Mixed::new(linear, dual, &shares)?, from(), to)?,
        }
        write(&posed)?;
        write(&posed_normals)?;
    }
    Ok(())
}

fn robot(given: &mut Given, file: &str) -> Result<(), Box<dyn Error>> {
    let robot = dq8_robot::urdf::Robot::from_file(file)?;
    let mechanism = robot.cast::<f32>()?;
    let (count, links, rates) =
        (mechanism.view().values(), mechanism.view().links(), mechanism.view().rates());
    let mut values = given.numbers(CONFIGURATIONS * count);
    let mut poses = vec![Motion::IDENTITY; CONFIGURATIONS * links];
    mechanism.job().poses(&values, &mut poses)?;
    write(&poses)?;
    let mut ends = vec![Motion::IDENTITY; CONFIGURATIONS];
    let mut columns = vec![[0.0_f32; 6]; CONFIGURATIONS * rates];
    mechanism.job().links(&[links - 1]).jacobians(World, &values, &mut ends, &mut columns)?;
    write(&columns)?;
    let reach = OwnedReach::new(mechanism, [Goal::pose(links - 1)])?;
    let mut scratch = vec![0.0; reach.view().scratch_len()];
    // From the first configuration to where the second one has its last link.
    reach.view().solve(&ends[1..2], &mut values[..count], &mut scratch, &Options::default())?;
    write(&values[..count])
}
