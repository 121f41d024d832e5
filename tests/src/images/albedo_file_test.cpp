#include "src/images/capture/albedo_file.h"

#include <cmath>
#include <limits>

#include <QtTest>

#include "core/spectra/colorimetry.h"
#include "src/color/color_space.h"
#include "tests/src/images/image_fixture.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

using test::ImageFolder;
using test::makeContent;
using test::makePlane;
using test::pixelOf;
using test::valuesOf;

using Rgb = std::array<float, 3>;

Result<Albedo> read(const std::filesystem::path& path, const AlbedoOptions& options = {}) {
  return readAlbedo(path, options, test::albedoRig(), nullptr, {});
}

// A picture of one colour.
ImageContent flat(const Rgb& color, int width = 4, int height = 3) {
  ImageContent content;
  content.channelNames = {"R", "G", "B"};
  for (const float level : color) {
    content.channels.push_back(makePlane(width, height, [level](int, int) { return level; }));
  }
  return content;
}

// Tristimulus values over those of the white, by the equations.
Eigen::Vector3d relativeXyz(const Eigen::Vector3d& linear) {
  const Rig& rig = test::albedoRig();
  const Eigen::Vector3d white = whitePoint(rig.lights[0].power, rig.camera.sensor);
  return (xyzFromRec709(white) * linear).cwiseQuotient(white);
}

class AlbedoFileTest : public QObject {
  Q_OBJECT

  ImageFolder folder_;

  Albedo written(const char* file, const ImageContent& content, SampleType type,
                 const AlbedoOptions& options = {}) {
    const auto path = folder_.path(file);
    const Status done = writeImage(path, content, type, {});
    if (!done) qFatal("cannot write: %s", done.error().text().c_str());
    auto albedo = read(path, options);
    if (!albedo) qFatal("cannot read: %s", albedo.error().text().c_str());
    return std::move(albedo).value();
  }

