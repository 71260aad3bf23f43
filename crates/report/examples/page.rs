//! The page of a fit that never was, to look at: `cargo run -p hyzer-report --example page -- FOLDER [FLIGHTS]`.

#[path = "../tests/integration/made/mod.rs"]
mod made;

use std::path::PathBuf;

use report::fit::FitPage;

fn main() -> std::io::Result<()> {
    let mut arguments = std::env::args().skip(1);
    let folder = PathBuf::from(arguments.next().unwrap_or_else(|| "page".into()));
    let flights = arguments.next().and_then(|n| n.parse().ok()).unwrap_or(4);
    let model = model_spec::load::load("disc", &[]).map_err(std::io::Error::other)?;
    let (report, evidence) = (made::report(flights), made::evidence(flights.min(12)));
    let page = FitPage {
        fit: None,
        report: &report,
        evidence: &evidence,
        model: &model,
        dataset: "made up",
    };
    println!("{}", report::fit::text(&page));
    std::fs::create_dir_all(&folder)?;
    let (html, figures) = report::fit::page(&page).parts();
    std::fs::write(folder.join("report.html"), html)?;
    for figure in figures {
        std::fs::write(folder.join(figure.name + ".svg"), figure.svg)?;
    }
    Ok(())
}
