//! Decoding of numbers from the bytes of a C3D file, in the byte order of the machine that wrote the file.

/// Size of a C3D block, bytes; the sections of a C3D file are addressed in blocks.
pub(super) const BLOCK: usize = 512;

/// Byte order and floating-point format of the machine that wrote the C3D file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Order {
    Intel,
    Dec,
    Mips,
}

impl Order {
    pub fn of_processor(code: u8) -> Option<Self> {
        match code {
            84 => Some(Self::Intel),
            85 => Some(Self::Dec),
            86 => Some(Self::Mips),
            _ => None,
        }
    }
}

/// Bytes with the byte order of their numbers. Bytes past the end read as 0, so callers check lengths first.
#[derive(Clone, Copy)]
pub(super) struct Bytes<'a> {
    pub bytes: &'a [u8],
    pub order: Order,
}

impl Bytes<'_> {
    fn take<const N: usize>(&self, at: usize) -> [u8; N] {
        let found = self.bytes.get(at..).and_then(<[u8]>::first_chunk);
        found.copied().unwrap_or([0; N])
    }

    pub fn u16(&self, at: usize) -> u16 {
        match self.order {
            Order::Intel | Order::Dec => u16::from_le_bytes(self.take(at)),
            Order::Mips => u16::from_be_bytes(self.take(at)),
        }
    }

    pub fn i16(&self, at: usize) -> i16 {
        self.u16(at).cast_signed()
    }

    pub fn f32(&self, at: usize) -> f32 {
        match self.order {
            Order::Intel => f32::from_le_bytes(self.take(at)),
            Order::Mips => f32::from_be_bytes(self.take(at)),
            Order::Dec => {
                // A VAX float has its two 16-bit words exchanged, and its exponent bias is greater by 2.
                let [a, b, c, d] = self.take(at);
                f32::from_le_bytes([c, d, a, b]) / 4.0
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_is_one_on_every_machine() {
        let one = |bytes: [u8; 4], order| {
            Bytes {
                bytes: &bytes,
                order,
            }
            .f32(0)
        };
        assert_eq!(one([0, 0, 0x80, 0x3f], Order::Intel), 1.0);
        assert_eq!(one([0x3f, 0x80, 0, 0], Order::Mips), 1.0);
        assert_eq!(one([0x80, 0x40, 0, 0], Order::Dec), 1.0);
    }
}
