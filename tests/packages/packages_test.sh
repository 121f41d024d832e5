#!/usr/bin/env bash
# Installs both components of a build into a scratch folder and makes the Debian packages of it, as
# an ordinary user and without compiling anything: what is in them, what they need, that the
# programs run from there, that a project is opened by the editor, and that nothing stays behind.
#
# Usage: tests/packages/packages_test.sh BUILD VERSION
#
# Checks whose tool is not installed are left out, with a notice. The exit status is 0 when all
# others passed.
set -euo pipefail

build="$(realpath -- "$1")"
version="$2"
scratch="$(mktemp -d)"
trap 'rm -rf -- "$scratch"' EXIT
cli="$scratch/cli" editor="$scratch/editor"
export HOME="$scratch/home" XDG_CACHE_HOME="$scratch/home/.cache" QT_QPA_PLATFORM=offscreen
export XDG_RUNTIME_DIR="$scratch/runtime"
unset XDG_DATA_HOME XDG_CONFIG_HOME LD_LIBRARY_PATH
mkdir -p "$HOME" "$scratch/tmp"
mkdir -m 700 "$XDG_RUNTIME_DIR"

fail() {
  printf 'FAIL: %s\n' "$*" >&2
  exit 1
}

# has TOOL WHAT: whether a check can be done; says so where it cannot.
has() {
  command -v "$1" >/dev/null 2>&1 && return 0
  printf 'left out, %s is not installed: %s\n' "$1" "$2"
  return 1
}

# expect_equal WHAT EXPECTED FOUND
expect_equal() {
  [[ "$2" == "$3" ]] || fail "$1"$'\n'"expected: $2"$'\n'"found:    $3"
}

files_below() { (cd -- "$1" && find . ! -type d -printf '%P\n' | LC_ALL=C sort); }

install_components() {
  cmake --install "$build" --component cli --prefix "$cli" --strip >/dev/null
  cmake --install "$build" --component editor --prefix "$editor" --strip >/dev/null
  expect_equal "the command line's programs" $'bin/cutis-cli\nlib/cutis/modules/cutis_rasteriser.so' \
    "$(files_below "$cli" | grep -v '^share/')"
  expect_equal "the editor's programs" "bin/cutis" "$(files_below "$editor" | grep -v '^share/')"
  expect_equal "files of both components" "" \
    "$(comm -12 <(files_below "$cli") <(files_below "$editor"))"
}

# The editor is held against the same question, so that it is known to be one.
command_line_has_no_widgets() {
  has ldd "what the programs link" || return 0
  local file
  [[ "$(ldd "$editor/bin/cutis")" == *libQt6Widgets* ]] || fail "the editor should link Qt Widgets"
  for file in "$cli/bin/cutis-cli" "$cli/lib/cutis/modules/cutis_rasteriser.so"; do
    [[ "$(ldd "$file")" != *libQt6Widgets* ]] || fail "$file links Qt Widgets"
  done
  [[ "$(ldd "$cli/bin/cutis-cli")" != *libQt6Gui* ]] || fail "cutis-cli links Qt Gui"
}

programs_run_where_they_are_installed() {
  local info
  info="$(cd "$scratch/tmp" && "$cli/bin/cutis-cli" info --system)"
  expect_equal "version of cutis-cli" "version: $version" "$(head -n 1 <<<"$info")"
  expect_equal "version of cutis" "cutis $version" "$("$editor/bin/cutis" --version)"
  # Draws with the part in lib/cutis/modules.
  (cd "$scratch/tmp" && "$cli/bin/cutis-cli" rig identify --rig monitor --plot plot.png) \
    >/dev/null 2>"$scratch/words" || fail "no plot is drawn: $(<"$scratch/words")"
  [[ -s "$scratch/tmp/plot.png" ]] || fail "no plot was written"
}

desktop_files_are_valid() {
  if has desktop-file-validate "the desktop entry"; then
    desktop-file-validate --no-hints "$editor/share/applications/cutis.desktop"
  fi
  if has appstreamcli "the AppStream metainfo"; then
    # Cutis has no domain that its id could be made of.
    appstreamcli validate --no-net --override cid-desktopapp-is-not-rdns=info \
      "$editor/share/metainfo/cutis.metainfo.xml" || fail "the AppStream metainfo is not valid"
  fi
}

