//! The page.

use crate::flights::Timed;
use crate::{Measured, TITLES, counts};
use lanes::Isa;
use serde_json::Value;
use std::fmt::Write;
use std::path::Path;

/// Greatest ratios to the fastest peer that we allow ourselves: f, f+J+Jp, one lane of f+J+Jp.
const BARS: [(usize, f64); 2] = [(0, 0.7), (2, 0.6)];
const LANE_BAR: f64 = 0.2;
const FLIGHT_BAR: f64 = 1000.0;

fn verdict(holds: bool) -> &'static str {
    if holds { "holds" } else { "**missed**" }
}

/// All of it, as Markdown.
pub fn page(
    root: &Path,
    m: &Measured,
    flown: Result<Vec<Timed>, String>,
    frispy: Option<Value>,
    results: &Value,
) -> String {
    let mut page = format!(
        "# Benchmarks\n\n\
        `python3 benches/peers/run.py --compare` makes this page: it installs the peers in an environment of their own, has them \
        generate the same disc, compiles them with their best flags, and times them and us in one process, function by function in \
        turn, {} rounds of {} states each. Figures are medians of that run, ns a state, on {}. Our build is the portable one.\n\n",
        m.rounds,
        crate::PASSES * 1000,
        machine(results)
    );
    functions(&mut page, m);
    bars(&mut page, m);
    operations(&mut page, root, m);
    flights(&mut page, flown, frispy);
    page
}

fn machine(results: &Value) -> String {
    let cpu = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let name = cpu.lines().find_map(|line| line.strip_prefix("model name"));
    let name = name.map_or("an unknown processor", |n| {
        n.trim_start_matches([' ', '\t', ':'])
    });
    let of = |tool: &str| results["machine"][tool].as_str().unwrap_or("?").to_string();
    let threads = flight::parallel::threads();
    format!("{name}, {threads} threads, {}, {}", of("gcc"), of("rustc"))
}

/// Time of the fastest peer.
fn fastest(m: &Measured, function: usize) -> f64 {
    let of = m
        .peers
        .iter()
        .zip(&m.peer_ns)
        .filter(|(peer, _)| peer.function == function);
    of.map(|(_, ns)| *ns).fold(f64::INFINITY, f64::min)
}

fn functions(page: &mut String, m: &Measured) {
    let best: Vec<f64> = (0..3).map(|function| fastest(m, function)).collect();
    *page += "## The functions of the disc\n\n\
        `best`: the chain rule done by hand where that is faster; `plain`: left to the tool. In brackets the ratio to the fastest peer.\n\n\
        | | f | f+J | f+J+Jp | worst difference from ours |\n|---|---:|---:|---:|---:|\n";
    for (i, first) in m
        .peers
        .iter()
        .enumerate()
        .filter(|(_, peer)| peer.function == 0)
    {
        let cells: Vec<String> = (0..3)
            .map(|k| {
                format!(
                    "{:.1} ({:.2})",
                    m.peer_ns[i + k],
                    m.peer_ns[i + k] / best[k]
                )
            })
            .collect();
        let worst = m.differences[i..i + 3]
            .iter()
            .fold(0.0, |a: f64, b| a.max(*b));
        _ = writeln!(
            page,
            "| {}, {} | {} | {worst:.1e} |",
            first.name,
            first.set,
            cells.join(" | ")
        );
    }
    for (i, times) in m.our_ns.iter().enumerate() {
        let cells: Vec<String> = times
            .iter()
            .zip(&best)
            .map(|(ns, best)| format!("{ns:.1} ({:.2})", ns / best))
            .collect();
        let (title, bits) = match i.checked_sub(1).map(|i| m.isas[i]) {
            None => ("f64".to_string(), "is ours".to_string()),
            Some((isa, 0.0)) => (format!("one lane, {}", isa.name()), "same bits".to_string()),
            Some((isa, apart)) if isa.fuses() == Isa::best().fuses() => {
                let title = format!("one lane, {}", isa.name());
                (title, format!("{apart:.1e}: **other bits**"))
            }
            // Without fused operations the roundings are others.
            Some((isa, apart)) => {
                let title = format!("one lane, {}", isa.name());
                (title, format!("{apart:.1e}, not fused"))
            }
        };
        _ = writeln!(
            page,
            "| **hyzer**, {title} | {} | {bits} |",
            cells.join(" | ")
        );
    }
    let worst = m.differences.iter().fold(0.0, |a: f64, b| a.max(*b));
    _ = writeln!(
        page,
        "\nAll agree to {worst:.1e} of each row's magnitude on {} states with the parameters of {} flights (bar 1e-12: {}).\n\
        Ours take what depends on parameters alone from `prepare`, once a flight: {:.1} ns.\n",
        crate::FLIGHTS * crate::STEPS,
        crate::FLIGHTS,
        verdict(worst <= 1e-12),
        m.prepare_ns
    );
}

