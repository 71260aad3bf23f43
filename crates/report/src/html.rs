//! HTML text in which everything from outside is escaped.

use crate::figures::svg::escape;

/// HTML text. Conversion from a string escapes it; tags and classes are fixed texts of the program.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Html(String);

impl From<&str> for Html {
    fn from(text: &str) -> Html {
        Html(escape(text))
    }
}

impl From<String> for Html {
    fn from(text: String) -> Html {
        Html(escape(&text))
    }
}

impl From<&String> for Html {
    fn from(text: &String) -> Html {
        Html(escape(text))
    }
}

impl Html {
    /// Empty text.
    pub fn new() -> Html {
        Html::default()
    }

    /// Markup that is valid HTML and contains no unescaped text from outside, such as MathML.
    pub(crate) fn trusted(markup: impl Into<String>) -> Html {
        Html(markup.into())
    }

    /// Element with a class, which may be empty, and its content.
    pub fn of(tag: &'static str, class: &str, content: impl Into<Html>) -> Html {
        let class = match class {
            "" => String::new(),
            class => format!(" class=\"{class}\""),
        };
        Html(format!("<{tag}{class}>{}</{tag}>", content.into().0))
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
        Html(format!("<a href=\"{}\">{}</a>", escape(to), text.into().0))
    }

    /// Whether the text is empty.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The HTML text.
    pub fn as_str(&self) -> &str {
        &self.0
    }

    /// The text without its markup.
    pub(crate) fn text(&self) -> String {
        let outside = self.0.split('<').enumerate().map(|(i, part)| match i {
            0 => part,
            _ => part.split_once('>').map_or("", |(_, text)| text),
        });
        let text: String = outside.collect();
        let text = text.replace("&lt;", "<").replace("&gt;", ">");
        text.replace("&quot;", "\"")
            .replace("&amp;", "&")
            .trim()
            .to_owned()
    }

    /// This text followed by `more`.
    #[must_use]
    pub fn then(mut self, more: impl Into<Html>) -> Html {
        self.0 += &more.into().0;
        self
    }

    /// Appends `more`.
    pub fn push(&mut self, more: impl Into<Html>) {
        self.0 += &more.into().0;
    }

    /// Appends an element on a line of its own.
    pub fn element(&mut self, tag: &'static str, class: &str, content: impl Into<Html>) {
        self.push(Html::of(tag, class, content));
        self.0.push('\n');
    }

    /// Appends an element with an id, on a line of its own.
    pub fn element_with_id(
        &mut self,
        tag: &'static str,
        id: &str,
        class: &str,
        content: impl Into<Html>,
    ) {
        let element = Html::of(tag, class, content);
        let rest = &element.0[1 + tag.len()..];
        self.0 += &format!("<{tag} id=\"{}\"{rest}\n", escape(id));
    }

    /// Appends an element that may be wider than the page, and is then scrolled, by the keyboard too.
    pub fn scrolled(&mut self, tag: &'static str, class: &str, content: impl Into<Html>) {
        let content = content.into().0;
        self.0 += &format!("<{tag} class=\"{class}\" tabindex=\"0\">{content}</{tag}>\n");
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

    /// Appends a part of the page that is folded until its summary is clicked; nothing if it is empty.
    pub fn folded(&mut self, summary: impl Into<Html>, content: Html) {
        if !content.is_empty() {
            self.element(
                "details",
                "",
                Html::of("summary", "", summary).then("\n").then(content),
            );
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
        if content.is_empty() {
            return;
        }
        let content = Html::trusted("\n<h2>")
            .then(title)
            .then(Html::trusted("</h2>\n"))
            .then(content);
        match id {
            "" => self.element("section", "", content),
            id => self.element_with_id("section", id, "", content),
        }
    }
}
