//! Reports: figures and tables of flights, HTML pages of fits and diagnoses, the page of the effects, and the folders that
//! results are written to.

#![forbid(unsafe_code)]

mod atomic_file;
mod certificate;
mod data_faults;
pub mod diagnosis;
pub mod effects;
pub mod figures;
pub mod fit;
pub mod import;
pub mod literature;
mod result_folder;

pub use atomic_file::write_atomic;
pub use certificate::{CertificateNote, WithCertificate};
pub use result_folder::{MANIFEST, ResultFile, ResultFolder, ResultFolderError};
