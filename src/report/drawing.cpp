#include "src/report/drawing.h"

#include <array>
#include <charconv>
#include <utility>

namespace cutis {
namespace {

// DejaVu Sans, from the blank to the tilde, in thousandths of an em.
constexpr std::array<short, 95> kWidths = {
    318, 401, 460, 838, 636, 950, 780, 275, 390, 390, 500, 838, 318, 361,  318, 337, 636, 636, 636,
    636, 636, 636, 636, 636, 636, 636, 337, 337, 838, 838, 838, 531, 1000, 684, 686, 698, 770, 632,
    575, 775, 752, 295, 295, 656, 557, 863, 748, 787, 603, 787, 695, 635,  611, 732, 684, 989, 685,
    611, 685, 390, 337, 390, 838, 500, 500, 613, 635, 550, 635, 615, 352,  635, 634, 278, 278, 579,
    278, 974, 634, 612, 635, 635, 411, 521, 392, 634, 592, 818, 592, 592,  525, 636, 337, 636, 838};
constexpr double kOtherWidth = 838;  // signs such as ≤; letters with accents are narrower

constexpr double kExponentSize = 0.74;
constexpr double kExponentRise = 0.42;

std::string number(double value) {
  std::array<char, 32> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                 std::chars_format::fixed, 1);
  std::string text(buffer.data(), end.ptr);
  if (text.ends_with(".0")) text.resize(text.size() - 2);
  return text == "-0" ? "0" : text;
}

std::string escaped(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    if (c == '<') {
      safe += "&lt;";
    } else if (c == '&') {
      safe += "&amp;";
    } else if (c == '"') {
      safe += "&quot;";
    } else {
      // Other control characters are not allowed in XML.
      safe += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return safe;
}

std::string attribute(const char* name, std::string_view value) {
  return " " + std::string(name) + "=\"" + escaped(value) + "\"";
}

std::string attribute(const char* name, double value) {
  return attribute(name, number(value));
}

std::string placesOf(std::span<const Point> points) {
  std::string places;
  for (const Point& point : points)
    places += (places.empty() ? "" : " ") + number(point.x) + "," + number(point.y);
  return places;
}

std::string strokeOf(const Stroke& stroke) {
  std::string text = attribute("stroke", stroke.color);
  if (std::string_view(stroke.color) == "none") return text;
  text += attribute("stroke-width", stroke.width);
  if (*stroke.dashes != '\0') text += attribute("stroke-dasharray", stroke.dashes);
  return text;
}

std::string styleOf(const TextStyle& style, Anchor anchor) {
  constexpr std::array<const char*, 3> anchors = {"start", "middle", "end"};
  return attribute("font-size", style.size) + attribute("fill", style.color) +
         (style.bold ? attribute("font-weight", "bold") : std::string()) +
         attribute("text-anchor", anchors[static_cast<std::size_t>(anchor)]);
}

bool continuesCharacter(char c) {
  return (static_cast<unsigned char>(c) & 0xc0) == 0x80;
}

}  // namespace

Drawing::Drawing(double width, double height, std::string title, std::string description)
    : width_(width),
      height_(height),
      title_(std::move(title)),
      description_(std::move(description)) {}

void Drawing::rectangle(const Box& box, const char* fill, const Stroke& stroke,
                        double cornerRadius) {
  body_ += "<rect" + attribute("x", box.left) + attribute("y", box.top) +
           attribute("width", box.right - box.left) + attribute("height", box.bottom - box.top) +
           (cornerRadius > 0.0 ? attribute("rx", cornerRadius) : std::string()) +
           attribute("fill", fill) + strokeOf(stroke) + "/>\n";
}

void Drawing::disc(Point centre, double radius, const char* fill, const Stroke& stroke) {
  body_ += "<circle" + attribute("cx", centre.x) + attribute("cy", centre.y) +
           attribute("r", radius) + attribute("fill", fill) + strokeOf(stroke) + "/>\n";
}

void Drawing::line(Point from, Point to, const Stroke& stroke) {
  body_ += "<line" + attribute("x1", from.x) + attribute("y1", from.y) + attribute("x2", to.x) +
           attribute("y2", to.y) + strokeOf(stroke) + "/>\n";
}

void Drawing::polyline(std::span<const Point> points, const Stroke& stroke) {
  body_ += "<polyline" + attribute("points", placesOf(points)) + attribute("fill", "none") +
           strokeOf(stroke) + "/>\n";
}

void Drawing::area(std::span<const Point> points, const char* fill) {
  body_ += "<polygon" + attribute("points", placesOf(points)) + attribute("fill", fill) + "/>\n";
}

void Drawing::text(Point at, std::string_view words, const TextStyle& style, Anchor anchor) {
  body_ += "<text" + attribute("x", at.x) + attribute("y", at.y) + styleOf(style, anchor) + ">" +
           escaped(words) + "</text>\n";
}

void Drawing::textUpwards(Point at, std::string_view words, const TextStyle& style) {
  body_ +=
      "<text" +
      attribute("transform", "translate(" + number(at.x) + " " + number(at.y) + ") rotate(-90)") +
      styleOf(style, Anchor::middle) + ">" + escaped(words) + "</text>\n";
}

void Drawing::powerOfTen(Point at, int exponent, const TextStyle& style, Anchor anchor) {
  const std::string power =
      exponent < 0 ? "−" + std::to_string(-exponent) : std::to_string(exponent);
  TextStyle raised = style;
  raised.size *= kExponentSize;
  const double base = textWidth("10", style.size), top = textWidth(power, raised.size);
  double meet = at.x + base;
  if (anchor == Anchor::middle) meet = at.x + 0.5 * (base - top);
  if (anchor == Anchor::end) meet = at.x - top;
  text({meet, at.y}, "10", style, Anchor::end);
  text({meet + 0.5, at.y - kExponentRise * style.size}, power, raised, Anchor::start);
}

std::string Drawing::svg(std::string_view family) const {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\"" + attribute("width", width_) +
         attribute("height", height_) +
         attribute("viewBox", "0 0 " + number(width_) + " " + number(height_)) +
         attribute("font-family", family) + " role=\"img\">\n<title>" + escaped(title_) +
         "</title>\n<desc>" + escaped(description_) + "</desc>\n" + body_ + "</svg>\n";
}

double textWidth(std::string_view words, double size) {
  double width = 0.0;
  for (const char c : words) {
    if (continuesCharacter(c)) continue;
    const auto index = static_cast<std::size_t>(static_cast<unsigned char>(c)) - 32;
    width += index < kWidths.size() ? kWidths[index] : kOtherWidth;
  }
  return 1e-3 * width * size;
}

std::string shortened(std::string_view words, double size, double width) {
  if (textWidth(words, size) <= width) return std::string(words);
  std::string text(words);
  while (!text.empty() && textWidth(text + "…", size) > width) {
    while (text.size() > 1 && continuesCharacter(text.back()))
      text.pop_back();
    text.pop_back();
  }
  return text + "…";
}

}  // namespace cutis
