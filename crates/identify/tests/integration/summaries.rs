//! Flights that are told by rows of a launch monitor: derivatives at the events, and coverage of the intervals.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use dataset::synthesize::{Plan, flights};
use dataset::{Dataset, Flight, KnownValue, Role, from_texts};
use flight::release::{Vocabulary, read};
use identify::{
    Fit, FitOptions, FitProblem, FlightAt, FlightId, LocalId, PointResidual, fit, resolve,
};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha12Rng;
use rand_distr::StandardNormal;

/// Coefficients of the golf ball by which the shots are made.
const TRUTH: [(&str, f64); 5] = [
    ("C_D0", 0.22),
    ("C_Ds", 0.25),
    ("C_DRe", 0.05),
    ("C_L1", 0.5),
    ("n_L", 0.45),
];

/// Columns: header, quantity, unit, and standard deviation of the noise in this unit.
const COLUMNS: [(&str, &str, &str, f64); 10] = [
    ("Ball Speed", "speed", "mph", 0.8),
    ("Launch Angle", "launch", "deg", 0.3),
    ("Direction", "heading", "deg", 0.4),
    ("Spin Rate", "spin", "rpm", 80.0),
    ("Spin Axis", "spin_axis", "deg", 1.0),
    ("Carry", "carry", "yd", 2.0),
    ("Side", "side", "yd", 1.5),
    ("Apex", "apex_height", "ft", 2.0),
    ("Time", "hang_time", "s", 0.05),
    ("Landing", "landing_angle", "deg", 0.6),
];

/// The flight of a golf ball by its own equations and the classical Runge-Kutta method: what the columns tell of it.
fn flown([speed, launch, heading, spin, tilt]: [f64; 5]) -> [f64; 10] {
    let [c_d0, c_ds, c_dre, c_l1, n_l] = TRUTH.map(|(_, value)| value);
    let (m, radius, rho, nu, g) = (0.04593_f64, 0.021335_f64, 1.2, 1.5e-5, 9.81);
    let area = std::f64::consts::PI * radius * radius;
    let along = [
        launch.cos() * heading.cos(),
        launch.cos() * heading.sin(),
        launch.sin(),
    ];
    let left = [-heading.sin(), heading.cos(), 0.0];
    let up = cross(along, left);
    let axis = [0, 1, 2].map(|k| -tilt.cos() * left[k] - tilt.sin() * up[k]);
    let rates = |y: [f64; 7]| {
        let v = [y[3], y[4], y[5]];
        let size = v.iter().map(|v| v * v).sum::<f64>().sqrt();
        let ratio = radius * spin * y[6] / size;
        let reynolds = 2.0 * radius * size / nu;
        let drag = c_d0
            + c_ds * ratio
            + c_dre * (std::f64::consts::PI * (reynolds - 90000.0) / 200000.0).sin();
        let lift = c_l1 * ratio.powf(n_l);
        let pressure = rho * size * size / 2.0 * area / m;
        let across = cross(axis, v);
        let across_size = across.iter().map(|v| v * v).sum::<f64>().sqrt();
        let a = [0, 1, 2].map(|k| pressure * (lift * across[k] / across_size - drag * v[k] / size));
        [
            v[0],
            v[1],
            v[2],
            a[0],
            a[1],
            a[2] - g,
            -2e-5 * y[6] * size / radius,
        ]
    };
    let step = |y: [f64; 7], h: f64| {
        let plus = |k: [f64; 7], h: f64| std::array::from_fn(|i| y[i] + h * k[i]);
        let k1 = rates(y);
        let k2 = rates(plus(k1, h / 2.0));
        let k3 = rates(plus(k2, h / 2.0));
        let k4 = rates(plus(k3, h));
        std::array::from_fn(|i| y[i] + h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]))
    };
    let v = along.map(|a| speed * a);
    let mut y = [0.0, 0.0, 0.0, v[0], v[1], v[2], 1.0];
    let (mut t, mut apex, h) = (0.0, 0.0, 0.01);
    loop {
        let next: [f64; 7] = step(y, h);
        if y[5] > 0.0 && next[5] <= 0.0 {
            apex = step(y, root(|s| step(y, s)[5], h))[2];
        }
        if next[2] <= 0.0 {
            let last = root(|s| step(y, s)[2], h);
            (y, t) = (step(y, last), t + last);
            break;
        }
        (y, t) = (next, t + h);
    }
    let across = y[3].hypot(y[4]);
    let found = [
        speed,
        launch,
        heading,
        spin,
        tilt,
        y[0].hypot(y[1]),
        -y[1],
        apex,
        t,
    ];
    let landing = (-y[5]).atan2(across);
    std::array::from_fn(|k| found.get(k).copied().unwrap_or(landing))
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

