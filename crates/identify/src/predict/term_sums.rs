//! Sums over the residuals of single samples, and of their products with the steps of terms, in SIMD lanes.

use lanes::{Kernel, Lanes};

use crate::least_squares::LANES;

/// Part of a row that fills the widest SIMD vectors.
pub(super) type Block = [f64; LANES];

/// Numbers of unknowns, functions of time and blocks.
#[derive(Clone, Copy)]
pub(super) struct Shape {
    pub locals: usize,
    /// Blocks of a vector of local parameters.
    pub local_blocks: usize,
    /// Blocks of a row, which has local and global parameters and the residual.
    pub blocks: usize,
    pub functions: usize,
}

/// Vector of each target at a sample, padded to blocks, and values of the functions there.
pub(super) struct Step {
    pub time: f64,
    pub added: Vec<Block>,
    pub functions: Vec<f64>,
}

/// Sums over the residuals of a sample; after [`sum_backwards`] over those that follow its step. The products of a row with
/// each local parameter are in successive blocks.
pub(super) struct Sample {
    pub step: Step,
    /// Products of the row with u.
    pub whitened: Vec<Block>,
    /// Products of the row with a.
    pub last: Vec<Block>,
    /// Products of a with itself.
    pub squares: Vec<Block>,
}

/// c and the sums so far of the terms of one target; the same block of all functions is in succession.
pub(super) struct OfTarget {
    combination: Vec<Block>,
    pub products: Vec<Block>,
    /// By function; the lanes are summed at the end.
    pub information: Vec<Block>,
    scratch: Scratch,
}

/// Products of the vectors of a target, before and after a step, with the sums.
struct Scratch {
    products: [Vec<Block>; 2],
    squares: Vec<Block>,
}

pub(super) fn zeros(count: usize) -> Vec<Block> {
    vec![[0.0; LANES]; count]
}

/// Sums `samples` over all that follow: `last` and `squares` are then the products of what depends on the step at a
/// sample, a of its residuals and u of the later ones. Returns the sum of `whitened`.
pub(super) fn sum_backwards(shape: Shape, samples: &mut [Sample]) -> Vec<Block> {
    let mut later = zeros(shape.locals * shape.blocks);
    for sample in samples.iter_mut().rev() {
        let flat = later.as_flattened_mut();
        let squares = sample.squares.as_flattened_mut().iter_mut();
        squares.zip(&*flat).for_each(|(own, later)| *own += later);
        let sums = flat.iter_mut().zip(sample.last.as_flattened_mut());
        for ((later, last), whitened) in sums.zip(sample.whitened.as_flattened()) {
            *last += *later;
            *later += whitened;
        }
    }
    later
}

/// SIMD kernel: adds the products of a row to the sums of its sample.
pub(super) struct AddRow<'a> {
    pub shape: Shape,
    pub row: &'a [Block],
    pub weight: f64,
    /// The row, weighted and without its autocorrelation.
    pub whitened: &'a [Block],
    pub sample: &'a mut Sample,
}

impl Kernel for AddRow<'_> {
    type Output = ();

    #[inline(always)]
    fn run<T: Lanes>(self) {
        let (locals, weight) = (self.shape.locals, self.weight);
        let by_local = &self.whitened.as_flattened()[..locals];
        let last = &self.row.as_flattened()[..locals];
        let sums = self.sample.whitened.chunks_exact_mut(locals);
        let sums = sums.zip(self.sample.last.chunks_exact_mut(locals));
        for (block, (of_whitened, of_last)) in self.whitened.iter().zip(sums) {
            let factors = by_local.iter().zip(last);
            for ((&u, &a), (whitened, last)) in factors.zip(of_whitened.iter_mut().zip(of_last)) {
                add_scaled::<T>(u, block, whitened);
                add_scaled::<T>(weight * a, block, last);
            }
        }
        let squares = self.sample.squares.chunks_exact_mut(locals);
        for (block, squares) in self.row.iter().zip(squares) {
            for (&a, to) in last.iter().zip(squares) {
                add_scaled::<T>(weight * weight * a, block, to);
            }
        }
    }
}

/// SIMD kernel: adds a segment to the products of the terms of one target. The trapezoidal rule gives the steps.
pub(super) struct SumSegment<'a> {
    pub shape: Shape,
    pub index: usize,
    pub target: &'a mut OfTarget,
    pub before: Option<&'a Step>,
    pub samples: &'a [Sample],
    pub whole: &'a [Block],
}

impl Kernel for SumSegment<'_> {
    type Output = ();

    #[inline(always)]
    fn run<T: Lanes>(self) {
        let Shape {
            local_blocks,
            functions,
            ..
        } = self.shape;
        self.target.begin::<T>(self.shape, self.whole);
        let own = self.index * local_blocks..(self.index + 1) * local_blocks;
        let mut earlier = self.before;
        for sample in self.samples {
            let Some(before) = earlier.replace(&sample.step) else {
                continue;
            };
            let half = 0.5 * (sample.step.time - before.time);
            let ends = [before, &sample.step];
            let ends = ends.map(|step| (&step.added[own.clone()], &step.functions[..functions]));
            self.target.step::<T>(half, ends, sample);
        }
    }
}

