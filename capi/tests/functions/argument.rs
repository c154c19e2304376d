//! The arguments of a C function: arrays, and numbers that are passed by value.

use crate::element::Element;
use dq8_capi::Status;
use dq8_capi::mesh::VertexFields;
use dq8_capi::skin::InfluenceField;
use dq8_fixtures::random::Random;
use std::any::Any;
use std::marker::PhantomData;
use std::rc::Rc;

/// The value of an argument in a call.
#[derive(Clone)]
pub(crate) enum Value {
    Pointer(*mut u8),
    Scalar(Rc<dyn Any>),
}

impl Value {
    pub(crate) fn pointer(&self) -> *mut u8 {
        match self {
            Self::Pointer(start) => *start,
            Self::Scalar(_) => unreachable!("a number is no array"),
        }
    }
}

/// A parameter of a C function.
pub(crate) trait Parameter {
    fn of(value: &Value) -> Self;
}

impl<T> Parameter for *const T {
    fn of(value: &Value) -> Self {
        value.pointer().cast()
    }
}

impl<T> Parameter for *mut T {
    fn of(value: &Value) -> Self {
        value.pointer().cast()
    }
}

macro_rules! scalars {
    ($($T:ty)*) => {$(
        impl Parameter for $T {
            fn of(value: &Value) -> Self {
                match value {
                    Value::Scalar(value) => *value.downcast_ref().expect("its type"),
                    Value::Pointer(_) => unreachable!("an array is no number"),
                }
            }
        }
    )*};
}
scalars! { usize i32 u32 f32 f64 VertexFields InfluenceField }

/// An argument, whatever its type.
pub(crate) struct Argument {
    pub(crate) name: &'static str,
    pub(crate) kind: Kind,
}

pub(crate) enum Kind {
    Array(Array),
    Scalar(Scalar),
}

/// A number: the values that a call may have, and the ones that are refused.
pub(crate) struct Scalar {
    pub(crate) values: Vec<Value>,
    pub(crate) wrong: Vec<(Value, Status)>,
}

/// The contents of an array before the call.
pub(crate) enum Contents<'r> {
    /// The contents that [`Element::sample`] or the table makes of the number of the argument.
    Sample(usize),
    /// Random contents, except for what the function checks.
    Random(&'r mut Random),
}

type Fill = Rc<dyn Fn(*mut u8, Contents<'_>)>;
type Change = Rc<dyn Fn(*mut u8)>;

/// Contents that are refused, and the index that the function returns.
pub(crate) struct Fault {
    pub(crate) status: Status,
    pub(crate) index: Option<usize>,
    pub(crate) change: Change,
}

pub(crate) struct Array {
    pub(crate) bytes: usize,
    pub(crate) align: usize,
    pub(crate) writes: bool,
    /// The input that this output may be, if it is exactly the same array.
    pub(crate) over: Option<&'static str>,
    /// True for an output that may overlap inputs, because these are read before it is written.
    pub(crate) free: bool,
    /// True for an output whose contents after the call are unspecified.
    pub(crate) untold: bool,
    /// True for an output that may be written even if the call is refused.
    pub(crate) scratch: bool,
    /// True for an output that is set to the index that is wrong, if one is.
    pub(crate) names: bool,
    /// The group of arrays that may be null together.
    pub(crate) group: Option<u8>,
    /// The memory that its elements point to.
    pub(crate) keeps: Vec<(*mut u8, usize)>,
    pub(crate) fill: Fill,
    pub(crate) bits: Rc<dyn Fn(*const u8) -> Vec<u64>>,
    pub(crate) faults: Vec<Fault>,
}

impl Array {
    /// What is in the memory that something in it points to.
    pub(crate) fn kept(&self) -> impl Iterator<Item = Vec<u8>> {
        // SAFETY: it is there as long as the table.
        let kept = |(start, bytes)| unsafe { std::slice::from_raw_parts::<u8>(start, bytes) };
        self.keeps.iter().map(move |&(start, bytes)| kept((start.cast_const(), bytes)).to_vec())
    }
}

/// An array of `T`, while the table describes it.
pub(crate) struct Of<T, V> {
    count: usize,
    pub(crate) array: Array,
    marker: PhantomData<(T, V)>,
}

/// The two ways in which the Rust function borrows an array.
pub(crate) struct Read;
pub(crate) struct Written;

fn array<T: Element, V>(count: usize, writes: bool) -> Of<T, V> {
    let fill = move |start: *mut u8, contents: Contents<'_>| {
        let start = start.cast::<T>();
        match contents {
            // C need not initialize an output.
            // SAFETY: the array has so many elements, here and below.
            Contents::Sample(_) if writes => unsafe { start.write_bytes(0x3f, count) },
            Contents::Sample(seed) => fill_by(start, count, |at| T::sample(at, seed)),
            Contents::Random(random) => match random.below(2) {
                0 => fill_by(start, count, |_| T::random(random)),
                _ => {
                    let seed = random.below(99);
                    fill_by(start, count, |at| T::sample(at, seed));
                }
            },
        }
    };
    let bits = move |start: *const u8| {
        let mut bits = Vec::new();
        // SAFETY: as above.
        (0..count).for_each(|at| unsafe { (*start.cast::<T>().add(at)).bits(&mut bits) });
        bits
    };
    let array = Array {
        bytes: count * size_of::<T>(),
        align: align_of::<T>(),
        writes,
        over: None,
        free: false,
        untold: false,
        scratch: false,
        names: false,
        group: None,
        keeps: Vec::new(),
        fill: Rc::new(fill),
        bits: Rc::new(bits),
        faults: Vec::new(),
    };
    Of { count, array, marker: PhantomData }
}

