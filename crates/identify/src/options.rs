//! What is asked of a fit.

use std::sync::atomic::{AtomicBool, Ordering};

/// What is asked of a fit beside its dataset and its model.
#[derive(Clone, Copy, Debug, Default)]
pub struct FitOptions<'a> {
    /// Coefficients that are held: at a value (SI), or at that of the model's file.
    pub fixed: &'a [(String, Option<f64>)],
    /// Parameters and components of inputs (`wind_x`) that are estimated too, one value for all flights.
    pub free: &'a [String],
    /// What is known of coefficients beforehand.
    pub priors: &'a [Prior],
    /// Coefficients may leave the bounds of the model's file.
    pub unbounded: bool,
    /// Coefficients whose likelihood is profiled.
    pub profiles: &'a [String],
    /// Flights that are worked on at once: as many as the machine has processors, unless said otherwise. The result
    /// does not depend on it.
    pub threads: Option<usize>,
    /// Who looks on.
    pub watch: Option<&'a dyn Watch>,
}

/// A coefficient known beforehand, with a normal error.
#[derive(Clone, Debug, PartialEq)]
pub struct Prior {
    /// Which.
    pub name: String,
    /// Its value, SI.
    pub value: f64,
    /// Its standard deviation, SI.
    pub sigma: f64,
}

/// Somebody who watches a fit, and may stop it.
pub trait Watch: std::fmt::Debug + Sync {
    /// A stage of the work begins, of so many parts.
    fn begins(&self, stage: &str, parts: usize);
    /// One part of the stage is done.
    fn part_done(&self);
    /// Whether the work is to be given up.
    fn is_stopped(&self) -> bool;
}

impl FitOptions<'_> {
    pub(crate) fn begins(&self, stage: &str, parts: usize) {
        if let Some(watch) = self.watch {
            watch.begins(stage, parts);
        }
    }

    pub(crate) fn part_done(&self) {
        if let Some(watch) = self.watch {
            watch.part_done();
        }
    }

    pub(crate) fn is_stopped(&self) -> bool {
        self.watch.is_some_and(Watch::is_stopped)
    }

    /// How many flights are worked on at once.
    pub fn threads(&self) -> usize {
        self.threads.unwrap_or_else(flight::batch::threads).max(1)
    }
}

/// A watch that only says when to stop.
#[derive(Debug, Default)]
pub struct Stop(AtomicBool);

impl Stop {
    /// Gives the work up.
    pub fn stop(&self) {
        self.0.store(true, Ordering::Relaxed);
    }
}

impl Watch for Stop {
    fn begins(&self, _: &str, _: usize) {}
    fn part_done(&self) {}
    fn is_stopped(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}
