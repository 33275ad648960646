#!/bin/bash
# Installs what is missing, builds, and runs every test: ./test.sh [ARGUMENTS OF ctest]
set -euo pipefail
cd "$(dirname "$0")"
. tools/setup.sh

need run test
build release
exec ctest --test-dir build/release -j2 --output-on-failure --no-tests=error "$@"
