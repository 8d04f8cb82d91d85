//! What the fuzzer holds of the readers holds for its corpus, and for random changes of it.

#[path = "../../fuzz/src/lib.rs"]
mod targets;

use pavo_tests::random::Generator;
use std::path::Path;
use targets::TARGETS;

/// Random changes of each target, and the most random edits of one change.
const CHANGES: usize = 2000;
const EDITS: usize = 4;

/// What is put in, beside random bytes.
const SNIPPETS: [&[u8]; 12] =
    [b"nan", b"-inf", b"1e999", b"-0", b"[", b"=", b"\"", b",", b"\n", b"\xef\xbb\xbf", b"\xff", b"\x1b["];

fn corpus(target: &str) -> Vec<Vec<u8>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../fuzz/corpus").join(target);
    let entries = std::fs::read_dir(&folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let mut files: Vec<_> = entries.map(|entry| entry.expect("the corpus can be listed").path()).collect();
    files.sort();
    assert!(files.len() >= 5, "{target} has a corpus of {} files", files.len());
    files.iter().map(|file| std::fs::read(file).expect("the corpus can be read")).collect()
}

fn changed(random: &mut Generator, corpus: &[Vec<u8>]) -> Vec<u8> {
    let mut bytes = corpus[random.below(corpus.len())].clone();
    for _ in 0..=random.below(EDITS) {
        let at = random.below(bytes.len());
        let end = (at + random.below(12)).min(bytes.len());
        match random.below(5) {
            0 => drop(bytes.drain(at..end)),
            1 => bytes.truncate(at),
            2 => drop(bytes.splice(at..at, SNIPPETS[random.below(SNIPPETS.len())].iter().copied())),
            3 => drop(bytes.splice(at..end, [random.below(256) as u8])),
            _ => {
                let other = &corpus[random.below(corpus.len())];
                let from = random.below(other.len()).min(other.len());
                bytes.splice(at..end, other[from..].iter().take(40).copied());
            }
        }
    }
    bytes
}

#[test]
fn what_is_fuzzed_holds_for_the_corpus() {
    for (name, target) in TARGETS {
        corpus(name).iter().for_each(|bytes| target(bytes));
    }
}

#[test]
fn what_is_fuzzed_holds_for_random_changes_of_the_corpus() {
    let mut random = Generator::new(20_171_104);
    for (name, target) in TARGETS {
        let corpus = corpus(name);
        (0..CHANGES).for_each(|_| target(&changed(&mut random, &corpus)));
    }
}
