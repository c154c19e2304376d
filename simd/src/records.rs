//! [`Records`]: transposes between records in memory and vectors of components.
//!
//! A *record* is the `C` components of one object: a point has three, a motion eight. Plain memory
//! holds one record after the other, while a kernel needs one vector per component:
//!
//! ```text
//! memory   x₀ y₀ z₀  x₁ y₁ z₁  x₂ y₂ z₂  x₃ y₃ z₃
//! vectors  [x₀ x₁ x₂ x₃]  [y₀ y₁ y₂ y₃]  [z₀ z₁ z₂ z₃]
//! ```
//!
//! [`Lanes::load_quads`] transposes four components at a time, from any addresses, and is `unsafe`.
//! The methods here are safe: they compute the addresses from a slice and check once per vector
//! that all of them are inside the slice:
//!
//! ```text
//! load_strided(from, stride):
//!     if there is one lane:                   copy the record
//!     if C = 1 and the records adjoin:        load the components as they are
//!     if C ≥ 3 and the slice is long enough:  transpose, four components at a time
//!     else:                                   move one component at a time, in a cold function
//! ```
//!
//! 1. If `C` is not a multiple of four, the last two transposes overlap. For example, components 0
//!    to 6 are read as 0 to 3 and 3 to 6, so that no load reads outside of the record. The overlap
//!    costs no time, because a transpose of three components takes as long as a transpose of four.
//! 2. A load of records of three components also reads the component after each record, and drops
//!    it. The slice must contain this fourth component. After the last record of a slice there is
//!    none, so the cold function loads the vector that ends with this record.
//! 3. The cold function takes and returns arrays, not vectors, so the loop around the call keeps
//!    its vectors in registers.

use crate::internal::GatheredRows;
use crate::lanes::Lanes;
use bytemuck::Zeroable;

