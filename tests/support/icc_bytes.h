#pragma once

// ICC profiles byte by byte, after ICC.1:2001-04 (version 2) and ICC.1:2022 (version 4), without
// any library.

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "core/spectra/colorimetry.h"
#include "core/spectra/rgb_primaries.h"

namespace cutis::test {

inline void putBytes(std::string& out, std::uint64_t value, int bytes) {
  for (int shift = 8 * (bytes - 1); shift >= 0; shift -= 8)
    out += static_cast<char>(value >> shift & 0xff);
}

inline void putFixed(std::string& out, double value) {
  putBytes(out, static_cast<std::uint32_t>(std::lround(value * 65536.0)), 4);
}

inline std::string xyzTag(const Eigen::Vector3d& xyz) {
  std::string tag("XYZ \0\0\0\0", 8);
  for (const double value : xyz)
    putFixed(tag, value);
  return tag;
}

// curv with no entry (linear), one (an exponent, in 256ths) or many.
inline std::string curveTag(const std::vector<std::uint16_t>& entries) {
  std::string tag("curv\0\0\0\0", 8);
  putBytes(tag, entries.size(), 4);
  for (const std::uint16_t entry : entries)
    putBytes(tag, entry, 2);
  return tag;
}

inline std::string sampledTag(int count, const std::function<double(double)>& curve) {
  std::vector<std::uint16_t> entries;
  for (int i = 0; i < count; ++i)
    entries.push_back(static_cast<std::uint16_t>(std::lround(curve(i / (count - 1.0)) * 65535.0)));
  return curveTag(entries);
}

inline std::string parametricTag(int type, const std::vector<double>& parameters) {
  std::string tag("para\0\0\0\0", 8);
  putBytes(tag, static_cast<std::uint64_t>(type), 2);
  putBytes(tag, 0, 2);
  for (const double value : parameters)
    putFixed(tag, value);
  return tag;
}

// textDescriptionType of version 2, multiLocalizedUnicodeType of version 4.
inline std::string nameTag(int version, const std::string& text) {
  if (version < 4) {
    std::string tag("desc\0\0\0\0", 8);
    putBytes(tag, text.size() + 1, 4);
    return tag + text + std::string(1 + 8 + 3 + 67, '\0');
  }
  std::string tag("mluc\0\0\0\0\0\0\0\1\0\0\0\14enUS", 20);
  putBytes(tag, 2 * text.size(), 4);
  putBytes(tag, 28, 4);
  for (const char c : text)
    putBytes(tag, static_cast<unsigned char>(c), 2);
  return tag;
}

using IccTags = std::vector<std::pair<std::string, std::string>>;

inline std::string iccBytes(int version, const std::string& device, const std::string& connection,
                            const IccTags& tags) {
  std::string table, contents;
  putBytes(table, tags.size(), 4);
  const std::size_t start = 132 + 12 * tags.size();
  for (const auto& [signature, content] : tags) {
    table += signature;
    putBytes(table, start + contents.size(), 4);
    putBytes(table, content.size(), 4);
    contents += content;
    contents.resize((contents.size() + 3) / 4 * 4, '\0');
  }
  std::string head;
  putBytes(head, start + contents.size(), 4);
  head += "none";
  putBytes(head, version == 4 ? 0x04200000 : 0x02400000, 4);
  head += (device == "CMYK" ? "prtr" : "mntr") + device + connection;
  head += std::string("\x07\xe8\0\1\0\1\0\0\0\0\0\0", 12) + "acsp";
  head.resize(68, '\0');
  for (const double value : {0.9642, 1.0, 0.8249})
    putFixed(head, value);
  head.resize(128, '\0');
  return head + table + contents;
}

inline Eigen::Vector3d iccD50() {
  return {0.9642, 1.0, 0.8249};
}

// A profile of primaries and a curve tag, adapted to D50 (Bradford).
inline std::string matrixProfile(int version, const std::array<double, 8>& chromaticities,
                                 const std::string& curve, const std::string& name) {
  const RgbPrimaries primaries = {"", chromaticities};
  const Eigen::Matrix3d colorants =
      adaptationMatrix(ChromaticAdaptation::bradford, primaries.xyzOfWhite(), iccD50()) *
      xyzFromRgb(primaries);
  return iccBytes(
      version, "RGB ", "XYZ ",
      {{"desc", nameTag(version, name)},
       {"cprt", version == 4 ? nameTag(4, "none") : std::string("text\0\0\0\0none\0", 13)},
       {"wtpt", xyzTag(iccD50())},
       {"rXYZ", xyzTag(colorants.col(0))},
       {"gXYZ", xyzTag(colorants.col(1))},
       {"bXYZ", xyzTag(colorants.col(2))},
       {"rTRC", curve},
       {"gTRC", curve},
       {"bTRC", curve}});
}

inline std::string greyProfile(int version, const std::string& curve, const std::string& name) {
  return iccBytes(version, "GRAY", "XYZ ",
                  {{"desc", nameTag(version, name)},
                   {"cprt", nameTag(version, "none")},
                   {"wtpt", xyzTag(iccD50())},
                   {"kTRC", curve}});
}

// A table from `channels` numbers to XYZ under D50 (lut16Type): the input curve, then a grid with
// two points a channel, first channel slowest.
inline std::string tableProfile(int channels,
                                const std::function<Eigen::Vector3d(std::array<double, 4>)>& xyz,
                                const std::function<double(double)>& curve,
                                const std::string& name) {
  constexpr int kEntries = 1024;
  std::string table("mft2\0\0\0\0", 8);
  putBytes(table, static_cast<std::uint64_t>(channels), 1);
  putBytes(table, 3, 1);
  putBytes(table, 2, 1);
  putBytes(table, 0, 1);
  for (int i = 0; i < 9; ++i)
    putFixed(table, i % 4 == 0 ? 1.0 : 0.0);
  putBytes(table, kEntries, 2);
  putBytes(table, 2, 2);
  for (int c = 0; c < channels; ++c) {
    for (int i = 0; i < kEntries; ++i)
      putBytes(table,
               static_cast<std::uint64_t>(std::lround(curve(i / (kEntries - 1.0)) * 65535.0)), 2);
  }
  for (int corner = 0; corner < 1 << channels; ++corner) {
    std::array<double, 4> numbers = {};
    for (int c = 0; c < channels; ++c)
      numbers[static_cast<std::size_t>(c)] = corner >> (channels - 1 - c) & 1;
    for (const double value : xyz(numbers))
      putBytes(table, static_cast<std::uint64_t>(std::lround(value * 32768.0)), 2);
  }
  for (int c = 0; c < 3; ++c) {
    putBytes(table, 0, 2);
    putBytes(table, 65535, 2);
  }
  return iccBytes(2, channels == 4 ? "CMYK" : "RGB ", "XYZ ",
                  {{"desc", nameTag(2, name)},
                   {"cprt", std::string("text\0\0\0\0none\0", 13)},
                   {"wtpt", xyzTag(iccD50())},
                   {"A2B0", table}});
}

}  // namespace cutis::test
