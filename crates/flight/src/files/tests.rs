use std::fs;
use std::path::Path;

use super::folder::files_below;
use super::manifest::Manifest;
use super::*;

fn files(texts: &[(&str, &str)]) -> Vec<ResultFile> {
    let each = texts
        .iter()
        .map(|(path, text)| ResultFile::new(*path, text.as_bytes()));
    each.collect()
}

fn open(path: &Path) -> ResultFolder {
    ResultFolder::open(path).unwrap()
}

/// Paths and contents of all files in a folder of results, except the manifest.
fn contents(folder: &Path) -> Vec<(String, String)> {
    let mut files = files_below(folder).unwrap();
    files.retain(|path| path != MANIFEST);
    files.sort();
    let each = files.into_iter().map(|path| {
        let text = fs::read_to_string(folder.join(&path)).unwrap();
        (path, text)
    });
    each.collect()
}

fn pairs(texts: &[(&str, &str)]) -> Vec<(String, String)> {
    let each = texts.iter();
    each.map(|(path, text)| ((*path).to_owned(), (*text).to_owned()))
        .collect()
}

#[test]
fn earlier_results_are_gone_and_files_of_the_user_are_never_touched() {
    let around = tempfile::tempdir().unwrap();
    let folder = around.path().join("a/found");
    let first = [
        ("extended/disc.rs", "code"),
        ("report.json", "1"),
        ("stall.hyz", "s"),
    ];
    open(&folder).replace(&files(&first)).unwrap();
    let second = [("report.json", "2"), ("stall.hyz", "t")];
    open(&folder).replace(&files(&second)).unwrap();
    assert_eq!(contents(&folder), pairs(&second));
    assert!(!folder.join("extended").exists());
    // Nothing remains beside the folder.
    let beside: Vec<_> = fs::read_dir(around.path().join("a")).unwrap().collect();
    assert_eq!(beside.len(), 1);
    let opened = open(&folder);
    let refused = |name: &str| {
        for error in [
            ResultFolder::open(&folder).unwrap_err(),
            opened.replace(&files(&first)).unwrap_err(),
        ] {
            assert!(
                matches!(error, ResultFolderError::Foreign { .. }),
                "{error}"
            );
            assert!(error.to_string().contains(name), "{error}");
        }
    };
    // Neither a file of the user nor a result that was edited is lost.
    fs::create_dir(folder.join("plots")).unwrap();
    fs::write(folder.join("plots/mine.svg"), "mine").unwrap();
    refused("plots/mine.svg");
    fs::remove_dir_all(folder.join("plots")).unwrap();
    fs::write(folder.join("stall.hyz"), "edited").unwrap();
    refused("stall.hyz");
    let left = [("report.json", "2"), ("stall.hyz", "edited")];
    assert_eq!(contents(&folder), pairs(&left));
}

#[test]
fn a_folder_of_other_files_and_a_file_are_refused_before_anything_is_written() {
    let around = tempfile::tempdir().unwrap();
    fs::write(around.path().join("notes.txt"), "mine").unwrap();
    let error = ResultFolder::open(around.path()).unwrap_err();
    assert!(error.to_string().contains("notes.txt"), "{error}");
    let file = around.path().join("notes.txt");
    for path in [&file, &file.join("below")] {
        let error = ResultFolder::open(path).unwrap_err();
        assert!(matches!(error, ResultFolderError::IsFile { .. }), "{error}");
        assert!(error.to_string().contains("notes.txt is a file"), "{error}");
    }
    // Checking a new folder creates nothing.
    open(&around.path().join("new/results"));
    assert_eq!(contents(around.path()), pairs(&[("notes.txt", "mine")]));
    assert!(!around.path().join("new").exists());
}

#[test]
fn an_empty_folder_is_taken_and_keeps_its_permissions() {
    let around = tempfile::tempdir().unwrap();
    let folder = around.path().join("empty");
    fs::create_dir(&folder).unwrap();
    open(&folder).replace(&files(&[("a.csv", "1")])).unwrap();
    assert_eq!(contents(&folder), pairs(&[("a.csv", "1")]));
}

