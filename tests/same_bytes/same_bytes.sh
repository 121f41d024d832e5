#!/usr/bin/env bash
# Runs one list of commands with two programs on this machine and compares what they write, byte by
# byte: what a change that must change no result is held against.
set -euo pipefail

usage() {
  cat <<'END'
Usage: tests/same_bytes/same_bytes.sh OLD NEW [NAME...]

OLD and NEW are two builds of cutis-cli. Every command of the list runs with both, each in a folder
of its own with the same inputs (made once, by OLD); their files, standard output and exit status
must be equal. Notes and errors on standard error are compared, too, but only reported: they may be
worded anew. With NAMEs only the commands whose name contains one of them run.

Times, dates and the peak of memory are left out. Nothing is stored between runs, because
floating-point results are equal on one machine only.

  KEEP=FOLDER   keeps all files there (default: a temporary folder that is removed)

The exit status is 0 when all bytes are equal.
END
}

if [[ $# -lt 2 || "$1" == "-h" || "$1" == "--help" ]]; then
  usage
  [[ "${1:-}" == "-h" || "${1:-}" == "--help" ]] && exit 0
  exit 2
fi

old_program="$(realpath -- "$1")"
new_program="$(realpath -- "$2")"
shift 2
names=("$@")

scratch="${KEEP:-}"
if [[ -z "$scratch" ]]; then
  scratch="$(mktemp -d)"
  trap 'rm -rf -- "$scratch"' EXIT
fi
mkdir -p -- "$scratch/old" "$scratch/new" "$scratch/in"
in="$scratch/in"

compared=0
different=0
reworded=0

wanted() {
  local name
  [[ ${#names[@]} -eq 0 ]] && return 0
  for name in "${names[@]}"; do
    [[ "$1" == *"$name"* ]] && return 0
  done
  return 1
}

# run PROGRAM FOLDER COMMAND...: in the folder, whose files in/ are the inputs.
run() {
  local program="$1" folder="$2" status=0
  shift 2
  mkdir -p -- "$folder"
  ln -sfn -- "$in" "$folder/in"
  (cd -- "$folder" && "$program" "$@" >stdout 2>stderr </dev/null) || status=$?
  printf '%s\n' "$status" >"$folder/status"
}

# A file less what differs between two runs of one program: times, dates, the peak of memory.
comparable() {
  local date='[0-9]{4}:[0-9]{2}:[0-9]{2} [0-9]{2}:[0-9]{2}:[0-9]{2}'
  case "$1" in
    *.report.json) sed -E '/"(load|prepare|fit|write|peak_memory_bytes)":/d' "$1" ;;
    */stdout) sed -E -e '/^ *seconds /d' -e 's/[0-9.e-]+ s($|[^a-z])/… s\1/g' "$1" ;;
    *) LC_ALL=C sed -E "s/$date/date/g" "$1" ;;
  esac
}

# same NAME COMMAND...: the files a command leaves in its folder, from both programs.
same() {
  local name="$1" file equal=1
  shift
  wanted "$name" || return 0
  run "$old_program" "$scratch/old/$name" "$@"
  run "$new_program" "$scratch/new/$name" "$@"
  compared=$((compared + 1))
  while IFS= read -r file; do
    case "$file" in
      ./stderr)
        cmp -s -- "$scratch/old/$name/$file" "$scratch/new/$name/$file" || {
          reworded=$((reworded + 1))
          printf 'reworded   %s\n' "$name"
        }
        ;;
      *)
        cmp -s -- <(comparable "$scratch/old/$name/$file") \
          <(comparable "$scratch/new/$name/$file") || {
          equal=0
          printf 'DIFFERENT  %s: %s\n' "$name" "$file"
        }
        ;;
    esac
  done < <({
    (cd -- "$scratch/old/$name" && find . -type f)
    (cd -- "$scratch/new/$name" && find . -type f)
  } | sort -u)
  if [[ $equal -eq 1 ]]; then
    printf 'same       %s (status %s)\n' "$name" "$(cat -- "$scratch/old/$name/status")"
  else
    different=$((different + 1))
  fi
}

