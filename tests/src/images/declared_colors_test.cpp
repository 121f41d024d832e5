// What files say of their colours: every statement, their order, their contradictions, and what is
// written of them. Files are made byte by byte or by OpenImageIO itself.

#include <zlib.h>

#include <QtTest>

#include "src/color/icc_profile.h"
#include "src/images/capture/albedo_file.h"
#include "src/images/image_file.h"
#include "tests/src/images/image_fixture.h"
#include "tests/support/expect.h"
#include "tests/support/icc_bytes.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

using test::ImageFolder;

std::string number(std::uint32_t value) {
  std::string bytes;
  test::putBytes(bytes, value, 4);
  return bytes;
}

std::string pngChunk(const std::string& name, const std::string& content) {
  const std::string body = name + content;
  const uLong crc =
      crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size()));
  return number(static_cast<std::uint32_t>(content.size())) + body +
         number(static_cast<std::uint32_t>(crc));
}

std::string zipped(const std::string& bytes) {
  std::string out(compressBound(static_cast<uLong>(bytes.size())), '\0');
  auto size = static_cast<uLongf>(out.size());
  compress(reinterpret_cast<Bytef*>(out.data()), &size,
           reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uLong>(bytes.size()));
  out.resize(size);
  return out;
}

std::string cicp(int primaries, int transfer, int matrix = 0, int range = 1) {
  return pngChunk("cICP", {char(primaries), char(transfer), char(matrix), char(range)});
}
std::string iccp(const std::string& profile) {
  return pngChunk("iCCP", std::string("x\0\0", 3) + zipped(profile));
}
std::string srgbChunk() {
  return pngChunk("sRGB", std::string(1, '\0'));
}
std::string gamma(double value) {
  return pngChunk("gAMA", number(static_cast<std::uint32_t>(std::lround(value * 1e5))));
}
// Red, green, blue, white; stored white first.
std::string chrm(const std::array<double, 8>& c) {
  std::string content;
  for (const std::size_t i : {6u, 7u, 0u, 1u, 2u, 3u, 4u, 5u})
    content += number(static_cast<std::uint32_t>(std::lround(c[i] * 1e5)));
  return pngChunk("cHRM", content);
}

// An EXIF block, little endian: IFD0 → EXIF (ColorSpace) → interoperability (index).
std::string exifBlock(int colorSpace, const std::string& index) {
  const auto little = [](std::uint32_t value, int bytes) {
    std::string out;
    for (int i = 0; i < bytes; ++i)
      out += static_cast<char>(value >> (8 * i) & 0xff);
    return out;
  };
  const auto entry = [&](std::uint32_t tag, std::uint32_t type, std::uint32_t count,
                         const std::string& value) {
    return little(tag, 2) + little(type, 2) + little(count, 4) + value;
  };
  std::string block("II*\0", 4);
  block += little(8, 4);
  block += little(1, 2) + entry(0x8769, 4, 1, little(26, 4)) + little(0, 4);
  block += little(2, 2) + entry(0xa001, 3, 1, little(static_cast<std::uint32_t>(colorSpace), 4)) +
           entry(0xa005, 4, 1, little(56, 4)) + little(0, 4);
  block +=
      little(1, 2) + entry(1, 2, 4, (index + std::string(4, '\0')).substr(0, 4)) + little(0, 4);
  return block;
}

std::string profileOf(const RgbPrimaries& primaries, const std::string& curve,
                      const std::string& name) {
  return test::matrixProfile(4, primaries.chromaticities, curve, name);
}

class DeclaredColorsTest : public QObject {
  Q_OBJECT

  ImageFolder folder_;

  // 8-bit PNG of one grey-brown colour with these chunks.
  std::filesystem::path png(const std::string& chunks, int colorType = 2) {
    const auto path = folder_.path("a.png");
    const int channels = colorType == 2 ? 3 : 1;
    std::string rows;
    for (int y = 0; y < 4; ++y) {
      rows += '\0';
      for (int x = 0; x < 4; ++x)
        rows += std::string("\xc8\x96\x78").substr(0, static_cast<std::size_t>(channels));
    }
    const std::string head =
        number(4) + number(4) + std::string("\x08", 1) + char(colorType) + std::string(3, '\0');
    const std::string bytes = std::string("\x89PNG\r\n\x1a\n", 8) + pngChunk("IHDR", head) +
                              chunks + pngChunk("IDAT", zipped(rows)) + pngChunk("IEND", "");
    test::writeBytes(path, QByteArray::fromStdString(bytes));
    return path;
  }

