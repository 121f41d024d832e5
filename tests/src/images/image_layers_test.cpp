// Layers and parts: what a file holds, found in its header, and what is read of it.

#include "src/images/image_layers.h"

#include <algorithm>

#include <QtTest>

#include "src/images/image_file.h"
#include "tests/src/images/image_fixture.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

using test::ImageFolder;
using test::pixelOf;

std::vector<std::string> namesOf(const std::vector<ImageLayer>& layers) {
  std::vector<std::string> names;
  for (const ImageLayer& layer : layers)
    names.push_back(layer.name);
  return names;
}

class ImageLayersTest : public QObject {
  Q_OBJECT

  ImageFolder folder_;

  // Every sample is the number of its channel by tenths, and of its part by ones.
  std::filesystem::path write(const std::string& name,
                              const std::vector<test::ForeignPart>& parts) {
    const auto path = folder_.path(name);
    test::writeForeignParts(path, parts);
    return path;
  }

 private Q_SLOTS:
  void layersOfOnePart() {
    const auto path =
        write("one.exr", {{"",
                           {"R", "G", "B", "A", "albedo.R", "albedo.G", "albedo.B", "Z", "spec.red",
                            "spec.green", "spec.blue", "spec.alpha", "N.X", "N.Y", "N.Z"}}});
    const auto layers = listLayers(path, {});
    EXPECT_OK(layers);
    std::vector<std::string> names = namesOf(layers.value());
    std::sort(names.begin(), names.end());
    QVERIFY(names == (std::vector<std::string>{"", "N", "albedo", "spec"}));
    for (const ImageLayer& layer : layers.value()) {
      QCOMPARE(layer.colors.has_value(), layer.name != "N");
      QCOMPARE(layer.alpha >= 0, layer.name.empty() || layer.name == "spec");
      QCOMPARE(layer.part, 0);
    }
    // Plain channels unless another layer is chosen.
    const auto plain = readImageHeader(path, {});
    EXPECT_OK(plain);
    QVERIFY(plain.value().layer.name.empty());
    const auto chosen = readImageHeader(path, {}, "albedo");
    EXPECT_OK(chosen);
    QCOMPARE(
        chosen.value().channelNames[static_cast<std::size_t>((*chosen.value().layer.colors)[2])],
        std::string("albedo.B"));
    EXPECT_ERROR(readImageHeader(path, {}, "beauty"), "there is no layer 'beauty' in this file");
  }

  void layersOfSeveralParts() {
    const auto path =
        write("parts.exr", {{"depth", {"Z"}},
                            {"left", {"R", "G", "B"}},
                            {"right", {"R", "G", "B", "sheen.R", "sheen.G", "sheen.B"}},
                            {"albedo", {"albedo.R", "albedo.G", "albedo.B"}}});
    const auto layers = listLayers(path, {});
    EXPECT_OK(layers);
    QVERIFY(namesOf(layers.value()) ==
            (std::vector<std::string>{"depth", "left", "right", "right.sheen", "albedo"}));
    QCOMPARE(layerNames(layers.value()),
             std::string("'depth', 'left', 'right', 'right.sheen' and 'albedo'"));
    // The first part with plain colours, wherever it is.
    for (const auto& [name, part] : {std::pair{"", 1}, {"right", 2}, {"sheen", 2}, {"albedo", 3}}) {
      const auto image = readImage(path, {.layer = name}, nullptr, {});
      EXPECT_OK(image);
      QCOMPARE(image.value().layer.part, part);
      const auto red = static_cast<std::size_t>((*image.value().layer.colors)[0]);
      EXPECT_NEAR(pixelOf(image.value().channels[red], 1, 1),
                  part + (std::string(name) == "sheen" ? 0.3 : 0.0), 1e-3);
    }
  }

  // Which layer is read where none is chosen is said, or left open.
  void whatIsReadIsSaid() {
    const auto said = [&](const std::filesystem::path& path, const std::string& layer) {
      test::Listener listener;
      const auto image = readImage(path, {.layer = layer}, nullptr, listener.context());
      return std::pair(image && image.value().isLayerOpen(), listener.sentences);
    };
    using Sentences = std::vector<std::string>;
    const auto one = write("one.exr", {{"", {"Z", "albedo.R", "albedo.G", "albedo.B"}}});
    QVERIFY(said(one, "") ==
            std::pair(false, Sentences{one.string() + ": the layer 'albedo' is read, the only one "
                                                      "with colours"}));
    QVERIFY(said(one, "albedo").second.empty());
    const auto eyes = write("eyes.exr", {{"left", {"R", "G", "B"}}, {"right", {"R", "G", "B"}}});
    QVERIFY(said(eyes, "") ==
            std::pair(false, Sentences{eyes.string() + ": 'left' is read; 'right' has colours, "
                                                       "too, and can be chosen as the layer"}));
    QVERIFY(said(eyes, "right").second.empty());
    const auto two =
        write("two.exr",
              {{"", {"albedo.R", "albedo.G", "albedo.B", "diffuse.R", "diffuse.G", "diffuse.B"}}});
    QVERIFY(said(two, "").first);
    QVERIFY(said(two, "diffuse") == std::pair(false, Sentences{}));
    const auto plain = write("plain.exr", {{"", {"R", "G", "B", "spec.R", "spec.G", "spec.B"}}});
    QVERIFY(said(plain, "") == std::pair(false, Sentences{}));
  }

  void otherFormatsHoldOne() {
    EXPECT_OK(writeImage(folder_.path("one.tif"),
                         test::makeContent(4, 4, {"R", "G", "B", "A", "pores"}), SampleType::uint16,
                         {}));
    const auto layers = listLayers(folder_.path("one.tif"), {});
    EXPECT_OK(layers);
    QCOMPARE(layers.value().size(), std::size_t{1});
    QCOMPARE(layers.value()[0].alpha, 3);
    QCOMPARE(layers.value()[0].channelNames.size(), std::size_t{5});
  }

  // A type counts where it is asked for: an identifier beside half colours widens nothing.
  void typesAreThoseOfTheLayer() {
    OIIO::ImageSpec spec(4, 4, 4, OIIO::TypeHalf);
    spec.channelnames = {"R", "G", "B", "depth.Z"};
    spec.channelformats = {OIIO::TypeHalf, OIIO::TypeHalf, OIIO::TypeHalf, OIIO::TypeFloat};
    test::writeForeign(folder_.path("mixed.exr"), "openexr", spec, test::noise(64));
    QVERIFY(readImageHeader(folder_.path("mixed.exr"), {}).value().sourceType == SampleType::half);
  }
};

CUTIS_TEST(ImageLayersTest)

}  // namespace
}  // namespace cutis

#include "image_layers_test.moc"
