//! Every operation of motions, as the contract lists them.

use crate::deal::Deal;
use crate::sample::Sample;

/// Arguments are dealt out in the order of the table; scales and bounds are the contract's.
macro_rules! operations {
    ($($name:ident($($kind:ident $field:ident $($more:ident)*),*) -> $result:ident,
        $scale:expr, [$($held:expr),* $(,)?];)*) => {
        pub(crate) fn run<M: Sample>(level: M::Level, sink: &mut dyn FnMut(&str, u64)) {
            $({
                let name = stringify!($name);
                sink(name, Deal::<M>::hash(level, name, |deal| {
                    $(let $field = take!(deal, $kind);)*
                    put!(deal, $result M::$name($($field),*));
                }));
            })*
        }
    };
}
include!("../contract/table.rs");
