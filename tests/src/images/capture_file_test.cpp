#include "src/images/capture/capture_file.h"

#include <cmath>
#include <limits>

#include <OpenImageIO/imageio.h>
#include <QtTest>

#include "core/skin/pixel_state.h"
#include "src/images/image_file.h"
#include "tests/src/images/image_fixture.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

namespace fs = std::filesystem;
using test::ImageFolder;
using test::makeContent;
using test::makePlane;
using test::pixelOf;
using test::valuesOf;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

Result<Capture> read(const fs::path& path, const CaptureReadOptions& options = {}) {
  return readCapture(path, options, nullptr, {});
}

const char kThreeLights[] = R"({ "cutis_capture": 1, "rig": "monitor", "encoding": "linear",
  "images": [ {"light": "white+green", "file": "green.exr"},
              {"light": "white", "file": "white.exr"},
              {"light": "white+blue", "file": "sub/blue.exr", "scale": [2, 1, 0.5]} ] })";

// A new capture in each test.
class CaptureFileTest : public QObject {
  Q_OBJECT

  std::unique_ptr<ImageFolder> folder_;

  fs::path path(const std::string& name) const { return folder_->path(name); }

  void describe(QByteArray text, const char* replace = "", const char* by = "") {
    if (*replace != '\0') {
      QVERIFY(text.contains(replace));
      text.replace(replace, by);
    }
    test::writeBytes(path("capture.json"), text);
  }

  void photograph(const std::string& name, float level, int width = 20, int height = 10) {
    ImageContent content;
    content.channelNames = {"R", "G", "B"};
    for (int c = 0; c < 3; ++c) {
      content.channels.push_back(makePlane(
          width, height, [&](int, int) { return level * (1.0f - 0.25f * static_cast<float>(c)); }));
    }
    QVERIFY(writeImage(path(name), content, SampleType::half, {}));
  }

  // What the capture's errors say when one thing in its description is replaced.
  Result<Capture> readWith(const char* replace, const char* by) {
    describe(kThreeLights, replace, by);
    return read(folder_->root());
  }

  Measurements simulated(int width, int height) const {
    Measurements measurements;
    measurements.rig = test::monitorRig();
    for (int c = 0; c < 9; ++c) {
      measurements.channels.push_back(makePlane(width, height, [&](int x, int y) {
        return 0.1f + 0.05f * static_cast<float>(c) + 1e-3f * static_cast<float>(x + y);
      }));
    }
    measurements.state = Plane(width, height, PixelFormat::half);
    return measurements;
  }

 private slots:
  void init() {
    folder_ = std::make_unique<ImageFolder>();
    fs::create_directory(path("sub"));
    photograph("white.exr", 0.5f);
    photograph("green.exr", 0.4f);
    photograph("sub/blue.exr", 0.25f);
    describe(kThreeLights);
  }

  // What lies beside a photograph's data window was not measured.
  void pixelsBesideWhatIsStoredAreLeftOut() {
    OIIO::ImageSpec spec(16, 10, 3, OIIO::TypeHalf);
    spec.x = 4;
    spec.full_width = 20;
    spec.full_height = 10;
    const std::vector<float> pixels(16 * 10 * 3, 0.4f);
    const auto file = OIIO::ImageOutput::create("green.exr");
    QVERIFY(file && file->open(path("green.exr").string(), spec));
    QVERIFY(file->write_image(OIIO::TypeFloat, pixels.data()) && file->close());
    const auto capture = read(folder_->root());
    EXPECT_OK(capture);
    const Plane& state = capture.value().measurements.state;
    QCOMPARE(pixelOf(state, 3, 5), storedState(PixelState::masked));
    QCOMPARE(pixelOf(state, 4, 5), storedState(PixelState::solved));
  }

  void channelsComeInTheOrderOfTheRig() {
    for (const fs::path& name : {folder_->root(), path("capture.json")}) {
      const auto capture = read(name);
      EXPECT_OK(capture);
      const Measurements& m = capture.value().measurements;
      QCOMPARE(m.width(), 20);
      QCOMPARE(m.channels.size(), std::size_t{9});
      QCOMPARE(m.rig.channelName(3), std::string("white+blue.R"));
      const std::array<float, 9> expected = {0.5f,    0.375f, 0.25f, 0.5f, 0.1875f,
                                             0.0625f, 0.4f,   0.3f,  0.2f};
      for (std::size_t c = 0; c < 9; ++c) {
        EXPECT_NEAR(pixelOf(m.channels[c], 7, 3), expected[c], 2e-4);
      }
      QCOMPARE(pixelOf(m.state, 0, 0), 0.0f);
      QCOMPARE(capture.value().sources.size(), std::size_t{3});
      QCOMPARE(capture.value().sources[1].file, std::string("sub/blue.exr"));
      QCOMPARE(capture.value().sources[1].hash.size(), std::size_t{32});
    }
    QVERIFY(looksLikeCapture(folder_->root()));
    QVERIFY(looksLikeCapture(path("capture.json")));
    QVERIFY(!looksLikeCapture(path("white.exr")));
  }

