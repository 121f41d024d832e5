// What a capture declares its photographs' numbers to be, and what they say of themselves.

#include <QtTest>

#include "src/color/color_space.h"
#include "src/color/icc_profile.h"
#include "src/images/capture/capture_file.h"
#include "src/images/image_file.h"
#include "tests/src/images/image_fixture.h"
#include "tests/support/expect.h"
#include "tests/support/icc_bytes.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

class CaptureEncodingTest : public QObject {
  Q_OBJECT

  test::ImageFolder folder_;

  // A capture of one 16-bit PNG file of this space, level 0.5 in its numbers. Only "linear" is of
  // the first version.
  Result<Capture> declared(const std::string& encoding, const ColorSpace& space) {
    ImageContent content;
    content.channelNames = {"R", "G", "B"};
    content.channels.assign(3, test::makePlane(20, 10, [](int, int) { return 0.5f; }));
    content.colorSpace = space;
    CUTIS_CHECK(writeImage(folder_.path("white.png"), content, SampleType::uint16, {}));
    const std::string text = std::string("{ \"cutis_capture\": ") +
                             (encoding == "linear" ? "1" : "2") +
                             ", \"rig\": \"monitor\", \"encoding\": \"" + encoding +
                             "\", \"images\": [{\"light\": \"white\", \"file\": \"white.png\"}] }";
    test::writeBytes(folder_.path("capture.json"), QByteArray::fromStdString(text));
    return readCapture(folder_.root(), {}, nullptr, {});
  }

  // What the photograph reads in the middle.
  static float whiteOf(const Result<Capture>& capture) {
    return test::pixelOf(capture.value().measurements.channels[0], 7, 3);
  }

 private slots:
  void declarationAndFilesAreCompared() {
    EXPECT_OK(declared("linear", {}));
    EXPECT_OK(declared("linear", builtInColorSpace("Linear Rec.709")));
    EXPECT_ERROR(declared("linear", builtInColorSpace("sRGB")),
                 "the capture declares its photographs linear, but this one is sRGB, as its sRGB "
                 "chunk says; write \"cutis_capture\": 2 and \"encoding\": \"sRGB\" into "
                 "capture.json if that is so, or \"raw\" if its numbers are proportional to light");
    const ColorSpace odd =
        readIccProfile(test::matrixProfile(4, kRec709.chromaticities, test::curveTag({461}), "odd"),
                       "odd")
            .value()
            .space;
    EXPECT_ERROR(declared("linear", odd),
                 "as its ICC profile 'odd' says; save it as linear if that is so, or write "
                 "\"cutis_capture\": 2 and \"encoding\": \"raw\" into capture.json");
    EXPECT_ERROR(declared("linear", builtInColorSpace("Display P3")),
                 "is Display P3, as its cICP chunk says");
    EXPECT_ERROR(declared("sRGB", builtInColorSpace("Linear Rec.709")),
                 "the capture declares its photographs sRGB, but this one is Linear Rec.709");
  }

  // In version 2 the curve of a colour space is undone, and nothing else of it.
  void encodingsAreUndone() {
    EXPECT_NEAR(whiteOf(declared("linear", {})), 0.5, 1e-4);
    for (const char* name : {"sRGB", "Gamma 2.2 Rec.709"}) {
      const auto capture = declared("sRGB", builtInColorSpace(name));
      EXPECT_OK(capture);
      EXPECT_NEAR(whiteOf(capture), 0.21404, 1e-4);
      QCOMPARE(capture.value().encoding, std::string("sRGB"));
      QCOMPARE(test::pixelOf(capture.value().measurements.state, 7, 3), 0.0f);
    }
    EXPECT_NEAR(whiteOf(declared("Display P3", builtInColorSpace("Display P3"))), 0.21404, 1e-4);
    EXPECT_NEAR(whiteOf(declared("raw", builtInColorSpace("sRGB"))), 0.5, 1e-4);
    EXPECT_NEAR(whiteOf(declared("sRGB", {})), 0.21404, 1e-4);
    EXPECT_ERROR(declared("sRBG", {}), "encoding: unknown colour space 'sRBG'");
  }
};

CUTIS_TEST(CaptureEncodingTest)

}  // namespace
}  // namespace cutis

#include "capture_encoding_test.moc"
