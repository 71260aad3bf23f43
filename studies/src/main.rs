//! The program `hyzer-studies`: each subcommand runs one study and writes its page.

mod cli;
mod output;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use anyhow::Context;
use clap::Parser;
use studies::Page;
use studies::bodies::{bodies_page, curves, filmed, turns_and_fades};
use studies::cuts::{CutSection, bounces, free_flights};
use studies::discovery::{
    Case, details, discovery_page, peer_section, plan, rejections, run_rows, with_peer_section,
};
use studies::fits::{FitCase, fits, fits_page};
use studies::identification::{coverage, identification_page, paper_fits};
use studies::oracle_flights::{TWELVE, noise_conditions};
use studies::others::{others, others_page};
use studies::own_models::{self, own_models_page};
use studies::paper::{Study, paper_page};
use studies::real_data::{RealData, real_data_page};
use studies::sensors::{sensors, sensors_page};
use studies::spoiled::{self, spoiled_page};
use studies::takes::takes_page;
use studies::throws::{launches, rolls, throws_page, winds};
use studies::wild::{cases, wild, wild_page};

fn main() -> ExitCode {
    match run(cli::Cli::parse().study) {
        Ok(()) => ExitCode::SUCCESS,
        // A closed pipe is not an error to report.
        Err(error) if output::is_broken_pipe(&error) => ExitCode::from(2),
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::from(2)
        }
    }
}

fn run(study: cli::Study) -> anyhow::Result<()> {
    let (page, out) = match study {
        cli::Study::Paper(options) => (paper()?, options.out),
        cli::Study::Others(options) => (others_page(&others()?)?, options.out),
        cli::Study::Identification(options) => (identification(options.seeds)?, options.out),
        cli::Study::RealData(options) => {
            let data = RealData::of(&options.data)?;
            (real_data_page(&data)?, options.out)
        }
        cli::Study::Discovery(options) => match discovery(options)? {
            Some(page_and_file) => page_and_file,
            None => return Ok(()),
        },
        cli::Study::Fits(options) => (random_fits(&options)?, options.out),
        cli::Study::OwnModels(options) => (models_of_users(&options)?, options.out),
        cli::Study::Spoiled(options) => (spoiled_datasets(&options)?, options.out),
        cli::Study::Sensors(options) => {
            let seeds = options.seeds.unwrap_or(100);
            let done = |set: &str| eprintln!("{set}");
            let sets = sensors(seeds, seeds.div_ceil(5), options.threads(), &done);
            (sensors_page(&sets, seeds)?, options.out)
        }
        cli::Study::Throws(options) => (
            throws_page(&launches()?, &rolls()?, &winds()?)?,
            options.out,
        ),
        cli::Study::Bodies(options) => (bodies(options.data.as_deref())?, options.out),
        cli::Study::Takes(options) => (takes(&options)?, options.runs.out),
        cli::Study::Wild(options) => match in_the_wild(&options)? {
            Some(page) => (page, options.runs.out),
            None => return Ok(()),
        },
        cli::Study::Cuts(options) => {
            let cuts = cut_section(options.seeds.unwrap_or(100), options.threads());
            (spoiled_page(&[], Some(cuts))?, options.out)
        }
    };
    match out {
        Some(file) => output::write_page(&file, &page),
        None => output::print(page.text),
    }
}

fn paper() -> anyhow::Result<Page> {
    let study = Study::run()?;
    eprintln!("{} readings flown", study.ranking.len());
    Ok(paper_page(&study)?)
}

fn bodies(data: Option<&Path>) -> anyhow::Result<Page> {
    let filmed = match data {
        Some(folder) => filmed(&folder.join("discgolf"))?,
        None => Vec::new(),
    };
    let flights = turns_and_fades(&[16.0, 20.0, 24.0], 1.0)?;
    Ok(bodies_page(&curves(-20, 40)?, &flights, &filmed)?)
}

fn identification(seeds: u64) -> anyhow::Result<Page> {
    let coverages = noise_conditions().into_iter().map(|condition| {
        eprintln!("{seeds} seeds under {} noise", condition.name);
        coverage(&TWELVE, &condition, seeds)
    });
    let coverages: Vec<_> = coverages.collect();
    eprintln!("the paper's flights, {seeds} seeds");
    Ok(identification_page(&coverages, &paper_fits(seeds))?)
}

/// Prints the numbers of finished runs and of all runs to standard error, each time another twentieth of all runs has
/// finished.
fn report_progress(done: usize, of: usize) {
    if done.is_multiple_of((of / 20).max(1)) {
        eprintln!("{done} of {of} runs");
    }
}

/// Seed given as `--only '#SEED'`; `None` if the option is absent or its value does not start with `#`.
fn single_seed(options: &cli::Runs) -> anyhow::Result<Option<u64>> {
    let seed = options
        .only
        .as_deref()
        .and_then(|only| only.strip_prefix('#'));
    let seed = seed.map(str::parse).transpose();
    seed.context("a seed is a number")
}

fn takes(options: &cli::Takes) -> anyhow::Result<Page> {
    let seeds = match single_seed(&options.runs)? {
        Some(seed) => vec![seed],
        None if options.runs.only.is_none() => (0..options.runs.seeds.unwrap_or(200)).collect(),
        None => anyhow::bail!("--only: expected a seed, such as '#7'"),
    };
    let (python, threads) = (options.python.as_deref(), options.runs.threads());
    let sessions = studies::takes::sessions(&seeds, python, threads, &report_progress);
    Ok(takes_page(&sessions)?)
}

