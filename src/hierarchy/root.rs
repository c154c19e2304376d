use super::run::Root;
use crate::scalar::DualQuat;
use crate::storage::{Element, Layout};

/// A [`Job`](super::Job) whose roots stand on nothing: their local pose is their model pose.
#[derive(Clone, Copy, Debug)]
pub struct NoRoot;

/// The base that root joints stand on, for models of `E`: nothing, one motion for all, or one each.
/// Sealed.
pub trait Roots<E: Element<8>>: sealed::Sealed {
    #[doc(hidden)]
    fn root(&self) -> Root<'_, E>;
    /// Their number, where each instance has its own.
    #[doc(hidden)]
    fn count(&self) -> Option<usize> {
        None
    }
}

impl<E: Element<8>> Roots<E> for NoRoot {
    fn root(&self) -> Root<'_, E> {
        Root::None
    }
}

impl<R, E: Element<8, Layout: Layout<Real = R>>> Roots<E> for DualQuat<R>
where
    DualQuat<R>: Copy,
{
    fn root(&self) -> Root<'_, E> {
        Root::Same(*self)
    }
}

impl<E: Element<8>> Roots<E> for &[E] {
    fn root(&self) -> Root<'_, E> {
        Root::Each(self)
    }
    fn count(&self) -> Option<usize> {
        Some(self.len())
    }
}

impl<E: Element<8>> Roots<E> for Root<'_, E> {
    fn root(&self) -> Root<'_, E> {
        self.clone()
    }
    fn count(&self) -> Option<usize> {
        if let Self::Each(roots) = self { Some(roots.len()) } else { None }
    }
}

mod sealed {
    use super::{DualQuat, Element, NoRoot, Root};
    pub trait Sealed {}
    impl Sealed for NoRoot {}
    impl<R> Sealed for DualQuat<R> {}
    impl<E> Sealed for &[E] {}
    impl<E: Element<8>> Sealed for Root<'_, E> {}
}
