// Files whose samples do not mean what they would at first sight: white at 0, an alpha that nobody
// meant, factors in the header, profiles in several pieces. Files are made byte by byte.

#include <array>
#include <cmath>

#include <OpenImageIO/imageio.h>
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
using test::pixelOf;

void writeText(const std::filesystem::path& path, const std::string& bytes) {
  test::writeBytes(path, QByteArray::fromStdString(bytes));
}

std::string lowBytes(std::uint64_t value, int bytes) {
  std::string out;
  for (int i = 0; i < bytes; ++i)
    out += static_cast<char>(value >> (8 * i) & 0xff);
  return out;
}

// 2 × 1 pixels of 32 bits, straight: half transparent and opaque, both of colour 200, 100, 50.
// type: of the extension area; negative: there is none.
std::string targa(int alphaBits, int type) {
  std::string file = std::string("\0\0\2\0\0\0\0\0\0\0\0\0", 12) + lowBytes(2, 2) + lowBytes(1, 2) +
                     lowBytes(32, 1) + lowBytes(static_cast<std::uint64_t>(alphaBits) | 0x20, 1);
  file += "\x32\x64\xc8\x80\x32\x64\xc8\xff";
  if (type < 0) return file;
  std::string extension = lowBytes(495, 2) + std::string(493, '\0');
  extension[494] = static_cast<char>(type);
  const std::size_t place = file.size();
  return file + extension + lowBytes(place, 4) + lowBytes(0, 4) +
         std::string("TRUEVISION-XFILE.\0", 18);
}

// A 32-bit bitmap of 2 × 1 pixels whose header knows no alpha; its fourth bytes are 0.
std::string bitmap() {
  const std::string pixels("\x32\x64\xc8\0\x32\x64\xc8\0", 8);
  return "BM" + lowBytes(54 + pixels.size(), 4) + lowBytes(0, 4) + lowBytes(54, 4) +
         lowBytes(40, 4) + lowBytes(2, 4) + lowBytes(1, 4) + lowBytes(1, 2) + lowBytes(32, 2) +
         std::string(24, '\0') + pixels;
}

std::string radiance(const std::string& lines) {
  // Mantissas 128 and exponent 128: 0.5 each.
  return "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n" + lines + "\n-Y 1 +X 2\n" +
         std::string("\x80\x80\x80\x80\x80\x80\x80\x80");
}

class UnusualSamplesTest : public QObject {
  Q_OBJECT

 private slots:
  void targaIsStraight_data() {
    QTest::addColumn<int>("bits");
    QTest::addColumn<int>("type");
    QTest::addColumn<bool>("multiplied");
    QTest::newRow("no extension") << 8 << -1 << false;
    QTest::newRow("no alpha bits") << 0 << -1 << false;
    QTest::newRow("no alpha data") << 8 << 0 << false;
    QTest::newRow("to be ignored") << 8 << 1 << false;
    QTest::newRow("to be retained") << 8 << 2 << false;
    QTest::newRow("useful") << 8 << 3 << false;
    QTest::newRow("multiplied") << 8 << 4 << true;
  }
  void targaIsStraight() {
    QFETCH(int, bits);
    QFETCH(int, type);
    QFETCH(bool, multiplied);
    writeText(folder_.path("a.tga"), targa(bits, type));
    const auto image = readImage(folder_.path("a.tga"), {PixelFormat::float32}, nullptr, {});
    EXPECT_OK(image);
    QCOMPARE(image.value().alphaKind == AlphaKind::associated, multiplied);
    EXPECT_NEAR(pixelOf(image.value().channels[0], 0, 0), 200.0f / 255.0f, 1e-6);
  }

  void whiteAtZeroIsWhite_data() {
    QTest::addColumn<bool>("isFloat");
    QTest::newRow("16 bits") << false;
    QTest::newRow("floats") << true;
  }
  void whiteAtZeroIsWhite() {
    QFETCH(bool, isFloat);
    const auto path = folder_.path("negative.tif");
    writeGreyTiff(path, isFloat);
    const auto image = readImage(path, {PixelFormat::float32}, nullptr, {});
    EXPECT_OK(image);
    EXPECT_NEAR(pixelOf(image.value().channels[0], 0, 0), 1.0, 1e-6);
    EXPECT_NEAR(pixelOf(image.value().channels[0], 1, 0), 0.25, 1e-4);
  }

  void radianceIsDividedByItsExposure() {
    for (const auto& [lines, expected] :
         {std::pair{"", 0.5}, std::pair{"EXPOSURE=2.0\n", 0.25},
          std::pair{"EXPOSURE=2\nEXPOSURE= 0.5\n", 0.5}, std::pair{"EXPOSURE=none\n", 0.5}}) {
      writeText(folder_.path("a.hdr"), radiance(lines));
      const auto image = readImage(folder_.path("a.hdr"), {PixelFormat::float32}, nullptr, {});
      EXPECT_OK(image);
      EXPECT_NEAR(double{pixelOf(image.value().channels[1], 1, 0)}, expected, 0.01);
    }
  }

  void radianceHasPrimaries() {
    writeText(folder_.path("p.hdr"),
              radiance("PRIMARIES=0.68 0.32 0.265 0.69 0.15 0.06 0.3127 0.3290\n"));
    const auto header = readImageHeader(folder_.path("p.hdr"), {});
    EXPECT_OK(header);
    QCOMPARE(header.value().colors.statements.size(), std::size_t{1});
    QCOMPARE(header.value().colors.statements.front().origin, std::string("its line PRIMARIES"));
  }

