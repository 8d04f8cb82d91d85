//! Fuzzes `pavo_fuzz::spectrum`.
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| pavo_fuzz::spectrum(data));
