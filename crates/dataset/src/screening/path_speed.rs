//! The speed that measured positions show, beside that of an instrument.

use nalgebra::Vector3;

use crate::sensor::pose_sensors;
use crate::statistics::median_of;
use crate::{Dataset, Flight};

/// Time over which the path is compared, s: markers beside the axis turn about it meanwhile, and add no length.
const CHORD: f64 = 0.2;

/// Unit of the speeds in `channel`, m/s: the median ratio of the speed along the path to the reading. `None` where no
/// positions are measured.
pub fn apparent_unit(dataset: &Dataset, flight: &Flight, channel: usize) -> Option<f64> {
    let poses = pose_sensors(&dataset.sensors);
    let places: Vec<usize> = poses.map(|(_, channel)| channel).collect();
    let positions = |sample: usize| -> Vec<Option<Vector3<f64>>> {
        let markers = flight.positions[sample].iter().copied();
        let row = flight.readings.get(sample);
        let poses = places.iter().map(|place| {
            let [x, y, z, _] = (*row?.get(*place)?)?;
            Some([x, y, z])
        });
        let all = markers.chain(poses);
        all.map(|point| point.map(Vector3::from)).collect()
    };
    let reading = |sample: usize| Some((*flight.readings.get(sample)?.get(channel)?)?[0]);
    let mut last = 0;
    let ratios = (0..flight.times.len()).filter_map(|first| {
        while last < flight.times.len() && flight.times[last] < flight.times[first] + CHORD {
            last += 1;
        }
        let read = median_of((first..=last.min(flight.times.len() - 1)).filter_map(reading))?;
        let time = flight.times.get(last)? - flight.times[first];
        let ends = positions(first).into_iter().zip(positions(last));
        let speeds = ends.filter_map(|(start, end)| Some((end? - start?).norm() / time));
        Some(median_of(speeds)? / read)
    });
    median_of(ratios.filter(|ratio| ratio.is_finite()).collect::<Vec<_>>())
}
