// Pixels that are stored in other colours than red, green and blue: CIELab, luminance and chroma,
// and inks. Files are made byte by byte.

#include "src/images/codec/stored_colors.h"

#include <QtTest>

#include "src/images/image_file.h"
#include "tests/src/images/image_fixture.h"
#include "tests/support/expect.h"
#include "tests/support/icc_bytes.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

using test::ImageFolder;

class StoredColorsTest : public QObject {
  Q_OBJECT

  ImageFolder folder_;

  static Result<ColorDecision> decide(const std::filesystem::path& path,
                                      const std::string& choice = {}) {
    CUTIS_TRY(header, readImageHeader(path, {}));
    return decideColors(header.colors, choice, path.string());
  }

  void expectLab(int photometric, int bits, const std::array<double, 3>& lab,
                 const Eigen::Vector3d& linear, double tolerance) {
    const auto path = folder_.path("lab.tif");
    std::vector<std::uint32_t> samples;
    for (int i = 0; i < 4; ++i) {
      for (const double value : lab)
        samples.push_back(static_cast<std::uint32_t>(std::lround(value)) & ((1u << bits) - 1));
    }
    writeTiff(path, photometric, bits, 3, samples, {});
    const auto image = readImage(path, {PixelFormat::float32}, nullptr, {});
    EXPECT_OK(image);
    QCOMPARE(image.value().channelNames, (std::vector<std::string>{"R", "G", "B"}));
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(test::pixelOf(image.value().channels[c], 1, 1),
                  linear[static_cast<Eigen::Index>(c)], tolerance);
    }
    const auto decided = decideColors(image.value().colors, {}, "lab.tif");
    EXPECT_OK(decided);
    QCOMPARE(decided.value().sentence,
             std::string("its colours are converted from its storage as CIELab"));
    EXPECT_ERROR(decideColors(image.value().colors, "sRGB", "lab.tif"), "leave the choice out");
  }

  // Little endian, 2 × 2, one strip.
  static void writeTiff(const std::filesystem::path& path, int photometric, int bits, int channels,
                        const std::vector<std::uint32_t>& samples, const std::string& profile) {
    const auto little = [](std::uint64_t value, int bytes) {
      std::string out;
      for (int i = 0; i < bytes; ++i)
        out += static_cast<char>(value >> (8 * i) & 0xff);
      return out;
    };
    struct Entry {
      int tag, type;
      std::size_t count;
      std::string value;
    };
    std::string pixels;
    for (const std::uint32_t sample : samples)
      pixels += little(sample, bits / 8);
    std::string depths;
    for (int c = 0; c < channels; ++c)
      depths += little(static_cast<std::uint64_t>(bits), 2);
    std::vector<Entry> entries = {{256, 4, 1, little(2, 4)},
                                  {257, 4, 1, little(2, 4)},
                                  {258, 3, static_cast<std::size_t>(channels), depths},
                                  {259, 3, 1, little(1, 4)},
                                  {262, 3, 1, little(static_cast<std::uint64_t>(photometric), 4)},
                                  {273, 4, 1, {}},
                                  {277, 3, 1, little(static_cast<std::uint64_t>(channels), 4)},
                                  {278, 4, 1, little(2, 4)},
                                  {279, 4, 1, little(pixels.size(), 4)}};
    if (!profile.empty()) entries.push_back({34675, 7, profile.size(), profile});
    std::size_t at = 8 + 2 + 12 * entries.size() + 4;
    std::string heap, directory = little(entries.size(), 2);
    std::size_t heapBytes = 0;
    for (const Entry& entry : entries)
      heapBytes += entry.value.size() > 4 ? (entry.value.size() + 1) / 2 * 2 : 0;
    for (Entry& entry : entries) {
      if (entry.tag == 273) entry.value = little(at + heapBytes, 4);
      directory += little(static_cast<std::uint64_t>(entry.tag), 2) +
                   little(static_cast<std::uint64_t>(entry.type), 2) + little(entry.count, 4);
      if (entry.value.size() <= 4) {
        directory += (entry.value + std::string(4, '\0')).substr(0, 4);
        continue;
      }
      directory += little(at + heap.size(), 4);
      heap += entry.value + std::string(entry.value.size() % 2, '\0');
    }
    const std::string bytes =
        std::string("II*\0", 4) + little(8, 4) + directory + little(0, 4) + heap + pixels;
    test::writeBytes(path, QByteArray::fromStdString(bytes));
  }

 private slots:
  // L*, a* and b* by the equations, 8 and 16 bits, both ways of storing them.
  void cieLabIsConverted() {
    // The values of sRGB (200, 150, 120) and of white, CIE 15:2018 under D50.
    const Eigen::Matrix3d toD50 =
        adaptationMatrix(ChromaticAdaptation::bradford, kRec709.xyzOfWhite(), test::iccD50()) *
        xyzFromRgb(kRec709);
    for (const Eigen::Vector3d& linear :
         {Eigen::Vector3d(0.58, 0.305, 0.188), Eigen::Vector3d(0.2, 0.35, 0.5),
          Eigen::Vector3d(0.03, 0.02, 0.015)}) {
      const Eigen::Vector3d xyz = (toD50 * linear).cwiseQuotient(test::iccD50());
      const auto f = [](double t) {
        return t > 216.0 / 24389.0 ? std::cbrt(t) : t * 841.0 / 108.0 + 4.0 / 29.0;
      };
      const double l = 116 * f(xyz[1]) - 16, a = 500 * (f(xyz[0]) - f(xyz[1])),
                   b = 200 * (f(xyz[1]) - f(xyz[2]));
      expectLab(8, 16, {l * 655.35, a * 256, b * 256}, linear, 1e-3);
      expectLab(8, 8, {l * 2.55, a, b}, linear, 0.02);
      expectLab(9, 16, {l * 652.8, (a + 128) * 256, (b + 128) * 256}, linear, 1e-3);
      expectLab(9, 8, {l * 2.55, a + 128, b + 128}, linear, 0.02);
    }
  }

  // Y, RY and BY, chroma with half the samples, uncompressed halves, as OpenEXR's RgbaFile lays
  // them out. One colour, so that any reconstruction gives it back.
  void luminanceAndChromaAreConverted() {
    constexpr int kSide = 8;
    const auto little = [](std::uint64_t value, int bytes) {
      std::string out;
      for (int i = 0; i < bytes; ++i)
        out += static_cast<char>(value >> (8 * i) & 0xff);
      return out;
    };
    const auto attribute = [&](const std::string& name, const std::string& type,
                               const std::string& value) {
      return name + '\0' + type + '\0' + little(value.size(), 4) + value;
    };
    std::string channels;
    for (const auto& [name, step] : {std::pair{"BY", 2}, {"RY", 2}, {"Y", 1}}) {
      channels += name + std::string(1, '\0') + little(1, 4) + little(0, 4) +
                  little(static_cast<std::uint64_t>(step), 4) +
                  little(static_cast<std::uint64_t>(step), 4);
    }
    const std::string window =
        little(0, 4) + little(0, 4) + little(kSide - 1, 4) + little(kSide - 1, 4);
    const std::string head =
        little(20000630, 4) + little(2, 4) + attribute("channels", "chlist", channels + '\0') +
        attribute("compression", "compression", std::string(1, '\0')) +
        attribute("dataWindow", "box2i", window) + attribute("displayWindow", "box2i", window) +
        attribute("lineOrder", "lineOrder", std::string(1, '\0')) +
        attribute("pixelAspectRatio", "float", little(0x3f800000, 4)) +
        attribute("screenWindowCenter", "v2f", little(0, 8)) +
        attribute("screenWindowWidth", "float", little(0x3f800000, 4)) + '\0';
    // Y = 0.5, (R − Y) / Y = 0.5, (B − Y) / Y = −0.5.
    std::string table, lines;
    for (int y = 0; y < kSide; ++y) {
      std::string row;
      for (int x = 0; y % 2 == 0 && x < kSide / 2; ++x)
        row += little(0xb800, 2);
      for (int x = 0; y % 2 == 0 && x < kSide / 2; ++x)
        row += little(0x3800, 2);
      for (int x = 0; x < kSide; ++x)
        row += little(0x3800, 2);
      table += little(head.size() + 8 * kSide + lines.size(), 8);
      lines += little(static_cast<std::uint64_t>(y), 4) + little(row.size(), 4) + row;
    }
    const auto path = folder_.path("yc.exr");
    test::writeBytes(path, QByteArray::fromStdString(head + table + lines));
    const auto image = readImage(path, {PixelFormat::float32}, nullptr, {});
    EXPECT_OK(image);
    QCOMPARE(image.value().channelNames, (std::vector<std::string>{"R", "G", "B"}));
    const double green = (0.5 - 0.2126 * 0.75 - 0.0722 * 0.25) / 0.7152;
    EXPECT_NEAR(test::pixelOf(image.value().channels[0], 3, 4), 0.75, 2e-3);
    EXPECT_NEAR(test::pixelOf(image.value().channels[1], 3, 4), green, 2e-3);
    EXPECT_NEAR(test::pixelOf(image.value().channels[2], 3, 4), 0.25, 2e-3);
    test::writeBytes(path, QByteArray::fromStdString((head + table + lines).substr(0, 500)));
    QVERIFY(readImage(path, {PixelFormat::float32}, nullptr, {}).failed());
  }

  void inksNeedTheirProfile() {
    const std::vector<std::uint32_t> samples = {0, 0,   0, 0, 255, 0, 0, 0,
                                                0, 255, 0, 0, 0,   0, 0, 255};
    const auto path = folder_.path("ink.tif");
    writeTiff(path, 5, 8, 4, samples, {});
    EXPECT_ERROR(decide(path),
                 "CMYK without an ICC profile, which does not say what its inks look");
    EXPECT_ERROR(decide(path, "sRGB"), "CMYK without an ICC profile");
    const std::string profile = test::tableProfile(
        4,
        [](std::array<double, 4> ink) -> Eigen::Vector3d {
          return test::iccD50() * ((1 - 0.7 * ink[0]) * (1 - 0.5 * ink[1]) * (1 - 0.9 * ink[3]));
        },
        [](double v) { return v; }, "press");
    writeTiff(path, 5, 8, 4, samples, profile);
    const auto image = readImage(path, {PixelFormat::float32}, nullptr, {});
    EXPECT_OK(image);
    QCOMPARE(image.value().channelNames, (std::vector<std::string>{"R", "G", "B"}));
    for (const Plane& plane : image.value().channels) {
      EXPECT_NEAR(test::pixelOf(plane, 0, 0), 1.0, 1e-3);
      EXPECT_NEAR(test::pixelOf(plane, 1, 0), 0.3, 1e-3);
      EXPECT_NEAR(test::pixelOf(plane, 0, 1), 0.5, 1e-3);
      EXPECT_NEAR(test::pixelOf(plane, 1, 1), 0.1, 1e-3);
    }
    QCOMPARE(decide(path).value().sentence,
             std::string("its colours are converted from its storage as CMYK with the ICC profile "
                         "'press'"));
  }
};

CUTIS_TEST(StoredColorsTest)

}  // namespace
}  // namespace cutis

#include "stored_colors_test.moc"
