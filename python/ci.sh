#!/usr/bin/env bash
# Builds the wheel by the profile of the tests, installs it into an environment of its own, and checks it there.
# With --all also the functions for other libraries, against the tape: ten minutes more.
# CARGO_TARGET_DIR is taken from the caller, so that what `cargo test` built is used again.
set -euo pipefail
cd "$(dirname "$0")"
root=$(cd .. && pwd)
target=${CARGO_TARGET_DIR:-$root/target}
mkdir -p "$target"
target=$(cd "$target" && pwd)
export CARGO_TARGET_DIR=$target
venv=$target/python-ci

echo "== environment"
# uv installs in a tenth of pip's time.
"${PYTHON:-python3}" -m venv "$venv"
"$venv/bin/pip" install --quiet --disable-pip-version-check uv
export PATH=$venv/bin:$PATH VIRTUAL_ENV=$venv
uv pip install --quiet --requirement requirements-dev.txt

echo "== wheel"
cargo fmt --check
rm -rf "$target/python-wheels"
maturin build --quiet --locked --profile dev --features as-tested --out "$target/python-wheels"
uv pip install --quiet --reinstall --no-deps "$target"/python-wheels/*.whl

echo "== ruff, mypy, pyright, stubs, beside the tests"
static() {
    ruff check . ../docs/notebooks && ruff format --check . ../docs/notebooks && mypy &&
        ruff check --isolated --select E9,F ../benches ../studies &&
        pyright --pythonpath "$venv/bin/python" && stubtest hyzer._hyzer
}
static >"$target/python-static.log" 2>&1 &
checks=$!

echo "== tests"
# From the root, where `hyzer` is the installed package and the examples are.
tests() {
    (cd "$root" && pytest --quiet -c python/pyproject.toml --rootdir python --import-mode importlib "$@")
}
tests -n auto -m "not alone" python/tests --ignore python/tests/ir --pyargs hyzer
wait "$checks" || { cat "$target/python-static.log"; exit 1; }
cat "$target/python-static.log"
tests -m alone python/tests --ignore python/tests/ir
if [ "${1:-}" = --all ]; then
    (cd "$root" && pytest --quiet -n auto -c /dev/null --rootdir python/tests/ir --confcutdir python/tests/ir python/tests/ir)
fi
