#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include <Eigen/LU>

#include "core/spectra/colorimetry.h"
#include "core/spectra/rgb_primaries.h"
#include "src/color/icc_header.h"
#include "src/color/icc_profile.h"

namespace cutis {
namespace {

void putInteger(std::string& out, std::uint64_t value, int bytes) {
  for (int shift = 8 * (bytes - 1); shift >= 0; shift -= 8)
    out += static_cast<char>(value >> shift & 0xff);
}

// s15Fixed16Number
void putFixed(std::string& out, double value) {
  putInteger(out, static_cast<std::uint32_t>(std::lround(value * 65536.0)), 4);
}

std::string xyzTag(const Eigen::Vector3d& xyz) {
  std::string tag("XYZ \0\0\0\0", 8);
  for (const double value : xyz)
    putFixed(tag, value);
  return tag;
}

// multiLocalizedUnicodeType of one English text.
std::string textTag(const std::string& text) {
  std::string tag("mluc\0\0\0\0\0\0\0\1\0\0\0\14enUS", 20);
  putInteger(tag, 2 * text.size(), 4);
  putInteger(tag, 28, 4);
  for (const char c : text)
    putInteger(tag, static_cast<unsigned char>(c), 2);
  return tag;
}

// Precondition: the curve has parameters or samples.
std::string curveTag(const TransferCurve& curve) {
  if (const auto p = curve.parameters()) {
    std::string tag("para\0\0\0\0\0\4\0\0", 12);
    for (const double value : {p->g, p->a, p->b, p->c, p->d, p->e, p->f})
      putFixed(tag, value);
    return tag;
  }
  std::string tag("curv\0\0\0\0", 8);
  putInteger(tag, curve.samples().size(), 4);
  for (const double value : curve.samples()) {
    putInteger(tag, static_cast<std::uint64_t>(std::lround(std::clamp(value, 0.0, 1.0) * 65535.0)),
               2);
  }
  return tag;
}

std::string adaptationTag(const Eigen::Matrix3d& matrix) {
  std::string tag("sf32\0\0\0\0", 8);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column)
      putFixed(tag, matrix(row, column));
  }
  return tag;
}

// ICC.1:2022, §7.2; the date is fixed so that the bytes are.
std::string header(std::size_t size) {
  std::string out;
  putInteger(out, size, 4);
  out += std::string(4, '\0');
  putInteger(out, 0x04300000, 4);
  out += "mntrRGB XYZ ";
  for (const int part : {2020, 1, 1, 0, 0, 0})
    putInteger(out, static_cast<std::uint64_t>(part), 2);
  out += "acsp";
  out.resize(68, '\0');
  for (const double value : {0.9642, 1.0, 0.8249})
    putFixed(out, value);
  out.resize(kIccHeaderBytes, '\0');
  return out;
}

using Tag = std::pair<std::string, std::string>;  // signature, content

std::string profileOf(const std::vector<Tag>& tags) {
  std::string table, contents;
  putInteger(table, tags.size(), 4);
  const std::size_t start = kIccHeaderBytes + 4 + 12 * tags.size();
  std::vector<std::size_t> offsets;
  for (std::size_t i = 0; i < tags.size(); ++i) {
    const auto same = std::find_if(tags.begin(), tags.begin() + static_cast<std::ptrdiff_t>(i),
                                   [&](const Tag& tag) { return tag.second == tags[i].second; });
    const auto earlier = static_cast<std::size_t>(same - tags.begin());
    offsets.push_back(earlier < i ? offsets[earlier] : start + contents.size());
    if (earlier == i) {
      contents += tags[i].second;
      contents.resize((contents.size() + 3) / 4 * 4, '\0');
    }
    table += tags[i].first;
    putInteger(table, offsets.back(), 4);
    putInteger(table, tags[i].second.size(), 4);
  }
  return header(start + contents.size()) + table + contents;
}

}  // namespace

std::string iccProfileOf(const ColorSpace& space) {
  if (!space.matrix) return {};
  for (const TransferCurve& curve : space.matrix->curves) {
    if (!curve.parameters() && curve.samples().empty()) return {};
  }
  const Eigen::Vector3d d65 = kRec709.xyzOfWhite(), d50(0.9642, 1.0, 0.8249);
  const Eigen::Matrix3d toD50 = adaptationMatrix(ChromaticAdaptation::bradford, d65, d50);
  const Eigen::Matrix3d colorants = toD50 * xyzFromRgb(kRec709) * space.matrix->toRec709;
  // s15Fixed16Number reaches to 32768, of which colorants and curves need little.
  if (!(colorants.cwiseAbs().maxCoeff() < 1000.0)) return {};
  std::string plain = space.name;
  std::erase_if(plain, [](unsigned char c) { return c < 0x20 || c > 0x7e; });
  return profileOf({{"desc", textTag(plain)},
                    {"cprt", textTag("No copyright, use freely")},
                    {"wtpt", xyzTag(d50)},
                    {"chad", adaptationTag(toD50)},
                    {"rXYZ", xyzTag(colorants.col(0))},
                    {"gXYZ", xyzTag(colorants.col(1))},
                    {"bXYZ", xyzTag(colorants.col(2))},
                    {"rTRC", curveTag(space.matrix->curves[0])},
                    {"gTRC", curveTag(space.matrix->curves[1])},
                    {"bTRC", curveTag(space.matrix->curves[2])}});
}

}  // namespace cutis
