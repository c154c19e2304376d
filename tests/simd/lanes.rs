//! Every operation of every lane type against plain arithmetic, lane by lane.

use dq8_simd::{Block, Float, Lanes, Level, Mask, PackedDualQuat, Portable, Records, Row};
use dq8_simd::{f32x4, f32x8, f32x16, f64x2, f64x4, f64x8};

/// Numbers that hurt, among ordinary ones.
const NUMBERS: [f64; 16] = [
    1.5,
    -2.25,
    0.0,
    -0.0,
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    1e-45,
    -1e-40,
    3e38,
    1.0,
    -1.0,
    1e-20,
    7.0,
    -1e20,
    0.1,
];

/// A number as bits, so that zeros of both signs differ; NaN has many bit patterns that mean the
/// same.
fn bits(number: f64) -> u64 {
    if number.is_nan() { f64::NAN.to_bits() } else { number.to_bits() }
}

/// Lane `i` from `NUMBERS[(first + i) % 16]`.
fn lanes<L: Lanes>(level: L::Level, first: usize) -> L {
    let numbers: Vec<_> =
        (0..L::LANES).map(|i| L::Real::from_f64(NUMBERS[(first + i) % NUMBERS.len()])).collect();
    L::load_partial(level, &numbers, L::Real::default())
}

fn numbers<L: Lanes>(lanes: L) -> Vec<f64> {
    lanes.to_array().as_ref().iter().map(|&number| number.into()).collect()
}

#[track_caller]
fn same(what: &str, got: &[f64], wanted: &[f64]) {
    let pairs = got.iter().zip(wanted);
    assert!(
        got.len() == wanted.len() && pairs.clone().all(|(a, b)| bits(*a) == bits(*b)),
        "{what}: {got:?} is not {wanted:?}"
    );
}

/// What a number becomes when it is stored in a lane.
fn rounded<L: Lanes>(number: f64) -> f64 {
    L::Real::from_f64(number).into()
}

fn arithmetic<L: Lanes>(level: L::Level) {
    for (first, second) in (0..16).flat_map(|i| (0..16).map(move |j| (i, j))) {
        let (a, b): (L, L) = (lanes(level, first), lanes(level, second));
        // f64 arithmetic, rounded to f32, is f32 arithmetic for one operation (53 ≥ 2·24 + 2).
        let on = |f: fn(f64, f64) -> f64| -> Vec<f64> {
            let pairs = numbers(a).into_iter().zip(numbers(b));
            pairs.map(|(a, b)| rounded::<L>(f(a, b))).collect()
        };
        same("a + b", &numbers(a + b), &on(|a, b| a + b));
        same("a − b", &numbers(a - b), &on(|a, b| a - b));
        same("a · b", &numbers(a * b), &on(|a, b| a * b));
        same("a / b", &numbers(a / b), &on(|a, b| a / b));
        same("−a", &numbers(-a), &on(|a, _| -a));
        same("√a", &numbers(a.sqrt()), &on(|a, _| a.sqrt()));
        same("|a|", &numbers(a.abs()), &on(|a, _| a.abs()));
        // NaN has a sign as well, which nothing promises to keep.
        if numbers(a).iter().chain(&numbers(b)).all(|number| !number.is_nan()) {
            same("copysign", &numbers(a.copysign(b)), &on(f64::copysign));
        }
    }
}

fn fused_or_not<L: Lanes>(level: L::Level) {
    let epsilon = if L::Real::SINGLE { f64::from(f32::EPSILON) } else { f64::EPSILON };
    let three = |value: f64| L::splat(level, L::Real::from_f64(value));
    for (a, b, c) in [(1.5, -2.25, 7.0), (0.1, 0.3, -0.03), (1e20, 1e-20, 1.0), (3.0, 5.0, -15.0)] {
        let (x, y, z) = (three(a), three(b), three(c));
        let (a, b, c) = (rounded::<L>(a), rounded::<L>(b), rounded::<L>(c));
        let allowed = epsilon * ((a * b).abs() + c.abs());
        for got in numbers(x.mul_add(y, z)) {
            assert!((got - (a * b + c)).abs() <= allowed, "{a} · {b} + {c} gives {got}");
        }
        for got in numbers(x.neg_mul_add(y, z)) {
            assert!((got - (c - a * b)).abs() <= allowed, "{c} − {a} · {b} gives {got}");
        }
    }
}

