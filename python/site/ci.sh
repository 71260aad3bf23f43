#!/usr/bin/env bash
# Runs the notebooks and the recipes, builds the site and checks its links, anchors and accessibility.
# Runs after python/ci.sh, in the environment with the package that it made. Node and Chromium check the accessibility; without them that is skipped.
# With --rustdoc the site has the API of the crates too, which compiles what they depend on.
set -euo pipefail
cd "$(dirname "$0")"
here=$PWD root=$(cd ../.. && pwd)
target=${CARGO_TARGET_DIR:-$root/target}
target=$(cd "$target" && pwd)
venv=${SITE_VENV:-$target/python-ci}
out=$target/site
export PATH=$venv/bin:$PATH VIRTUAL_ENV=$venv SITE_BUILD=$target/site-build NO_MKDOCS_2_WARNING=1
rm -rf "$SITE_BUILD" "$out"
mkdir -p "$SITE_BUILD"
source "$root/.ci/beside.sh"
bash "$root/python/environment.sh"

cd "$root"
recipes() {
    python -m pytest --quiet -c python/pyproject.toml --rootdir python --import-mode importlib python/tests/test_recipes.py
}
demo() {
    python -c 'import hyzer, sys; hyzer.diagnose("examples/mystery").save(sys.argv[1])' "$SITE_BUILD/demo"
}
beside "shares by each scheduler" recipes
beside demo demo
echo "== notebooks"
python "$here/notebooks.py" --out "$SITE_BUILD/notebooks" 2> "$SITE_BUILD/.log" || { tail -40 "$SITE_BUILD/.log"; exit 1; }
joined demo

echo "== site"
if [ "${1:-}" = --rustdoc ]; then
    cargo doc --locked --no-deps --workspace --quiet
    mkdir -p "$SITE_BUILD/rust/hyzer"
    cp "$target/doc/hyzer/index.html" "$SITE_BUILD/rust/hyzer/"
fi
mkdocs build --config-file "$here/mkdocs.yml" --site-dir "$out"
[ "${1:-}" != --rustdoc ] || cp -r "$target/doc/." "$out/rust"
python "$here/check.py" "$out"
joined "shares by each scheduler"

echo "== accessibility, 1280 and 390 px"
if [ -d "$target/site-node/node_modules/axe-core" ] && command -v chromium > /dev/null; then
    node "$target/site-node/axe.js" "$out"
else
    echo "skipped: no Node with its packages, or no Chromium"
fi
