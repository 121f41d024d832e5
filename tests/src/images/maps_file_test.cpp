#include "src/images/maps/maps_file.h"

#include <cmath>
#include <limits>

#include <QtTest>

#include "core/skin/pixel_state.h"
#include "core/skin/profile/parameter.h"
#include "src/files/profiles/profile_file.h"
#include "src/images/image_file.h"
#include "tests/src/images/image_fixture.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

using test::ImageFolder;
using test::makePlane;
using test::pixelOf;
using test::valuesOf;

constexpr int kWidth = 300;
constexpr int kHeight = 270;
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

Plane ramp(float offset) {
  return makePlane(kWidth, kHeight, [offset](int x, int y) {
    return offset + 1e-3f * static_cast<float>(x) + 1e-6f * static_cast<float>(y);
  });
}

MapsFile makeMaps(bool everything) {
  MapsFile file;
  file.maps = ChromophoreMaps(kWidth, kHeight);
  for (std::size_t k = 0; k < kParameterCount; ++k) {
    file.maps.values[k] = ramp(static_cast<float>(k));
  }
  file.maps.state =
      makePlane(kWidth, kHeight, [](int x, int y) { return static_cast<float>((x + y) % 5); });
  file.attributes.profileName = "li2024";
  file.attributes.profileJson = profileText("li2024", "test").value();
  file.attributes.rigName = "monitor";
  file.attributes.method = "refined";
  file.attributes.exposure = 1.0 / 3.0;
  file.attributes.sources = {{"white.exr", "aa"}, {"Gesicht „ß“.exr", "bb"}};
  file.attributes.sourceColorSpace = "ACEScg";
  if (!everything) return file;
  for (std::size_t k = 0; k < kParameterCount; ++k) {
    file.deviations.push_back(ramp(10.0f + static_cast<float>(k)));
  }
  file.residualNames = {"white.R",      "white.G",      "white.B",
                        "white+blue.R", "white+blue.G", "white+blue.B"};
  for (std::size_t c = 0; c < file.residualNames.size(); ++c) {
    file.residuals.push_back(ramp(-static_cast<float>(c)));
  }
  file.shading = ramp(0.5f);
  return file;
}

MapsFile withConstants(MapsFile file, const FreeConstants& free) {
  for (const SkinConstant constant : kSkinConstants) {
    if (!free.has(constant)) continue;
    file.maps.constants[constant] = ramp(constant == kOxygenation ? 0.4f : 0.05f);
    file.constantDeviations.push_back(ramp(constant == kOxygenation ? 0.1f : 0.01f));
  }
  return file;
}

Result<MapsFile> read(const std::filesystem::path& path, const JobContext& context = {}) {
  return readMaps(path, PixelFormat::float32, nullptr, context);
}

// A maps file as another program might have left it.
struct ForeignPart {
  std::string name = {};
  std::vector<std::string> channels = {};
  int width = 8;
  int height = 6;
  int version = 0;
  float value = 0.5f;
  int cropX = 0, cropY = 0;  // where the data window begins; it ends with the picture
};

void writeForeignParts(const std::filesystem::path& path, const std::vector<ForeignPart>& parts) {
  std::vector<OIIO::ImageSpec> specs;
  for (const ForeignPart& part : parts) {
    OIIO::ImageSpec spec(part.width - part.cropX, part.height - part.cropY,
                         static_cast<int>(part.channels.size()), OIIO::TypeFloat);
    spec.x = part.cropX;
    spec.y = part.cropY;
    spec.full_width = part.width;
    spec.full_height = part.height;
    spec.channelnames = part.channels;
    spec.attribute("oiio:subimagename", part.name);
    if (part.version > 0) spec.attribute("cutis:version", part.version);
    specs.push_back(spec);
  }
  auto output = OIIO::ImageOutput::create("openexr");
  QVERIFY(output->open(path.string(), static_cast<int>(specs.size()), specs.data()));
  for (std::size_t i = 0; i < specs.size(); ++i) {
    if (i > 0) {
      QVERIFY(output->open(path.string(), specs[i], OIIO::ImageOutput::AppendSubimage));
    }
    const std::vector<float> samples(
        static_cast<std::size_t>(specs[i].width * specs[i].height) * parts[i].channels.size(),
        parts[i].value);
    QVERIFY(output->write_image(OIIO::TypeFloat, samples.data()));
  }
  QVERIFY(output->close());
}

const std::vector<std::string> kFive = {"melanin", "melanin_blend", "haemoglobin_dermal",
                                        "haemoglobin_epidermal", "carotene"};

