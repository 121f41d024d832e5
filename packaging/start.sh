#!/usr/bin/env bash
# Installs what is missing, builds a release and runs Cutis.
set -euo pipefail
started_in="$PWD"
# shellcheck source-path=SCRIPTDIR source=set_up.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/set_up.sh"
# shellcheck source-path=SCRIPTDIR source=contact_sheet.sh
source "$cutis_root/packaging/contact_sheet.sh"

bin="$cutis_root/build/release/bin"

usage() {
  cat <<'END'
Usage: packaging/start.sh [--cli | --build-only | FOLDER]

Installs the packages that are missing (Debian 12), builds the release in build/release and runs
it. With a display this opens the editor with a sample: simulated photographs of a patch of skin.
Without one they are fitted, edited and rendered on the command line.

  --cli         the command-line run, even where there is a display
  --build-only  install and build, run nothing
  FOLDER        the command-line run, writing there (default: build/sample-run)
END
}

# sample_run FOLDER: the whole way of the data, once, on the simulated sample.
sample_run() {
  local out="$1"
  mkdir -p -- "$out" || fail "the folder '$out' cannot be made; name another."
  out="$(CDPATH="" cd -- "$out" && pwd -P)"
  local cutis="$bin/cutis-cli" maps="$out/maps.exr"

  step "Simulating photographs of a patch of skin, 1024 x 1024 pixels, under three lights"
  "$cutis" simulate --patch 1024x1024 -o "$out/sample"

  step "Fitting the five chromophores"
  "$cutis" fit "$out/sample" -o "$maps" --deviation --report "$out/fit.json"

  step "Editing: twice the melanin, and more blood"
  local edits=(--melanin 2 --haemoglobin 1.4)
  "$cutis" edit "$maps" -o "$out/maps_edited.exr" --quiet "${edits[@]}"
  "$cutis" apply "$out/sample" --maps "$maps" -o "$out/albedo_edited.exr" "${edits[@]}"

  step "Rendering under daylight, in the ultraviolet and in the near infrared"
  "$cutis" render "$maps" -o "$out/d65.png" --light D65
  "$cutis" render "$maps" -o "$out/uv.png" --band uv
  "$cutis" render "$maps" -o "$out/nir.png" --band nir

  step "Drawing the contact sheet"
  contact_sheet "$out" "$out/contact_sheet.png"

  step "Done. In $out"
  describe "$out" sample/capture.json "the simulated capture: photographs under three lights"
  describe "$out" sample/maps.exr "the true chromophores the photographs were made from"
  describe "$out" maps.exr "the fitted chromophores, with their deviations"
  describe "$out" fit.json "what the fit did: counts, times, residuals"
  describe "$out" maps_edited.exr "the chromophores after the edit"
  describe "$out" albedo_edited.exr "the edited albedo, linear Rec.709"
  describe "$out" d65.png "the fitted skin under daylight, D65"
  describe "$out" uv.png "mean reflectance from 300 to 400 nm, extrapolated from visible light"
  describe "$out" nir.png "mean reflectance from 700 to 1000 nm, extrapolated as well"
  describe "$out" contact_sheet.png "all of it on one page: look at this first"
}

# describe FOLDER FILE TEXT
describe() {
  [[ -s "$1/$2" ]] || fail "'$1/$2' was not written."
  printf '%s\n    %s\n' "$1/$2" "$3"
}

mode="auto"
folder=""
while [[ $# -gt 0 ]]; do
  case "$1" in
    -h | --help)
      usage
      exit 0
      ;;
    --cli) mode="cli" ;;
    --build-only) mode="build" ;;
    -*) fail "unknown option '$1'; see packaging/start.sh --help" ;;
    *)
      [[ -z "$folder" ]] || fail "one folder at most; see packaging/start.sh --help"
      folder="$1"
      ;;
  esac
  shift
done
if [[ "$mode" == "auto" ]]; then
  if [[ -z "$folder" && -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]]; then
    mode="editor"
  else
    mode="cli"
  fi
fi
# A folder is meant from where the script was started.
case "$folder" in
  "") folder="$cutis_root/build/sample-run" ;;
  /*) ;;
  *) folder="$started_in/$folder" ;;
esac

if [[ "$mode" == "editor" && -z "${DISPLAY:-}" ]]; then
  cutis_packages+=(qt6-wayland)
fi
install_packages

case "$mode" in
  build)
    build cutis cutis-cli
    step "Done"
    printf '%s\n    %s\n' "$bin/cutis" "the editor" "$bin/cutis-cli" "the command line"
    ;;
  editor)
    build cutis cutis-cli
    step "Starting the editor"
    exec "$bin/cutis" --sample
    ;;
  cli)
    build cutis-cli
    sample_run "$folder"
    ;;
esac
