// What TIFF tags, PSD, WebP and HEIC say of their colours, and that these formats are read at all.
// Files are made byte by byte, or by OpenImageIO and then changed.

#include <algorithm>
#include <array>
#include <cmath>

#include <QtTest>

#include "src/color/color_space.h"
#include "src/images/color/heif_color.h"
#include "src/images/image_file.h"
#include "tests/src/images/image_fixture.h"
#include "tests/support/expect.h"
#include "tests/support/icc_bytes.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

using test::ImageFolder;

std::string little(std::uint64_t value, int bytes) {
  std::string out;
  for (int i = 0; i < bytes; ++i)
    out += static_cast<char>(value >> (8 * i) & 0xff);
  return out;
}

std::string big(std::uint64_t value, int bytes) {
  std::string out;
  test::putBytes(out, value, bytes);
  return out;
}

struct TiffTag {
  int tag = 0;
  int type = 0;
  std::uint64_t count = 0;
  std::string value;
};

std::string rationals(const std::vector<double>& values) {
  std::string bytes;
  for (const double value : values)
    bytes += little(static_cast<std::uint64_t>(std::lround(value * 1e6)), 4) + little(1000000, 4);
  return bytes;
}

TiffTag primariesTag(const RgbPrimaries& primaries) {
  const auto& c = primaries.chromaticities;
  return {319, 5, 6, rationals({c[0], c[1], c[2], c[3], c[4], c[5]})};
}
TiffTag whiteTag(double x, double y) {
  return {318, 5, 2, rationals({x, y})};
}
// Tables of so many bits, one for each curve.
TiffTag transferTag(int bits, const std::vector<TransferCurve>& curves) {
  std::string bytes;
  const int entries = 1 << bits;
  for (const TransferCurve& curve : curves) {
    for (int i = 0; i < entries; ++i) {
      const double light = curve.toLight(i / (entries - 1.0));
      bytes += little(static_cast<std::uint64_t>(std::lround(light * 65535.0)), 2);
    }
  }
  return {301, 3, bytes.size() / 2, bytes};
}

// 2 × 2 pixels of RGB, 8 bits, with these tags as well.
void writeTaggedTiff(const std::filesystem::path& path, std::vector<TiffTag> tags) {
  const std::string pixels(12, '\x80');
  tags.insert(tags.end(), {{256, 4, 1, little(2, 4)},
                           {257, 4, 1, little(2, 4)},
                           {258, 3, 3, little(8, 2) + little(8, 2) + little(8, 2)},
                           {259, 3, 1, little(1, 4)},
                           {262, 3, 1, little(2, 4)},
                           {273, 4, 1, little(8, 4)},
                           {277, 3, 1, little(3, 4)},
                           {278, 4, 1, little(2, 4)},
                           {279, 4, 1, little(pixels.size(), 4)}});
  std::sort(tags.begin(), tags.end(), [](const auto& a, const auto& b) { return a.tag < b.tag; });
  std::string heap = pixels, directory = little(tags.size(), 2);
  for (const TiffTag& tag : tags) {
    directory += little(static_cast<std::uint64_t>(tag.tag), 2) +
                 little(static_cast<std::uint64_t>(tag.type), 2) + little(tag.count, 4);
    if (tag.value.size() <= 4) {
      directory += (tag.value + std::string(4, '\0')).substr(0, 4);
      continue;
    }
    directory += little(8 + heap.size(), 4);
    heap += tag.value;
  }
  test::writeBytes(
      path, QByteArray::fromStdString(std::string("II*\0", 4) + little(8 + heap.size(), 4) + heap +
                                      directory + little(0, 4)));
}

// A layer without pixels of its own. That there is minus one of it says that the fourth plane of
// the flattened picture is its transparency.
std::string psdLayers() {
  const std::string layer = std::string(16, '\0') + big(0, 2) + "8BIMnorm" +
                            std::string("\xff\0\0\0", 4) + big(12, 4) + std::string(12, '\0');
  const std::string layers = big(0xffff, 2) + layer;
  return big(layers.size() + 8, 4) + big(layers.size(), 4) + layers + big(0, 4);
}

