use super::*;

/// Flights `y = own * exp(-shared t)`.
struct Decay {
    data: Vec<Vec<(f64, f64)>>,
    known: [Known; 1],
}

impl Problem for Decay {
    fn flights(&self) -> usize {
        self.data.len()
    }

    fn linearise(
        &self,
        flight: usize,
        shared: &DVector<f64>,
        own: &DVector<f64>,
    ) -> Result<Block, String> {
        let mut block = Block::zero(1, 1);
        for &(t, y) in &self.data[flight] {
            let e = (-shared[0] * t).exp();
            let by_shared = DVector::from_element(1, -t * own[0] * e);
            block.add(own[0] * e - y, &DVector::from_element(1, e), &by_shared);
        }
        Ok(block)
    }

    fn moved(&self, _: usize, own: &DVector<f64>, step: &DVector<f64>) -> DVector<f64> {
        own + step
    }

    fn known(&self) -> &[Known] {
        &self.known
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
        known: [Known {
            bounds,
            prior: None,
        }],
    }
}

fn start() -> Point {
    Point {
        shared: DVector::from_element(1, 0.0),
        own: vec![DVector::from_element(1, 1.0); 2],
    }
}

const EXACT: Until = Until {
    gain: 1e-16,
    part: 0.0,
    unseen: 1.0,
    steps: 100,
};

#[test]
fn exact_data_give_the_exact_unknowns() {
    let solution = solve(&decay((-10.0, 10.0)), start(), EXACT).unwrap();
    assert!(solution.converged);
    assert!((solution.point.shared[0] - 1.3).abs() < 1e-8);
    assert!((solution.point.own[1][0] + 5.0).abs() < 1e-8);
}

#[test]
fn bounds_hold() {
    let solution = solve(&decay((-10.0, 1.0)), start(), EXACT).unwrap();
    assert!(solution.converged);
    assert_eq!(solution.point.shared[0], 1.0);
}

#[test]
fn a_strong_prior_wins() {
    let mut problem = decay((-10.0, 10.0));
    problem.known[0].prior = Some((0.7, 1e-9));
    let solution = solve(&problem, start(), Until::DONE).unwrap();
    assert!((solution.point.shared[0] - 0.7).abs() < 1e-6);
}
