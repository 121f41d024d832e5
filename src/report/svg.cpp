#include "src/report/svg.h"

#include <array>
#include <charconv>
#include <cstdio>
#include <span>

namespace cutis {
namespace {

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

std::string attribute(std::string_view name, std::string_view value) {
  return " " + std::string(name) + "=\"" + escaped(value) + "\"";
}

std::string attribute(std::string_view name, double value) {
  return attribute(name, number(value));
}

// name: "fill" or "stroke".
std::string colored(const std::string& name, Color color) {
  if (color.isNone()) return attribute(name, "none");
  std::array<char, 8> hex;
  std::snprintf(hex.data(), hex.size(), "#%02x%02x%02x", color.red, color.green, color.blue);
  std::string text = attribute(name, hex.data());
  if (color.alpha == 255) return text;
  std::array<char, 8> opacity;
  const auto end = std::to_chars(opacity.data(), opacity.data() + opacity.size(),
                                 color.alpha / 255.0, std::chars_format::fixed, 3);
  return text + attribute(name + "-opacity", {opacity.data(), end.ptr});
}

std::string placesOf(std::span<const Point> points) {
  std::string places;
  for (const Point& point : points)
    places += (places.empty() ? "" : " ") + number(point.x) + "," + number(point.y);
  return places;
}

std::string strokeOf(const Stroke& stroke) {
  std::string text = colored("stroke", stroke.color);
  if (stroke.color.isNone()) return text;
  text += attribute("stroke-width", stroke.width);
  if (stroke.dash > 0.0)
    text += attribute("stroke-dasharray", number(stroke.dash) + " " + number(stroke.gap));
  return text;
}

std::string styleOf(const TextStyle& style, Anchor anchor) {
  constexpr std::array<const char*, 3> anchors = {"start", "middle", "end"};
  return attribute("font-size", style.size) + colored("fill", style.color) +
         (style.bold ? attribute("font-weight", "bold") : std::string()) +
         attribute("text-anchor", anchors[static_cast<std::size_t>(anchor)]);
}

std::string elementOf(const Polyline& polyline) {
  return "<polyline" + attribute("points", placesOf(polyline.points)) + attribute("fill", "none") +
         strokeOf(polyline.stroke) + attribute("stroke-linejoin", "round") + "/>\n";
}

std::string elementOf(const Area& area) {
  return "<polygon" + attribute("points", placesOf(area.points)) + colored("fill", area.fill) +
         "/>\n";
}

std::string elementOf(const Rectangle& rectangle) {
  const Box& box = rectangle.box;
  return "<rect" + attribute("x", box.left) + attribute("y", box.top) +
         attribute("width", box.width()) + attribute("height", box.height()) +
         (rectangle.cornerRadius > 0.0 ? attribute("rx", rectangle.cornerRadius) : std::string()) +
         colored("fill", rectangle.fill) + strokeOf(rectangle.stroke) + "/>\n";
}

std::string elementOf(const Disc& disc) {
  return "<circle" + attribute("cx", disc.centre.x) + attribute("cy", disc.centre.y) +
         attribute("r", disc.radius) + colored("fill", disc.fill) + strokeOf(disc.stroke) + "/>\n";
}

std::string elementOf(const Text& text) {
  const std::string place = text.upwards
                                ? attribute("transform", "translate(" + number(text.at.x) + " " +
                                                             number(text.at.y) + ") rotate(-90)")
                                : attribute("x", text.at.x) + attribute("y", text.at.y);
  return "<text" + place + styleOf(text.style, text.anchor) + ">" + escaped(text.words) +
         "</text>\n";
}

}  // namespace

std::string svgOf(const Drawing& drawing, std::string_view family) {
  std::string text =
      "<svg xmlns=\"http://www.w3.org/2000/svg\"" + attribute("width", drawing.width) +
      attribute("height", drawing.height) +
      attribute("viewBox", "0 0 " + number(drawing.width) + " " + number(drawing.height)) +
      attribute("font-family", family) + " role=\"img\">\n<title>" + escaped(drawing.title) +
      "</title>\n<desc>" + escaped(drawing.description) + "</desc>\n";
  for (const Primitive& primitive : drawing.primitives)
    text += std::visit([](const auto& one) { return elementOf(one); }, primitive);
  return text + "</svg>\n";
}

}  // namespace cutis
