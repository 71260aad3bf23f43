//! Copies tables of docs/studies/discovery-peers.md, which benches/discovery writes, into a section of docs/studies/discovery.md.

/// Heading of docs/studies/discovery.md before which the section with the results of other programs (pysindy, stepwise
/// regression) is inserted.
const BEFORE: &str = "## Every row";

/// Headings of the tables of other programs' results that are copied from docs/studies/discovery-peers.md to docs/studies/discovery.md.
const TABLES: [&str; 3] = [
    "## A strong effect is seeded",
    "## A weak effect is seeded",
    "## No effect is seeded",
];

/// Builds the section with the results of other programs (pysindy, stepwise regression) from the text of
/// docs/studies/discovery-peers.md. `None` if one of the three tables to be copied (strong effect, weak effect, no effect) is
/// missing in that text.
pub fn peer_section(peers: &str) -> Option<String> {
    let mut text = include_str!("peers.md").to_owned();
    for heading in TABLES {
        let after = peers.split_once(&format!("{heading}\n"))?.1;
        let lines = after.lines().skip_while(|line| line.is_empty());
        let table: Vec<&str> = lines.take_while(|line| line.starts_with('|')).collect();
        if table.len() < 3 {
            return None;
        }
        text.push_str(&format!("\n#{heading}\n\n{}\n", table.join("\n")));
    }
    Some(text)
}

/// Returns the page docs/studies/discovery.md with the section on other programs inserted; an earlier version of the section is
/// replaced.
pub fn with_peer_section(page: &str, section: &str) -> String {
    let title = section.lines().next().unwrap_or_default();
    let without = match page.split_once(title) {
        Some((before, after)) => match after.split_once(BEFORE) {
            Some((_, after)) => format!("{before}{BEFORE}{after}"),
            None => before.to_owned(),
        },
        None => page.to_owned(),
    };
    match without.split_once(BEFORE) {
        Some((before, after)) => format!("{before}{section}\n{BEFORE}{after}"),
        None => format!("{without}\n{section}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn page(name: &str) -> String {
        let file = format!("{}/../docs/studies/{name}", env!("CARGO_MANIFEST_DIR"));
        std::fs::read_to_string(file).expect("a page of docs")
    }

    #[test]
    fn the_page_of_the_discoveries_has_the_peers_tables_as_they_are() {
        let section = peer_section(&page("discovery-peers.md")).expect("its tables");
        assert_eq!(section.matches("**hyzer diagnose**").count(), 3);
        let discoveries = page("discovery.md");
        assert_eq!(with_peer_section(&discoveries, &section), discoveries);
        assert!(discoveries.contains(&section));
    }

    #[test]
    fn a_section_goes_before_the_rows_and_takes_the_place_of_an_old_one() {
        let (old, new) = ("## Peers\n\nold\n", "## Peers\n\nnew\n");
        let with = with_peer_section("# Page\n\n## Every row\n\n| a |\n", old);
        assert_eq!(with, "# Page\n\n## Peers\n\nold\n\n## Every row\n\n| a |\n");
        assert_eq!(with_peer_section(&with, new), with.replace("old", "new"));
        assert_eq!(
            peer_section("## A strong effect is seeded\n\nno table\n"),
            None
        );
    }
}
