#pragma once

// False-colour scales: 256 sRGB colours at equal distances along a path through OKLab. Lightness
// alone already carries the order, so that they read the same with any colour vision, and in print.
//
// Values are mapped linearly from [minimum, maximum] and clamped to its ends. What has no value
// (masked, invalid, NaN) is a dark neutral that no scale with colour contains; maskedPixel adds a
// hatch that distinguishes it from the dark end of the grey scale too. Safe from any thread.

#include <array>

#include <QRgb>

namespace cutis {

enum class ScaleKind {
  sequential,  // dark blue to pale yellow: concentrations, deviations
  diverging,   // blue, white, brown: differences around zero
  grey,        // near black to white: ultraviolet and near infrared
};

class ColorScale {
 public:
  static const ColorScale& of(ScaleKind kind);

  // Colours from that of the minimum to that of the maximum.
  const std::array<QRgb, 256>& table() const { return table_; }

  QRgb at(double value, double minimum, double maximum) const;

 private:
  explicit ColorScale(const std::array<QRgb, 256>& table) : table_(table) {}

  std::array<QRgb, 256> table_;
};

// Flat grey for what has no value.
inline constexpr QRgb kMaskedColor = 0xff2a2a2a;

// The same with a diagonal hatch; x and y in pixels of the drawn image.
QRgb maskedPixel(int x, int y);

}  // namespace cutis
