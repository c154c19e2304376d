//! [`Subject`]: the kernels over one layout, as functions of `f64` records.

use crate::inputs::Inputs;
use crate::memory::{Memory, lay, read, round};
use crate::slices::kernels;
use core::marker::PhantomData;
use core::ops::Range;
use dq8::simd::Float;
use dq8::storage::{AoSoA, Aos};
use dq8::{
    Backend, DualQuat, Hierarchy, Job, ShapeError, hierarchy,
    hierarchy::{Bones, MatrixOrder, Poses, Renormalize, RotationsTranslations},
};

/// What a job is told.
#[derive(Clone, Debug)]
pub(crate) struct Task<'a> {
    pub(crate) parents: &'a [u32],
    pub(crate) backend: Backend,
    pub(crate) joints: Range<usize>,
    pub(crate) root: Root<'a>,
    pub(crate) renormalize: Renormalize,
    pub(crate) order: MatrixOrder,
}

#[derive(Clone, Copy, Debug)]
pub(crate) enum Root<'a> {
    None,
    Same([f64; 8]),
    /// One for each instance; more are cut off.
    Each(&'a [[f64; 8]]),
}

impl<'a> Task<'a> {
    pub(crate) fn new(parents: &'a [u32], backend: Backend) -> Self {
        Self {
            parents,
            backend,
            joints: 0..parents.len(),
            root: Root::None,
            renormalize: Renormalize::Never,
            order: MatrixOrder::Rows,
        }
    }
}

/// Locals, `[instance][joint]`.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Given<'a> {
    Poses(&'a [[f64; 8]]),
    /// They lie where the models go.
    InPlace,
    RotationsTranslations(&'a [[f64; 7]]),
    /// Offsets are one for each joint.
    Rotations(&'a [[f64; 4]], &'a [[f64; 3]]),
}

/// The four runs of a job.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Run {
    LocalToModel,
    LocalToModelInPlace,
    ModelToLocal,
    ModelToLocalInPlace,
}

/// The kernels over one layout. Records are rounded on the way in; on the way out come those of all
/// lanes, `[instance][joint]`, with instances at the end that fill the last block.
pub(crate) trait Subject {
    fn name(&self) -> String;
    /// Whether numbers are `f32`.
    fn single(&self) -> bool;
    /// How many instances an element holds.
    fn things(&self) -> usize;

    /// Over `models`, which hold what the joints outside the range are, or locals in place.
    fn forward(&self, task: &Task, given: Given, models: &[[f64; 8]]) -> Vec<[f64; 8]>;
    /// The models, and the entries of a palette that was `before` in every number: of 8 numbers
    /// from rotations, of 12 from poses, of 16 from rotations and translations.
    fn palette(
        &self,
        task: &Task,
        given: Given,
        binds: &[[f64; 8]],
        before: f64,
    ) -> (Vec<[f64; 8]>, Vec<Vec<f64>>);
    /// Over `locals`; in place if there are no `models`.
    fn backward(
        &self,
        task: &Task,
        models: Option<&[[f64; 8]]>,
        locals: &[[f64; 8]],
    ) -> Vec<[f64; 8]>;
    /// Of one chain, in place and out of place, which are the same to the last bit.
    fn chain(&self, backend: Backend, links: &[[f64; 8]]) -> Vec<[f64; 8]>;
    /// What a kernel of the table makes of slices, of which the results follow one another; in
    /// place, where that can be, it is the same.
    fn slices(&self, backend: Backend, kernel: usize, inputs: &Inputs) -> Vec<Vec<f64>>;
    /// Panics unless every kernel of the table refuses slices of other lengths by their names.
    fn slices_are_as_long(&self, backend: Backend, inputs: &Inputs);

    /// A run with as many input and output elements, and roots if a number of them is given. Panics
    /// if the output is written in spite of an error.
    fn run(
        &self,
        task: &Task,
        run: Run,
        lengths: [usize; 2],
        roots: Option<usize>,
    ) -> Result<(), ShapeError>;
}

/// Every layout there is.
pub(crate) fn subjects() -> [&'static dyn Subject; 8] {
    const fn of<L>() -> In<L> {
        In(PhantomData)
    }
    [
        const { &of::<Aos<f32>>() },
        const { &of::<Aos<f64>>() },
        const { &of::<AoSoA<[f32; 4]>>() },
        const { &of::<AoSoA<[f32; 8]>>() },
        const { &of::<AoSoA<[f32; 16]>>() },
        const { &of::<AoSoA<[f64; 2]>>() },
        const { &of::<AoSoA<[f64; 4]>>() },
        const { &of::<AoSoA<[f64; 8]>>() },
    ]
}

