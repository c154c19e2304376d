//! Macros that define a function for a kernel over slices. The function is generic over the layout
//! of its arrays: plain or in blocks.

/// Defines the function of a kernel that reads arrays and writes an array. The integer after an
/// array's name is the count of components of an element. One more argument may follow the arrays.
/// The expression after its `=` converts the argument from its type in C to the type that the
/// kernel takes.
macro_rules! kernel {
    (
        $name:ident($($from:ident: $size:tt),+ $(; $more:ident: $type:ty $(= $known:expr)?)?)
            -> $out:tt by $kernel:ident
    ) => {
        /// # Safety
        /// Each array must have `count` elements. No other thread may use the output or write the
        /// inputs during the call.
        pub(super) unsafe fn $name<L: Layout>(
            $($from: *const L::Real,)+
            $($more: $type,)?
            out: *mut L::Real,
            count: usize,
        ) -> Done {
            $($(let $more = $known;)?)?
            $(let $from = crate::memory::Input::<L::Record<$size>>::new($from, count)?;)+
            let out = crate::memory::Output::<L::Record<$out>>::new(out, count)?;
            crate::span::disjoint(&[out.span], &[$($from.span),+])?;
            // SAFETY: the caller guarantees that each array has `count` elements, and `disjoint`
            // has checked that `out` overlaps no input.
            let (($($from,)+), out) = unsafe { (($($from.slice(),)+), out.slice()) };
            Ok(dq8::Backend::best().$kernel($($from,)+ $($more,)? out)?)
        }
    };
}

/// Defines the function of a kernel that reads an array and writes an array of the same records. If
/// C passes the same array for both, the function calls the kernel `$in_place`. Both kernels may
/// take further arrays, or one motion before the arrays.
macro_rules! kernel_or_in_place {
    (
        $name:ident($from:ident: $size:tt $(, $other:ident: $others:tt)*) $(of one $motion:ident)?
            by $kernel:ident, $in_place:ident
    ) => {
        /// # Safety
        /// Each array must have `count` elements, and `$motion`, if there is one, must point to a
        /// motion. No other thread may use the output or write the inputs during the call.
        pub(super) unsafe fn $name<L: Layout>(
            $($motion: *const L::Real,)?
            $from: *const L::Real,
            $($other: *const L::Real,)*
            out: *mut L::Real,
            count: usize,
        ) -> Done {
            let best = dq8::Backend::best();
            $(
                let one = crate::span::Span::of($motion.cast::<dq8::DualQuat<L::Real>>(), 1)?;
                let to = crate::memory::Output::<L::Record<$size>>::new(out, count)?;
                crate::span::disjoint(&[to.span], &[one])?;
                // SAFETY: the caller guarantees that the pointer points to a motion, and `Span::of`
                // has checked that it is neither null nor misaligned.
                let $motion: dq8::DualQuat<L::Real> = unsafe { crate::memory::read($motion)? };
            )?
            $(
                let $other = crate::memory::Input::<L::Record<$others>>::new($other, count)?;
                let to = crate::memory::Output::<L::Record<$size>>::new(out, count)?;
                crate::span::disjoint(&[to.span], &[$other.span])?;
                // SAFETY: the caller guarantees that this array has `count` elements, and
                // `disjoint` has checked that the output does not overlap it.
                let $other = unsafe { $other.slice() };
            )*
            let elsewhere =
                |from: &[_], to: &mut [_]| best.$kernel($($motion,)? from, $($other,)* to);
            let in_place = |all: &mut [L::Record<$size>]| {
                done!(best.$in_place($($motion,)? all $(, $other)*); $($other)*)
            };
            // SAFETY: the caller guarantees that both arrays have `count` elements, and that no
            // other thread uses them.
            unsafe { crate::memory::from_to($from, out, count, elsewhere, in_place) }
        }
    };
}

/// Expands to the result of a call in place. Such a call returns a `Result` only if the kernel
/// takes further arrays, whose lengths may be wrong.
macro_rules! done {
    ($call:expr;) => {{
        $call;
        Ok(())
    }};
    ($call:expr; $($other:ident)+) => {
        $call
    };
}
