//! Positions in an array as types of their own: the index of a state cannot be mistaken for that of a parameter.
//!
//! ```
//! use model_spec::index::{Idx, IndexVec};
//!
//! model_spec::index_type!(
//!     /// Index of a marker.
//!     pub struct MarkerId;
//! );
//!
//! let mut names: IndexVec<MarkerId, &str> = IndexVec::new();
//! let rim = names.push("rim");
//! assert_eq!(names[rim], "rim");
//! assert_eq!(rim.index(), 0);
//! ```

use std::fmt;
use std::marker::PhantomData;
use std::ops::{Index, IndexMut};

pub use crate::index_type;

/// A type that stands for a position in an array; made by [`index_type!`].
pub trait Idx: Copy + Eq + Ord + fmt::Debug {
    /// The index of a position counted from 0.
    ///
    /// # Panics
    /// Beyond `u32::MAX` items.
    fn new(position: usize) -> Self;

    /// The position, counted from 0.
    fn index(self) -> usize;
}

/// Declares an index type: a `u32` behind a name, with `new(usize)` and `index()`.
#[macro_export]
macro_rules! index_type {
    ($(#[$meta:meta])* $visibility:vis struct $name:ident;) => {
        $(#[$meta])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        $visibility struct $name(u32);

        #[allow(dead_code)]
        impl $name {
            /// The index of a position counted from 0; panics beyond `u32::MAX`.
            #[must_use]
            $visibility fn new(position: usize) -> Self {
                Self(u32::try_from(position).expect("at most u32::MAX items are indexed"))
            }

            /// The position, counted from 0.
            #[must_use]
            $visibility const fn index(self) -> usize {
                self.0 as usize
            }
        }

        impl $crate::index::Idx for $name {
            fn new(position: usize) -> Self {
                Self::new(position)
            }

            fn index(self) -> usize {
                self.index()
            }
        }
    };
}

/// A vector that is indexed by `I` alone; [`IndexVec::as_slice`] gives its items by plain position.
#[derive(Clone, PartialEq, Eq, Hash)]
pub struct IndexVec<I, T> {
    items: Vec<T>,
    index: PhantomData<fn(I) -> I>,
}

impl<I: Idx, T> IndexVec<I, T> {
    /// An empty vector.
    pub fn new() -> Self {
        Self::default()
    }

    /// Number of items.
    pub fn len(&self) -> usize {
        self.items.len()
    }

    /// Whether there are no items.
    pub fn is_empty(&self) -> bool {
        self.items.is_empty()
    }

    /// The items, in order.
    pub fn iter(&self) -> std::slice::Iter<'_, T> {
        self.items.iter()
    }

    /// The items for modification, in order.
    pub fn iter_mut(&mut self) -> std::slice::IterMut<'_, T> {
        self.items.iter_mut()
    }

    /// Appends an item and returns its index.
    pub fn push(&mut self, item: T) -> I {
        let index = self.next_index();
        self.items.push(item);
        index
    }

    /// The index that the next item pushed will have.
    pub fn next_index(&self) -> I {
        I::new(self.items.len())
    }

    /// Indices of all items, in order.
    pub fn indices(&self) -> impl DoubleEndedIterator<Item = I> + ExactSizeIterator + use<I, T> {
        (0..self.items.len()).map(I::new)
    }

    /// Items with their indices, in order.
    pub fn iter_enumerated(&self) -> impl DoubleEndedIterator<Item = (I, &T)> + ExactSizeIterator {
        self.items
            .iter()
            .enumerate()
            .map(|(k, item)| (I::new(k), item))
    }

    /// The item at an index, if there is one.
    pub fn get(&self, index: I) -> Option<&T> {
        self.items.get(index.index())
    }

    /// Index of the first item that satisfies a predicate.
    pub fn position(&self, predicate: impl FnMut(&T) -> bool) -> Option<I> {
        self.items.iter().position(predicate).map(I::new)
    }

    /// The items by plain position.
    pub fn as_slice(&self) -> &[T] {
        &self.items
    }
}

impl<I: Idx, T> Index<I> for IndexVec<I, T> {
    type Output = T;

    fn index(&self, index: I) -> &T {
        &self.items[index.index()]
    }
}

impl<I: Idx, T> IndexMut<I> for IndexVec<I, T> {
    fn index_mut(&mut self, index: I) -> &mut T {
        &mut self.items[index.index()]
    }
}

impl<I, T> From<Vec<T>> for IndexVec<I, T> {
    fn from(items: Vec<T>) -> Self {
        IndexVec {
            items,
            index: PhantomData,
        }
    }
}

impl<I: Idx, T> FromIterator<T> for IndexVec<I, T> {
    fn from_iter<Items: IntoIterator<Item = T>>(items: Items) -> Self {
        Vec::from_iter(items).into()
    }
}

impl<I, T> Default for IndexVec<I, T> {
    fn default() -> Self {
        Vec::new().into()
    }
}

impl<I, T: fmt::Debug> fmt::Debug for IndexVec<I, T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.items.fmt(f)
    }
}
