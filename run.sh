#!/bin/bash
# Installs what is missing, builds, and starts the program: ./run.sh [ARGUMENTS OF sudar]
set -euo pipefail
cd "$(dirname "$0")"
. tools/setup.sh

need run
build release sudar_app sudar_scenarios
exec build/release/bin/sudar "$@"
