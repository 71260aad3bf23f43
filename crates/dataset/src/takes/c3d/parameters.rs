//! Parameter section of a C3D file: groups of named values.

use std::collections::BTreeMap;

use super::bytes::{Bytes, Order};
use super::refuse;
use crate::takes::{Fault, shown};

/// Maximum total number of groups and parameters in a C3D file, which bounds the memory used.
const MAX_ENTRIES: usize = 20_000;

struct Parameter<'a> {
    /// Byte offset of the parameter's type in the file.
    offset: usize,
    kind: i8,
    dimensions: &'a [u8],
    data: Bytes<'a>,
}

pub(super) struct Parameters<'a> {
    section: Bytes<'a>,
    /// Byte offset of the parameter section in the file.
    start: usize,
    groups: BTreeMap<String, u8>,
    parameters: BTreeMap<(u8, String), Parameter<'a>>,
    /// Fault of a parameter that extends past the section, and its end in the file; only those before it are read.
    pub cut: Option<(Fault, usize)>,
}

impl<'a> Parameters<'a> {
    /// Parses the parameter section, which begins at byte `start` of the file and ends where the data begin.
    pub fn read(section: &'a [u8], start: usize, order: Order) -> Result<Self, Fault> {
        let mut found = Self {
            section: Bytes {
                bytes: section,
                order,
            },
            start,
            groups: BTreeMap::new(),
            parameters: BTreeMap::new(),
            cut: None,
        };
        // The section begins with two obsolete bytes, the number of blocks and the processor type.
        let mut at = 4;
        while let Some(&[length, id]) = section.get(at..).and_then(|rest| rest.first_chunk()) {
            let (length, id) = (length.cast_signed().unsigned_abs(), id.cast_signed());
            if length == 0 || id == 0 {
                break;
            }
            if found.groups.len() + found.parameters.len() >= MAX_ENTRIES {
                let expected = format!("at most {MAX_ENTRIES}");
                return refuse(start + at, "a parameter more", expected);
            }
            let name = text(found.part(at + 2, usize::from(length))?).to_uppercase();
            at += 2 + usize::from(length);
            found.part(at, 2)?;
            let offset = usize::from(found.section.u16(at));
            if id < 0 {
                found.groups.entry(name).or_insert(id.unsigned_abs());
            } else if let Some(parameter) = found.parameter(at + 2, &name)? {
                let key = (id.unsigned_abs(), name);
                found.parameters.entry(key).or_insert(parameter);
            } else {
                return Ok(found);
            }
            // Every entry advances the offset, so the loop terminates.
            match offset {
                0 => break,
                1 => {
                    let found = "an entry of the parameters that ends in itself";
                    return refuse(start + at, found, "a next entry");
                }
                _ => at += offset,
            }
        }
        Ok(found)
    }

