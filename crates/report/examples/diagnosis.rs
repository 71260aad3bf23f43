//! The page of a diagnosis that never was, to look at:
//! `cargo run -p hyzer-report --example diagnosis -- FOLDER [VERDICT [FLIGHTS]]`.

#[path = "../tests/integration/found/mod.rs"]
mod found;
#[allow(dead_code)]
#[path = "../tests/integration/made/mod.rs"]
mod made;

use std::path::PathBuf;

use diagnose::Verdict;
use report::diagnosis::DiagnosisPage;

fn main() -> std::io::Result<()> {
    let mut arguments = std::env::args().skip(1);
    let folder = PathBuf::from(arguments.next().unwrap_or_else(|| "page".into()));
    let verdict = match arguments.next().as_deref() {
        Some("adequate") => Verdict::Adequate,
        Some("ambiguous") => Verdict::Ambiguous,
        Some("unattributed") => Verdict::Unattributed,
        Some("negligible") => Verdict::Negligible,
        _ => Verdict::Identified,
    };
    let flights = arguments.next().and_then(|n| n.parse().ok()).unwrap_or(9);
    let after = made::evidence(flights);
    let before = found::without(&after);
    let report = found::report(verdict, &after);
    let extended = report.extended_model.is_some();
    let page = DiagnosisPage {
        report: &report,
        fits: None,
        before: if verdict == Verdict::Adequate {
            &after
        } else {
            &before
        },
        after: if extended { &after } else { &[] },
        extended: extended.then_some(found::EXTENDED),
    };
    println!("{}", report::diagnosis::text(&report));
    let (html, figures) = report::diagnosis::page(&page).parts();
    std::fs::create_dir_all(&folder)?;
    std::fs::write(folder.join("report.html"), html)?;
    for figure in figures {
        std::fs::write(folder.join(figure.name + ".svg"), figure.svg)?;
    }
    Ok(())
}
