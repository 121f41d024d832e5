// JPEG files of inks: CMYK and YCCK, with Adobe's marker and without, made by libjpeg itself.

#include <cstdio>
#include <jpeglib.h>
#include <string>
#include <vector>

#include <QtTest>

#include "src/images/image_file.h"
#include "tests/src/images/image_fixture.h"
#include "tests/support/expect.h"
#include "tests/support/icc_bytes.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

using test::ImageFolder;

constexpr int kSide = 16;

// Ink as it is written into the file: 255 is all of it, unless Adobe's marker is there.
struct InkJpeg {
  J_COLOR_SPACE stored = JCS_CMYK;
  bool isAdobe = true;
  bool isProgressive = false;
  std::string profile = {};
};

// Columns of no ink, cyan, magenta, black and all four, a quarter of the width each but the last.
std::vector<JSAMPLE> inkAt(int x) {
  const int column = 4 * x / kSide;
  return {static_cast<JSAMPLE>(column == 1 ? 255 : 0), static_cast<JSAMPLE>(column == 2 ? 255 : 0),
          0, static_cast<JSAMPLE>(column == 3 ? 255 : 0)};
}

void writeInkJpeg(const std::filesystem::path& path, const InkJpeg& options) {
  jpeg_compress_struct info = {};
  jpeg_error_mgr errors = {};
  info.err = jpeg_std_error(&errors);
  jpeg_create_compress(&info);
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (file == nullptr) test::fail("cannot write " + path.string());
  jpeg_stdio_dest(&info, file);
  info.image_width = info.image_height = kSide;
  info.input_components = 4;
  info.in_color_space = JCS_CMYK;
  jpeg_set_defaults(&info);
  jpeg_set_colorspace(&info, options.stored);
  jpeg_set_quality(&info, 100, TRUE);
  info.write_Adobe_marker = static_cast<boolean>(options.isAdobe);
  if (options.isProgressive) jpeg_simple_progression(&info);
  for (int c = 0; c < info.num_components; ++c)
    info.comp_info[c].h_samp_factor = info.comp_info[c].v_samp_factor = 1;
  jpeg_start_compress(&info, TRUE);
  if (!options.profile.empty()) {
    jpeg_write_icc_profile(&info, reinterpret_cast<const JOCTET*>(options.profile.data()),
                           static_cast<unsigned>(options.profile.size()));
  }
  for (int y = 0; y < kSide; ++y) {
    std::vector<JSAMPLE> row;
    for (int x = 0; x < kSide; ++x) {
      for (const JSAMPLE ink : inkAt(x))
        row.push_back(static_cast<JSAMPLE>(options.isAdobe ? 255 - ink : ink));
    }
    JSAMPLE* rows = row.data();
    jpeg_write_scanlines(&info, &rows, 1);
  }
  jpeg_finish_compress(&info);
  jpeg_destroy_compress(&info);
  std::fclose(file);
}

std::string pressProfile() {
  return test::tableProfile(
      4,
      [](std::array<double, 4> ink) -> Eigen::Vector3d {
        return test::iccD50() * ((1 - 0.7 * ink[0]) * (1 - 0.5 * ink[1]) * (1 - 0.9 * ink[3]));
      },
      [](double v) { return v; }, "press");
}

class InkJpegTest : public QObject {
  Q_OBJECT

  ImageFolder folder_;

  Result<Image> made(const InkJpeg& options) {
    writeInkJpeg(folder_.path("ink.jpg"), options);
    return readImage(folder_.path("ink.jpg"), {PixelFormat::float32}, nullptr, {});
  }

 private slots:
  void inksAreReadByTheirProfile_data() {
    QTest::addColumn<int>("stored");
    QTest::addColumn<bool>("adobe");
    QTest::addColumn<bool>("progressive");
    QTest::newRow("CMYK of Adobe") << int{JCS_CMYK} << true << false;
    QTest::newRow("YCCK of Adobe") << int{JCS_YCCK} << true << false;
    QTest::newRow("progressive YCCK") << int{JCS_YCCK} << true << true;
    QTest::newRow("CMYK of others") << int{JCS_CMYK} << false << false;
  }
  void inksAreReadByTheirProfile() {
    QFETCH(int, stored);
    QFETCH(bool, adobe);
    QFETCH(bool, progressive);
    const auto image =
        made({static_cast<J_COLOR_SPACE>(stored), adobe, progressive, pressProfile()});
    EXPECT_OK(image);
    QCOMPARE(image.value().channelNames, (std::vector<std::string>{"R", "G", "B"}));
    QVERIFY(image.value().sourceType == SampleType::uint8);
    for (const Plane& plane : image.value().channels) {
      EXPECT_NEAR(test::pixelOf(plane, 1, 1), 1.0, 0.02);
      EXPECT_NEAR(test::pixelOf(plane, 6, 5), 0.3, 0.02);
      EXPECT_NEAR(test::pixelOf(plane, 9, 14), 0.5, 0.02);
      EXPECT_NEAR(test::pixelOf(plane, 14, 8), 0.1, 0.02);
    }
    const auto decided = decideColors(image.value().colors, {}, "ink.jpg");
    EXPECT_OK(decided);
    QCOMPARE(decided.value().sentence,
             std::string("its colours are converted from its storage as CMYK with the ICC profile "
                         "'press'"));
  }

  void inksWithoutAProfileAreRefused() {
    for (const J_COLOR_SPACE stored : {JCS_CMYK, JCS_YCCK}) {
      const auto image = made({stored});
      EXPECT_OK(image);
      EXPECT_ERROR(decideColors(image.value().colors, {}, "ink.jpg"),
                   "CMYK without an ICC profile, which does not say what its inks look like");
    }
    const auto image = made({.profile = test::matrixProfile(4, kRec709.chromaticities,
                                                            test::curveTag({563}), "screen")});
    EXPECT_OK(image);
    EXPECT_ERROR(decideColors(image.value().colors, {}, "ink.jpg"),
                 "CMYK, but its ICC profile is for other colours");
  }

  // libjpeg fills what is missing with grey.
  void damagedInksAreErrors() {
    writeInkJpeg(folder_.path("whole.jpg"), {.profile = pressProfile()});
    const QByteArray whole = test::readBytes(folder_.path("whole.jpg"));
    const auto cut = folder_.path("cut.jpg");
    for (qsizetype length = 4; length < whole.size(); length += 1 + whole.size() / 97) {
      test::writeBytes(cut, whole.first(length));
      const auto image = readImage(cut, {PixelFormat::float32}, nullptr, {});
      QVERIFY2(image.failed(), qPrintable(QString::number(length)));
      QVERIFY(image.error().kind == ErrorKind::input);
    }
    for (qsizetype at = 20; at < whole.size(); at += 1 + whole.size() / 61) {
      QByteArray damaged = whole;
      damaged[at] = static_cast<char>(damaged[at] ^ 0xff);
      test::writeBytes(cut, damaged);
      const auto image = readImage(cut, {PixelFormat::float32}, nullptr, {});
      QVERIFY(image || image.failed());
    }
  }
};

CUTIS_TEST(InkJpegTest)

}  // namespace
}  // namespace cutis

#include "ink_jpeg_test.moc"
