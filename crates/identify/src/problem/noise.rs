//! Noise groups of the channels of a problem, and the noise of each group by the residuals.

use std::collections::BTreeMap;

use super::FitProblem;
use crate::channel::{ATTITUDE, Channel, ChannelKind, MARKER, POSITION};
use crate::noise::{AxesNoise, Moments, NoiseModel, group_count};
use crate::rounding;

impl FitProblem {
    /// Noise group of each channel; the channels of a group have common noise parameters.
    pub fn noise_groups(&self) -> Vec<usize> {
        self.channels.iter().map(|channel| channel.group).collect()
    }

    /// Noise of each group by `moments` after a fit of `unknowns` unknowns, for a sampling interval in s; given
    /// standard deviations replace the estimated ones.
    pub fn noise_of(&self, moments: &[Moments], unknowns: usize, interval: f64) -> NoiseModel {
        let all: usize = moments.iter().map(|sum| sum.count).sum();
        let groups = moments.iter().enumerate().map(|(group, sum)| {
            let of_group = self.channels.iter().find(|channel| channel.group == group);
            let given = of_group.and_then(|channel| Some(channel.sigma? * channel.scale));
            // The unknowns are distributed over the groups in proportion to their residuals.
            let unknowns = (unknowns * sum.count).div_ceil(all.max(1));
            let mut noise = sum.noise(unknowns, interval, given);
            if given.is_none() {
                let least = self.rounding(group);
                noise.sigma = [0, 1, 2].map(|axis| noise.sigma[axis].max(least[axis]));
            }
            noise
        });
        NoiseModel::of_groups(groups.collect(), self.noise_groups())
    }

    /// Standard deviation of the rounding errors of a noise group along each axis, m: the greatest of its channels.
    pub(crate) fn rounding(&self, group: usize) -> [f64; 3] {
        rounding::of_group(&self.channels, group)
    }

    /// [`rounding`](Self::rounding) of every noise group.
    pub(crate) fn rounding_of_groups(&self) -> Vec<[f64; 3]> {
        let groups = 0..group_count(&self.noise_groups());
        groups.map(|group| self.rounding(group)).collect()
    }

    /// Creates empty sums of squares and products of residuals, one `Moments` for each noise group.
    pub fn no_moments(&self) -> Vec<Moments> {
        vec![Moments::default(); group_count(&self.noise_groups())]
    }

    /// Noise of the positions together, or of all channels without positions: by axis, the root mean square of their
    /// standard deviations, m, and the mean of their autocorrelations.
    pub(crate) fn position_noise(&self, noise: &NoiseModel) -> AxesNoise {
        let scored = (0..self.channels.len()).filter(|channel| self.is_scored(*channel));
        let count = scored.clone().count().max(1) as f64;
        let mean = |of: &dyn Fn(&AxesNoise) -> f64| {
            scored
                .clone()
                .map(|channel| of(noise.of(channel)))
                .sum::<f64>()
                / count
        };
        AxesNoise {
            sigma: [0, 1, 2].map(|axis| mean(&|own| own.sigma[axis].powi(2)).sqrt()),
            ar1: [0, 1, 2].map(|axis| mean(&|own| own.ar1[axis])),
            interval: noise.interval,
        }
    }

    /// What a channel measures, as reports name it; `None` of a summary that is not compared with its prediction.
    pub(crate) fn measures(&self, channel: &Channel) -> Option<&'static str> {
        match channel.kind {
            ChannelKind::Marker(_) => Some(MARKER),
            ChannelKind::Position => Some(POSITION),
            ChannelKind::Attitude => Some(ATTITUDE),
            ChannelKind::Instrument(place) => Some(self.instruments[place].0.name()),
            ChannelKind::Summary(_) => channel.summary(),
        }
    }

    /// Kind of sensor with which reports count a channel: positions of poses with markers, or not at all next to them.
    pub(crate) fn kind(&self, channel: usize) -> Option<&'static str> {
        match self.measures(&self.channels[channel])? {
            POSITION => self.is_scored(channel).then_some(MARKER),
            kind => Some(kind),
        }
    }

    /// Standard deviation, in the unit of the sensor, and lag-1 autocorrelation of the noise of each kind of sensor: the
    /// root mean square and the mean of its channels.
    pub fn noise_by_kind(&self, noise: &NoiseModel) -> BTreeMap<&'static str, [f64; 2]> {
        let mut sums: BTreeMap<&str, [f64; 3]> = BTreeMap::new();
        for (index, channel) in self.channels.iter().enumerate() {
            let Some(kind) = self.kind(index) else {
                continue;
            };
            let own = noise.of(index);
            let sum = sums.entry(kind).or_default();
            sum[0] += (own.overall() / channel.scale).powi(2);
            sum[1] += own.ar1.iter().sum::<f64>() / 3.0;
            sum[2] += 1.0;
        }
        let sums = sums.into_iter();
        let means = sums
            .map(|(kind, [squares, ar1, count])| (kind, [(squares / count).sqrt(), ar1 / count]));
        means.collect()
    }
}
