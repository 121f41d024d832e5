#include "src/cli/bench_plot.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "src/cli/bench_errors.h"
#include "src/cli/text_table.h"
#include "src/files/atomic_write.h"

namespace cutis {
namespace {

constexpr double kWidth = 860.0;
constexpr double kHeight = 520.0;
constexpr double kPixels = 2048.0 * 2048.0;

// Part of the picture that is plotted in, and what its edges are worth (logarithms to base 10).
constexpr double kLeft = 78.0, kRight = 640.0, kTop = 52.0, kBottom = 452.0;
constexpr int kTimeFrom = -1, kTimeTo = 5;      // seconds
constexpr int kErrorFrom = -10, kErrorTo = -3;  // mean squared

double across(double seconds) {
  const double at = (std::log10(seconds) - kTimeFrom) / (kTimeTo - kTimeFrom);
  return kLeft + std::clamp(at, 0.0, 1.0) * (kRight - kLeft);
}

double down(double error) {
  const double at = (std::log10(std::max(error, 1e-30)) - kErrorFrom) / (kErrorTo - kErrorFrom);
  return kBottom - std::clamp(at, 0.0, 1.0) * (kBottom - kTop);
}

std::string number(double value) {
  return fixedNumber(value, 1);
}

std::string line(double x1, double y1, double x2, double y2, const char* kind) {
  return "<line class=\"" + std::string(kind) + "\" x1=\"" + number(x1) + "\" y1=\"" + number(y1) +
         "\" x2=\"" + number(x2) + "\" y2=\"" + number(y2) + "\"/>\n";
}

std::string words(double x, double y, const char* anchor, const std::string& text,
                  const char* kind = "label") {
  return "<text class=\"" + std::string(kind) + "\" x=\"" + number(x) + "\" y=\"" + number(y) +
         "\" text-anchor=\"" + anchor + "\">" + text + "</text>\n";
}

std::string disc(double x, double y, const char* kind) {
  return "<circle class=\"" + std::string(kind) + "\" cx=\"" + number(x) + "\" cy=\"" + number(y) +
         "\" r=\"5\"/>\n";
}

std::string square(double x, double y) {
  return "<rect class=\"paper\" x=\"" + number(x - 4.5) + "\" y=\"" + number(y - 4.5) +
         "\" width=\"9\" height=\"9\"/>\n";
}

std::string powerOfTen(int exponent) {
  return "10<tspan dy=\"-5\" font-size=\"9\">" +
         (exponent < 0 ? "−" + std::to_string(-exponent) : std::to_string(exponent)) + "</tspan>";
}

std::string timeName(int exponent) {
  constexpr std::array<const char*, 7> names = {"0.1 s",  "1 s",   "10 s", "100 s",
                                                "17 min", "2.8 h", "28 h"};
  return names[static_cast<std::size_t>(exponent - kTimeFrom)];
}

std::string axes() {
  std::string text;
  for (int t = kTimeFrom; t <= kTimeTo; ++t) {
    const double x = across(std::pow(10.0, t));
    text += line(x, kTop, x, kBottom, "grid") + words(x, kBottom + 18.0, "middle", timeName(t));
  }
  for (int e = kErrorFrom; e <= kErrorTo; ++e) {
    const double y = down(std::pow(10.0, e));
    text += line(kLeft, y, kRight, y, "grid") + words(kLeft - 8.0, y + 5.0, "end", powerOfTen(e));
  }
  text += words(0.5 * (kLeft + kRight), kBottom + 42.0, "middle",
                "time for 2048 × 2048 pixels that have nothing in common");
  text += "<text class=\"label\" text-anchor=\"middle\" transform=\"translate(22 " +
          number(0.5 * (kTop + kBottom)) +
          ") rotate(-90)\">mean squared error of reflectance, 400–700 nm</text>\n";
  return text;
}

std::string boundLine(const BenchFigures& figures) {
  for (const BoundFigures& row : figures.bounds) {
    if (row.noise != kUsualNoise) continue;
    const double y = down(row.bound.visible);
    return line(kLeft, y, kRight, y, "bound") +
           words(kRight + 10.0, y + 4.0, "start", "the best possible, 0.5 % noise");
  }
  return {};
}

// Labels that stand side by side on the right, moved apart so that none covers another.
class Labels {
 public:
  void add(double x, double y, std::string text) { all_.push_back({x, y, y, std::move(text)}); }

