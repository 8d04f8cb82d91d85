//! A run that is killed leaves the old file or the new one, and what it was at is cleared away later.
#![cfg(unix)]

use pavo_tests::random::Generator;
use pavo_tests::{run, scene_file};
use std::collections::BTreeMap;
use std::fs::FileTimes;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant, SystemTime};

const PROGRAM: &str = env!("CARGO_BIN_EXE_pavo-under-test");
const OLD: &str = "what was there before\n";
const KILLS: u32 = 40;
const KILLS_OF_MANY: u32 = 24;

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

/// The files of a folder and of those in it by their paths, without the unfinished ones.
fn files(folder: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let mut files = BTreeMap::new();
    for entry in std::fs::read_dir(folder).into_iter().flatten() {
        let path = entry.expect("it can be read").path();
        if path.is_dir() {
            files.extend(self::files(&path));
        } else if path.extension().is_none_or(|extension| extension != "unfinished") {
            let content = std::fs::read(&path).expect("it can be read");
            files.insert(path, content);
        }
    }
    files
}

/// Kills a command that writes several files to `out`: half of the times at a random moment of its length, half of them
/// a moment after the first change in the folder. `last` is what it writes last: where that is new, all are.
fn killed_with_many_files(arguments: &[&str], last: &str, seed: u64) {
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    let out = folder.path().join("out");
    let ran = run(PROGRAM, folder.path(), arguments);
    assert_eq!(ran.status, 0, "{}", ran.errors);
    // With what it keeps between runs it is faster the second time.
    let started = Instant::now();
    assert_eq!(run(PROGRAM, folder.path(), arguments).status, 0);
    let whole = started.elapsed();
    let new = files(&out);
    assert!(new.len() > 2, "{new:?}");
    let mut random = Generator::new(seed);
    for kill in 0..KILLS_OF_MANY {
        for path in new.keys() {
            std::fs::write(path, OLD).expect("written");
        }
        let mut command = Command::new(PROGRAM);
        command.current_dir(folder.path()).args(arguments).stdout(Stdio::null()).stderr(Stdio::null());
        let mut child = command.env("PAVO_CACHE", folder.path().join("cache")).spawn().expect("it can be started");
        if kill % 2 == 0 {
            std::thread::sleep(whole * random.below(1000) as u32 / 900);
        } else {
            let is_old = || unfinished(&out).is_empty() && files(&out).values().all(|text| text == OLD.as_bytes());
            while child.try_wait().expect("it can be asked").is_none() && is_old() {}
            std::thread::sleep(Duration::from_micros(random.below(2000) as u64));
        }
        // One that has ended by now is not there to be killed.
        let _ = child.kill();
        child.wait().expect("it has ended");
        let found = files(&out);
        assert_eq!(found.keys().collect::<Vec<_>>(), new.keys().collect::<Vec<_>>(), "kill {kill}");
        let is_new = |path: &PathBuf| found[path] == new[path];
        for path in new.keys() {
            assert!(is_new(path) || found[path] == OLD.as_bytes(), "kill {kill}: half of {}", path.display());
        }
        assert!(!is_new(&out.join(last)) || new.keys().all(is_new), "kill {kill}: {last} is new before the others");
    }
    stopped_before(&folder.path().join("out").join(last), folder.path(), arguments);
    // What they left is in nobody's way.
    assert_eq!(run(PROGRAM, folder.path(), arguments).status, 0);
    assert_eq!(files(&out), new);
}

/// Kills a run that has written all files but this one, at which it waits: it is a pipe that nobody reads.
fn stopped_before(last: &Path, folder: &Path, arguments: &[&str]) {
    let out = last.parent().expect("it is in a folder");
    let new = files(out);
    for path in new.keys() {
        std::fs::write(path, OLD).expect("written");
    }
    std::fs::remove_file(last).expect("it can be removed");
    assert!(Command::new("mkfifo").arg(last).status().expect("mkfifo can be run").success());
    let mut command = Command::new(PROGRAM);
    command.current_dir(folder).args(arguments).stdout(Stdio::null()).stderr(Stdio::null());
    let mut child = command.env("PAVO_CACHE", folder.join("cache")).spawn().expect("it can be started");
    let is_new = |path: &PathBuf| path == last || std::fs::read(path).is_ok_and(|found| found == new[path]);
    let started = Instant::now();
    while !new.keys().all(is_new) && started.elapsed() < Duration::from_secs(60) {
        std::thread::sleep(Duration::from_millis(1));
    }
    assert!(new.keys().all(is_new), "the others are not written");
    assert!(child.try_wait().expect("it can be asked").is_none(), "it does not wait for {}", last.display());
    child.kill().expect("it can be killed");
    child.wait().expect("it has ended");
    std::fs::remove_file(last).expect("it can be removed");
}

#[test]
fn a_killed_build_leaves_old_files_or_new_ones() {
    let scene = scene_file("soap-bubble").display().to_string();
    let arguments = ["build", &scene, "--target", "wgsl,rust", "--variant", "series:m=1", "--no-run", "-o", "out"];
    killed_with_many_files(&arguments, "manifest.json", 1);
}

#[test]
fn a_killed_export_leaves_old_files_or_new_ones() {
    let scene = scene_file("soap-bubble").display().to_string();
    let arguments = ["export", &scene, "--engine", "three", "-o", "out"];
    killed_with_many_files(&arguments, "README.md", 2);
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