/// Transposes between `C` vectors and records of `C` components: component `c` of record `i` is
/// lane `i` of vector `c`.
pub trait Records: Lanes {
    /// Loads the first `LANES` records: component `c` of record `i` of `from` becomes lane `i` of
    /// vector `c`. If `from` has fewer records, the remaining lanes hold the record `padding`.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn load_records<const C: usize>(
        level: Self::Level,
        from: &[[Self::Real; C]],
        padding: [Self::Real; C],
    ) -> [Self; C] {
        Self::load_strided(level, from, None, &padding)
    }
    /// Loads four elements from each of `LANES` rows: lane `i` of vector `c` is element
    /// `i · stride + c` of `from`. This is for rows whose length is known at run time only.
    /// Returns `None` if `from` ends before the last of these elements.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn load_rows(level: Self::Level, from: &[Self::Real], stride: usize) -> Option<[Self; 4]> {
        if from.len() < reach(Self::LANES, stride, 4) {
            return None;
        }
        // SAFETY: the last row begins at element `(LANES − 1) · stride`, and `from` has four
        // elements from there on, as checked above, so the four elements of every lane are
        // readable.
        Some(unsafe {
            Self::load_quads(
                level,
                from.as_ptr(),
                #[cfg_attr(not(opt_level_0), inline(always))]
                |lane| lane * stride,
            )
        })
    }
    /// Stores `4 · Q` elements to each of `LANES` rows: lane `i` of vector `c` of quad `q` becomes
    /// element `i · stride + 4q + c` of `to`. Returns `false`, and writes nothing, if `to` ends
    /// before the last of these elements.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn store_rows<const Q: usize>(
        quads: [[Self; 4]; Q],
        to: &mut [Self::Real],
        stride: usize,
    ) -> bool {
        if to.len() < reach(Self::LANES, stride, 4 * Q) {
            return false;
        }
        for (index, quad) in quads.into_iter().enumerate() {
            // SAFETY: the last row begins at element `(LANES − 1) · stride`, and `to` has the
            // `4Q` elements of all quads from there on, as checked above. `to` is borrowed mutably.
            unsafe { Self::store_quads(quad, to.as_mut_ptr().add(4 * index), stride) };
        }
        true
    }
    /// Stores records: lane `i` of vector `c` becomes component `c` of record `i` of `to`. Records
    /// after the first `LANES` keep their values.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn store_records<const C: usize>(components: [Self; C], to: &mut [[Self::Real; C]]) {
        Self::store_strided(components, to, None);
    }
    /// Loads every `stride`-th record, from the first record on, and is otherwise like
    /// [`load_records`](Self::load_records). `None` means a stride of 1, which the compiler then
    /// knows as a constant.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn load_strided<const C: usize>(
        level: Self::Level,
        from: &[[Self::Real; C]],
        stride: Option<usize>,
        padding: &[Self::Real; C],
    ) -> [Self; C] {
        // The conditions here and below are `const` blocks, so that a branch that is never taken is
        // not compiled.
        if const { Self::LANES == 1 } {
            let mut components = [Self::splat(level, Self::Real::default()); C];
            for (component, &number) in components.iter_mut().zip(from.first().unwrap_or(padding)) {
                *component = Self::splat(level, number);
            }
            return components;
        }
        let flat = from.as_flattened();
        let spacing = C.saturating_mul(stride.unwrap_or(1));
        // Adjoining records of one component need no transpose.
        if const { C == 1 }
            && let (None, Some(row)) = (stride, flat.get(..Self::LANES))
        {
            let mut array = Self::Array::zeroed();
            array.as_mut().copy_from_slice(row);
            return [Self::load(level, &array); C];
        }
        if stride.is_none()
            && flat.len() >= reach(Self::LANES, C, C)
            // SAFETY: `from` has `C · LANES` components, as the line above checks.
            && let Some(components) = unsafe { Self::load_adjoining::<C>(level, flat.as_ptr()) }
        {
            return components;
        }
        let all = match stride {
            Some(stride) if const { C >= 4 } => has_all::<Self, C>(from.len(), stride),
            // A load of records of three components also reads the component after each record.
            _ => flat.len() >= reach(Self::LANES, spacing, const { if C < 4 { 4 } else { C } }),
        };
        if const { C < 3 } || !all {
            // `padding` is passed by value. If it were passed by reference, a caller with a
            // constant would have to store it to the stack for this call.
            let rows = load_each::<Self, C>(from, stride.unwrap_or(1), *padding);
            let mut components = [Self::splat(level, Self::Real::default()); C];
            let mut component = 0;
            while component < C {
                components[component] = Self::load(level, &rows[component]);
                component += 1;
            }
            return components;
        }
        // SAFETY: the last record begins at component `(LANES − 1) · spacing`, and `from` has
        // `C` components from there on, or four if `C` is three, because `all` is true.
        unsafe {
            load_all(
                level,
                flat.as_ptr(),
                #[cfg_attr(not(opt_level_0), inline(always))]
                |lane| lane * spacing,
            )
        }
    }
    /// Loads record `column` of each lane's own row into `C` vectors. Returns `None` if the record
    /// `column` of one of these rows is beyond the end of `from`. `C` must be at least four.
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
        // SAFETY: `starts` has `MAX_LANES` elements, so `lane` is in bounds. No row begins after
        // the greatest row, whose record `column` is in `from`, as checked above, so the `C`
        // components of each lane are readable.
        Some(unsafe {
            load_all(
                level,
                from.as_flattened().as_ptr(),
                #[cfg_attr(not(opt_level_0), inline(always))]
                |lane| rows.starts.get_unchecked(lane) + column * C,
            )
        })
    }
    /// Loads components `first` to `first + 3` of the first `LANES` records. Returns `None` if
    /// there are fewer than `LANES` records, or if a record ends before component `first + 3`.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn load_four<const C: usize>(
        level: Self::Level,
        from: &[[Self::Real; C]],
        first: usize,
    ) -> Option<[Self; 4]> {
        // The condition is not `first + 4 > C`, because that sum may wrap.
        if from.len() < Self::LANES || C < 4 || first > C - 4 {
            return None;
        }
        // SAFETY: `from` has a record for each lane, and each record has four components from
        // `first` on, as checked above.
        Some(unsafe {
            Self::load_quads(
                level,
                from.as_flattened().as_ptr().add(first),
                #[cfg_attr(not(opt_level_0), inline(always))]
                |lane| lane * C,
            )
        })
    }
    /// Stores to every `stride`-th record, from the first record on, and is otherwise like
    /// [`store_records`](Self::store_records). `None` means a stride of 1, which the compiler then
    /// knows as a constant.
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
        let records = to.len();
        let flat = to.as_flattened_mut();
        let spacing = C.saturating_mul(stride.unwrap_or(1));
        let fits = match stride {
            Some(stride) if const { C >= 4 } => has_all::<Self, C>(records, stride),
            _ => flat.len() >= reach(Self::LANES, spacing, C),
        };
        if stride.is_none() && fits {
            // SAFETY: `fits` means that `to` has `C · LANES` components, and `to` is borrowed
            // mutably.
            if unsafe { Self::store_adjoining(components, flat.as_mut_ptr()) } {
                return;
            }
        }
        if const { C == 3 }
            && let (&[x, y, z], true, 3) = (components.as_slice(), fits, spacing)
        {
            // SAFETY: `fits` and `spacing` mean that `to` has the `3 · LANES` components that are
            // written, and `to` is borrowed mutably.
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
        // SAFETY: `fits` means that `to` has the `C` components of each lane, `spacing` components
        // apart. `C` is at least four here, and `to` is borrowed mutably.
        unsafe { store_all(components, flat.as_mut_ptr(), spacing) };
    }
}

impl<L: Lanes> Records for L {}

