//! `hyzer trials`: what a fit is worth, tried on made and on measured flights.

use std::path::Path;

use trials::page::{Page, RealData, identification, real_data};
use trials::{coverage, replay};

use crate::cli::{Trials, TrialsOf};
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
    };
    match out {
        Some(file) => write(file, &page)?,
        None => output::print(page.text)?,
    }
    Ok(Answer::Yes)
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