# As a file manager asks: the type of the file, by name and by content, and the program for it.
project_belongs_to_the_editor() {
  has update-mime-database "the type of projects" || return 0
  has update-desktop-database "the program for projects" || return 0
  has gio "the type of projects" || return 0
  export XDG_DATA_DIRS="$editor/share"
  update-mime-database "$editor/share/mime"
  update-desktop-database "$editor/share/applications"
  printf '{ "cutis_project": 1 }\n' >"$scratch/tmp/face.cutis"
  cp -- "$scratch/tmp/face.cutis" "$scratch/tmp/unnamed"
  printf '{}\n' >"$scratch/tmp/damaged.cutis"
  local name
  for name in face.cutis unnamed damaged.cutis; do
    expect_equal "type of $name" "  standard::content-type: application/x-cutis" \
      "$(gio info -a standard::content-type "$scratch/tmp/$name" | grep content-type)"
  done
  # An entry whose program is not found does not count.
  local PATH="$editor/bin:$PATH"
  local program
  program="$(gio mime application/x-cutis)"
  [[ "${program%%$'\n'*}" == *": cutis.desktop" ]] ||
    fail "projects do not open with the editor: $program"
  unset XDG_DATA_DIRS
}

field() { dpkg-deb --field "$scratch/packages/$1_$version-1_"*.deb "$2"; }

files_of_package() {
  dpkg-deb --fsys-tarfile "$scratch/packages/$1_$version-1_"*.deb | tar -t | grep -v '/$' |
    sed 's,^\./usr/,,' | LC_ALL=C sort
}

make_packages() {
  (cd "$build" && cpack --config CPackConfig.cmake -B "$scratch/packages" \
    -D CPACK_DEBIAN_COMPRESSION_TYPE=none) >"$scratch/words" 2>&1 ||
    fail "the packages are not made: $(<"$scratch/words")"
  expect_equal "version of the package" "$version-1" "$(field cutis Version)"
  expect_equal "files of cutis-cli" "$cli_files" "$(files_of_package cutis-cli)"
  expect_equal "files of cutis" "$editor_files" "$(files_of_package cutis)"
  [[ "$(field cutis Depends)" == *libqt6widgets6* ]] || fail "cutis should depend on Qt Widgets"
  [[ "$(field cutis-cli Depends)" == *libopenimageio* ]] || fail "cutis-cli lacks dependencies"
  [[ "$(field cutis-cli Depends)" != *widgets* ]] || fail "cutis-cli depends on Qt Widgets"
}

# dpkg into a root of its own: dependencies are not there, and nothing is run.
dpkg_there() { dpkg --root="$scratch/root" --force-not-root --force-depends "$@" >/dev/null 2>&1; }

installed_and_removed() {
  mkdir -p "$scratch/root/var/lib/dpkg/"{info,updates,triggers}
  : >"$scratch/root/var/lib/dpkg/status"
  dpkg_there --install "$scratch"/packages/*.deb || fail "the packages cannot be installed"
  local found
  found="$(files_below "$scratch/root" | grep '^usr/' | sed 's,^usr/,,')"
  expect_equal "what is installed" "$(LC_ALL=C sort <<<"$cli_files"$'\n'"$editor_files")" "$found"
  dpkg_there --remove cutis cutis-cli || fail "the packages cannot be removed"
  found="$(find "$scratch/root" -path "$scratch/root/var" -prune -o -mindepth 1 -print)"
  expect_equal "what stays behind" "" "$found"
}

install_components
cli_files="$(files_below "$cli")"
editor_files="$(files_below "$editor")"
command_line_has_no_widgets
programs_run_where_they_are_installed
desktop_files_are_valid
project_belongs_to_the_editor
if has dpkg-shlibdeps "the Debian packages" && has file "the Debian packages"; then
  make_packages
  installed_and_removed
fi
printf 'passed\n'
