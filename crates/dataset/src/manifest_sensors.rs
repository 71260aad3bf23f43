//! Parser of the `[[sensors]]` entries of `dataset.toml`.

use toml::de::DeTable;

use super::fields::{Entry, Fields};
use super::unplaced::Unplaced;
use super::words::{listed, meant, shown};
use super::{Marker, Sensor, SensorKind};
use crate::input_error::InputError;

/// Value of the key `kind` in an entry of `[[sensors]]` that declares a marker.
const MARKER: &str = "marker";

const KEYS: [&str; 5] = ["name", "kind", "position", "sigma", "sigma_angle"];

impl Fields<'_> {
    pub(super) fn sensors(
        &self,
        document: &DeTable<'_>,
        (markers, unplaced): (&mut Vec<Marker>, &mut Vec<Unplaced>),
        sigma: &mut Option<f64>,
    ) -> Result<Vec<Sensor>, InputError> {
        let tables = self.entries(document, "sensors")?;
        if tables.is_empty() && markers.is_empty() && !document.contains_key("summaries") {
            let expected = "at least one marker or sensor: what was measured";
            return Err(self.fault(0..0, "no [[markers]] and no [[sensors]]", expected));
        }
        let mut sensors: Vec<Sensor> = Vec::new();
        for entry in &tables {
            self.keys(entry.1, " in [[sensors]]", &KEYS)?;
            let (name, span) = self.name(entry, "sensor")?;
            let own = sensors.iter().map(|sensor| sensor.name.as_str());
            let others = markers.iter().map(|marker| marker.name.as_str());
            if name == "t" || own.chain(others).any(|other| other == name) {
                let found = format!("a second column or sensor {}", shown(&name));
                return Err(self.fault(span, found, "each name once"));
            }
            let kind = self.kind(entry)?;
            let stated = entry.1.get("position");
            let position = stated
                .map(|value| self.position(value, "sensor"))
                .transpose()?;
            let position_is_unknown = position == Some(None);
            if let (true, None, Some(value)) = (position_is_unknown, kind, stated) {
                unplaced.push(self.unplaced(markers.len(), value));
            }
            let position = position.flatten().unwrap_or_default();
            let own_sigma = self.deviation(entry.1, "sigma")?;
            let sigma_angle = self.deviation(entry.1, "sigma_angle")?;
            if sigma_angle.is_some() && kind != Some(SensorKind::Pose) {
                let expected = "sigma_angle only with kind = \"pose\"";
                return Err(self.fault(entry.0.clone(), "sigma_angle", expected));
            }
            match kind {
                Some(kind) => sensors.push(Sensor {
                    name,
                    kind,
                    position,
                    position_is_unknown,
                    sigma: own_sigma,
                    sigma_angle,
                }),
                None => {
                    if let (Some(own), Some(other)) = (own_sigma, *sigma)
                        && own != other
                    {
                        let found = format!("sigma = {own} and sigma = {other}");
                        let expected = "one standard deviation for all markers";
                        return Err(self.fault(entry.0.clone(), found, expected));
                    }
                    *sigma = own_sigma.or(*sigma);
                    markers.push(Marker { name, position });
                }
            }
        }
        Ok(sensors)
    }

    /// Reads the kind of a sensor from its entry of `[[sensors]]`; `None` if the entry declares a marker.
    fn kind(&self, entry: &Entry<'_, '_>) -> Result<Option<SensorKind>, InputError> {
        let all = || {
            SensorKind::ALL
                .iter()
                .map(|(_, name)| *name)
                .chain([MARKER])
        };
        let expected = format!("kind, one of {}", listed(all()));
        let value = self.needed(entry, "kind", &expected)?;
        let kind = self.text(value, "kind", &expected)?;
        if kind == MARKER {
            return Ok(None);
        }
        let mut known = SensorKind::ALL.iter();
        match known.find(|(_, name)| *name == kind) {
            Some((found, _)) => Ok(Some(*found)),
            None => {
                let expected = format!("one of {}{}", listed(all()), meant(&kind, all()));
                Err(self.refused(value, "kind", shown(&kind), expected))
            }
        }
    }

    /// Standard deviation of a sensor's noise, in the unit of its readings (`sigma`) or in rad (`sigma_angle`).
    pub(super) fn deviation(
        &self,
        table: &DeTable<'_>,
        key: &str,
    ) -> Result<Option<f64>, InputError> {
        let Some(value) = table.get(key) else {
            return Ok(None);
        };
        let number = self.number(value, key)?;
        if number > 0.0 {
            return Ok(Some(number));
        }
        let expected = "a standard deviation above 0";
        Err(self.refused(value, key, number, expected))
    }
}
