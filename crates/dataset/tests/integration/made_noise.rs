//! The noise of made datasets is what was asked for, and the same seed makes the same bits.

use dataset::synthesize::{Corruption, corrupt};

type Positions = Vec<Vec<Option<[f64; 3]>>>;

const SAMPLES: usize = 20_000;

fn still(markers: usize) -> Positions {
    vec![vec![Some([0.0; 3]); markers]; SAMPLES]
}

fn corrupted(noise: &Corruption, markers: usize, seed: u64) -> Positions {
    let mut positions = still(markers);
    corrupt(&mut positions, noise, seed);
    positions
}

/// Errors of one marker along one axis, by sample, if its true position is 0; panics if a position is missing.
fn along(positions: &Positions, marker: usize, axis: usize) -> Vec<f64> {
    let each = positions.iter();
    each.map(|row| row[marker].expect("seen")[axis]).collect()
}

fn correlation(a: &[f64], b: &[f64]) -> f64 {
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    dot(a, b) / (dot(a, a) * dot(b, b)).sqrt()
}

#[test]
fn noise_has_its_size_and_its_correlation() {
    for ar1 in [0.0, 0.6, -0.5, 0.95] {
        let noise = Corruption {
            sigma: 0.002,
            ar1,
            ..Corruption::default()
        };
        let positions = corrupted(&noise, 2, 3);
        for (marker, axis) in [(0, 0), (0, 1), (0, 2), (1, 0), (1, 2)] {
            let all = along(&positions, marker, axis);
            let n = SAMPLES as f64;
            let variance = all.iter().map(|e| e * e).sum::<f64>() / n;
            // The standard error of a variance grows with the correlation.
            let error = (2.0 / n * (1.0 + ar1 * ar1) / (1.0 - ar1 * ar1)).sqrt();
            let found = variance / noise.sigma.powi(2);
            assert!(
                (found - 1.0).abs() < 4.5 * error,
                "{ar1}: {found} ± {error}"
            );
            let mean = all.iter().sum::<f64>() / n / noise.sigma;
            let error = ((1.0 + ar1) / (1.0 - ar1) / n).sqrt();
            assert!(mean.abs() < 4.5 * error, "{ar1}: {mean} ± {error}");
            let found = correlation(&all[1..], &all[..SAMPLES - 1]);
            let error = ((1.0 - ar1 * ar1) / n).sqrt();
            assert!(
                (found - ar1).abs() < 4.5 * error,
                "{ar1}: {found} ± {error}"
            );
        }
    }
}

#[test]
fn markers_and_axes_have_streams_of_their_own() {
    let positions = corrupted(&Corruption::default(), 3, 5);
    let all: Vec<Vec<f64>> = (0..9).map(|i| along(&positions, i / 3, i % 3)).collect();
    for (i, a) in all.iter().enumerate() {
        for b in &all[..i] {
            let found = correlation(a, b);
            assert!(found.abs() < 4.5 / (SAMPLES as f64).sqrt(), "{found}");
        }
    }
    // One marker more does not change the others.
    assert_eq!(
        along(&corrupted(&Corruption::default(), 4, 5), 1, 2),
        all[5]
    );
}

#[test]
fn the_noise_of_the_first_sample_is_as_large_as_later() {
    let noise = Corruption {
        sigma: 1.0,
        ar1: 0.9,
        ..Corruption::default()
    };
    let squares = (0..4000).map(|seed| {
        let mut positions = vec![vec![Some([0.0; 3])]];
        corrupt(&mut positions, &noise, seed);
        positions[0][0].expect("seen")[0].powi(2)
    });
    let variance = squares.sum::<f64>() / 4000.0;
    assert!(
        (variance - 1.0).abs() < 4.5 * (2.0_f64 / 4000.0).sqrt(),
        "{variance}"
    );
}

