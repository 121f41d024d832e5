// The first impression of a picture is that picture, coarser.

#include "src/images/preview/image_preview.h"

#include <cmath>
#include <fstream>

#include <QtTest>

#include "core/spectra/colorimetry.h"
#include "tests/src/images/image_fixture.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {
namespace preview_test {

constexpr int kWidth = 1201;
constexpr int kHeight = 801;

// Encoded values of a smooth picture, so that a mean is what lies in the middle.
float encodedAt(int channel, double x, double y) {
  const double u = x / kWidth, v = y / kHeight;
  const double values[] = {0.3 + 0.5 * u, 0.2 + 0.5 * v, 0.6 - 0.3 * u * v};
  return static_cast<float>(values[channel]);
}

ImageContent content() {
  ImageContent content;
  content.channelNames = {"R", "G", "B"};
  for (int c = 0; c < 3; ++c) {
    content.channels.push_back(test::makePlane(
        kWidth, kHeight, [c](int x, int y) { return encodedAt(c, x + 0.5, y + 0.5); }));
  }
  return content;
}

double encodedSrgb(float linear) {
  return encodeSrgb(std::clamp(double{linear}, 0.0, 1.0));
}

}  // namespace preview_test

class ImagePreviewTest : public QObject {
  Q_OBJECT

  test::ImageFolder folder_;

 private slots:
  void aJpegIsSeenCoarsely() {
    const auto path = folder_.path("smooth.jpg");
    EXPECT_OK(writeImage(path, preview_test::content(), SampleType::uint8, {}));
    const auto preview = previewImage(path, {{}, {}, 300}, {});
    QVERIFY(preview.has_value());
    QCOMPARE(preview->width, preview_test::kWidth);
    QCOMPARE(preview->height, preview_test::kHeight);
    QCOMPARE(preview->step, 4);
    QCOMPARE(preview->columns, 301);
    QCOMPARE(preview->rows, 201);
    double worst = 0;
    for (int y = 0; y < 200; ++y) {
      for (int x = 0; x < 300; ++x) {
        for (int c = 0; c < 3; ++c) {
          const float linear =
              preview->colors[static_cast<std::size_t>(c)][static_cast<std::size_t>(301 * y + x)];
          const double expected = preview_test::encodedAt(c, 4 * x + 2, 4 * y + 2);
          worst = std::max(worst, std::abs(preview_test::encodedSrgb(linear) - expected));
        }
      }
    }
    EXPECT_AT_MOST(worst, 3.0 / 255);
  }

  // The same decision as for the whole picture.
  void aChosenColorSpaceCounts() {
    const auto path = folder_.path("chosen.jpg");
    EXPECT_OK(writeImage(path, preview_test::content(), SampleType::uint8, {}));
    const auto usual = previewImage(path, {{}, {}, 300}, {});
    const auto chosen = previewImage(path, {"Display P3", {}, 300}, {});
    QVERIFY(usual.has_value() && chosen.has_value());
    QVERIFY(usual->colors != chosen->colors);
    QVERIFY(!previewImage(path, {"no such space", {}, 300}, {}).has_value());
  }

  void whatIsSmallNeedsNone() {
    const auto path = folder_.path("small.jpg");
    EXPECT_OK(writeImage(path, preview_test::content(), SampleType::uint8, {}));
    QVERIFY(!previewImage(path, {}, {}).has_value());
  }

  // Reading the whole picture says what is wrong.
  void whatIsNoPictureHasNone() {
    const auto path = folder_.path("damaged.jpg");
    std::ofstream(path) << "\xff\xd8\xff\xe0 and no more";
    QVERIFY(!previewImage(path, {}, {}).has_value());
    QVERIFY(!previewImage(folder_.path("missing.jpg"), {}, {}).has_value());
  }

  void itStopsWhenAsked() {
    const auto path = folder_.path("stopped.jpg");
    EXPECT_OK(writeImage(path, preview_test::content(), SampleType::uint8, {}));
    std::stop_source stop;
    stop.request_stop();
    QVERIFY(!previewImage(path, {{}, {}, 300}, {stop.get_token(), {}, {}}).has_value());
  }
};

CUTIS_TEST(ImagePreviewTest)

}  // namespace
}  // namespace cutis

#include "image_preview_test.moc"
