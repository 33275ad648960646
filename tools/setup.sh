# Sourced by run.sh, test.sh and .ci/run: installs the packages that are missing and builds a preset.
# The caller is in the repository's root and has set -euo pipefail.

# packages_of SECTION…: the names listed there in tools/packages.txt.
packages_of() {
  awk -v wanted=" $* " '/^\[/ { section = substr($0, 2, length($0) - 2); next }
                        /^[^#]/ && index(wanted, " " section " ")' tools/packages.txt
}

# need SECTION…: installs what is missing. With nothing missing it asks for neither rights nor network.
need() {
  local package missing=() as_root=()
  if ! command -v dpkg >/dev/null; then
    echo "This is not a Debian system: make sure that you have the equivalents of $(packages_of "$@" | paste -sd ' ')" >&2
    return
  fi
  for package in $(packages_of "$@"); do
    dpkg -s "$package" 2>/dev/null | grep -q '^Status: install ok installed' || missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return
  if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null; then
      echo "Packages are missing, and only root can install them. As root, run:" >&2
      echo "  apt-get update && apt-get install -y --no-install-recommends ${missing[*]}" >&2
      exit 2
    fi
    as_root=(sudo)
  fi
  echo "Installing ${missing[*]} …"
  mkdir -p build
  if ! { "${as_root[@]}" apt-get update &&
         "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
           apt-get install -y --no-install-recommends "${missing[@]}"; } >build/packages.log 2>&1; then
    tail -n 20 build/packages.log >&2
    echo "The installation failed; all of its output is in build/packages.log." >&2
    exit 1
  fi
}

# Shows ninja's "[3/120] …" lines as one bar on a terminal, and nothing in a pipe.
progress() {
  local line width=40 bar
  while IFS= read -r line; do
    if [ -t 2 ] && [[ $line =~ ^\[([0-9]+)/([0-9]+)\] ]]; then
      bar=$(printf '%*s' $((width * BASH_REMATCH[1] / BASH_REMATCH[2])) '' | tr ' ' '#')
      printf '\rBuilding [%-*s] %d/%d ' $width "$bar" "${BASH_REMATCH[1]}" "${BASH_REMATCH[2]}" >&2
    fi
  done
  if [ -t 2 ]; then printf '\r\033[K' >&2; fi
}

# build PRESET [TARGET…]: configures and builds quietly; what was said is in build/PRESET.log.
build() {
  local preset=$1 log=build/$1.log
  shift
  mkdir -p build
  if ! cmake --preset "$preset" >"$log" 2>&1 ||
     ! cmake --build "build/$preset" ${1:+--target "$@"} 2>&1 | tee -a "$log" | progress; then
    grep -vE '^(\[[0-9]+/[0-9]+\] (Building|Linking)|-- )' "$log" | tail -n 40 >&2
    echo "The build failed; all of its output is in $log." >&2
    exit 1
  fi
}
