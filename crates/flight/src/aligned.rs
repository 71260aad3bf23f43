//! Numbers that begin where a line of the machine's memory does: then no vector of them lies across two lines.

/// Bytes of a line.
const LINE: usize = 64;

/// Some numbers, from the beginning of a line on.
#[derive(Debug)]
pub struct Aligned {
    /// Room for them, wherever it begins.
    room: Box<[f64]>,
    first: usize,
    length: usize,
}

impl Aligned {
    /// So many zeros.
    pub fn zeros(length: usize) -> Aligned {
        let room = vec![0.0; length + LINE / size_of::<f64>() - 1].into_boxed_slice();
        // Where this cannot be told they begin anywhere, which is only slower.
        let first = room.as_ptr().align_offset(LINE);
        let first = if first + length <= room.len() {
            first
        } else {
            0
        };
        Aligned {
            room,
            first,
            length,
        }
    }
}

impl AsRef<[f64]> for Aligned {
    #[inline(always)]
    fn as_ref(&self) -> &[f64] {
        &self.room[self.first..][..self.length]
    }
}

impl AsMut<[f64]> for Aligned {
    #[inline(always)]
    fn as_mut(&mut self) -> &mut [f64] {
        &mut self.room[self.first..][..self.length]
    }
}

impl Clone for Aligned {
    fn clone(&self) -> Aligned {
        let mut clone = Aligned::zeros(self.length);
        clone.as_mut().copy_from_slice(self.as_ref());
        clone
    }

    fn clone_from(&mut self, source: &Aligned) {
        if self.length == source.length {
            self.as_mut().copy_from_slice(source.as_ref());
        } else {
            *self = source.clone();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn they_begin_at_a_line_and_stay_what_they_are() {
        for length in [0, 1, 8, 204] {
            let mut numbers = Aligned::zeros(length);
            for (i, number) in numbers.as_mut().iter_mut().enumerate() {
                *number = i as f64;
            }
            let mut other = Aligned::zeros(3);
            other.clone_from(&numbers);
            for each in [&numbers, &numbers.clone(), &other] {
                assert_eq!(each.as_ref(), numbers.as_ref());
                assert_eq!(each.as_ref().len(), length);
                assert_eq!(each.as_ref().as_ptr() as usize % LINE, 0);
            }
        }
    }
}
