//! What each candidate would explain, without a refit: the scores of all candidates once every flight's own unknowns, the base
//! and what is allowed for are eliminated.

mod parts;

use identify::{NormalBlock, eliminate};
use nalgebra::{DMatrix, DVector, SymmetricEigen};

use parts::{Eliminated, Parts, inverse_root};

pub(crate) use parts::inverse;

use crate::bench::Bench;
use crate::chance::{Group, ln_tail};

/// The part of a direction's squared size that must be left of it once all else is allowed for; what is below it is the
/// integration's error.
const VISIBLE: f64 = 1e-8;

/// The scores of all candidates that are not allowed for.
pub struct Scores {
    /// Every candidate's, by its index; none for those that are allowed for.
    pub each: Vec<Option<Score>>,
    /// Those of the terms outside the catalogue, where they were looked at.
    pub terms: Vec<Score>,
    /// The information of the candidates' shared coefficients, each scaled to 1 before the base was eliminated.
    pub information: DMatrix<f64>,
    /// The scores of the same columns.
    pub score: DVector<f64>,
    /// What each column was scaled by.
    pub scale: Vec<f64>,
    /// By how much the base's unknowns would step by themselves.
    pub base_step: DVector<f64>,
    /// The shared unknowns that its rows stand for.
    pub columns: Vec<usize>,
    /// Groups of these columns that are looked at together, for the threshold.
    pub groups: Vec<Group>,
    /// How many statistics are not among the groups.
    pub others: usize,
    /// The information of the base's unknowns and of what is allowed for, with those unknowns.
    pub base: (Vec<usize>, DMatrix<f64>),
    /// The squared size of each column before anything was allowed for, and once the flights' own unknowns were.
    pub sizes: Vec<(f64, f64)>,
    /// How each of the columns leans on each of those unknowns: its share of what absorbs it.
    pub leaning: DMatrix<f64>,
}

/// What one candidate would explain.
#[derive(Clone, Debug)]
pub struct Score {
    /// By how much the sum of squares would fall: chi squared of `freedom` where it is not missing.
    pub statistic: f64,
    /// Directions that these flights show of it; 0 where it is invisible.
    pub freedom: usize,
    /// Logarithm of the probability that chance does as much.
    pub ln_p: f64,
    /// The values of its coefficients that the scores point to, by shared unknown, with standard errors; the others are taken to be off.
    pub estimates: Vec<(usize, f64, f64)>,
    /// The greatest part of its squared effect on what is seen that nothing else absorbs.
    pub visible: f64,
}

impl Score {
    /// That of what is allowed for, or does nothing.
    const NOTHING: Score = Score {
        statistic: 0.0,
        freedom: 0,
        ln_p: 0.0,
        estimates: Vec::new(),
        visible: 0.0,
    };
}

impl Scores {
    /// Scores at a point where these are the flights' normal equations, with some candidates and terms allowed for.
    ///
    /// # Errors
    /// In words, where a flight does not determine its own unknowns.
    pub fn new(
        bench: &Bench,
        blocks: &[NormalBlock],
        (allowed, terms): (&[usize], &[usize]),
        global: &DVector<f64>,
    ) -> Result<Self, String> {
        let size = blocks.first().map_or(0, |block| block.global.nrows());
        // Terms have no value of their own yet.
        let known = global.len();
        let global = &DVector::from_fn(size, |i, _| if i < known { global[i] } else { 0.0 });
        let reduced = Reduced::new(bench, blocks, allowed, size)?;
        let mut free = bench.unknowns(allowed);
        free.extend(terms.iter().map(|term| known + term));
        let columns: Vec<usize> = (0..size).filter(|i| !free.contains(i)).collect();
        let (h, g) = prior(bench, &reduced.matrix, &reduced.gradient, global);
        let scale: Vec<f64> = columns.iter().map(|&i| inverse_root(h[(i, i)])).collect();
        let parts = Parts::new(&h, &g, &free, &columns, &scale);
        let Eliminated {
            information,
            score,
            leaning,
            base_step,
        } = parts.eliminated()?;
        let base = DMatrix::from_fn(free.len(), free.len(), |i, j| h[(free[i], free[j])]);
        let sizes = columns.iter().map(|&i| {
            let raw: f64 = blocks.iter().map(|block| block.global[(i, i)]).sum();
            (raw, h[(i, i)])
        });
        let mut scores = Scores {
            sizes: sizes.collect(),
            each: Vec::new(),
            terms: Vec::new(),
            information,
            columns,
            groups: Vec::new(),
            others: 0,
            score: score.clone(),
            scale: scale.clone(),
            base_step,
            base: (free, base),
            leaning,
        };
        let base_gain = gain_of(
            bench,
            &reduced.matrix,
            &reduced.gradient,
            global,
            &scores.base.0,
        );
        for (index, columns) in bench.candidates.iter().enumerate() {
            let score_of = if allowed.contains(&index) {
                None
            } else if columns.states.is_empty() {
                Some(scores.global(&columns.global, &score, &scale, global))
            } else {
                scores.others += 1;
                let local = reduced.local.iter().find(|local| local.candidate == index);
                local.map(|local| local.score(bench, global, &scores.base.0, base_gain))
            };
            scores.each.push(score_of);
        }
        for unknown in known..size {
            let score = scores.global(&[unknown], &score, &scale, global);
            scores.terms.push(score);
        }
        Ok(scores)
    }