class MapsFileTest : public QObject {
  Q_OBJECT

  ImageFolder folder_;

 private slots:
  void roundTripWithAllParts() {
    const MapsFile written = makeMaps(true);
    const auto path = folder_.path("all.exr");
    EXPECT_OK(writeMaps(path, written, {}));
    QVERIFY(isMapsFile(path));
    const auto result = read(path);
    EXPECT_OK(result);
    const MapsFile& file = result.value();
    for (std::size_t k = 0; k < kParameterCount; ++k) {
      QVERIFY(valuesOf(file.maps.values[k])[1000] == valuesOf(written.maps.values[k])[1000]);
      QVERIFY(valuesOf(file.deviations[k]) == valuesOf(written.deviations[k]));
    }
    QVERIFY(valuesOf(file.maps.state) == valuesOf(written.maps.state));
    QVERIFY(valuesOf(file.shading) == valuesOf(written.shading));
    QCOMPARE(file.residualNames.size(), written.residualNames.size());
    for (std::size_t c = 0; c < written.residualNames.size(); ++c) {
      const auto at =
          std::find(file.residualNames.begin(), file.residualNames.end(), written.residualNames[c]);
      QVERIFY(at != file.residualNames.end());
      QVERIFY(valuesOf(file.residuals[static_cast<std::size_t>(at - file.residualNames.begin())]) ==
              valuesOf(written.residuals[c]));
    }
    QCOMPARE(file.attributes.profileName, written.attributes.profileName);
    QCOMPARE(file.attributes.profileJson, written.attributes.profileJson);
    EXPECT_OK(parseProfile(file.attributes.profileJson, "maps"));
    QCOMPARE(file.attributes.rigName, written.attributes.rigName);
    QCOMPARE(file.attributes.method, written.attributes.method);
    QCOMPARE(file.attributes.exposure, written.attributes.exposure);
    QCOMPARE(file.attributes.sourceColorSpace, written.attributes.sourceColorSpace);
    QVERIFY(file.attributes.sources == written.attributes.sources);
  }

  void roundTripWithoutOptionalParts() {
    const MapsFile written = makeMaps(false);
    EXPECT_OK(writeMaps(folder_.path("plain.exr"), written, {}));
    const auto file = read(folder_.path("plain.exr"));
    EXPECT_OK(file);
    QVERIFY(file.value().deviations.empty() && file.value().residuals.empty());
    QVERIFY(file.value().shading.empty());
    for (std::size_t k = 0; k < kParameterCount; ++k) {
      QVERIFY(valuesOf(file.value().maps.values[k]) == valuesOf(written.maps.values[k]));
    }
  }

  void constantsGoAlong() {
    for (const FreeConstants& free :
         {FreeConstants{true, true}, FreeConstants{true, false}, FreeConstants{false, true}}) {
      const MapsFile written = withConstants(makeMaps(false), free);
      EXPECT_OK(writeMaps(folder_.path("constants.exr"), written, {}));
      const auto file = read(folder_.path("constants.exr"));
      EXPECT_OK(file);
      QVERIFY(file.value().maps.free() == free);
      for (const SkinConstant constant : kSkinConstants) {
        if (!free.has(constant)) continue;
        QVERIFY(valuesOf(file.value().maps.constants[constant]) ==
                valuesOf(written.maps.constants[constant]));
      }
      QCOMPARE(file.value().constantDeviations.size(), static_cast<std::size_t>(free.count()));
      QVERIFY(valuesOf(file.value().constantDeviations[0]) ==
              valuesOf(written.constantDeviations[0]));
    }
  }

  void coefficientsGoAlong() {
    for (const SurfaceLight surface : {SurfaceLight::included, SurfaceLight::removed}) {
      MapsFile written = makeMaps(true);
      written.maps.addCoefficients(surface, 3, nullptr);
      for (std::size_t c = 0; c < 3; ++c) {
        // Numbers that a half holds.
        written.maps.coefficients[c] = makePlane(kWidth, kHeight, [c](int x, int y) {
          return static_cast<float>((x + y) % 7 - 3) * 0.25f + static_cast<float>(c);
        });
      }
      EXPECT_OK(writeMaps(folder_.path("coefficients.exr"), written, {}));
      const auto file = read(folder_.path("coefficients.exr"));
      EXPECT_OK(file);
      QVERIFY(file.value().maps.perPixel() == written.maps.perPixel());
      QCOMPARE(file.value().maps.coefficients.size(), std::size_t{3});
      for (std::size_t c = 0; c < 3; ++c) {
        QVERIFY(file.value().maps.coefficients[c].format() == PixelFormat::half);
        QVERIFY(valuesOf(file.value().maps.coefficients[c]) ==
                valuesOf(written.maps.coefficients[c]));
      }
    }
  }

