#!/usr/bin/env bash
# Installs what is missing, builds a release and runs every test.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=set_up.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/set_up.sh"

usage() {
  cat <<'END'
Usage: packaging/test.sh [CTEST OPTION...]

Installs the packages that are missing (Debian 12), builds the release in build/release and runs
all tests. What follows is passed to ctest:

  packaging/test.sh                    every test
  packaging/test.sh -R core            those with "core" in their name
  packaging/test.sh --rerun-failed     those that failed last time

The exit status is 0 when every test passed.
END
}

if [[ "${1:-}" == "-h" || "${1:-}" == "--help" ]]; then
  usage
  exit 0
fi

install_packages
build all
step "Running the tests"
ctest --preset release --parallel "$(nproc)" --no-tests=error "$@" ||
  fail "not every test passed (or none matched); the failures are listed above."
