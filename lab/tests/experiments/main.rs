//! What the experiments of the laboratory find, and the report that they are written up in.

mod counts;
mod derivatives;
mod drift;
mod figures;
mod hyper_dual;
mod inputs;
mod interpolation;
mod keyframe;
mod products;
mod report;