fn comparisons<L: Lanes>(level: L::Level) {
    let all = (1_u64 << L::LANES) - 1;
    for (first, second) in (0..16).flat_map(|i| (0..16).map(move |j| (i, j))) {
        let (a, b): (L, L) = (lanes(level, first), lanes(level, second));
        let on = |f: fn(f64, f64) -> bool| -> u32 {
            let pairs = numbers(a).into_iter().zip(numbers(b)).enumerate();
            pairs.map(|(i, (a, b))| u32::from(f(a, b)) << i).sum()
        };
        let (lt, le, eq) = (on(|a, b| a < b), on(|a, b| a <= b), on(|a, b| a == b));
        assert_eq!((a.lt(b).to_bitmask(), a.le(b).to_bitmask()), (lt, le));
        assert_eq!(a.eq(b).to_bitmask(), eq);
        let (x, y) = (a.lt(b), a.eq(b));
        assert_eq!((x | y).to_bitmask(), lt | eq);
        assert_eq!((a.le(b) & y).to_bitmask(), le & eq);
        assert_eq!(u64::from((!x).to_bitmask()), !u64::from(lt) & all);
        assert_eq!((x.any(), x.all()), (lt != 0, u64::from(lt) == all));
        assert_eq!(<L::Mask as Mask>::LANES as usize, L::LANES);
        let picked = numbers(L::select(x, a, b));
        for (i, picked) in picked.into_iter().enumerate() {
            let wanted = if lt >> i & 1 == 1 { numbers(a)[i] } else { numbers(b)[i] };
            assert_eq!(bits(picked), bits(wanted), "lane {i}");
        }
    }
}

fn memory<L: Lanes>(level: L::Level) {
    let source: Vec<_> =
        (0..2 * L::LANES + 2).map(|i| L::Real::from_f64(10.0 + i as f64)).collect();
    let padding = L::Real::from_f64(-1.0);
    for length in 0..=L::LANES + 2 {
        let loaded = numbers(L::load_partial(level, &source[..length], padding));
        let wanted = |i: usize| if i < length { 10.0 + i as f64 } else { -1.0 };
        same("load_partial", &loaded, &(0..L::LANES).map(wanted).collect::<Vec<_>>());

        let mut target = vec![padding; length];
        L::load_partial(level, &source, padding).store_partial(&mut target);
        for (i, &number) in target.iter().enumerate() {
            let wanted = if i < L::LANES { 10.0 + i as f64 } else { -1.0 };
            assert_eq!(number.into(), wanted, "element {i} of {length}");
        }
    }
    let array = L::load_partial(level, &source, padding).to_array();
    same("load", &numbers(L::load(level, &array)), &numbers(lanes_from::<L>(level, &source)));
    assert_eq!(numbers(L::splat(level, padding)), vec![-1.0; L::LANES]);
    let beside = L::splat(L::splat(level, padding).level(), padding).constant(0.1);
    assert_eq!(numbers(beside), vec![rounded::<L>(0.1); L::LANES]);
}

fn lanes_from<L: Lanes>(level: L::Level, source: &[L::Real]) -> L {
    L::load_partial(level, source, L::Real::default())
}

fn records<L: Lanes, const C: usize>(level: L::Level) {
    let record = |i: usize| std::array::from_fn(|c| L::Real::from_f64((100 * i + c) as f64));
    let source: Vec<[L::Real; C]> = (0..L::LANES + 2).map(record).collect();
    let padding = std::array::from_fn(|c| L::Real::from_f64(-1.0 - c as f64));
    for length in 0..=L::LANES + 2 {
        let columns = L::load_records(level, &source[..length], padding);
        for (c, column) in columns.into_iter().enumerate() {
            let wanted = |i: usize| if i < length { source[i][c] } else { padding[c] }.into();
            same("load_records", &numbers(column), &(0..L::LANES).map(wanted).collect::<Vec<_>>());
        }
        let mut target = vec![padding; length];
        L::store_records(L::load_records(level, &source, padding), &mut target);
        for (i, record) in target.iter().enumerate() {
            let wanted = if i < L::LANES { source[i] } else { padding };
            assert_eq!(*record, wanted, "record {i} of {length}");
        }
    }
}

/// Every `stride`-th record, in memory of any length.
fn strided<L: Lanes, const C: usize>(level: L::Level) {
    let record = |i: usize| std::array::from_fn(|c| L::Real::from_f64((100 * i + c) as f64));
    let padding = std::array::from_fn(|c| L::Real::from_f64(-1.0 - c as f64));
    for stride in [1, 2, 5] {
        for length in 0..=(L::LANES - 1) * stride + 2 {
            let memory: Vec<[L::Real; C]> = (0..length).map(record).collect();
            let columns = L::load_strided(level, &memory, Some(stride), &padding);
            for (c, column) in columns.into_iter().enumerate() {
                let wanted = |i: usize| memory.get(i * stride).unwrap_or(&padding)[c].into();
                let wanted: Vec<f64> = (0..L::LANES).map(wanted).collect();
                same("load_strided", &numbers(column), &wanted);
            }
            let mut target = vec![padding; length];
            L::store_strided(columns, &mut target, Some(stride));
            for (i, (&number, &source)) in target.iter().zip(&memory).enumerate() {
                let written = i % stride == 0 && i / stride < L::LANES;
                assert_eq!(number, if written { source } else { padding }, "{i} of {length}");
            }
        }
    }
}

