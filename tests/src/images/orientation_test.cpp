// Pictures that lie turned in their files are read upright, whatever says so.

#include "src/images/pixels/orientation.h"

#include <array>
#include <cstdint>

#include <OpenImageIO/imageio.h>
#include <QtTest>

#include "src/images/image_file.h"
#include "tests/src/images/image_fixture.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

using test::ImageFolder;
using test::pixelOf;

constexpr int kWidth = 301;
constexpr int kHeight = 270;

// Where the pixel (x, y) of the upright picture stands in the file, column and row: where the first
// row and the first column of the file belong (Exif 2.32, §4.6.4 Orientation). OpenImageIO 2.4
// turns 5 and 7 into each other.
std::array<int, 2> placeInFile(int tag, int x, int y) {
  constexpr int right = kWidth - 1, bottom = kHeight - 1;
  switch (tag) {
    case 2:  // top, right
      return {right - x, y};
    case 3:  // bottom, right
      return {right - x, bottom - y};
    case 4:  // bottom, left
      return {x, bottom - y};
    case 5:  // left, top
      return {y, x};
    case 6:  // right, top
      return {y, bottom - x};
    case 7:  // right, bottom
      return {right - y, bottom - x};
    case 8:  // left, bottom
      return {right - y, x};
    default:
      return {x, y};
  }
}

// All samples as the file holds them.
std::vector<float> storedSamples(const std::filesystem::path& path) {
  auto input = OIIO::ImageInput::open(path.string());
  std::vector<float> samples(static_cast<std::size_t>(kWidth * kHeight * 3));
  if (!input || !input->read_image(0, 0, 0, 3, OIIO::TypeFloat, samples.data())) return {};
  return samples;
}

class OrientationTest : public QObject {
  Q_OBJECT

  ImageFolder folder_;

 private Q_SLOTS:
  void partsAreWhatTheWholeIs_data() {
    QTest::addColumn<int>("tag");
    for (int tag = 1; tag <= 8; ++tag)
      QTest::addRow("orientation %d", tag) << tag;
  }
  // Turning piece by piece, as chunks of a file come, is turning the whole.
  void partsAreWhatTheWholeIs() {
    QFETCH(int, tag);
    const Orientation orientation = orientationOf(tag);
    const int width = 5, height = 4;
    std::vector<float> stored(20), whole(20), pieces(20, -1.0f);
    for (std::size_t i = 0; i < stored.size(); ++i)
      stored[i] = static_cast<float>(i);
    turnUpright(stored, width, height, orientation, whole);
    const int columns = swapsSides(orientation) ? height : width;
    for (const Rect& part : {Rect{0, 0, 5, 1}, Rect{0, 1, 2, 4}, Rect{2, 1, 5, 4}}) {
      std::vector<float> values, turned(part.pixelCount());
      for (int y = part.y0; y < part.y1; ++y) {
        for (int x = part.x0; x < part.x1; ++x)
          values.push_back(stored[static_cast<std::size_t>(y * width + x)]);
      }
      turnUpright(values, part.width(), part.height(), orientation, turned);
      const Rect to = uprightRect(part, width, height, orientation);
      std::size_t next = 0;
      for (int y = to.y0; y < to.y1; ++y) {
        for (int x = to.x0; x < to.x1; ++x)
          pieces[static_cast<std::size_t>(y * columns + x)] = turned[next++];
      }
    }
    QVERIFY(pieces == whole);
  }

  void numbersThatAreNoneAreUpright() {
    for (const int tag : {-1, 0, 9, 65535})
      QVERIFY(orientationOf(tag) == Orientation::upright);
  }

  void filesAreReadUpright_data() {
    QTest::addColumn<QString>("format");
    QTest::addColumn<int>("tag");
    for (const char* format : {"tiff", "jpeg", "png"}) {
      for (int tag = 1; tag <= 8; ++tag)
        QTest::addRow("%s %d", format, tag) << QString(format) << tag;
    }
  }
  // More than a tile each way.
  void filesAreReadUpright() {
    QFETCH(QString, format);
    QFETCH(int, tag);
    OIIO::ImageSpec spec(kWidth, kHeight, 3, OIIO::TypeUInt8);
    spec.attribute("Orientation", tag);
    const auto path = folder_.path("turned." + format.toStdString());
    test::writeForeign(path, format.toStdString(), spec, test::noise(kWidth * kHeight * 3));
    if (format == "png") test::addPngOrientation(path, tag);
    const auto image = readImage(path, {}, nullptr, {});
    EXPECT_OK(image);
    const bool swapped = tag >= 5;
    QCOMPARE(image.value().width, swapped ? kHeight : kWidth);
    QCOMPARE(image.value().height, swapped ? kWidth : kHeight);
    QCOMPARE(static_cast<int>(image.value().orientation), tag);
    const std::vector<float> stored = storedSamples(path);
    QVERIFY(!stored.empty());
    for (std::size_t c = 0; c < 3; ++c) {
      const std::vector<float> values = test::valuesOf(image.value().channels[c]);
      for (std::size_t i = 0; i < values.size(); ++i) {
        const int width = image.value().width, at = static_cast<int>(i);
        const auto [column, row] = placeInFile(tag, at % width, at / width);
        EXPECT_NEAR(values[i], stored[3 * static_cast<std::size_t>(row * kWidth + column) + c],
                    1e-6);
      }
    }
    // Written upright, and nothing says otherwise any more.
    ImageContent content;
    content.channelNames = image.value().channelNames;
    content.channels = image.value().channels;
    content.metadata = image.value().metadata;
    const auto again = folder_.path("upright." + format.toStdString());
    EXPECT_OK(writeImage(again, content, SampleType::uint8, {}));
    const auto header = readImageHeader(again, {});
    EXPECT_OK(header);
    QVERIFY(header.value().orientation == Orientation::upright);
    QCOMPARE(header.value().width, image.value().width);
  }

  // An attribute of that name in an OpenEXR file is somebody's remark.
  void openExrHasNone() {
    OIIO::ImageSpec spec(6, 4, 3, OIIO::TypeHalf);
    spec.attribute("Orientation", 6);
    test::writeForeign(folder_.path("remark.exr"), "openexr", spec, test::noise(6 * 4 * 3));
    const auto header = readImageHeader(folder_.path("remark.exr"), {});
    EXPECT_OK(header);
    QCOMPARE(header.value().width, 6);
    QVERIFY(header.value().orientation == Orientation::upright);
  }
};

CUTIS_TEST(OrientationTest)

}  // namespace
}  // namespace cutis

#include "orientation_test.moc"
