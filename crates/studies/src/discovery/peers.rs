//! The tables of the peers, from the page that benches/discovery makes, for that of the discoveries.

/// Where the section goes: before this one.
const BEFORE: &str = "## Every row";

/// Headings of the tables that are taken over.
const TABLES: [&str; 3] = [
    "## A strong effect is hidden",
    "## A weak effect is hidden",
    "## Nothing is hidden",
];

/// The section that the peers' page gives; none where it has not all of its tables.
pub fn section(peers: &str) -> Option<String> {
    let mut text = String::from(
        "## Beside pysindy and stepwise regression\n\nThe same hidden effects, asked of pysindy (at the thresholds that are best for it) and of stepwise regression with predicted squared \
         error: from [discovery-peers.md](discovery-peers.md), which says what each was given and how it is judged.\n",
    );
    for heading in TABLES {
        let from = peers.split_once(&format!("{heading}\n"))?.1;
        let lines = from.lines().skip_while(|line| line.is_empty());
        let table: Vec<&str> = lines.take_while(|line| line.starts_with('|')).collect();
        if table.len() < 3 {
            return None;
        }
        text.push_str(&format!("\n#{heading}\n\n{}\n", table.join("\n")));
    }
    Some(text)
}

/// The page of the discoveries with that section, in the place of the one that it has.
pub fn beside(page: &str, section: &str) -> String {
    let title = section.lines().next().unwrap_or_default();
    let rest = match page.split_once(title) {
        Some((before, after)) => match after.split_once(BEFORE) {
            Some((_, after)) => format!("{before}{BEFORE}{after}"),
            None => before.to_owned(),
        },
        None => page.to_owned(),
    };
    match rest.split_once(BEFORE) {
        Some((before, after)) => format!("{before}{section}\n{BEFORE}{after}"),
        None => format!("{rest}\n{section}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn page(name: &str) -> String {
        let file = format!("{}/../../docs/{name}", env!("CARGO_MANIFEST_DIR"));
        std::fs::read_to_string(file).expect("a page of docs")
    }

    #[test]
    fn the_page_of_the_discoveries_has_the_peers_tables_as_they_are() {
        let section = section(&page("discovery-peers.md")).expect("its tables");
        assert_eq!(section.matches("**hyzer diagnose**").count(), 3);
        let discoveries = page("discovery.md");
        assert_eq!(beside(&discoveries, &section), discoveries);
        assert!(discoveries.contains(&section));
    }

    #[test]
    fn a_section_goes_before_the_rows_and_takes_the_place_of_an_old_one() {
        let (old, new) = ("## Peers\n\nold\n", "## Peers\n\nnew\n");
        let with = beside("# Page\n\n## Every row\n\n| a |\n", old);
        assert_eq!(with, "# Page\n\n## Peers\n\nold\n\n## Every row\n\n| a |\n");
        assert_eq!(beside(&with, new), with.replace("old", "new"));
        assert_eq!(section("## A strong effect is hidden\n\nno table\n"), None);
    }
}
