//! Macros that define the function for both layouts, plain and blocks, of a kernel over slices.

/// Defines the function of a kernel from arrays to an array. The numbers are those of each element.
/// After the arrays, there may be one more argument; `= …` converts it from what C passes to what
/// the kernel takes.
macro_rules! kernel {
    (
        $name:ident($($from:ident: $size:tt),+ $(; $more:ident: $type:ty $(= $known:expr)?)?)
            -> $out:tt by $kernel:ident
    ) => {
        /// # Safety
        /// The caller must keep the conditions of [`Input::slice`](crate::memory::Input::slice) and
        /// [`Output::slice`](crate::memory::Output::slice).
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
            // SAFETY: the caller guarantees that the memory is valid, and the outputs have been
            // checked to overlap nothing.
            let (($($from,)+), out) = unsafe { (($($from.slice(),)+), out.slice()) };
            Ok(dq8::Backend::best().$kernel($($from,)+ $($more,)? out)?)
        }
    };
}

/// Defines the function of a kernel from one array to another of the same records, and of its
/// sibling in place, which is called if C passes the same array twice. Both may take other arrays
/// as well, or one motion first.
macro_rules! kernel_or_in_place {
    (
        $name:ident($from:ident: $size:tt $(, $other:ident: $others:tt)*) $(of one $motion:ident)?
            by $kernel:ident, $in_place:ident
    ) => {
        /// # Safety
        /// The caller must keep the conditions of [`from_to`](crate::memory::from_to); for one
        /// motion [`read`](crate::memory::read), and for other arrays
        /// [`Input::slice`](crate::memory::Input::slice).
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
                // SAFETY: the caller keeps the conditions under `# Safety`, which are those of the
                // functions called here.
                let $motion: dq8::DualQuat<L::Real> = unsafe { crate::memory::read($motion)? };
            )?
            $(
                let $other = crate::memory::Input::<L::Record<$others>>::new($other, count)?;
                let to = crate::memory::Output::<L::Record<$size>>::new(out, count)?;
                crate::span::disjoint(&[to.span], &[$other.span])?;
                // SAFETY: the caller guarantees that the memory is valid, and the outputs have been
                // checked to overlap nothing.
                let $other = unsafe { $other.slice() };
            )*
            let elsewhere =
                |from: &[_], to: &mut [_]| best.$kernel($($motion,)? from, $($other,)* to);
            let in_place = |all: &mut [L::Record<$size>]| {
                done!(best.$in_place($($motion,)? all $(, $other)*); $($other)*)
            };
            // SAFETY: the caller keeps the conditions under `# Safety`, which are those of the
            // functions called here.
            unsafe { crate::memory::from_to($from, out, count, elsewhere, in_place) }
        }
    };
}

/// A call in place, which can fail only where there are other arrays.
macro_rules! done {
    ($call:expr;) => {{
        $call;
        Ok(())
    }};
    ($call:expr; $($other:ident)+) => {
        $call
    };
}
