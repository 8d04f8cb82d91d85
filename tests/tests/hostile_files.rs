//! Files that are not what they should be: the command ends soon, says what is wrong and what would be right, and leaves
//! nothing behind.
#![cfg(unix)]

use pavo_tests::{Ran, run, scene_file};
use std::ffi::OsStr;
use std::fs::{self, File, Permissions};
use std::os::unix::ffi::OsStrExt;
use std::os::unix::fs::{PermissionsExt, symlink};
use std::os::unix::process::{CommandExt, ExitStatusExt};
use std::path::Path;
use std::process::Command;
use std::time::{Duration, Instant};

const PROGRAM: &str = env!("CARGO_BIN_EXE_pavo-under-test");

const SCENE: &str = "name = \"film\"\n[film]\nior = 1.33\nthickness_nm = [0, 1200]\n[base]\nior = 1.5\n";

/// A pipe is given up after ten seconds of silence; the rest is what a busy machine may need.
const TIME: Duration = Duration::from_secs(40);

/// The name of a file with what would make a terminal red, delete a line and begin a new one.
const ESCAPES: &str = "red\u{1b}[31m\r\u{9b}2K\nfilm";

fn folder() -> tempfile::TempDir {
    tempfile::tempdir().expect("a temporary folder can be made")
}

/// Puts something at a path.
enum Put {
    Text(String),
    Bytes(Vec<u8>),
    /// A file of this size, of zeros that take no room on the disk.
    Zeros(u64),
    Folder,
    Pipe,
    Link(&'static str),
    Nothing,
}

impl Put {
    fn at(&self, path: &Path) {
        let done = match self {
            Put::Text(text) => fs::write(path, text),
            Put::Bytes(bytes) => fs::write(path, bytes),
            Put::Zeros(size) => File::create(path).and_then(|file| file.set_len(*size)),
            Put::Folder => fs::create_dir(path),
            Put::Pipe => Command::new("mkfifo").arg(path).status().map(|status| assert!(status.success())),
            Put::Link(target) => symlink(target, path),
            Put::Nothing => Ok(()),
        };
        done.unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    }
}

/// A message that a terminal shows as it is: no control characters but the ends of lines.
fn is_printable(ran: &Ran) -> bool {
    !ran.errors.chars().any(|character| character.is_control() && character != '\n')
}

/// Runs the command in a folder where something is put at a name, and expects a refusal with these fragments, soon.
fn refused(name: &str, put: &Put, arguments: &[&str], fragments: &[&str]) {
    let folder = folder();
    for (file, text) in [("scene.toml", SCENE), ("points.csv", "cos_theta1,thickness_nm\n1,0\n")] {
        fs::write(folder.path().join(file), text).expect("it can be written");
    }
    put.at(&folder.path().join(name));
    let before = names(folder.path());
    let started = Instant::now();
    let ran = run(PROGRAM, folder.path(), arguments);
    let taken = started.elapsed();
    assert_eq!(ran.status, 2, "{name:?} {arguments:?}\n{}\n{}", ran.output, ran.errors);
    for fragment in fragments {
        assert!(ran.errors.contains(fragment), "{name:?} {arguments:?}: no {fragment:?} in\n{}", ran.errors);
    }
    assert!(is_printable(&ran), "{name:?} {arguments:?}: {:?}", ran.errors);
    assert!(taken < TIME, "{name:?} {arguments:?} took {taken:?}");
    assert_eq!(names(folder.path()), before, "{name:?} {arguments:?} left something behind");
}

fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).expect("the folder can be read");
    let names = entries.map(|entry| entry.expect("it can be read").file_name().to_string_lossy().into_owned());
    let mut names: Vec<String> = names.filter(|name| name != "cache").collect();
    names.sort();
    names
}

fn nested(open: &str, inside: &str, close: &str) -> Put {
    const DEPTH: usize = 200_000;
    Put::Text(format!("name = 'x'\na = {}{inside}{}\n", open.repeat(DEPTH), close.repeat(DEPTH)))
}

