//! Messages of the language server protocol: a header with `Content-Length`, then JSON.

use std::io::{self, BufRead, Read, Write};

use serde_json::Value;

/// Greatest length of a message, bytes; a longer one is skipped.
const MAX_MESSAGE_BYTES: u64 = 16_000_000;

/// Greatest length of a header line, bytes.
const MAX_HEADER_BYTES: u64 = 4096;

/// What was read.
pub enum Incoming {
    /// A message.
    Message(Value),
    /// Something that is no message, with the reason.
    Faulty(String),
}

/// Reads the next message; `None` at the end of the input.
pub fn read(input: &mut impl BufRead) -> io::Result<Option<Incoming>> {
    let mut length = None;
    loop {
        let mut line = Vec::new();
        let count = { &mut *input }
            .take(MAX_HEADER_BYTES)
            .read_until(b'\n', &mut line)?;
        if count == 0 {
            return Ok(None);
        }
        let line = String::from_utf8_lossy(&line);
        let line = line.trim();
        if line.is_empty() {
            // Blank lines before a header are skipped.
            match length {
                Some(length) => return body(input, length).map(Some),
                None => continue,
            }
        }
        if let Some((name, value)) = line.split_once(':')
            && name.eq_ignore_ascii_case("content-length")
        {
            length = value.trim().parse::<u64>().ok();
            if length.is_none() {
                let reason = format!("`{line}` states no length");
                return Ok(Some(Incoming::Faulty(reason)));
            }
        }
    }
}

fn body(input: &mut impl BufRead, length: u64) -> io::Result<Incoming> {
    let mut limited = input.take(length);
    if length > MAX_MESSAGE_BYTES {
        io::copy(&mut limited, &mut io::sink())?;
        let reason =
            format!("the message has {length} bytes; at most {MAX_MESSAGE_BYTES} are read");
        return Ok(Incoming::Faulty(reason));
    }
    let mut bytes = Vec::new();
    limited.read_to_end(&mut bytes)?;
    Ok(match serde_json::from_slice(&bytes) {
        Ok(message) => Incoming::Message(message),
        Err(error) => Incoming::Faulty(error.to_string()),
    })
}

/// Writes a message.
pub fn write(output: &mut impl Write, message: &Value) -> io::Result<()> {
    let text = message.to_string();
    write!(output, "Content-Length: {}\r\n\r\n{text}", text.len())?;
    output.flush()
}
