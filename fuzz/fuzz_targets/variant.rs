//! Fuzzes `pavo_fuzz::variant`.
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| pavo_fuzz::variant(data));