  void expectColor(const Albedo& albedo, const Eigen::Vector3d& linear, double tolerance) {
    const Eigen::Vector3d expected = relativeXyz(linear);
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(pixelOf(albedo.measurements.channels[c], 1, 1),
                  expected[static_cast<Eigen::Index>(c)], tolerance);
    }
    QCOMPARE(pixelOf(albedo.measurements.state, 1, 1), 0.0f);
  }

 private slots:
  // Planes hold floats, of whatever the file is.
  void samplesOfMoreBitsAreSaid() {
    for (const auto& [type, says] :
         {std::pair{OIIO::TypeUInt32, "its samples of type 32 bit are read as floats"},
          std::pair{OIIO::TypeDesc(OIIO::TypeDesc::DOUBLE), "its samples of type double"},
          std::pair{OIIO::TypeUInt16, ""}}) {
      const auto path = folder_.path("wide.tif");
      test::writeForeign(path, "tiff", OIIO::ImageSpec(4, 4, 3, type),
                         std::vector<float>(48, 0.25f));
      test::Listener listener;
      EXPECT_OK(readAlbedo(path, {}, test::albedoRig(), nullptr, listener.context()));
      std::string all;
      for (const std::string& sentence : listener.sentences)
        all += sentence;
      QVERIFY2(*says == '\0' ? all.empty() : all.find(says) != std::string::npos, all.c_str());
    }
  }

  // Nothing tells which of several layers is meant.
  void layersAreNotGuessed() {
    const auto path = folder_.path("layers.exr");
    test::writeForeignParts(
        path,
        {{"", {"Z", "albedo.R", "albedo.G", "albedo.B", "diffuse.R", "diffuse.G", "diffuse.B"}}});
    const auto read = [&](const std::string& layer) {
      return readAlbedo(path, {.layer = layer}, test::albedoRig(), nullptr, {});
    };
    EXPECT_ERROR(read(""), "layer: '" + path.string() +
                               "' has no plain channels R, G and B, but 'albedo' and 'diffuse' "
                               "have colours; choose one of them");
    EXPECT_OK(read("diffuse"));
    EXPECT_ERROR(read("Z"), "there is no layer 'Z'");
  }

  void greyWithASecondChannelIsRead() {
    const auto path = folder_.path("two.tif");
    OIIO::ImageSpec spec(4, 4, 2, OIIO::TypeUInt16);
    spec.channelnames = {"Y", "dust"};
    spec.alpha_channel = -1;
    std::vector<float> samples;
    for (int i = 0; i < 16; ++i)
      samples.insert(samples.end(), {0.5f, 0.25f});
    test::writeForeign(path, "tiff", spec, samples);
    test::Listener listener;
    const auto albedo = readAlbedo(path, {}, test::albedoRig(), nullptr, listener.context());
    EXPECT_OK(albedo);
    const auto& source = albedo.value().source;
    for (const int color : *source.layer.colors) {
      EXPECT_NEAR(pixelOf(source.channels[static_cast<std::size_t>(color)], 1, 1), 0.5, 1e-4);
    }
    QCOMPARE(listener.sentences.size(), std::size_t{1});
    QVERIFY(listener.sentences[0].find(
                "its second channel, which nothing explains, is not looked at") !=
            std::string::npos);
  }

  void init() { qunsetenv("OCIO"); }

  // A neutral reflectance reads the same in all channels, a perfect diffuser 1.
  void neutralsReadTheirReflectance() {
    for (const float level : {0.02f, 0.18f, 0.5f, 1.0f}) {
      const Albedo albedo = written("grey.exr", flat({level, level, level}), SampleType::float32);
      for (const Plane& plane : albedo.measurements.channels) {
        EXPECT_NEAR(pixelOf(plane, 1, 1), level, 1e-6);
      }
    }
  }

  void integersAreSrgbUnlessTheFileOrTheUserSaysOtherwise() {
    const Rgb skin = {200.0f / 255, 150.0f / 255, 120.0f / 255};
    const Eigen::Vector3d decoded = {decodeSrgb(skin[0]), decodeSrgb(skin[1]), decodeSrgb(skin[2])};
    for (const char* file : {"skin.png", "skin.tif"}) {
      const Albedo albedo = written(file, flat(skin), SampleType::uint8);
      QCOMPARE(albedo.colors.followed.space.name, std::string("sRGB"));
      expectColor(albedo, decoded, 1e-6);
    }
    const Albedo linear =
        written("skin.png", flat(skin), SampleType::uint8, {.colorSpace = "lin_rec709"});
    expectColor(linear, {skin[0], skin[1], skin[2]}, 1e-6);
    ImageContent tagged = flat(skin);
    tagged.colorSpace = builtInColorSpace("Linear Rec.709");
    expectColor(written("tagged.png", tagged, SampleType::uint8), {skin[0], skin[1], skin[2]},
                1e-6);
  }

  void floatsAreLinearUnlessTheFileOrTheUserSaysOtherwise() {
    const Rgb skin = {0.6f, 0.35f, 0.2f};
    for (const char* file : {"skin.exr", "float.tif"}) {
      const Albedo albedo = written(file, flat(skin), SampleType::float32);
      QCOMPARE(albedo.colors.followed.space.name, std::string("Linear Rec.709"));
      expectColor(albedo, {0.6, 0.35, 0.2}, 1e-6);
    }
    ImageContent aces = flat(skin);
    aces.colorSpace = builtInColorSpace("ACEScg");
    Rgb linear = skin;
    EXPECT_OK(toLinearRec709("ACEScg", "test").value()(linear));
    const Albedo albedo = written("aces.exr", aces, SampleType::float32);
    QCOMPARE(albedo.colors.followed.space.name, std::string("ACEScg"));
    expectColor(albedo, {linear[0], linear[1], linear[2]}, 1e-6);
    expectColor(written("srgb.exr", flat(skin), SampleType::float32, {.colorSpace = "sRGB"}),
                {decodeSrgb(0.6f), decodeSrgb(0.35f), decodeSrgb(0.2f)}, 1e-6);
  }

  void statesFollowThePixels() {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    // solved, NaN, black, blue so pure that X or Y is negative, alpha 0, alpha small
    const std::vector<Rgb> pixels = {{0.5f, 0.4f, 0.3f},   {nan, 0.4f, 0.3f},  {0, 0, 0},
                                     {-0.9f, -0.2f, 0.8f}, {0.5f, 0.4f, 0.3f}, {0.5f, 0.4f, 0.3f}};
    const std::vector<float> alphas = {1.0f, 1.0f, 1.0f, 1.0f, 0.0f, 0.01f};
    ImageContent content;
    content.channelNames = {"R", "G", "B", "A"};
    for (std::size_t c = 0; c < 4; ++c) {
      content.channels.push_back(makePlane(6, 1, [&](int x, int) {
        const auto at = static_cast<std::size_t>(x);
        return c < 3 ? pixels[at][c] : alphas[at];
      }));
    }
    EXPECT_OK(writeImage(folder_.path("states.exr"), content, SampleType::float32, {}));
    const auto albedo = read(folder_.path("states.exr"));
    EXPECT_OK(albedo);
    QVERIFY(valuesOf(albedo.value().measurements.state) == (std::vector<float>{0, 2, 2, 2, 1, 0}));
    // All channels of the source are kept for what is written later.
    QCOMPARE(albedo.value().source.channels.size(), std::size_t{4});
    QVERIFY(albedo.value().source.sourceType == SampleType::float32);
    // Alpha takes nothing away from the colour.
    QCOMPARE(pixelOf(albedo.value().measurements.channels[1], 5, 0),
             pixelOf(albedo.value().measurements.channels[1], 0, 0));
  }

  void theEndOfAnIntegerRangeIsSaturated() {
    ImageContent content = flat({0.5f, 0.4f, 0.3f});
    const float one = 1.0f;
    EXPECT_OK(content.channels[0].store({2, 2, 3, 3}, std::span(&one, 1)));
    const Albedo albedo = written("clip.png", content, SampleType::uint8);
    QCOMPARE(pixelOf(albedo.measurements.state, 2, 2), 3.0f);
    QCOMPARE(pixelOf(albedo.measurements.state, 1, 2), 0.0f);
    const Albedo floats = written("clip.exr", content, SampleType::float32);
    QCOMPARE(pixelOf(floats.measurements.state, 2, 2), 0.0f);
  }

  void masksLeaveOut() {
    ImageContent mask;
    mask.channelNames = {"Y"};
    mask.channels = {makePlane(4, 3, [](int x, int) { return x == 1 ? 0.0f : 0.3f; })};
    EXPECT_OK(writeImage(folder_.path("mask.png"), mask, SampleType::uint8, {}));
    EXPECT_OK(writeImage(folder_.path("face.exr"), flat({0.5f, 0.4f, 0.3f}), SampleType::half, {}));
    const auto albedo = read(folder_.path("face.exr"), {.mask = folder_.path("mask.png")});
    EXPECT_OK(albedo);
    QCOMPARE(pixelOf(albedo.value().measurements.state, 1, 0), 1.0f);
    QCOMPARE(pixelOf(albedo.value().measurements.state, 2, 0), 0.0f);
    EXPECT_OK(
        writeImage(folder_.path("small.png"), makeContent(2, 2, {"Y"}), SampleType::uint8, {}));
    EXPECT_ERROR(read(folder_.path("face.exr"), {.mask = folder_.path("small.png")}),
                 "the mask is 2 × 2 pixels but");
  }

  void whatIsNoAlbedoIsTold() {
    EXPECT_OK(writeImage(folder_.path("five.exr"), makeContent(4, 4, {"a", "b", "c"}),
                         SampleType::half, {}));
    EXPECT_ERROR(read(folder_.path("five.exr")), "without the channels R, G and B");
    EXPECT_ERROR(read(folder_.path("missing.exr")), "there is no such file");
    EXPECT_OK(writeImage(folder_.path("face.exr"), flat({0.5f, 0.4f, 0.3f}), SampleType::half, {}));
    EXPECT_ERROR(readAlbedo(folder_.path("face.exr"), {}, test::monitorRig(), nullptr, {}),
                 "use the rig 'albedo' or name a capture");
  }

  void unknownSpacesAreAnsweredByWhoNamedThem() {
    ImageContent content = flat({0.5f, 0.4f, 0.3f});
    content.colorSpace = builtInColorSpace("Linear Rec.709");
    content.colorSpace.name = "Martian RGB";
    EXPECT_OK(writeImage(folder_.path("mars.exr"), content, SampleType::half, {}));
    EXPECT_ERROR(read(folder_.path("mars.exr")),
                 "its attribute cutis:colorspace says 'Martian RGB', which is not known; name the "
                 "colour space of the file, for example Linear Rec.709");
    EXPECT_OK(read(folder_.path("mars.exr"), {.colorSpace = "ACEScg"}));
    EXPECT_ERROR(read(folder_.path("mars.exr"), {.colorSpace = "ACEScq"}),
                 "colour space: unknown colour space 'ACEScq'");
  }

  void stopsWhenAsked() {
    EXPECT_OK(writeImage(folder_.path("big.exr"), makeContent(1500, 1500, {"R", "G", "B"}),
                         SampleType::float32, {}));
    test::Stopper stopper;
    QVERIFY(readAlbedo(folder_.path("big.exr"), {}, test::albedoRig(), nullptr, stopper.context())
                .cancelled());
  }
};

CUTIS_TEST(AlbedoFileTest)

}  // namespace
}  // namespace cutis

#include "albedo_file_test.moc"
