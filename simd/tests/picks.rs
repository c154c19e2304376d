//! Records of a table by indices that are checked once.

use dq8_simd::internal::{CheckedIndices, Index, Picks};
use dq8_simd::{Portable, f32x4};

#[test]
fn only_indices_that_were_checked_are_read() {
    let indices = [1_u8, 2, 9, 9, 2, 0, 9, 9, 1, 1];
    let checked = CheckedIndices::new(&indices, 2, 4, 3).unwrap();
    assert_eq!((checked.rows(), checked.bound()), (3, 3));
    assert_eq!([0, 1, 2].map(|row| checked.row(row)), [[1, 2], [2, 0], [1, 1]]);
    // 2⁶² · 4 wraps to the first row.
    for row in [3, usize::MAX / 4 + 1, usize::MAX] {
        assert!(checked.row(row).is_empty(), "{row}");
    }
    assert_eq!(CheckedIndices::new(&indices[1..], 2, 4, 3).unwrap_err(), (0, 1));
    assert_eq!(CheckedIndices::new(&indices[4..], 2, 2, 3).unwrap_err(), (1, 0));
    // There are no rows if they would overlap, or would have no columns.
    for (columns, stride) in [(2, 1), (1, 0), (0, 4)] {
        assert_eq!(CheckedIndices::new(&indices, columns, stride, 3).unwrap().rows(), 0);
    }
    // A lane takes the columns that its row has, and the first one for the others. Without a row it
    // takes index 0.
    let mut picks = Picks::new(checked);
    assert!(!picks.set_rows(1, 0), "two columns are not four");
    for (lane, row, from) in [(0, 0, 0), (1, 1, 1), (2, 3, 0), (3, 0, usize::MAX)] {
        assert_eq!(picks.set_row(lane, row, from), row < 3);
    }
    picks.set_first(1, 2, 2);
    let table = [[0.0_f32], [1.0], [2.0]];
    let picked = picks.rows().of(&table).unwrap();
    let of = |lane| [0, 1, 2, 3].map(|which| picked.records(lane)[which][0]);
    assert_eq!(of(0), [1.0, 2.0, 1.0, 1.0]);
    assert_eq!(of(1), [0.0, 2.0, 2.0, 2.0]);
    assert_eq!((of(2), of(3)), ([0.0; 4], [1.0; 4]));
    // Four of four are read in place, three of four are not.
    let many = [2_u16; 64];
    for (columns, in_place) in [(4, true), (3, false)] {
        let checked = CheckedIndices::new(&many, columns, 4, 3).unwrap();
        assert_eq!(checked.in_place(0).is_some(), in_place);
        assert!(checked.in_place(1).is_none());
        assert_eq!(checked.all_in_place(1, 15, &table).is_some(), in_place);
        for (first, count) in [(0, 17), (1, 16), (16, 1), (17, 0), (1, usize::MAX)] {
            assert!(checked.all_in_place(first, count, &table).is_none());
        }
        assert!(checked.all_in_place(0, 1, &table[..2]).is_none(), "record 2 is not there");
    }
}

/// Rows of four indices of any type, which are read in the order of memory.
fn four_in_place<J: Index>(indices: [J; 12]) {
    let table = [0.0_f32, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0].map(|number| [number]);
    let checked = CheckedIndices::new(&indices, 4, 4, 8).unwrap();
    let picked = checked.all_in_place(1, 2, &table).unwrap();
    let of = |row| picked.records(row).map(|records| records.map(|&[number]| number));
    assert_eq!(of(0), Some([7.0, 0.0, 1.0, 5.0]));
    assert_eq!(of(1), Some([3.0, 3.0, 6.0, 2.0]));
    assert_eq!(of(2), None);
}

#[test]
fn rows_of_four_indices_name_their_records_in_order() {
    let indices = [4_u8, 4, 4, 4, 7, 0, 1, 5, 3, 3, 6, 2];
    four_in_place(indices);
    four_in_place(indices.map(u16::from));
    four_in_place(indices.map(u32::from));
}

#[test]
#[should_panic(expected = "no such components")]
fn picked_components_beyond_every_record_are_refused_and_not_read() {
    let checked = CheckedIndices::new(&[0_u8; 4], 4, 4, 1).unwrap();
    let picks = Picks::new(checked);
    let _: [f32x4; 4] =
        picks.rows().of(&[[1.0_f32; 8]]).unwrap().quads(Portable, 0, usize::MAX - 3);
}
