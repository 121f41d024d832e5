# What start.sh and test.sh share: the packages, the build, and how a failure is told.
# To be sourced by bash; leaves the working directory at the root of the checkout.
# shellcheck shell=bash

cutis_root="$(CDPATH="" cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd -P)"
cutis_program="${0##*/}"
cd "$cutis_root" || exit 1

# Debian 12 names. openimageio-tools also draws the contact sheet of start.sh, with DejaVu; a test
# holds the layout of the sources against clang-format. dpkg-dev and file make the packages; the last
# line is for a test of what they install.
cutis_packages=(
  g++ cmake ninja-build pkg-config ccache
  qt6-base-dev qt6-svg-dev
  libopenimageio-dev openimageio-tools libopenexr-dev libjpeg62-turbo-dev
  libopencolorio-dev liblcms2-dev
  libeigen3-dev libtbb-dev libhwy-dev libcli11-dev nlohmann-json3-dev libxxhash-dev
  libimath-dev zlib1g-dev libbenchmark-dev clang-format
  xvfb fonts-dejavu-core
  dpkg-dev file
  desktop-file-utils shared-mime-info libglib2.0-bin
)

step() { printf '\n== %s\n' "$*"; }

fail() {
  printf '\n%s: %s\n' "$cutis_program" "$*" >&2
  exit 1
}

has() { command -v "$1" >/dev/null 2>&1; }

# Prints those of the named packages that are not installed, one a line.
missing_packages() {
  local package status
  for package in "$@"; do
    status="$(dpkg-query -W -f='${db:Status-Status} ' "$package" 2>/dev/null || true)"
    [[ " $status" == *" installed "* ]] || printf '%s\n' "$package"
  done
}

# Runs a command as root: directly, or through sudo.
as_root() {
  if [[ "$(id -u)" -eq 0 ]]; then
    "$@"
  else
    sudo "$@"
  fi
}

# Installs what is missing of cutis_packages. Needs neither network nor root when nothing is.
install_packages() {
  if ! has dpkg-query || ! has apt-get; then
    if has cmake && has ninja && has pkg-config; then
      printf '%s\n' "This is not a Debian system: no packages are installed, the build uses what is there."
      return
    fi
    fail "this is not a Debian system, so nothing can be installed from here. Install what" \
      "these Debian 12 packages hold, then run this again: ${cutis_packages[*]}"
  fi

  local missing
  mapfile -t missing < <(missing_packages "${cutis_packages[@]}")
  if [[ ${#missing[@]} -eq 0 ]]; then
    return
  fi

  step "Installing ${#missing[@]} missing packages: ${missing[*]}"
  if [[ "$(id -u)" -ne 0 ]] && ! has sudo; then
    fail "packages are missing and only root may install them. As root, run:" \
      "apt-get install --no-install-recommends ${missing[*]}"
  fi
  local apt=(env DEBIAN_FRONTEND=noninteractive apt-get -q -o Acquire::Retries=3
    -o DPkg::Lock::Timeout=300)
  as_root "${apt[@]}" update ||
    fail "the package lists could not be read. Check the network and the files in /etc/apt," \
      "then run this again."
  as_root "${apt[@]}" install -y --no-install-recommends "${missing[@]}" ||
    fail "these packages could not be installed (apt's own message is above): ${missing[*]}." \
      "Check the network; the names are those of Debian 12 (bookworm)."
}

# build TARGET...: builds these targets of the release, in build/release.
build() {
  # Without a home to write to, ccache would refuse to compile.
  if [[ -z "${CCACHE_DIR:-}" && ! -w "${HOME:-}" ]]; then
    export CCACHE_DISABLE=1
  fi

  step "Building the release in build/release"
  # A folder that was copied or moved together with its build is configured anew.
  local cache="build/release/CMakeCache.txt" configure=(cmake --preset release)
  if [[ -f "$cache" ]] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$cutis_root" "$cache"; then
    configure+=(--fresh)
  fi
  "${configure[@]}" ||
    fail "the build could not be configured; the first error above names what is missing."
  cmake --build --preset release --target "$@" ||
    fail "the build failed; the first error above says where."
}
