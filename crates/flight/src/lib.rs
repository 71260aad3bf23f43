//! Flying a model: integration with dense output, events, wind and batches.
