# The page of pictures that start.sh leaves: drawn with OpenImageIO's oiiotool. To be sourced.
# shellcheck shell=bash

sheet_tile=400    # pixels, width and height of a picture
sheet_caption=44  # pixels below it
sheet_pad=12

# draw_tile OUT CAPTION INPUT [OIIOTOOL OPTION...]: a picture, scaled, over its caption.
draw_tile() {
  local out="$1" caption="$2"
  shift 2
  oiiotool "$@" --resize "${sheet_tile}x${sheet_tile}" \
    --pattern constant:color=0.1,0.1,0.1 "${sheet_tile}x$((sheet_tile + sheet_caption))" 3 \
    --paste +0+0 \
    --text:x=2:y=$((sheet_tile + 30)):size=20:font=DejaVuSans:color=0.9,0.9,0.9 "$caption" \
    -d uint8 -o "$out" ||
    fail "oiiotool could not draw '$caption' for the contact sheet; its message is above."
}

# draw_photograph OUT CAPTION FILE: linear values, shown as on an sRGB display.
draw_photograph() {
  draw_tile "$1" "$2" "$3" --ch R,G,B --clamp:min=0:max=1 --colorconvert linear sRGB
}

# draw_map OUT CAPTION FILE CHANNEL MAXIMUM: one chromophore in false colour, 0 to its maximum.
draw_map() {
  draw_tile "$1" "$2, 0 to $5" "$3" --subimage chromophores --ch "$4" --divc "$5" \
    --clamp:min=0:max=1 --colormap inferno
}

# contact_sheet FOLDER OUT: what sample_run of start.sh wrote into the folder, on one page.
contact_sheet() {
  local in="$1" out="$2"
  tiles="$(mktemp -d)"
  trap 'rm -rf -- "$tiles"' EXIT

  draw_photograph "$tiles/01.png" "photograph, white light" "$in/sample/white.exr"
  draw_photograph "$tiles/02.png" "photograph, more blue" "$in/sample/white_blue.exr"
  draw_photograph "$tiles/03.png" "photograph, more green" "$in/sample/white_green.exr"
  draw_tile "$tiles/04.png" "fitted skin under D65" "$in/d65.png" --ch R,G,B

  draw_map "$tiles/05.png" "melanin" "$in/maps.exr" melanin 0.12
  draw_map "$tiles/06.png" "melanin blend" "$in/maps.exr" melanin_blend 1
  draw_map "$tiles/07.png" "haemoglobin, dermis" "$in/maps.exr" haemoglobin_dermal 0.08
  draw_map "$tiles/08.png" "haemoglobin, epidermis" "$in/maps.exr" haemoglobin_epidermal 0.12

  draw_map "$tiles/09.png" "carotene, g/L" "$in/maps.exr" carotene 0.008
  draw_tile "$tiles/10.png" "ultraviolet, 300 to 400 nm" "$in/uv.png" --ch 0,0,0
  draw_tile "$tiles/11.png" "near infrared, 700 to 1000 nm" "$in/nir.png" --ch 0,0,0
  draw_photograph "$tiles/12.png" "edited albedo" "$in/albedo_edited.exr"

  oiiotool "$tiles"/*.png --mosaic:pad=$sheet_pad 4x3 -o "$out" ||
    fail "oiiotool could not write the contact sheet; its message is above."
}
