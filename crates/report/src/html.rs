//! HTML text in which everything from outside is escaped.

use crate::figure::Figure;
use crate::figures::svg::escape;

/// HTML text, and the figures in it. Conversion from a string escapes it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Html {
    text: String,
    /// In order of appearance.
    pub(crate) figures: Vec<Figure>,
}

impl From<&str> for Html {
    fn from(text: &str) -> Html {
        Html::trusted(escape(text))
    }
}

impl From<String> for Html {
    fn from(text: String) -> Html {
        text.as_str().into()
    }
}

impl From<&String> for Html {
    fn from(text: &String) -> Html {
        text.as_str().into()
    }
}

impl From<usize> for Html {
    fn from(number: usize) -> Html {
        Html::trusted(number.to_string())
    }
}

impl From<Option<String>> for Html {
    /// A dash stands for `None`.
    fn from(text: Option<String>) -> Html {
        text.unwrap_or_else(|| "–".to_owned()).into()
    }
}

impl Html {
    /// Empty text.
    pub fn new() -> Html {
        Html::default()
    }

    /// Markup without unescaped text from outside, such as MathML.
    pub(crate) fn trusted(markup: impl Into<String>) -> Html {
        Html {
            text: markup.into(),
            figures: Vec::new(),
        }
    }

    /// Element with attributes, which may be empty, and its content.
    fn with(tag: &str, attributes: &str, content: impl Into<Html>) -> Html {
        let Html { text, figures } = content.into();
        let text = format!("<{tag}{attributes}>{text}</{tag}>");
        Html { text, figures }
    }

    /// Element with a class, which may be empty, and its content.
    pub fn of(tag: &'static str, class: &str, content: impl Into<Html>) -> Html {
        Html::with(tag, &attribute("class", class), content)
    }

    /// Emphasised text.
    pub fn strong(text: impl Into<Html>) -> Html {
        Html::of("b", "", text)
    }

    /// Short label in a cell of a table.
    pub fn tag(text: impl Into<Html>) -> Html {
        Html::of("span", "tag", text)
    }

    /// Short label that warns.
    pub fn warning_tag(text: impl Into<Html>) -> Html {
        Html::of("span", "tag warn", text)
    }

    /// Link to `to`, whose part after `#` must be percent-encoded.
    pub fn link(to: &str, text: impl Into<Html>) -> Html {
        Html::with("a", &attribute("href", &escape(to)), text)
    }

    /// Whether the text is empty.
    pub fn is_empty(&self) -> bool {
        self.text.is_empty()
    }

    /// The HTML text.
    pub fn as_str(&self) -> &str {
        &self.text
    }

    pub(crate) fn text(&self) -> String {
        let outside = self.text.split('<').enumerate().map(|(i, part)| match i {
            0 => part,
            _ => part.split_once('>').map_or("", |(_, text)| text),
        });
        let mut text = outside.collect::<String>();
        for (entity, c) in [
            ("&lt;", "<"),
            ("&gt;", ">"),
            ("&quot;", "\""),
            ("&amp;", "&"),
        ] {
            text = text.replace(entity, c);
        }
        text.trim().to_owned()
    }

    /// This text followed by `more`.
    #[must_use]
    pub fn then(mut self, more: impl Into<Html>) -> Html {
        self.push(more);
        self
    }

    /// Appends `more`.
    pub fn push(&mut self, more: impl Into<Html>) {
        let more = more.into();
        self.text += &more.text;
        self.figures.extend(more.figures);
    }

    /// Appends an element on a line of its own.
    pub fn element(&mut self, tag: &'static str, class: &str, content: impl Into<Html>) {
        self.element_with_id(tag, "", class, content);
    }

    /// Appends an element with an id.
    pub fn element_with_id(
        &mut self,
        tag: &'static str,
        id: &str,
        class: &str,
        content: impl Into<Html>,
    ) {
        let attributes = attribute("id", &escape(id)) + &attribute("class", class);
        self.push(Html::with(tag, &attributes, content));
        self.text.push('\n');
    }

    /// Appends an element that is scrolled where it is wider than the page, by the keyboard too.
    pub fn scrolled(&mut self, tag: &'static str, class: &str, content: impl Into<Html>) {
        let attributes = format!(" class=\"{class}\" tabindex=\"0\"");
        self.push(Html::with(tag, &attributes, content));
        self.text.push('\n');
    }

    /// Appends a paragraph.
    pub fn paragraph(&mut self, text: impl Into<Html>) {
        self.element("p", "words", text);
    }

    /// Appends a paragraph in small letters.
    pub fn note(&mut self, text: impl Into<Html>) {
        self.element("p", "note", text);
    }

    /// Appends a heading within a section.
    pub fn heading(&mut self, text: impl Into<Html>) {
        self.element("h3", "", text);
    }

    /// Appends a list of `items`; nothing if there are none.
    pub fn list<T: Into<Html>>(&mut self, class: &str, items: impl IntoIterator<Item = T>) {
        let mut list = Html::new();
        for item in items {
            list.element("li", "", item);
        }
        if !list.is_empty() {
            self.element("ul", class, Html::from("\n").then(list));
        }
    }

    /// Appends a part that is folded until its summary is clicked; nothing if it is empty.
    pub fn folded(&mut self, summary: impl Into<Html>, content: Html) {
        if !content.is_empty() {
            let summary = Html::of("summary", "", summary).then("\n");
            self.element("details", "", summary.then(content));
        }
    }

    /// Appends warnings under a heading; nothing if there are none.
    pub fn alarms<T: Into<Html>>(&mut self, title: &str, items: impl IntoIterator<Item = T>) {
        let mut list = Html::new();
        list.list("", items);
        if !list.is_empty() {
            let title = Html::of("h2", "", title).then("\n");
            self.element("div", "alarms", title.then(list));
        }
    }

    /// Appends a section with a heading; nothing if its content is empty. `id` may be empty.
    pub fn section(&mut self, id: &str, title: &str, content: Html) {
        if !content.is_empty() {
            let title = Html::of("h2", "", title).then("\n");
            let content = Html::from("\n").then(title).then(content);
            self.element_with_id("section", id, "", content);
        }
    }
}

/// Attribute of an element with a space before it; nothing without a value.
fn attribute(name: &str, value: &str) -> String {
    match value {
        "" => String::new(),
        value => format!(" {name}=\"{value}\""),
    }
}
