//! [`Records`]: between vectors of components and records of numbers in memory.

use crate::internal::GatheredRows;
use crate::lanes::Lanes;
use bytemuck::Zeroable;

/// Transposes between `C` vectors and records of `C` numbers: component `c` of record `i` is lane
/// `i` of vector `c`.
pub trait Records: Lanes {
    /// Transposes on the way in: record `i` of `from` becomes lane `i` of `C` vectors.
    /// Lanes without a record take `padding`.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn load_records<const C: usize>(
        level: Self::Level,
        from: &[[Self::Real; C]],
        padding: [Self::Real; C],
    ) -> [Self; C] {
        Self::load_strided(level, from, None, &padding)
    }
    /// Transposes on the way in of four numbers from each of `LANES` rows that begin `apart`
    /// numbers from each other, the first of them at the beginning of `from`; for rows whose length
    /// is known at run time. `None` if `from` ends before the last of these numbers.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn load_rows(level: Self::Level, from: &[Self::Real], apart: usize) -> Option<[Self; 4]> {
        if from.len() < reach(Self::LANES, apart, 4) {
            return None;
        }
        // SAFETY: row `LANES − 1` begins `(LANES − 1) · apart` numbers from the start, and
        // four numbers from there on are part of `from`: checked above.
        Some(unsafe {
            Self::load_quads(
                level,
                from.as_ptr(),
                #[cfg_attr(not(opt_level_0), inline(always))]
                |lane| lane * apart,
            )
        })
    }
    /// Transposes on the way out of `4 · Q` numbers to each of `LANES` rows that begin `apart`
    /// numbers from each other, the first of them at the beginning of `to`: what
    /// [`load_rows`](Self::load_rows) reads. `false`, and nothing is written, if `to` ends before
    /// the last of these numbers.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn store_rows<const Q: usize>(
        quads: [[Self; 4]; Q],
        to: &mut [Self::Real],
        apart: usize,
    ) -> bool {
        if to.len() < reach(Self::LANES, apart, 4 * Q) {
            return false;
        }
        for (index, quad) in quads.into_iter().enumerate() {
            // SAFETY: row `LANES − 1` begins `(LANES − 1) · apart` numbers from the start, and
            // the numbers of each quad from there on are part of `to`: checked above.
            unsafe { Self::store_quads(quad, to.as_mut_ptr().add(4 * index), apart) };
        }
        true
    }
    /// Transposes on the way out: lane `i` of `C` vectors becomes record `i` of `to`.
    /// Records beyond `LANES` are left as they were.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn store_records<const C: usize>(components: [Self; C], to: &mut [[Self::Real; C]]) {
        Self::store_strided(components, to, None);
    }
    /// [`load_records`](Self::load_records) of every `stride`-th record; `None` is 1, which the
    /// compiler can see.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn load_strided<const C: usize>(
        level: Self::Level,
        from: &[[Self::Real; C]],
        stride: Option<usize>,
        padding: &[Self::Real; C],
    ) -> [Self; C] {
        // What constants decide is decided before there is code of it, here and below.
        if const { Self::LANES == 1 } {
            let mut components = [Self::splat(level, Self::Real::default()); C];
            for (component, &number) in components.iter_mut().zip(from.first().unwrap_or(padding)) {
                *component = Self::splat(level, number);
            }
            return components;
        }
        let flat = from.as_flattened();
        let apart = C.saturating_mul(stride.unwrap_or(1));
        // Numbers one after the other need no transpose.
        if const { C == 1 }
            && let (None, Some(row)) = (stride, flat.get(..Self::LANES))
        {
            let mut array = Self::Array::zeroed();
            array.as_mut().copy_from_slice(row);
            return [Self::load(level, &array); C];
        }
        // Four numbers are read of a record of three.
        if const { C < 3 }
            || flat.len() < reach(Self::LANES, apart, const { if C < 4 { 4 } else { C } })
        {
            let rows = load_each::<Self, C>(from, stride.unwrap_or(1), padding);
            let mut components = [Self::splat(level, Self::Real::default()); C];
            let mut component = 0;
            while component < C {
                components[component] = Self::load(level, &rows[component]);
                component += 1;
            }
            return components;
        }
        // SAFETY: record `LANES − 1` begins `(LANES − 1) · apart` numbers from the start, and
        // the numbers of each, or, of three, a fourth one, are there: checked above.
        unsafe {
            load_all(
                level,
                flat.as_ptr(),
                #[cfg_attr(not(opt_level_0), inline(always))]
                |lane| lane * apart,
            )
        }
    }
    /// Lane `i` of `C` vectors is the record `column` of its row. `None` if a row of the
    /// `Gather` or the column does not exist. `C` must be at least four.
    #[doc(hidden)]
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn load_gathered<const C: usize>(
        level: Self::Level,
        from: &[[Self::Real; C]],
        rows: &GatheredRows<C>,
        column: usize,
    ) -> Option<[Self; C]> {
        const { assert!(C >= 4) }
        if rows.greatest.saturating_add(column) >= from.len() {
            return None;
        }
        // SAFETY: there are as many rows as any vector has lanes; the record of the greatest is
        // there, and no other lies beyond it.
        Some(unsafe {
            load_all(
                level,
                from.as_flattened().as_ptr(),
                #[cfg_attr(not(opt_level_0), inline(always))]
                |lane| rows.starts.get_unchecked(lane) + column * C,
            )
        })
    }
    /// Four components of the first records, from component `first` on. `None` if there are not as
    /// many records as lanes, or no such components.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn load_four<const C: usize>(
        level: Self::Level,
        from: &[[Self::Real; C]],
        first: usize,
    ) -> Option<[Self; 4]> {
        // Not `first + 4`, which may wrap.
        if from.len() < Self::LANES || C < 4 || first > C - 4 {
            return None;
        }
        // SAFETY: there is a record for each lane, and four of its numbers begin at `first`.
        Some(unsafe {
            Self::load_quads(
                level,
                from.as_flattened().as_ptr().add(first),
                #[cfg_attr(not(opt_level_0), inline(always))]
                |lane| lane * C,
            )
        })
    }
    /// [`store_records`](Self::store_records) to every `stride`-th record; `None` is 1.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn store_strided<const C: usize>(
        components: [Self; C],
        to: &mut [[Self::Real; C]],
        stride: Option<usize>,
    ) {
        if const { Self::LANES == 1 } {
            let record = to.first_mut().into_iter().flatten();
            for (slot, component) in record.zip(components) {
                if let [number] = component.to_array().as_ref() {
                    *slot = *number;
                }
            }
            return;
        }
        let flat = to.as_flattened_mut();
        let apart = C.saturating_mul(stride.unwrap_or(1));
        let fits = flat.len() >= reach(Self::LANES, apart, C);
        if const { C == 3 }
            && let (&[x, y, z], true, 3) = (components.as_slice(), fits, apart)
        {
            // SAFETY: checked above.
            return unsafe { Self::store_triples([x, y, z], flat.as_mut_ptr()) };
        }
        if const { C < 4 } || !fits {
            let mut rows = [Self::Array::zeroed(); C];
            let mut component = 0;
            while component < C {
                components[component].store(&mut rows[component]);
                component += 1;
            }
            return store_each::<Self, C>(&rows, to, stride.unwrap_or(1));
        }
        // SAFETY: checked above.
        unsafe { store_all(components, flat.as_mut_ptr(), apart) };
    }
}

