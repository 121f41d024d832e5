#include "src/images/image_file.h"

#include <cmath>
#include <limits>
#include <tuple>

#include <QtTest>

#include "src/files/io/file_extension.h"
#include "tests/src/images/image_fixture.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

using test::ImageFolder;
using test::makeContent;
using test::makePlane;
using test::pixelOf;
using test::valuesOf;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

Result<Image> read(const std::filesystem::path& path, const JobContext& context = {}) {
  return readImage(path, {PixelFormat::float32}, nullptr, context);
}

float largestDifference(const Plane& a, const Plane& b) {
  const std::vector<float> va = valuesOf(a), vb = valuesOf(b);
  float largest = va.size() == vb.size() ? 0.0f : kInfinity;
  for (std::size_t i = 0; i < std::min(va.size(), vb.size()); ++i) {
    largest = std::max(largest, std::abs(va[i] - vb[i]));
  }
  return largest;
}

bool contains(const std::string& sentence, const char* part) {
  return sentence.find(part) != std::string::npos;
}

class ImageFileTest : public QObject {
  Q_OBJECT

  ImageFolder folder_;

 private slots:
  void roundTrips_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<int>("type");
    QTest::addColumn<double>("step");  // between neighbouring values
    const auto row = [](const char* file, SampleType type, double step) {
      QTest::newRow(qPrintable(QString("%1 %2").arg(file).arg(static_cast<int>(type))))
          << QString(file) << static_cast<int>(type) << step;
    };
    row("a.png", SampleType::uint8, 1.0 / 255);
    row("b.png", SampleType::uint16, 1.0 / 65535);
    row("c.tif", SampleType::uint8, 1.0 / 255);
    row("d.TIFF", SampleType::uint16, 1.0 / 65535);
    row("e.tif", SampleType::float32, 0.0);
    row("f.exr", SampleType::half, 1.0 / 1024);
    row("g.EXR", SampleType::float32, 0.0);
  }
  void roundTrips() {
    QFETCH(QString, file);
    QFETCH(int, type);
    QFETCH(double, step);
    // Rounding to the nearest level, and to the nearest float on the way there and on the way back.
    const double tolerance = step > 0.0 ? 0.5 * step + 2 * 0x1p-25 : 0.0;
    for (const auto& channels :
         {std::vector<std::string>{"R", "G", "B"}, std::vector<std::string>{"R", "G", "B", "A"},
          std::vector<std::string>{"Y"}}) {
      // More than a tile each way, and no multiple of anything.
      ImageContent content = makeContent(301, 523, channels);
      const auto path = folder_.path(file.toStdString());
      const bool isExr =
          imageFormat(ImageFileKind::openExr).extensions.front() == lowerExtension(path);
      content.alphaKind = isExr ? AlphaKind::associated : AlphaKind::straight;
      EXPECT_OK(writeImage(path, content, static_cast<SampleType>(type), {}));
      const auto first = read(path);
      EXPECT_OK(first);
      const Image& image = first.value();
      QCOMPARE(image.width, 301);
      QCOMPARE(image.height, 523);
      QVERIFY(image.channelNames == channels);
      QVERIFY(image.sourceType == static_cast<SampleType>(type));
      QCOMPARE(image.contentHash.size(), std::size_t{32});
      for (std::size_t c = 0; c < channels.size(); ++c) {
        EXPECT_AT_MOST(largestDifference(image.channels[c], content.channels[c]), tolerance);
      }
      // What was read once comes back bit for bit.
      ImageContent again;
      again.channelNames = image.channelNames;
      again.channels = image.channels;
      again.alphaKind = image.alphaKind;
      EXPECT_OK(writeImage(path, again, static_cast<SampleType>(type), {}));
      const auto second = read(path);
      EXPECT_OK(second);
      for (std::size_t c = 0; c < channels.size(); ++c) {
        QVERIFY(valuesOf(second.value().channels[c]) == valuesOf(image.channels[c]));
      }
    }
  }

  void everyIntegerLevelSurvives() {
    for (const auto& [file, type, levels] :
         {std::tuple{"levels8.png", SampleType::uint8, 256},
          std::tuple{"levels8.tif", SampleType::uint8, 256},
          std::tuple{"levels16.png", SampleType::uint16, 65536},
          std::tuple{"levels16.tif", SampleType::uint16, 65536}}) {
      const int side = levels == 256 ? 16 : 256;
      const auto level = [&](int x, int y) {
        return static_cast<float>(y * side + x) / static_cast<float>(levels - 1);
      };
      ImageContent content;
      content.channelNames = {"Y"};
      content.channels = {makePlane(side, side, level)};
      EXPECT_OK(writeImage(folder_.path(file), content, type, {}));
      const auto image = read(folder_.path(file));
      EXPECT_OK(image);
      QVERIFY(valuesOf(image.value().channels[0]) == valuesOf(content.channels[0]));
    }
  }

  void jpegIsClose() {
    const ImageContent content = makeContent(100, 80, {"R", "G", "B"});
    EXPECT_OK(writeImage(folder_.path("a.jpg"), content, SampleType::uint8, {}));
    const auto image = read(folder_.path("a.jpg"));
    EXPECT_OK(image);
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_AT_MOST(largestDifference(image.value().channels[c], content.channels[c]), 0.08);
    }
  }

  void integersAreClampedAndRounded() {
    const std::vector<float> given = {kNan, kInfinity, -kInfinity, -0.3f,       1.7f,
                                      0.0f, 1.0f,      0.5f / 255, 0.49f / 255, 254.6f / 255};
    const std::vector<int> expected = {0, 255, 0, 0, 255, 0, 255, 1, 0, 255};
    ImageContent content;
    content.channelNames = {"Y"};
    content.channels = {
        makePlane(10, 1, [&](int x, int) { return given[static_cast<std::size_t>(x)]; })};
    for (const char* file : {"edge.png", "edge.tif"}) {
      EXPECT_OK(writeImage(folder_.path(file), content, SampleType::uint8, {}));
      const auto image = read(folder_.path(file));
      EXPECT_OK(image);
      for (int x = 0; x < 10; ++x) {
        EXPECT_NEAR(pixelOf(image.value().channels[0], x, 0) * 255.0f,
                    expected[static_cast<std::size_t>(x)], 1e-4);
      }
    }
  }

  void floatsAreKeptAsTheyAre() {
    const std::vector<float> given = {kNan, kInfinity, -kInfinity, -0.25f, 3.5f, 1e-30f, 65504.0f};
    ImageContent content;
    content.channelNames = {"R", "G", "B"};
    const Plane plane =
        makePlane(7, 1, [&](int x, int) { return given[static_cast<std::size_t>(x)]; });
    content.channels = {plane, plane, plane};
    for (const auto& [file, type] :
         {std::pair{"f.exr", SampleType::float32}, std::pair{"f.tif", SampleType::float32},
          std::pair{"h.exr", SampleType::half}}) {
      EXPECT_OK(writeImage(folder_.path(file), content, type, {}));
      const auto image = read(folder_.path(file));
      EXPECT_OK(image);
      for (int x = 0; x < 7; ++x) {
        const float value = pixelOf(image.value().channels[1], x, 0);
        const float wanted = given[static_cast<std::size_t>(x)];
        if (x == 5 && type == SampleType::half) {
          QCOMPARE(value, 0.0f);
        } else {
          QVERIFY(std::isnan(wanted) ? std::isnan(value) : value == wanted);
        }
      }
    }
  }

  // Each format in its own convention, whatever the content's; alpha 0 keeps its colour.
  void alphaIsWrittenAsTheFormatHasIt() {
    const std::vector<float> alphas = {1.0f, 0.5f, 0.25f, 0.0f};
    const auto alphaAt = [&](int x, int) { return alphas[static_cast<std::size_t>(x)]; };
    for (const AlphaKind given : {AlphaKind::straight, AlphaKind::associated}) {
      ImageContent content;
      content.channelNames = {"R", "G", "B", "A"};
      content.alphaKind = given;
      const auto straight = [](int x) { return x == 3 ? 0.8f : 0.4f; };
      for (int c = 0; c < 3; ++c) {
        content.channels.push_back(makePlane(4, 4, [&](int x, int y) {
          const float alpha = alphaAt(x, y);
          return straight(x) * (given == AlphaKind::associated && alpha > 0.0f ? alpha : 1.0f);
        }));
      }
      content.channels.push_back(makePlane(4, 4, alphaAt));
      for (const auto& [file, type, kind] :
           {std::tuple{"a.png", SampleType::uint16, AlphaKind::straight},
            std::tuple{"a.tif", SampleType::float32, given},
            std::tuple{"a.exr", SampleType::float32, AlphaKind::associated}}) {
        test::Listener listener;
        EXPECT_OK(writeImage(folder_.path(file), content, type, listener.context()));
        const auto image = read(folder_.path(file));
        EXPECT_OK(image);
        QVERIFY(image.value().alphaKind == kind);
        for (int x = 0; x < 4; ++x) {
          const float factor =
              kind == AlphaKind::associated && x < 3 ? alphas[static_cast<std::size_t>(x)] : 1.0f;
          EXPECT_NEAR(pixelOf(image.value().channels[1], x, 2), straight(x) * factor, 1e-4);
          EXPECT_NEAR(pixelOf(image.value().channels[3], x, 2), alphaAt(x, 2), 1e-4);
        }
        const bool hidden = given == AlphaKind::straight && kind == AlphaKind::associated;
        QCOMPARE(listener.sentences.size(), std::size_t{hidden ? 1U : 0U});
        if (hidden) QVERIFY(contains(listener.sentences[0], "4 pixels with alpha 0 have a colour"));
      }
    }
  }

  void clippingIsCountedAndSaid() {
    ImageContent content;
    content.channelNames = {"R", "G", "B"};
    for (int c = 0; c < 3; ++c) {
      content.channels.push_back(makePlane(5, 2, [&](int x, int y) {
        if (x == 0 && y == 0) return 1.5f;              // all three channels: one pixel
        if (x == 1 && y == 0 && c == 0) return -0.25f;  // one channel
        return x == 2 ? 1.0f + 0.2f / 255.0f : 0.5f;    // rounds to the largest
      }));
    }
    test::Listener listener;
    EXPECT_OK(writeImage(folder_.path("cut.png"), content, SampleType::uint8, listener.context()));
    QCOMPARE(listener.sentences.size(), std::size_t{1});
    QVERIFY(contains(listener.sentences[0],
                     "the values of 2 pixels lie beyond what 8 bit samples hold and were clipped"));
    listener.sentences.clear();
    EXPECT_OK(writeImage(folder_.path("cut.exr"), content, SampleType::half, listener.context()));
    QVERIFY(listener.sentences.empty());
  }

  void whatIsNoNumberIsCountedAndSaid() {
    ImageContent content;
    content.channelNames = {"R", "G", "B"};
    for (int c = 0; c < 3; ++c) {
      content.channels.push_back(makePlane(5, 2, [&](int x, int y) {
        if (x == 0 && y == 0) return std::numeric_limits<float>::quiet_NaN();
        if (x == 1 && y == 0 && c == 0) return std::numeric_limits<float>::quiet_NaN();
        return x == 2 && y == 1 ? std::numeric_limits<float>::infinity() : 0.5f;
      }));
    }
    for (const char* name : {"nan.png", "nan.tif"}) {
      test::Listener listener;
      EXPECT_OK(writeImage(folder_.path(name), content, SampleType::uint16, listener.context()));
      QCOMPARE(listener.sentences.size(), std::size_t{2});
      QVERIFY(contains(listener.sentences[0], "the values of 1 pixel lie beyond"));
      QVERIFY(contains(listener.sentences[1],
                       "2 pixels have values that are no number (NaN), which 16 bit samples do not "
                       "have, and became 0"));
    }
    test::Listener listener;
    EXPECT_OK(writeImage(folder_.path("nan.exr"), content, SampleType::half, listener.context()));
    QVERIFY(listener.sentences.empty());
  }

  void channelsAreFoundByName() {
    ImageContent content;
    content.channelNames = {"zebra", "B", "A", "R", "mask.inner", "G"};
    content.alphaKind = AlphaKind::associated;  // as OpenEXR has it
    for (int c = 0; c < 6; ++c) {
      content.channels.push_back(
          makePlane(5, 5, [&](int, int) { return static_cast<float>(c) / 8.0f; }));
    }
    EXPECT_OK(writeImage(folder_.path("order.exr"), content, SampleType::float32, {}));
    const auto image = read(folder_.path("order.exr"));
    EXPECT_OK(image);
    QCOMPARE(image.value().channels.size(), std::size_t{6});
    for (std::size_t c = 0; c < 6; ++c) {
      const int at = image.value().channelIndex(content.channelNames[c]);
      QVERIFY(at >= 0);
      QCOMPARE(pixelOf(image.value().channels[static_cast<std::size_t>(at)], 2, 2),
               static_cast<float>(c) / 8.0f);
    }
    QCOMPARE(image.value().channelIndex("nothing"), -1);
  }

  void channelsWithoutAPlaceAreLeftOutAndSaid() {
    ImageContent content;
    content.channelNames = {"depth", "A", "B", "G", "R"};
    for (int c = 0; c < 5; ++c) {
      content.channels.push_back(
          makePlane(4, 4, [&](int, int) { return static_cast<float>(c) / 5.0f; }));
    }
    test::Listener listener;
    EXPECT_OK(writeImage(folder_.path("few.png"), content, SampleType::uint8, listener.context()));
    QCOMPARE(listener.sentences.size(), std::size_t{1});
    const auto png = read(folder_.path("few.png"));
    EXPECT_OK(png);
    QVERIFY(png.value().channelNames == (std::vector<std::string>{"R", "G", "B", "A"}));
    for (const auto& [channel, level] : {std::pair{0, 4}, {1, 3}, {2, 2}, {3, 1}}) {
      EXPECT_NEAR(pixelOf(png.value().channels[static_cast<std::size_t>(channel)], 1, 1),
                  level / 5.0, 1e-6);
    }
    EXPECT_OK(writeImage(folder_.path("few.jpg"), content, SampleType::uint8, listener.context()));
    QCOMPARE(read(folder_.path("few.jpg")).value().channels.size(), std::size_t{3});
    EXPECT_OK(writeImage(folder_.path("all.tif"), content, SampleType::uint8, listener.context()));
    const auto tiff = read(folder_.path("all.tif"));
    QCOMPARE(tiff.value().channels.size(), std::size_t{5});
    EXPECT_NEAR(pixelOf(tiff.value().channels[0], 1, 1), 0.8, 1e-6);  // red first
    EXPECT_NEAR(pixelOf(tiff.value().channels[4], 1, 1), 0.0, 1e-6);
  }

  void headersAreReadAlone() {
    const ImageContent content = makeContent(40, 30, {"R", "G", "B"});
    EXPECT_OK(writeImage(folder_.path("head.exr"), content, SampleType::half, {}));
    const auto header = readImageHeader(folder_.path("head.exr"), {});
    EXPECT_OK(header);
    QCOMPARE(header.value().width, 40);
    QCOMPARE(header.value().height, 30);
    QVERIFY(header.value().sourceType == SampleType::half);
  }

  void formatsSayWhatTheyCannotHold() {
    const ImageContent content = makeContent(4, 4, {"R", "G", "B"});
    const auto refused = [&](const char* file, SampleType type) {
      return writeImage(folder_.path(file), content, type, {});
    };
    EXPECT_ERROR(refused("x.png", SampleType::float32), "PNG does not hold samples of type float");
    EXPECT_ERROR(refused("x.png", SampleType::half), "choose 8 bit, 16 bit");
    EXPECT_ERROR(refused("x.exr", SampleType::uint8), "choose half, float");
    EXPECT_ERROR(refused("x.jpg", SampleType::uint16), "JPEG");
    EXPECT_ERROR(refused("x.tif", SampleType::half), "TIFF");
    EXPECT_ERROR(refused("x.bmp", SampleType::uint8), ".exr, .tif, .png or .jpg");
    EXPECT_ERROR(refused("noextension", SampleType::uint8), ".exr, .tif, .png or .jpg");
    QVERIFY(refused("x.bmp", SampleType::uint8).error().kind == ErrorKind::usage);
    EXPECT_ERROR(refused("nowhere/x.png", SampleType::uint8), "does not exist");
    QVERIFY(writableSampleTypes("x.exr").value().front() == SampleType::half);
  }

  void colorSpacesAreFoundAgain() {
    ImageContent content = makeContent(4, 4, {"R", "G", "B"});
    const auto spaceAfter = [&](const char* file, SampleType type, const char* space) {
      content.colorSpace = *space == 0 ? ColorSpace() : builtInColorSpace(space);
      test::Listener listener;
      const auto path = folder_.path(file);
      if (!writeImage(path, content, type, listener.context())) return std::string("not written");
      const std::string found = readImageHeader(path, {}).value().colors.stated();
      return listener.sentences.empty() ? found : "said: " + found;
    };
    const auto is = [&](const char* file, SampleType type, const char* space, const char* found) {
      QCOMPARE(spaceAfter(file, type, space), std::string(found));
    };
    is("c.exr", SampleType::half, "ACEScg", "ACEScg");
    is("c.exr", SampleType::half, "sRGB", "sRGB");
    is("c.exr", SampleType::half, "Linear Rec.709", "Linear Rec.709");
    is("c.exr", SampleType::half, "", "");
    is("c.png", SampleType::uint8, "sRGB", "sRGB");
    is("c.png", SampleType::uint16, "Linear Rec.709", "Linear Rec.709");
    is("c.png", SampleType::uint16, "ACEScg", "ACEScg");
    is("c.tif", SampleType::uint16, "sRGB", "sRGB");
    is("c.tif", SampleType::float32, "Linear Rec.709", "Linear Rec.709");
    is("c.tif", SampleType::float32, "ACEScg", "ACEScg");
    is("c.tif", SampleType::float32, "Raw", "said: ");
    is("c.jpg", SampleType::uint8, "Display P3", "Display P3");
    is("c.jpg", SampleType::uint8, "sRGB", "sRGB");
  }

  void hashesFollowTheBytes() {
    const ImageContent content = makeContent(20, 20, {"R", "G", "B"});
    EXPECT_OK(writeImage(folder_.path("h1.png"), content, SampleType::uint8, {}));
    std::filesystem::copy_file(folder_.path("h1.png"), folder_.path("h2.png"));
    EXPECT_OK(writeImage(folder_.path("h3.png"), makeContent(20, 20, {"R", "G", "B"}, 7),
                         SampleType::uint8, {}));
    const std::string first = read(folder_.path("h1.png")).value().contentHash;
    QCOMPARE(read(folder_.path("h2.png")).value().contentHash, first);
    QVERIFY(read(folder_.path("h3.png")).value().contentHash != first);
  }

  void planesMaySpillAndBeHalf() {
    const ImageContent content = makeContent(600, 600, {"R", "G", "B"});
    EXPECT_OK(writeImage(folder_.path("spill.exr"), content, SampleType::half, {}));
    const auto store = std::make_shared<TileStore>(std::size_t{1} << 18);
    const auto image = readImage(folder_.path("spill.exr"), {PixelFormat::half}, store, {});
    EXPECT_OK(image);
    QVERIFY(image.value().channels[0].format() == PixelFormat::half);
    QVERIFY(store->statistics().tilesWritten > 0);
    EXPECT_AT_MOST(largestDifference(image.value().channels[0], content.channels[0]), 0.0005);
  }

  void stopsWhenAsked() {
    const ImageContent content = makeContent(400, 900, {"R", "G", "B"});
    EXPECT_OK(writeImage(folder_.path("long.tif"), content, SampleType::float32, {}));
    test::Stopper reading;
    QVERIFY(read(folder_.path("long.tif"), reading.context()).cancelled());
    for (const auto& [file, type] :
         {std::pair{"stop.png", SampleType::uint8}, std::pair{"stop.exr", SampleType::float32},
          std::pair{"stop.tif", SampleType::float32}, std::pair{"stop.jpg", SampleType::uint8}}) {
      test::Stopper writing;
      QVERIFY(writeImage(folder_.path(file), content, type, writing.context()).cancelled());
      QVERIFY(!std::filesystem::exists(folder_.path(file)));
    }
    for (const std::string& name : folder_.names()) {
      QVERIFY2(name.find("partial") == std::string::npos, name.c_str());
    }
  }
};

CUTIS_TEST(ImageFileTest)

}  // namespace
}  // namespace cutis

#include "image_file_test.moc"
