//! Interpolation between keys of 16 bits, compared with plain integers, and the checks of their
//! tables.
#![forbid(unsafe_code)]

use dq8_simd::internal::{OwnedTracks, TrackError, TrackPlace, Tracks};
use dq8_simd::{Float, Lanes, Level, Portable};

/// SplitMix64 (Steele, Lea and Flood 2014).
fn random(state: &mut u64) -> u64 {
    *state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let mut bits = *state;
    bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    bits ^ (bits >> 31)
}

fn words<const N: usize>(words: [u32; N]) -> Vec<u8> {
    words.into_iter().flat_map(u32::to_le_bytes).collect()
}

/// Three clips of three columns, among 32 keys: one clip moves in two columns, one in all, one has
/// a single frame.
struct Bytes {
    keys: Vec<u8>,
    clips: Vec<u8>,
    rows: Vec<u8>,
}

impl Bytes {
    fn new() -> Self {
        let mut state = 7;
        let extreme = [i16::MIN, i16::MAX, -1, 0, 1];
        let mut number = || match random(&mut state) {
            bits if bits.is_multiple_of(3) => extreme[(bits >> 8) as usize % 5],
            bits => (bits >> 16) as i16,
        };
        Self {
            keys: (0..32 * 4).flat_map(|_| number().to_le_bytes()).collect(),
            clips: words([0, 5, 2, 0, 12, 4, 3, 1, 0, 1, 0, 2]),
            rows: [1, 2 * 31, 3, 1, 3, 5, 2 * 30, 0, 2 * 31_u16]
                .into_iter()
                .flat_map(u16::to_le_bytes)
                .collect(),
        }
    }
    fn tracks(&self) -> Result<Tracks<'_>, TrackError> {
        Tracks::new(&self.keys, &self.clips, &self.rows, 3)
    }
}

/// 2¹⁴((1−t)a + tb) in integers; the weight in `f64`, which holds 2¹⁴t exactly.
fn by_the_book(a: [i16; 4], b: [i16; 4], t: f64) -> [i32; 4] {
    let t = if t > 0.0 { t.min(1.0) } else { 0.0 };
    let weight = (t * 16384.0).round_ties_even() as i64;
    std::array::from_fn(|c| {
        i32::try_from(i64::from(a[c]) * (16384 - weight) + i64::from(b[c]) * weight).expect("fits")
    })
}

/// Every lane of every column, each lane at a place and a parameter of its own; and one place,
/// lanes of columns.
fn check<L: Lanes>(level: L::Level, parameters: &[f64]) {
    level.run(
        #[inline(always)]
        || {
            let bytes = Bytes::new();
            let tracks = bytes.tracks().expect("they fit");
            let at = [(0, 0), (1, 2), (2, 0), (0, 3), (1, 0), (0, 1), (1, 1)];
            let places: Vec<_> =
                (0..19).map(|i| tracks.place(at[i % 7].0, at[i % 7].1).unwrap()).collect();
            let placed = tracks.placed(&places).expect("of these tracks");
            let wanted = |i: usize, column: usize, t: f64| {
                let (clip, frame) = at[i.min(18) % 7];
                let next = (frame + 1).min(tracks.frames(clip).unwrap() - 1);
                let [a, b] = [frame, next].map(|f| tracks.key(clip, column, f).unwrap().1);
                by_the_book(a, b, t).map(L::Real::from_i32)
            };
            for (turn, chunk) in parameters.chunks(L::LANES).enumerate() {
                let t: Vec<_> = chunk.iter().map(|&t| L::Real::from_f64(t)).collect();
                let t = L::load_partial(level, &t, L::Real::from_f64(0.5));
                let (first, column) = (turn % 19, turn % 3);
                let got = placed.between(level, first, column, t).unwrap();
                let columns = placed.between_columns(level, first, column, t).unwrap();
                for lane in 0..L::LANES {
                    let t = t.to_array().as_ref()[lane].into();
                    let lane_of = |got: [L; 4]| got.map(|c| c.to_array().as_ref()[lane]);
                    assert_eq!(lane_of(got), wanted(first + lane, column, t), "{t}");
                    let column = (column + lane).min(2);
                    assert_eq!(lane_of(columns), wanted(first, column, t), "{t}");
                }
            }
            let t = L::splat(level, L::Real::from_f64(0.5));
            assert!(placed.between(level, 0, 3, t).is_none(), "no such column");
            assert!(placed.between_columns(level, 19, 0, t).is_none(), "no such place");
            assert!(placed.part(5..5).between(level, 0, 0, t).is_none(), "no place");
            let after = placed.part(1..19).between(level, 0, 1, t).unwrap();
            let same = placed.between(level, 1, 1, t).unwrap();
            assert_eq!(after.map(L::to_array_bits), same.map(L::to_array_bits));
        },
    );
}

/// The lanes as numbers that can be compared.
trait Bits: Lanes {
    fn to_array_bits(self) -> Vec<f64> {
        self.to_array().as_ref().iter().map(|&number| number.into()).collect()
    }
}
impl<L: Lanes> Bits for L {}

fn all_of<V: Level>(level: V, parameters: &[f64]) {
    check::<V::F32x4>(level, parameters);
    check::<V::F32x8>(level, parameters);
    check::<V::F32x16>(level, parameters);
    check::<V::F64x2>(level, parameters);
    check::<V::F64x4>(level, parameters);
    check::<V::F64x8>(level, parameters);
}

