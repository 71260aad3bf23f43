#!/usr/bin/env bash
# Builds the wheel by the profile of the tests, installs it into an environment of its own, and checks it there.
# With --all also the functions for other libraries, against the tape: ten minutes more.
# CARGO_TARGET_DIR is taken from the caller, so that what `cargo test` built is used again.
set -euo pipefail
cd "$(dirname "$0")"
root=$(cd .. && pwd)
source "$root/.ci/beside.sh"
echo "== environment"
bash environment.sh
echo "== wheel"
bash wheel.sh
target=${CARGO_TARGET_DIR:-$root/target}
venv=$(cd "$target" && pwd)/python-ci
export PATH=$venv/bin:$PATH VIRTUAL_ENV=$venv

static() {
    ruff check . ../docs/notebooks && ruff format --check . ../docs/notebooks && mypy &&
        ruff check --isolated --select E9,F ../benches ../studies &&
        pyright --pythonpath "$venv/bin/python" && stubtest hyzer._hyzer
}
beside "ruff, mypy, pyright, stubs" static

echo "== tests"
# From the root, where `hyzer` is the installed package and the examples are.
tests() {
    (cd "$root" && pytest --quiet -c python/pyproject.toml --rootdir python --import-mode importlib "$@")
}
tests -n auto -m "not alone" python/tests --ignore python/tests/ir --pyargs hyzer
joined "ruff, mypy, pyright, stubs"
tests -m alone python/tests --ignore python/tests/ir
if [ "${1:-}" = --all ]; then
    (cd "$root" && pytest --quiet -n auto -c /dev/null --rootdir python/tests/ir --confcutdir python/tests/ir python/tests/ir)
fi