impl OfTarget {
    pub fn new(shape: Shape) -> Self {
        Self {
            combination: zeros(shape.functions * shape.local_blocks),
            products: zeros(shape.functions * shape.blocks),
            information: zeros(shape.functions),
            scratch: Scratch {
                products: [0, 1].map(|_| zeros(shape.blocks)),
                squares: zeros(shape.local_blocks),
            },
        }
    }

    /// Adds what c at the beginning of a segment does to its residuals.
    #[inline(always)]
    fn begin<T: Lanes>(&mut self, shape: Shape, whole: &[Block]) {
        let by_whole = &mut self.scratch.products[0];
        for function in 0..shape.functions {
            let start = self.combination[function..].iter().step_by(shape.functions);
            let start: Vec<Block> = start.copied().collect();
            multiply::<T>(&start.as_flattened()[..shape.locals], whole, by_whole);
            let products = self.products[function..].iter_mut();
            for (to, from) in products.step_by(shape.functions).zip(&*by_whole) {
                add_scaled::<T>(1.0, from, to);
            }
            self.information[function][0] += dot(&start, by_whole);
        }
    }

    /// Adds the step to `sample` with the rule's weight `half`, s, of the vector and the functions at its two `ends`.
    #[inline(always)]
    fn step<T: Lanes>(&mut self, half: f64, ends: [(&[Block], &[f64]); 2], sample: &Sample) {
        let Scratch { products, squares } = &mut self.scratch;
        let [(start, at_start), (end, at_end)] = ends;
        let functions = at_start.len();
        for ((vector, _), products) in ends.iter().zip(products.iter_mut()) {
            let locals = sample.last.len() / products.len();
            multiply::<T>(&vector.as_flattened()[..locals], &sample.last, products);
        }
        let squares = [
            product::<T>(start, start, &sample.squares, squares),
            2.0 * product::<T>(start, end, &sample.squares, squares),
            product::<T>(end, end, &sample.squares, squares),
        ];
        let squares = squares.map(|square| half * half * square);
        let weights = at_start.iter().zip(at_end);
        for ((x, y), information) in weights.clone().zip(&mut self.information) {
            information[0] += x * x * squares[0] + x * y * squares[1] + y * y * squares[2];
        }
        let by_block = products[0].iter().zip(&products[1]);
        let vectors = start.iter().zip(end);
        let combinations = self.combination.chunks_exact_mut(functions);
        for ((of_vectors, of_products), combination) in
            vectors.zip(by_block.clone()).zip(combinations)
        {
            let terms = combination.iter_mut().zip(&mut self.information);
            for ((&x, &y), (combination, information)) in weights.clone().zip(terms) {
                let mut both = [0.0; LANES];
                add_scaled::<T>(2.0 * half * x, of_products.0, &mut both);
                add_scaled::<T>(2.0 * half * y, of_products.1, &mut both);
                add_product::<T>(&both, combination, information);
                add_scaled::<T>(half * x, of_vectors.0, combination);
                add_scaled::<T>(half * y, of_vectors.1, combination);
            }
        }
        let sums = self.products.chunks_exact_mut(functions);
        for (of_products, sums) in by_block.zip(sums) {
            for ((&x, &y), sum) in weights.clone().zip(sums) {
                add_scaled::<T>(half * x, of_products.0, sum);
                add_scaled::<T>(half * y, of_products.1, sum);
            }
        }
    }
}

/// Sum of the rows, each times its factor; `rows` has the same block of all rows in succession.
#[inline(always)]
fn multiply<T: Lanes>(factors: &[f64], rows: &[Block], to: &mut [Block]) {
    for (to, rows) in to.iter_mut().zip(rows.chunks_exact(factors.len())) {
        let mut sum = [0.0; LANES];
        for (&factor, row) in factors.iter().zip(rows) {
            add_scaled::<T>(factor, row, &mut sum);
        }
        *to = sum;
    }
}

/// Product of two vectors of local parameters with `squares` between them.
#[inline(always)]
fn product<T: Lanes>(
    one: &[Block],
    other: &[Block],
    squares: &[Block],
    scratch: &mut [Block],
) -> f64 {
    let locals = squares.len() / scratch.len();
    multiply::<T>(&one.as_flattened()[..locals], squares, scratch);
    dot(scratch, other)
}

#[inline(always)]
fn add_scaled<T: Lanes>(factor: f64, from: &Block, to: &mut Block) {
    for lane in (0..LANES).step_by(T::WIDTH) {
        let sum = T::splat(factor).mul_add(T::load(&from[lane..]), T::load(&to[lane..]));
        sum.store(&mut to[lane..]);
    }
}

#[inline(always)]
fn add_product<T: Lanes>(one: &Block, other: &Block, to: &mut Block) {
    for lane in (0..LANES).step_by(T::WIDTH) {
        let sum = T::load(&one[lane..]).mul_add(T::load(&other[lane..]), T::load(&to[lane..]));
        sum.store(&mut to[lane..]);
    }
}

#[inline(always)]
fn dot(one: &[Block], other: &[Block]) -> f64 {
    let pairs = one.as_flattened().iter().zip(other.as_flattened());
    pairs.map(|(a, b)| a * b).sum()
}
