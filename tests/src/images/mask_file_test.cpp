// Masks: where the shape is, how they lie, and what is said of those that change nothing.

#include "src/images/capture/mask_file.h"

#include <algorithm>
#include <array>

#include <QtTest>

#include "tests/src/images/image_fixture.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

using test::ImageFolder;
using test::pixelOf;

constexpr int kWidth = 6;
constexpr int kHeight = 4;

struct Pixel {
  float red = 0.0f;
  float green = 0.0f;
  float blue = 0.0f;
  float alpha = 1.0f;
};

class MaskFileTest : public QObject {
  Q_OBJECT

  ImageFolder folder_;
  test::Listener listener_;

  std::filesystem::path write(const std::string& name, int width, int height,
                              const std::function<Pixel(int x, int y)>& at,
                              AlphaKind alphaKind = AlphaKind::straight) {
    ImageContent content;
    content.channelNames = {"R", "G", "B", "A"};
    content.alphaKind = alphaKind;
    for (int c = 0; c < 4; ++c) {
      content.channels.push_back(test::makePlane(width, height, [&](int x, int y) {
        const Pixel pixel = at(x, y);
        return std::array{pixel.red, pixel.green, pixel.blue,
                          pixel.alpha}[static_cast<std::size_t>(c)];
      }));
    }
    const auto path = folder_.path(name);
    const bool isFloat = name.ends_with(".exr");
    if (!writeImage(path, content, isFloat ? SampleType::float32 : SampleType::uint16, {})) {
      qFatal("cannot write a mask");
    }
    return path;
  }

  Result<Plane> read(const std::filesystem::path& path,
                     MaskedPicture picture = {kWidth, kHeight, "'face'"}) {
    listener_.sentences.clear();
    return readMask(path, picture, nullptr, listener_.context());
  }

  bool wasSaid(const char* part) const {
    return std::any_of(
        listener_.sentences.begin(), listener_.sentences.end(),
        [&](const std::string& sentence) { return sentence.find(part) != std::string::npos; });
  }

 private Q_SLOTS:
  void theShapeIsFound_data() {
    QTest::addColumn<int>("kind");
    QTest::addColumn<double>("left");
    QTest::addColumn<double>("right");
    QTest::addColumn<QString>("said");
    QTest::newRow("white with its shape in alpha") << 0 << 1.0 << 0.0 << "";
    QTest::newRow("grey") << 1 << 0.75 << 0.25 << "";
    QTest::newRow("one colour") << 2 << 1.0 << 0.0 << "";
    QTest::newRow("one colour on another") << 3 << 1.0 << 0.0 << "";
    QTest::newRow("coloured") << 4 << 0.9278 << 0.0 << "the mask is coloured";
    QTest::newRow("alpha and another shape") << 5 << 1.0 << 0.5 << "was taken from its alpha";
    QTest::newRow("empty") << 6 << 0.0 << 0.0 << "the mask is empty";
    QTest::newRow("full") << 7 << 1.0 << 1.0 << "the mask is full";
    QTest::newRow("half everywhere") << 8 << 0.5 << 0.5 << "";
  }
  void theShapeIsFound() {
    QFETCH(int, kind);
    QFETCH(double, left);
    QFETCH(double, right);
    QFETCH(QString, said);
    const auto at = [&](int x, int y) -> Pixel {
      const bool in = x < kWidth / 2;
      const float shape = in ? 1.0f : 0.0f;
      switch (kind) {
        case 0:
          return {1, 1, 1, shape};
        case 1:
          return in ? Pixel{0.75f, 0.75f, 0.75f} : Pixel{0.25f, 0.25f, 0.25f};
        case 2:
          return {shape, 0, 0};
        case 3:
          return {0.5f, shape, 0.25f};
        case 4:
          return {shape, shape, 0};
        case 5:
          return {y < 2 ? 1.0f : 0.0f, 0, 0, in ? 1.0f : 0.5f};
        case 6:
          return {};
        case 7:
          return {1, 1, 1};
        default:
          return {0.5f, 0.5f, 0.5f};
      }
    };
    for (const char* name : {"mask.png", "mask.tif", "mask.exr"}) {
      const auto mask = read(write(name, kWidth, kHeight, at));
      EXPECT_OK(mask);
      EXPECT_NEAR(pixelOf(mask.value(), 0, 3), left, 1e-4);
      EXPECT_NEAR(pixelOf(mask.value(), 5, 3), right, 1e-4);
      QCOMPARE(listener_.sentences.size(), std::size_t{said.isEmpty() ? 0U : 1U});
      if (!said.isEmpty()) QVERIFY(wasSaid(qPrintable(said)));
    }
  }

