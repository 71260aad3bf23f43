//! The peers' libraries, as `benches/peers/run.py` leaves them.

use crate::rows::{PARAMETERS, STATES};
use libloading::Library;
use serde_json::Value;
use std::path::PathBuf;

/// The three functions, by the names of the peers' symbols.
pub const FUNCTIONS: [&str; 3] = ["f", "fj", "fjp"];

type Raw = unsafe extern "C" fn(*const f64, *const f64, *mut f64);

/// A function of a peer.
pub struct Peer {
    /// `best` or `plain`.
    pub set: String,
    /// Who made it.
    pub name: String,
    /// Index in [`FUNCTIONS`].
    pub function: usize,
    /// Fewest operations of any of its candidates.
    pub fewest_operations: u64,
    /// How it was made.
    pub made: String,
    /// Places of the state Jacobian's entries.
    pub j: Vec<(usize, usize)>,
    /// Places of the parameter Jacobian's entries.
    pub jp: Vec<(usize, usize)>,
    call: Raw,
    _library: Library,
}

/// Where the peers are.
pub fn folder() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("target/peers")
}

/// `results.json`.
pub fn results() -> Option<Value> {
    let text = std::fs::read_to_string(folder().join("results.json")).ok()?;
    serde_json::from_str(&text).ok()
}

/// All functions of all peers of both sets.
pub fn load(results: &Value) -> Vec<Peer> {
    let mut peers = Vec::new();
    for set in ["best", "plain"] {
        for (name, functions) in results[set].as_object().expect("a set of peers") {
            for (function, symbol) in FUNCTIONS.iter().enumerate() {
                peers.push(Peer::open(set, name, function, &functions[*symbol]));
            }
        }
    }
    peers
}

impl Peer {
    fn open(set: &str, name: &str, function: usize, about: &Value) -> Peer {
        let text = |key: &str| about[key].as_str().expect("a text").to_string();
        let places = |key: &str| -> Vec<(usize, usize)> {
            serde_json::from_value(about[key].clone()).expect("places of a Jacobian")
        };
        let path = folder().join(text("library"));
        // SAFETY: the libraries are our own build of generated code, and hold plain functions without initialisers.
        let library = unsafe { Library::new(&path) }.expect("the library of a peer");
        // SAFETY: the symbol has this type, as benches/peers/README.md says.
        let call = unsafe {
            *library
                .get::<Raw>(text("symbol").as_bytes())
                .expect("a symbol")
        };
        Peer {
            set: set.to_string(),
            name: name.to_string(),
            function,
            fewest_operations: about["fewest_ops"]["total"].as_u64().expect("a count"),
            made: ["variant", "chain", "layout", "flags"].map(text).join(" "),
            j: places("J"),
            jp: places("Jp"),
            call,
            _library: library,
        }
    }

    /// How many numbers it writes.
    pub fn outputs(&self) -> usize {
        12 + self.j.len() + self.jp.len()
    }

    /// Calls it.
    #[inline(always)]
    pub fn call(&self, x: &[f64; STATES], p: &[f64; PARAMETERS], out: &mut [f64]) {
        assert!(out.len() >= self.outputs());
        // SAFETY: it reads 12 and 18 numbers and writes as many as there is room for.
        unsafe { (self.call)(x.as_ptr(), p.as_ptr(), out.as_mut_ptr()) }
    }
}