make_inputs() {
  local cli="$old_program"
  "$cli" simulate --patch 160x120 --seed 7 -o "$in/capture" --quiet
  "$cli" simulate --patch 48x40 --seed 3 --profile li2024 -o "$in/small" --quiet
  cat >"$in/lamps.json" <<'END'
{ "cutis_rig": 1, "name": "lamps",
  "camera": {"sensitivity": "flat.csv"},
  "lights": [ {"name": "n405", "spectrum": "n405.csv"}, {"name": "n450", "spectrum": "n450.csv"},
              {"name": "n500", "spectrum": "n500.csv"}, {"name": "n545", "spectrum": "n545.csv"},
              {"name": "n578", "spectrum": "n578.csv"}, {"name": "n630", "spectrum": "n630.csv"},
              {"name": "n780", "spectrum": "n780.csv"}, {"name": "n940", "spectrum": "n940.csv"} ],
  "noise": {"read": 0.0001, "proportional": 0.005} }
END
  printf 'nm,R,G,B\n300,1,1,1\n1000,1,1,1\n' >"$in/flat.csv"
  local centre
  for centre in 405 450 500 545 578 630 780 940; do
    printf 'nm,power\n%d,0\n%d,1\n%d,0\n' $((centre - 12)) "$centre" $((centre + 12)) \
      >"$in/n$centre.csv"
  done
  "$cli" simulate --patch 24x20 --seed 5 --rig "$in/lamps.json" -o "$in/many" --quiet
  "$cli" fit "$in/capture" -o "$in/maps.exr" --quiet
  # Skin of real people, of which the model leaves something over.
  cp -R -- "$in/capture" "$in/real"
  sed -i 's/"simulated": true/"simulated": false/' "$in/real/capture.json"
  "$cli" fit "$in/real" -o "$in/left_over.exr" --quiet
  "$cli" fit "$in/many" --rig "$in/lamps.json" --free oxygenation -o "$in/free.exr" --quiet
  "$cli" fit "$in/small" --profile li2024 -o "$in/li2024.exr" --quiet
  "$cli" render "$in/maps.exr" -o "$in/texture.exr" --bit-depth float --quiet
  "$cli" render "$in/maps.exr" -o "$in/texture.png" --quiet
  "$cli" render "$in/maps.exr" -o "$in/texture.tif" --quiet
  "$cli" render "$in/maps.exr" -o "$in/mask.png" --band 600:700 --quiet
  cat >"$in/parameters.csv" <<'END'
melanin,melanin_blend,haemoglobin_dermal,haemoglobin_epidermal,carotene
0,0,0,0,0
0.02,0.5,0.02,0.01,0.001
0.1,0.7,0.05,0.05,0.002
0.25,0.9,0.1,0.02,0.0005
0.5,1,0.5,0.3,0.01
END
  "$cli" spectrum --csv "$in/parameters.csv" -o "$in/spectra.csv" --quiet
  local person
  printf 'melanin,melanin_blend,haemoglobin_dermal,haemoglobin_epidermal,carotene\n' \
    >"$in/people_parameters.csv"
  for person in 1 2 3 4 5 6 7 8 9; do
    printf '0.0%d,0.%d,0.00%d,0.0%d,0.00%d\n' "$person" "$person" $((10 - person)) \
      $((1 + person % 4)) $((1 + person % 3)) >>"$in/people_parameters.csv"
  done
  "$cli" spectrum --csv "$in/people_parameters.csv" -o "$in/people.csv" --quiet
  cat >"$in/prior.json" <<'END'
{"scale": "log",
 "mean": {"melanin": 0.03, "melanin_blend": 0.6, "haemoglobin_dermal": 0.02,
          "haemoglobin_epidermal": 0.02, "carotene": 0.001},
 "sd": {"melanin": 0.8, "melanin_blend": 0.5, "haemoglobin_dermal": 0.8,
        "haemoglobin_epidermal": 0.8, "carotene": 0.8}}
END
}

printf '== inputs\n'
make_inputs

printf '== commands\n'
same simulate-patch simulate --patch 64x48 --seed 11 -o capture
same simulate-li2024 simulate --patch 64x48 --profile li2024 --noise 0.01 -o capture
same simulate-maps simulate in/maps.exr --rig monitor --noise 0 -o capture
same simulate-free simulate in/free.exr --rig in/lamps.json -o capture

same fit-refined fit in/capture -o maps.exr --report fit.report.json
same fit-one-thread fit in/capture -o maps.exr --threads 1
same fit-deviation fit in/capture -o maps.exr --deviation
same fit-shading fit in/capture -o maps.exr --shading --deviation
same fit-li2024 fit in/capture -o maps.exr --profile li2024 --deviation --report fit.report.json
same fit-exact fit in/capture -o maps.exr --noise 0,0
same fit-noisy fit in/capture -o maps.exr --noise 0.001,0.02
same fit-prior fit in/capture -o maps.exr --prior in/prior.json --deviation
same fit-fixed fit in/capture -o maps.exr --fix carotene=0 --fix melanin_blend=0.5
same fit-lights fit in/capture -o maps.exr --lights white,white+blue
same fit-mask fit in/capture -o maps.exr --mask in/mask.png --report fit.report.json
same fit-specular fit in/capture -o maps.exr --specular included --specular-share 0.03
same fit-three-stage fit in/capture -o maps.exr --method three-stage
same fit-full-search fit in/small -o maps.exr --method full-search --profile li2024
same fit-network fit in/capture -o maps.exr --method network
same fit-network-5 fit in/capture -o maps.exr --method network --weights monitor-5
same fit-network-li2024 fit in/small -o maps.exr --method network --profile li2024
same fit-free-oxygenation fit in/many --rig in/lamps.json -o maps.exr --free oxygenation --deviation
same fit-free-both fit in/many --rig in/lamps.json -o maps.exr --free oxygenation,thickness
same fit-left-over fit in/real -o maps.exr --deviation --report fit.report.json
same fit-left-over-off fit in/real -o maps.exr --discrepancy off
same fit-left-over-removed fit in/real -o maps.exr --specular excluded
same fit-texture fit in/texture.exr -o maps.exr --report fit.report.json
same fit-texture-8 fit in/texture.png -o maps.exr --deviation
same fit-texture-search fit in/texture.png -o maps.exr --method three-stage
same fit-refused fit in/texture.png -o maps.exr --shading --method network

