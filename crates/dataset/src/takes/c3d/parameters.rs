//! Parameter section of a C3D file: groups of named values.

use std::collections::BTreeMap;

use super::bytes::{Bytes, Order};
use super::parameter::{Parameter, Shape, part};
use super::{C3dError, refuse};

/// Maximum total number of groups and parameters in a C3D file; a greater number is an error, which bounds the memory
/// used.
const MAX_ENTRIES: usize = 20_000;

/// Parameters of a C3D file by group and name, both in upper case.
pub(super) struct Parameters<'a> {
    groups: BTreeMap<String, u8>,
    parameters: BTreeMap<(u8, String), Parameter<'a>>,
    /// Byte offset of the parameter section in the file.
    start: usize,
    /// Byte offset in the file of the end of a parameter that extends past the parameter section; 0 if no parameter
    /// does.
    end_of_cut: usize,
}

impl<'a> Parameters<'a> {
    /// Parses the parameter section of a C3D file, which begins at byte `start` of the file and ends where the data
    /// begin. If a parameter extends past the section, the parameters before it are returned together with the fault.
    pub fn read(
        section: &'a [u8],
        start: usize,
        order: Order,
    ) -> Result<(Self, Option<C3dError>), C3dError> {
        let mut found = Self {
            groups: BTreeMap::new(),
            parameters: BTreeMap::new(),
            start,
            end_of_cut: 0,
        };
        // The section begins with two obsolete bytes, the number of blocks and the processor type.
        let mut at = 4;
        while let Some(&[length, id]) = section.get(at..).and_then(|rest| rest.first_chunk()) {
            let (length, id) = (length.cast_signed().unsigned_abs(), id.cast_signed());
            if length == 0 || id == 0 {
                break;
            }
            if found.groups.len() + found.parameters.len() >= MAX_ENTRIES {
                return refuse(
                    start + at,
                    "a parameter more",
                    format!("at most {MAX_ENTRIES}"),
                );
            }
            let name = part(section, start, at + 2, usize::from(length))?;
            let name = text(name).to_uppercase();
            at += 2 + usize::from(length);
            part(section, start, at, 2)?;
            let all = Bytes {
                bytes: section,
                order,
            };
            let offset = usize::from(all.u16(at));
            if id < 0 {
                found.groups.entry(name).or_insert(id.unsigned_abs());
            } else {
                let shape = Shape::read(section, start, at + 2, &name)?;
                let parameter = match shape.parameter(section, start, order) {
                    Ok(parameter) => parameter,
                    Err(cut) => {
                        found.end_of_cut = start.saturating_add(shape.end());
                        return Ok((found, Some(cut)));
                    }
                };
                let key = (id.unsigned_abs(), name);
                found.parameters.entry(key).or_insert(parameter);
            }
            // Every entry advances the offset, so the loop terminates.
            match offset {
                0 => break,
                1 => {
                    return refuse(
                        start + at,
                        "an entry of the parameters that ends in itself",
                        "a next entry",
                    );
                }
                _ => at += offset,
            }
        }
        Ok((found, None))
    }

    /// Byte offset in the file of the end of the parameter that extends past the parameter section; 0 if no parameter
    /// does.
    pub fn end_of_cut(&self) -> usize {
        self.end_of_cut
    }

    /// Whether the file contains the parameter `group:name`.
    pub fn has(&self, group: &str, name: &str) -> bool {
        self.get(group, name).is_some()
    }

    /// All values of a floating-point parameter; empty if the parameter is absent or has another type.
    pub fn floats(&self, group: &str, name: &str) -> Vec<f64> {
        let Some(parameter) = self.get(group, name).filter(|it| it.kind == 4) else {
            return Vec::new();
        };
        let places = (0..parameter.data.bytes.len()).step_by(4);
        places.map(|at| f64::from(parameter.data.f32(at))).collect()
    }

