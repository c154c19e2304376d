//! Random calls of the C functions: arrays of just the length that is said, on the heap, so that the address
//! sanitizer sees a number read or written beyond; null, misaligned and overlapping pointers; lengths that do
//! not fit. Nothing is written where the answer is an error.
//!
//! ```text
//! RUSTC_BOOTSTRAP=1 RUSTFLAGS=-Zsanitizer=address DQ8_FUZZ_SECONDS=60 cargo test --release -p dq8-capi \
//!   --test fuzz --target x86_64-unknown-linux-gnu
//! ```

use dq8::simd::Block;
use dq8_capi::Status;
use dq8_capi::hierarchy::{self, single as h};
use dq8_capi::joint::Joint;
use dq8_capi::links::single as k;
use dq8_capi::mechanism::{Mechanism, Step, single as c};
use dq8_capi::motion::single as m;
use dq8_capi::packing::single as p;
use dq8_capi::screw::single as s;
use dq8_capi::slices::single as l;
use std::mem::MaybeUninit;
use std::time::{Duration, Instant};

/// SplitMix64 (Steele, Lea and Flood 2014).
struct Fuzz(u64);

impl Fuzz {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        bits ^ (bits >> 31)
    }
    fn below(&mut self, end: usize) -> usize {
        (self.bits() % end as u64) as usize
    }
    fn number(&mut self) -> f32 {
        match self.below(8) {
            0 => f32::from_bits(self.bits() as u32),
            1 => [0.0, f32::NAN, f32::INFINITY, f32::MAX][self.below(4)],
            _ => (self.bits() >> 40) as f32 / (1 << 22) as f32 - 2.0,
        }
    }
    /// Just so many numbers: nothing behind them is ours.
    fn numbers(&mut self, count: usize) -> Box<[f32]> {
        (0..count).map(|_| self.number()).collect()
    }
    /// So many blocks of eight lanes and sixteen.
    fn blocks<const N: usize, const C: usize>(
        &mut self,
        count: usize,
    ) -> Box<[Block<[f32; N], C>]> {
        (0..count).map(|_| Block([(); C].map(|()| [(); N].map(|()| self.number())))).collect()
    }
    /// A pointer that may be wrong, and whether it is.
    fn pointer(&mut self, good: *mut f32, wrong: &mut bool) -> *mut f32 {
        match self.below(40) {
            0 => {
                *wrong = true;
                std::ptr::null_mut()
            }
            1 => {
                *wrong = true;
                good.wrapping_byte_add(2)
            }
            _ => good,
        }
    }
}

/// One call, by pointers to its arrays, the output last.
type Call = fn([*mut f32; 4], f32, usize) -> Status;

/// What a function over `count` things reads and writes: numbers a thing, 0 for none; the output last.
struct Function {
    name: &'static str,
    inputs: [usize; 3],
    /// Whether the first input is one thing for all.
    one: bool,
    output: usize,
    call: Call,
}

macro_rules! functions {
    ($($name:ident [$($input:literal)*] one $one:literal -> $output:literal
        |$p:ident, $t:ident, $n:ident| ($($argument:expr),*);)*) => {
        vec![$(Function {
            name: stringify!($name),
            inputs: [$($input),*],
            one: $one,
            output: $output,
            call: |$p, $t, $n| {
                let _ = $t;
                // SAFETY: arrays are as long as the table says, or pointers wrong in ways that are seen.
                unsafe { l::$name($($argument),*) }
            },
        }),*]
    };
}