/// Where `of` falls to 0 between 0, where it is positive, and `end`.
fn root(of: impl Fn(f64) -> f64, end: f64) -> f64 {
    let (mut low, mut high) = (0.0, end);
    for _ in 0..50 {
        let middle = (low + high) / 2.0;
        if of(middle) > 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    (low + high) / 2.0
}

/// A dataset of `shots` shots; `tells` says whether the noise of a column is stated.
fn dataset(shots: usize, seed: u64, tells: impl Fn(usize) -> bool) -> Dataset {
    let mut random = ChaCha12Rng::seed_from_u64(seed);
    let mut normal = || -> f64 { random.sample(StandardNormal) };
    let units = [
        0.44704, 0.0174533, 0.0174533, 0.10471976, 0.0174533, 0.9144, 0.9144, 0.3048, 1.0,
        0.0174533,
    ];
    let headers: Vec<&str> = COLUMNS.iter().map(|own| own.0).collect();
    let mut table = headers.join(",") + "\n";
    for shot in 0..shots {
        let part = shot as f64 / (shots - 1) as f64;
        let release = [
            70.0 - 25.0 * part + 2.0 * normal(),
            0.2 + 0.2 * part + 0.02 * normal(),
            0.04 * normal(),
            250.0 + 550.0 * part + 40.0 * normal(),
            0.12 * normal(),
        ];
        let seen = flown(release);
        let cells = seen.iter().zip(units).zip(COLUMNS);
        let cells = cells.map(|((value, unit), own)| (value / unit + own.3 * normal()).to_string());
        table += &(cells.collect::<Vec<_>>().join(",") + "\n");
    }
    let mut manifest =
        "model = \"golf_ball\"\n[[summaries]]\nfile = \"shots.csv\"\n[summaries.columns]\n"
            .to_owned();
    for (index, (header, is, unit, sigma)) in COLUMNS.iter().enumerate() {
        let _ = write!(
            manifest,
            "\"{header}\" = {{ is = \"{is}\", unit = \"{unit}\""
        );
        let _ = match tells(index) {
            true => writeln!(manifest, ", sigma = {sigma} }}"),
            false => writeln!(manifest, " }}"),
        };
    }
    let tables = BTreeMap::from([("shots.csv".to_owned(), table)]);
    from_texts(&manifest, &tables).expect("a dataset")
}

/// The decay of the spin, whose size no column of these shots tells.
fn options() -> FitOptions<'static> {
    static FIXED: std::sync::LazyLock<Vec<(String, Option<f64>)>> =
        std::sync::LazyLock::new(|| vec![("C_N".to_owned(), None)]);
    FitOptions {
        fixed: &FIXED,
        ..FitOptions::default()
    }
}

#[test]
fn intervals_hold_the_coefficients_of_simulated_shots() {
    let model = model_spec::load::load("golf_ball", &[]).expect("built in");
    let (mut held, mut all) = (0_u32, 0_u32);
    for seed in 0..30 {
        // The errors of the release are stated; those of the outcomes are estimated in every second dataset.
        let dataset = dataset(20, seed, |column| column < 5 || seed % 2 == 0);
        let found = fit(&model, &dataset, &options()).expect("a fit");
        for (name, truth) in TRUTH {
            let own = &found.report.coefficients[name];
            all += 1;
            held += u32::from((own.interval[0]..=own.interval[1]).contains(&truth));
        }
    }
    let share = f64::from(held) / f64::from(all);
    println!("the intervals hold {held} of {all} coefficients");
    assert!((0.93..=0.97).contains(&share), "{held} of {all}");
}

/// A prior of each row is not an unknown that takes up data.
#[test]
fn rows_with_measured_wind_pass_as_those_without() {
    let model = model_spec::load::load("golf_ball", &[]).expect("built in");
    let wind = [("wind", [0.0; 3]), ("wind_sigma", [0.1, 0.1, 0.001])];
    for known in [&wind[..0], &wind] {
        let doubtful = (0..20).filter(|seed| {
            let mut dataset = dataset(12, *seed, |_| true);
            for flight in &mut dataset.flights {
                let known = known.iter().copied();
                flight.known.extend(
                    known.map(|(name, value)| (name.to_owned(), KnownValue::Vector(value))),
                );
            }
            let found = fit(&model, &dataset, &options()).expect("a fit");
            found.report.doubt_of_summaries.is_some()
        });
        assert!(doubtful.count() <= 1, "{known:?}");
    }
}