#[test]
fn a_scene_that_is_no_scene_is_refused() {
    let utf16: Vec<u8> = SCENE.encode_utf16().flat_map(u16::to_le_bytes).collect();
    let cases = [
        (Put::Folder, ["is a folder", "name a file"]),
        (Put::Pipe, ["nothing came from it for 10 s", "a pipe that somebody writes to"]),
        (Put::Link("/dev/zero"), ["has more than 1048576 bytes", "a scene has about a kilobyte"]),
        (Put::Link("/dev/null"), ["name", "name = "]),
        (Put::Link("odd.toml"), ["cannot be read", "symbolic links"]),
        (Put::Zeros(100 << 20), ["it has 104857600 bytes", "a scene has about a kilobyte"]),
        (Put::Text(SCENE.replace("1.33", "1.33\0")), ["odd.toml:3", "key = value"]),
        (Put::Text(SCENE.replace("1.33", "1.33\u{1b}[31m")), ["odd.toml:3", "1.33?[31m"]),
        (Put::Text(SCENE.replace("1.33", "'\u{202e}33.1'")), ["odd.toml:3", "film.ior"]),
        (Put::Bytes(utf16), ["odd.toml", "key = value"]),
        (Put::Bytes(b"\xff\xfe\x00".to_vec()), ["not UTF-8", "save the file as UTF-8"]),
        (nested("[", "1", "]"), ["not valid TOML", "key = value"]),
        (nested("{a=", "1", "}"), ["not valid TOML", "key = value"]),
        (Put::Text(format!("[{}a]\n", "a.".repeat(200_000))), ["odd.toml", "help"]),
        (Put::Text(format!("{}a = 1\n", "a.".repeat(200_000))), ["odd.toml", "help"]),
        (Put::Text(format!("name = \"{}\"\nbase.ior = 1.5\n", "x".repeat(1 << 19))), ["odd.toml", "64"]),
        (Put::Text("x".repeat(1 << 19)), ["odd.toml", "help"]),
    ];
    for (put, fragments) in cases {
        refused("odd.toml", &put, &["emit", "odd.toml", "--target", "wgsl", "-o", "out.wgsl"], &fragments);
    }
}

#[test]
fn a_table_that_is_no_table_is_refused() {
    let with_table = format!("{}csv = 'odd.csv'\n", SCENE.replace("[base]\nior = 1.5\n", "[base]\n"));
    let illuminated = format!("{SCENE}[colour]\nilluminant_csv = 'odd.csv'\n");
    let cases = [
        (Put::Folder, ["which is not a file", "taken from the folder"]),
        (Put::Pipe, ["which is not a file", "taken from the folder"]),
        (Put::Link("/dev/zero"), ["which is not a file", "taken from the folder"]),
        (Put::Link("odd.csv"), ["which is not a file", "taken from the folder"]),
        (Put::Zeros(100 << 20), ["it has 104857600 bytes", "the columns wavelength_nm"]),
        (Put::Bytes(b"wavelength_nm,n,k\n500,1\xff,0\n".to_vec()), ["it is not UTF-8: byte 24", "the columns"]),
        (Put::Text("wavelength_nm,n,k\n500,\u{1b}[31m\0,0\n".to_owned()), ["odd.csv", "line"]),
    ];
    for text in [with_table, illuminated] {
        for (put, fragments) in &cases {
            let folder = folder();
            fs::write(folder.path().join("scene.toml"), &text).expect("it can be written");
            put.at(&folder.path().join("odd.csv"));
            let started = Instant::now();
            let ran = run(PROGRAM, folder.path(), &["emit", "scene.toml", "--target", "wgsl"]);
            assert_eq!(ran.status, 2, "{}", ran.errors);
            assert!(fragments.iter().all(|fragment| ran.errors.contains(fragment)), "{fragments:?}\n{}", ran.errors);
            assert!(is_printable(&ran) && started.elapsed() < TIME, "{}", ran.errors);
        }
    }
}

#[test]
fn points_that_are_no_table_are_refused() {
    let cases = [
        (Put::Folder, ["it is a folder", "name a file in it"]),
        (Put::Pipe, ["nothing came from it for 10 s", "a pipe that somebody writes to"]),
        (Put::Link("/dev/zero"), ["it has more than 268435456 bytes", "divide the file"]),
        (Put::Link("odd"), ["symbolic links", "help"]),
        (Put::Zeros(300 << 20), ["it has 314572800 bytes", "divide the file"]),
        (Put::Bytes(b"cos_theta1,thickness_nm\n1,\xff\n".to_vec()), ["odd", "help"]),
        (Put::Text("cos_theta1,thickness_nm\n1,\0\n".to_owned()), ["odd:2: `\\0`", "a number such as"]),
        (Put::Text("cos_theta1,thickness_nm\n1,\u{1b}[31m\n".to_owned()), ["odd:2: `\\u{1b}[31m`", "a number such as"]),
    ];
    for (put, fragments) in cases {
        let arguments = ["eval", "scene.toml", "--points", "odd", "--on", "cpu-f64", "-o", "out.csv"];
        refused("odd", &put, &arguments, &fragments);
    }
}

