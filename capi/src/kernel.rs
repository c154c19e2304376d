//! Macros that write the generic function, plain or in blocks, that a kernel over slices is in C.

/// Of a kernel that makes arrays, of so many numbers per element, into another. After them may come
/// one thing more, which C may pass as something else: `= …` says what it stands for.
macro_rules! kernel {
    (
        $name:ident($($from:ident: $size:tt),+ $(; $more:ident: $type:ty $(= $known:expr)?)?)
            -> $out:tt by $kernel:ident
    ) => {
        /// # Safety
        /// As for [`Input::slice`](crate::memory::Input::slice) and
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
            crate::span::apart(&[out.span], &[$($from.span),+])?;
            // SAFETY: promised, and apart.
            let (($($from,)+), out) = unsafe { (($($from.slice(),)+), out.slice()) };
            Ok(dq8::Backend::best().$kernel($($from,)+ $($more,)? out)?)
        }
    };
}

/// Of a kernel that makes an array into another of the same records, and of its sibling for where
/// the two are one. Both may take other arrays beside it, or one motion first.
macro_rules! kernel_or_in_place {
    (
        $name:ident($from:ident: $size:tt $(, $other:ident: $others:tt)*) $(of one $motion:ident)?
            by $kernel:ident, $in_place:ident
    ) => {
        /// # Safety
        /// As for [`from_to`](crate::memory::from_to) and, of one motion,
        /// [`read`](crate::memory::read), of other arrays
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
                crate::span::apart(&[to.span], &[one])?;
                // SAFETY: promised.
                let $motion: dq8::DualQuat<L::Real> = unsafe { crate::memory::read($motion)? };
            )?
            $(
                let $other = crate::memory::Input::<L::Record<$others>>::new($other, count)?;
                let to = crate::memory::Output::<L::Record<$size>>::new(out, count)?;
                crate::span::apart(&[to.span], &[$other.span])?;
                // SAFETY: promised, and apart.
                let $other = unsafe { $other.slice() };
            )*
            let apart = |from: &[_], to: &mut [_]| best.$kernel($($motion,)? from, $($other,)* to);
            let in_place = |all: &mut [L::Record<$size>]| {
                done!(best.$in_place($($motion,)? all $(, $other)*); $($other)*)
            };
            // SAFETY: promised.
            unsafe { crate::memory::from_to($from, out, count, apart, in_place) }
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
