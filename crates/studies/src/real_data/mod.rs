//! docs/real-data.md: what measured flights and a wind tunnel say.

pub mod balls;
pub mod disc_golf;
pub mod spin_decay;
pub mod wind_tunnel;

use std::path::Path;

use identify::{FitReport, dataset};
use model_spec::model::Model;

use crate::markdown::Text;
use crate::page::Page;
use crate::real_data::balls::Agreement;
use crate::real_data::disc_golf::Fitted;
use crate::real_data::spin_decay::{Fit, Form};
use crate::real_data::wind_tunnel::{Measured, read};

/// What was made of the measured data.
pub struct RealData {
    balls: balls::page::Balls,
    spin: spin_decay::page::Spindown,
    golf: disc_golf::page::Discgolf,
    table: Vec<Measured>,
    disc: Model,
}

impl RealData {
    /// The fit of the balls.
    pub fn ball(&self) -> &FitReport {
        &self.balls.plain
    }

    /// How the balls' spins fit their lifts: of all flights, of the agreeing stretches, of the others.
    pub fn agreement(&self) -> [Agreement; 3] {
        self.balls.agreeing
    }

    /// The fits of the agreeing stretches: gravity and drag, with lift by spin, and with its square.
    pub fn lift_by_spin(&self) -> &[FitReport; 3] {
        &self.balls.steps
    }

    /// The launches of the disc-golf throws, without and with factors on their disc's table.
    pub fn launches(&self) -> impl Iterator<Item = &[Option<Fitted>; 2]> {
        self.golf.fits()
    }

    /// The fit of a form of the spin's decay to the record of a disc in flight.
    pub fn spin_down(&self, form: Form) -> Option<&Fit> {
        self.spin.fit(form)
    }

    /// Fits and compares what is in a folder with `spindoe`, `spindown`, `windtunnel` and `discgolf`.
    ///
    /// # Errors
    /// In words, where a file is missing or malformed, or a fit fails.
    pub fn of(folder: &Path) -> Result<Self, String> {
        let flights = dataset::load(&folder.join("spindoe")).map_err(|error| error.to_string())?;
        let disc = crate::oracle_flights::disc();
        Ok(Self {
            balls: balls::page::Balls::of(&flights)?,
            spin: spin_decay::page::Spindown::of(&folder.join("spindown/flight.csv"), &disc)?,
            golf: disc_golf::page::Discgolf::of(&folder.join("discgolf"), &disc)?,
            table: read(&folder.join("windtunnel/potts_crowther.csv"))?,
            disc,
        })
    }
}

/// The page.
pub fn real_data(data: &RealData) -> Page {
    let mut text = Text::default();
    text.paragraph("# Measured data");
    text.paragraph("<!-- Written by `hyzer-studies real-data`; do not edit. -->");
    text.paragraph(
        "What the models say to data that nobody of this project made. The data are not part of the repository; where they lie \
         beside it, `hyzer-studies real-data --data ../shared/data --out docs/real-data.md` makes this page again.",
    );
    balls::page::section(&mut text, &data.balls);
    spin_decay::page::section(&mut text, &data.spin);
    wind_tunnel::page::tunnel(&mut text, &data.disc, &data.table);
    wind_tunnel::effects_page::section(&mut text, &data.table);
    wind_tunnel::paper_page::paper(&mut text, &data.disc, &data.table);
    disc_golf::page::section(&mut text, &data.golf);
    Page {
        text: text.finish(),
        figures: vec![
            ("real-data-spin.svg".into(), balls::page::drawn(&data.balls)),
            (
                "real-data-tunnel.svg".into(),
                wind_tunnel::page::drawn(&data.disc, &data.table),
            ),
        ],
    }
}