// The flattened picture is stored plane by plane, uncompressed.
std::string psd(int bits, const std::vector<std::vector<std::uint16_t>>& planes,
                const std::string& profile) {
  std::string resources;
  if (!profile.empty()) {
    resources = "8BIM" + big(1039, 2) + std::string(2, '\0') + big(profile.size(), 4) + profile +
                std::string(profile.size() % 2, '\0');
  }
  std::string pixels;
  for (const auto& plane : planes) {
    for (const std::uint16_t value : plane)
      pixels += big(value, bits / 8);
  }
  return "8BPS" + big(1, 2) + std::string(6, '\0') + big(planes.size(), 2) + big(2, 4) + big(2, 4) +
         big(static_cast<std::uint64_t>(bits), 2) + big(3, 2) + big(0, 4) +
         big(resources.size(), 4) + resources + (planes.size() > 3 ? psdLayers() : big(0, 4)) +
         big(0, 2) + pixels;
}

std::string studioProfile() {
  return test::matrixProfile(4, kP3D65.chromaticities, test::curveTag({563}), "studio");
}

std::string chunk(const std::string& name, const std::string& content) {
  return name + little(content.size(), 4) + content + std::string(content.size() % 2, '\0');
}

// A lossless WebP (RFC 9649) of one straight colour: five prefix codes of one symbol each, after
// which no pixel needs a bit.
std::string webPPixels(int width, int height, const std::array<int, 4>& rgba) {
  std::vector<bool> bits;
  const auto put = [&](int value, int count) {
    for (int i = 0; i < count; ++i)
      bits.push_back((value >> i & 1) != 0);
  };
  put(0x2f, 8);
  put(width - 1, 14);
  put(height - 1, 14);
  put(1, 1);  // alpha is used
  put(0, 3);  // version
  put(0, 3);  // no transform, no cache of colours, one group of codes
  for (const int symbol : {rgba[1], rgba[0], rgba[2], rgba[3], 0}) {
    put(1, 1);  // a simple code
    put(0, 1);  // of one symbol
    put(1, 1);  // in 8 bits
    put(symbol, 8);
  }
  std::string pixels((bits.size() + 7) / 8, '\0');
  for (std::size_t i = 0; i < bits.size(); ++i)
    pixels[i / 8] = static_cast<char>(pixels[i / 8] | (bits[i] ? 1 << i % 8 : 0));
  return chunk("VP8L", pixels);
}

std::string sides(int width, int height) {
  return little(static_cast<std::uint64_t>(width - 1), 3) +
         little(static_cast<std::uint64_t>(height - 1), 3);
}

// Chunks before and behind the pixels; flags say which there are.
std::string webPOf(int flags, int width, int height, const std::string& before,
                   const std::string& pixels, const std::string& behind) {
  std::string body = "WEBP";
  if (flags != 0) {
    body += chunk("VP8X", little(static_cast<std::uint64_t>(flags), 4) + sides(width, height));
  }
  body += before + pixels + behind;
  return "RIFF" + little(body.size(), 4) + body;
}

std::string webP(int width, int height, const std::array<int, 4>& rgba,
                 const std::string& profile) {
  const std::string pixels = webPPixels(width, height, rgba);
  if (profile.empty()) return webPOf(0, width, height, "", pixels, "");
  return webPOf(0x30, width, height, chunk("ICCP", profile), pixels, "");
}

// An EXIF block that says nothing but how the picture lies.
std::string exifOrientationBlock(int tag) {
  return std::string("MM\0*", 4) + big(8, 4) + big(1, 2) + big(0x112, 2) + big(3, 2) + big(1, 4) +
         big(static_cast<std::uint64_t>(tag), 2) + big(0, 2) + big(0, 4);
}

// Two frames of one colour each, for a tenth of a second.
std::string webPAnimation(int width, int height) {
  std::string frames = chunk("ANIM", little(0, 4) + little(0, 2));
  for (const std::array<int, 4>& color :
       {std::array{204, 102, 51, 255}, std::array{51, 102, 204, 255}}) {
    frames += chunk("ANMF", little(0, 6) + sides(width, height) + little(100, 3) + little(2, 1) +
                                webPPixels(width, height, color));
  }
  return webPOf(0x02, width, height, frames, "", "");
}

std::string box(const std::string& name, const std::string& content) {
  return big(content.size() + 8, 4) + name + content;
}