fn functions() -> Vec<Function> {
    functions! {
        mul [8 8 0] one false -> 8 |p, t, n| (p[0], p[1], p[3], n);
        normalize [8 0 0] one false -> 8 |p, t, n| (p[0], p[3], n);
        inverse [8 0 0] one false -> 8 |p, t, n| (p[0], p[3], n);
        nlerp [8 8 0] one false -> 8 |p, t, n| (p[0], p[1], t, p[3], n);
        sclerp [8 8 0] one false -> 8 |p, t, n| (p[0], p[1], t, p[3], n);
        sclerp_each [8 8 1] one false -> 8 |p, t, n| (p[0], p[1], p[2], p[3], n);
        points [8 3 0] one true -> 3 |p, t, n| (p[0], p[1], p[3], n);
        vectors [8 3 0] one true -> 3 |p, t, n| (p[0], p[1], p[3], n);
        points_each [8 3 0] one false -> 3 |p, t, n| (p[0], p[1], p[3], n);
        matrices_3x4 [8 0 0] one false -> 12 |p, t, n| (p[0], 0, p[3], n);
        matrices_4x4 [8 0 0] one false -> 16 |p, t, n| (p[0], 1, p[3], n);
    }
}

/// Functions over plain arrays.
fn arrays(fuzz: &mut Fuzz, functions: &[Function]) {
    let function = &functions[fuzz.below(functions.len())];
    let count = 1 + fuzz.below(40);
    let mut arrays: Vec<_> = function
        .inputs
        .iter()
        .enumerate()
        .map(|(i, &numbers)| {
            fuzz.numbers(if function.one && i == 0 { numbers } else { numbers * count })
        })
        .collect();
    let mut output = fuzz.numbers(function.output * count);
    let before: Vec<u32> = output.iter().map(|c| c.to_bits()).collect();
    let mut wrong = false;
    let mut pointers = [std::ptr::null_mut(); 4];
    for (slot, (array, numbers)) in pointers.iter_mut().zip(arrays.iter_mut().zip(function.inputs))
    {
        if numbers > 0 {
            *slot = fuzz.pointer(array.as_mut_ptr(), &mut wrong);
        }
    }
    pointers[3] = fuzz.pointer(output.as_mut_ptr(), &mut wrong);
    // More than any memory holds.
    let huge = fuzz.below(50) == 0;
    let status =
        (function.call)(pointers, fuzz.number(), if huge { usize::MAX / 5 } else { count });
    assert_eq!(status == Status::Ok, !wrong && !huge, "{}: {status:?}", function.name);
    assert!(
        status == Status::Ok || output.iter().map(|c| c.to_bits()).eq(before),
        "{}",
        function.name
    );
}

/// Functions on one motion; the output may lie on the input.
fn motions(fuzz: &mut Fuzz) {
    let (a, b, t) = (fuzz.numbers(8), fuzz.numbers(8), fuzz.number());
    let (three, matrix) = (fuzz.numbers(3), fuzz.numbers(16));
    let (a, b, three, matrix) = (a.as_ptr(), b.as_ptr(), three.as_ptr(), matrix.as_ptr());
    let mut out = [8, 3, 12, 16, 8, 4].map(|count| fuzz.numbers(count));
    let [o8, o3, o12, o16, screw, o4] = out.each_mut().map(|out| out.as_mut_ptr());
    // SAFETY: every array has the length that its function says, and outputs lie apart.
    unsafe {
        for status in [
            m::mul(a, b, o8),
            m::mul(o8, o8, o8),
            m::conjugate(a, o8),
            m::point(a, three, o3),
            m::vector(a, three, o3),
            m::to_matrix_3x4(a, o12),
            m::to_matrix_4x4(a, o16),
            m::to_rotation_translation(a, o4, o3),
        ] {
            assert_eq!(status, Status::Ok);
        }
        // These refuse what has no answer.
        let _ = s::nlerp(a, b, t, o8);
        let _ = s::sclerp(a, b, t, o8);
        let _ = s::pow(a, t, o8);
        let _ = s::to_screw(a, screw);
        let _ = s::from_screw(screw, o8);
        let _ = m::inverse(a, o8);
        let _ = m::normalize(a, o8);
        let _ = m::check_unit(a, t);
        let _ = m::from_matrix_4x4(matrix, t, o8);
        let _ = m::from_matrix_3x4(matrix, t, o8);
        assert_eq!(m::mul(a, std::ptr::null(), o8), Status::NullPointer);
    }
}

