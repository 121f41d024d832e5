// Pictures as other programs write them, and files that are none.

#include <cstring>

#include <QtTest>

#include "src/images/image_file.h"
#include "tests/src/images/image_fixture.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

using test::ImageFolder;
using test::makeContent;
using test::pixelOf;

Result<Image> read(const std::filesystem::path& path) {
  return readImage(path, {PixelFormat::float32}, nullptr, {});
}

class ForeignImageTest : public QObject {
  Q_OBJECT

  ImageFolder folder_;

 private slots:
  void contentTellsTheKindNotTheName() {
    const ImageContent content = makeContent(40, 30, {"R", "G", "B"});
    EXPECT_OK(writeImage(folder_.path("real.png"), content, SampleType::uint16, {}));
    std::filesystem::rename(folder_.path("real.png"), folder_.path("really_png.jpg"));
    const auto image = read(folder_.path("really_png.jpg"));
    EXPECT_OK(image);
    QVERIFY(image.value().sourceType == SampleType::uint16);
  }

  // Tiles, crops and overscan as other programs write them.
  void tilesAndWindowsOfOthers() {
    for (const auto& [tileWidth, tileHeight] : {std::pair{16, 16}, {64, 32}, {512, 16}, {0, 0}}) {
      OIIO::ImageSpec spec(301, 283, 3, OIIO::TypeFloat);
      spec.tile_width = tileWidth;
      spec.tile_height = tileHeight;
      const std::vector<float> samples = test::noise(301 * 283 * 3);
      for (const auto& [name, format] :
           {std::pair{"tiled.exr", "openexr"}, {"tiled.tif", "tiff"}}) {
        test::writeForeign(folder_.path(name), format, spec, samples);
        const auto image = read(folder_.path(name));
        EXPECT_OK(image);
        for (const auto& [x, y] : {std::pair{0, 0}, {300, 282}, {17, 200}, {256, 256}}) {
          QCOMPARE(pixelOf(image.value().channels[2], x, y),
                   samples[static_cast<std::size_t>((y * 301 + x) * 3 + 2)]);
        }
      }
    }
    OIIO::ImageSpec cropped(60, 50, 3, OIIO::TypeHalf);
    cropped.x = -10;
    cropped.y = 30;
    cropped.full_x = 0;
    cropped.full_y = 0;
    cropped.full_width = 100;
    cropped.full_height = 300;
    test::writeForeign(folder_.path("crop.exr"), "openexr", cropped,
                       std::vector<float>(60 * 50 * 3, 0.5f));
    const auto image = read(folder_.path("crop.exr"));
    EXPECT_OK(image);
    QCOMPARE(image.value().width, 100);
    QCOMPARE(image.value().height, 300);
    QCOMPARE(pixelOf(image.value().channels[0], 0, 30), 0.5f);
    QCOMPARE(pixelOf(image.value().channels[0], 49, 79), 0.5f);
    QCOMPARE(pixelOf(image.value().channels[0], 50, 40), 0.0f);
    QCOMPARE(pixelOf(image.value().channels[0], 0, 29), 0.0f);
    QCOMPARE(pixelOf(image.value().channels[0], 0, 80), 0.0f);
  }

  void otherKindsAreRead() {
    const std::vector<float> samples(20 * 10 * 3, 0.2f);
    for (const auto& [name, format, type] : {std::tuple{"a.bmp", "bmp", OIIO::TypeUInt8},
                                             std::tuple{"a.tga", "targa", OIIO::TypeUInt8},
                                             std::tuple{"a.hdr", "hdr", OIIO::TypeFloat}}) {
      test::writeForeign(folder_.path(name), format, OIIO::ImageSpec(20, 10, 3, type), samples);
      const auto image = read(folder_.path(name));
      EXPECT_OK(image);
      EXPECT_NEAR(pixelOf(image.value().channels[1], 19, 9), 0.2, 0.002);
    }
  }