fn bars(page: &mut String, m: &Measured) {
    *page += "## The bars\n\n| | ns | fastest peer, ns | ratio | bar | |\n|---|---:|---:|---:|---:|---|\n";
    let mut row = |title: String, ns: f64, peer: f64, bar: f64| {
        let ratio = ns / peer;
        _ = writeln!(
            page,
            "| {title} | {ns:.1} | {peer:.1} | {ratio:.3} | {bar} | {} |",
            verdict(ratio <= bar)
        );
    };
    for (function, bar) in BARS {
        row(
            TITLES[function].to_string(),
            m.our_ns[0][function],
            fastest(m, function),
            bar,
        );
    }
    for ((isa, _), times) in m.isas.iter().zip(&m.our_ns[1..]) {
        row(
            format!("one lane of {}, {}", TITLES[2], isa.name()),
            times[2],
            fastest(m, 2),
            LANE_BAR,
        );
    }
    *page += "\n";
}

fn operations(page: &mut String, root: &Path, m: &Measured) {
    *page += "## Operations\n\nCounted by `benches/peers/count_ops.py`, the same for all; signs are free.\n\n\
        | | the leanest peer | ours | ours with all of `prepare` | |\n|---|---:|---:|---:|---|\n";
    let prepare = counts::ours(root, "prepare");
    for (function, name) in ["f", "f_jac", "f_jac_par"].into_iter().enumerate() {
        let of = m.peers.iter().filter(|peer| peer.function == function);
        let leanest = of
            .min_by_key(|peer| peer.fewest_operations)
            .expect("a peer");
        let (Some(ours), Some(prepare)) = (counts::ours(root, name), prepare) else {
            *page += "(python3 did not count)\n";
            return;
        };
        _ = writeln!(
            page,
            "| {} | {} ({}) | {ours} | {} | {} |",
            TITLES[function],
            leanest.fewest_operations,
            leanest.name,
            ours + prepare,
            verdict(ours + prepare <= leanest.fewest_operations)
        );
    }
    *page += "\n";
}

fn flights(page: &mut String, flown: Result<Vec<Timed>, String>, frispy: Option<Value>) {
    *page += "## Flights\n\nFrisPy 2.0.2 flies its default release to the landing by its own equations, which \
        `model-spec/refuted/frispy.hyz` says in our language; they are not those of a real disc (see there).\n\n";
    let flown = match flown {
        Ok(flown) => flown,
        Err(fault) => {
            _ = writeln!(page, "(not flown: {fault})");
            return;
        }
    };
    let milliseconds = |which: &str| frispy.as_ref().and_then(|f| f[which]["ms_median"].as_f64());
    let tight = milliseconds("to_landing_1e-6");
    *page +=
        "| | time | error at the landing | FrisPy's time at 1e-6 over it |\n|---|---:|---:|---:|\n";
    for (which, title) in [
        ("defaults", "FrisPy, everything default (1e-3, 3 s)"),
        ("to_landing", "FrisPy to the landing, its tolerance 1e-3"),
        (
            "to_landing_1e-6",
            "FrisPy to the landing, rtol 1e-6, atol 1e-9",
        ),
    ] {
        if let Some(ms) = milliseconds(which) {
            _ = writeln!(page, "| {title} | {ms:.2} ms | | |");
        }
    }
    for flight in &flown {
        let ratio = tight.map(|ms| 1e3 * ms / flight.microseconds);
        let ratio_text = ratio.map_or("?".to_string(), |ratio| match flight.error {
            Some(_) => format!(
                "{ratio:.0}: {} (bar {FLIGHT_BAR})",
                verdict(ratio >= FLIGHT_BAR)
            ),
            None => format!("{ratio:.0}"),
        });
        let error = flight.error.map_or(String::new(), |e| format!("{e:.1e}"));
        _ = writeln!(
            page,
            "| {} ({}) | {:.2} µs | {error} | {ratio_text} |",
            flight.title, flight.work, flight.microseconds
        );
    }
    *page += "\nOur backhand nutates at about 100 rad/s, which FrisPy's equations do not have: it takes many more steps.\n";
}