/// Hierarchies whose parents may be wrong, over plain arrays and blocks, and packing between the two.
fn hierarchies(fuzz: &mut Fuzz) {
    let joints = 1 + fuzz.below(12);
    let instances = 1 + fuzz.below(20);
    let parents: Box<[i32]> = (0..joints)
        .map(|joint| {
            if fuzz.below(60) == 0 { fuzz.bits() as i32 } else { fuzz.below(joint + 1) as i32 - 1 }
        })
        .collect();
    let count = joints * instances;
    let (locals, root, seven) = (fuzz.numbers(8 * count), fuzz.numbers(8), fuzz.numbers(7 * count));
    let (rotations, offsets, binds) =
        (fuzz.numbers(4 * count), fuzz.numbers(3 * joints), fuzz.numbers(8 * joints));
    let mut models = fuzz.numbers(8 * count);
    let mut palette = fuzz.numbers(12 * count);
    let (out, palette) = (models.as_mut_ptr(), palette.as_mut_ptr());
    let root = if fuzz.below(2) == 0 { std::ptr::null() } else { root.as_ptr() };
    let (of, locals) = (parents.as_ptr(), locals.as_ptr());
    let blocks = instances.div_ceil(8) * joints;
    let mut packed = fuzz.blocks::<8, 8>(blocks);
    let mut wide = fuzz.blocks::<16, 8>(instances.div_ceil(16) * joints);
    let (packed, wide) = (packed.as_mut_ptr().cast(), wide.as_mut_ptr().cast());
    let lanes = fuzz.bits() as usize;
    // SAFETY: every array has the length that its function says.
    unsafe {
        let mut bad = 0;
        let good = hierarchy::dq8_check_parents(of, joints, &mut bad);
        for status in [
            h::local_to_model(of, joints, root, locals, out, count),
            h::local_to_model(of, joints, root, out, out, count),
            h::model_to_local(of, joints, root, locals, out, count),
            h::rotations_to_model(
                of,
                joints,
                root,
                rotations.as_ptr(),
                offsets.as_ptr(),
                out,
                count,
            ),
            h::rotations_translations_to_model(of, joints, root, seven.as_ptr(), out, count),
            h::palette(of, joints, root, locals, binds.as_ptr(), out, palette, count),
            h::palette_matrices(of, joints, root, locals, binds.as_ptr(), out, palette, count),
            h::blocks_local_to_model(8, of, joints, root, packed, packed, blocks),
        ] {
            assert_eq!(status, good, "{parents:?}");
        }
        let pack = |lanes, blocks, count| {
            p::pack(lanes, joints, locals, count, blocks, blocks_of(lanes, instances) * joints)
        };
        assert_eq!(pack(8, packed, count), Status::Ok);
        assert_eq!(pack(16, wide, count), Status::Ok);
        assert!(joints == 1 || pack(8, packed, count - 1) != Status::Ok);
        assert!(
            [4, 8, 16].contains(&lanes)
                || p::pack(lanes, joints, locals, count, packed, blocks) != Status::Ok
        );
        let whole = instances.div_ceil(16) * joints;
        assert_eq!(p::unpack(16, joints, wide, whole, out, count), Status::Ok);
        let same = models.iter().zip(std::slice::from_raw_parts(locals, 8 * count));
        assert!(same.into_iter().all(|(a, b)| a.to_bits() == b.to_bits()));
    }
}