#[test]
fn a_shader_that_is_no_file_is_refused() {
    for extension in ["wgsl", "frag", "spv", "rs"] {
        let name = format!("odd.{extension}");
        let cases = [
            (Put::Folder, "it is a folder"),
            (Put::Link("/dev/zero"), "it has more than 67108864 bytes"),
            (Put::Zeros(100 << 20), "it has 104857600 bytes"),
        ];
        for (put, fragment) in cases {
            refused(&name, &put, &["check", &name], &[&name, fragment]);
        }
    }
    refused("odd.wgsl", &Put::Pipe, &["check", "odd.wgsl"], &["nothing came from it for 10 s"]);
}

#[test]
fn names_with_control_characters_are_escaped() {
    let escaped = "red\\u{1b}[31m\\r\\u{9b}2K\\nfilm";
    let file = |extension: &str| format!("{ESCAPES}.{extension}");
    let (toml, csv, wgsl, png) = (file("toml"), file("csv"), file("wgsl"), file("png"));
    let below = format!("{ESCAPES}.toml/out");
    let bad = Put::Text("name = 'x'\n[base]\nior = 0\n".to_owned());
    let good = || Put::Text(SCENE.to_owned());
    let cases: [(&str, Put, &[&str]); 11] = [
        (&toml, Put::Nothing, &["build", &toml]),
        (&toml, Put::Folder, &["build", &toml]),
        (&toml, bad, &["build", &toml]),
        (&csv, Put::Nothing, &["eval", "scene.toml", "--points", &csv, "--on", "cpu-f64"]),
        (&csv, Put::Text("x\n".to_owned()), &["eval", "scene.toml", "--points", &csv, "--on", "cpu-f64"]),
        (&wgsl, Put::Nothing, &["check", &wgsl]),
        (&wgsl, Put::Folder, &["emit", "scene.toml", "--target", "wgsl", "-o", &wgsl]),
        (&toml, good(), &["build", "scene.toml", "--no-run", "--target", "wgsl", "-o", &toml]),
        (&toml, good(), &["plot", "reflectance", "scene.toml", "-o", &below]),
        (&png, Put::Folder, &["preview", "scene.toml", "--size", "16", "-o", &png]),
        (&toml, good(), &["report", "scene.toml", &toml]),
    ];
    for (name, put, arguments) in cases {
        refused(name, &put, arguments, &[escaped]);
    }
    // Arguments that are no names of files.
    for arguments in [
        &["emit", "scene.toml", "--target", ESCAPES][..],
        &["emit", "scene.toml", "--target", "wgsl", "--variant", ESCAPES],
        &["export", "scene.toml", "--engine", ESCAPES],
        &["new", ESCAPES],
        &["preview", "scene.toml", "--size", ESCAPES],
        &["tune", "scene.toml", "--cost", ESCAPES],
        &["plot", "sensitivities", "--illuminant", ESCAPES],
        &["plot", "sensitivities", "--observer", ESCAPES],
        &[ESCAPES],
    ] {
        refused("none", &Put::Nothing, arguments, &[]);
    }
}

#[test]
fn a_name_does_not_become_code() {
    // The command at the top of a text is a comment, whatever the scene is called.
    let folder = folder();
    let name = "a\n} fn evil() -> f32 { return 1.0; }\u{2028} fn evil() {}.toml";
    fs::write(folder.path().join(name), SCENE).expect("it can be written");
    for target in ["wgsl", "glsl450", "rust"] {
        let ran = run(PROGRAM, folder.path(), &["emit", name, "--target", target]);
        assert_eq!(ran.status, 0, "{}", ran.errors);
        let made_by: Vec<&str> = ran.output.lines().filter(|line| line.contains("evil")).collect();
        assert!(made_by.iter().all(|line| line.starts_with("//")), "{made_by:?}");
        assert!(!made_by.is_empty() && !ran.output.contains('\u{2028}'), "{}", ran.output);
    }
}

