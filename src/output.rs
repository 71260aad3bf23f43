//! Output of the program: standard output, and result files that are written atomically.

use std::io::{IsTerminal, Write};
use std::path::Path;

use analysis::{Cells, parquet_table};
use anyhow::Context;
use flight::files::{ResultFile, ResultFolder, write_atomic};
use report::FigureKind;

use crate::cli::TableFormat;
use crate::progress;

/// Writes `contents` to `path` atomically; creates missing parent folders.
pub fn write(path: &Path, contents: impl AsRef<[u8]>) -> anyhow::Result<()> {
    let whole = || {
        if let Some(folder) = path.parent() {
            std::fs::create_dir_all(folder)?;
        }
        write_atomic(path, contents)
    };
    progress::writing(whole).with_context(|| format!("cannot write {}", path.display()))
}

/// Folder of results, the kinds of figures besides SVG, and whether every CSV table is written as Parquet too.
pub struct Results<'a> {
    folder: ResultFolder,
    path: &'a Path,
    kinds: &'a [FigureKind],
    as_parquet: bool,
}

/// Opens the folder of the option `--out`, so that an unusable one is an error before any work is done.
pub fn results<'a>(
    out: Option<&'a Path>,
    kinds: &'a [FigureKind],
    tables: &[TableFormat],
) -> anyhow::Result<Option<Results<'a>>> {
    let open = |path| {
        let folder = ResultFolder::open(path).context("--out")?;
        Ok(Results {
            folder,
            path,
            kinds,
            as_parquet: !tables.is_empty(),
        })
    };
    out.map(open).transpose()
}

impl Results<'_> {
    /// Replaces earlier results by `files`, all at once and with each figure in the other kinds too.
    pub fn write(&self, mut files: Vec<ResultFile>, what: &str) -> anyhow::Result<()> {
        let kinds = FigureKind::ALL.iter();
        for kind in kinds.filter(|kind| self.kinds.contains(kind)) {
            let mut drawn = Vec::new();
            for file in &files {
                let Some(stem) = file.path.strip_suffix(".svg") else {
                    continue;
                };
                let svg = std::str::from_utf8(&file.contents).context("--figures")?;
                let picture = kind.draw(svg);
                let picture = picture.with_context(|| format!("--figures: {}", file.path))?;
                drawn.push(ResultFile::new(format!("{stem}.{}", kind.name()), picture));
            }
            files.extend(drawn);
        }
        if self.as_parquet {
            let tables = files.iter().filter(|file| file.path.ends_with(".csv"));
            let tables = tables.map(|file| parquet(file).context("--tables"));
            let tables = tables.collect::<anyhow::Result<Vec<_>>>()?;
            files.extend(tables);
        }
        progress::writing(|| self.folder.replace(&files)).context("--out")?;
        eprintln!("{what} are in {}", self.path.display());
        Ok(())
    }
}

/// The Parquet file of a CSV table with a header.
fn parquet(table: &ResultFile) -> anyhow::Result<ResultFile> {
    let mut reader = csv::Reader::from_reader(&table.contents[..]);
    let mut columns: Vec<(String, Vec<Option<String>>)> = reader
        .headers()?
        .iter()
        .map(|name| (name.to_owned(), Vec::new()))
        .collect();
    for record in reader.records() {
        let record = record?;
        for (cell, (_, cells)) in record.iter().zip(&mut columns) {
            cells.push(Some(cell.to_owned()).filter(|cell| !cell.is_empty()));
        }
    }
    let columns = columns.into_iter();
    let columns: Vec<(String, Cells)> = columns
        .map(|(name, cells)| (name, Cells::of(cells)))
        .collect();
    let path = table.path.replace(".csv", ".parquet");
    Ok(ResultFile::new(path, parquet_table(&columns)?))
}

/// Checks that a folder can be created, before any work is done; one with files is checked when results are written.
pub fn new_folder(path: &Path) -> anyhow::Result<()> {
    let holds_files = std::fs::read_dir(path).is_ok_and(|mut entries| entries.next().is_some());
    if !holds_files {
        results(Some(path), &[], &[])?;
    }
    Ok(())
}

/// Width of text that is read elsewhere than on a terminal, characters.
pub const PRINTED_WIDTH: usize = 100;

/// Whether standard output is a terminal.
pub fn is_terminal() -> bool {
    std::io::stdout().is_terminal()
}

/// Fits texts and tables to the terminal; elsewhere they are as wide as they are.
pub fn fit_terminal() {
    let size = console::Term::stdout().size_checked();
    if let Some((_, width)) = size.filter(|_| is_terminal()) {
        report::set_width(width.into());
        verify::set_table_width(width);
    }
}

/// Tells on standard error what to do next: a command, or what to state where.
pub fn next(step: impl std::fmt::Display) {
    eprintln!("next: {step}");
}

/// Prints text to standard output and flushes it.
pub fn print(text: impl AsRef<str>) -> anyhow::Result<()> {
    let mut out = std::io::stdout().lock();
    out.write_all(text.as_ref().as_bytes())?;
    out.flush()?;
    Ok(())
}

/// Text of an error with its causes; a cause that an error before it states is not repeated.
pub fn chain(error: &anyhow::Error) -> String {
    let mut text = String::new();
    for cause in error.chain().map(ToString::to_string) {
        if text.is_empty() {
            text = cause;
        } else if !text.contains(&cause) {
            text = format!("{text}: {cause}");
        }
    }
    text
}

/// Formats an error with its causes for the terminal, prefixed by `error: `.
pub fn error_text(error: &anyhow::Error) -> String {
    let text = chain(error);
    // Rendered diagnostics of a model file already have headings.
    let has_heading = text.contains("] Error:");
    if has_heading {
        text
    } else {
        format!("error: {text}")
    }
}