  void fewerLightsMakeASmallerRig() {
    describe(R"({"cutis_capture": 1, "rig": "monitor", "encoding": "linear",
                 "images": [{"light": "white+blue", "file": "sub/blue.exr"}]})");
    const auto one = read(folder_->root());
    EXPECT_OK(one);
    QCOMPARE(one.value().measurements.rig.lights.size(), std::size_t{1});
    QCOMPARE(one.value().measurements.channels.size(), std::size_t{3});
    describe(kThreeLights);
    const auto two = read(folder_->root(), {.lights = {"white+green", "white"}});
    EXPECT_OK(two);
    QCOMPARE(two.value().measurements.rig.channelName(0), std::string("white.R"));
    QCOMPARE(two.value().measurements.rig.channelName(3), std::string("white+green.R"));
    EXPECT_ERROR(read(folder_->root(), {.lights = {"infrared"}}), "no photograph under 'infrared'");
    EXPECT_ERROR(read(folder_->root(), {.rig = "monitr"}), "rig: unknown rig 'monitr'");
  }

  void statesFollowThePixels() {
    ImageContent content;
    content.channelNames = {"R", "G", "B"};
    const std::vector<float> red = {0.5f, kNan, -0.1f, 0.0f, 65504.0f, 0.5f};
    for (int c = 0; c < 3; ++c) {
      content.channels.push_back(makePlane(
          6, 1, [&](int x, int) { return x == 3 ? 0.0f : red[static_cast<std::size_t>(x)]; }));
    }
    EXPECT_OK(writeImage(path("white.exr"), content, SampleType::float32, {}));
    ImageContent mask;
    mask.channelNames = {"Y"};
    mask.channels = {makePlane(6, 1, [](int x, int) { return x == 5 ? 0.0f : 0.5f; })};
    EXPECT_OK(writeImage(path("mask.png"), mask, SampleType::uint8, {}));
    describe(R"({"cutis_capture": 1, "rig": "monitor", "encoding": "linear", "mask": "mask.png",
                 "images": [{"light": "white", "file": "white.exr"}]})");
    const auto capture = read(folder_->root());
    EXPECT_OK(capture);
    // solved, NaN, negative, black, bright but not clipped (a float has no end), masked
    QVERIFY(valuesOf(capture.value().measurements.state) == (std::vector<float>{0, 2, 2, 2, 0, 1}));
  }

  void theEndOfAnIntegerRangeIsSaturated() {
    for (const auto& [file, type, top] : {std::tuple{"white.png", SampleType::uint8, 255.0f},
                                          std::tuple{"white.tif", SampleType::uint16, 65535.0f}}) {
      ImageContent content;
      content.channelNames = {"R", "G", "B"};
      for (int c = 0; c < 3; ++c) {
        content.channels.push_back(makePlane(3, 1, [&, t = top](int x, int) {
          return c == 1 ? (t - static_cast<float>(x)) / t : 0.25f;
        }));
      }
      EXPECT_OK(writeImage(path(file), content, type, {}));
      // A scale that moves the end of the range to another number.
      describe(QByteArray(R"({"cutis_capture": 1, "rig": "monitor", "encoding": "linear",
                 "images": [{"light": "white", "file": "FILE", "scale": [0.5, 0.5, 3]}]})")
                   .replace("FILE", file));
      const auto capture = read(folder_->root());
      EXPECT_OK(capture);
      const Measurements& m = capture.value().measurements;
      QVERIFY(valuesOf(m.state) == (std::vector<float>{3, 0, 0}));
      EXPECT_NEAR(pixelOf(m.channels[2], 1, 0), 0.75, 0.01);
      EXPECT_NEAR(pixelOf(m.channels[1], 2, 0), 0.5 * (top - 2) / top, 1e-6);
    }
  }

  void integersAreTakenAsLinear() {
    ImageContent content = makeContent(4, 4, {"R", "G", "B"});
    content.channels[0] = makePlane(4, 4, [](int, int) { return 128.0f / 255.0f; });
    EXPECT_OK(writeImage(path("white.jpg"), content, SampleType::uint8, {}));
    EXPECT_OK(writeImage(path("white.png"), content, SampleType::uint8, {}));
    describe(R"({"cutis_capture": 1, "rig": "monitor", "encoding": "linear",
                 "images": [{"light": "white", "file": "white.png"}]})");
    const auto capture = read(folder_->root());
    EXPECT_OK(capture);
    QCOMPARE(pixelOf(capture.value().measurements.channels[0], 1, 1), 128.0f / 255.0f);
  }

  void fieldsAreChecked() {
    EXPECT_ERROR(readWith("\"cutis_capture\": 1", "\"cutis_capture\": 3"), "newer version");
    EXPECT_ERROR(readWith("\"cutis_capture\": 1,", ""), "cutis_capture");
    EXPECT_ERROR(
        readWith("\"linear\"", "\"sRGB\""),
        "encoding must be \"linear\"; for the name of a colour space set cutis_capture to 2");
    EXPECT_ERROR(readWith("\"encoding\": \"linear\",", ""), "encoding must be a text");
    EXPECT_ERROR(readWith("\"encoding\"", "\"chart\": {}, \"encoding\""),
                 "charts are not supported by this version; use scale");
    EXPECT_ERROR(readWith("\"encoding\"", "\"encodng\": 1, \"encoding\""),
                 "unknown field 'encodng'");
    EXPECT_ERROR(readWith("\"monitor\"", "\"monitr\""), "did you mean 'monitor'");
    EXPECT_ERROR(readWith("\"white+green\"", "\"white+gren\""),
                 "images[0].light must be a light of rig 'monitor', not 'white+gren'; did you mean "
                 "'white+green'?");
    EXPECT_ERROR(readWith("\"white+green\"", "\"white\""), "images[1].light");
    EXPECT_ERROR(readWith("\"white+green\"", "\"white\""), "keep 'green.exr' or 'white.exr'");
    EXPECT_ERROR(readWith("[2, 1, 0.5]", "[2, 1]"), "images[2].scale must be a list of three");
    EXPECT_ERROR(readWith("[2, 1, 0.5]", "[2, 0, 1]"), "images[2].scale[1] must be positive");
    EXPECT_ERROR(readWith("[2, 1, 0.5]", "[2, \"x\", 1]"), "scale[1] must be a finite number");
    EXPECT_ERROR(readWith("\"scale\"", "\"scales\""), "unknown field 'images[2].scales'");
    EXPECT_ERROR(readWith("\"white.exr\"", "7"), "images[1].file must be a text");
    EXPECT_ERROR(readWith("\"white.exr\"", "\"whte.exr\""), "there is no such file");
    EXPECT_ERROR(readWith(" ] }", " ], }"), "capture.json:4:");
    describe(R"({"cutis_capture": 1, "rig": "monitor", "encoding": "linear", "images": []})");
    EXPECT_ERROR(read(folder_->root()), "images must be a list of at least one image");
    describe(R"({"cutis_capture": 1, "rig": "monitor", "encoding": "linear", "images": ["a"]})");
    EXPECT_ERROR(read(folder_->root()), "images[0] must be an object");
    fs::remove(path("capture.json"));
    EXPECT_ERROR(read(folder_->root()), "there is no capture.json in this folder");
    EXPECT_ERROR(read(path("nowhere")), "there is no such file");
  }

  void photographsAreChecked() {
    photograph("green.exr", 0.4f, 21, 10);
    const auto sizes = read(folder_->root());
    EXPECT_ERROR(sizes, "green.exr");
    EXPECT_ERROR(sizes, "'white.exr' is 20 × 10 pixels");
    EXPECT_ERROR(sizes, "is 21 × 10 pixels");
    EXPECT_OK(writeImage(path("green.exr"), makeContent(20, 10, {"Y"}), SampleType::half, {}));
    EXPECT_ERROR(read(folder_->root()), "needs the channels R, G and B; this file has Y");
    photograph("green.exr", 0.4f);
    EXPECT_OK(writeImage(path("mask.png"), makeContent(10, 10, {"Y"}), SampleType::uint8, {}));
    EXPECT_ERROR(readWith("\"encoding\"", "\"mask\": \"mask.png\", \"encoding\""),
                 "the mask is 10 × 10 pixels but 'white.exr' is 20 × 10");
    EXPECT_ERROR(readWith("\"encoding\"", "\"mask\": \"nomask.png\", \"encoding\""),
                 "there is no such file");
  }

  // Photographs that are offset by pixels do not pass unseen.
  void displayWindowsAreCompared() {
    OIIO::ImageSpec spec(20, 10, 3, OIIO::TypeHalf);
    spec.x = spec.full_x = 3;
    test::writeForeign(path("green.exr"), "openexr", spec, std::vector<float>(600, 0.3f));
    EXPECT_ERROR(read(folder_->root()),
                 "the photograph's display window begins at 3, 0 but that of 'white.exr' at 0, 0");
    for (const char* name : {"green.exr", "white.exr", "sub/blue.exr"})
      test::writeForeign(path(name), "openexr", spec, std::vector<float>(600, 0.3f));
    EXPECT_OK(read(folder_->root()));
  }

  void coloursAreDividedByTheirAlpha() {
    ImageContent content = makeContent(20, 10, {"R", "G", "B", "A"});
    for (int c = 0; c < 4; ++c) {
      content.channels[static_cast<std::size_t>(c)] = makePlane(20, 10, [&](int x, int) {
        const float alpha = x == 0 ? 0.0f : 0.5f;
        return c == 3 ? alpha : 0.4f;
      });
    }
    EXPECT_OK(writeImage(path("white.exr"), content, SampleType::float32, {}));
    const auto capture = read(folder_->root());
    EXPECT_OK(capture);
    const Measurements& measurements = capture.value().measurements;
    EXPECT_NEAR(test::pixelOf(measurements.channels[0], 5, 5), 0.4, 1e-6);
    QCOMPARE(test::pixelOf(measurements.state, 0, 5), 1.0f);  // masked
    QCOMPARE(test::pixelOf(measurements.state, 5, 5), 0.0f);
  }

  void namesDoNotLeadOutOfTheFolder() {
    ImageFolder elsewhere;
    fs::copy_file(path("white.exr"), elsewhere.path("secret.exr"));
    const auto refused = [&](const std::string& name) {
      const auto result = readWith("\"white.exr\"", ("\"" + name + "\"").c_str());
      return result.failed() && result.error().text().find(
                                    "in or below the folder of the capture") != std::string::npos;
    };
    const std::string absolute = elsewhere.path("secret.exr").string();
    QVERIFY(refused(absolute));
    QVERIFY(refused("../" + elsewhere.root().filename().string() + "/secret.exr"));
    QVERIFY(refused("sub/../../x.exr"));
    QVERIFY(refused("sub/../white.exr"));
    QVERIFY(refused(".."));
    QVERIFY(refused(""));
    fs::create_symlink(elsewhere.path("secret.exr"), path("link.exr"));
    QVERIFY(refused("link.exr"));
    fs::create_directory_symlink(elsewhere.root(), path("linked"));
    QVERIFY(refused("linked/secret.exr"));
    fs::create_symlink("loop.exr", path("loop.exr"));
    QVERIFY(read(folder_->root()).failed());
    QVERIFY(readWith("\"white.exr\"", "\"loop.exr\"").failed());
    EXPECT_ERROR(readWith("\"encoding\"", ("\"mask\": \"" + absolute + "\", \"encoding\"").c_str()),
                 "mask must be a file in or below");
    // A link that stays inside is a file like any other.
    fs::create_symlink("white.exr", path("inside.exr"));
    EXPECT_OK(readWith("\"white.exr\"", "\"inside.exr\""));
    // So is a capture that is itself reached through a link.
    ImageFolder other;
    fs::create_directory_symlink(folder_->root(), other.path("capture"));
    describe(kThreeLights);
    EXPECT_OK(read(other.path("capture")));
  }

  void rigsAreFoundBesideTheCapture() {
    test::writeBytes(path("sub/studio.json"), R"({"cutis_rig": 1, "name": "studio",
        "camera": {"sensitivity": "Canon_EOS_R"}, "lights": [{"name": "lamp", "spectrum": "D65"}]})");
    describe(R"({"cutis_capture": 1, "rig": "sub/studio.json", "encoding": "linear",
                 "images": [{"light": "lamp", "file": "white.exr"}]})");
    const auto capture = read(folder_->root());
    EXPECT_OK(capture);
    QCOMPARE(capture.value().measurements.rig.name, std::string("studio"));
  }

  void writtenCapturesAreReadBack() {
    const Measurements written = simulated(40, 30);
    CaptureWriteOptions options;
    options.sampleType = SampleType::float32;
    options.mask = makePlane(40, 30, [](int x, int) { return x < 10 ? 0.0f : 1.0f; });
    options.extra = [](const fs::path& folder) -> Status {
      test::writeBytes(folder / "maps.exr", "truth");
      return {};
    };
    const fs::path target = path("new/");
    EXPECT_OK(writeCapture(target, written, options, {}));
    for (const char* name : {"white.exr", "white_blue.exr", "white_green.exr", "mask.png",
                             "capture.json", "maps.exr"}) {
      QVERIFY2(fs::exists(path("new") / name), name);
    }
    const auto capture = read(path("new"));
    EXPECT_OK(capture);
    const Measurements& m = capture.value().measurements;
    for (std::size_t c = 0; c < 9; ++c)
      QVERIFY(valuesOf(m.channels[c]) == valuesOf(written.channels[c]));
    QCOMPARE(pixelOf(m.state, 9, 5), 1.0f);
    QCOMPARE(pixelOf(m.state, 10, 5), 0.0f);
  }

  void everySampleTypeIsReadBack() {
    const Measurements written = simulated(20, 10);
    for (const auto& [type, file, tolerance] :
         {std::tuple{SampleType::half, "white_blue.exr", 5e-4},
          std::tuple{SampleType::uint16, "white_blue.tif", 1e-5},
          std::tuple{SampleType::uint8, "white_blue.png", 2e-3}}) {
      const fs::path target = path("typed" + std::to_string(static_cast<int>(type)));
      CaptureWriteOptions options;
      options.sampleType = type;
      EXPECT_OK(writeCapture(target, written, options, {}));
      QVERIFY(fs::exists(target / file));
      const auto capture = read(target);
      EXPECT_OK(capture);
      EXPECT_NEAR(pixelOf(capture.value().measurements.channels[4], 3, 3),
                  pixelOf(written.channels[4], 3, 3), tolerance);
    }
  }

  void rigsAreNamedFromTheCapture() {
    Measurements written = simulated(8, 8);
    test::writeBytes(path("sub/own.json"), R"({"cutis_rig": 1, "name": "own",
        "camera": {"sensitivity": "Canon_EOS_R"}, "primaries": {"file": "iset_LCD_Gechic"},
        "lights": [{"name": "white", "mix": {"R": 1, "G": 1, "B": 1}},
                   {"name": "white+blue", "mix": {"R": 1, "G": 1, "B": 3}},
                   {"name": "white+green", "mix": {"R": 1, "G": 3, "B": 1}}]})");
    CaptureWriteOptions options;
    options.rig = path("sub/own.json").string();
    EXPECT_OK(writeCapture(path("made"), written, options, {}));
    QVERIFY(test::readBytes(path("made/capture.json")).contains("\"../sub/own.json\""));
    const auto capture = read(path("made"));
    EXPECT_OK(capture);
    QCOMPARE(capture.value().measurements.rig.name, std::string("own"));
  }

  void likeNamesOfLightsGetFilesOfTheirOwn() {
    Measurements written = simulated(8, 8);
    written.rig.lights[0].name = "a+b";
    written.rig.lights[1].name = "a b";
    written.rig.lights[2].name = "mask";
    EXPECT_OK(writeCapture(path("alike"), written, {.rig = "monitor"}, {}));
    for (const char* name : {"a_b.exr", "a_b_2.exr", "mask_2.exr"}) {
      QVERIFY2(fs::exists(path("alike") / name), name);
    }
  }

  void onlyCapturesAreWrittenOver() {
    const Measurements written = simulated(8, 8);
    test::writeBytes(path("sub/letter.txt"), "dear");
    EXPECT_ERROR(writeCapture(path("sub"), written, {}, {}), "something other than a capture");
    QVERIFY(fs::exists(path("sub/letter.txt")));
    EXPECT_ERROR(writeCapture(path("white.exr"), written, {}, {}), "there is a file of this name");
    EXPECT_ERROR(writeCapture(path("no/such/folder"), written, {}, {}), "cannot be created");
    fs::create_directory(path("hollow"));
    EXPECT_OK(writeCapture(path("hollow"), written, {}, {}));
    // This very folder is a capture: its files are replaced, others stay.
    EXPECT_OK(writeCapture(folder_->root(), written, {}, {}));
    const auto capture = read(folder_->root());
    EXPECT_OK(capture);
    QCOMPARE(capture.value().measurements.width(), 8);
    QVERIFY(fs::exists(path("green.exr")));
  }

  void nothingIsLeftOfACaptureThatFailed() {
    const Measurements written = simulated(600, 600);
    const auto before = folder_->names();
    CaptureWriteOptions options;
    options.extra = [](const fs::path&) -> Status {
      return resourceError("x", "the disk is full");
    };
    EXPECT_ERROR(writeCapture(path("failed"), written, options, {}), "the disk is full");
    QVERIFY(folder_->names() == before);
    test::Stopper stopper;
    QVERIFY(writeCapture(path("stopped"), written, {}, stopper.context()).cancelled());
    QVERIFY(folder_->names() == before);
  }
};

CUTIS_TEST(CaptureFileTest)

}  // namespace
}  // namespace cutis

#include "capture_file_test.moc"
