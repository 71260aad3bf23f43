//! scratch
use batch::LaneModel;
use flight::release::{Vocabulary, built_in, read};
use flight::{CompiledModel, simulate};
use lanes::Isa;
use ode::*;
use std::time::Instant;

struct Q {
    k: u64,
    n: u64,
    x: Vec<f64>,
    p: Vec<f64>,
    ends: Vec<(f64, [f64; 12], u64)>,
    steps: usize,
    evals: usize,
    how: [usize; 8],
    scatter: f64,
    apex: (f64, f64),
}
impl FlightQueue for Q {
    fn next(&mut self, x: &mut [f64], p: &mut [f64]) -> Option<u64> {
        if self.k == self.n {
            return None;
        }
        let k = self.k;
        self.k += 1;
        x.copy_from_slice(&self.x);
        p.copy_from_slice(&self.p);
        let f = ((k * 7919) % 1000) as f64 / 1000.0 - 0.5;
        let s = self.scatter;
        if x.len() > 5 {
            x[3] *= 1.0 + s * f;
            x[4] += s * 0.5 * f;
        }
        Some(k)
    }
    #[inline(never)]
    fn end(&mut self, end: FlightEnd<'_>) {
        self.steps += end.stats.steps + end.stats.rejected;
        self.evals += end.stats.evaluations;
        let code = match end.outcome {
            FlightOutcome::Ground => 0,
            FlightOutcome::Time => 1,
            FlightOutcome::Limit(_) => 2,
            FlightOutcome::TooManySteps => 3,
            FlightOutcome::StepTooSmall => 4,
            FlightOutcome::StartsBelowGround => 5,
            _ => 6,
        };
        self.how[code] += 1;
        if end.flight == 0 {
            let mut s = [0.0; 12];
            s[..end.state.len().min(12)].copy_from_slice(&end.state[..end.state.len().min(12)]);
            self.ends.push((end.time, s, 0));
            self.apex = end.apex;
        }
    }
}

fn main() {
    let which = std::env::args().nth(1).unwrap_or("disc".into());
    let n: u64 = std::env::args().nth(2).map_or(4096, |n| n.parse().unwrap());
    let model = model_spec::load::load(&which, &[]).unwrap();
    let compiled = CompiledModel::new(&model);
    let (x, p, release) = if which.contains("frispy") {
        (
            compiled.layout().default_states(),
            compiled.layout().default_parameters(),
            None,
        )
    } else {
        let text = std::env::args().nth(3).map_or_else(
            || {
                built_in("backhand")
                    .unwrap()
                    .replace("\"disc\"", &format!("{which:?}"))
            },
            |f| std::fs::read_to_string(f).unwrap(),
        );
        let release = read("backhand", &text, |_| Ok(Vocabulary::of(&model))).unwrap();
        (
            release.state(),
            compiled.release_parameters(&release),
            Some(release),
        )
    };
    for (name, lane_model) in [
        ("code", LaneModel::new(&model)),
        ("tape", LaneModel::interpreted(&model)),
    ] {
        for method in [Method::Tsit5, Method::Dop853] {
            let options = IntegrationOptions {
                method,
                rtol: 1e-6,
                atol: 1e-6,
                ..Default::default()
            };
            if let Some(release) = &release {
                if name == "code" {
                    let t0 = Instant::now();
                    for _ in 0..20 {
                        std::hint::black_box(simulate(&compiled, release, &options).unwrap());
                    }
                    let s = t0.elapsed().as_secs_f64() / 20.0 * 1e6;
                    let f = simulate(&compiled, release, &options).unwrap();
                    println!(
                        "scalar {method:?}: {s:.1} us, {:?} end {:.12} {:.12?}",
                        f.stats,
                        f.end,
                        &f.end_state[..3]
                    );
                }
            }
            for scatter in [0.0, 0.1] {
                for isa in [Isa::Avx512, Isa::Avx2] {
                    let span = FlightSpan {
                        t_end: 600.0,
                        height: Some(2),
                        until_ground: true,
                    };
                    let mut q = Q {
                        k: 0,
                        n,
                        x: x.clone(),
                        p: p.clone(),
                        ends: vec![],
                        steps: 0,
                        evals: 0,
                        how: [0; 8],
                        scatter,
                        apex: (0.0, 0.0),
                    };
                    let mut best = f64::INFINITY;
                    let mut total = 0;
                    for _ in 0..3 {
                        q = Q {
                            k: 0,
                            n,
                            x: x.clone(),
                            p: p.clone(),
                            ends: vec![],
                            steps: 0,
                            evals: 0,
                            how: [0; 8],
                            scatter,
                            apex: (0.0, 0.0),
                        };
                        let t0 = Instant::now();
                        total = lane_model.fly(&mut q, &span, &options, Some(isa));
                        best = best.min(t0.elapsed().as_secs_f64() / n as f64 * 1e6);
                    }
                    println!(
                        "{name} {method:?} {isa:?} scatter {scatter}: {best:.2} us a flight, {:.1} steps, {:.1} evals, vector evals x width / flight {:.1}, {:?} apex {:?} end {:.12} {:.12?}",
                        q.steps as f64 / n as f64,
                        q.evals as f64 / n as f64,
                        total as f64 * if isa == Isa::Avx512 { 8.0 } else { 4.0 } / n as f64,
                        q.how,
                        q.apex,
                        q.ends[0].0,
                        &q.ends[0].1[..3]
                    );
                }
            }
        }
    }
}
