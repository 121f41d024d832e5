#include "src/images/inputs/radiance_header.h"

#include <cmath>
#include <fstream>
#include <sstream>
#include <string_view>

namespace cutis {
namespace {

constexpr int kMostLines = 200;
constexpr std::size_t kLongestLine = 4096;

std::optional<std::array<double, 8>> primariesIn(const std::string& text) {
  std::istringstream numbers(text);
  numbers.imbue(std::locale::classic());
  std::array<double, 8> values = {};
  for (double& value : values) {
    if (!(numbers >> value)) return std::nullopt;
  }
  return values;
}

// 1 for what is no positive number.
double exposureIn(const std::string& text) {
  std::istringstream number(text);
  number.imbue(std::locale::classic());
  double value = 0.0;
  return (number >> value) && std::isfinite(value) && value > 0.0 ? value : 1.0;
}

}  // namespace

RadianceHeader readRadianceHeader(const std::filesystem::path& path) {
  RadianceHeader header;
  std::ifstream file(path, std::ios::binary);
  std::string line;
  for (int i = 0; i < kMostLines && std::getline(file, line) && !line.empty(); ++i) {
    if (line.size() > kLongestLine) break;
    const std::size_t equals = line.find('=');
    if (equals == std::string::npos) continue;
    const std::string_view name = std::string_view(line).substr(0, equals);
    const std::string value = line.substr(equals + 1);
    if (name == "EXPOSURE") header.exposure *= exposureIn(value);
    if (name == "PRIMARIES") header.primaries = primariesIn(value);
    if (name == "FORMAT") header.format = value.substr(0, value.find_last_not_of(" \r\t") + 1);
  }
  return header;
}

}  // namespace cutis
