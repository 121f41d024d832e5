// OpenEXR pictures that were changed and are written as OpenEXR keep all that was not changed.

#include <array>
#include <cstring>

#include <OpenImageIO/imageio.h>
#include <QtTest>

#include "src/images/image_file.h"
#include "tests/src/images/image_fixture.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

using test::ImageFolder;

// A level of a part as it is stored, sample for sample.
struct Stored {
  OIIO::ImageSpec spec;
  std::vector<unsigned char> bytes;
};

std::vector<std::vector<Stored>> storedIn(const std::filesystem::path& path) {
  std::vector<std::vector<Stored>> parts;
  const auto input = OIIO::ImageInput::open(path.string());
  if (!input) qFatal("cannot open");
  for (int part = 0; input->seek_subimage(part, 0); ++part) {
    parts.emplace_back();
    for (int level = 0; input->seek_subimage(part, level); ++level) {
      Stored stored = {input->spec(part, level), {}};
      stored.bytes.resize(stored.spec.image_bytes(true));
      input->read_image(part, level, 0, -1, OIIO::TypeUnknown, stored.bytes.data());
      parts.back().push_back(std::move(stored));
    }
  }
  return parts;
}

bool sameLayout(const OIIO::ImageSpec& a, const OIIO::ImageSpec& b) {
  return a.x == b.x && a.y == b.y && a.width == b.width && a.height == b.height &&
         a.full_x == b.full_x && a.full_y == b.full_y && a.full_width == b.full_width &&
         a.full_height == b.full_height && a.tile_width == b.tile_width &&
         a.tile_height == b.tile_height && a.channelnames == b.channelnames &&
         a.format == b.format && a.channelformats == b.channelformats &&
         a.get_float_attribute("PixelAspectRatio") == b.get_float_attribute("PixelAspectRatio") &&
         a.get_string_attribute("oiio:subimagename") == b.get_string_attribute("oiio:subimagename");
}

// All of a file's samples at their places.
bool isSame(const std::filesystem::path& a, const std::filesystem::path& b) {
  const auto first = storedIn(a), second = storedIn(b);
  if (first.size() != second.size()) return false;
  for (std::size_t p = 0; p < first.size(); ++p) {
    if (first[p].size() != second[p].size()) return false;
    for (std::size_t l = 0; l < first[p].size(); ++l) {
      if (!sameLayout(first[p][l].spec, second[p][l].spec)) return false;
      if (first[p][l].bytes != second[p][l].bytes) return false;
    }
  }
  return true;
}

struct Level {
  int width = 0;
  int height = 0;
};

void writeLevels(const std::filesystem::path& path, OIIO::ImageSpec spec,
                 const std::vector<Level>& levels) {
  const auto output = OIIO::ImageOutput::create("openexr");
  for (std::size_t l = 0; l < levels.size(); ++l) {
    OIIO::ImageSpec level = spec;
    level.width = levels[l].width;
    level.height = levels[l].height;
    const auto mode = l == 0 ? OIIO::ImageOutput::Create : OIIO::ImageOutput::AppendMIPLevel;
    const auto count = static_cast<std::size_t>(level.width * level.height * level.nchannels);
    if (!output->open(path.string(), level, mode) ||
        !output->write_image(OIIO::TypeFloat,
                             test::noise(count, static_cast<unsigned>(l) + 1).data())) {
      qFatal("cannot write a level");
    }
  }
  output->close();
}

class ExrEditionTest : public QObject {
  Q_OBJECT

  ImageFolder folder_;
  test::Listener listener_;

  // The picture of a file as content, its first colour changed by a factor.
  ImageContent contentOf(const std::filesystem::path& path, float factor,
                         const std::string& layer = {}) {
    const auto read = readImage(path, {.layer = layer, .overscan = true}, nullptr, {});
    if (!read) qFatal("cannot read");
    const Image& image = read.value();
    ImageContent content;
    content.channelNames = image.channelNames;
    content.channels = image.channels;
    content.metadata = image.metadata;
    content.alphaKind = image.alphaKind;
    content.source = image;
    content.sourceHash = image.contentHash;
    const auto red = static_cast<std::size_t>((*image.layer.colors)[0]);
    const std::vector<float> values = test::valuesOf(image.channels[red]);
    content.channels[red] = test::makePlane(image.width, image.height, [&](int x, int y) {
      return factor * values[static_cast<std::size_t>(y * image.width + x)];
    });
    return content;
  }

