//! Vector of `f64` aligned to a cache line, so that no SIMD load of it crosses two lines.

/// Size of a cache line in bytes: the alignment of [`AlignedVec`].
const CACHE_LINE_BYTES: usize = 64;

/// Fixed-length vector of `f64` whose first element starts a cache line of 64 bytes.
#[derive(Debug)]
pub struct AlignedVec {
    /// Storage of the elements, with up to seven unused elements before them for alignment.
    buffer: Box<[f64]>,
    first: usize,
    len: usize,
}

impl AlignedVec {
    /// Returns an aligned vector of `len` zeros.
    pub fn zeros(len: usize) -> AlignedVec {
        let buffer = vec![0.0; len + CACHE_LINE_BYTES / size_of::<f64>() - 1].into_boxed_slice();
        // `align_offset` may fail; unaligned elements are only slower.
        let offset = buffer.as_ptr().align_offset(CACHE_LINE_BYTES);
        let first = if offset + len <= buffer.len() {
            offset
        } else {
            0
        };
        AlignedVec { buffer, first, len }
    }
}

impl AsRef<[f64]> for AlignedVec {
    #[inline(always)]
    fn as_ref(&self) -> &[f64] {
        &self.buffer[self.first..][..self.len]
    }
}

impl AsMut<[f64]> for AlignedVec {
    #[inline(always)]
    fn as_mut(&mut self) -> &mut [f64] {
        &mut self.buffer[self.first..][..self.len]
    }
}

impl Clone for AlignedVec {
    fn clone(&self) -> AlignedVec {
        let mut clone = AlignedVec::zeros(self.len);
        clone.as_mut().copy_from_slice(self.as_ref());
        clone
    }

    fn clone_from(&mut self, source: &AlignedVec) {
        if self.len == source.len {
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
    fn values_are_aligned_and_survive_copies() {
        for length in [0, 1, 8, 204] {
            let mut numbers = AlignedVec::zeros(length);
            for (i, number) in numbers.as_mut().iter_mut().enumerate() {
                *number = i as f64;
            }
            let mut other = AlignedVec::zeros(3);
            other.clone_from(&numbers);
            for each in [&numbers, &numbers.clone(), &other] {
                assert_eq!(each.as_ref(), numbers.as_ref());
                assert_eq!(each.as_ref().len(), length);
                assert_eq!(each.as_ref().as_ptr() as usize % CACHE_LINE_BYTES, 0);
            }
        }
    }
}