  void whatIsNoImageIsTold() {
    EXPECT_ERROR(read(folder_.path("missing.png")), "there is no such file");
    EXPECT_ERROR(read(folder_.root()), "this is a folder");
    test::writeBytes(folder_.path("empty.exr"), {});
    EXPECT_ERROR(read(folder_.path("empty.exr")), "the file is empty");
    test::writeBytes(folder_.path("text.png"), "hello, I am a text and no picture");
    EXPECT_ERROR(read(folder_.path("text.png")), "not an image of a supported kind");
    test::writeBytes(folder_.path("short.tif"), "I");
    EXPECT_ERROR(read(folder_.path("short.tif")), "not an image of a supported kind");
    test::writeBytes(folder_.path("photo.NEF"), QByteArray("II*\0", 4) + QByteArray(100, 'x'));
    EXPECT_ERROR(read(folder_.path("photo.NEF")), "raw photograph");
    EXPECT_ERROR(read("/dev/null"), "not a regular file");
  }

  void layoutsThatAreNoPictureAreRefused() {
    OIIO::ImageSpec deep(4, 4, 4, OIIO::TypeFloat);
    deep.deep = true;
    {
      auto output = OIIO::ImageOutput::create("openexr");
      QVERIFY(output->open(folder_.path("deep.exr").string(), deep));
    }
    const auto result = read(folder_.path("deep.exr"));
    QVERIFY(result.failed());
    EXPECT_ERROR(result, "deep");
    OIIO::ImageSpec many(2, 2, 300, OIIO::TypeHalf);
    test::writeForeign(folder_.path("many.exr"), "openexr", many,
                       std::vector<float>(2 * 2 * 300, 0.5f));
    EXPECT_ERROR(read(folder_.path("many.exr")), "300 channels; at most 256");
    OIIO::ImageSpec whole(4, 4, 3, OIIO::TypeInt16);
    test::writeForeign(folder_.path("int16.tif"), "tiff", whole, std::vector<float>(48, 0.5f));
    EXPECT_ERROR(read(folder_.path("int16.tif")), "int16");
  }

  // A header that promises far more than there is must cost nothing.
  void absurdSizesAreRefused() {
    ImageContent content = makeContent(8, 8, {"R", "G", "B"});
    EXPECT_OK(writeImage(folder_.path("small.exr"), content, SampleType::half, {}));
    QByteArray bytes = test::readBytes(folder_.path("small.exr"));
    for (const char* window : {"dataWindow", "displayWindow"}) {
      const auto at = bytes.indexOf(QByteArray(window) + QByteArray("\0box2i\0", 7)) +
                      static_cast<qsizetype>(std::strlen(window)) + 7 + 4;
      for (const int offset : {8, 12})
        bytes.replace(at + offset, 4, QByteArray("\xff\xff\xff\x0f"));
    }
    test::writeBytes(folder_.path("absurd.exr"), bytes);
    QVERIFY(read(folder_.path("absurd.exr")).failed());

    OIIO::ImageSpec wide(40000, 1, 1, OIIO::TypeUInt8);
    test::writeForeign(folder_.path("wide.tif"), "tiff", wide, std::vector<float>(40000, 0.5f));
    EXPECT_ERROR(read(folder_.path("wide.tif")), "at most 32768 a side");
  }

  void primariesOfOthersAreRecognised() {
    OIIO::ImageSpec spec(4, 4, 3, OIIO::TypeHalf);
    const float p3[8] = {0.68f, 0.32f, 0.265f, 0.69f, 0.15f, 0.06f, 0.3127f, 0.329f};
    spec.attribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8), p3);
    test::writeForeign(folder_.path("p3.exr"), "openexr", spec, std::vector<float>(48, 0.5f));
    QCOMPARE(readImageHeader(folder_.path("p3.exr"), {}).value().colors.stated(),
             std::string("Linear P3-D65"));
    const float odd[8] = {0.8f, 0.2f, 0.3f, 0.6f, 0.1f, 0.1f, 0.33f, 0.33f};
    spec.attribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8), odd);
    test::writeForeign(folder_.path("odd.exr"), "openexr", spec, std::vector<float>(48, 0.5f));
    QCOMPARE(readImageHeader(folder_.path("odd.exr"), {}).value().colors.stated(),
             std::string("linear RGB of the primaries 0.8 0.2 0.3 0.6 0.1 0.1 0.33 0.33"));
  }
};

CUTIS_TEST(ForeignImageTest)

}  // namespace
}  // namespace cutis

#include "foreign_image_test.moc"
