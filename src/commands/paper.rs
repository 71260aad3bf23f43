//! `hyzer paper`: the paper's claims against every reading of its tables.

use crate::cli::Paper;
use crate::{Answer, output};

/// Flies both flights under every reading and writes the page.
pub fn run(options: &Paper) -> anyhow::Result<Answer> {
    let study = paper::study::Study::run().map_err(anyhow::Error::msg)?;
    let page = paper::page::page(&study);
    match &options.out {
        Some(file) => {
            output::write(file, page)?;
            eprintln!(
                "{} readings flown; the page is {}",
                study.ranking.len(),
                file.display()
            );
        }
        None => output::print(page)?,
    }
    Ok(Answer::Yes)
}
