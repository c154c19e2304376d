//! Pointers that are wrong in every way, and what must come of them.

/// Numbers at a multiple of 64 bytes, enough for three blocks of anything.
#[repr(C, align(64))]
#[derive(Clone)]
pub(crate) struct Memory<R>(pub(crate) [R; 3 * 16 * 16]);

/// A number type, and a unit motion everywhere: blocks of it are no motions, but finite.
macro_rules! memory {
    ($R:ident) => {
        Memory::<$R>(std::array::from_fn(|i| if i % 8 == 3 { 1.0 } else { 0.0 }))
    };
}

/// What a buffer holds, which C has a pointer to as well.
pub(crate) fn now<R: Copy, const N: usize>(buffer: *const R) -> [R; N] {
    // SAFETY: the tests call this with buffers that are alive, and so long.
    unsafe { buffer.cast::<[R; N]>().read() }
}

/// What may happen to the last pointer, the output.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Aliasing {
    /// It may lie anywhere.
    Free,
    /// It may be the input of this number.
    InPlace(usize),
    /// It must be apart from all inputs.
    Apart,
}

/// Calls with pointers that are wrong: whether the output may lie on an input, all pointers, the output last, and the call.
macro_rules! refuses {
    ($R:ident: $($aliasing:expr, |[$($pointer:ident),+]| $call:expr;)+) => {$({
        const POINTERS: usize = [$(stringify!($pointer)),+].len();
        let call: &dyn Fn([*mut $R; POINTERS]) -> Status = &|[$($pointer),+]| $call;
        let aliasing: Aliasing = $aliasing;
        let name = concat!(stringify!($call), " ", stringify!($R));
        // How far into an input an output overlaps it, aligned as blocks must be.
        let into =
            if name.contains("pack") || name.contains("blocks") { 64 } else { size_of::<$R>() };
        let before: Vec<_> = (0..POINTERS).map(|_| memory!($R)).collect();
        let mut buffers = before.clone();
        let good: [*mut $R; POINTERS] = {
            let mut starts = buffers.iter_mut().map(|buffer| buffer.0.as_mut_ptr());
            std::array::from_fn(|_| starts.next().unwrap())
        };
        let refused = |pointers, wanted, what: &str| {
            assert_eq!(call(pointers), wanted, "{name}: {what}");
            for (buffer, before) in good.iter().zip(&before) {
                assert_eq!(now(*buffer), before.0, "{name}: {what}: something was written");
            }
        };
        for at in 0..POINTERS {
            let mut pointers = good;
            pointers[at] = ptr::null_mut();
            refused(pointers, Status::NullPointer, &format!("argument {at} null"));
            pointers[at] = good[at].wrapping_byte_add(2);
            refused(pointers, Status::Misaligned, &format!("argument {at} misaligned"));
            let output = POINTERS - 1;
            if at != output && aliasing != Aliasing::Free {
                let mut pointers = good;
                pointers[output] = good[at].wrapping_byte_add(into);
                refused(pointers, Status::Overlap, &format!("output within argument {at}"));
                if aliasing != Aliasing::InPlace(at) {
                    pointers[output] = good[at];
                    refused(pointers, Status::Overlap, &format!("output is argument {at}"));
                }
            }
        }
        assert_eq!(call(good), Status::Ok, "{name}");
        if let Aliasing::InPlace(at) = aliasing {
            let mut pointers = good;
            pointers[POINTERS - 1] = good[at];
            assert_eq!(call(pointers), Status::Ok, "{name}: in place");
        }
    })+};
}