#[test]
fn files_are_replaced_one_by_one_where_the_folder_cannot_be_renamed() {
    let around = tempfile::tempdir().unwrap();
    let folder = around.path().join("here");
    open(&folder)
        .replace(&files(&[
            ("a.csv", "1"),
            ("code/b.rs", "1"),
            ("c.hyz", "1"),
        ]))
        .unwrap();
    let in_place = open(&folder).without_part();
    let second = [("a.csv", "2"), ("c.hyz", "2")];
    in_place.replace(&files(&second)).unwrap();
    assert_eq!(contents(&folder), pairs(&second));
    assert!(!folder.join("code/b.rs").exists());
    fs::write(folder.join("notes.txt"), "mine").unwrap();
    assert!(in_place.replace(&files(&second)).is_err());
}

#[test]
fn remains_of_interrupted_runs_are_removed_and_an_earlier_folder_is_given_back() {
    let around = tempfile::tempdir().unwrap();
    let folder = around.path().join("found");
    open(&folder).replace(&files(&[("a.csv", "1")])).unwrap();
    // Ids of processes that are not running.
    let left = |id: &str| around.path().join(format!(".found.hyzer-{id}"));
    // Interrupted while the new folder was written.
    fs::create_dir(left("2000000001")).unwrap();
    fs::write(left("2000000001").join("a.csv"), "ha").unwrap();
    // Interrupted between the two renames, on a file system that cannot exchange folders.
    fs::rename(&folder, left("2000000002.old")).unwrap();
    fs::create_dir(left("2000000002")).unwrap();
    fs::write(left("2000000002").join("a.csv"), "2").unwrap();
    // A folder of another target, and of a running process.
    let other = around.path().join(".other.hyzer-2000000001");
    fs::create_dir(&other).unwrap();
    #[cfg(unix)]
    let running = left(&std::os::unix::process::parent_id().to_string());
    #[cfg(unix)]
    fs::create_dir(&running).unwrap();
    let opened = open(&folder);
    assert_eq!(contents(&folder), pairs(&[("a.csv", "1")]));
    assert!(!left("2000000001").exists() && !left("2000000002").exists());
    assert!(other.exists());
    #[cfg(unix)]
    assert!(running.exists());
    opened.replace(&files(&[("a.csv", "3")])).unwrap();
    assert_eq!(contents(&folder), pairs(&[("a.csv", "3")]));
}

/// As where a process was ended and its id is used again.
#[test]
fn what_a_run_prepares_is_its_folder_s_own_and_removed_if_it_was_interrupted() {
    let around = tempfile::tempdir().unwrap();
    let folder = around.path().join("found");
    let opened = open(&folder);
    let part = opened.part().unwrap();
    assert_ne!(Some(part), open(&around.path().join("other")).part());
    fs::create_dir(part).unwrap();
    fs::write(part.join("a.csv"), "ha").unwrap();
    open(&folder);
    assert!(!part.exists());
}

#[test]
fn a_manifest_is_never_seen_in_part() {
    let around = tempfile::tempdir().unwrap();
    let folder = open(&around.path().join("found"));
    let complete = Manifest::of(&files(&[("a.csv", "1")])).text();
    let manifest = folder.part().unwrap().join(MANIFEST);
    let done = std::sync::atomic::AtomicBool::new(false);
    let is_done = || done.load(std::sync::atomic::Ordering::Relaxed);
    std::thread::scope(|scope| {
        let reader = scope.spawn(|| {
            while !is_done() {
                if let Ok(text) = fs::read_to_string(&manifest) {
                    assert_eq!(text, complete);
                }
            }
        });
        for _ in 0..500 {
            folder.replace(&files(&[("a.csv", "1")])).unwrap();
        }
        done.store(true, std::sync::atomic::Ordering::Relaxed);
        reader.join().unwrap();
    });
}

#[test]
fn a_manifest_leads_nowhere_else() {
    let around = tempfile::tempdir().unwrap();
    fs::write(around.path().join("precious"), "x").unwrap();
    let folder = around.path().join("found");
    fs::create_dir(&folder).unwrap();
    let print = Manifest::of(&files(&[("../precious", "x")])).text();
    fs::write(folder.join(MANIFEST), print + "zz  a\nnothing\n").unwrap();
    assert_eq!(Manifest::read(&folder).paths().count(), 0);
    open(&folder).replace(&files(&[("a.csv", "1")])).unwrap();
    assert!(around.path().join("precious").exists());
}
