//! Fuzzes `pavo_fuzz::points`.
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| pavo_fuzz::points(data));