  void write(const std::filesystem::path& path, const ImageContent& content) {
    listener_.sentences.clear();
    EXPECT_OK(writeImage(path, content, SampleType::half, listener_.context()));
  }

 private Q_SLOTS:
  void windowsTypesAndAspectStay() {
    OIIO::ImageSpec spec(48, 40, 6, OIIO::TypeHalf);
    spec.channelnames = {"R", "G", "B", "A", "Z", "id"};
    spec.channelformats = {OIIO::TypeHalf, OIIO::TypeHalf,  OIIO::TypeHalf,
                           OIIO::TypeHalf, OIIO::TypeFloat, OIIO::TypeUInt32};
    spec.x = -8;
    spec.y = -6;
    spec.full_x = 0;
    spec.full_y = 0;
    spec.full_width = 32;
    spec.full_height = 24;
    spec.attribute("PixelAspectRatio", 2.0f);
    const auto path = folder_.path("windows.exr"), same = folder_.path("same.exr");
    test::writeForeign(path, "openexr", spec, test::noise(48 * 40 * 6));
    write(same, contentOf(path, 1.0f));
    QVERIFY(listener_.sentences.empty());
    QVERIFY(isSame(path, same));
    const auto changed = folder_.path("changed.exr");
    write(changed, contentOf(path, 0.5f));
    const auto before = storedIn(path), after = storedIn(changed);
    QVERIFY(sameLayout(before[0][0].spec, after[0][0].spec));
    QVERIFY(before[0][0].bytes != after[0][0].bytes);
    // Only the first channel, the first two bytes of a pixel, differs.
    const std::size_t pixel = before[0][0].spec.pixel_bytes(true);
    for (std::size_t i = 0; i < before[0][0].bytes.size(); ++i) {
      if (i % pixel >= 2) QCOMPARE(after[0][0].bytes[i], before[0][0].bytes[i]);
    }
    // Elsewhere only the display window has a place, and that is said.
    listener_.sentences.clear();
    EXPECT_OK(writeImage(folder_.path("window.png"), contentOf(path, 1.0f), SampleType::uint16,
                         listener_.context()));
    QCOMPARE(readImageHeader(folder_.path("window.png"), {}).value().width, 32);
    QVERIFY(listener_.sentences.size() >= 3);  // overscan, pixel aspect, channels
  }

  void tilesAndLevelsStay() {
    for (const std::vector<Level>& levels :
         {std::vector<Level>{{64, 64}, {32, 32}, {16, 16}, {8, 8}, {4, 4}, {2, 2}, {1, 1}},
          std::vector<Level>{{37, 21}, {18, 10}, {9, 5}, {4, 2}, {2, 1}, {1, 1}},
          std::vector<Level>{{70, 50}}}) {
      OIIO::ImageSpec spec(levels[0].width, levels[0].height, 3, OIIO::TypeHalf);
      spec.tile_width = 16;
      spec.tile_height = 8;
      if (levels.size() > 1) spec.attribute("textureformat", "Plain Texture");
      const auto path = folder_.path("levels.exr"), same = folder_.path("same.exr");
      writeLevels(path, spec, levels);
      QCOMPARE(storedIn(path)[0].size(), levels.size());
      write(same, contentOf(path, 1.0f));
      QVERIFY(listener_.sentences.empty());
      QVERIFY(isSame(path, same));
      const auto changed = folder_.path("changed.exr");
      write(changed, contentOf(path, 0.5f));
      const auto before = storedIn(path), after = storedIn(changed);
      for (std::size_t l = 0; l < levels.size(); ++l) {
        QVERIFY(sameLayout(before[0][l].spec, after[0][l].spec));
        QVERIFY(before[0][l].bytes != after[0][l].bytes);
      }
    }
  }

