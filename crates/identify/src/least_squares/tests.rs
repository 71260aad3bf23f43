use nalgebra::DVector;

use super::*;

/// Returns the part of the normal equations `block` that belongs to the unknowns `by`. The problem has one local and
/// one global parameter.
fn of(block: NormalBlock, by: Unknowns) -> NormalBlock {
    match by {
        Unknowns::All => block,
        Unknowns::Local => block.select(&[0], &[]),
    }
}

/// Test problem: each flight measures `y = local * exp(-global t)`.
struct Decay {
    data: Vec<Vec<(f64, f64)>>,
    constraints: [Constraint; 1],
}

impl LeastSquaresProblem for Decay {
    fn flights(&self) -> usize {
        self.data.len()
    }

    fn linearise(
        &self,
        flight: usize,
        (global, local): (&DVector<f64>, &DVector<f64>),
        by: Unknowns,
    ) -> Result<NormalBlock, crate::error::FlightError> {
        let mut block = NormalBlock::zero(1, 1);
        for &(t, y) in &self.data[flight] {
            let e = (-global[0] * t).exp();
            let by_global = DVector::from_element(1, -t * local[0] * e);
            block.add(local[0] * e - y, &DVector::from_element(1, e), &by_global);
        }
        Ok(of(block, by))
    }

    fn plus(&self, _: usize, local: &DVector<f64>, step: &DVector<f64>) -> DVector<f64> {
        local + step
    }

    fn constraints(&self) -> &[Constraint] {
        &self.constraints
    }
}

fn decay(bounds: (f64, f64)) -> Decay {
    let flight = |amplitude: f64| {
        (0..20)
            .map(|i| f64::from(i) * 0.1)
            .map(|t| (t, amplitude * (-1.3 * t).exp()))
            .collect()
    };
    Decay {
        data: vec![flight(2.0), flight(-5.0)],
        constraints: [Constraint {
            bounds,
            prior: None,
        }],
    }
}

fn start() -> Iterate {
    Iterate {
        global: DVector::from_element(1, 0.0),
        local: vec![DVector::from_element(1, 1.0); 2],
    }
}

const EXACT: StoppingCriteria = StoppingCriteria {
    ftol_abs: 1e-16,
    ftol_rel: 0.0,
    accept_unevaluated: 1.0,
    max_steps: 100,
    worthwhile_squares: f64::INFINITY,
};

#[test]
fn exact_data_give_the_exact_unknowns() {
    let solution = solve(&decay((-10.0, 10.0)), start(), EXACT).unwrap();
    assert!(solution.converged());
    assert!((solution.iterate.global[0] - 1.3).abs() < 1e-8);
    assert!((solution.iterate.local[1][0] + 5.0).abs() < 1e-8);
}

#[test]
fn bounds_hold() {
    let solution = solve(&decay((-10.0, 1.0)), start(), EXACT).unwrap();
    assert!(solution.converged());
    assert_eq!(solution.iterate.global[0], 1.0);
}

#[test]
fn a_strong_prior_wins() {
    let mut problem = decay((-10.0, 10.0));
    problem.constraints[0].prior = Some((0.7, 1e-9));
    let solution = solve(&problem, start(), StoppingCriteria::CONVERGED).unwrap();
    assert!((solution.iterate.global[0] - 0.7).abs() < 1e-6);
}

/// Test problem whose sum of squares is Rosenbrock's function, with a curved valley `local = global²` that descends to
/// the minimum at (1, 1).
struct Rosenbrock;

fn far_from_the_end_of_the_valley() -> Iterate {
    Iterate {
        global: DVector::from_element(1, -1.2),
        local: vec![DVector::from_element(1, 1.0)],
    }
}

impl LeastSquaresProblem for Rosenbrock {
    fn flights(&self) -> usize {
        1
    }

    fn linearise(
        &self,
        _: usize,
        (global, local): (&DVector<f64>, &DVector<f64>),
        by: Unknowns,
    ) -> Result<NormalBlock, crate::error::FlightError> {
        let one = |value: f64| DVector::from_element(1, value);
        let mut block = NormalBlock::zero(1, 1);
        let across = 10.0 * (local[0] - global[0].powi(2));
        block.add(across, &one(10.0), &one(-20.0 * global[0]));
        block.add(1.0 - global[0], &one(0.0), &one(-1.0));
        Ok(of(block, by))
    }

    fn plus(&self, _: usize, local: &DVector<f64>, step: &DVector<f64>) -> DVector<f64> {
        local + step
    }

    fn constraints(&self) -> &[Constraint] {
        &[Constraint::NONE]
    }
}

