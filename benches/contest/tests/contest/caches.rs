//! Sizes of caches, and of what fills them.

use dq8_contest::caches::{Caches, Footprint, Level, bytes};

#[test]
fn sizes_as_linux_writes_them() {
    assert_eq!(bytes("48K"), Some(48 << 10));
    assert_eq!(bytes("2M"), Some(2 << 20));
    assert_eq!(bytes("64"), Some(64));
    assert_eq!(bytes("many"), None);
    assert_eq!(bytes(""), None);
}

#[test]
fn every_level_holds_more_than_the_one_before() {
    let caches = Caches { l1: 48 << 10, l2: 2 << 20, l3: 32 << 20 };
    let footprint = Footprint { own: 96, most: 192 };
    let [l1, l2, l3, dram] = Level::ALL.map(|level| caches.transforms(level, footprint));
    assert_eq!(l1, 192);
    assert!(l2 * 96 > caches.l1 && l2 * 192 < caches.l2);
    assert!(l3 * 96 > caches.l2 && l3 * 96 < caches.l3);
    assert!(dram * 96 > caches.l3);
}