#[test]
fn names_that_are_not_utf8_and_marks_of_windows_are_read() {
    let folder = folder();
    let (scene, points, out) = (b"caf\xe9.toml", b"caf\xe9.csv", b"\xff\xfe.csv");
    let text = format!("\u{feff}{}", SCENE.replace('\n', "\r\n"));
    let path = |name: &[u8]| folder.path().join(OsStr::from_bytes(name));
    fs::write(path(scene), text).expect("it can be written");
    fs::write(path(points), "\u{feff}cos_theta1,thickness_nm\r\n1,100\r\n").expect("it can be written");
    let evaluate = |scene: &[u8]| {
        let mut command = Command::new(PROGRAM);
        command.current_dir(folder.path()).env("NO_COLOR", "1").env("PAVO_CACHE", folder.path().join("cache"));
        command.arg("eval").arg(OsStr::from_bytes(scene)).args(["--on", "cpu-f64", "--points"]);
        command.arg(OsStr::from_bytes(points)).arg("-o").arg(OsStr::from_bytes(out));
        command.output().expect("it can be started")
    };
    let done = evaluate(scene);
    assert_eq!(done.status.code(), Some(0), "{}", String::from_utf8_lossy(&done.stderr));
    assert!(
        fs::read_to_string(path(out)).expect("it was written").starts_with("cos_theta1,thickness_nm,r,g,b\n1,100,")
    );
    let refused = evaluate(b"absent\xe9.toml");
    assert_eq!(refused.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&refused.stderr).contains("`absent\u{fffd}.toml`"));
}

#[test]
fn a_place_that_cannot_be_written_is_refused_with_what_would_be_right() {
    let long = "x".repeat(300);
    let cases: [(&str, Put, &str, [&str; 2]); 7] = [
        ("odd", Put::Folder, "odd", ["it is a folder", "name a file in it"]),
        ("odd", Put::Text("old".to_owned()), "odd/out", ["cannot be written", "a part of the path is a file"]),
        ("odd", Put::Nothing, "odd/out", ["cannot be written", "in a folder that is there"]),
        ("odd", Put::Link("odd"), "odd", ["symbolic links", "help"]),
        ("odd", Put::Link("odd"), "odd/out", ["symbolic links", "help"]),
        ("odd", Put::Nothing, &long, ["too long", "a shorter name"]),
        // Nobody can make a file there, not even root.
        ("odd", Put::Nothing, "/proc/self/out", ["cannot be written", "in a folder that is there"]),
    ];
    for (name, put, output, fragments) in cases {
        let eval = ["eval", "scene.toml", "--points", "points.csv", "--on", "cpu-f64", "-o", output];
        for arguments in [&["emit", "scene.toml", "--target", "wgsl", "-o", output][..], &eval] {
            refused(name, &put, arguments, &fragments);
        }
    }
    let build = ["build", "scene.toml", "--no-run", "--target", "wgsl", "-o"];
    let export = ["export", "scene.toml", "--engine", "babylon", "-o"];
    for (put, output, fragments) in [
        (Put::Text("old".to_owned()), "odd", ["cannot be made", "a part of the path is a file"]),
        (Put::Text("old".to_owned()), "odd/out", ["cannot be made", "a part of the path is a file"]),
        (Put::Link("odd"), "odd/out", ["symbolic links", "help"]),
        (Put::Nothing, "/proc/self/out", ["cannot be made", "in a folder that is there"]),
    ] {
        for arguments in [[&build[..], &[output]].concat(), [&export[..], &[output]].concat()] {
            refused("odd", &put, &arguments, &fragments);
        }
    }
}

/// A command of a shell in a folder with a scene, by somebody who is not root.
fn unprivileged(folder: &Path, script: &str) -> Command {
    let mut command = Command::new("sh");
    command.current_dir(folder).args(["-c", script]).env("NO_COLOR", "1").env("PAVO_CACHE", folder.join("cache"));
    let is_root = fs::metadata("/proc/self").is_ok_and(|found| std::os::unix::fs::MetadataExt::uid(&found) == 0);
    if is_root {
        const NOBODY: u32 = 65534;
        command.uid(NOBODY).gid(NOBODY);
    }
    command
}

