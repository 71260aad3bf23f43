//! The oracle, and every independent check of a model.