fn random_fits(options: &cli::Runs) -> anyhow::Result<Page> {
    let words = options.only.as_deref().unwrap_or_default();
    let seeds: Vec<u64> = match single_seed(options)? {
        Some(seed) => vec![seed],
        None => {
            let has_words = |seed: &u64| {
                words.is_empty() || {
                    let names = FitCase::of(*seed).names().join(" ");
                    words.split_whitespace().all(|word| names.contains(word))
                }
            };
            let all = 0..options.seeds.unwrap_or(1000);
            all.filter(has_words).collect()
        }
    };
    anyhow::ensure!(!seeds.is_empty(), "no fit has the words `{words}`");
    let outcomes = fits(&seeds, options.threads(), &report_progress);
    Ok(fits_page(&outcomes)?)
}

/// Page of the study of datasets in the wild; `None` if they are to be written and not fitted.
fn in_the_wild(options: &cli::Wild) -> anyhow::Result<Option<Page>> {
    let runs = &options.runs;
    let words = runs.only.as_deref().unwrap_or_default();
    let seeds = runs.seeds.unwrap_or(16);
    let cases = cases(seeds, words);
    anyhow::ensure!(!cases.is_empty(), "no dataset has the words `{words}`");
    if let Some(folder) = &options.write {
        for case in &cases {
            let name = case.class().replace([':', ','], "").replace(' ', "_");
            case.write(&folder.join(format!("{name}_{}", case.run)))?;
        }
        return Ok(None);
    }
    let threads = runs.threads();
    let outcomes = wild(&cases, options.diagnose_every, threads, &report_progress);
    Ok(Some(wild_page(&outcomes, seeds, options.diagnose_every)?))
}

fn models_of_users(options: &cli::Runs) -> anyhow::Result<Page> {
    let words = options.only.as_deref().unwrap_or_default();
    let tasks = own_models::tasks(options.seeds.unwrap_or(1), words);
    anyhow::ensure!(!tasks.is_empty(), "no row has the words `{words}`");
    let outcomes = own_models::own_models(&tasks, options.threads(), &report_progress);
    Ok(own_models_page(&outcomes)?)
}

fn spoiled_datasets(options: &cli::Runs) -> anyhow::Result<Page> {
    let words = options.only.as_deref().unwrap_or_default();
    let kinds = spoiled::runs(words);
    anyhow::ensure!(!kinds.is_empty(), "no kind has the words `{words}`");
    let (seeds, threads) = (options.seeds.unwrap_or(3), options.threads());
    let runs = spoiled::spoiled(&kinds, seeds, threads, &report_progress);
    let cuts = words.is_empty().then(|| cut_section(100, threads));
    Ok(spoiled_page(&runs, cuts)?)
}

/// Results of the study of truncation at ground contact. Fits `datasets` datasets of flights without ground contact,
/// and a quarter as many datasets of flights that bounce.
fn cut_section(datasets: u64, threads: usize) -> CutSection {
    let free = free_flights(datasets as usize, threads, &report_progress);
    let bounces = bounces(datasets.div_ceil(4) as usize, threads, &report_progress);
    CutSection::new(&free, &bounces)
}

/// Executes the runs (diagnoses of simulated datasets) of all selected rows of the discovery study's table. Prints a
/// line for each run if `--details` is given. Returns the page, and the output file given as `--out`; `None` means that
/// the page is to be printed.
fn discovery(options: cli::Discovery) -> anyhow::Result<Option<(Page, Option<PathBuf>)>> {
    let cli::Discovery {
        runs: options,
        details: with_details,
        write,
    } = options;
    let mut rows = plan(options.seeds.unwrap_or(100) as usize);
    if let Some(words) = &options.only {
        rows.retain(|row| row.has(words));
        anyhow::ensure!(!rows.is_empty(), "no row has the words `{words}`");
    }
    if let Some(folder) = &write {
        for (row, run) in rows
            .iter()
            .flat_map(|row| (0..row.runs).map(move |run| (row, run)))
        {
            let name = row.key().replace(' ', "_");
            Case::of(row, run).write(&folder.join(format!("{name}_{run}")))?;
        }
        return Ok(None);
    }
    let runs: usize = rows.iter().map(|row| row.runs).sum();
    eprintln!("{} rows, {runs} runs", rows.len());
    let results = run_rows(&rows, options.threads(), &report_progress);
    if with_details {
        for (result, rejections) in results.iter().zip(rejections(&results)) {
            let lines = details(result, &rejections);
            output::print(lines.join("\n") + "\n")?;
        }
    }
    let page = discovery_page(&results)?;
    let page = with_peer_tables(page, options.out.as_deref());
    Ok(Some((page, options.out)))
}

/// Inserts a section with the results of other programs (pysindy, stepwise regression) into the discovery study's page,
/// if discovery-peers.md is in the folder of the output file.
fn with_peer_tables(page: Page, out: Option<&Path>) -> Page {
    let peers = out.map(|file| file.with_file_name("discovery-peers.md"));
    let peers = peers.and_then(|file| std::fs::read_to_string(file).ok());
    match peers.and_then(|text| peer_section(&text)) {
        Some(section) => Page {
            text: with_peer_section(&page.text, &section),
            ..page
        },
        None => page,
    }
}
