//! Single operations on rows of the reference vectors, one motion at a time and on slices.

use crate::Board;
use crate::answers::{MUL, NORMALIZE, POINT, SCLERP};
use crate::error::{error, max_or_nan, motion_error};
use crate::table::Table;
use core::hint::black_box;
use dq8::{Backend, DualQuat};

// In units of 2⁻²³; the table of the project is tests/contract/operations.rs.
const PRODUCT: f32 = 2.0;
const UNIT: f32 = 2.0;
const MOVED: f32 = 4.0;
const SCREW: f32 = 8.0;

/// How many rows of each there are.
const ROWS: usize = MUL.len();
type Motions = [DualQuat<f32>; ROWS];

pub(crate) fn run<B: Board>(table: &mut Table<'_, B>) {
    products(table);
    units(table);
    points(table);
    screws(table);
}

fn products<B: Board>(table: &mut Table<'_, B>) {
    let a = MUL.map(|(a, _, _)| DualQuat::from_array(a));
    let b = MUL.map(|(_, b, _)| DualQuat::from_array(b));
    let worst = |computed: &Motions| worst(computed, MUL.map(|(.., answer)| answer));
    let mut computed = [DualQuat::ZERO; ROWS];

    let (a, b) = black_box((&a, &b));
    let cost = each(table, |i| computed[i] = a[i] * b[i]);
    table.line("product", cost, worst(&computed), PRODUCT);
    let cost = on_slices(table, |best| {
        best.mul(black_box(a), black_box(b), black_box(&mut computed)).is_ok()
    });
    table.line("product, slices", cost, worst(&computed), PRODUCT);
}

fn units<B: Board>(table: &mut Table<'_, B>) {
    let a = NORMALIZE.map(|(a, _)| DualQuat::from_array(a));
    let worst = |computed: &Motions| worst(computed, NORMALIZE.map(|(.., answer)| answer));
    let mut computed = [DualQuat::ZERO; ROWS];

    let a = black_box(&a);
    let cost = each(table, |i| computed[i] = a[i].normalize());
    table.line("normalize", cost, worst(&computed), UNIT);
    let cost =
        on_slices(table, |best| best.normalize(black_box(a), black_box(&mut computed)).is_ok());
    table.line("normalize, slices", cost, worst(&computed), UNIT);
}

fn points<B: Board>(table: &mut Table<'_, B>) {
    let a = POINT.map(|(a, ..)| DualQuat::from_array(a).normalize());
    let v = POINT.map(|(_, v, _)| v);
    let worst = |computed: &[[f32; 3]; ROWS]| {
        let pairs = computed.iter().zip(&POINT);
        pairs
            .fold(0.0, |worst, (computed, (.., answer))| max_or_nan(error(computed, answer), worst))
    };
    let mut computed = [[0.0; 3]; ROWS];

    let (a, v) = black_box((&a, &v));
    let cost = each(table, |i| computed[i] = a[i].transform_point(v[i]));
    table.line("point", cost, worst(&computed), MOVED);
    let cost = on_slices(table, |best| {
        best.transform_points_each(black_box(a), black_box(v), black_box(&mut computed)).is_ok()
    });
    table.line("point, slices", cost, worst(&computed), MOVED);
}

fn screws<B: Board>(table: &mut Table<'_, B>) {
    let a = SCLERP.map(|(a, ..)| DualQuat::from_array(a).normalize());
    let b = SCLERP.map(|(_, b, ..)| DualQuat::from_array(b).normalize());
    let t = SCLERP.map(|(_, _, t, _)| t);
    let worst = |computed: &Motions| worst(computed, SCLERP.map(|(.., answer)| answer));
    let mut computed = [DualQuat::ZERO; ROWS];

    let (a, b, t) = black_box((&a, &b, &t));
    let cost = each(table, |i| computed[i] = a[i].sclerp(b[i], t[i]));
    table.line("ScLERP", cost, worst(&computed), SCREW);
    let cost = on_slices(table, |best| {
        best.sclerp_each(black_box(a), black_box(b), black_box(t), black_box(&mut computed)).is_ok()
    });
    table.line("ScLERP, slices", cost, worst(&computed), SCREW);
}

/// Instructions of one of the rows, one after the other.
fn each<B: Board>(table: &mut Table<'_, B>, mut work: impl FnMut(usize)) -> u32 {
    table.count(|| (0..ROWS).for_each(&mut work)) / ROWS as u32
}

/// Instructions of one of the rows, all in a call.
fn on_slices<B: Board>(table: &mut Table<'_, B>, work: impl FnOnce(Backend) -> bool) -> u32 {
    let best = Backend::best();
    table.count(|| _ = black_box(work(best))) / ROWS as u32
}

fn worst(computed: &Motions, answers: [[f32; 8]; ROWS]) -> f32 {
    let pairs = computed.iter().zip(&answers);
    pairs.fold(0.0, |worst, (computed, answer)| {
        max_or_nan(motion_error(computed.to_array(), answer), worst)
    })
}
