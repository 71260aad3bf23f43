//! Markdown, line by line.

/// Text being written.
#[derive(Default)]
pub struct Text(String);

impl Text {
    /// A line.
    pub fn line(&mut self, line: impl AsRef<str>) {
        self.0.push_str(line.as_ref());
        self.0.push('\n');
    }

    /// A paragraph and an empty line.
    pub fn paragraph(&mut self, text: impl AsRef<str>) {
        self.line(text);
        self.line("");
    }

    /// A table; the first column is text, the others are numbers.
    pub fn table(&mut self, head: &[&str], rows: impl IntoIterator<Item = Vec<String>>) {
        self.line(format!("| {} |", head.join(" | ")));
        let marks = head
            .iter()
            .enumerate()
            .map(|(k, _)| if k == 0 { "---" } else { "---:" });
        self.line(format!("|{}|", marks.collect::<Vec<_>>().join("|")));
        for row in rows {
            self.line(format!("| {} |", row.join(" | ")));
        }
        self.line("");
    }

    /// All of it.
    pub fn finish(self) -> String {
        let mut text = self.0.trim_end().to_owned();
        text.push('\n');
        text
    }
}

/// A number with three significant digits.
pub fn three(value: f64) -> String {
    if value == 0.0 {
        return "0".into();
    }
    let size = value.abs().log10().floor() as i32;
    if !(-3..5).contains(&size) {
        return format!("{value:.2e}");
    }
    format!("{value:.*}", (2 - size).max(0) as usize)
}

/// A part as a percentage.
pub fn percent(part: f64) -> String {
    format!("{:.1} %", 100.0 * part)
}