  std::filesystem::path jpeg(const std::string& exif, const std::string& profile) {
    const auto path = folder_.path("a.jpg");
    OIIO::ImageSpec spec(16, 16, 3, OIIO::TypeUInt8);
    if (!profile.empty()) {
      spec.attribute("ICCProfile",
                     OIIO::TypeDesc(OIIO::TypeDesc::UINT8, static_cast<int>(profile.size())),
                     profile.data());
    }
    test::writeForeign(path, "jpeg", spec, std::vector<float>(16 * 16 * 3, 0.5f));
    if (exif.empty()) return path;
    const std::string content = std::string("Exif\0\0", 6) + exif;
    std::string segment("\xff\xe1", 2);
    test::putBytes(segment, content.size() + 2, 2);
    QByteArray bytes = test::readBytes(path);
    bytes.insert(2, QByteArray::fromStdString(segment + content));
    test::writeBytes(path, bytes);
    return path;
  }

  std::filesystem::path exr(const std::function<void(OIIO::ImageSpec&)>& say) {
    const auto path = folder_.path("a.exr");
    OIIO::ImageSpec spec(4, 4, 3, OIIO::TypeHalf);
    say(spec);
    test::writeForeign(path, "openexr", spec, std::vector<float>(48, 0.5f));
    return path;
  }

  static Result<ColorDecision> decide(const std::filesystem::path& path,
                                      const std::string& choice = {}) {
    CUTIS_TRY(header, readImageHeader(path, {}));
    return decideColors(header.colors, choice, path.string());
  }

  // The name of what is followed, and the number of contradictions if there are any.
  static std::string outcome(const std::filesystem::path& path, const std::string& choice = {}) {
    const auto decided = decide(path, choice);
    if (!decided) return decided.error().message;
    const auto against = decided.value().contradictions.size();
    return decided.value().followed.space.name +
           (against == 0 ? "" : ", against " + std::to_string(against));
  }

 private slots:
  void init() { qunsetenv("OCIO"); }

  void pngStatements_data() {
    QTest::addColumn<QByteArray>("chunks");
    QTest::addColumn<QString>("found");
    const auto row = [](const char* name, const std::string& chunks, const char* found) {
      QTest::newRow(name) << QByteArray::fromStdString(chunks) << found;
    };
    const std::string linear = test::curveTag({});
    const std::string p3 = profileOf(kP3D65, linear, "sRGB");
    const std::string rec709 = profileOf(kRec709, linear, "any");
    row("nothing", "", "sRGB");
    row("cICP sRGB", cicp(1, 13), "sRGB");
    row("cICP Display P3", cicp(12, 13), "Display P3");
    row("cICP linear Rec.2020", cicp(9, 8), "Linear Rec.2020");
    row("cICP linear P3", cicp(12, 8), "Linear P3-D65");
    row("cICP PQ", cicp(9, 16),
        "its cICP chunk says PQ, which is the light of a display; name the colour space of the "
        "file, for example sRGB");
    row("cICP HLG", cicp(9, 18),
        "its cICP chunk says HLG, which is the light of a display; name the colour space of the "
        "file, for example sRGB");
    row("cICP YCbCr", cicp(1, 13, 1),
        "its cICP chunk says luminance and chroma, which PNG files cannot hold; name the colour "
        "space of the file, for example sRGB");
    row("cICP narrow", cicp(1, 13, 0, 0),
        "its cICP chunk says the narrow range of video, which is not supported; name the colour "
        "space of the file, for example sRGB");
    row("cICP unspecified", cicp(2, 2), "sRGB");
    row("cICP too short", pngChunk("cICP", "ab"), "sRGB");
    row("iCCP", iccp(p3), "Linear P3-D65");
    row("sRGB", srgbChunk(), "sRGB");
    row("gAMA 1", gamma(1.0), "Linear Rec.709");
    row("gAMA 2.2", gamma(1 / 2.2), "Gamma 2.2 Rec.709");
    row("gAMA and cHRM", gamma(256.0 / 563.0) + chrm(kAdobeRgb.chromaticities), "Adobe RGB (1998)");
    row("cHRM alone", chrm(kP3D65.chromaticities), "Display P3");
    row("gAMA 0", gamma(0.0), "sRGB");
    row("cHRM of nothing", gamma(1.0) + pngChunk("cHRM", std::string(32, '\0')),
        "its gAMA chunk with cHRM says primaries that span no colours; name the colour space of "
        "the file, for example sRGB");
    row("order: cICP", cicp(12, 13) + iccp(rec709) + gamma(1.0), "Display P3, against 2");
    row("order: iCCP", iccp(p3) + gamma(1.0), "Linear P3-D65, against 1");
    row("order: sRGB", gamma(1.0) + srgbChunk(), "sRGB, against 1");
    row("libpng's usual trio", srgbChunk() + gamma(0.45455) + chrm(kRec709.chromaticities), "sRGB");
    row("order of chunks does not matter", gamma(1.0) + iccp(p3) + cicp(12, 8),
        "Linear P3-D65, against 1");
    row("eXIf Adobe", pngChunk("eXIf", exifBlock(65535, "R03")), "Adobe RGB (1998)");
    row("eXIf against sRGB", srgbChunk() + pngChunk("eXIf", exifBlock(65535, "R03")),
        "sRGB, against 1");
    row("unspecified cICP leaves room", cicp(2, 2) + gamma(1.0), "Linear Rec.709");
  }
  void pngStatements() {
    QFETCH(QByteArray, chunks);
    QFETCH(QString, found);
    QCOMPARE(QString::fromStdString(outcome(png(chunks.toStdString()))), found);
  }