#[test]
fn outliers_are_as_many_and_as_large_as_asked() {
    let noise = Corruption {
        sigma: 0.0,
        outliers: 0.05,
        outlier_size: 0.3,
        ..Corruption::default()
    };
    let positions = corrupted(&noise, 1, 9);
    let jumps: Vec<[f64; 3]> = positions
        .iter()
        .map(|row| row[0].expect("seen"))
        .filter(|point| *point != [0.0; 3])
        .collect();
    let (count, n) = (jumps.len() as f64, SAMPLES as f64);
    let error = (0.05 * 0.95 / n).sqrt();
    assert!((count / n - 0.05).abs() < 4.5 * error, "{count}");
    let variance = jumps.iter().flatten().map(|x| x * x).sum::<f64>() / (3.0 * count);
    let error = (2.0 / (3.0 * count)).sqrt();
    assert!((variance / 0.09 - 1.0).abs() < 4.5 * error, "{variance}");
}

#[test]
fn dropouts_are_as_many_as_asked_half_singly_and_half_in_runs() {
    for fraction in [0.02, 0.2, 0.9] {
        let noise = Corruption {
            dropouts: fraction,
            ..Corruption::default()
        };
        let positions = corrupted(&noise, 4, 11);
        let hidden: Vec<Vec<bool>> = (0..4)
            .map(|marker| positions.iter().map(|row| row[marker].is_none()).collect())
            .collect();
        let all = hidden.iter().flatten().filter(|hidden| **hidden).count() as f64;
        let n = 4.0 * SAMPLES as f64;
        // Half of the hidden samples come some eight at a time.
        let error = (fraction * 5.0 / n).sqrt();
        assert!(
            (all / n - fraction).abs() < 4.5 * error,
            "{fraction}: {}",
            all / n
        );
        if fraction > 0.1 {
            continue;
        }
        // Where they are few, runs and single ones seldom meet.
        let runs: Vec<usize> = hidden
            .iter()
            .flat_map(|marker| marker.split(|hidden| !hidden))
            .map(<[bool]>::len)
            .filter(|length| *length > 0)
            .collect();
        let single = runs.iter().filter(|length| **length <= 2).sum::<usize>() as f64;
        assert!((single / all - 0.5).abs() < 0.1, "{}", single / all);
        assert!(runs.iter().all(|length| *length < 40));
        assert!((3..=12).all(|length| runs.contains(&length)));
    }
}

#[test]
fn the_first_samples_are_hidden_as_often_as_later_ones() {
    let noise = Corruption {
        dropouts: 0.3,
        ..Corruption::default()
    };
    let hidden = (0..4000).filter(|&seed| {
        let mut positions = vec![vec![Some([0.0; 3])]];
        corrupt(&mut positions, &noise, seed);
        positions[0][0].is_none()
    });
    let found = hidden.count() as f64 / 4000.0;
    assert!(
        (found - 0.3).abs() < 4.5 * (0.21_f64 / 4000.0).sqrt(),
        "{found}"
    );
}

#[test]
fn a_seed_makes_the_same_bits_on_every_machine() {
    let noise = Corruption {
        ar1: 0.4,
        outliers: 0.1,
        dropouts: 0.3,
        ..Corruption::default()
    };
    assert_eq!(corrupted(&noise, 2, 1), corrupted(&noise, 2, 1));
    assert_ne!(corrupted(&noise, 2, 1), corrupted(&noise, 2, 2));
    let seen = corrupted(&Corruption::default(), 1, 42);
    let first: Vec<String> = seen[..3]
        .iter()
        .map(|row| format!("{:.9}", row[0].expect("seen")[0]))
        .collect();
    assert_eq!(first, ["0.000104142", "0.000199407", "0.000393865"]);
}

#[test]
fn noise_that_makes_no_sense_is_refused() {
    let wrong = |change: &dyn Fn(&mut Corruption)| {
        let mut noise = Corruption::default();
        change(&mut noise);
        noise.check().expect_err("it makes no sense").to_string()
    };
    assert!(wrong(&|noise| noise.sigma = -1.0).starts_with("noise-sigma: found -1"));
    assert!(wrong(&|noise| noise.sigma = f64::NAN).starts_with("noise-sigma: found NaN"));
    assert!(wrong(&|noise| noise.ar1 = 1.0).starts_with("noise-ar1"));
    assert!(wrong(&|noise| noise.outliers = 1.5).starts_with("outliers"));
    assert!(wrong(&|noise| noise.outlier_size = f64::INFINITY).starts_with("outlier-size"));
    assert!(wrong(&|noise| noise.dropouts = 1.0).starts_with("dropouts"));
    Corruption::default().check().expect("the default");
}
