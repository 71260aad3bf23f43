//! Decay of a disc's spin in flight: forms of the torque, fitted to the record of a gyroscope.

mod diagnosis;
mod figure;
mod fit;
mod form;
mod page;
mod record;
mod results;

pub(super) use figure::spin_decay_figure;
pub use fit::DecayFit;
pub use form::Form;
pub(super) use page::spin_decay_section;
pub(super) use results::SpinDecay;
