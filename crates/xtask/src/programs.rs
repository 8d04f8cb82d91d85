//! Where programs are.

use std::path::PathBuf;

/// The path of a program in the folders of `PATH`.
pub fn find_program(name: &str) -> Option<PathBuf> {
    find_in(std::env::split_paths(&std::env::var_os("PATH")?), name)
}

/// The path of a program in the first of these folders that holds it.
fn find_in(folders: impl IntoIterator<Item = PathBuf>, name: &str) -> Option<PathBuf> {
    let file = format!("{name}{}", std::env::consts::EXE_SUFFIX);
    folders.into_iter().map(|folder| folder.join(&file)).find(|path| path.is_file())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_program_is_found_in_the_folder_that_holds_it() {
        let this_test = std::env::current_exe().expect("a process knows its program");
        let folder = this_test.parent().expect("a program lies in a folder").to_owned();
        let name = this_test.file_stem().and_then(|name| name.to_str()).expect("cargo names it in ASCII");
        let elsewhere = PathBuf::from("/no/such/folder");
        for (folders, name, expected) in [
            (vec![elsewhere.clone(), folder.clone()], name, Some(this_test.clone())),
            (vec![elsewhere], name, None),
            (vec![folder.clone()], "no-such-program", None),
            // A folder is no program.
            (vec![folder.join("..")], "deps", None),
        ] {
            assert_eq!(find_in(folders, name), expected);
        }
    }
}