  void partsStay() {
    const auto path = folder_.path("parts.exr"), same = folder_.path("same.exr");
    test::writeForeignParts(path, {{"beauty", {"R", "G", "B", "A"}},
                                   {"depth", {"Z"}},
                                   {"albedo", {"albedo.R", "albedo.G", "albedo.B"}}});
    for (const char* layer : {"", "albedo"}) {
      write(same, contentOf(path, 1.0f, layer));
      QVERIFY(listener_.sentences.empty());
      QVERIFY(isSame(path, same));
    }
    const auto changed = folder_.path("changed.exr");
    write(changed, contentOf(path, 0.5f, "albedo"));
    const auto before = storedIn(path), after = storedIn(changed);
    QVERIFY(after[0][0].bytes == before[0][0].bytes);
    QVERIFY(after[1][0].bytes == before[1][0].bytes);
    QVERIFY(after[2][0].bytes != before[2][0].bytes);
    // A format without layers takes the one that was chosen.
    listener_.sentences.clear();
    EXPECT_OK(writeImage(folder_.path("albedo.png"), contentOf(path, 1.0f, "albedo"),
                         SampleType::uint8, listener_.context()));
    QCOMPARE(readImageHeader(folder_.path("albedo.png"), {}).value().channelNames.size(),
             std::size_t{3});
    // The other parts are left out, and values above 1 are clipped.
    QCOMPARE(listener_.sentences.size(), std::size_t{2});
  }

  // What loses nothing stays; what would lose more with each writing is replaced, and that is said.
  void compressionStaysUnlessItLoses_data() {
    QTest::addColumn<QString>("given");
    QTest::addColumn<bool>("isFloat");
    QTest::addColumn<QString>("written");
    for (const char* same : {"none", "rle", "zips", "zip", "piz", "pxr24"})
      QTest::newRow(same) << same << false << same;
    QTest::newRow("pxr24 of floats") << "pxr24" << true << "zip";
    for (const char* lossy : {"dwaa:60", "dwab:45", "b44", "b44a"})
      QTest::newRow(lossy) << lossy << false << "zip";
  }
  void compressionStaysUnlessItLoses() {
    QFETCH(QString, given);
    QFETCH(bool, isFloat);
    QFETCH(QString, written);
    OIIO::ImageSpec spec(48, 40, 3, isFloat ? OIIO::TypeFloat : OIIO::TypeHalf);
    spec.attribute("compression", given.toStdString());
    const auto path = folder_.path("packed.exr"), same = folder_.path("same.exr");
    test::writeForeign(path, "openexr", spec, test::noise(48 * 40 * 3));
    listener_.sentences.clear();
    EXPECT_OK(writeImage(same, contentOf(path, 1.0f),
                         isFloat ? SampleType::float32 : SampleType::half, listener_.context()));
    const auto compression = storedIn(same)[0][0].spec.get_string_attribute("compression");
    QCOMPARE(QString::fromStdString(std::string(compression)), written);
    const bool isKept = given == written;
    QCOMPARE(listener_.sentences.size(), std::size_t{isKept ? 0U : 1U});
    if (!isKept) {
      QVERIFY(listener_.sentences[0].find("is compressed with " +
                                          given.split(':').front().toStdString()) !=
              std::string::npos);
    }
  }

  void aChangedSourceIsSaid() {
    const auto path = folder_.path("gone.exr");
    test::writeForeignParts(path, {{"beauty", {"R", "G", "B"}}, {"depth", {"Z"}}});
    const ImageContent content = contentOf(path, 0.5f);
    std::filesystem::remove(path);
    write(folder_.path("alone.exr"), content);
    QVERIFY(!listener_.sentences.empty());
    QVERIFY(listener_.sentences[0].find("has changed since it was opened") != std::string::npos);
    QCOMPARE(storedIn(folder_.path("alone.exr")).size(), std::size_t{1});
  }
};

CUTIS_TEST(ExrEditionTest)

}  // namespace
}  // namespace cutis

#include "exr_edition_test.moc"
