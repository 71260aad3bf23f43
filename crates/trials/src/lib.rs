//! The fit put to the test on flights that the oracle made, and on measured ones.
//!
//! Flights are made by the oracle's vector mechanics and an integration of its own ([`fly`]), so that neither the
//! generated code nor its integrator is shared with what is tested.

pub mod coverage;
pub mod discgolf;
pub mod discovery;
pub mod fly;
pub mod hidden;
pub mod made;
pub mod page;
pub mod paper_flight;
pub mod replay;
pub mod spindoe;
pub mod spindown;
pub mod throw;
pub mod windtunnel;
