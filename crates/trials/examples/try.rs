//! tmp
use rand::{RngExt, SeedableRng};
fn main() {
    let model = trials::made::disc();
    let args: Vec<String> = std::env::args().collect();
    let n: usize = args[1].parse().unwrap();
    let seeds: u64 = args[2].parse().unwrap();
    let sigma: f64 = args[3].parse().unwrap();
    let truth = [
        ("C_L0", 0.15),
        ("C_La", 2.8),
        ("C_D0", 0.1),
        ("C_Da", 1.6),
        ("C_Ma", -0.3),
        ("C_Mq", -0.008),
        ("C_Rr", -0.0006),
        ("C_Nr", -5e-5),
    ];
    let plan = trials::made::Plan {
        truth: &truth,
        throws: trials::throw::Throws::SPREAD,
        flights: n,
        duration: (1.0, 1.0),
        rate: 120.0,
    };
    let (mut inside, mut all) = (0, 0);
    let mut zs: Vec<f64> = vec![0.0; 8];
    for seed in 0..seeds {
        let mut data = trials::made::flights(&model, &plan, seed);
        let mut random = rand_chacha::ChaCha12Rng::seed_from_u64(seed + 1000);
        let mut normal = || (0..12).map(|_| random.random::<f64>()).sum::<f64>() - 6.0;
        for f in &mut data.flights {
            for row in &mut f.positions {
                for p in row.iter_mut().flatten() {
                    for c in p {
                        *c += sigma * normal();
                    }
                }
            }
        }
        let t = std::time::Instant::now();
        match identify::fit::fit(&model, &data, &Default::default()) {
            Ok(fitted) => {
                let r = &fitted.report;
                if seeds < 5 {
                    println!(
                        "{:?} sigma {:.5} ar {:.3} outl {} steps {:?} rms {:.6}",
                        t.elapsed(),
                        r.noise.sigma_m,
                        r.noise.ar1,
                        r.noise.outliers,
                        r.iterations,
                        r.rms_m
                    );
                    for f in &r.flights {
                        if !f.notes.is_empty() || f.cut.is_some() {
                            println!("{} {:?} {:?} {}", f.file, f.notes, f.cut, f.rms_m);
                        }
                    }
                    println!("{:?} {:?}", r.seconds, r.undetermined);
                }
                for (k, (name, value)) in trials::made::truth(&model, &plan).iter().enumerate() {
                    let c = &r.coefficients[name];
                    if seeds < 5 {
                        println!(
                            "{name} {value} {:.5e} +- {:.2e} clustered {:?} z {:.2}",
                            c.value,
                            c.std_error,
                            c.std_error_clustered,
                            (c.value - value) / c.std_error
                        );
                    }
                    all += 1;
                    let z = (c.value - value) / c.std_error;
                    zs[k] += z * z;
                    if z.abs() < 1.96 {
                        inside += 1;
                    }
                }
            }
            Err(e) => println!("{seed}: {e}"),
        }
    }
    println!(
        "{inside}/{all} {:?}",
        zs.iter().map(|z| z / seeds as f64).collect::<Vec<_>>()
    );
}
