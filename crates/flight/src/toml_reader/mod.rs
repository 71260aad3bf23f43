//! Reader of TOML texts that collects all faults, with their locations.

mod fault;
mod text;
mod values;

use std::ops::Range;
use std::path::PathBuf;

use model_spec::location::line_and_column;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

pub use fault::{Fault, ReleaseError, suggestion};
pub use text::read_text;
pub use values::{Name, number_of};

pub(crate) const MAX_FILE_BYTES: u64 = 1 << 20;

/// Reader of a TOML text that collects all faults in it, with their locations.
pub struct Reader<'t> {
    text: &'t str,
    faults: Vec<Fault>,
    /// Folder that the paths in the text are relative to; `None` for the working folder.
    pub(crate) folder: Option<PathBuf>,
}

/// Value in a TOML text, with its location.
pub type Value<'t> = Spanned<DeValue<'t>>;

impl<'t> Reader<'t> {
    /// Creates a reader of a text, without recorded faults.
    pub fn new(text: &'t str) -> Reader<'t> {
        Reader {
            text,
            faults: Vec::new(),
            folder: None,
        }
    }

    /// Returns `value`, parsed from the text, if no fault was recorded; `file` is its name in messages.
    ///
    /// # Errors
    /// [`ReleaseError`] with the faults in order of location if there are any, or if `value` is `None`.
    pub fn finish<V>(self, file: &str, value: Option<V>) -> Result<V, ReleaseError> {
        match value {
            Some(value) if self.faults.is_empty() => Ok(value),
            _ => Err(ReleaseError::new(file, self.faults)),
        }
    }

    /// Records a fault at a byte range of the text.
    pub fn fault(&mut self, span: Range<usize>, message: impl Into<String>) {
        self.faults.push(Fault {
            location: Some(line_and_column(self.text, span.start)),
            message: message.into(),
        });
    }

    /// As [`fault`](Self::fault); returns `None`.
    pub fn refuse<V>(&mut self, span: Range<usize>, message: impl Into<String>) -> Option<V> {
        self.fault(span, message);
        None
    }

    pub(crate) fn faults_count(&self) -> usize {
        self.faults.len()
    }

    /// Records a fault that concerns the whole text.
    pub fn missing(&mut self, message: impl Into<String>) {
        self.faults.push(Fault {
            location: None,
            message: message.into(),
        });
    }

    /// Parses the text as TOML; for a syntax error records a fault and returns `None`.
    pub fn document(&mut self) -> Option<Spanned<DeTable<'t>>> {
        match DeTable::parse(self.text) {
            Ok(document) => Some(document),
            Err(e) => {
                let span = e.span().unwrap_or(0..0);
                self.refuse(
                    span,
                    format!("this is no TOML: {}", e.message().replace('\n', "; ")),
                )
            }
        }
    }

    /// Entries of the table `key`: key, its span, and value. Empty if it is absent, or, with a fault, no table.
    pub fn table<'d>(
        &mut self,
        document: &'d DeTable<'t>,
        key: &str,
    ) -> Vec<(&'d str, Range<usize>, &'d Value<'t>)> {
        let Some(value) = document.get(key) else {
            return Vec::new();
        };
        let table = self.as_table(value, key).into_iter().flatten();
        table
            .map(|(key, value)| (&**key.get_ref(), key.span(), value))
            .collect()
    }

    /// Value of a key of a table; records the fault `absent` at `span` and returns `None` if the table lacks the key.
    pub fn required<'d>(
        &mut self,
        table: &'d DeTable<'t>,
        key: &str,
        span: Range<usize>,
        absent: impl Into<String>,
    ) -> Option<&'d Value<'t>> {
        let value = table.get(key);
        if value.is_none() {
            self.fault(span, absent);
        }
        value
    }

    /// Records a fault for each key of a table not in `names`; `context` follows it in the message: `" in [throw]"`.
    pub fn known_keys<'n>(
        &mut self,
        table: &DeTable<'t>,
        context: &str,
        names: impl Iterator<Item = &'n str> + Clone,
    ) {
        for key in table.keys() {
            let name = key.get_ref();
            if !names.clone().any(|n| n == name) {
                self.fault(
                    key.span(),
                    format!(
                        "unknown key {name:?}{context}{}",
                        suggestion(name, names.clone())
                    ),
                );
            }
        }
    }
}
