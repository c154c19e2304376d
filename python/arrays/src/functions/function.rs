//! [`function!`]: a function of Python, from the law that it computes for each element.

/// A function on arrays as Python has it, with the [`Law`](crate::law::Law) of its elements and its
/// docstring.
///
/// Each parameter has the name that Python knows and the shape of one element: `[]` of a number,
/// `[4, 4]` of a matrix. In the body it is the numbers of one element on lanes, in one array:
/// `[L; 8]` where the shape is `[8]`, `[L; 1]` where it is `[]`. So is the result.
///
/// The docstring is in the order in which it is written: what is said of the function, of each
/// parameter (of several that share a shape, `a, b: [8]`), and of the result, with everything that
/// may follow. In between comes what is the same for all functions: headings, shapes, `out`, the
/// dtype.
macro_rules! function {
    (
        $(#[doc = $about:tt])*
        // As in the trait.
        $(const WIDE: bool = $wide:literal;)?
        // The method of `Backend` for one motion and many other arguments, if there is one.
        $(one motion: $of_one:ident;)?
        // What the first argument is refused for, unless the caller says not to look.
        $(refuse $fault:ident if $check:ident;)?
        fn $name:ident(
            $(
                $(#[doc = $of:tt])*
                // In errors a parameter may have another name.
                $($parameter:ident $(as $called:literal)?),+ : $shape:tt
            ),+ $(,)?
            $(; out $may:literal)?
        ) -> $result:tt
        $(#[doc = $of_result:tt])*
        $body:block
    ) => {
        $(#[doc = $about])*
        ///
        /// Parameters
        /// ----------
        $(
            #[doc = concat!(stringify!($($parameter),+), " : array_like, shape ", function!(@shape $shape))]
            $(#[doc = concat!("   ", $of)])*
        )+
        $(
            #[doc = concat!(stringify!($check), " : bool, optional")]
            ///     ValueError names the first that is not unit. False takes all as they are.
        )?
        /// out : ndarray, optional
        #[doc = concat!("    Where to write the result", $($may,)? ".")]
        ///
        /// Returns
        /// -------
        #[doc = concat!("ndarray, shape ", function!(@shape $result))]
        #[doc = common_dtype!()]
        $(#[doc = $of_result])*
        #[pyfunction]
        #[pyo3(signature = ($($($parameter,)+)+ *, $($check=true,)? out=None))]
        pub fn $name<'py>(
            py: Python<'py>,
            $($($parameter: &Bound<'py, PyAny>,)+)+
            $($check: bool,)?
            out: Option<&Bound<'py, PyAny>>,
        ) -> Answer<'py> {
            #[derive(Clone, Copy)]
            struct Of;
            function! {
                @law [$(const WIDE: bool = $wide;)?] [$($of_one)?] $result $body
                $($(($parameter $shape))+)+ (_ [0]) (_ [0])
            }
            let arguments = Argument::all(&[$($(
                ([$($called,)? stringify!($parameter)][0], &$shape, $parameter),
            )+)+])?;
            $(if $check {
                if is_single(&arguments) {
                    refuse::<f32, _, _>(&arguments[0], $fault)?;
                } else {
                    refuse::<f64, _, _>(&arguments[0], $fault)?;
                }
            })?
            call(py, Of, &arguments, &$result, out)
        }
    };

    // As NumPy's documentation writes it: (..., 8).
    (@shape [$($size:literal),*]) => { concat!("(...", $(", ", $size,)* ")") };

    // A law has three arguments; those that are not there have no numbers.
    (
        @law [$($wide:tt)*] [$($of_one:ident)?] $result:tt $body:block
        ($a:tt $of_a:tt) ($b:tt $of_b:tt) ($c:tt $of_c:tt) $((_ [0]))*
    ) => {
        impl Law<{ size(&$of_a) }, { size(&$of_b) }, { size(&$of_c) }, { size(&$result) }> for Of {
            $($wide)*
            #[inline(always)]
            fn of<L: Lanes>(
                self,
                $a: [L; size(&$of_a)],
                $b: [L; size(&$of_b)],
                $c: [L; size(&$of_c)],
            ) -> [L; size(&$result)] $body
            $(
                fn of_one<R: Scalar>(
                    self,
                    backend: Backend,
                    one: &[R; size(&$of_a)],
                    many: &[[R; size(&$of_b)]],
                    to: &mut [[R; size(&$result)]],
                ) -> bool {
                    backend.$of_one(DualQuat::from_array(*one), many, to).is_ok()
                }
            )?
        }
    };
}
pub(crate) use function;

/// How many numbers there are in one element of a shape.
pub(crate) const fn size(shape: &[usize]) -> usize {
    let (mut size, mut axis) = (1, 0);
    while axis < shape.len() {
        size *= shape[axis];
        axis += 1;
    }
    size
}

// What the macro names, for `use super::function::*`.
pub(crate) use crate::argument::{Argument, common_dtype};
pub(crate) use crate::call::{Answer, call};
pub(crate) use crate::law::Law;
pub(crate) use dq8::{Backend, DualQuat, Lanes, Scalar};
pub(crate) use pyo3::prelude::*;