// The boxes of a HEIC file that speak of colours: the first picture has the first property, the
// second, which is the primary one, the others.
std::string heifBoxes(const std::vector<std::string>& colr) {
  std::string properties = box("colr", "prof" + std::string("of another picture"));
  std::string places = big(1, 2) + big(1, 1) + big(1, 1) + big(2, 2) + big(colr.size(), 1);
  for (std::size_t i = 0; i < colr.size(); ++i) {
    properties += box("colr", colr[i]);
    places += big(0x80 | (i + 2), 1);  // essential
  }
  const std::string meta =
      big(0, 4) + box("pitm", big(0, 4) + big(2, 2)) +
      box("iprp", box("ipco", properties) + box("ipma", big(0, 4) + big(2, 4) + places));
  return box("ftyp", "heic" + big(0, 4) + "mif1heic") + box("free", "abc") + box("meta", meta) +
         box("mdat", "pixels");
}

class ForeignColorsTest : public QObject {
  Q_OBJECT

  ImageFolder folder_;

  static Result<ColorDecision> decide(const std::filesystem::path& path) {
    CUTIS_TRY(header, readImageHeader(path, {}));
    return decideColors(header.colors, {}, path.string());
  }

  std::string outcome(const std::vector<TiffTag>& tags) {
    writeTaggedTiff(folder_.path("t.tif"), tags);
    const auto decided = decide(folder_.path("t.tif"));
    if (!decided) return decided.error().message;
    const auto against = decided.value().contradictions.size();
    return decided.value().followed.space.name + (against == 0 ? "" : ", contradicted");
  }

 private slots:
  void tiffTagsAreFollowed() {
    const TransferCurve srgb = TransferCurve::srgb(), adobe = TransferCurve::power(563.0 / 256.0);
    QCOMPARE(outcome({}), std::string("sRGB"));
    QCOMPARE(outcome({primariesTag(kP3D65)}), std::string("Display P3"));
    QCOMPARE(outcome({primariesTag(kP3D65), whiteTag(0.3127, 0.329), transferTag(8, {srgb})}),
             std::string("Display P3"));
    QCOMPARE(outcome({primariesTag(kAdobeRgb), whiteTag(0.3127, 0.329),
                      transferTag(8, {adobe, adobe, adobe})}),
             std::string("Adobe RGB (1998)"));
    QCOMPARE(outcome({transferTag(8, {TransferCurve()})}), std::string("Linear Rec.709"));
    QCOMPARE(outcome({transferTag(16, {srgb, srgb, srgb})}), std::string("sRGB"));
    QCOMPARE(outcome({whiteTag(0.3457, 0.3585)}), std::string("sRGB"));
    QCOMPARE(decide(folder_.path("t.tif")).value().followed.source == ColorSource::formatDefault,
             true);
  }

  void whatTagsLeaveOpenIsSaid() {
    outcome({primariesTag(kP3D65)});
    QCOMPARE(
        decide(folder_.path("t.tif")).value().sentence,
        std::string("its colours are read as Display P3, according to its TIFF tag "
                    "PrimaryChromaticities; a white of D65 and the curve of sRGB are assumed"));
    outcome({primariesTag(kP3D65), whiteTag(0.3127, 0.329)});
    QCOMPARE(decide(folder_.path("t.tif")).value().sentence,
             std::string("its colours are read as Display P3, according to its TIFF tags "
                         "PrimaryChromaticities and WhitePoint; the curve of sRGB is assumed"));
  }

  void badTagsAreObjections() {
    QCOMPARE(outcome({primariesTag({"", {0.3, 0.3, 0.3, 0.3, 0.3, 0.3, 0, 0}})}),
             std::string("its TIFF tag PrimaryChromaticities says primaries that span no colours; "
                         "name the colour space of the file, for example sRGB"));
    std::string falling;
    for (int i = 0; i < 256; ++i)
      falling += little(static_cast<std::uint64_t>(257 * (255 - i)), 2);
    QCOMPARE(
        outcome({{301, 3, 256, falling}}),
        std::string("its TIFF tag TransferFunction says a transfer function that does not rise "
                    "from black to white; name the colour space of the file, for example "
                    "sRGB"));
  }

  void profilesComeBeforeTags() {
    const std::string profile =
        test::matrixProfile(4, kRec2020.chromaticities, test::curveTag({}), "wide");
    QCOMPARE(outcome({primariesTag(kP3D65), {34675, 7, profile.size(), profile}}),
             std::string("Linear Rec.2020, contradicted"));
  }

