//! What measured data say, where they lie beside the checkout.

use std::path::PathBuf;

use trials::page::{RealData, real_data};

/// The folder of the measured data; none where it is not there, which is said.
fn measured() -> Option<PathBuf> {
    let folder = PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../../../shared/data"));
    let there = folder.join("spindoe").is_dir() && folder.join("windtunnel").is_dir();
    if !there {
        eprintln!("skipped: no measured data at {}", folder.display());
    }
    there.then_some(folder)
}

#[test]
fn measured_balls_and_a_wind_tunnel() {
    let Some(folder) = measured() else { return };
    let data = RealData::of(&folder).expect("the data");
    let drag = &data.ball().coefficients["C_D"];
    assert!((0.4..0.6).contains(&drag.value), "{drag:?}");
    let by_scatter = drag.std_error_clustered.expect("42 flights");
    assert!(by_scatter < 0.03 && drag.std_error < by_scatter, "{drag:?}");
    assert!(data.ball().rms_m < 0.02);
    assert!(
        data.ball()
            .flights
            .iter()
            .all(|flight| !flight.initial.is_empty())
    );
    let page = real_data(&data);
    // The parabola through the tunnel's drag, and the model's own slope of the lift beside the tunnel's.
    assert!(
        page.text.contains("| drag, -5° to 10° | 0.0868 | 5.40 |"),
        "{}",
        page.text
    );
    assert!(page.figures[0].1.contains("pitching moment"));
}