  // Colours that were multiplied by an alpha without a shape are what they were.
  void coloursAreStraight() {
    const auto path = write(
        "even.exr", kWidth, kHeight,
        [](int x, int) -> Pixel {
          const float grey = x == 0 ? 0.4f : 0.0f;
          return {grey, grey, grey, 0.5f};
        },
        AlphaKind::associated);
    const auto mask = read(path);
    EXPECT_OK(mask);
    EXPECT_NEAR(pixelOf(mask.value(), 0, 0), 0.8, 1e-6);
  }

  void masksFitUprightAndLying_data() {
    QTest::addColumn<int>("tag");
    for (int tag = 5; tag <= 8; ++tag)
      QTest::addRow("orientation %d", tag) << tag;
  }
  void masksFitUprightAndLying() {
    QFETCH(int, tag);
    const Orientation orientation = orientationOf(tag);
    const MaskedPicture picture = {kWidth, kHeight, "'face'", {}, orientation};
    const auto upright = read(write("upright.png", kWidth, kHeight,
                                    [](int x, int y) -> Pixel {
                                      return {0, 0, 0, x == 4 && y == 1 ? 1.0f : 0.0f};
                                    }),
                              picture);
    EXPECT_OK(upright);
    QVERIFY(listener_.sentences.empty());
    QCOMPARE(pixelOf(upright.value(), 4, 1), 1.0f);
    // The same pixel where it lies in the file of the photograph.
    const auto lying = read(
        write("lying.png", kHeight, kWidth,
              [&](int x, int y) -> Pixel {
                const Rect to = uprightRect({x, y, x + 1, y + 1}, kHeight, kWidth, orientation);
                return {0, 0, 0, to.x0 == 4 && to.y0 == 1 ? 1.0f : 0.0f};
              }),
        picture);
    EXPECT_OK(lying);
    QVERIFY(wasSaid("lies like the picture in its file"));
    QVERIFY(test::valuesOf(lying.value()) == test::valuesOf(upright.value()));
  }

  // Size cannot tell upright from lying where both have the same.
  void masksOfTheSameSizeStandUpright_data() {
    QTest::addColumn<int>("tag");
    QTest::addColumn<int>("height");
    for (const int tag : {2, 3, 4}) {
      QTest::addRow("orientation %d", tag) << tag << kHeight;
      QTest::addRow("orientation %d of a square", tag) << tag << kWidth;
    }
    for (int tag = 5; tag <= 8; ++tag)
      QTest::addRow("orientation %d of a square", tag) << tag << kWidth;
  }
  void masksOfTheSameSizeStandUpright() {
    QFETCH(int, tag);
    QFETCH(int, height);
    const MaskedPicture picture = {kWidth, height, "'face'", {}, orientationOf(tag)};
    const auto mask = read(write("same.png", kWidth, height,
                                 [](int x, int y) -> Pixel {
                                   return {0, 0, 0, x == 4 && y == 1 ? 1.0f : 0.0f};
                                 }),
                           picture);
    EXPECT_OK(mask);
    QCOMPARE(pixelOf(mask.value(), 4, 1), 1.0f);
    QCOMPARE(listener_.sentences.size(), std::size_t{1});
    QVERIFY(wasSaid("the mask is taken to stand upright"));
  }

  void masksOfSeveralLayersAreRefused() {
    const auto path = folder_.path("layers.exr");
    test::writeForeignParts(path, {{"", {"a.R", "a.G", "a.B", "b.R", "b.G", "b.B"}}});
    EXPECT_ERROR(read(path, {4, 3, "'face'"}), "the mask has several layers with colours");
  }

  void othersDoNotFit() {
    const auto path = write("other.png", kHeight, kWidth, [](int, int) { return Pixel{}; });
    EXPECT_ERROR(read(path), "the mask is 4 × 6 pixels but 'face' is 6 × 4");
  }

  // A mask of the display window belongs there, and leaves out the overscan.
  void masksOfTheDisplayWindowFit() {
    const MaskedPicture picture = {
        kWidth + 4, kHeight + 3, "'face'", {1, 2, 1 + kWidth, 2 + kHeight}};
    const auto mask = read(write("display.png", kWidth, kHeight,
                                 [](int x, int) -> Pixel {
                                   return {0, 0, 0, x == 0 ? 0.5f : 1.0f};
                                 }),
                           picture);
    EXPECT_OK(mask);
    QVERIFY(wasSaid("covers the display window alone"));
    EXPECT_NEAR(pixelOf(mask.value(), 1, 2), 0.5, 1e-4);
    EXPECT_NEAR(pixelOf(mask.value(), 6, 5), 1.0, 1e-4);
    for (const auto& [x, y] : {std::pair{0, 3}, {7, 3}, {3, 1}, {3, 6}})
      QCOMPARE(pixelOf(mask.value(), x, y), 0.0f);
  }
};

CUTIS_TEST(MaskFileTest)

}  // namespace
}  // namespace cutis

#include "mask_file_test.moc"