  // Flattened, of 8 and 16 bits, with and without alpha and profile.
  void photoshopIsRead() {
    for (const int bits : {8, 16}) {
      const std::uint16_t most = bits == 8 ? 255 : 65535,
                          third = static_cast<std::uint16_t>(most / 3);
      const std::vector<std::vector<std::uint16_t>> rgb = {
          {most, third, 0, third}, {third, most, 0, third}, {0, third, most, third}};
      // Photoshop lays what is transparent on white: a third of a third, and two thirds of white.
      auto withAlpha = rgb;
      for (auto& plane : withAlpha)
        plane[3] = static_cast<std::uint16_t>(std::lround(most * 7.0 / 9.0));
      withAlpha.push_back({most, most, most, third});
      for (const auto& planes : {rgb, withAlpha}) {
        test::writeBytes(folder_.path("a.psd"), QByteArray::fromStdString(psd(bits, planes, {})));
        const auto image = readImage(folder_.path("a.psd"), {PixelFormat::float32}, nullptr, {});
        EXPECT_OK(image);
        QVERIFY(image.value().kind == ImageFileKind::psd);
        QVERIFY(image.value().sourceType == (bits == 8 ? SampleType::uint8 : SampleType::uint16));
        QCOMPARE(image.value().channels.size(), planes.size());
        EXPECT_NEAR(test::pixelOf(image.value().channels[0], 0, 0), 1.0, 1e-6);
        EXPECT_NEAR(test::pixelOf(image.value().channels[0], 1, 0), 1.0 / 3.0, 1e-4);
        EXPECT_NEAR(test::pixelOf(image.value().channels[2], 0, 1), 1.0, 1e-6);
        QCOMPARE(image.value().layer.alpha, planes.size() == 4 ? 3 : -1);
        QVERIFY(image.value().alphaKind == AlphaKind::straight);
        expectStraight(image.value(), 1, 1, 1.0 / 3.0);
        QCOMPARE(decide(folder_.path("a.psd")).value().followed.space.name, std::string("sRGB"));
      }
      test::writeBytes(folder_.path("p.psd"),
                       QByteArray::fromStdString(psd(bits, rgb, studioProfile())));
      const auto decided = decide(folder_.path("p.psd"));
      EXPECT_OK(decided);
      QCOMPARE(decided.value().sentence,
               std::string("its colours are read by its ICC profile 'studio'"));
    }
  }

  void webPIsRead() {
    const auto path = folder_.path("a.webp");
    for (const std::string& profile : {std::string(), studioProfile()}) {
      for (const int alpha : {255, 153}) {
        test::writeBytes(path,
                         QByteArray::fromStdString(webP(20, 10, {204, 102, 51, alpha}, profile)));
        const auto image = readImage(path, {PixelFormat::float32}, nullptr, {});
        EXPECT_OK(image);
        QVERIFY(image.value().kind == ImageFileKind::webP);
        QCOMPARE(image.value().width, 20);
        expectStraight(image.value(), 19, 9, 0.8);
        EXPECT_NEAR(test::pixelOf(image.value().channels[3], 19, 9), alpha / 255.0, 1e-6);
      }
      const auto decided = decide(path);
      EXPECT_OK(decided);
      QCOMPARE(decided.value().sentence,
               std::string(profile.empty()
                               ? "it says nothing of its colours, which are read as sRGB, the "
                                 "default for integers"
                               : "its colours are read by its ICC profile 'studio'"));
    }
  }

  // OpenImageIO hands no EXIF of a WebP file on.
  void webPIsReadUpright() {
    const std::string pixels = webPPixels(20, 10, {204, 102, 51, 255});
    for (int tag = 1; tag <= 8; ++tag) {
      for (const bool isMarked : {false, true}) {
        const std::string block =
            (isMarked ? std::string("Exif\0\0", 6) : "") + exifOrientationBlock(tag);
        test::writeBytes(
            folder_.path("turned.webp"),
            QByteArray::fromStdString(webPOf(0x08, 20, 10, "", pixels, chunk("EXIF", block))));
        const auto image = readImage(folder_.path("turned.webp"), {}, nullptr, {});
        EXPECT_OK(image);
        QCOMPARE(static_cast<int>(image.value().orientation), tag);
        QCOMPARE(image.value().width, tag >= 5 ? 10 : 20);
        QCOMPARE(image.value().channels[0].height(), tag >= 5 ? 20 : 10);
      }
    }
  }