fn packed<L: PackedDualQuat>(level: L::Level) {
    let numbers_of = |motion: [f64; 8]| {
        let motion = motion.map(L::Real::from_f64);
        L::load_partial(level, &motion, L::Real::default())
    };
    let motion = numbers_of([1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0]);
    let [x, y, z, w] = motion.columns();
    same("columns, x", &numbers(x), &[4.0, 3.0, -2.0, -1.0, 8.0, 7.0, -6.0, -5.0]);
    same("columns, y", &numbers(y), &[-3.0, 4.0, 1.0, -2.0, -7.0, 8.0, 5.0, -6.0]);
    same("columns, z", &numbers(z), &[2.0, -1.0, 4.0, -3.0, 6.0, -5.0, 8.0, -7.0]);
    same("columns, w", &numbers(w), &numbers(motion));
    // Below is −0: a sum with it has the bits of the other number, also of zeros.
    same(
        "times_epsilon",
        &numbers(motion.times_epsilon()),
        &[-0.0, -0.0, -0.0, -0.0, 1.0, 2.0, 3.0, 4.0],
    );
    let eight = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0];
    for (number, each) in eight.iter().zip(L::splat_each(level, &eight.map(L::Real::from_f64))) {
        same("splat_each", &numbers(each), &[*number; 8]);
    }
    // Wherever they lie: these begin one number after each other.
    let row = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0].map(L::Real::from_f64);
    for (first, four) in row.windows(4).enumerate() {
        let four = four.first_chunk().expect("a window of four");
        let half = [1.0, 2.0, 3.0, 4.0].map(|number| number + first as f64);
        same("twice", &numbers(L::load_twice(level, four)), [half, half].as_flattened());
    }
}

/// The order of the additions shows where numbers differ in size.
fn sums<L: Lanes>(level: L::Level) {
    if L::LANES % 4 != 0 {
        return;
    }
    let numbers_of = |vector: usize| {
        let number = |lane: usize| {
            let sizes = [1e7, 1.0, -1e7, 0.25 + vector as f64, 3.0, 3e7, 0.125, -3e7];
            L::Real::from_f64(sizes[(lane + 3 * vector) % 8])
        };
        (0..L::LANES).map(number).collect::<Vec<_>>()
    };
    let vectors = [0, 1, 2, 3].map(numbers_of);
    let wanted: Vec<f64> = (0..L::LANES)
        .map(|lane| {
            let group = &vectors[lane % 4][lane / 4 * 4..][..4];
            ((group[0] + group[2]) + (group[1] + group[3])).into()
        })
        .collect();
    let loaded = vectors.map(|vector| L::load_partial(level, &vector, L::Real::default()));
    same("sums", &numbers(L::sum_quads(loaded)), &wanted);
}

fn check<L: Lanes>(level: L::Level) {
    arithmetic::<L>(level);
    fused_or_not::<L>(level);
    comparisons::<L>(level);
    memory::<L>(level);
    sums::<L>(level);
    records::<L, 2>(level);
    records::<L, 3>(level);
    records::<L, 4>(level);
    records::<L, 7>(level);
    records::<L, 8>(level);
    records::<L, 12>(level);
    strided::<L, 1>(level);
    strided::<L, 3>(level);
    strided::<L, 6>(level);
    strided::<L, 7>(level);
    strided::<L, 8>(level);
    strided::<L, 16>(level);
    strided::<L, 36>(level);
}

fn check_level<V: Level>(level: V) {
    level.run(|| {
        check::<V::F32x4>(level);
        check::<V::F32x8>(level);
        check::<V::F32x16>(level);
        check::<V::F64x2>(level);
        check::<V::F64x4>(level);
        check::<V::F64x8>(level);
        streams::<[f32; 4], V>(level);
        streams::<[f32; 8], V>(level);
        streams::<[f32; 16], V>(level);
        streams::<[f64; 2], V>(level);
        streams::<[f64; 4], V>(level);
        streams::<[f64; 8], V>(level);
        check::<V::Single>(level);
        check::<V::Double>(level);
        packed::<V::F32x8>(level);
        packed::<V::F64x8>(level);
    });
}

#[test]
fn portable_lanes_compute_as_numbers_do() {
    check_level(Portable);
    check::<f32x4>(Portable);
    check::<f32x8>(Portable);
    check::<f32x16>(Portable);
    check::<f64x2>(Portable);
    check::<f64x4>(Portable);
    check::<f64x8>(Portable);
}

