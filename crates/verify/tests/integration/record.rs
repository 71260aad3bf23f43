//! Records of verifications: what is no record is refused, and hashes and verdicts that differ are named.

use crate::support::built_in;
use model_spec::model::Source;
use verify::record::{MAX_BYTES, Record, RecordError, code_hash, text_hash};

const HASH: &str = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";

fn record(text_hash: &str, verdict: &str) -> String {
    format!(
        r#"{{ "schema": "hyzer.verification/1", "seed": 1, "cases": 10, "mutants": false, "program": "1",
        "models": [{{ "model": "kite", "source": "kite.hyz", "with": [], "text_sha256": "{text_hash}",
            "code_sha256": "{HASH}", "rows": [{{ "check": "reference", "verdict": "{verdict}" }}] }}],
        "same_motion": null }}"#
    )
}

#[test]
fn hashes_are_those_of_sha256sum_and_differ_where_texts_do() {
    let source = |text: &str| Source {
        name: "abc".into(),
        text: text.into(),
    };
    assert_eq!(text_hash(&[source("abc")]), HASH);
    assert_eq!(text_hash(&[source("a"), source("bc")]), HASH);
    let [disc, ball] = ["disc", "ball"].map(|name| code_hash(&built_in(name).model.unwrap()));
    assert_ne!(disc, ball);
}

#[test]
fn what_differs_is_named() {
    let before = Record::parse(&record(HASH, "holds")).unwrap();
    assert!(before.differences(&before).is_empty());
    let now = Record::parse(&record("other", "refuted")).unwrap();
    assert_eq!(
        before.differences(&now),
        [
            "kite: hash of the model's text changed",
            "kite: check reference: was holds, is refuted"
        ]
    );
    let renamed = record(HASH, "holds").replace("\"reference\"", "\"tree\"");
    let other = Record::parse(&renamed).unwrap();
    assert_eq!(
        before.differences(&other),
        [
            "kite: check reference: was holds, is not made",
            "kite: check tree: was not made, is holds"
        ]
    );
}

#[test]
fn what_is_no_record_is_refused() {
    let valid = record(HASH, "holds");
    for (from, to) in [
        ("\"seed\": 1", "\"seed\": -1"),
        ("\"seed\": 1,", ""),
        ("\"holds\"", "\"sure\""),
        ("\"models\": [", "\"models\": [[["),
        ("null }", "null"),
    ] {
        let text = valid.replace(from, to);
        assert_ne!(text, valid, "{from}");
        let refused = Record::parse(&text);
        assert!(matches!(refused, Err(RecordError::Malformed(_))), "{to}");
    }
    let other = Record::parse(&valid.replace("verification/1", "verification/2"));
    assert!(matches!(other, Err(RecordError::Schema(_))));
    let long = " ".repeat(MAX_BYTES as usize + 1);
    assert!(matches!(Record::parse(&long), Err(RecordError::TooLong)));
}