same edit edit in/maps.exr -o maps.exr --melanin 1.7 --haemoglobin 0.6 --carotene 2
same edit-add edit in/maps.exr -o maps.exr --add melanin=0.01 --set carotene=0.002
same edit-mask edit in/maps.exr -o maps.exr --melanin 3 --melanin-blend 0.5 --mask in/mask.png
same edit-left-over edit in/left_over.exr -o maps.exr --melanin 1.5
same edit-free edit in/free.exr -o maps.exr --haemoglobin-dermal 2

same apply-exr apply in/texture.exr -o out.exr --melanin 2
same apply-png apply in/texture.png -o out.png --haemoglobin 1.5
same apply-tif apply in/texture.tif -o out.tif --carotene 3 --mask in/mask.png
same apply-jpg apply in/texture.png -o out.jpg --melanin 0.5
same apply-neutral apply in/texture.png -o out.png
same apply-maps apply in/capture --maps in/maps.exr -o out.exr --melanin 1.3
same apply-pure apply in/texture.exr -o out.exr --pure --melanin 1.3
same apply-space apply in/texture.png -o out.exr --colorspace ACEScg --set melanin=0.05
same apply-free apply in/many --maps in/free.exr -o out.exr --melanin 2
same apply-capture apply in/capture -o out.png --haemoglobin 1.4 --method network

same render-d65 render in/maps.exr -o out.exr
same render-png render in/maps.exr -o out.png --light A --adapt bradford
same render-tif render in/maps.exr -o out.tif --light FL2 --observer cie1964 --bit-depth float
same render-uv render in/maps.exr -o out.png --band uv
same render-nir render in/maps.exr -o out.exr --band nir --bit-depth float
same render-band render in/li2024.exr -o out.exr --band 520:560 --bit-depth float
same render-li2024 render in/li2024.exr -o out.exr --bit-depth float
same render-left-over render in/left_over.exr -o out.exr --bit-depth float
same render-free render in/free.exr -o out.exr --bit-depth float
same render-space render in/maps.exr -o out.exr --colorspace ACEScg --adapt cat16 --light A

same spectrum spectrum --csv in/parameters.csv
same spectrum-li2024 spectrum --csv in/parameters.csv --profile li2024
same spectrum-specular spectrum --csv in/parameters.csv --specular included --aperture-radius 2
same spectrum-one spectrum --params 0.1,0.7,0.05,0.05,0.002 -o out.csv
same spectrum-maps spectrum --maps in/left_over.exr --at 20,20 --at 100,60
same spectrum-deviation spectrum --maps in/left_over.exr --at 20,20 --deviation
same fit-spectra fit-spectra in/spectra.csv -o out.csv
same fit-spectra-range fit-spectra in/spectra.csv -o out.csv --range 320:900 --profile li2024
same fit-spectra-free fit-spectra in/spectra.csv -o out.csv --free oxygenation,thickness

same validate validate in/spectra.csv --profile li2024,skin2026
same validate-capture validate in/people.csv --capture monitor --noise 0.005 --halvings 0 -o out.csv
same calibrate-profile calibrate-profile own-people in/people.csv -o out.json --halvings 0
same rig-identify rig identify --people 60
same rig-identify-li2024 rig identify --rig in/lamps.json --profile li2024 --people 40
same train train --rig monitor --people 3000 --epochs 3 --table-step 40 --hidden 8,8 --seed 2 \
  -o weights.json --quiet
same train-paper train --rig monitor --channels paper --people 2000 --epochs 2 --table-step 60 \
  --hidden 6 --profile li2024 --seed 4 -o weights.json --quiet
same info-maps info in/maps.exr
same info-free info in/free.exr
same info-capture info in/capture
same usage fit

printf '\n%d commands compared, %d different, %d reworded\n' "$compared" "$different" "$reworded"
[[ $different -eq 0 ]]