#[test]
fn one_lane_computes_as_a_number_does() {
    check::<f32>(Portable);
    check::<f64>(Portable);
}

/// What the operating system says the CPU has; this test must not ask the code that it tests.
#[cfg(all(target_arch = "x86_64", target_os = "linux"))]
fn cpu_has(feature: &str) -> bool {
    let text = std::fs::read_to_string("/proc/cpuinfo").expect("Linux tells what the CPU has");
    let flags = text.lines().find(|line| line.starts_with("flags")).unwrap_or_default();
    flags.split_whitespace().any(|flag| flag == feature)
}

#[cfg(all(target_arch = "x86_64", target_os = "linux"))]
#[test]
fn lanes_found_at_run_time_are_found_where_they_are_and_compute_as_numbers_do() {
    use dq8_simd::x86_64::{Avx2, Avx512};
    let avx2 = Avx2::detect();
    assert_eq!(avx2.is_some(), cpu_has("avx2") && cpu_has("fma"));
    let avx512 = Avx512::detect();
    let features = ["avx512f", "avx512vl", "avx512dq"];
    assert_eq!(avx512.is_some(), features.into_iter().all(cpu_has));
    if let Some(level) = avx2 {
        check_level(level);
    }
    if let Some(level) = avx512 {
        check_level(level);
        let cpus = std::fs::read_to_string("/proc/cpuinfo").unwrap();
        assert_eq!([(); 2].map(|()| level.shuffles_wide()), [cpus.contains("AuthenticAMD"); 2]);
    }
}

/// Until there is nothing more, and nothing beyond.
fn streams<A: Row, V: Level>(level: V) {
    let number = |i: usize| A::Real::from_f64(i as f64);
    let mut blocks = vec![Block::<A, 3>::splat([number(7); 3]); 5];
    let parts = Block::<A, 3>::parts::<V>();
    Block::stream(level, &mut blocks, |index, part| {
        let source = Block::<A, 3>::splat([0, 1, 2].map(|c| number(100 * index + 10 * part + c)));
        (index < 4).then(|| source.load_part(level, part))
    });
    for (index, block) in blocks.iter().enumerate() {
        for lane in 0..A::LANES {
            let part = lane / (A::LANES / parts);
            let wanted = [0, 1, 2].map(|c| number(100 * index + 10 * part + c));
            let wanted = if index < 4 { wanted } else { [number(7); 3] };
            assert_eq!(block.get(lane), Some(wanted), "block {index}, lane {lane}");
        }
    }
}

fn blocks<A: Row>() {
    let real = A::Real::from_f64;
    let record = |i: usize| std::array::from_fn(|c| real((100 * i + c) as f64));
    let mut block = Block::<A, 8>::splat([real(-1.0); 8]);
    assert_eq!(std::mem::size_of_val(&block), 8 * std::mem::size_of::<A>());
    assert_eq!(std::mem::align_of_val(&block), 64);
    for lane in 0..A::LANES {
        assert_eq!(block.get(lane), Some([real(-1.0); 8]));
        assert_eq!(block.set(lane, record(lane)), Ok(()));
    }
    assert_eq!(block.get(A::LANES), None);
    assert_eq!(block.set(A::LANES, record(7)), Err(record(7)));
    for lane in 0..A::LANES {
        assert_eq!(block.get(lane), Some(record(lane)));
    }
    let mut copy = Block::<A, 8>::splat([real(0.0); 8]);
    copy.store::<Portable>(block.load(Portable));
    // Row c holds component c of all lanes.
    let numbers: &[A::Real] = bytemuck::cast_slice(std::slice::from_ref(&copy));
    for (i, number) in numbers.iter().enumerate() {
        assert_eq!(*number, record(i % A::LANES)[i / A::LANES]);
    }
}

#[test]
fn a_block_holds_what_was_set_in_rows_of_one_component() {
    blocks::<[f32; 4]>();
    blocks::<[f32; 8]>();
    blocks::<[f32; 16]>();
    blocks::<[f64; 2]>();
    blocks::<[f64; 4]>();
    blocks::<[f64; 8]>();
    assert_eq!(std::mem::size_of::<Block<[f32; 8], 8>>(), 256);
}

/// Sums of such places wrap in a release build, and bounds that are checked with them hold for
/// anything.
#[test]
fn components_beyond_every_record_are_refused_and_not_read() {
    let table = [[1.0_f32; 8]; 4];
    for first in [5, 8, usize::MAX - 3, usize::MAX] {
        assert!(f32x4::load_four(Portable, &table, first).is_none(), "{first}");
    }
    assert!(f32x4::load_four(Portable, &table, 4).is_some());
    assert!(f32x4::load_four(Portable, &[[1.0_f32; 3]; 4], 0).is_none());
}
