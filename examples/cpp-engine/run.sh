#!/usr/bin/env bash
# Emits the film, compiles it into a C++ program, and checks both ways of using it.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

for program in g++ glslangValidator; do
    if ! command -v "$program" > /dev/null; then
        echo "error: $program is needed; on Debian and Ubuntu, apt-get install g++ glslang-tools brings it" >&2
        exit 3
    fi
done

cargo run --quiet --package pavo --manifest-path ../../Cargo.toml -- build bubble.toml -o generated --no-run
{ echo 'R"glsl('; cat generated/bubble.450.glsl; echo ')glsl"'; } > generated/bubble.450.glsl.inc
g++ -std=c++20 -O2 -Wall -Wextra -Werror main.cpp -o generated/engine
generated/engine generated/test-vectors.csv
generated/engine --shader > generated/bubble.frag
glslangValidator -V generated/bubble.frag -o generated/bubble.spv
