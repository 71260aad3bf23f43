//! What `hyzer sweep` refuses: a folder in which another run computes, and flights that no body can fly.

use std::fs;

use crate::support::{hyzer, told};
use crate::sweep::{leaf, sweep, swept};

#[test]
fn a_folder_in_which_another_run_computes_is_left_alone() {
    let (folder, plan) = leaf();
    let out = folder.path().join("swept");
    sweep(&plan, &out, &["--part", "1/2"]);
    let lock = fs::File::open(out.join("parts/.lock")).expect("the lock of the run before");
    let refused = |options: &[&str]| {
        let mut command = hyzer();
        let command = command.arg("sweep").arg(&plan).arg("--out").arg(&out);
        told(command.args(options))
    };
    // A run that joins the parts would remove those of the others.
    lock.lock_shared()
        .expect("a share that is computed elsewhere");
    let (status, _, errors) = refused(&[]);
    assert!(status == 2 && errors.contains("is in use"), "{errors}");
    sweep(&plan, &out, &["--part", "2/2"]);
    lock.unlock().expect("unlocked");
    lock.lock().expect("a run that joins the parts elsewhere");
    let (status, _, errors) = refused(&["--part", "2/2"]);
    assert!(status == 2 && errors.contains("is in use"), "{errors}");
    drop(lock);
    sweep(&plan, &out, &[]);
    assert!(!out.join("parts").exists());
}

#[test]
fn a_flight_with_the_inertia_of_no_body_is_a_row() {
    // A moment of inertia above the sum of the others is that of no body.
    let (summary, lines) = swept(
        "model = \"disc\"\nuntil = \"ground\"\n[throw]\nspeed = 20.0\nspin = 600.0\nheight = 1.0\n[vary]\nI_a = { values = [0.00235, 0.01] }",
    );
    assert_eq!(summary["statuses"]["landed"], 1, "{lines:?}");
    assert_eq!(summary["statuses"]["refused"], 1, "{lines:?}");
}
