//! A writer of small C3D files, with every count where a test can spoil it.

/// Contents of a C3D file to be written.
#[derive(Clone)]
pub struct File {
    pub labels: Vec<String>,
    pub units: Option<String>,
    pub rate: f32,
    pub first: u16,
    /// Scale factor of the C3D format: if positive, coordinates are stored as integers in units of this factor,
    /// otherwise as floating-point numbers.
    pub scale: f32,
    /// Processor type of the C3D format, which determines the byte order: 84 (Intel) or 86 (MIPS).
    pub processor: u8,
    pub analog: u16,
    /// Positions as `frames[frame][label]`; `None` for a missing position.
    pub frames: Vec<Vec<Option<[f32; 3]>>>,
    /// Further parameters of the C3D group POINT: name, type, dimensions, data.
    pub more: Vec<(&'static str, i8, Vec<u8>, Vec<u8>)>,
}

impl File {
    pub fn new(labels: &[&str], frames: Vec<Vec<Option<[f32; 3]>>>) -> Self {
        Self {
            labels: labels.iter().map(|&label| label.to_owned()).collect(),
            units: Some("mm".into()),
            rate: 120.0,
            first: 1,
            scale: -0.1,
            processor: 84,
            analog: 0,
            frames,
            more: Vec::new(),
        }
    }

    fn u16(&self, value: u16) -> [u8; 2] {
        match self.processor {
            86 => value.to_be_bytes(),
            _ => value.to_le_bytes(),
        }
    }

    fn f32(&self, value: f32) -> [u8; 4] {
        match self.processor {
            86 => value.to_be_bytes(),
            _ => value.to_le_bytes(),
        }
    }

    fn parameter(&self, name: &str, kind: i8, dimensions: &[u8], data: &[u8]) -> Vec<u8> {
        let mut bytes = vec![name.len() as u8, 1];
        bytes.extend(name.bytes());
        let rest = 2 + 2 + dimensions.len() + data.len() + 1;
        bytes.extend(self.u16(rest as u16));
        bytes.extend([kind as u8, dimensions.len() as u8]);
        bytes.extend(dimensions);
        bytes.extend(data);
        bytes.push(0);
        bytes
    }

    pub fn bytes(&self) -> Vec<u8> {
        let points = self.labels.len() as u16;
        let count = self.frames.len() as u16;
        let mut section = vec![0, 0, 0, self.processor];
        section.extend([5, -1_i8 as u8]);
        section.extend(b"POINT");
        section.extend(self.u16(3));
        section.push(0);
        let width = self.labels.iter().map(String::len).max().unwrap_or(0);
        let padded = |label: &String| format!("{label:width$}").into_bytes();
        let labels: Vec<u8> = self.labels.iter().flat_map(padded).collect();
        section.extend(self.parameter("USED", 2, &[], &self.u16(points)));
        section.extend(self.parameter("FRAMES", 2, &[], &self.u16(count)));
        section.extend(self.parameter("SCALE", 4, &[], &self.f32(self.scale)));
        section.extend(self.parameter("RATE", 4, &[], &self.f32(self.rate)));
        section.extend(self.parameter("LABELS", -1, &[width as u8, points as u8], &labels));
        if let Some(units) = &self.units {
            section.extend(self.parameter("UNITS", -1, &[units.len() as u8], units.as_bytes()));
        }
        for (name, kind, dimensions, data) in &self.more {
            section.extend(self.parameter(name, *kind, dimensions, data));
        }
        section.extend([0; 2]);
        section.resize(section.len().next_multiple_of(512), 0);
        section[2] = (section.len() / 512) as u8;

        let mut bytes = vec![2, 0x50];
        bytes.extend(self.u16(points));
        bytes.extend(self.u16(self.analog));
        bytes.extend(self.u16(self.first));
        bytes.extend(self.u16(self.first.wrapping_add(count).wrapping_sub(1)));
        bytes.extend(self.u16(0));
        bytes.extend(self.f32(self.scale));
        bytes.extend(self.u16((2 + section.len() / 512) as u16));
        bytes.extend(self.u16(1));
        bytes.extend(self.f32(self.rate));
        bytes.resize(512, 0);
        bytes.extend(section);
        for row in &self.frames {
            for point in row {
                self.point(*point, &mut bytes);
            }
            let width = if self.scale > 0.0 { 2 } else { 4 };
            bytes.resize(bytes.len() + width * usize::from(self.analog), 0);
        }
        bytes
    }

    fn point(&self, point: Option<[f32; 3]>, bytes: &mut Vec<u8>) {
        let (position, residual) = match point {
            // Two cameras, and a residual above 127 that is no sign.
            Some(position) => (position, 0x03c8),
            None => ([0.0; 3], -1_i16),
        };
        if self.scale > 0.0 {
            let steps = position.map(|x| (x / self.scale).round() as i16 as u16);
            for word in steps.into_iter().chain([residual as u16]) {
                bytes.extend(self.u16(word));
            }
        } else {
            for word in position.into_iter().chain([f32::from(residual)]) {
                bytes.extend(self.f32(word));
            }
        }
    }
}
