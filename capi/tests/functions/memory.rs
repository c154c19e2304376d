//! The arrays of a call, each with memory of its own, aligned no more than it must be. Those of
//! random calls have just so many bytes, so that the address sanitizer sees what is read or written
//! beyond.

use crate::argument::{Contents, Value};
use crate::function::Function;
use dq8_fixtures::random::Random;
use std::alloc::{Layout, alloc_zeroed, dealloc, handle_alloc_error};
use std::ptr::null_mut;

/// A cache line: no array is aligned to more.
const LINE: usize = 64;

/// The bytes after an array of a call that is not random: as many as a wrong length may add.
const BEHIND: usize = 4096;

/// The memory of an array of `bytes` bytes, with memory before it, and perhaps after it.
struct Room {
    layout: Layout,
    base: *mut u8,
    start: *mut u8,
    bytes: usize,
}

impl Room {
    fn new(before: usize, bytes: usize, behind: usize) -> Self {
        let layout = Layout::from_size_align(before + bytes + behind, LINE).expect("a size");
        // SAFETY: something is before it.
        let base = unsafe { alloc_zeroed(layout) };
        if base.is_null() {
            handle_alloc_error(layout);
        }
        Self { layout, base, start: base.wrapping_add(before), bytes }
    }
    fn copy(&self) -> Self {
        let before = self.start.addr() - self.base.addr();
        let room = Self::new(before, self.bytes, self.layout.size() - before - self.bytes);
        // SAFETY: as long.
        unsafe { room.base.copy_from(self.base, self.layout.size()) };
        room
    }
    fn array(&self) -> &[u8] {
        // SAFETY: so many bytes, all of which have been written.
        unsafe { std::slice::from_raw_parts(self.start, self.bytes) }
    }
    fn all(&self) -> &[u8] {
        // SAFETY: as above.
        unsafe { std::slice::from_raw_parts(self.base, self.layout.size()) }
    }
}

impl Drop for Room {
    fn drop(&mut self) {
        // SAFETY: from `alloc_zeroed`, with this layout.
        unsafe { dealloc(self.base, self.layout) };
    }
}

/// A function, and what it is given: change it to make it wrong.
pub(crate) struct Call<'f> {
    pub(crate) function: &'f Function,
    pub(crate) given: Vec<Value>,
    /// The memory of each argument that is an array.
    rooms: Vec<Option<Room>>,
}

impl<'f> Call<'f> {
    pub(crate) fn new(function: &'f Function, mut random: Option<&mut Random>) -> Self {
        let mut rooms: Vec<_> = function.arguments.iter().map(|_| None).collect();
        let mut given = vec![Value::Pointer(null_mut()); rooms.len()];
        for (at, scalar) in function.scalars() {
            given[at] = scalar.values.first().expect("a number").clone();
        }
        for (at, array) in function.arrays() {
            // There are as many bytes before an array as its alignment, so it has no greater one.
            let behind = if random.is_some() { 0 } else { BEHIND };
            let room = Room::new(array.align, array.bytes, behind);
            let contents = random.as_deref_mut().map_or(Contents::Sample(at), Contents::Random);
            (array.fill)(room.start, contents);
            // An optional array without elements is passed as null.
            let is_there = array.bytes > 0 || array.group.is_none();
            given[at] = Value::Pointer(if is_there { room.start } else { null_mut() });
            rooms[at] = Some(room);
        }
        Self { function, given, rooms }
    }
    /// The same in other memory, before anything else is passed.
    pub(crate) fn copy(&self) -> Self {
        let rooms: Vec<_> = self.rooms.iter().map(|room| room.as_ref().map(Room::copy)).collect();
        let given = self.given.iter().zip(&rooms).map(|(value, room)| match (value, room) {
            (Value::Pointer(start), Some(room)) if !start.is_null() => Value::Pointer(room.start),
            _ => value.clone(),
        });
        Self { function: self.function, given: given.collect(), rooms }
    }
    fn room(&self, at: usize) -> &Room {
        self.rooms[at].as_ref().expect("an array")
    }
    /// The start of the array, whatever pointer is passed for it.
    pub(crate) fn start(&self, at: usize) -> *mut u8 {
        self.room(at).start
    }
    /// The memory before and after the array of each argument. It is empty for a call in which one
    /// array has been moved onto another.
    pub(crate) fn around(&self) -> Vec<[Vec<u8>; 2]> {
        if self.function.arrays().any(|(at, _)| self.rooms[at].is_none()) {
            return Vec::new();
        }
        let around = |room: &Option<Room>| {
            room.as_ref().map_or([const { Vec::new() }; 2], |room| {
                let (before, rest) = room.all().split_at(room.start.addr() - room.base.addr());
                [before.to_vec(), rest[room.bytes..].to_vec()]
            })
        };
        self.rooms.iter().map(around).collect()
    }
    /// The contents of the memory of each argument, and of what is around it.
    pub(crate) fn now(&self) -> Vec<Vec<u8>> {
        let all =
            |room: &Option<Room>| room.as_ref().map_or(Vec::new(), |room| room.all().to_vec());
        self.rooms.iter().map(all).collect()
    }
    pub(crate) fn pass(&mut self, at: usize, start: *mut u8) {
        self.given[at] = Value::Pointer(start);
    }
    /// An input and an output that are one array.
    pub(crate) fn join(&mut self, input: usize, output: usize) {
        let (from, to) = (self.room(input).array(), self.start(output));
        // SAFETY: they have as many elements.
        unsafe { to.copy_from(from.as_ptr(), from.len()) };
        self.given[input] = self.given[output].clone();
    }
    /// The argument `at`, `offset` bytes from where the array `to` begins, with memory all around.
    pub(crate) fn slide(&mut self, at: usize, to: usize, offset: isize) {
        let (own, other) = (self.room(at).array().to_vec(), self.room(to).array().to_vec());
        let around = own.len().next_multiple_of(LINE) + LINE;
        let room = Room::new(around, other.len(), around);
        let slid = room.start.wrapping_offset(offset);
        // SAFETY: there is room for both.
        unsafe {
            room.start.copy_from(other.as_ptr(), other.len());
            slid.copy_from(own.as_ptr(), own.len());
        }
        // What is passed there too moves with it.
        let before = self.given[to].pointer();
        for value in &mut self.given {
            if matches!(value, Value::Pointer(start) if *start == before) {
                *value = Value::Pointer(room.start);
            }
        }
        self.pass(at, slid);
        self.rooms[to] = Some(room);
        self.rooms[at] = None;
    }
}