  void exifStatements() {
    QCOMPARE(outcome(jpeg("", "")), std::string("sRGB"));
    QVERIFY(readImageHeader(jpeg("", ""), {}).value().colors.statements.empty());
    QCOMPARE(outcome(jpeg(exifBlock(1, "R98"), "")), std::string("sRGB"));
    QCOMPARE(outcome(jpeg(exifBlock(65535, "R03"), "")), std::string("Adobe RGB (1998)"));
    QCOMPARE(outcome(jpeg(exifBlock(65535, "R98"), "")), std::string("sRGB"));
    QCOMPARE(outcome(jpeg(exifBlock(1, "R03"), "")), std::string("sRGB, against 1"));
    const std::string p3 = profileOf(kP3D65, test::curveTag({563}), "Adobe RGB (1998)");
    QCOMPARE(outcome(jpeg("", p3)), std::string("the space of the ICC profile 'Adobe RGB (1998)'"));
    QCOMPARE(outcome(jpeg(exifBlock(65535, "R98"), p3)),
             std::string("the space of the ICC profile 'Adobe RGB (1998)'"));
    QCOMPARE(outcome(jpeg(exifBlock(1, "R98"), p3)),
             std::string("the space of the ICC profile 'Adobe RGB (1998)', against 1"));
  }

  // Every byte of the block may be wrong.
  void damagedExifIsNoStatement() {
    const std::string sound = exifBlock(65535, "R03");
    for (std::size_t at = 0; at < sound.size(); ++at) {
      std::string damaged = sound;
      damaged[at] = static_cast<char>(damaged[at] ^ 0xff);
      const std::string found = outcome(png(pngChunk("eXIf", damaged)));
      QVERIFY2(found == "sRGB" || found == "Adobe RGB (1998)", found.c_str());
    }
    QCOMPARE(outcome(png(pngChunk("eXIf", sound.substr(0, 30)))), std::string("sRGB"));
  }

