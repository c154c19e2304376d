//! What one line of the [table](crate::operations) becomes: a place in it, an
//! [`Operation`](crate::operation::Operation), a function for each implementation, and a method of
//! [`Motions`](crate::lanes::Motions).

/// Everything that the lines of a table become.
macro_rules! operations {
    ($($name:ident($($kind:ident $field:ident $($more:ident)*),*) -> $result:ident,
        $scale:expr, [$($held:expr),* $(,)?];)*) => {
        /// The place of each in the table.
        #[allow(non_camel_case_types, reason = "they are called as the operations are")]
        #[derive(Clone, Copy)]
        enum Place { $($name),* }

        /// Every operation of the contract.
        pub static OPERATIONS: &[Operation] = &[$(Operation {
            name: stringify!($name),
            arguments: &[$(Argument {
                domain: domain(stringify!($kind)).0,
                numbers: domain(stringify!($kind)).1,
                #[allow(unused_variables, reason = "most ask for the case alone")]
                pick: |x, on| pick!(x, on, $kind $field $($more)*),
            }),*],
            scale: $scale,
            bounds: &[$($held),*],
            answers: stringify!($result),
            index: Place::$name as usize,
        }),*];

        /// The operations of `M`.
        pub(crate) struct Calls<M>(std::marker::PhantomData<M>);

        impl<M: Sample> Calls<M> {
            pub(crate) const TABLE: &'static [Call] = &[$(call::$name::<M>),*];
        }

        mod call {
            use super::*;
            $(
                pub(super) fn $name<M: Sample>(given: &[Vec<Row>]) -> Answer {
                    let [$($field),*] = given else { panic!("as many arguments as there are") };
                    let ($($field,)*) = ($(give!(M, $kind $field),)*);
                    receive!(M, $result M::$name($($field),*))
                }
            )*
        }

        $(method! { $name($($kind $field),*) -> $result })*
    };
}

/// The operation under the names of [`lanes`](crate::lanes): a method of motions if it begins with
/// one.
macro_rules! method {
    ($name:ident(any $($rest:tt)*) -> $result:ident) => {
        method! { @of_motions $name(any $($rest)*) -> $result }
    };
    ($name:ident(unit $($rest:tt)*) -> $result:ident) => {
        method! { @of_motions $name(unit $($rest)*) -> $result }
    };
    (@of_motions $name:ident($own:ident $a:ident $(, $kind:ident $field:ident)*) -> $result:ident) => {
        impl Motions {
            #[allow(clippy::should_implement_trait, reason = "the traits are implemented by these")]
            pub fn $name(self $(, $field: argument!($kind))*) -> answer!($result) {
                let on = self.on;
                let given = [rows_of(&self) $(, pass!($kind $field))*];
                let answer = on.call(Place::$name as usize, &given);
                read!($result on answer)
            }
        }
    };
    ($name:ident($($kind:ident $field:ident),*) -> $result:ident) => {
        impl Implementation {
            pub fn $name(&'static self $(, $field: argument!($kind))*) -> answer!($result) {
                let (on, given) = (self, [$(pass!($kind $field)),*]);
                let answer = on.call(Place::$name as usize, &given);
                read!($result on answer)
            }
        }
    };
}

pub(crate) use {method, operations};
