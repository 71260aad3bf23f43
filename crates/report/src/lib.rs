//! Figures and tables of flights.
