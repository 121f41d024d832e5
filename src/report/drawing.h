#pragma once

// A picture of lines, markers and words, kept as SVG.
//
// Places and lengths are pixels, x to the right and y downwards; colours are "#rrggbb". Words are
// UTF-8 and may hold anything; y is their baseline. What is added later lies above.

#include <span>
#include <string>
#include <string_view>

namespace cutis {

struct Point {
  double x = 0.0;
  double y = 0.0;
};

// Half-open on no side: boxes that touch do not overlap.
struct Box {
  double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;

  bool overlaps(const Box& other) const {
    return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
  }
  bool holds(const Box& other) const {
    return left <= other.left && top <= other.top && other.right <= right && other.bottom <= bottom;
  }
};

struct Stroke {
  const char* color = "#000000";
  double width = 1.0;
  const char* dashes = "";  // lengths on and off, "6 4"
};

enum class Anchor { start, middle, end };

struct TextStyle {
  double size = 12.0;  // of an em
  const char* color = "#000000";
  bool bold = false;
};

class Drawing {
 public:
  // description: what a reader who cannot see it should know.
  Drawing(double width, double height, std::string title, std::string description);

  // Either colour may be "none".
  void rectangle(const Box& box, const char* fill, const Stroke& stroke, double cornerRadius = 0.0);
  void disc(Point centre, double radius, const char* fill, const Stroke& stroke);
  void line(Point from, Point to, const Stroke& stroke);
  void polyline(std::span<const Point> points, const Stroke& stroke);
  // What the points enclose, without a rim.
  void area(std::span<const Point> points, const char* fill);

  void text(Point at, std::string_view words, const TextStyle& style, Anchor anchor);
  // Turned by a quarter, to be read from the right; centred.
  void textUpwards(Point at, std::string_view words, const TextStyle& style);
  // 10 and an exponent. The two meet in one place, whatever font the viewer has.
  void powerOfTen(Point at, int exponent, const TextStyle& style, Anchor anchor);

  double width() const { return width_; }
  double height() const { return height_; }

  // family: of the font, as in CSS.
  std::string svg(std::string_view family) const;

 private:
  double width_;
  double height_;
  std::string title_;
  std::string description_;
  std::string body_;
};

// How far words reach in DejaVu Sans, which is wider than most fonts.
double textWidth(std::string_view words, double size);
// Words that reach no farther than `width`, with an ellipsis where some had to go.
std::string shortened(std::string_view words, double size, double width);

}  // namespace cutis
