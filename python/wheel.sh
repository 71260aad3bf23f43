#!/usr/bin/env bash
# Builds the wheel by the profile of the tests, so that what `cargo test` built is used again, and installs it.
# Runs after environment.sh, in the environment that it made.
set -euo pipefail
cd "$(dirname "$0")"
target=${CARGO_TARGET_DIR:-$(cd .. && pwd)/target}
target=$(cd "$target" && pwd)
venv=$target/python-ci
export CARGO_TARGET_DIR=$target PATH=$venv/bin:$PATH VIRTUAL_ENV=$venv
cargo fmt --check
rm -rf "$target/python-wheels"
maturin build --quiet --locked --profile dev --features as-tested --out "$target/python-wheels"
uv pip install --quiet --reinstall --no-deps "$target"/python-wheels/*.whl