  void otherRadianceIsNotDamaged() {
    writeText(folder_.path("x.hdr"), "#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 2\n");
    const auto header = readImageHeader(folder_.path("x.hdr"), {});
    QVERIFY(header.failed());
    QVERIFY2(header.error().message.find("32-bit_rle_xyze") != std::string::npos,
             header.error().message.c_str());
    QVERIFY(header.error().message.find("damaged") == std::string::npos);
  }

  // An alpha that leaves nothing of the picture was not meant.
  void anEmptyAlphaIsNone() {
    writeText(folder_.path("a.bmp"), bitmap());
    test::Listener listener;
    const auto albedo =
        readAlbedo(folder_.path("a.bmp"), {}, test::albedoRig(), nullptr, listener.context());
    EXPECT_OK(albedo);
    QCOMPARE(pixelOf(albedo.value().measurements.state, 0, 0), 0.0f);
    QVERIFY(std::any_of(
        listener.sentences.begin(), listener.sentences.end(),
        [](const std::string& said) { return said.find("0 everywhere") != std::string::npos; }));
  }

  // A profile in one piece and in several.
  void profilesInJpegComeBackWhole_data() {
    QTest::addColumn<int>("entries");
    for (const int entries : {256, 20000, 32000, 65000, 120000})
      QTest::newRow(QByteArray::number(2 * entries).constData()) << entries;
  }
  void profilesInJpegComeBackWhole() {
    QFETCH(int, entries);
    const std::string padding(static_cast<std::size_t>(2 * entries), 'x');
    const auto& p3 = kP3D65.chromaticities;
    std::string bytes = test::matrixProfile(4, p3, test::curveTag({563}), "studio");
    bytes += padding;  // what profiles hold beside what is read
    bytes[0] = static_cast<char>(bytes.size() >> 24);
    bytes[1] = static_cast<char>(bytes.size() >> 16 & 0xff);
    bytes[2] = static_cast<char>(bytes.size() >> 8 & 0xff);
    bytes[3] = static_cast<char>(bytes.size() & 0xff);
    const auto profile = readIccProfile(bytes, "test");
    EXPECT_OK(profile);
    ImageContent content = test::makeContent(9, 7, {"R", "G", "B"});
    content.colorSpace = profile.value().space;
    EXPECT_OK(writeImage(folder_.path("p.jpg"), content, SampleType::uint8, {}));
    const auto image = readImage(folder_.path("p.jpg"), {PixelFormat::float32}, nullptr, {});
    EXPECT_OK(image);
    QVERIFY(!image.value().colors.statements.empty());
    const ColorSpace& space = image.value().colors.statements.front().space;
    QVERIFY(space.profile != nullptr && *space.profile == bytes);
  }

  // Not the grey picture that its luminance would be.
  void wholeLuminanceAndChromaAreRefused() {
    const auto path = folder_.path("yc.exr");
    writeLumaChroma(path);
    const auto header = readImageHeader(path, {});
    QVERIFY(header.failed());
    QVERIFY2(header.error().message.find("luminance and chroma") != std::string::npos,
             header.error().message.c_str());
  }

 private:
  // 2 × 1 pixels, stored 0 and three quarters.
  static void writeGreyTiff(const std::filesystem::path& path, bool isFloat) {
    const std::string pixels =
        isFloat ? std::string("\0\0\0\0\0\0\x40\x3f", 8) : std::string("\0\0\xff\xbf", 4);
    const auto entry = [](int tag, int type, std::uint64_t value) {
      return lowBytes(static_cast<std::uint64_t>(tag), 2) +
             lowBytes(static_cast<std::uint64_t>(type), 2) + lowBytes(1, 4) + lowBytes(value, 4);
    };
    const std::string directory =
        entry(256, 4, 2) + entry(257, 4, 1) + entry(258, 3, isFloat ? 32 : 16) + entry(259, 3, 1) +
        entry(262, 3, 0) + entry(273, 4, 8) + entry(277, 3, 1) + entry(278, 4, 1) +
        entry(279, 4, pixels.size()) + entry(339, 3, isFloat ? 3 : 1);
    writeText(path, std::string("II*\0", 4) + lowBytes(8 + pixels.size(), 4) + pixels +
                        lowBytes(10, 2) + directory + lowBytes(0, 4));
  }

  static void writeLumaChroma(const std::filesystem::path& path) {
    constexpr int kSize = 8;
    OIIO::ImageSpec spec(kSize, kSize, 3, OIIO::TypeFloat);
    spec.channelnames = {"Y", "RY", "BY"};
    std::vector<float> pixels;
    for (int i = 0; i < kSize * kSize; ++i)
      pixels.insert(pixels.end(), {0.5f, 0.4f, -0.4f});
    const auto file = OIIO::ImageOutput::create(path.string());
    QVERIFY(file && file->open(path.string(), spec));
    QVERIFY(file->write_image(OIIO::TypeFloat, pixels.data()) && file->close());
  }

  ImageFolder folder_;
};

CUTIS_TEST(UnusualSamplesTest)

}  // namespace
}  // namespace cutis

#include "unusual_samples_test.moc"