    fn get(&self, group: &str, name: &str) -> Option<&Parameter<'a>> {
        let group = *self.groups.get(group)?;
        self.parameters.get(&(group, name.to_owned()))
    }

    /// Byte offset in the file of a parameter, or of the parameter section if the parameter is absent.
    pub fn offset(&self, group: &str, name: &str) -> usize {
        let parameter = self.get(group, name);
        parameter.map_or(self.start, |parameter| parameter.offset)
    }

    /// First value of a numeric parameter; `None` if the parameter is absent, an error if it is not numeric.
    pub fn number(&self, group: &str, name: &str) -> Result<Option<f64>, C3dError> {
        let Some(parameter) = self.get(group, name) else {
            return Ok(None);
        };
        match (parameter.kind, parameter.data.bytes.len()) {
            (2, 2..) => Ok(Some(f64::from(parameter.data.i16(0)))),
            (4, 4..) => Ok(Some(f64::from(parameter.data.f32(0)))),
            (1, 1..) => Ok(Some(f64::from(parameter.data.bytes[0]))),
            _ => refuse(
                parameter.offset,
                format!("{group}:{name} without a number"),
                "a number",
            ),
        }
    }

    /// Value of a parameter that is a count, stored as an unsigned 16-bit integer or a float; `None` if the parameter
    /// is absent.
    pub fn count(&self, group: &str, name: &str) -> Result<Option<u64>, C3dError> {
        match self.number(group, name)? {
            None => Ok(None),
            Some(number) if (-32768.0..0.0).contains(&number) => {
                Ok(Some((number + 65536.0) as u64))
            }
            Some(number) if (0.0..=4294967295.0).contains(&number) && number.fract() == 0.0 => {
                Ok(Some(number as u64))
            }
            Some(number) => refuse(
                self.offset(group, name),
                format!("{group}:{name} = {number}"),
                "a number of frames",
            ),
        }
    }

    /// Value of an unsigned 32-bit integer stored as two 16-bit words, low word first; `None` if the parameter is
    /// absent.
    pub fn long(&self, group: &str, name: &str) -> Result<Option<u32>, C3dError> {
        match self.get(group, name) {
            None => Ok(None),
            Some(parameter) if parameter.kind == 2 && parameter.data.bytes.len() == 4 => {
                let [low, high] = [0, 2].map(|at| u32::from(parameter.data.u16(at)));
                Ok(Some(low | high << 16))
            }
            Some(parameter) => refuse(
                parameter.offset,
                format!("{group}:{name} of another kind"),
                "two integers",
            ),
        }
    }

    /// Text of a parameter, without surrounding blanks; `None` if the parameter is absent, an error if it is not a
    /// text.
    pub fn text(&self, group: &str, name: &str) -> Result<Option<String>, C3dError> {
        match self.get(group, name) {
            None => Ok(None),
            Some(parameter) if parameter.kind == -1 => Ok(Some(text(parameter.data.bytes))),
            Some(parameter) => refuse(
                parameter.offset,
                format!("{group}:{name} of another kind"),
                "a text",
            ),
        }
    }

    /// First text of a parameter that may be an array of texts; `None` if the parameter is absent.
    pub fn first_text(&self, group: &str, name: &str) -> Result<Option<String>, C3dError> {
        let whole = self.text(group, name)?;
        let several = self.get(group, name).filter(|it| it.dimensions.len() > 1);
        let first = several.and_then(|it| {
            let width = usize::from(*it.dimensions.first()?);
            it.data.bytes.get(..width).map(text)
        });
        Ok(first.or(whole))
    }

    /// Labels of the points from the parameters LABELS, LABELS2, …, each of which contains at most 255 labels. Only the
    /// first `points` labels are returned; there may be fewer.
    pub fn labels(&self, points: usize) -> Result<Vec<String>, C3dError> {
        let mut labels = Vec::new();
        for number in 1.. {
            let name = match number {
                1 => "LABELS".to_owned(),
                _ => format!("LABELS{number}"),
            };
            let Some(parameter) = self.get("POINT", &name) else {
                break;
            };
            if parameter.kind != -1 {
                return refuse(
                    parameter.offset,
                    format!("POINT:{name} of another kind"),
                    "texts",
                );
            }
            let width = usize::from(parameter.dimensions.first().copied().unwrap_or(0));
            if width > 0 {
                let each = parameter.data.bytes.chunks(width).map(text);
                labels.extend(each.take(points - labels.len()));
            }
        }
        if labels.is_empty() {
            return refuse(self.start, "no POINT:LABELS", "the name of every point");
        }
        Ok(labels)
    }
}

/// Decodes a text of the file and strips blanks and zero bytes at both ends.
fn text(bytes: &[u8]) -> String {
    let text = String::from_utf8_lossy(bytes);
    text.trim_matches([' ', '\0', '\t', '\r', '\n']).to_owned()
}