#[test]
fn a_row_without_an_outcome_is_a_summary_as_the_others() {
    let model = model_spec::load::load("golf_ball", &[]).expect("built in");
    let mut shots = dataset(10, 5, |column| column >= 5);
    let columns = shots.sensors.iter().zip(&mut shots.flights[2].readings[0]);
    for (_, reading) in columns.filter(|(own, _)| own.is_outcome()) {
        *reading = None;
    }
    let found = fit(&model, &shots, &options()).expect("a fit");
    let flights = &found.report.flights;
    assert!(flights.iter().all(|own| own.is_summary && own.is_used()));
    let seen: Vec<usize> = flights.iter().map(|own| own.seen.len()).collect();
    assert_eq!(seen, [5, 5, 0, 5, 5, 5, 5, 5, 5, 5]);
}

/// Tracks of the golf ball, whose spin is known, made by hyzer's own integrator.
fn tracks() -> Dataset {
    let model = model_spec::load::load("golf_ball", &[]).expect("built in");
    let text = "model = \"golf_ball\"\nduration = 1.5\n[initial]\nx = 0\ny = 0\nz = 1\nvx = 60\nvy = 0\nvz = 12\nspin_left = 1\n";
    let release = read("shot", text, |_| Ok(Vocabulary::of(&model))).expect("a release");
    let plan = Plan {
        flights: 4,
        held_out: 1,
        seed: 3,
        ..Plan::default()
    };
    flights(&model, &[release], &plan).expect("made").dataset
}

#[test]
fn summaries_and_tracks_are_fitted_together() {
    let model = model_spec::load::load("golf_ball", &[]).expect("built in");
    let tracks = tracks();
    let mut both = tracks.clone();
    let shots = dataset(10, 5, |_| true);
    both.sensors = shots.sensors.clone();
    for flight in &mut both.flights {
        flight.readings = vec![vec![None; both.sensors.len()]; flight.times.len()];
    }
    let markers = both.markers.len();
    both.flights
        .extend(shots.flights.into_iter().map(|flight| Flight {
            positions: vec![vec![None; markers]],
            ..flight
        }));
    both.flights.last_mut().expect("a shot").role = Role::HeldOut;
    both.validate().expect("a dataset that can be written");
    let alone = fit(&model, &tracks, &options()).expect("a fit of the tracks");
    let found = fit(&model, &both, &options()).expect("a fit of both");
    let report = &found.report;
    let status = report.iterations.status;
    let excluded: Vec<_> = report
        .excluded()
        .map(|own| (&own.file, &own.notes))
        .collect();
    assert!(
        status.converged() && excluded.is_empty(),
        "{status:?} {excluded:?}"
    );
    assert_eq!(report.used(Role::HeldOut).count(), 2);
    let kinds = ["marker", "carry", "hang_time"];
    assert!(
        kinds
            .iter()
            .all(|kind| report.residual_rms.contains_key(*kind))
    );
    let error = |fit: &Fit| fit.report.coefficients["n_L"].std_error;
    let (both, alone) = (error(&found), error(&alone));
    assert!(both < 1.01 * alone, "{both} {alone}");
}

/// Largest difference of the derivatives of residuals from central differences, relative to the largest derivative of
/// each residual.
fn worst_derivative(model: &str, dataset: &Dataset) -> f64 {
    let model = model_spec::load::load(model, &[]).expect("built in");
    let options = FitOptions::default();
    let resolved = resolve(&model, dataset, &options).expect("resolved");
    let found = fit(&model, dataset, &options).expect("a fit");
    let problem: &FitProblem = found.problem();
    let (observations, local) = found.flight(FlightId::new(0)).expect("the first flight");
    assert_eq!(resolved.model.states.len(), local.len());
    let at = |global: &nalgebra::DVector<f64>, local: &nalgebra::DVector<f64>| {
        let mut points = Vec::new();
        let mut keep = |point: PointResidual<'_>| {
            points.push((point.residual[0], point.rows[0].clone()));
        };
        FlightAt::new(problem, observations, (global, local))
            .each_residual(&problem.global_parameters(), &mut keep)
            .expect("flown");
        points
    };
    let (global, dimension) = (found.global(), observations.manifold.dimension());
    let exact = at(global, local);
    let mut worst: f64 = 0.0;
    for column in 0..dimension + global.len() {
        let moved = |sign: f64| {
            let (mut there, mut step) = (global.clone(), nalgebra::DVector::zeros(dimension));
            let h = match column.checked_sub(dimension) {
                Some(k) => 1e-3 * problem.globals[k].x_scale,
                // Far above the error of an integration, which differs from state to state.
                None => {
                    1e-3 * local[observations
                        .manifold
                        .direct_state(LocalId::new(column))
                        .map_or(0, model_spec::layout::StateId::index)]
                    .abs()
                    .max(1.0)
                }
            };
            match column.checked_sub(dimension) {
                Some(k) => there[k] += sign * h,
                None => step[column] = sign * h,
            }
            (at(&there, &observations.manifold.plus(local, &step)), h)
        };
        let ((ahead, h), (behind, _)) = (moved(1.0), moved(-1.0));
        for ((exact, ahead), behind) in exact.iter().zip(&ahead).zip(&behind) {
            let difference = (ahead.0 - behind.0) / (2.0 * h);
            let size = exact.1.iter().fold(0.0_f64, |size, by| size.max(by.abs()));
            let off = (exact.1[column] - difference).abs() / size;
            if off > 1e-3 {
                println!("{column}: {} {difference} of {size}", exact.1[column]);
            }
            worst = worst.max(off);
        }
    }
    worst
}

