//! Random calls of what reads and writes memory without a check of its own, by safe code, with
//! lengths, strides, pitches and indices that fit, nearly fit, and wrap. All memory is of exactly
//! its length, so that the address sanitizer sees a number too far; what was read and written is
//! what indexing finds. `DQ8_FUZZ_SECONDS` says how long (a fifth of one by default),
//! `DQ8_FUZZ_SEED` from where; a failure names the seed of its round.

use dq8_simd::internal::{CheckedIndices, Index, Picks, RECORDS_PER_LANE};
use dq8_simd::internal::{CheckedSchedule, Gather};
use dq8_simd::{Float, Lanes, Level, Portable, Records};
use std::time::{Duration, Instant};

/// SplitMix64 (Steele, Lea and Flood 2014).
struct Fuzz {
    state: u64,
    calls: u64,
}

impl Fuzz {
    fn bits(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = self.state;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        bits ^ (bits >> 31)
    }
    fn below(&mut self, end: usize) -> usize {
        (self.bits() % end.max(1) as u64) as usize
    }
    /// About `size`, and now and then what wraps when it is multiplied or added to.
    fn hostile(&mut self, size: usize) -> usize {
        match self.below(10) {
            0 => usize::MAX - self.below(3),
            1 => (usize::MAX >> self.below(8)).wrapping_add(1).wrapping_sub(self.below(3)),
            2 => size + self.below(3),
            3 => size.saturating_sub(self.below(3)),
            _ => self.below(size + 1),
        }
    }
    /// Records of numbers that tell where they are.
    fn table<R: Float, const C: usize>(&mut self, count: usize) -> Box<[[R; C]]> {
        let number = |i: usize, c| R::from_f64((C * i + c) as f64);
        (0..count).map(|i| std::array::from_fn(|c| number(i, c))).collect()
    }
    fn index<J: Index + TryFrom<u32>>(&mut self, bound: usize) -> J {
        let index = if self.below(40) == 0 { self.bits() as usize } else { self.below(bound) };
        J::try_from((index & 0xff) as u32).unwrap_or_default()
    }
}

fn numbers<L: Lanes>(lanes: L) -> Vec<L::Real> {
    lanes.to_array().as_ref().to_vec()
}

/// Component `c` of lane `i` is number `c` of record `i`.
#[track_caller]
fn same<L: Lanes, const C: usize>(got: [L; C], wanted: impl Fn(usize) -> [L::Real; C]) {
    for (c, component) in got.into_iter().enumerate() {
        let wanted: Vec<_> = (0..L::LANES).map(|lane| wanted(lane)[c]).collect();
        assert_eq!(numbers(component), wanted, "component {c} of {C}");
    }
}

fn records<L: Lanes, const C: usize>(fuzz: &mut Fuzz, level: L::Level) {
    let count = fuzz.below(3 * L::LANES + 4);
    let from = fuzz.table::<L::Real, C>(count);
    let padding = [L::Real::from_f64(-1.0); C];
    let stride = if fuzz.below(3) == 0 { None } else { Some(fuzz.hostile(4)) };
    let step = stride.unwrap_or(1);
    let record = |lane: usize| lane.checked_mul(step).and_then(|at| from.get(at)).copied();
    let loaded = L::load_strided(level, &from, stride, &padding);
    // Nobody says what every zeroth record is; it is read where there are records.
    if step != 0 {
        same(loaded, |lane| record(lane).unwrap_or(padding));
    }
    let length = fuzz.below(3 * L::LANES + 4);
    let mut to: Box<[[L::Real; C]]> = vec![padding; length].into();
    L::store_strided(loaded, &mut to, stride);
    for (i, got) in to.iter().enumerate().filter(|_| step != 0) {
        let is_written = i.is_multiple_of(step) && i / step < L::LANES;
        let wanted = if is_written { record(i / step).unwrap_or(padding) } else { padding };
        assert_eq!(*got, wanted, "record {i} of {length}, stride {stride:?}");
    }
    let first = fuzz.hostile(C);
    let four = L::load_four(level, &from, first);
    let fits = from.len() >= L::LANES && first <= C && C - first >= 4;
    assert_eq!(four.is_some(), fits, "{count} records of {C}, four from {first}");
    if let Some(four) = four {
        same(four, |lane| std::array::from_fn(|c| from[lane][first + c]));
    }
    fuzz.calls += 3;
}

