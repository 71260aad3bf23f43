//! Renders docs/studies/real-data.md.

use super::balls::{balls_figure, balls_section};
use super::disc_golf::disc_golf_section;
use super::disc_pose::{disc_pose_section, ratio_figure};
use super::results::RealData;
use super::spin_decay::{spin_decay_figure, spin_decay_section};
use super::wind_tunnel::{effects_section, paper_flights_section, tunnel_figure, tunnel_section};
use crate::error::StudyError;
use crate::page::Page;

/// Renders docs/studies/real-data.md, the page on the fits and diagnoses of measured flights, with its figures.
///
/// # Errors
/// [`StudyError`] if a template cannot be rendered with the results, or a required fit is missing.
pub fn real_data_page(data: &RealData) -> Result<Page, StudyError> {
    let sections = [
        include_str!("page.md").to_owned(),
        balls_section(&data.balls)?,
        spin_decay_section(&data.spin_decay)?,
        disc_pose_section(&data.disc_pose)?,
        tunnel_section(&data.disc, &data.table)?,
        effects_section(&data.table)?,
        paper_flights_section(&data.disc, &data.table)?,
        disc_golf_section(&data.disc_golf)?,
    ];
    let tunnel = tunnel_figure(&data.disc, &data.table);
    Ok(Page {
        text: sections.join("\n"),
        figures: vec![
            ("real-data-spin.svg".into(), balls_figure(&data.balls)),
            (
                "real-data-spin-down.svg".into(),
                spin_decay_figure(&data.spin_decay),
            ),
            ("real-data-ratio.svg".into(), ratio_figure(&data.disc_pose)),
            ("real-data-tunnel.svg".into(), tunnel),
        ],
    })
}