impl<L: Lanes> Records for L {}

/// Where four of `C` components begin, the fours one after the other; the last begin earlier where
/// `C` is not a multiple of four.
#[cfg_attr(not(opt_level_0), inline(always))]
const fn four<const C: usize>(number: usize) -> usize {
    if 4 * number + 4 <= C { 4 * number } else { C.saturating_sub(4) }
}

/// Does something for each four of `C` components.
///
/// Written four times where a loop would do, which is left to matrices of six rows: whether the
/// compiler unrolls a loop depends on how it weighs bytes, and one that it leaves goes through
/// memory, which takes 1.4 of the time in WebAssembly. What an instance has no fours for is decided
/// by a constant, and no code of it: a program has dozens of instances.
macro_rules! fours {
    ($C:ident, |$first:ident| $each:expr) => {
        fours!(@ $C, |$first| $each, 0 1 2 3);
        if const { $C > 16 } {
            for number in 4..$C.div_ceil(4) {
                let $first = four::<$C>(number);
                $each
            }
        }
    };
    (@ $C:ident, |$first:ident| $each:expr, $($number:literal)*) => {$(
        if const { 4 * $number < $C } {
            let $first = const { four::<$C>($number) };
            $each
        }
    )*};
}

/// # Safety
/// Of the `C` numbers, or of the four if `C` is three, that begin `place(lane)` numbers after
/// `from`, all may be read, for each lane.
#[cfg_attr(not(opt_level_0), inline(always))]
unsafe fn load_all<L: Lanes, const C: usize>(
    level: L::Level,
    from: *const L::Real,
    place: impl Fn(usize) -> usize + Copy,
) -> [L; C] {
    let mut components = [L::splat(level, L::Real::default()); C];
    fours!(C, |first| {
        // SAFETY: the numbers may be read, as promised. `first` is at most C − 4, or 0 where C is
        // less, so neither place holds less than is copied.
        unsafe {
            let quad = L::load_quads(level, from.add(first), place);
            let to = components.as_mut_ptr().add(first);
            to.copy_from_nonoverlapping(quad.as_ptr(), const { if C < 4 { C } else { 4 } });
        }
    });
    components
}