/// Calls `check` with every layout on every backend of this CPU.
pub(crate) fn for_every_subject(mut check: impl FnMut(&dyn Subject, Backend)) {
    for backend in Backend::available() {
        for subject in subjects() {
            check(subject, backend);
        }
    }
}

/// Kernels over the layout `L`.
struct In<L>(PhantomData<L>);

impl<L: Memory> In<L> {
    /// Roots as `task` says, for so many elements.
    fn roots(task: &Task, elements: usize) -> Vec<L::Record<8>> {
        let instances = elements.checked_div(task.parents.len()).unwrap_or(0) * L::THINGS;
        match task.root {
            Root::Each(roots) => lay::<L, 8>(1, &roots[..instances.min(roots.len())]),
            _ => Vec::new(),
        }
    }

    fn job<'a>(
        task: &Task<'a>,
        roots: &'a [L::Record<8>],
    ) -> Job<'a, hierarchy::Root<'a, L::Record<8>>> {
        let hierarchy = Hierarchy::new(task.parents).expect("parents come first");
        let job = hierarchy.job().backend(task.backend).joints(task.joints.clone());
        let job = job.renormalize(task.renormalize).matrix_order(task.order);
        job.on(match task.root {
            Root::None => hierarchy::Root::None,
            Root::Same(root) => hierarchy::Root::Same(DualQuat::from_array(round(root))),
            Root::Each(_) => hierarchy::Root::Each(roots),
        })
    }

    /// `number` in as many elements.
    fn all<const C: usize>(number: f64, elements: usize) -> Vec<L::Record<C>> {
        vec![L::filled::<C>(round([number])[0]); elements]
    }

    fn unwritten<const C: usize>(
        answer: Result<(), ShapeError>,
        output: &[L::Record<C>],
        number: f64,
    ) -> Result<(), ShapeError> {
        let written = read::<L, C>(1, output).into_iter().any(|record| record != [number; C]);
        assert!(answer.is_ok() || !written, "written in spite of {answer:?}");
        answer
    }
}

const FITS: &str = "lengths fit";

impl<L: Memory> Subject for In<L> {
    fn name(&self) -> String {
        L::name()
    }
    fn single(&self) -> bool {
        L::Real::SINGLE
    }
    fn things(&self) -> usize {
        L::THINGS
    }

    fn forward(&self, task: &Task, given: Given, models: &[[f64; 8]]) -> Vec<[f64; 8]> {
        let joints = task.parents.len();
        let mut models = lay::<L, 8>(joints, models);
        let roots = Self::roots(task, models.len());
        let job = Self::job(task, &roots);
        let answer = match given {
            Given::Poses(locals) => job.local_to_model(&lay::<L, 8>(joints, locals), &mut models),
            Given::InPlace => job.local_to_model_in_place(&mut models),
            Given::RotationsTranslations(locals) => {
                let locals = lay::<L, 7>(joints, locals);
                job.locals_to_model(RotationsTranslations(&locals), &mut models)
            }
            Given::Rotations(rotations, offsets) => {
                let rotations = lay::<L, 4>(joints, rotations);
                let offsets: Vec<_> = offsets.iter().map(|offset| round(*offset)).collect();
                let locals = Bones { rotations: &rotations, offsets: &offsets };
                job.locals_to_model(locals, &mut models)
            }
        };
        answer.expect(FITS);
        read::<L, 8>(joints, &models)
    }