  std::string text() {
    std::sort(all_.begin(), all_.end(), [](const Label& a, const Label& b) { return a.y < b.y; });
    std::string text;
    for (std::size_t i = 0; i < all_.size(); ++i) {
      Label& label = all_[i];
      const auto overlaps = [&](const Label& other) {
        return std::abs(other.x - label.x) < kWide && label.place - other.place < kApart;
      };
      for (std::size_t j = 0; j < i; ++j) {
        if (overlaps(all_[j])) label.place = all_[j].place + kApart;
      }
      const bool left = label.x + kWide > kWidth;
      text += words(label.x + (left ? -10.0 : 10.0), label.place + 4.0, left ? "end" : "start",
                    label.text);
    }
    return text;
  }

 private:
  static constexpr double kWide = 140.0;
  static constexpr double kApart = 15.0;
  struct Label {
    double x, y, place;
    std::string text;
  };
  std::vector<Label> all_;
};

std::string points(const BenchFigures& figures) {
  std::string text;
  Labels labels;
  for (const BenchMethod method : kBenchMethods) {
    const auto* clean = figuresOf(figures.methods, method, 0.0);
    const auto* noisy = figuresOf(figures.methods, method, kUsualNoise);
    if (clean == nullptr || noisy == nullptr) continue;
    const auto place = [](const MethodFigures& row) {
      return std::pair(across(1e-9 * row.nanosecondsPerPixel * kPixels),
                       down(row.errors.visibleMse));
    };
    const auto [x, y] = place(*clean);
    text += disc(x, y, "clean");
    // The exact setting is for pixels without noise: it has one point.
    if (method == BenchMethod::refinedExact) {
      labels.add(x, y, methodLabel(method));
      continue;
    }
    const auto [noisyX, noisyY] = place(*noisy);
    labels.add(std::max(x, noisyX), y, methodLabel(method));
    text += line(x, y, noisyX, noisyY, "pair") + disc(noisyX, noisyY, "noisy");
  }
  for (const PublishedFigures& row : kPublished) {
    const double x = across(row.secondsFor2048), y = down(row.visibleMse);
    text += square(x, y);
    text += words(x, y - 10.0, "middle", "paper: " + std::string(row.method));
  }
  return text + labels.text();
}

std::string key() {
  std::string text;
  const double y = 30.0;
  text += disc(kLeft + 6.0, y - 4.0, "clean") + words(kLeft + 18.0, y, "start", "no noise");
  text += disc(kLeft + 106.0, y - 4.0, "noisy") + words(kLeft + 118.0, y, "start", "0.5 % noise");
  text += square(kLeft + 226.0, y - 4.0) +
          words(kLeft + 238.0, y, "start", "published by the paper (Titan X, no noise)");
  return text;
}

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '<')
      safe += "&lt;";
    else if (c == '&')
      safe += "&amp;";
    else
      safe += c;
  }
  return safe;
}

// Greys and hues of middling lightness, on no ground of their own.
constexpr char kStyle[] =
    "<style>\n"
    "text { font-family: sans-serif; font-size: 12px; fill: #808080; }\n"
    ".grid { stroke: #808080; stroke-opacity: 0.25; }\n"
    ".bound { stroke: #2f9e6e; stroke-width: 1.5; stroke-dasharray: 6 4; }\n"
    ".pair { stroke: #d9722b; stroke-opacity: 0.6; }\n"
    ".clean { fill: #d9722b; stroke: #d9722b; stroke-width: 1.5; }\n"
    ".noisy { fill: none; stroke: #d9722b; stroke-width: 1.5; }\n"
    ".paper { fill: #4c86d6; stroke: #4c86d6; }\n"
    "</style>\n";

}  // namespace

std::string benchPlot(const BenchFigures& figures) {
  const std::string machine =
      figures.processor + ", " + figures.instructionSet + ", " + std::to_string(figures.threads) +
      " threads, profile " + figures.profile + ", rig " + figures.rig +
      "; exhaustive searches scaled from " + std::to_string(figures.subsample) + " pixels";
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + number(kWidth) + "\" height=\"" +
         number(kHeight) + "\" viewBox=\"0 0 " + number(kWidth) + " " + number(kHeight) + "\">\n" +
         "<title>Run time against error</title>\n" + kStyle + axes() + boundLine(figures) +
         points(figures) + key() + words(kLeft, kHeight - 8.0, "start", escaped(machine)) +
         "</svg>\n";
}

Status writeBenchPlot(const std::filesystem::path& path, const BenchFigures& figures) {
  return writeTextAtomically(path, benchPlot(figures));
}

}  // namespace cutis
