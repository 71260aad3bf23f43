#!/usr/bin/env bash
# Makes the environment in which the Python package is checked and its site is built, or completes the one that is there.
# Without Node or its packages, the accessibility of the site is not checked.
set -euo pipefail
cd "$(dirname "$0")"
target=${CARGO_TARGET_DIR:-$(cd .. && pwd)/target}
mkdir -p "$target/site-node"
target=$(cd "$target" && pwd)
venv=${SITE_VENV:-$target/python-ci}
if [ ! -x "$venv/bin/uv" ]; then
    # uv installs in a tenth of pip's time.
    "${PYTHON:-python3}" -m venv "$venv"
    "$venv/bin/pip" install --quiet --disable-pip-version-check uv
fi
VIRTUAL_ENV=$venv "$venv/bin/uv" pip install --quiet --requirement requirements-dev.txt --requirement site/requirements.txt
cp site/package.json site/axe.js "$target/site-node"
if command -v npm > /dev/null; then
    (cd "$target/site-node" && npm install --silent --no-fund --no-audit --ignore-scripts) ||
        rm -rf "$target/site-node/node_modules"
fi