  void webPSaysWhatIsNotRead() {
    const auto said = [&](const std::string& bytes) {
      test::writeBytes(folder_.path("said.webp"), QByteArray::fromStdString(bytes));
      test::Listener listener;
      const auto image =
          readImage(folder_.path("said.webp"), {PixelFormat::float32}, nullptr, listener.context());
      if (!image) return image.failed() ? image.error().message : std::string("cancelled");
      if (std::abs(test::pixelOf(image.value().channels[0], 3, 3) - 0.8f) > 0.01f &&
          image.value().layer.alpha < 0)
        return std::string("another frame");
      std::string all;
      for (const std::string& sentence : listener.sentences)
        all += sentence + "\n";
      return all;
    };
    QCOMPARE(said(webP(20, 10, {204, 102, 51, 255}, {})).find("animation"), std::string::npos);
    QVERIFY(said(webPAnimation(20, 10)).find("its first frame alone is read") != std::string::npos);
    QVERIFY(said(webP(20, 10, {204, 102, 51, 153}, {})).find("multiplied by it in 8 bits") !=
            std::string::npos);
  }

  void heicSaysItsColors() {
    const auto path = folder_.path("boxes.heic");
    const auto said = [&](const std::string& bytes) {
      test::writeBytes(path, QByteArray::fromStdString(bytes));
      return readHeifColors(path);
    };
    const std::string nclx = "nclx" + big(9, 2) + big(16, 2) + big(9, 2) + big(0, 1);
    const std::string whole = heifBoxes({nclx, "prof" + studioProfile()});
    const HeifColors both = said(whole);
    QVERIFY(both.profile && *both.profile == studioProfile());
    QVERIFY(both.codePoints && both.codePoints->primaries == 9 && both.codePoints->transfer == 16);
    QVERIFY(both.codePoints->matrix == 0 && both.codePoints->fullRange);
    const HeifColors neither = said(heifBoxes({}));
    QVERIFY(!neither.profile && !neither.codePoints);
    for (std::size_t length = 0; length < whole.size(); length += 7) {
      const HeifColors cut = said(whole.substr(0, length));
      QVERIFY(!cut.profile || *cut.profile == studioProfile());
    }
    for (std::size_t at = 0; at < 200; ++at) {
      std::string damaged = whole;
      damaged[at] = static_cast<char>(damaged[at] ^ 0xff);
      said(damaged);
    }
  }

  void heicIsRead() {
    const auto path = folder_.path("a.heic");
    auto output = OIIO::ImageOutput::create("heif");
    const OIIO::ImageSpec spec(64, 48, 3, OIIO::TypeUInt8);
    if (!output || !output->open(path.string(), spec)) QSKIP("OpenImageIO writes no HEIC here");
    std::vector<float> samples;
    for (int i = 0; i < 64 * 48; ++i)
      samples.insert(samples.end(), {0.7f, 0.5f, 0.4f});
    if (!output->write_image(OIIO::TypeFloat, samples.data()) || !output->close())
      QSKIP("OpenImageIO writes no HEIC here");
    const auto image = readImage(path, {PixelFormat::float32}, nullptr, {});
    EXPECT_OK(image);
    QVERIFY(image.value().kind == ImageFileKind::heic);
    for (const auto& [channel, value] : {std::pair{0U, 0.7}, {1U, 0.5}, {2U, 0.4}})
      EXPECT_NEAR(test::pixelOf(image.value().channels[channel], 30, 20), value, 0.02);
    QCOMPARE(decide(path).value().followed.space.name, std::string("sRGB"));
  }

 private:
  // The straight red of a pixel, whichever way the reader hands it over.
  static void expectStraight(const Image& image, int x, int y, double red) {
    float value = test::pixelOf(image.channels[0], x, y);
    if (image.layer.alpha >= 0 && image.alphaKind == AlphaKind::associated)
      value /= test::pixelOf(image.channels[static_cast<std::size_t>(image.layer.alpha)], x, y);
    EXPECT_NEAR(value, red, 0.01);
  }
};

CUTIS_TEST(ForeignColorsTest)

}  // namespace
}  // namespace cutis

#include "foreign_colors_test.moc"