#[test]
fn a_folder_that_may_not_be_written_is_refused() {
    let folder = folder();
    fs::set_permissions(folder.path(), Permissions::from_mode(0o755)).expect("it can be opened");
    fs::write(folder.path().join("scene.toml"), SCENE).expect("it can be written");
    fs::create_dir(folder.path().join("closed")).expect("it can be made");
    // The program itself may lie where others cannot read. Another process copies it: what this one writes, a test beside
    // this may hold open for a moment, and it could not be started.
    let copied = Command::new("cp").arg(PROGRAM).arg(folder.path().join("program")).status();
    assert!(copied.expect("cp can be run").success());
    let program = |arguments: &str| unprivileged(folder.path(), &format!("./program {arguments}"));
    fs::write(folder.path().join("closed/out.wgsl"), "old").expect("it can be written");
    fs::set_permissions(folder.path().join("closed"), Permissions::from_mode(0o555)).expect("it can be closed");
    for output in ["-o closed/out.wgsl", "-o closed/new.wgsl"] {
        let done = program(&format!("emit scene.toml --target wgsl {output}")).output().expect("it can be started");
        let errors = String::from_utf8_lossy(&done.stderr);
        assert_eq!(done.status.code(), Some(2), "{errors}");
        assert!(errors.contains("ermission denied") && errors.contains("may read and write"), "{errors}");
    }
    assert_eq!(names(&folder.path().join("closed")), ["out.wgsl"]);
    assert_eq!(fs::read_to_string(folder.path().join("closed/out.wgsl")).expect("it is there"), "old");
}

#[test]
fn a_full_disk_leaves_the_old_file() {
    let folder = folder();
    fs::write(folder.path().join("scene.toml"), SCENE).expect("it can be written");
    // Files may have 4 blocks, of 512 or 1024 bytes: fewer than the text has.
    for (script, expected) in [
        ("trap '' XFSZ; ulimit -f 4; exec", Some(2)),
        // Without the trap the system ends the program in the middle of the write.
        ("ulimit -c 0; ulimit -f 4; exec", None),
    ] {
        fs::write(folder.path().join("out.wgsl"), "old").expect("it can be written");
        let script = format!("{script} {PROGRAM} emit scene.toml --target wgsl -o out.wgsl");
        let mut command = Command::new("sh");
        command.current_dir(folder.path()).args(["-c", &script]).env("NO_COLOR", "1").env("PAVO_CACHE", "");
        let done = command.output().expect("it can be started");
        let errors = String::from_utf8_lossy(&done.stderr);
        assert_eq!(done.status.code(), expected, "{errors}");
        match expected {
            Some(_) => assert!(errors.contains("too large") && errors.contains("ulimit -f"), "{errors}"),
            None => assert!(done.status.signal().is_some(), "{:?}", done.status),
        }
        assert_eq!(fs::read_to_string(folder.path().join("out.wgsl")).expect("it is there"), "old");
        let left = names(folder.path()).into_iter().filter(|name| name.starts_with(".pavo-"));
        assert!(left.count() <= usize::from(expected.is_none()));
    }
    let full = File::options().write(true).open("/dev/full").expect("it is there");
    let mut command = Command::new(PROGRAM);
    command.current_dir(folder.path()).args(["emit", "scene.toml", "--target", "wgsl"]).stdout(full);
    let done = command.env("NO_COLOR", "1").env("PAVO_CACHE", "").output().expect("it can be started");
    assert_eq!(done.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&done.stderr).contains("standard output cannot be written: No space left"));
}

#[test]
fn a_starter_is_read_from_a_pipe() {
    let folder = folder();
    Put::Pipe.at(&folder.path().join("pipe"));
    let pipe = folder.path().join("pipe");
    let text = fs::read(scene_file("soap-bubble")).expect("it can be read");
    let writer = std::thread::spawn(move || fs::write(pipe, text));
    // Its text is read once, though the export writes it again.
    let ran = run(PROGRAM, folder.path(), &["export", "pipe", "--engine", "babylon", "-o", "out"]);
    assert_eq!(ran.status, 0, "{}", ran.errors);
    writer.join().expect("it ends").expect("it is read");
    let copied = fs::read(folder.path().join("out/pipe")).expect("it is there");
    assert_eq!(copied, fs::read(scene_file("soap-bubble")).expect("it can be read"));
}