    fn global(
        &mut self,
        local: &[usize],
        score: &DVector<f64>,
        scale: &[f64],
        global: &DVector<f64>,
    ) -> Score {
        let at: Vec<usize> = (0..self.columns.len())
            .filter(|&i| local.contains(&self.columns[i]))
            .collect();
        if at.is_empty() {
            return Score::NOTHING;
        }
        let part = DMatrix::from_fn(at.len(), at.len(), |i, j| self.information[(at[i], at[j])]);
        let eigen = SymmetricEigen::new(part);
        let seen = (0..at.len()).filter(|&k| eigen.eigenvalues[k] > VISIBLE);
        let seen: Vec<usize> = seen.collect();
        let mut whitening = DMatrix::zeros(seen.len(), self.columns.len());
        for (row, &k) in seen.iter().enumerate() {
            for (i, &column) in at.iter().enumerate() {
                whitening[(row, column)] = eigen.eigenvectors[(i, k)] / eigen.eigenvalues[k].sqrt();
            }
        }
        let normal = &whitening * score;
        let statistic = normal.norm_squared();
        let mut estimates = Vec::new();
        for (i, &column) in at.iter().enumerate() {
            let (mut value, mut variance) = (0.0, 0.0);
            for (row, &k) in seen.iter().enumerate() {
                let along = eigen.eigenvectors[(i, k)] / eigen.eigenvalues[k].sqrt();
                value += along * normal[row];
                variance += along * along;
            }
            let unknown = self.columns[column];
            let error = match variance > 0.0 && seen.len() == at.len() {
                true => variance.sqrt() * scale[column],
                false => f64::INFINITY,
            };
            estimates.push((unknown, global[unknown] + value * scale[column], error));
        }
        let visible = eigen.eigenvalues.iter().copied().fold(0.0, f64::max);
        let freedom = seen.len();
        if freedom > 0 {
            self.groups.push(Group { whitening });
        }
        Score {
            statistic,
            freedom,
            ln_p: ln_tail(statistic, freedom),
            estimates,
            visible,
        }
    }

    /// The step of all shared unknowns along those directions of the columns whose scores are greater than `limit` standard
    /// deviations, the base following; and how many directions that are.
    pub fn step(&self, limit: f64) -> (DVector<f64>, usize) {
        let size = self.columns.len() + self.base.0.len();
        let mut step = DVector::zeros(size);
        let mut along = DVector::zeros(self.columns.len());
        let mut kept = 0;
        if !self.columns.is_empty() {
            let eigen = SymmetricEigen::new(self.information.clone());
            for (value, vector) in eigen
                .eigenvalues
                .iter()
                .zip(eigen.eigenvectors.column_iter())
            {
                if *value > VISIBLE {
                    let score = vector.dot(&self.score) / value.sqrt();
                    if score.abs() > limit {
                        along.axpy(score / value.sqrt(), &vector, 1.0);
                        kept += 1;
                    }
                }
            }
        }
        let base = &self.base_step - &self.leaning * &along;
        for (&unknown, value) in self.base.0.iter().zip(base.iter()) {
            step[unknown] = *value;
        }
        for ((&unknown, value), scale) in self.columns.iter().zip(along.iter()).zip(&self.scale) {
            step[unknown] = value * scale;
        }
        (step, kept)
    }

