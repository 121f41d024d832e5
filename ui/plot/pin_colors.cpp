#include "ui/plot/pin_colors.h"

#include <array>
#include <cstddef>

namespace cutis {
namespace {

constexpr std::array<std::uint32_t, 6> kOnDark = {0x7fc99a, 0xc9a0dc, 0xf0e442,
                                                  0xff8a65, 0x5ad1e6, 0xe8e8e8};
// At least 4.5 : 1 on white.
constexpr std::array<std::uint32_t, 6> kOnPaper = {0x1b7344, 0x7b3fa0, 0x7a6800,
                                                   0xb8400a, 0x00708a, 0x404040};

std::size_t paletteIndex(int number) {
  return static_cast<std::size_t>(number) % kOnDark.size();
}

}  // namespace

Color pinColor(int number) {
  return Color::rgb(kOnDark[paletteIndex(number)]);
}

Color printedPinColor(int number) {
  return Color::rgb(kOnPaper[paletteIndex(number)]);
}

}  // namespace cutis