fn fill_by<T>(start: *mut T, count: usize, mut of: impl FnMut(usize) -> T) {
    // SAFETY: the array has so many elements.
    (0..count).for_each(|at| unsafe { start.add(at).write(of(at)) });
}

pub(crate) fn reads<T: Element>(count: usize) -> Of<T, Read> {
    array(count, false)
}

pub(crate) fn writes<T: Element>(count: usize) -> Of<T, Written> {
    array(count, true)
}

/// An output that is set to the index that is wrong.
pub(crate) fn names() -> Of<usize, Written> {
    let mut names = writes(1).unless_null(u8::MAX);
    names.array.names = true;
    names
}

impl<T: Element, V> Of<T, V> {
    /// Sets the contents of samples; random calls have random contents.
    pub(crate) fn of(self, of: impl Fn(usize) -> T + 'static) -> Self {
        let (count, any) = (self.count, self.array.fill);
        let fill = move |start: *mut u8, contents: Contents<'_>| match contents {
            Contents::Sample(_) => fill_by(start.cast(), count, &of),
            Contents::Random(_) => any(start, contents),
        };
        Self { array: Array { fill: Rc::new(fill), ..self.array }, ..self }
    }
    /// Sets the contents of all calls.
    pub(crate) fn only(self, of: impl Fn(usize) -> T + 'static) -> Self {
        let count = self.count;
        let fill = move |start: *mut u8, _: Contents<'_>| fill_by(start.cast(), count, &of);
        Self { array: Array { fill: Rc::new(fill), ..self.array }, ..self }
    }
    /// Adds contents that are refused, if there are elements.
    pub(crate) fn fault(
        mut self,
        status: Status,
        index: Option<usize>,
        change: impl Fn(&mut [T]) + 'static,
    ) -> Self {
        let count = self.count;
        if index.is_some_and(|index| index >= count) || count == 0 {
            return self;
        }
        let change: Change = Rc::new(move |start| {
            // SAFETY: the array has so many elements.
            change(unsafe { std::slice::from_raw_parts_mut(start.cast(), count) });
        });
        self.array.faults.push(Fault { status, index, change });
        self
    }
    /// Adds contents that are refused with an index that is not one of this array.
    pub(crate) fn fault_through(
        self,
        status: Status,
        index: usize,
        change: impl Fn(&mut [T]) + 'static,
    ) -> Self {
        let mut changed = self.fault(status, None, change);
        if let Some(fault) = changed.array.faults.last_mut() {
            fault.index = Some(index);
        }
        changed
    }
    pub(crate) fn unless_null(self, group: u8) -> Self {
        Self { array: Array { group: Some(group), ..self.array }, ..self }
    }
    pub(crate) fn keeps(self, keeps: Vec<(*mut u8, usize)>) -> Self {
        Self { array: Array { keeps, ..self.array }, ..self }
    }
    pub(crate) fn over(self, over: &'static str) -> Self {
        Self { array: Array { over: Some(over), ..self.array }, ..self }
    }
    pub(crate) fn free(self) -> Self {
        Self { array: Array { free: true, ..self.array }, ..self }
    }
    pub(crate) fn untold(self) -> Self {
        Self { array: Array { untold: true, ..self.array }, ..self }
    }
    pub(crate) fn scratch(self) -> Self {
        Self { array: Array { untold: true, scratch: true, ..self.array }, ..self }
    }
}