    /// The term outside the catalogue that would explain most.
    pub fn best_term(&self) -> Option<(usize, &Score)> {
        least_likely(self.terms.iter().enumerate())
    }

    /// The candidate that would explain most, among those that these flights show.
    pub fn best(&self) -> Option<(usize, &Score)> {
        let each = self.each.iter().enumerate();
        least_likely(each.filter_map(|(index, score)| Some((index, score.as_ref()?))))
    }
}

/// The score that chance reaches least, of those that these flights show.
fn least_likely<'s>(
    scores: impl Iterator<Item = (usize, &'s Score)>,
) -> Option<(usize, &'s Score)> {
    scores
        .filter(|(_, score)| score.freedom > 0)
        .min_by(|a, b| a.1.ln_p.total_cmp(&b.1.ln_p))
}

/// The correlation matrix of an information matrix.
pub fn correlations(information: &DMatrix<f64>) -> DMatrix<f64> {
    let root = information.diagonal().map(|value| value.max(0.0).sqrt());
    DMatrix::from_fn(information.nrows(), information.ncols(), |i, j| {
        let product = root[i] * root[j];
        if product > 0.0 {
            (information[(i, j)] / product).clamp(-1.0, 1.0)
        } else {
            0.0
        }
    })
}

/// The normal equations of the shared unknowns once each flight's own are eliminated, and with them the states of what is
/// allowed for.
struct Reduced {
    matrix: DMatrix<f64>,
    gradient: DVector<f64>,
    local: Vec<Own>,
}

/// The same with the states of one more candidate eliminated too.
struct Own {
    candidate: usize,
    matrix: DMatrix<f64>,
    gradient: DVector<f64>,
    gain: f64,
    freedom: usize,
}

impl Reduced {
    fn new(
        bench: &Bench,
        blocks: &[NormalBlock],
        allowed: &[usize],
        size: usize,
    ) -> Result<Self, String> {
        let mut total = Reduced {
            matrix: DMatrix::zeros(size, size),
            gradient: DVector::zeros(size),
            local: Vec::new(),
        };
        let each = bench.candidates.iter().enumerate();
        for (candidate, columns) in each {
            if !columns.states.is_empty() && !allowed.contains(&candidate) {
                total.local.push(Own {
                    candidate,
                    matrix: DMatrix::zeros(size, size),
                    gradient: DVector::zeros(size),
                    gain: 0.0,
                    freedom: 0,
                });
            }
        }
        for (flight, block) in blocks.iter().enumerate() {
            total.add(bench, flight, block, allowed)?;
        }
        Ok(total)
    }

    fn add(
        &mut self,
        bench: &Bench,
        flight: usize,
        block: &NormalBlock,
        allowed: &[usize],
    ) -> Result<(), String> {
        let manifold = &bench.observation_sets[flight].manifold;
        let (out, local) = bench.directions(flight, allowed);
        let told = |_| {
            let file = &bench.observation_sets[flight].file;
            format!("{file}: its samples do not determine its initial state")
        };
        // What is off counts among the shared unknowns, before them, while the flight's own are eliminated.
        let rest = local_block(block, &local, &out);
        let blocks = [rest];
        let rest = eliminate(&blocks, 0.0).map_err(told)?;
        let skip = out.len();
        let size = self.gradient.len();
        self.matrix += rest.reduced.view((skip, skip), (size, size));
        self.gradient += rest.gradient.rows(skip, size);
        for total in &mut self.local {
            let states = &bench.candidates[total.candidate].states;
            let at: Vec<usize> = (0..skip)
                .filter(|&i| manifold.plain(out[i]).is_some_and(|s| states.contains(&s)))
                .collect();
            let global: Vec<usize> = (skip..skip + size).collect();
            let blocks = [of_shared((&rest.reduced, &rest.gradient), &at, &global)];
            match eliminate(&blocks, 0.0) {
                Ok(next) => {
                    let step = &next.back_substitute(&DVector::zeros(size))[0];
                    total.gain -= blocks[0].local_gradient.dot(step);
                    total.matrix += &next.reduced;
                    total.gradient += &next.gradient;
                    total.freedom += at.len();
                }
                // This flight does not show it.
                Err(_) => {
                    total.matrix += &blocks[0].global;
                    total.gradient += &blocks[0].global_gradient;
                }
            }
        }
        Ok(())
    }
}

