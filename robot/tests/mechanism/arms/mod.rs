//! Arms from screws: their poses against other algebra, and the steps to their targets.

mod forward;
mod honest;
mod lanes;
mod reference;
mod shapes;
mod steps;