/// An argument of the table: what it is for any test, and what the Rust function has of it.
pub(crate) trait Role {
    type View;
    fn push(self, name: &'static str, to: &mut Vec<Argument>) -> Self::View;
}

pub(crate) trait View {
    type Seen;
    /// # Safety
    /// The array is as long as was said, and nothing else has it.
    unsafe fn see(&self, value: &Value) -> Self::Seen;
}

/// Arrays as the Rust function has them: empty where C has null.
pub(crate) struct Slice<T, V>(usize, PhantomData<(T, V)>);

impl<T: 'static, V> Role for Of<T, V> {
    type View = Slice<T, V>;
    fn push(self, name: &'static str, to: &mut Vec<Argument>) -> Slice<T, V> {
        to.push(Argument { name, kind: Kind::Array(self.array) });
        Slice(self.count, PhantomData)
    }
}

impl<T: 'static> View for Slice<T, Read> {
    type Seen = &'static [T];
    unsafe fn see(&self, value: &Value) -> &'static [T] {
        match value.pointer() {
            null if null.is_null() => &[],
            // SAFETY: promised.
            start => unsafe { std::slice::from_raw_parts(start.cast(), self.0) },
        }
    }
}

impl<T: 'static> View for Slice<T, Written> {
    type Seen = &'static mut [T];
    unsafe fn see(&self, value: &Value) -> &'static mut [T] {
        match value.pointer() {
            null if null.is_null() => &mut [],
            // SAFETY: promised.
            start => unsafe { std::slice::from_raw_parts_mut(start.cast(), self.0) },
        }
    }
}

/// A number, while the table describes it.
pub(crate) struct Passed<T> {
    scalar: Scalar,
    marker: PhantomData<T>,
}

/// A number that may be any of these values.
pub(crate) fn one_of<T: 'static>(values: impl IntoIterator<Item = T>) -> Passed<T> {
    let values = values.into_iter().map(|value| Value::Scalar(Rc::new(value))).collect();
    Passed { scalar: Scalar { values, wrong: Vec::new() }, marker: PhantomData }
}

pub(crate) fn passes<T: 'static>(value: T) -> Passed<T> {
    one_of([value])
}

/// The length of an array whose elements have four bytes or more.
pub(crate) fn count(count: usize) -> Passed<usize> {
    let beyond = [isize::MAX as usize / 4 + 1, usize::MAX / 4, usize::MAX];
    beyond.into_iter().fold(passes(count), |passed, beyond| passed.wrong(beyond, Status::TooLarge))
}

pub(crate) fn lanes<R>(lanes: usize) -> Passed<usize> {
    let none = [0, 5, size_of::<R>() * 2 - 4, usize::MAX];
    let passed = none.into_iter().fold(passes(lanes), |all, none| all.wrong(none, Status::Lanes));
    // Blocks of the other number type may have these.
    passed.wrong(if size_of::<R>() == 4 { 4 } else { 16 }, Status::Lanes)
}

impl<T: 'static> Passed<T> {
    pub(crate) fn wrong(mut self, value: T, status: Status) -> Self {
        self.scalar.wrong.push((Value::Scalar(Rc::new(value)), status));
        self
    }
    pub(crate) fn wrong_if(self, is_wrong: bool, value: T, status: Status) -> Self {
        if is_wrong { self.wrong(value, status) } else { self }
    }
}

/// The number that is passed.
pub(crate) struct Number<T>(PhantomData<T>);

impl<T> Role for Passed<T> {
    type View = Number<T>;
    fn push(self, name: &'static str, to: &mut Vec<Argument>) -> Number<T> {
        to.push(Argument { name, kind: Kind::Scalar(self.scalar) });
        Number(PhantomData)
    }
}

impl<T: Parameter> View for Number<T> {
    type Seen = T;
    unsafe fn see(&self, value: &Value) -> T {
        T::of(value)
    }
}