/// # Safety
/// `C`, four or more, numbers that begin `i · stride` numbers after `to` may be written, for each
/// lane `i`.
#[cfg_attr(not(opt_level_0), inline(always))]
unsafe fn store_all<L: Lanes, const C: usize>(components: [L; C], to: *mut L::Real, stride: usize) {
    fours!(C, |first| {
        // SAFETY: `first` is at most C − 4, and C at least four, so four components are there;
        // the rest is promised.
        unsafe {
            let quad = components.as_ptr().add(first).cast::<[L; 4]>().read();
            L::store_quads(quad, to.add(first), stride);
        }
    });
}

/// How many numbers `lanes` records of `count` reach over, `stride` apart.
#[cfg_attr(not(opt_level_0), inline(always))]
fn reach(lanes: usize, stride: usize, count: usize) -> usize {
    stride.saturating_mul(lanes - 1).saturating_add(count)
}

/// [`Records::load_strided`] one number at a time: where the records end. Not inlined, and without
/// vectors: the loop that calls it keeps its registers.
#[cold]
#[inline(never)]
fn load_each<L: Lanes, const C: usize>(
    from: &[[L::Real; C]],
    stride: usize,
    padding: &[L::Real; C],
) -> [L::Array; C] {
    let mut rows = [L::Array::zeroed(); C];
    let mut records = from.iter().step_by(stride.max(1));
    for lane in 0..L::LANES {
        for (row, &value) in rows.iter_mut().zip(records.next().unwrap_or(padding)) {
            row.as_mut()[lane] = value;
        }
    }
    rows
}

/// [`Records::store_strided`] one number at a time: where the records end.
#[cold]
#[inline(never)]
fn store_each<L: Lanes, const C: usize>(
    rows: &[L::Array; C],
    to: &mut [[L::Real; C]],
    stride: usize,
) {
    for (lane, record) in to.iter_mut().step_by(stride.max(1)).take(L::LANES).enumerate() {
        for (slot, row) in record.iter_mut().zip(rows) {
            *slot = row.as_ref()[lane];
        }
    }
}