    /// Reads the parameter `name` whose type is at the offset `at` of the section.
    fn parameter(&mut self, at: usize, name: &str) -> Result<Option<Parameter<'a>>, Fault> {
        let offset = self.start + at;
        let &[kind, count] = self.part(at, 2)? else {
            return refuse(offset, "half a parameter", "a whole one");
        };
        let kind = kind.cast_signed();
        if ![-1, 1, 2, 4].contains(&kind) || count > 7 {
            let name = shown(name);
            let found = format!("the parameter {name} of type {kind} with {count} dimensions");
            return refuse(offset, found, "type -1, 1, 2 or 4 and at most 7 dimensions");
        }
        let at = at + 2;
        let dimensions = self.part(at, usize::from(count))?;
        // The product of seven dimensions of 255 fits in 64 bits.
        let size: u64 = dimensions.iter().map(|&d| u64::from(d)).product();
        let size = usize::try_from(size * u64::from(kind.unsigned_abs())).unwrap_or(usize::MAX);
        let at = at + usize::from(count);
        match self.part(at, size) {
            Ok(bytes) => Ok(Some(Parameter {
                offset,
                kind,
                dimensions,
                data: Bytes {
                    bytes,
                    ..self.section
                },
            })),
            Err(fault) => {
                self.cut = Some((fault, (self.start + at).saturating_add(size)));
                Ok(None)
            }
        }
    }

    fn part(&self, at: usize, length: usize) -> Result<&'a [u8], Fault> {
        let section = self.section.bytes;
        let end = at.checked_add(length);
        match end.and_then(|end| section.get(at..end)) {
            Some(part) => Ok(part),
            None => refuse(
                self.start + at,
                format!("a parameter of {length} bytes at byte {at} of the parameters"),
                format!("all of it within their {} bytes", section.len()),
            ),
        }
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

    /// Value of a parameter as `read` decodes it; an error with the text `expected` if that fails.
    fn value<V>(
        &self,
        group: &str,
        name: &str,
        (found, expected): (&str, &str),
        read: impl Fn(&Parameter<'a>) -> Option<V>,
    ) -> Result<Option<V>, Fault> {
        let Some(parameter) = self.get(group, name) else {
            return Ok(None);
        };
        let fault = || {
            refuse(
                parameter.offset,
                format!("{group}:{name} {found}"),
                expected,
            )
        };
        read(parameter).map_or_else(fault, |value| Ok(Some(value)))
    }

    /// Byte offset in the file of a parameter, or of the parameter section if the parameter is absent.
    pub fn offset(&self, group: &str, name: &str) -> usize {
        let parameter = self.get(group, name);
        parameter.map_or(self.start, |parameter| parameter.offset)
    }

    /// First value of a numeric parameter; `None` if the parameter is absent, an error if it is not numeric.
    pub fn number(&self, group: &str, name: &str) -> Result<Option<f64>, Fault> {
        self.value(group, name, ("without a number", "a number"), |it| {
            match (it.kind, it.data.bytes.len()) {
                (2, 2..) => Some(f64::from(it.data.i16(0))),
                (4, 4..) => Some(f64::from(it.data.f32(0))),
                (1, 1..) => Some(f64::from(it.data.bytes[0])),
                _ => None,
            }
        })
    }

    /// Value of a parameter that is a count, stored as an unsigned 16-bit integer or a float.
    pub fn count(&self, group: &str, name: &str) -> Result<Option<u64>, Fault> {
        match self.number(group, name)? {
            None => Ok(None),
            Some(number) if (-32768.0..0.0).contains(&number) => {
                Ok(Some((number + 65536.0) as u64))
            }
            Some(number) if (0.0..=4294967295.0).contains(&number) && number.fract() == 0.0 => {
                Ok(Some(number as u64))
            }
            Some(number) => {
                let found = format!("{group}:{name} = {number}");
                refuse(self.offset(group, name), found, "a number of frames")
            }
        }
    }

    /// Value of an unsigned 32-bit integer stored as two 16-bit words, low word first.
    pub fn long(&self, group: &str, name: &str) -> Result<Option<u32>, Fault> {
        self.value(group, name, ("of another kind", "two integers"), |it| {
            let [low, high] = [0, 2].map(|at| u32::from(it.data.u16(at)));
            (it.kind == 2 && it.data.bytes.len() == 4).then_some(low | high << 16)
        })
    }

    /// Text of a parameter, without surrounding blanks.
    pub fn text(&self, group: &str, name: &str) -> Result<Option<String>, Fault> {
        self.value(group, name, ("of another kind", "a text"), |it| {
            (it.kind == -1).then(|| text(it.data.bytes))
        })
    }

    /// First text of a parameter that may be an array of texts.
    pub fn first_text(&self, group: &str, name: &str) -> Result<Option<String>, Fault> {
        self.value(group, name, ("of another kind", "a text"), |it| {
            let width = it.dimensions.first().filter(|_| it.dimensions.len() > 1);
            let first = width.and_then(|&width| it.data.bytes.get(..usize::from(width)));
            (it.kind == -1).then(|| text(first.unwrap_or(it.data.bytes)))
        })
    }

    /// Labels of at most `points` points, from LABELS, LABELS2, …, each of which has up to 255; there may be fewer.
    pub fn labels(&self, points: usize) -> Result<Vec<String>, Fault> {
        let mut labels = Vec::new();
        for number in 1.. {
            let name = match number {
                1 => "LABELS".to_owned(),
                _ => format!("LABELS{number}"),
            };
            let more = self.value("POINT", &name, ("of another kind", "texts"), |it| {
                let width = usize::from(it.dimensions.first().copied().unwrap_or(0));
                let each = it.data.bytes.chunks(width.max(1)).map(text);
                let left = if width > 0 { points - labels.len() } else { 0 };
                (it.kind == -1).then(|| each.take(left).collect::<Vec<String>>())
            })?;
            match more {
                Some(more) => labels.extend(more),
                None => break,
            }
        }
        if labels.is_empty() {
            return refuse(self.start, "no POINT:LABELS", "the name of every point");
        }
        Ok(labels)
    }
}

fn text(bytes: &[u8]) -> String {
    let text = String::from_utf8_lossy(bytes);
    text.trim_matches([' ', '\0', '\t', '\r', '\n']).to_owned()
}
