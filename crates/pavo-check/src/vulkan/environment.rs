//! Environment variables that a driver reads while it is opened.
//!
//! Mesa's drivers take some settings from the environment of the process and from nowhere else. Rust guards the
//! environment against its own readers, but not against C code in another thread. So this crate never lets a driver of
//! its own open, or compile, while it changes a variable: who opens or compiles holds the lock shared, who changes a
//! variable holds it alone. C code that is not called by this crate is beyond that lock; a program that has such code
//! running on other threads should make its [`StaticCompiler`](crate::static_cost::StaticCompiler)s first.

use std::ffi::OsString;
use std::sync::{RwLock, RwLockReadGuard};

static LOCK: RwLock<()> = RwLock::new(());

/// Keeps this crate from changing the environment for as long as the guard lives.
pub(super) fn unchanged() -> RwLockReadGuard<'static, ()> {
    LOCK.read().unwrap_or_else(|poisoned| poisoned.into_inner())
}

/// Does some work with variables set, or removed where the value is `None`, and puts the old values back.
pub(super) fn with_variables<T>(variables: &[(&'static str, Option<&str>)], work: impl FnOnce() -> T) -> T {
    let _alone = LOCK.write().unwrap_or_else(|poisoned| poisoned.into_inner());
    // Dropped before the lock is given back, after a panic of the work too.
    let _restored: Vec<Restored> =
        variables.iter().map(|&(name, value)| Restored::set(name, value.map(OsString::from))).collect();
    work()
}

/// A variable that gets its old value back.
struct Restored {
    name: &'static str,
    before: Option<OsString>,
}

impl Restored {
    fn set(name: &'static str, value: Option<OsString>) -> Restored {
        let before = std::env::var_os(name);
        change(name, value);
        Restored { name, before }
    }
}

impl Drop for Restored {
    fn drop(&mut self) {
        change(self.name, self.before.take());
    }
}

fn change(name: &str, value: Option<OsString>) {
    // SAFETY: Rust's own readers of the environment are locked out by the standard library, and the drivers that this
    // crate calls by the lock above.
    unsafe {
        match value {
            Some(value) => std::env::set_var(name, value),
            None => std::env::remove_var(name),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn variables_are_set_for_the_work_and_then_restored() {
        let read = |name: &str| std::env::var(name).ok();
        let outer = [("PAVO_TEST_SET", Some("outer")), ("PAVO_TEST_REMOVED", None)];
        let found = with_variables(&outer, || (read("PAVO_TEST_SET"), read("PAVO_TEST_REMOVED")));
        assert_eq!(found, (Some("outer".to_owned()), None));
        assert_eq!(read("PAVO_TEST_SET"), None);
        drop(unchanged());
    }
}