impl Own {
    fn score(&self, bench: &Bench, global: &DVector<f64>, free: &[usize], base_gain: f64) -> Score {
        let with = gain_of(bench, &self.matrix, &self.gradient, global, free);
        let statistic = (self.gain + with - base_gain).max(0.0);
        Score {
            statistic,
            freedom: self.freedom,
            ln_p: ln_tail(statistic, self.freedom),
            estimates: Vec::new(),
            visible: f64::from(u8::from(self.freedom > 0)),
        }
    }
}

/// By how much the sum of squares falls when these unknowns are fitted.
fn gain_of(
    bench: &Bench,
    matrix: &DMatrix<f64>,
    gradient: &DVector<f64>,
    global: &DVector<f64>,
    free: &[usize],
) -> f64 {
    let (h, g) = prior(bench, matrix, gradient, global);
    let gradient = DVector::from_fn(free.len(), |i, _| g[free[i]]);
    let matrix = DMatrix::from_fn(free.len(), free.len(), |i, j| h[(free[i], free[j])]);
    inverse(&matrix).map_or(0.0, |inverse| gradient.dot(&(inverse * &gradient)))
}

/// The normal equations with what is known of the unknowns beforehand.
fn prior(
    bench: &Bench,
    matrix: &DMatrix<f64>,
    gradient: &DVector<f64>,
    global: &DVector<f64>,
) -> (DMatrix<f64>, DVector<f64>) {
    let (mut matrix, mut gradient) = (matrix.clone(), gradient.clone());
    for (i, unknown) in bench.problem.globals.iter().enumerate() {
        if let Some((centre, sigma)) = unknown.constraint.prior {
            matrix[(i, i)] += sigma.powi(-2);
            gradient[i] += (global[i] - centre) / (sigma * sigma);
        }
    }
    (matrix, gradient)
}

/// The normal equations of a flight's own unknowns `own`, with the unknowns `out` put before the shared ones.
pub(crate) fn local_block(block: &NormalBlock, local: &[usize], out: &[usize]) -> NormalBlock {
    let (skip, size) = (out.len(), block.global.nrows());
    let cross = DMatrix::from_fn(local.len(), skip + size, |i, j| match j.checked_sub(skip) {
        None => block.local[(local[i], out[j])],
        Some(j) => block.cross[(local[i], j)],
    });
    let global = DMatrix::from_fn(skip + size, skip + size, |i, j| {
        match (i.checked_sub(skip), j.checked_sub(skip)) {
            (None, None) => block.local[(out[i], out[j])],
            (None, Some(j)) => block.cross[(out[i], j)],
            (Some(i), None) => block.cross[(out[j], i)],
            (Some(i), Some(j)) => block.global[(i, j)],
        }
    });
    NormalBlock {
        local: DMatrix::from_fn(local.len(), local.len(), |i, j| {
            block.local[(local[i], local[j])]
        }),
        cross,
        global,
        local_gradient: DVector::from_fn(local.len(), |i, _| block.local_gradient[local[i]]),
        global_gradient: DVector::from_fn(skip + size, |i, _| match i.checked_sub(skip) {
            None => block.local_gradient[out[i]],
            Some(i) => block.global_gradient[i],
        }),
        squares: block.squares,
        count: block.count,
    }
}

/// The normal equations of some unknowns, of which `own` are made own ones and `shared` shared ones.
fn of_shared(
    (matrix, gradient): (&DMatrix<f64>, &DVector<f64>),
    local: &[usize],
    global: &[usize],
) -> NormalBlock {
    let part = |rows: &[usize], columns: &[usize]| {
        DMatrix::from_fn(rows.len(), columns.len(), |i, j| {
            matrix[(rows[i], columns[j])]
        })
    };
    let gradient = |rows: &[usize]| DVector::from_fn(rows.len(), |i, _| gradient[rows[i]]);
    NormalBlock {
        local: part(local, local),
        cross: part(local, global),
        global: part(global, global),
        local_gradient: gradient(local),
        global_gradient: gradient(global),
        squares: 0.0,
        count: 0,
    }
}
