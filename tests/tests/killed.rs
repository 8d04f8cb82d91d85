//! A run that is killed leaves the old file or the new one, and what it was at is cleared away later.
#![cfg(unix)]

use pavo_tests::{run, scene_file};
use std::fs::FileTimes;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant, SystemTime};

const PROGRAM: &str = env!("CARGO_BIN_EXE_pavo-under-test");
const OLD: &str = "what was there before\n";
const KILLS: u32 = 40;

fn unfinished(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).expect("the folder can be read");
    let paths = entries.map(|entry| entry.expect("it can be read").path());
    paths.filter(|path| path.extension().is_some_and(|extension| extension == "unfinished")).collect()
}

#[test]
fn a_killed_run_leaves_the_old_file_or_the_new_one() {
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    let output = folder.path().join("out.wgsl");
    let scene = scene_file("soap-bubble").display().to_string();
    let arguments = ["emit", &scene, "--target", "wgsl", "-o", "out.wgsl"];
    let started = Instant::now();
    assert_eq!(run(PROGRAM, folder.path(), &arguments).status, 0);
    let whole = started.elapsed();
    let new = std::fs::read_to_string(&output).expect("it was written");
    for kill in 0..KILLS {
        std::fs::write(&output, OLD).expect("written");
        let mut command = Command::new(PROGRAM);
        command.current_dir(folder.path()).args(arguments).stdout(Stdio::null()).stderr(Stdio::null());
        let mut child = command.env("PAVO_CACHE", folder.path().join("cache")).spawn().expect("it can be started");
        // Over the length of a run, and a little more.
        std::thread::sleep(whole * kill * 5 / (KILLS * 4));
        // One that has ended by now is not there to be killed.
        let _ = child.kill();
        child.wait().expect("it has ended");
        let found = std::fs::read_to_string(&output).expect("one of them is there");
        assert!(found == OLD || found == new, "kill {kill} left {} bytes", found.len());
    }
}

#[test]
fn what_killed_runs_left_is_removed_by_a_later_one() {
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    for (name, age) in [(".pavo-old.unfinished", 7200), (".pavo-new.unfinished", 0)] {
        let file = std::fs::File::create(folder.path().join(name)).expect("it can be made");
        let modified = SystemTime::now() - Duration::from_secs(age);
        file.set_times(FileTimes::new().set_modified(modified)).expect("it can be dated");
    }
    let scene = scene_file("soap-bubble").display().to_string();
    assert_eq!(run(PROGRAM, folder.path(), &["emit", &scene, "--target", "wgsl", "-o", "out.wgsl"]).status, 0);
    // A young one may be that of a run beside this one.
    assert_eq!(unfinished(folder.path()), [folder.path().join(".pavo-new.unfinished")]);
}

#[test]
fn a_pipe_is_written_to_and_a_link_stays() {
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    let scene = scene_file("soap-bubble").display().to_string();
    let emit = |output: &str| run(PROGRAM, folder.path(), &["emit", &scene, "--target", "wgsl", "-o", output]);
    let made = Command::new("mkfifo").arg(folder.path().join("pipe")).status().expect("mkfifo can be run");
    assert!(made.success());
    std::fs::write(folder.path().join("file"), OLD).expect("written");
    std::os::unix::fs::symlink("file", folder.path().join("link")).expect("it can be made");
    let pipe = folder.path().join("pipe");
    let reader = std::thread::spawn(move || std::fs::read_to_string(pipe));
    assert_eq!(emit("pipe").status, 0);
    let is_file = |name: &str| std::fs::symlink_metadata(folder.path().join(name)).expect("it is there").is_file();
    assert!(!is_file("pipe"), "the pipe was replaced");
    assert_eq!(emit("link").status, 0);
    assert!(!is_file("link") && is_file("file"), "the link was replaced");
    let text = |name: &str| std::fs::read_to_string(folder.path().join(name)).expect("it can be read");
    let piped = reader.join().expect("it ends").expect("the pipe can be read");
    // The header of the text names no file, so all are the same.
    assert_eq!(piped, text("file"));
    let refused = emit(".");
    assert_eq!(refused.status, 2);
    assert!(refused.errors.contains("it is a folder"), "{}", refused.errors);
}