#[test]
fn derivatives_at_events_are_those_of_differences() {
    let shots = dataset(6, 1, |_| true);
    assert!(worst_derivative("golf_ball", &shots) < 1e-3);
    let manifest = "model = \"disc\"\n[[summaries]]\nfile = \"throws.csv\"\n[summaries.columns]\n\
        v = { is = \"speed\", unit = \"m/s\" }\na = { is = \"launch\", unit = \"deg\" }\n\
        n = { is = \"nose\", unit = \"deg\" }\nh = { is = \"hyzer\", unit = \"deg\" }\n\
        s = { is = \"spin\", unit = \"rpm\" }\nw = { is = \"wobble\", unit = \"deg\" }\n\
        z = { is = \"height\", unit = \"m\" }\nc = { is = \"carry\", unit = \"m\" }\n\
        y = { is = \"side\", unit = \"m\" }\nt = { is = \"hang_time\", unit = \"s\" }\n\
        e = { is = \"final_spin\", unit = \"rpm\" }\nd = { is = \"apex_distance\", unit = \"m\" }\n";
    let table = "v,a,n,h,s,w,z,c,y,t,e,d\n14,8,2,5,500,2,1.2,20,-1,2.2,480,9\n\
        15,9,1,-5,550,1,1.2,21,1,2.3,490,10\n13,7,3,2,450,2,1.1,19,0,2,440,9\n16,10,2,0,600,1,1.3,22,1,2.4,540,11\n";
    let tables = BTreeMap::from([("throws.csv".to_owned(), table.to_owned())]);
    let throws = from_texts(manifest, &tables).expect("a dataset");
    assert!(worst_derivative("disc", &throws) < 1e-3);
}

#[test]
fn what_rows_do_not_tell_of_the_spin_is_told() {
    let model = model_spec::load::load("golf_ball", &[]).expect("built in");
    let manifest = "model = \"golf_ball\"\n[[summaries]]\nfile = \"shots.csv\"\n[summaries.columns]\n\
        Speed = { is = \"speed\", unit = \"mph\" }\nLaunch = { is = \"launch\", unit = \"deg\" }\n\
        Spin = { is = \"spin\", unit = \"rpm\" }\nCarry = { is = \"carry\", unit = \"yd\" }\n";
    let noted_of = |spins: [&str; 4], manifest: &str, known: Option<KnownValue>| {
        let mut table = String::from("Speed,Launch,Spin,Carry\n");
        for (k, spin) in spins.into_iter().enumerate() {
            let _ = writeln!(table, "{},12,{spin},{}", 140 + 5 * k, 225 + 8 * k);
        }
        let tables = BTreeMap::from([("shots.csv".to_owned(), table)]);
        let mut dataset = from_texts(manifest, &tables).expect("a dataset");
        for flight in &mut dataset.flights {
            flight
                .known
                .extend(known.map(|spin| ("omega".to_owned(), spin)));
        }
        let options = FitOptions {
            fixed: &["C_Ds", "C_DRe", "C_L1", "n_L", "C_N"].map(|name| (name.to_owned(), None)),
            ..FitOptions::default()
        };
        fit(&model, &dataset, &options)
            .expect("a fit")
            .report
            .notes
            .join("\n")
    };
    let noted = |spins, manifest: &str| noted_of(spins, manifest, None);
    let of_some = noted(["2500", "", "2600", ""], manifest);
    let expected = "2 of 4 rows have no spin, and are assumed to have 267 ± 300 rad/s";
    assert!(of_some.contains(expected), "{of_some}");
    let of_all = noted(["2500", "2400", "2600", "2700"], manifest);
    assert!(!of_all.contains("assumed"), "{of_all}");
    let without = manifest.replace("Spin = { is = \"spin\", unit = \"rpm\" }\n", "");
    let of_none = noted(["", "", "", ""], &without);
    assert!(of_none.contains("no column tells the spin"), "{of_none}");
    let known = Some(KnownValue::Vector([0.0, -260.0, 0.0]));
    let of_known = noted_of(["", "", "", ""], &without, known);
    assert!(!of_known.contains("no column tells the spin"), "{of_known}");
}