    fn palette(
        &self,
        task: &Task,
        given: Given,
        binds: &[[f64; 8]],
        before: f64,
    ) -> (Vec<[f64; 8]>, Vec<Vec<f64>>) {
        let joints = task.parents.len();
        let binds: Vec<_> = binds.iter().map(|bind| DualQuat::from_array(round(*bind))).collect();
        let count = match given {
            Given::Poses(locals) => locals.len(),
            Given::InPlace => 0,
            Given::RotationsTranslations(locals) => locals.len(),
            Given::Rotations(rotations, _) => rotations.len(),
        };
        let identity = DualQuat::<f64>::IDENTITY.to_array();
        let mut models = lay::<L, 8>(joints, &vec![identity; count]);
        let roots = Self::roots(task, models.len());
        let job = Self::job(task, &roots);
        let entries = match given {
            Given::Poses(locals) => {
                let locals = lay::<L, 8>(joints, locals);
                let mut palette = Self::all::<12>(before, models.len());
                let locals = Poses(&locals);
                job.palette_and_models(locals, &mut models, &binds, &mut palette).expect(FITS);
                read::<L, 12>(joints, &palette).iter().map(|entry| entry.to_vec()).collect()
            }
            Given::InPlace => panic!("a palette needs locals of its own"),
            Given::RotationsTranslations(locals) => {
                let locals = lay::<L, 7>(joints, locals);
                let mut palette = Self::all::<16>(before, models.len());
                let locals = RotationsTranslations(&locals);
                job.palette_and_models(locals, &mut models, &binds, &mut palette).expect(FITS);
                read::<L, 16>(joints, &palette).iter().map(|entry| entry.to_vec()).collect()
            }
            Given::Rotations(rotations, offsets) => {
                let rotations = lay::<L, 4>(joints, rotations);
                let offsets: Vec<_> = offsets.iter().map(|offset| round(*offset)).collect();
                let mut palette = Self::all::<8>(before, models.len());
                let locals = Bones { rotations: &rotations, offsets: &offsets };
                job.palette_and_models(locals, &mut models, &binds, &mut palette).expect(FITS);
                read::<L, 8>(joints, &palette).iter().map(|entry| entry.to_vec()).collect()
            }
        };
        (read::<L, 8>(joints, &models), entries)
    }

    fn backward(
        &self,
        task: &Task,
        models: Option<&[[f64; 8]]>,
        locals: &[[f64; 8]],
    ) -> Vec<[f64; 8]> {
        let joints = task.parents.len();
        let mut locals = lay::<L, 8>(joints, locals);
        let roots = Self::roots(task, locals.len());
        let job = Self::job(task, &roots);
        let answer = match models {
            Some(models) => job.model_to_local(&lay::<L, 8>(joints, models), &mut locals),
            None => job.model_to_local_in_place(&mut locals),
        };
        answer.expect(FITS);
        read::<L, 8>(joints, &locals)
    }

    fn chain(&self, backend: Backend, links: &[[f64; 8]]) -> Vec<[f64; 8]> {
        // A segment in each lane.
        let segment = links.len().div_ceil(L::THINGS);
        let links = lay::<L, 8>(segment, links);
        let mut products = Self::all::<8>(f64::NAN, links.len());
        backend.chain_products(&links, &mut products).expect(FITS);
        let mut in_place = links;
        backend.chain_products_in_place(&mut in_place);
        let products = read::<L, 8>(segment, &products);
        let in_place = read::<L, 8>(segment, &in_place);
        crate::records::assert_same_bits(&in_place, &products, "in place");
        products
    }

    fn slices(&self, backend: Backend, kernel: usize, inputs: &Inputs) -> Vec<Vec<f64>> {
        kernels::<L>()[kernel].compute(backend, inputs)
    }

    fn slices_are_as_long(&self, backend: Backend, inputs: &Inputs) {
        kernels::<L>().iter().for_each(|kernel| kernel.are_as_long(backend, inputs));
    }

    fn run(
        &self,
        task: &Task,
        run: Run,
        [input, output]: [usize; 2],
        roots: Option<usize>,
    ) -> Result<(), ShapeError> {
        let (from, mut to) = (Self::all::<8>(0.25, input), Self::all::<8>(0.5, output));
        let roots = roots.map(|roots| Self::all::<8>(1.0, roots));
        let task = match &roots {
            Some(_) => &Task { root: Root::Each(&[]), ..task.clone() },
            None => task,
        };
        let job = Self::job(task, roots.as_deref().unwrap_or_default());
        let answer = match run {
            Run::LocalToModel => job.local_to_model(&from, &mut to),
            Run::LocalToModelInPlace => job.local_to_model_in_place(&mut to),
            Run::ModelToLocal => job.model_to_local(&from, &mut to),
            Run::ModelToLocalInPlace => job.model_to_local_in_place(&mut to),
        };
        Self::unwritten::<8>(answer, &to, 0.5)
    }
}