  void coefficientsOfAnUnknownDiscrepancyAreRefused() {
    MapsFile written = makeMaps(false);
    written.maps.addCoefficients(SurfaceLight::included, 2, nullptr);
    EXPECT_OK(writeMaps(folder_.path("unknown.exr"), written, {}));
    const auto file = read(folder_.path("unknown.exr"));
    EXPECT_OK(file);
    const Profile plain = loadProfile("li2024", "test").value();
    EXPECT_ERROR(checkCoefficients(file.value().maps, plain, "unknown.exr"),
                 "a discrepancy that their profile does not have");
    const Profile other = loadProfile("skin2026b", "test").value();
    EXPECT_ERROR(checkCoefficients(file.value().maps, other, "unknown.exr"), "2 coefficients");
    EXPECT_OK(checkCoefficients(makeMaps(false).maps, plain, "plain.exr"));
  }

  // At an estimate they must be what some profile could have; elsewhere they are nothing.
  void impossibleConstantsAreInvalid() {
    MapsFile maps = withConstants(makeMaps(false), {true, true});
    const auto spoil = [](Plane& plane, int x, int y, float value) {
      QVERIFY(plane.store({x, y, x + 1, y + 1}, std::span(&value, 1)));
    };
    Plane& oxygenation = maps.maps.constants[kOxygenation];
    Plane& thickness = maps.maps.constants[kThickness];
    spoil(oxygenation, 5, 5, 1.5f);
    spoil(oxygenation, 10, 5, -0.25f);
    spoil(oxygenation, 15, 5, kNan);
    spoil(thickness, 20, 5, 0.0f);
    spoil(thickness, 25, 5, 40.0f);
    spoil(thickness, 31, 5, 0.0f);  // masked
    EXPECT_OK(writeMaps(folder_.path("impossible.exr"), maps, {}));
    test::Listener listener;
    const auto file = read(folder_.path("impossible.exr"), listener.context());
    EXPECT_OK(file);
    QCOMPARE(listener.sentences.size(), std::size_t{1});
    QVERIFY(listener.sentences[0].find("5 pixels") != std::string::npos);
    for (const int x : {5, 10, 15, 20, 25}) {
      QCOMPARE(pixelOf(file.value().maps.state, x, 5), 2.0f);
      for (const Plane& plane : file.value().maps.planes())
        QCOMPARE(pixelOf(plane, x, 5), 0.0f);
    }
    QCOMPARE(pixelOf(file.value().maps.state, 31, 5), 1.0f);
  }

  void constantsOfNoKnownNameAreRefused() {
    writeForeignParts(folder_.path("strange.exr"),
                      {{.name = "chromophores", .channels = kFive, .version = 1},
                       {.name = "state", .channels = {"state"}, .value = 0.0f},
                       {.name = "constants", .channels = {"temperature"}}});
    EXPECT_ERROR(read(folder_.path("strange.exr")), "neither a channel 'oxygenation'");
    writeForeignParts(folder_.path("deviating.exr"),
                      {{.name = "chromophores", .channels = kFive, .version = 1},
                       {.name = "state", .channels = {"state"}, .value = 0.0f},
                       {.name = "constants", .channels = {"oxygenation"}},
                       {.name = "constants_deviation", .channels = {"thickness_mm"}}});
    EXPECT_ERROR(read(folder_.path("deviating.exr")), "has no channel 'oxygenation'");
  }

