#!/bin/sh
# Parses every model and effect of the repository but those that are broken on purpose; fails if one has an error.
set -eu
cd "$(dirname "$0")"
command -v tree-sitter >/dev/null || { echo "skipped: there is no tree-sitter"; exit 0; }
tree-sitter generate
find ../.. -name '*.hyz' -not -path '*/broken/*' -not -path '*/target/*' -exec tree-sitter parse --quiet {} +