fn rows<L: Lanes>(fuzz: &mut Fuzz, level: L::Level) {
    let count = fuzz.below(9 * L::LANES);
    let from: Box<[[L::Real; 1]]> = fuzz.table(count);
    let (from, apart) = (from.as_flattened(), fuzz.hostile(9));
    let reach = apart.checked_mul(L::LANES - 1).and_then(|last| last.checked_add(4));
    let got = L::load_rows(level, from, apart);
    assert_eq!(got.is_some(), reach.is_some_and(|reach| reach <= count), "{count}, {apart} apart");
    if let Some(got) = got {
        same(got, |lane| std::array::from_fn(|c| from[lane * apart + c]));
        let padding = L::Real::from_f64(-1.0);
        let mut to: Box<[_]> = vec![padding; fuzz.below(10 * L::LANES)].into();
        let does_fit = apart * (L::LANES - 1) + 8 <= to.len();
        assert_eq!(L::store_rows([got, got], &mut to, apart), does_fit);
        // Where rows overlap, nobody says which of them stays.
        for (at, &number) in to.iter().enumerate().filter(|_| apart >= 8 || !does_fit) {
            let (lane, column) = (at / apart.max(1), at % apart.max(1));
            let is_written = does_fit && lane < L::LANES && column < 8;
            assert_eq!(number, if is_written { from[lane * apart + column % 4] } else { padding });
        }
    }
    fuzz.calls += 2;
}

fn gathers<L: Lanes, const C: usize>(fuzz: &mut Fuzz, level: L::Level) {
    let (rows, pitch) = (1 + fuzz.below(6), fuzz.hostile(3));
    let from: Box<[[L::Real; C]]> = {
        let count = rows * pitch.min(4) + fuzz.below(2);
        fuzz.table(count)
    };
    let frame = |fuzz: &mut Fuzz| match fuzz.below(60) {
        0 => fuzz.bits() as u32,
        1 => rows as u32,
        _ => fuzz.below(rows) as u32,
    };
    let frames: Box<[u32]> = (0..fuzz.below(2 * L::LANES + 2)).map(|_| frame(fuzz)).collect();
    let all = Gather::new(&frames, pitch);
    let (begin, end) = (fuzz.hostile(frames.len()), fuzz.hostile(frames.len()));
    let gather = if fuzz.below(2) == 0 { all } else { all.part(begin..end) };
    let (first, column) = (fuzz.hostile(gather.frames().len()), fuzz.hostile(pitch.min(4)));
    let got =
        gather.rows::<L, C>(first).and_then(|rows| L::load_gathered(level, &from, &rows, column));
    let place = |frame: u32| (frame as usize).checked_mul(pitch)?.checked_add(column);
    let is_there = |&frame: &u32| place(frame).is_some_and(|at| at < from.len());
    // A part is held to the greatest frame of all.
    let fits = !gather.frames().is_empty() && frames.iter().all(is_there);
    assert_eq!(got.is_some(), fits, "{frames:?}, pitch {pitch}, column {column}, {}", from.len());
    if let (Some(got), Some(last)) = (got, gather.frames().last()) {
        let frame = |lane| first.checked_add(lane).and_then(|at| gather.frames().get(at));
        same(got, |lane| from[place(*frame(lane).unwrap_or(last)).unwrap()]);
    }
    fuzz.calls += 1;
}

fn picks<L: Lanes, J: Index + TryFrom<u32>, const C: usize>(fuzz: &mut Fuzz, level: L::Level) {
    let bound = fuzz.below(9);
    let columns = [4, 4, 4, fuzz.below(7)][fuzz.below(4)];
    let stride = [columns, columns, fuzz.hostile(6)][fuzz.below(3)];
    let indices: Box<[J]> = (0..fuzz.below(100)).map(|_| fuzz.index(bound)).collect();
    let Ok(checked) = CheckedIndices::new(&indices, columns, stride, bound) else { return };
    let count = (bound + fuzz.below(3)).saturating_sub(1);
    let table = fuzz.table::<L::Real, C>(count);
    let record = |index: J| table[index.into() as usize];
    let first = fuzz.hostile(checked.rows());
    let size = fuzz.hostile(checked.rows());
    if let Some(picked) = checked.all_in_place(first, size, &table) {
        for row in 0..size.min(40) {
            let got = picked.records(row).expect("as many rows as were asked for");
            assert!(
                got.into_iter().copied().eq(checked.row(first + row).iter().copied().map(record))
            );
        }
        assert!(picked.records(size).is_none());
    }
    let which = fuzz.below(RECORDS_PER_LANE);
    let from = fuzz.below(C - 3);
    let four = |record: [L::Real; C]| std::array::from_fn(|c| record[from + c]);
    if let Some(picked) = checked.in_place(first).and_then(|rows| rows.of(&table)) {
        let quads: [L; 4] = picked.quads(level, which, from);
        same(quads, |lane| four(record(checked.row(first + lane)[which])));
    }
    let mut picks = Picks::new(checked);
    for _ in 0..fuzz.below(4) {
        let (lane, row) = (fuzz.hostile(L::LANES), fuzz.hostile(checked.rows()));
        let column = fuzz.hostile(columns);
        match fuzz.below(3) {
            0 => drop(picks.set_rows(lane, row)),
            1 => drop(picks.set_row(lane, row, column)),
            _ => picks.set_first(lane, row, column),
        }
    }
    if let Some(picked) = picks.rows().of(&table) {
        let quads: [L; 4] = picked.quads(level, which, from);
        same(quads, |lane| four(*picked.records(lane)[which]));
    }
    fuzz.calls += 4;
}

