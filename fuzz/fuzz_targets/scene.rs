//! Fuzzes `pavo_fuzz::scene`.
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| pavo_fuzz::scene(data));
