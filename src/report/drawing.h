#pragma once

// A picture as a list of lines, filled areas, markers and words, which knows nothing of how it is
// drawn: svg.h writes it as SVG, ui/plot paints it with QPainter.
//
// Places and lengths are pixels, x to the right and y downwards. Words are UTF-8 and may hold
// anything; y is their baseline. What is added later lies above. Places must be finite.

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "src/report/geometry.h"

namespace cutis {

// sRGB; alpha 0 is not drawn at all.
struct Color {
  std::uint8_t red = 0, green = 0, blue = 0, alpha = 255;

  // From 0xrrggbb.
  static constexpr Color rgb(std::uint32_t value) {
    return {static_cast<std::uint8_t>(value >> 16), static_cast<std::uint8_t>(value >> 8),
            static_cast<std::uint8_t>(value), 255};
  }
  // The same colour, of which the ground shows a part.
  constexpr Color faded(std::uint8_t share) const { return {red, green, blue, share}; }
  constexpr bool isNone() const { return alpha == 0; }

  bool operator==(const Color&) const = default;
};

inline constexpr Color kNoColor = {0, 0, 0, 0};

struct Stroke {
  Color color;
  double width = 1.0;
  double dash = 0.0, gap = 0.0;  // lengths along the line; no dash: a whole line

  bool operator==(const Stroke&) const = default;
};

inline constexpr Stroke kNoStroke = {kNoColor, 0.0};

enum class Anchor { start, middle, end };

struct TextStyle {
  double size = 12.0;  // of an em
  Color color;
  bool bold = false;

  bool operator==(const TextStyle&) const = default;
};

struct Polyline {
  std::vector<Point> points;  // at least two
  Stroke stroke;

  bool operator==(const Polyline&) const = default;
};

// What the points enclose, without a rim.
struct Area {
  std::vector<Point> points;
  Color fill;

  bool operator==(const Area&) const = default;
};

struct Rectangle {
  Box box;
  Color fill = kNoColor;
  Stroke stroke = kNoStroke;
  double cornerRadius = 0.0;

  bool operator==(const Rectangle&) const = default;
};

struct Disc {
  Point centre;
  double radius = 1.0;
  Color fill = kNoColor;
  Stroke stroke = kNoStroke;

  bool operator==(const Disc&) const = default;
};

struct Text {
  Point at;
  std::string words;
  TextStyle style;
  Anchor anchor = Anchor::start;
  bool upwards = false;  // turned by a quarter, to be read from the right

  bool operator==(const Text&) const = default;
};

using Primitive = std::variant<Polyline, Area, Rectangle, Disc, Text>;

struct Drawing {
  double width = 0.0, height = 0.0;
  std::string title;
  std::string description;  // what a reader who cannot see it should know
  std::vector<Primitive> primitives;

  void add(Primitive primitive) { primitives.push_back(std::move(primitive)); }
  void line(Point from, Point to, const Stroke& stroke) { add(Polyline{{from, to}, stroke}); }

  bool operator==(const Drawing&) const = default;
};

}  // namespace cutis
