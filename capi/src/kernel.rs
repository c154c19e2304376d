//! Macros that write the generic function, plain or in blocks, that a kernel over slices is in C.

/// Of a kernel that makes arrays, of so many numbers per element, into another. After them may come
/// one thing more, which C may pass as something else: `= …` says what it stands for.
macro_rules! kernel {
    (
        $name:ident($($from:ident: $size:literal),+ $(; $more:ident: $type:ty $(= $known:expr)?)?)
            -> $out:literal by $kernel:ident
    ) => {
        /// # Safety
        /// As for [`Input::slice`](crate::memory::Input::slice) and
        /// [`Output::slice`](crate::memory::Output::slice).
        unsafe fn $name<L: Layout>(
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

/// Of a kernel that makes an array into another, and of its sibling for where the two are one; both
/// may take one motion first.
macro_rules! kernel_or_in_place {
    (
        $name:ident($from:ident: $size:literal) $(of one $motion:ident)?
            by $kernel:ident, $in_place:ident
    ) => {
        /// # Safety
        /// As for [`from_to`](crate::memory::from_to) and, of one motion,
        /// [`read`](crate::memory::read).
        unsafe fn $name<L: Layout>(
            $($motion: *const L::Real,)?
            $from: *const L::Real,
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
            let apart = |from: &[_], to: &mut [_]| best.$kernel($($motion,)? from, to);
            let in_place = |all: &mut [L::Record<$size>]| {
                best.$in_place($($motion,)? all);
                Ok(())
            };
            // SAFETY: promised.
            unsafe { crate::memory::from_to($from, out, count, apart, in_place) }
        }
    };
}