/// Mechanisms of joints any of which may be wrong, with values that may be anything.
fn mechanisms(fuzz: &mut Fuzz) {
    let count = fuzz.below(12);
    let joints: Box<[Joint<f32>]> = (0..count)
        .map(|index| {
            let mut placement = [0.0, 0.0, 0.0, 1.0, fuzz.number(), fuzz.number(), 0.5, 0.0];
            let mut axis = [0.0; 3];
            axis[fuzz.below(3)] = 1.0;
            let wrong = fuzz.below(100);
            if wrong == 0 {
                placement[fuzz.below(8)] = fuzz.number();
            }
            if wrong == 1 {
                axis[fuzz.below(3)] = fuzz.number();
            }
            let parent = fuzz.below(index + 1) as i32 - 1;
            Joint {
                parent: if wrong == 2 { fuzz.bits() as i32 } else { parent },
                kind: if wrong == 3 { fuzz.bits() as i32 } else { fuzz.below(6) as i32 },
                placement,
                axis,
                pitch: 0.1,
                mimics: i32::from(fuzz.below(20) == 0),
                leader: fuzz.below(count) as i32 - i32::from(wrong == 4),
                multiplier: 2.0,
                offset: 0.1,
                limited: 0,
                limits: [0.0; 2],
            }
        })
        .collect();
    let mut steps = Box::<[Step<f32>]>::new_uninit_slice(count);
    let mut made = MaybeUninit::<Mechanism<f32>>::zeroed();
    let (room, of, mut bad) = (steps.as_mut_ptr().cast(), made.as_mut_ptr(), usize::MAX);
    // SAFETY: every array has the length that its function says.
    unsafe {
        let status = c::make(joints.as_ptr(), count, room, of, &mut bad);
        if status != Status::Ok {
            assert!(bad < count, "{status:?}");
            assert_eq!(made.assume_init_ref().links, 0);
            return;
        }
        let (values, rates) = (made.assume_init_ref().values, made.assume_init_ref().rates);
        let numbers = fuzz.numbers(values);
        let (mut poses, mut one) = (fuzz.numbers(8 * count), fuzz.numbers(8));
        let mut columns = fuzz.numbers(6 * rates);
        let (n, to, pose) = (numbers.as_ptr(), poses.as_mut_ptr(), one.as_mut_ptr());
        assert_eq!(c::link_poses(of, n, values, to, count), Status::Ok);
        assert!(count == 0 || c::link_poses(of, n, values, to, count - 1) == Status::Length);
        let (link, frame, columns) = (fuzz.below(14), fuzz.below(4) as i32, columns.as_mut_ptr());
        let there = if link < count { Status::Ok } else { Status::NoLink };
        assert_eq!(c::link_pose(of, n, values, link, pose), there);
        let wanted = if link < count && frame == 3 { Status::UnknownValue } else { there };
        let status = c::link_jacobian(of, frame, n, values, link, columns, rates, pose);
        assert_eq!(status, wanted);
        let configurations = fuzz.below(20);
        if values > 0 {
            let many = fuzz.numbers(configurations * values);
            let mut poses = fuzz.numbers(8 * count * configurations);
            let (from, to, all) = (many.as_ptr(), poses.as_mut_ptr(), count * configurations);
            assert_eq!(k::link_poses(of, from, many.len(), to, all), Status::Ok);
            let mut blocks = fuzz.blocks::<8, 8>(blocks_of(8, configurations) * count);
            let (to, all) = (blocks.as_mut_ptr().cast(), blocks.len());
            assert_eq!(k::blocks_link_poses(8, of, from, many.len(), to, all), Status::Ok);
        }
    }
}

fn blocks_of(lanes: usize, instances: usize) -> usize {
    instances.div_ceil(lanes)
}

#[test]
fn the_c_functions_stay_within_their_arrays() {
    let number = |name: &str| std::env::var(name).ok().and_then(|text| text.parse::<u64>().ok());
    let seconds = Duration::from_secs(number("DQ8_FUZZ_SECONDS").unwrap_or(1));
    let (start, functions) = (Instant::now(), functions());
    let mut fuzz = Fuzz(number("DQ8_FUZZ_SEED").unwrap_or(1));
    let mut calls = 0_u64;
    while start.elapsed() < seconds {
        for _ in 0..100 {
            for _ in 0..10 {
                arrays(&mut fuzz, &functions);
                motions(&mut fuzz);
            }
            hierarchies(&mut fuzz);
            mechanisms(&mut fuzz);
            calls += 10 * (1 + 19) + 14 + 7;
        }
    }
    println!("{calls} calls in {} s", start.elapsed().as_secs());
}