#[test]
fn a_curved_valley_is_crossed_in_one_step() {
    let start = far_from_the_end_of_the_valley();
    let solution = solve(&Rosenbrock, start, StoppingCriteria::CONVERGED).unwrap();
    assert!((solution.iterate.global[0] - 1.0).abs() < 1e-9);
    assert!((solution.iterate.local[0][0] - 1.0).abs() < 1e-9);
    // One rejected step, one step with refined local parameters, and the last step.
    assert!(solution.iterations <= 4, "{}", solution.iterations);
}

#[test]
fn a_curved_valley_is_crossed_uphill() {
    let start = far_from_the_end_of_the_valley();
    let solution = solve_with_watchdog(&Rosenbrock, start, StoppingCriteria::CONVERGED).unwrap();
    assert!((solution.iterate.global[0] - 1.0).abs() < 1e-9);
    // A step uphill, a step to the minimum, and the last step: no step is rejected.
    assert_eq!(solution.iterations, 3);
}

/// Test problem whose sum of squares has a valley with sharp bends, so that steps along it are short, and a constant
/// residual that no step decreases.
struct Misfit;

impl LeastSquaresProblem for Misfit {
    fn flights(&self) -> usize {
        1
    }

    fn linearise(
        &self,
        _: usize,
        (global, local): (&DVector<f64>, &DVector<f64>),
        by: Unknowns,
    ) -> Result<NormalBlock, crate::error::FlightError> {
        let one = |value: f64| DVector::from_element(1, value);
        let mut block = NormalBlock::zero(1, 1);
        let (sin, cos) = (50.0 * global[0]).sin_cos();
        block.add(1e3 * (local[0] - sin), &one(1e3), &one(-5e4 * cos));
        block.add(1.0 - global[0], &one(0.0), &one(-1.0));
        block.add(10.0, &one(0.0), &one(0.0));
        Ok(of(block, by))
    }

    fn plus(&self, _: usize, local: &DVector<f64>, step: &DVector<f64>) -> DVector<f64> {
        local + step
    }

    fn constraints(&self) -> &[Constraint] {
        &[Constraint::NONE]
    }
}

#[test]
fn a_slow_iteration_is_given_up_above_the_worthwhile_sum_of_squares_alone() {
    let steps_with = |worthwhile_squares: f64| {
        let start = Iterate {
            global: DVector::from_element(1, 0.0),
            local: vec![DVector::from_element(1, 0.0)],
        };
        let criteria = StoppingCriteria {
            worthwhile_squares,
            ..EXACT
        };
        let solution = solve(&Misfit, start, criteria).unwrap();
        (solution.stop_reason, solution.iterations)
    };
    let (reason, steps) = steps_with(50.0);
    assert_eq!(reason, StopReason::GivenUp);
    assert!(steps < 10, "{steps}");
    let (reason, _) = steps_with(200.0);
    assert_ne!(reason, StopReason::GivenUp);
}

/// Test problem with the residual atan(global), from which undamped steps diverge beyond |global| = 1.39, and a
/// constant residual `wall` where the parameter is negative.
struct Diverging {
    wall: f64,
}

impl LeastSquaresProblem for Diverging {
    fn flights(&self) -> usize {
        1
    }

    fn linearise(
        &self,
        _: usize,
        (global, local): (&DVector<f64>, &DVector<f64>),
        by: Unknowns,
    ) -> Result<NormalBlock, crate::error::FlightError> {
        let one = |value: f64| DVector::from_element(1, value);
        let mut block = NormalBlock::zero(1, 1);
        let x = global[0];
        block.add(x.atan(), &one(0.0), &one(1.0 / (1.0 + x * x)));
        block.add(if x < 0.0 { self.wall } else { 0.0 }, &one(0.0), &one(0.0));
        block.add(local[0], &one(1.0), &one(0.0));
        Ok(of(block, by))
    }

    fn plus(&self, _: usize, local: &DVector<f64>, step: &DVector<f64>) -> DVector<f64> {
        local + step
    }

    fn constraints(&self) -> &[Constraint] {
        &[Constraint::NONE]
    }
}

#[test]
fn undamped_steps_that_lead_nowhere_are_taken_back() {
    // Behind a wall, the first step predicts already that no second one leads below the start.
    for (wall, undamped_steps) in [(0.0, 4), (10.0, 1)] {
        let problem = Diverging { wall };
        let start = || Iterate {
            global: DVector::from_element(1, 1.5),
            local: vec![DVector::from_element(1, 0.0)],
        };
        let monotone = solve(&problem, start(), EXACT).unwrap();
        let watched = solve_with_watchdog(&problem, start(), EXACT).unwrap();
        assert_eq!(watched.iterate.global, monotone.iterate.global, "{wall}");
        assert_eq!(watched.iterations, monotone.iterations + undamped_steps);
    }
}