fn schedules(fuzz: &mut Fuzz) {
    let bound = fuzz.below(20);
    let index = |fuzz: &mut Fuzz| match fuzz.below(200) {
        0 => fuzz.bits() as u32,
        1 => bound as u32,
        _ => fuzz.below(bound) as u32,
    };
    let pairs: Box<[[u32; 2]]> = (0..fuzz.below(30)).map(|_| [index(fuzz), index(fuzz)]).collect();
    let is_below = pairs.as_flattened().iter().all(|&index| (index as usize) < bound);
    let Some(schedule) = CheckedSchedule::new(&*pairs, bound) else {
        return assert!(!is_below, "{pairs:?} below {bound}");
    };
    assert!(is_below, "{pairs:?} not below {bound}");
    let mut length =
        || (bound + [0, 0, 0, fuzz.below(3)][fuzz.below(4)]).saturating_sub(fuzz.below(9) / 8);
    let (inputs, outputs) = (length(), length());
    // Memory of their own: what is read after it was freed or overwritten is seen too.
    let inputs: Box<[Box<u64>]> = (0..inputs as u64).map(Box::new).collect();
    let before: Box<[Box<u64>]> = (0..outputs as u64).map(|i| Box::new(100 + i)).collect();
    let step = |from: u64, to: u64| from.wrapping_mul(31).wrapping_add(to);
    let mut got = before.clone();
    let ran = schedule.run(&inputs, &mut got, |from, to| Box::new(step(**from, **to)));
    let fits = inputs.len() == bound && before.len() == bound;
    assert_eq!(ran.is_some(), fits);
    let mut wanted = before.clone();
    for &[to, from] in pairs.iter().filter(|_| fits) {
        *wanted[to as usize] = step(*wanted[from as usize], *inputs[to as usize]);
    }
    assert_eq!(got, wanted);
    let (mut got, mut wanted) = (before.clone(), before);
    let ran = schedule.run_in_place(&mut got, |from, to| Box::new(step(**from, **to)));
    assert_eq!(ran.is_some(), got.len() == bound);
    for &[to, from] in pairs.iter().filter(|_| ran.is_some()) {
        *wanted[to as usize] = step(*wanted[from as usize], *wanted[to as usize]);
    }
    assert_eq!(got, wanted);
    fuzz.calls += 3;
}

fn lanes<L: Lanes>(fuzz: &mut Fuzz, level: L::Level) {
    records::<L, 1>(fuzz, level);
    records::<L, 3>(fuzz, level);
    records::<L, 7>(fuzz, level);
    records::<L, 8>(fuzz, level);
    records::<L, 16>(fuzz, level);
    rows::<L>(fuzz, level);
    gathers::<L, 7>(fuzz, level);
    gathers::<L, 8>(fuzz, level);
    picks::<L, u16, 8>(fuzz, level);
    picks::<L, u32, 12>(fuzz, level);
}

fn levels<V: Level>(fuzz: &mut Fuzz, level: V) {
    lanes::<V::F32x4>(fuzz, level);
    lanes::<V::F32x8>(fuzz, level);
    lanes::<V::F32x16>(fuzz, level);
    lanes::<V::F64x2>(fuzz, level);
    lanes::<V::F64x4>(fuzz, level);
    lanes::<V::F64x8>(fuzz, level);
}

fn round(fuzz: &mut Fuzz) {
    for _ in 0..20 {
        schedules(fuzz);
    }
    lanes::<f32>(fuzz, Portable);
    lanes::<f64>(fuzz, Portable);
    levels(fuzz, Portable);
    #[cfg(target_arch = "x86_64")]
    {
        use dq8_simd::x86_64::{Avx2, Avx512};
        if let Some(level) = Avx2::detect() {
            levels(fuzz, level);
        }
        if let Some(level) = Avx512::detect() {
            levels(fuzz, level);
        }
    }
}

#[test]
fn nothing_is_read_or_written_that_is_not_there() {
    let number = |name: &str| std::env::var(name).ok().and_then(|text| text.parse::<u64>().ok());
    let seconds =
        number("DQ8_FUZZ_SECONDS").map_or(Duration::from_millis(200), Duration::from_secs);
    let (first, start) = (number("DQ8_FUZZ_SEED").unwrap_or(1), Instant::now());
    let (mut seed, mut calls) = (first, 0);
    while start.elapsed() < seconds {
        let mut fuzz = Fuzz { state: seed.wrapping_mul(0x2545_f491_4f6c_dd1d), calls: 0 };
        let done = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| round(&mut fuzz)));
        assert!(done.is_ok(), "DQ8_FUZZ_SEED={seed} fails");
        calls += fuzz.calls;
        seed += 1;
    }
    println!("{calls} calls in {} s, seeds {first} to {}", start.elapsed().as_secs(), seed - 1);
}
