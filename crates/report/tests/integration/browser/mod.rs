//! A headless Chromium that a test drives over pipes, by the DevTools protocol.

use std::fs::File;
use std::io::{BufRead, BufReader, Write};
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use serde_json::{Value, json};

/// Names of the programs that are tried in turn as the web browser of the tests.
const NAMES: [&str; 4] = ["chromium", "chromium-browser", "google-chrome", "chrome"];

/// Maximum time to wait until a condition becomes true in the browser.
const PATIENCE: Duration = Duration::from_secs(20);

/// JavaScript condition that the file is loaded, rather than the empty page that the browser shows before.
const LOADED: &str = "location.protocol === 'file:' && document.readyState === 'complete'";

/// A web page in a Chromium process, which is killed when the value is dropped.
pub struct Browser {
    child: Child,
    commands: File,
    answers: BufReader<File>,
    session: String,
    last: u64,
    _folder: tempfile::TempDir,
}

impl Browser {
    /// Opens a file in the browser; `None` if no Chromium is installed.
    pub fn open(file: &Path) -> Option<Browser> {
        let runs = |name: &&&str| {
            let mut command = Command::new(name);
            let command = command
                .arg("--version")
                .stdout(Stdio::null())
                .stderr(Stdio::null());
            command.status().is_ok_and(|status| status.success())
        };
        let name = NAMES.iter().find(runs)?;
        let folder = tempfile::tempdir().unwrap();
        let pipe = |name: &str| {
            let path = folder.path().join(name);
            Command::new("mkfifo")
                .arg(&path)
                .status()
                .ok()
                .filter(std::process::ExitStatus::success)?;
            Some(path)
        };
        let (to, from) = (pipe("to")?, pipe("from")?);
        let line = format!(
            "exec {name} --headless --no-sandbox --disable-gpu --remote-debugging-pipe --user-data-dir='{}' 3<'{}' 4>'{}'",
            folder.path().join("profile").display(),
            to.display(),
            from.display()
        );
        let mut shell = Command::new("sh");
        let shell = shell
            .args(["-c", &line])
            .stdout(Stdio::null())
            .stderr(Stdio::null());
        let child = shell.spawn().unwrap();
        let commands = File::options().write(true).open(&to).unwrap();
        let mut browser = Browser {
            child,
            commands,
            answers: BufReader::new(File::open(&from).unwrap()),
            session: String::new(),
            last: 0,
            _folder: folder,
        };
        let url = format!("file://{}", file.display());
        let target = browser.ask("Target.createTarget", json!({ "url": url }));
        let asked = json!({ "targetId": target["targetId"], "flatten": true });
        let attached = browser.ask("Target.attachToTarget", asked);
        browser.session = attached["sessionId"].as_str().unwrap().to_owned();
        assert!(browser.wait_for(LOADED));
        Some(browser)
    }

    fn ask(&mut self, method: &str, params: Value) -> Value {
        self.last += 1;
        let mut message = json!({ "id": self.last, "method": method, "params": params });
        if !self.session.is_empty() {
            message["sessionId"] = json!(self.session);
        }
        let text = message.to_string() + "\0";
        self.commands.write_all(text.as_bytes()).unwrap();
        loop {
            let mut answer = Vec::new();
            self.answers.read_until(0, &mut answer).unwrap();
            assert_eq!(answer.pop(), Some(0), "the browser ended");
            let answer: Value = serde_json::from_slice(&answer).unwrap();
            if answer["id"] == json!(self.last) {
                assert!(answer["error"].is_null(), "{method}: {answer}");
                return answer["result"].clone();
            }
        }
    }

    fn value(&mut self, expression: &str) -> Value {
        let asked = json!({ "expression": expression, "returnByValue": true });
        let answer = self.ask("Runtime.evaluate", asked);
        assert!(
            answer["exceptionDetails"].is_null(),
            "{expression}: {answer}"
        );
        answer["result"]["value"].clone()
    }

    /// Evaluates a JavaScript expression in the web page and returns its value as a number.
    pub fn number(&mut self, expression: &str) -> f64 {
        self.value(expression).as_f64().unwrap()
    }

    /// Evaluates a JavaScript expression in the web page and returns its value as a text.
    pub fn text(&mut self, expression: &str) -> String {
        self.value(expression).as_str().unwrap().to_owned()
    }

    /// Waits until a JavaScript condition becomes true in the web page; false if it is not true within [`PATIENCE`].
    pub fn wait_for(&mut self, condition: &str) -> bool {
        let begun = Instant::now();
        while begun.elapsed() < PATIENCE {
            if self.value(condition) == json!(true) {
                return true;
            }
            std::thread::sleep(Duration::from_millis(20));
        }
        false
    }

    /// Clicks the middle of the element with the CSS selector `selector` with the left mouse button.
    pub fn click(&mut self, selector: &str) {
        let of = format!("document.querySelector('{selector}')");
        self.value(&format!("{of}.scrollIntoView({{block: 'center'}})"));
        let centre = |from: &str, size: &str| {
            format!("{of}.getBoundingClientRect().{from} + {of}.getBoundingClientRect().{size} / 2")
        };
        let (x, y) = (
            self.number(&centre("x", "width")),
            self.number(&centre("y", "height")),
        );
        for kind in ["mousePressed", "mouseReleased"] {
            let event = json!({ "type": kind, "x": x, "y": y, "button": "left", "clickCount": 1 });
            self.ask("Input.dispatchMouseEvent", event);
        }
    }

    /// Presses a key while no control of the web page has the focus.
    pub fn key(&mut self, key: &str) {
        self.value("document.activeElement.blur()");
        for kind in ["keyDown", "keyUp"] {
            self.ask(
                "Input.dispatchKeyEvent",
                json!({ "type": kind, "key": key }),
            );
        }
    }
}

impl Drop for Browser {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}
