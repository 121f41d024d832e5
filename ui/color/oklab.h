#pragma once  // internal to ui/color

// OKLab (Ottosson 2020), a space in which equal distances look about equally different, and its way
// to sRGB. For the colours of the interface; the colours of skin come from core/spectra.

#include <QRgb>

namespace cutis {

struct OkLab {
  double lightness = 0;  // 0 black, 1 white
  double a = 0;          // green to red
  double b = 0;          // blue to yellow
};

double distance(const OkLab& from, const OkLab& to);

// Opaque. Colours outside sRGB are clipped per channel.
QRgb toSrgb(const OkLab& color);

}  // namespace cutis