  // Other programs see the parts and channels that the documentation promises.
  void layoutIsAsDocumented() {
    EXPECT_OK(writeMaps(folder_.path("layout.exr"), makeMaps(true), {}));
    auto input = OIIO::ImageInput::open(folder_.path("layout.exr").string());
    QVERIFY(input != nullptr);
    const std::vector<std::pair<std::string, int>> parts = {
        {"chromophores", 5}, {"state", 1}, {"deviation", 5}, {"residual", 6}, {"shading", 1}};
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const OIIO::ImageSpec spec = input->spec(static_cast<int>(i), 0);
      QCOMPARE(std::string(spec.get_string_attribute("oiio:subimagename")), parts[i].first);
      QCOMPARE(spec.nchannels, parts[i].second);
      QVERIFY(spec.format == OIIO::TypeFloat);
    }
    const OIIO::ImageSpec first = input->spec(0, 0);
    QCOMPARE(first.get_int_attribute("cutis:version"), 1);
    QCOMPARE(std::string(first.get_string_attribute("cutis:profile")), std::string("li2024"));
    for (const std::string& name : kFive)
      QVERIFY(first.channelindex(name) >= 0);
  }

  // The file's order is alphabetical; ours is that of the parameters.
  void channelsAreFoundByName() {
    EXPECT_OK(writeMaps(folder_.path("order.exr"), makeMaps(false), {}));
    const auto file = read(folder_.path("order.exr"));
    EXPECT_OK(file);
    for (std::size_t k = 0; k < kParameterCount; ++k) {
      QCOMPARE(pixelOf(file.value().maps.values[k], 0, 0), static_cast<float>(k));
    }
  }

  void spoiledPixelsBecomeInvalidWithANotice() {
    MapsFile maps = makeMaps(true);
    const auto spoil = [](Plane& plane, int x, int y, float value) {
      QVERIFY(plane.store({x, y, x + 1, y + 1}, std::span(&value, 1)));
    };
    spoil(maps.maps.values[kMelanin], 3, 4, kNan);
    spoil(maps.maps.values[kCarotene], 290, 260, std::numeric_limits<float>::infinity());
    spoil(maps.maps.state, 7, 7, 2.5f);
    spoil(maps.maps.state, 8, 7, -1.0f);
    spoil(maps.maps.state, 9, 7, kNan);
    spoil(maps.deviations[0], 5, 5, kNan);
    spoil(maps.shading, 6, 5, -std::numeric_limits<float>::infinity());
    EXPECT_OK(writeMaps(folder_.path("nan.exr"), maps, {}));
    test::Listener listener;
    const auto file = read(folder_.path("nan.exr"), listener.context());
    EXPECT_OK(file);
    QCOMPARE(listener.sentences.size(), std::size_t{1});
    QVERIFY(listener.sentences[0].find("5 pixels") != std::string::npos);
    for (const auto& [x, y] : {std::pair{3, 4}, {290, 260}, {7, 7}, {8, 7}, {9, 7}}) {
      QCOMPARE(pixelOf(file.value().maps.state, x, y), 2.0f);
      for (const Plane& plane : file.value().maps.values)
        QCOMPARE(pixelOf(plane, x, y), 0.0f);
    }
    QCOMPARE(pixelOf(file.value().deviations[0], 5, 5), 0.0f);
    QCOMPARE(pixelOf(file.value().shading, 6, 5), 0.0f);
    QCOMPARE(pixelOf(file.value().maps.values[kMelanin], 4, 4), pixelOf(ramp(0), 4, 4));
  }

  void croppedPixelsAreMasked() {
    writeForeignParts(
        folder_.path("crop.exr"),
        {{.name = "chromophores", .channels = kFive, .version = 1, .value = 0.25f, .cropX = 2},
         {.name = "state", .channels = {"state"}, .value = 0.0f, .cropY = 1}});
    const auto file = read(folder_.path("crop.exr"));
    EXPECT_OK(file);
    const ChromophoreMaps& maps = file.value().maps;
    QCOMPARE(maps.state.width(), 8);
    for (int y = 0; y < 6; ++y) {
      for (int x = 0; x < 8; ++x) {
        const bool stored = x >= 2 && y >= 1;
        QCOMPARE(pixelOf(maps.state, x, y), stored ? 0.0f : 1.0f);
        QCOMPARE(pixelOf(maps.values[kCarotene], x, y), stored ? 0.25f : 0.0f);
      }
    }
  }

  void foreignImagesAreTold() {
    const auto content = test::makeContent(8, 8, {"R", "G", "B"});
    EXPECT_OK(writeImage(folder_.path("photo.exr"), content, SampleType::half, {}));
    EXPECT_ERROR(read(folder_.path("photo.exr")),
                 "this is not a Cutis maps file; fit an image first");
    QVERIFY(!isMapsFile(folder_.path("photo.exr")));
    EXPECT_OK(writeImage(folder_.path("photo.png"), content, SampleType::uint8, {}));
    EXPECT_ERROR(read(folder_.path("photo.png")), "not a Cutis maps file but a PNG image");
    QVERIFY(!isMapsFile(folder_.path("photo.png")));
    QVERIFY(!isMapsFile(folder_.path("missing.exr")));
    EXPECT_ERROR(read(folder_.path("missing.exr")), "there is no such file");
    writeForeignParts(folder_.path("unversioned.exr"), {{.name = "chromophores", .channels = kFive},
                                                        {.name = "state", .channels = {"state"}}});
    EXPECT_ERROR(read(folder_.path("unversioned.exr")), "not a Cutis maps file");
  }

  void incompleteMapsAreTold() {
    const ForeignPart five = {.name = "chromophores", .channels = kFive, .version = 1};
    const ForeignPart state = {.name = "state", .channels = {"state"}, .value = 0.0f};
    writeForeignParts(folder_.path("good.exr"), {state, five});
    EXPECT_OK(read(folder_.path("good.exr")));
    ForeignPart other = five;
    other.version = 2;
    writeForeignParts(folder_.path("newer.exr"), {other, state});
    EXPECT_ERROR(read(folder_.path("newer.exr")), "newer version of Cutis");
    other = five;
    other.channels.back() = "charcoal";
    writeForeignParts(folder_.path("channel.exr"), {other, state});
    EXPECT_ERROR(read(folder_.path("channel.exr")), "has no channel 'carotene'");
    writeForeignParts(folder_.path("nostate.exr"), {five, {.name = "x", .channels = {"state"}}});
    EXPECT_ERROR(read(folder_.path("nostate.exr")), "the part 'state' is missing");
  }

  // OpenEXR writes no file whose parts differ in their display window; one that does is damaged.
  void partsOfDifferentSizesAreRefused() {
    writeForeignParts(folder_.path("size.exr"),
                      {{.name = "chromophores", .channels = kFive, .version = 1},
                       {.name = "state", .channels = {"state"}}});
    QByteArray bytes = test::readBytes(folder_.path("size.exr"));
    const QByteArray window("displayWindow\0box2i\0\x10\0\0\0", 24);
    const qsizetype right = bytes.lastIndexOf(window) + window.size() + 8;
    QCOMPARE(bytes.mid(right, 4), QByteArray("\x07\0\0\0", 4));
    bytes[right] = 8;
    test::writeBytes(folder_.path("size.exr"), bytes);
    EXPECT_ERROR(read(folder_.path("size.exr")), "size.exr: ");
  }

  void oddAttributesAreTold() {
    MapsFile maps = makeMaps(false);
    EXPECT_OK(writeMaps(folder_.path("odd.exr"), maps, {}));
    QByteArray bytes = test::readBytes(folder_.path("odd.exr"));
    bytes.replace("[{\"file\":", "[[\"file\":");
    test::writeBytes(folder_.path("odd.exr"), bytes);
    EXPECT_ERROR(read(folder_.path("odd.exr")), "cutis:sources");
  }

  // As for other images, the case of the extension says nothing.
  void theExtensionMayBeInCapitals() {
    EXPECT_OK(writeMaps(folder_.path("MAPS.EXR"), makeMaps(false), {}));
    QVERIFY(isMapsFile(folder_.path("MAPS.EXR")));
  }

  void onlyOpenExrIsWritten() {
    EXPECT_ERROR(writeMaps(folder_.path("maps.tif"), makeMaps(false), {}),
                 "name the file with .exr");
  }

  void metadataIsCarriedOver() {
    OIIO::ImageSpec spec(8, 8, 3, OIIO::TypeUInt8);
    spec.attribute("Make", "Canon");
    spec.attribute("ExposureTime", 0.01f);
    test::writeForeign(folder_.path("camera.jpg"), "jpeg", spec, test::noise(192));
    MapsFile maps = makeMaps(true);
    maps.metadata = readImageHeader(folder_.path("camera.jpg"), {}).value().metadata;
    EXPECT_OK(writeMaps(folder_.path("meta.exr"), maps, {}));
    const auto file = read(folder_.path("meta.exr"));
    EXPECT_OK(file);
    QCOMPARE(file.value().metadata.text("Make").value_or(""), std::string("Canon"));
    QVERIFY(file.value().metadata.text("ExposureTime").has_value());
    QVERIFY(!file.value().metadata.text("cutis:profile").has_value());
  }

  void stopsWhenAskedAndLeavesNothing() {
    MapsFile maps = makeMaps(true);
    test::Stopper writing;
    QVERIFY(writeMaps(folder_.path("stopped.exr"), maps, writing.context()).cancelled());
    EXPECT_OK(writeMaps(folder_.path("whole.exr"), maps, {}));
    test::Stopper reading;
    QVERIFY(read(folder_.path("whole.exr"), reading.context()).cancelled());
    for (const std::string& name : folder_.names()) {
      QVERIFY2(name.find("stopped") == std::string::npos, name.c_str());
    }
  }
};

CUTIS_TEST(MapsFileTest)

}  // namespace
}  // namespace cutis

#include "maps_file_test.moc"