  void openExrStatements() {
    const auto primaries = [](const RgbPrimaries& p) {
      return [&p](OIIO::ImageSpec& spec) {
        std::array<float, 8> values = {};
        for (std::size_t i = 0; i < 8; ++i)
          values[i] = static_cast<float>(p.chromaticities[i]);
        spec.attribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8), values.data());
      };
    };
    QCOMPARE(outcome(exr([](OIIO::ImageSpec&) {})), std::string("Linear Rec.709"));
    QCOMPARE(outcome(exr(primaries(kAcesCg))), std::string("ACEScg"));
    QCOMPARE(outcome(exr(primaries(kAdobeRgb))),
             std::string("linear RGB of the primaries 0.64 0.33 0.21 0.71 0.15 0.06 0.3127 0.329"));
    const auto id = [](const char* name) {
      return [name](OIIO::ImageSpec& spec) { spec.attribute("colorInteropID", name); };
    };
    for (const auto& [name, space] : {std::pair{"lin_ap1_scene", "ACEScg"},
                                      {"srgb_p3d65_scene", "Display P3"},
                                      {"lin_ap0_scene", "ACES2065-1"},
                                      {"g22_adobergb_scene", "Adobe RGB (1998)"},
                                      {"data", "Raw"},
                                      {"unknown", "Linear Rec.709"}}) {
      QCOMPARE(outcome(exr(id(name))), std::string(space));
    }
    QCOMPARE(outcome(exr(id("studio:martian"))),
             std::string("its attribute colorInteropID says 'studio:martian', which is not known; "
                         "name the colour space of the file, for example Linear Rec.709"));
    const auto aces = [](OIIO::ImageSpec& spec) { spec.attribute("acesImageContainerFlag", 1); };
    QCOMPARE(outcome(exr(aces)), std::string("ACES2065-1"));
    QCOMPARE(outcome(exr([&](OIIO::ImageSpec& spec) {
               primaries(kAcesCg)(spec);
               aces(spec);
             })),
             std::string("ACEScg, against 1"));
    QCOMPARE(outcome(exr([&](OIIO::ImageSpec& spec) {
               spec.attribute("cutis:colorspace", "ACEScg");
               primaries(kRec709)(spec);
             })),
             std::string("ACEScg, against 1"));
  }

  void choicesComeFirstAndAreHeldAgainstTheFile() {
    QCOMPARE(outcome(png(srgbChunk()), "sRGB"), std::string("sRGB"));
    const auto decided = decide(png(cicp(12, 13)), "acescg");
    EXPECT_OK(decided);
    QCOMPARE(decided.value().sentence, std::string("its colours are read as ACEScg, as chosen"));
    QCOMPARE(decided.value().contradictions.front(),
             std::string("its cICP chunk says that its colours are Display P3, but ACEScg was "
                         "chosen and is followed"));
    // A file that cannot be followed can be told what it is.
    QCOMPARE(outcome(png(cicp(9, 16)), "ACEScg"), std::string("ACEScg, against 1"));
    EXPECT_ERROR(decide(png(""), "ACEScq"), "--colorspace: unknown colour space 'ACEScq'");
  }

  void sentencesNameWhatIsFollowed() {
    QCOMPARE(decide(png("")).value().sentence,
             std::string("it says nothing of its colours, which are read as sRGB, the default for "
                         "integers"));
    QCOMPARE(decide(png(cicp(12, 13))).value().sentence,
             std::string("its colours are read as Display P3, according to its cICP chunk"));
    const std::string odd = profileOf(kRec2020, test::curveTag({461}), "studio");
    QCOMPARE(decide(png(iccp(odd))).value().sentence,
             std::string("its colours are read by its ICC profile 'studio'"));
    QCOMPARE(decide(png(iccp(odd) + srgbChunk())).value().contradictions.front(),
             std::string("its sRGB chunk says that its colours are sRGB, but its ICC profile "
                         "'studio' describes other colours and is followed"));
  }

  void damagedProfilesAreRefusedForTheTrueReason() {
    EXPECT_ERROR(decide(png(iccp("no profile at all, only a text"))),
                 "a.png: its ICC profile says the ICC profile cannot be used");
    EXPECT_ERROR(decide(png(pngChunk("iCCP", std::string("x\0\0garbage", 10)))), "cannot be used");
    EXPECT_OK(decide(png(iccp("no profile")), "sRGB"));
  }

  // L*, a* and b* by the equations, 8 and 16 bits, both ways of storing them.
  void cieLabIsConverted() {
    struct Sample {
      double l, a, b;
      std::array<double, 3> linear;
    };
    // Of sRGB (200, 150, 120) and of white, CIE 15:2018 under D50.
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

  void greyIsReadAsEqualColors() {
    const auto path = png(iccp(test::greyProfile(2, test::curveTag({461}), "dots")), 0);
    test::Listener listener;
    const auto albedo = readAlbedo(path, {}, test::albedoRig(), nullptr, listener.context());
    EXPECT_OK(albedo);
    QCOMPARE(albedo.value().source.channelNames, (std::vector<std::string>{"R", "G", "B"}));
    for (const Plane& plane : albedo.value().measurements.channels)
      EXPECT_NEAR(test::pixelOf(plane, 1, 1), std::pow(200.0 / 255.0, 461.0 / 256.0), 1e-3);
    QCOMPARE(listener.sentences.size(), std::size_t{2});
    QVERIFY(listener.sentences[0].ends_with("its colours are read by its ICC profile 'dots'"));
    QVERIFY(listener.sentences[1].find("the image is grey") != std::string::npos);
  }

  // What is written says what it is, and says nothing that is not so.
  void outputsStateTheirColors_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("space");
    for (const char* file : {"o.png", "o.jpg", "o.tif", "o.exr"}) {
      for (const char* space : {"sRGB", "Linear Rec.709", "Display P3", "Adobe RGB (1998)",
                                "ACEScg", "Linear Rec.2020"})
        QTest::addRow("%s %s", file, space) << file << space;
    }
  }
  void outputsStateTheirColors() {
    QFETCH(QString, file);
    QFETCH(QString, space);
    const auto path = folder_.path(file.toStdString());
    ImageContent content = test::makeContent(8, 8, {"R", "G", "B"});
    content.colorSpace = builtInColorSpace(space.toStdString());
    // A source that says many things which are no longer true.
    content.metadata = readImageHeader(exr([](OIIO::ImageSpec& spec) {
                                         spec.attribute("acesImageContainerFlag", 1);
                                         spec.attribute("colorInteropID", "lin_ap0_scene");
                                         spec.attribute("Exif:ColorSpace", 1);
                                         spec.attribute("oiio:Gamma", 1.8f);
                                         spec.attribute("Make", "Canon");
                                       }),
                                       {})
                           .value()
                           .metadata;
    const SampleType type = file.endsWith("exr") ? SampleType::half : SampleType::uint8;
    test::Listener listener;
    EXPECT_OK(writeImage(path, content, type, listener.context()));
    QVERIFY(listener.sentences.empty());
    const auto header = readImageHeader(path, {});
    EXPECT_OK(header);
    const auto decided = decideColors(header.value().colors, {}, "out");
    EXPECT_OK(decided);
    QCOMPARE(QString::fromStdString(decided.value().followed.space.name), space);
    QVERIFY(!header.value().colors.statements.empty());
    QVERIFY2(decided.value().contradictions.empty(),
             decided.value().contradictions.empty()
                 ? ""
                 : decided.value().contradictions.front().c_str());
    auto input = OIIO::ImageInput::open(path.string());
    QVERIFY(input != nullptr);
    for (const char* stale : {"acesImageContainerFlag", "colorInteropID"})
      QVERIFY(input->spec().find_attribute(stale) == nullptr);
    QCOMPARE(header.value().metadata.text("Make").value_or(""), std::string("Canon"));
    std::vector<unsigned char> pixels(8 * 8 * 3);
    QVERIFY(input->read_image(0, 0, 0, -1, OIIO::TypeUInt8, pixels.data()));
  }

  void profilesOfTheSourceAreEmbeddedAgain() {
    const std::string profile =
        profileOf(kRec2020, test::sampledTag(256, [](double v) { return v * v; }), "studio");
    for (const char* file : {"o.png", "o.jpg", "o.tif"}) {
      ImageContent content = test::makeContent(8, 8, {"R", "G", "B"});
      content.colorSpace = readIccProfile(profile, "a").value().space;
      EXPECT_OK(writeImage(folder_.path(file), content, SampleType::uint8, {}));
      const auto header = readImageHeader(folder_.path(file), {});
      EXPECT_OK(header);
      const ColorStatement& first = header.value().colors.statements.front();
      QVERIFY(first.space.profile != nullptr && *first.space.profile == profile);
    }
    QVERIFY(!canStateColors("o.exr", readIccProfile(profile, "a").value().space));
    QVERIFY(canStateColors("o.exr", builtInColorSpace("sRGB")));
  }
};

CUTIS_TEST(DeclaredColorsTest)

}  // namespace
}  // namespace cutis

#include "declared_colors_test.moc"
