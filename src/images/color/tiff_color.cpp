#include "src/images/color/tiff_color.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/word_list.h"
#include "core/spectra/rgb_primaries.h"
#include "src/images/inputs/tiff_directory.h"

namespace cutis {
namespace {

constexpr int kTransferFunction = 301;
constexpr int kWhitePoint = 318;
constexpr int kPrimaryChromaticities = 319;

using Numbers = std::vector<std::uint64_t>;
using Curves = std::array<TransferCurve, 3>;

// x and y of so many colours, each a number and what it is divided by.
template <std::size_t count>
std::optional<std::array<double, count>> chromaticitiesIn(const std::optional<Numbers>& numbers) {
  if (!numbers || numbers->size() != 2 * count) return std::nullopt;
  std::array<double, count> values = {};
  for (std::size_t i = 0; i < count; ++i)
    values[i] = static_cast<double>((*numbers)[2 * i]) / static_cast<double>((*numbers)[2 * i + 1]);
  return values;
}

// One table for all channels, or one for each, with as many entries as a sample has values.
std::optional<Curves> curvesIn(const Numbers& numbers) {
  const auto isTable = [](std::size_t size) { return size >= 2 && std::has_single_bit(size); };
  const std::size_t tables = isTable(numbers.size()) ? 1 : 3;
  const std::size_t size = numbers.size() / tables;
  if (!isTable(size) || size * tables != numbers.size()) return std::nullopt;
  Curves curves;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const std::size_t first = tables == 1 ? 0 : c * size;
    std::vector<double> light;
    for (std::size_t i = 0; i < size; ++i)
      light.push_back(static_cast<double>(numbers[first + i]) / 65535.0);
    curves[c] = TransferCurve::sampled(std::move(light));
    if (!curves[c].isRising()) return std::nullopt;
  }
  return curves;
}

// "its TIFF tags PrimaryChromaticities and WhitePoint"
std::string originOf(const std::vector<const char*>& tags) {
  return std::string(tags.size() > 1 ? "its TIFF tags " : "its TIFF tag ") +
         wordList(tags, " and ");
}

}  // namespace

ColorStatement tiffTagStatement(const std::filesystem::path& path, const TransferCurve& usual) {
  TiffDirectory file(path);
  const auto table = file.values(kTransferFunction);
  const auto primaries = chromaticitiesIn<6>(file.values(kPrimaryChromaticities));
  const auto white = chromaticitiesIn<2>(file.values(kWhitePoint));
  ColorStatement statement = {ColorSource::tiffTags, {}, {}, {}};
  if (!table && !primaries) return statement;

  std::vector<const char*> tags, assumed;
  (primaries ? tags : assumed)
      .push_back(primaries ? "PrimaryChromaticities" : "the primaries of Rec.709");
  (white ? tags : assumed).push_back(white ? "WhitePoint" : "a white of D65");
  (table ? tags : assumed)
      .push_back(table              ? "TransferFunction"
                 : usual.isLinear() ? "linear numbers"
                                    : "the curve of sRGB");
  statement.origin = originOf(tags);
  const auto curves = table ? curvesIn(*table) : std::optional(Curves{usual, usual, usual});
  if (!curves) {
    statement.objection = "says a transfer function that does not rise from black to white";
    return statement;
  }
  std::array<double, 8> chromaticities = kRec709.chromaticities;
  if (primaries) std::copy(primaries->begin(), primaries->end(), chromaticities.begin());
  if (white) std::copy(white->begin(), white->end(), chromaticities.begin() + 6);
  auto space = spaceOfPrimaries(chromaticities, *curves, path.string());
  if (!space) {
    statement.objection = "says primaries that span no colours";
    return statement;
  }
  statement.space = std::move(space).value();
  if (!assumed.empty())
    statement.assumption =
        wordList(assumed, " and ") + (assumed.size() > 1 ? " are" : " is") + " assumed";
  return statement;
}

}  // namespace cutis