/// Returns the first component of group `number`, where each group is four of `C` components. The
/// last group ends with the last component, so it overlaps the group before it if `C` is not a
/// multiple of four.
#[cfg_attr(not(opt_level_0), inline(always))]
const fn first_of_four<const C: usize>(number: usize) -> usize {
    if 4 * number + 4 <= C { 4 * number } else { C.saturating_sub(4) }
}

/// Runs `$each` for each group of four of `C` components, with the group's first component as
/// `$first`.
///
/// The macro writes the body out four times, for up to 16 components, and only larger records
/// (matrices of six rows) take a loop. The compiler does not always unroll a loop, and a loop that
/// is not unrolled keeps its vectors in memory, which takes 1.4 times as long in WebAssembly. The
/// conditions are `const` blocks, so a record of four components compiles one body and not four.
macro_rules! fours {
    ($C:ident, |$first:ident| $each:expr) => {
        fours!(@ $C, |$first| $each, 0 1 2 3);
        if const { $C > 16 } {
            for number in 4..$C.div_ceil(4) {
                let $first = first_of_four::<$C>(number);
                $each
            }
        }
    };
    (@ $C:ident, |$first:ident| $each:expr, $($number:literal)*) => {$(
        if const { 4 * $number < $C } {
            let $first = const { first_of_four::<$C>($number) };
            $each
        }
    )*};
}

/// Loads `C` components per lane, from `from + offset(lane)` on, into `C` vectors.
///
/// # Safety
/// For each lane, the `C` components from `from + offset(lane)` on must be readable, or four if `C`
/// is three.
#[cfg_attr(not(opt_level_0), inline(always))]
unsafe fn load_all<L: Lanes, const C: usize>(
    level: L::Level,
    from: *const L::Real,
    offset: impl Fn(usize) -> usize + Copy,
) -> [L; C] {
    let mut components = [L::splat(level, L::Real::default()); C];
    fours!(C, |first| {
        // SAFETY: `first` is at most C − 4, or 0 if C is three, so the four components from
        // `first` on are among those that the caller guarantees to be readable, and `components`
        // has room for the copy of at most C vectors.
        unsafe {
            let quad = L::load_quads(level, from.add(first), offset);
            let to = components.as_mut_ptr().add(first);
            to.copy_from_nonoverlapping(quad.as_ptr(), const { if C < 4 { C } else { 4 } });
        }
    });
    components
}

/// Stores `C` vectors as `C` components per lane, from `to + lane · stride` on. `C` must be at
/// least four.
///
/// # Safety
/// For each lane, the `C` components from `to + lane · stride` on must be writable, and no other
/// thread may use them during the call.
#[cfg_attr(not(opt_level_0), inline(always))]
unsafe fn store_all<L: Lanes, const C: usize>(components: [L; C], to: *mut L::Real, stride: usize) {
    fours!(C, |first| {
        // SAFETY: C is at least four and `first` at most C − 4, so `components` has four vectors
        // from `first` on, and the four components from `first` on are among those that the caller
        // guarantees to be writable for each lane.
        unsafe {
            let quad = components.as_ptr().add(first).cast::<[L; 4]>().read();
            L::store_quads(quad, to.add(first), stride);
        }
    });
}

/// Returns the length that a slice needs for `lanes` records of `count` elements each, which begin
/// `spacing` elements apart.
#[cfg_attr(not(opt_level_0), inline(always))]
fn reach(lanes: usize, spacing: usize, count: usize) -> usize {
    spacing.saturating_mul(lanes - 1).saturating_add(count)
}

/// Returns `true` if a slice of `records` records has the record `lane · stride` for each lane.
/// This compares the same lengths as a test with [`reach`], in fewer instructions. `C` must be at
/// least four.
#[cfg_attr(not(opt_level_0), inline(always))]
fn has_all<L: Lanes, const C: usize>(records: usize, stride: usize) -> bool {
    // The product below does not wrap: `stride` is at most `records`, a slice has at most
    // `usize::MAX / 2` bytes, and a record has at least as many bytes as there are lanes.
    const { assert!(C < 4 || L::LANES <= C * size_of::<L::Real>()) }
    stride <= records && (L::LANES - 1) * stride < records
}

/// Loads records one component at a time, with `padding` after the end of the slice. This is the
/// rare case of [`Records::load_strided`].
#[cold]
#[inline(never)]
fn load_each<L: Lanes, const C: usize>(
    from: &[[L::Real; C]],
    stride: usize,
    padding: [L::Real; C],
) -> [L::Array; C] {
    let mut rows = [L::Array::zeroed(); C];
    let mut records = from.iter().step_by(stride.max(1));
    for lane in 0..L::LANES {
        for (row, &value) in rows.iter_mut().zip(records.next().unwrap_or(&padding)) {
            row.as_mut()[lane] = value;
        }
    }
    rows
}

/// Stores records one component at a time, as many as the slice has. This is the rare case of
/// [`Records::store_strided`].
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
