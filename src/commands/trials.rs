//! `hyzer trials`: what a fit is worth, tried on made and on measured flights.

use std::path::Path;

use trials::discovery::{self, plan::Row};
use trials::page::{self, Page, RealData, identification, peers, real_data};
use trials::{coverage, replay};

use crate::cli::{Trials, TrialsDiscovery, TrialsOf};
use crate::{Answer, output};

/// Runs the trials and writes their page.
pub fn run(options: &Trials) -> anyhow::Result<Answer> {
    let (page, out) = match &options.of {
        TrialsOf::Identification(options) => {
            let mut coverages = Vec::new();
            for condition in coverage::conditions() {
                eprintln!("{} seeds under {} noise", options.seeds, condition.name);
                coverages.push(coverage::coverage(
                    &coverage::TWELVE,
                    &condition,
                    options.seeds,
                ));
            }
            eprintln!("the paper's flights, {} seeds", options.seeds);
            let replay = replay::replay(options.seeds);
            (identification(&coverages, &replay), &options.out)
        }
        TrialsOf::RealData(options) => {
            let data = RealData::of(&options.data).map_err(anyhow::Error::msg)?;
            (real_data(&data), &options.out)
        }
        TrialsOf::Discovery(options) => {
            let page = discovered(options)?;
            let page = beside_peers(page, options.out.as_deref());
            (page, &options.out)
        }
    };
    match out {
        Some(file) => write(file, &page)?,
        None => output::print(page.text)?,
    }
    Ok(Answer::Yes)
}

/// Has what is hidden sought, and tells of each run where that is asked for.
fn discovered(options: &TrialsDiscovery) -> anyhow::Result<Page> {
    let mut rows = discovery::plan::plan(options.seeds as usize);
    if let Some(words) = &options.only {
        rows.retain(|row| row.has(words));
        anyhow::ensure!(!rows.is_empty(), "no row has the words `{words}`");
    }
    let runs: usize = rows.iter().map(|row: &Row| row.runs).sum();
    eprintln!("{} rows, {runs} runs", rows.len());
    let tried = discovery::discovery(&rows, &|done, of| {
        if done % (of / 20).max(1) == 0 {
            eprintln!("{done} of {of} runs");
        }
    });
    if options.details {
        for (tried, rejections) in tried.iter().zip(discovery::rejections(&tried)) {
            let lines = page::details(tried, &rejections);
            output::print(lines.join("\n") + "\n")?;
        }
    }
    Ok(page::discovery(&tried))
}

/// The page with the peers' tables, where their page stands beside it.
fn beside_peers(page: Page, out: Option<&Path>) -> Page {
    let peers = out.map(|file| file.with_file_name("discovery-peers.md"));
    let peers = peers.and_then(|file| std::fs::read_to_string(file).ok());
    match peers.and_then(|text| peers::section(&text)) {
        Some(section) => Page {
            text: peers::beside(&page.text, &section),
            ..page
        },
        None => page,
    }
}

/// Writes a page, and its figures beside it.
fn write(file: &Path, page: &Page) -> anyhow::Result<()> {
    for (name, svg) in &page.figures {
        output::write(&file.with_file_name(name), svg)?;
    }
    output::write(file, &page.text)?;
    eprintln!("the page is {}", file.display());
    Ok(())
}
