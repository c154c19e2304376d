//! This crate's ways for one instance.

use super::{Field, Motion};
use crate::memory::Packed;
use dq8::{Backend, Block, HierarchyPlan, Link, pack_chain};

impl Field<'_, '_> {
    /// In an order that is found once.
    pub(super) fn plan(&mut self) {
        let Self { scene, hierarchy, .. } = *self;
        for backend in Backend::available() {
            let memory = move || {
                let plan = HierarchyPlan::new(&hierarchy).backend(backend);
                ((plan, scene.locals.pack::<Motion>()), scene.locals.pack::<Motion>())
            };
            let pass = |(plan, locals): &(HierarchyPlan, Vec<Motion>), models: &mut [Motion]| {
                plan.local_to_model(locals, models).expect("one instance");
            };
            let numbers = |models: &[Motion], index| scene.locals.numbers(models, index);
            self.contest.add(format!("dq8 plan {backend}"), Some(backend), memory, pass, numbers);
        }
    }

    /// A chain with a segment in each lane.
    pub(super) fn segments<const N: usize>(&mut self)
    where
        Block<f32, N>: Link + Packed<Motion>,
        [f32; N]: dq8_simd::Row<Real = f32>,
    {
        let scene = self.scene;
        for backend in Backend::available() {
            let memory = move || {
                let links = scene.locals.pack::<Motion>();
                let mut blocks = vec![Block::<f32, N>::splat([0.0; 8]); links.len().div_ceil(N)];
                pack_chain(&links, &mut blocks).expect("as many blocks as the links fill");
                (blocks.clone(), blocks)
            };
            let pass = move |links: &Vec<Block<f32, N>>, products: &mut [Block<f32, N>]| {
                backend.chain_products(links, products).expect("as many products as links");
            };
            let numbers = |products: &[Block<f32, N>], index: usize| {
                products[index % products.len()].numbers(index / products.len())
            };
            let name = format!("dq8 segments in {N} lanes {backend}");
            self.contest.add(name, Some(backend), memory, pass, numbers);
        }
    }
}
