//! Any bytes as a model file: read, checked, and every fault drawn.
#![no_main]

use libfuzzer_sys::fuzz_target;
use model_spec::load;

fuzz_target!(|bytes: &[u8]| {
    let Ok(text) = load::decode("fuzz.hyz", bytes.to_vec()) else { return };
    let Ok(loaded) = load::inspect_text("fuzz.hyz", &text, &[]) else { return };
    let _ = model_spec::render(&loaded.diagnostics, &loaded.sources, false);
    if let Some(model) = &loaded.model {
        let _ = model_spec::summary(model);
        // What was read can be written, and reads the same.
        let written = loaded.file.to_string();
        let again = model_spec::syntax::parse("fuzz.hyz", &written);
        assert!(again.diagnostics.is_empty());
        assert_eq!(again.file.to_string(), written);
    }
});