#[test]
fn between_two_keys_all_lanes_have_what_integers_have_for_every_weight() {
    let every = (0..=16384).map(|i| f64::from(i) / 16384.0);
    let half_way = (0..1000).map(|i| (f64::from(i * 16) + 0.5) / 16384.0);
    let near_half =
        (0..1000).map(|i| f64::from((f64::from(i * 16) as f32 + 0.5_f32).next_up()) / 16384.0);
    let hostile = [
        f64::NAN,
        -f64::NAN,
        -0.0,
        -1e-9,
        1.0 + 1e-7,
        1e30,
        -1e30,
        f64::INFINITY,
        f64::NEG_INFINITY,
    ];
    let all: Vec<_> = every.chain(half_way).chain(near_half).chain(hostile).collect();
    check::<f32>(Portable, &all);
    check::<f64>(Portable, &all);
    all_of(Portable, &all);
    #[cfg(target_arch = "x86_64")]
    {
        use dq8_simd::x86_64::{Avx2, Avx512};
        if let Some(avx2) = Avx2::detect() {
            all_of(avx2, &all);
        }
        if let Some(avx512) = Avx512::detect() {
            all_of(avx512, &all);
        }
    }
}

#[test]
fn a_key_that_is_not_there_is_refused_at_its_clip_and_entry() {
    let good = Bytes::new();
    assert!(good.tracks().is_ok());
    let with = |word: usize, number: u32| {
        let mut bytes = Bytes::new();
        bytes.clips[4 * word..][..4].copy_from_slice(&number.to_le_bytes());
        bytes.tracks().map(|_| ())
    };
    let with_entry = |entry: usize, number: u16| {
        let mut bytes = Bytes::new();
        bytes.rows[2 * entry..][..2].copy_from_slice(&number.to_le_bytes());
        bytes.tracks().map(|_| ())
    };
    // Four frames on, two keys each, from key 23: the last is 31. One later it is not there.
    assert_eq!(with_entry(0, 2 * 23 + 1), Ok(()));
    assert_eq!(with_entry(0, 2 * 24 + 1), Err(TrackError::Entry(0)));
    assert_eq!(with_entry(8, 2 * 32), Err(TrackError::Entry(8)));
    assert_eq!(with_entry(4, u16::MAX), Err(TrackError::Entry(4)));
    // From the clip's first key: three frames on, three keys each, from the third after that, is
    // the last.
    assert_eq!((with(4, 20), with(4, 21)), (Ok(()), Err(TrackError::Entry(5))));
    // Moves without a step.
    assert_eq!(with_entry(6, 1), Err(TrackError::Entry(6)));
    // No frame; a step without a next frame; more keys than 32 bits count, after the first or with
    // it; no such row.
    assert_eq!(with(1, 0), Err(TrackError::Clip(0)));
    assert_eq!(with(10, 1), Err(TrackError::Clip(2)));
    assert_eq!(with(5, u32::MAX), Err(TrackError::Clip(1)));
    assert_eq!(with(4, u32::MAX), Err(TrackError::Clip(1)));
    assert_eq!(with(11, 3), Err(TrackError::Clip(2)));
    // The row of another clip, which leads too far from the first key of this one.
    assert_eq!(with(7, 0), Err(TrackError::Entry(1)));
    let short = Bytes { rows: good.rows[..16].to_vec(), ..Bytes::new() };
    assert_eq!(short.tracks().map(|_| ()), Err(TrackError::Clip(2)));
}

#[test]
fn owned_tracks_are_checked_in_their_ranges_and_a_range_beyond_the_bytes_is_empty() {
    let Bytes { keys, clips, rows } = Bytes::new();
    let [first, second] = [keys.len(), keys.len() + clips.len()];
    let all = [keys, clips, rows].concat();
    let owned = |keys, rows| OwnedTracks::new(all.clone().into(), [keys, first..second, rows], 3);
    let tracks = owned(0..first, second..all.len()).unwrap();
    let borrowed = tracks.borrowed();
    assert_eq!((borrowed.clips(), borrowed.frames(1)), (3, Some(4)));
    assert_eq!(borrowed.key(1, 2, 3), Bytes::new().tracks().unwrap().key(1, 2, 3));
    let refused = |keys, rows| owned(keys, rows).map(|_| ()).unwrap_err();
    assert_eq!(refused(0..all.len() + 1, second..all.len()), TrackError::Entry(0));
    assert_eq!(refused(0..first, second..all.len() + 1), TrackError::Clip(0));
}

#[test]
fn only_places_of_the_same_tracks_are_read() {
    let bytes = Bytes::new();
    let tracks = bytes.tracks().unwrap();
    assert_eq!((tracks.place(0, 4), tracks.place(3, 0), tracks.place(2, 1)), (None, None, None));
    let good = tracks.place(0, 3).unwrap();
    for number in 0..6 {
        let mut other = [tracks.place(2, 0).unwrap(), good];
        for by in [1, 6, u32::MAX, 1 << 30] {
            let place: &mut [u32; 6] = bytemuck::cast_mut(&mut other[1]);
            place[number] = place[number].wrapping_add(by);
            assert_eq!(tracks.placed(&other).map(|_| ()), Err(1), "{number} {by}");
        }
    }
    assert!(tracks.placed(&[TrackPlace::default()]).is_err(), "clip 0 has a step");
}
