//! A C function: its arguments, and the Rust function that it stands for.

use crate::argument::{Argument, Array, Kind, Scalar, Value};
use dq8_capi::Status;

type Run<S> = Box<dyn Fn(&[Value]) -> S>;

pub(crate) struct Function {
    /// The name in C.
    pub(crate) name: &'static str,
    /// The path in Rust.
    pub(crate) path: &'static str,
    pub(crate) arguments: Vec<Argument>,
    pub(crate) c: Run<Status>,
    pub(crate) rust: Run<Result<(), Status>>,
}

impl Function {
    pub(crate) fn arrays(&self) -> impl Iterator<Item = (usize, &Array)> + Clone {
        self.arguments.iter().enumerate().filter_map(|(at, argument)| match &argument.kind {
            Kind::Array(array) => Some((at, array)),
            Kind::Scalar(_) => None,
        })
    }
    pub(crate) fn scalars(&self) -> impl Iterator<Item = (usize, &Scalar)> {
        self.arguments.iter().enumerate().filter_map(|(at, argument)| match &argument.kind {
            Kind::Scalar(scalar) => Some((at, scalar)),
            Kind::Array(_) => None,
        })
    }
    pub(crate) fn array(&self, at: usize) -> &Array {
        self.arrays().find(|(other, _)| *other == at).expect("an array").1
    }
    pub(crate) fn scalar(&self, at: usize) -> &Scalar {
        self.scalars().find(|(other, _)| *other == at).expect("a number").1
    }
    /// The contents of the memory that elements of arguments point to.
    pub(crate) fn kept(&self) -> Vec<Vec<u8>> {
        self.arrays().flat_map(|(_, array)| array.kept()).collect()
    }
    /// The argument that an output may be.
    pub(crate) fn over(&self, output: &Array) -> Option<usize> {
        let at = |name| self.arguments.iter().position(|argument| argument.name == name);
        output.over.map(|name| at(name).expect("there is an input of that name"))
    }
}

/// The result of a Rust function, as the status of its C function.
pub(crate) trait Says {
    fn says(self) -> Result<(), Status>;
}

impl Says for () {
    fn says(self) -> Result<(), Status> {
        Ok(self)
    }
}

impl<T, E: Into<Status>> Says for Result<T, E> {
    fn says(self) -> Result<(), Status> {
        self.map(|_| ()).map_err(Into::into)
    }
}

/// Adds rows to the table:
/// `name in C, path in Rust = (argument: its role, …) => the Rust function of the arguments;`.
macro_rules! functions {
    ($to:ident: $($name:expr, $c:path = ($($argument:ident: $role:expr),* $(,)?) => $rust:expr;)+) => {$({
        #[allow(unused_imports, reason = "not all functions have all of them")]
        use $crate::argument::{Parameter, Role, View};
        let mut arguments = Vec::new();
        let ($($argument,)*) = ($($role.push(stringify!($argument), &mut arguments),)*);
        let c = |given: &[$crate::argument::Value]| {
            let mut given = given.iter();
            // SAFETY: arrays are as long as the table says, or wrong in ways that are seen.
            unsafe { $c($({
                let _: &str = stringify!($argument);
                Parameter::of(given.next().expect("a value"))
            }),*) }
        };
        let rust = move |given: &[$crate::argument::Value]| -> Result<(), dq8_capi::Status> {
            let mut given = given.iter();
            // SAFETY: as above; and they lie apart.
            $(let $argument = unsafe { $argument.see(given.next().expect("a value")) };)*
            let _ = ($(&$argument,)*);
            $crate::function::Says::says($rust)
        };
        $to.push($crate::function::Function {
            name: $name,
            path: std::any::type_name_of_val(&$c),
            arguments,
            c: Box::new(c),
            rust: Box::new(rust),
        });
    })+};
}

/// [`functions`] whose names in C and in Rust are made of: the number type, `single` or `double`; a
/// word before the name in C, the room.
macro_rules! of_numbers {
    ($to:ident $R:ident $of:ident: $($prefix:literal $module:ident $name:ident ($($arguments:tt)*) => $rust:expr;)+) => {
        functions! { $to: $(
            concat!("dq8_", $prefix, stringify!($name), "_", stringify!($R)), $module::$of::$name = ($($arguments)*) => $rust;
        )+ }
    };
}

/// The same of functions on arrays: those on plain ones, or on blocks of some lanes.
macro_rules! of_arrays {
    ($to:ident $R:ident $of:ident []: $($module:ident $plain:ident $blocks:ident ($($arguments:tt)*) => $rust:expr;)+) => {
        of_numbers! { $to $R $of: $("" $module $plain ($($arguments)*) => $rust;)+ }
    };
    ($to:ident $R:ident $of:ident [$lanes:literal]:
        $($module:ident $plain:ident $blocks:ident ($($arguments:tt)*) => $rust:expr;)+) => {
        of_numbers! { $to $R $of: $(
            "" $module $blocks (lanes: $crate::argument::lanes::<$R>($lanes), $($arguments)*) => $rust;
        )+ }
    };
}
