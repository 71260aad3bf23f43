//! Index newtypes: typed indices, so that the index of one kind of item, such as a state, cannot be used for another
//! kind, such as a parameter.
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

/// An index of one kind of item, declared by [`index_type!`].
pub trait Idx: Copy + Eq + Ord + fmt::Debug {
    /// Creates the index with the value `position`, counted from 0.
    ///
    /// # Panics
    /// If `position` exceeds `u32::MAX`.
    fn new(position: usize) -> Self;

    /// Value of the index as an integer, counted from 0.
    fn index(self) -> usize;
}

/// Declares an index newtype over `u32`, with the methods `new(usize)` and `index()`.
#[macro_export]
macro_rules! index_type {
    ($(#[$meta:meta])* $visibility:vis struct $name:ident;) => {
        $(#[$meta])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        $visibility struct $name(u32);

        #[allow(dead_code)]
        impl $name {
            /// Creates the index with the value `position`, counted from 0. Panics if `position` exceeds `u32::MAX`.
            #[must_use]
            $visibility fn new(position: usize) -> Self {
                Self(u32::try_from(position).expect("at most u32::MAX items are indexed"))
            }

            /// Value of the index as an integer, counted from 0.
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

/// A vector that can be indexed only by the index type `I`.
#[derive(Clone, PartialEq, Eq, Hash)]
pub struct IndexVec<I, T> {
    items: Vec<T>,
    index: PhantomData<fn(I) -> I>,
}

impl<I: Idx, T> IndexVec<I, T> {
    /// Creates an empty vector.
    pub fn new() -> Self {
        Self::default()
    }

    /// Number of items in the vector.
    pub fn len(&self) -> usize {
        self.items.len()
    }

    /// Whether the vector has no items.
    pub fn is_empty(&self) -> bool {
        self.items.is_empty()
    }

    /// Iterates over the items in order of their indices.
    pub fn iter(&self) -> std::slice::Iter<'_, T> {
        self.items.iter()
    }

    /// Iterates mutably over the items in order of their indices.
    pub fn iter_mut(&mut self) -> std::slice::IterMut<'_, T> {
        self.items.iter_mut()
    }

    /// Appends an item to the vector and returns its index.
    pub fn push(&mut self, item: T) -> I {
        let index = self.next_index();
        self.items.push(item);
        index
    }

    /// Index that the next pushed item will have: the number of items.
    pub fn next_index(&self) -> I {
        I::new(self.items.len())
    }

    /// Iterates over the indices of all items, in ascending order.
    pub fn indices(&self) -> impl DoubleEndedIterator<Item = I> + ExactSizeIterator + use<I, T> {
        (0..self.items.len()).map(I::new)
    }

    /// Iterates over pairs of index and item, in ascending order of the indices.
    pub fn iter_enumerated(&self) -> impl DoubleEndedIterator<Item = (I, &T)> + ExactSizeIterator {
        self.items
            .iter()
            .enumerate()
            .map(|(k, item)| (I::new(k), item))
    }

    /// The item at an index; `None` if the index is out of range.
    pub fn get(&self, index: I) -> Option<&T> {
        self.items.get(index.index())
    }

    /// Index of the first item that satisfies `predicate`; `None` if no item does.
    pub fn position(&self, predicate: impl FnMut(&T) -> bool) -> Option<I> {
        self.items.iter().position(predicate).map(I::new)
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
