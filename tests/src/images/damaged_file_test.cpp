#include <random>

#include <QtTest>

#include "src/images/image_file.h"
#include "src/images/maps/maps_file.h"
#include "tests/src/images/image_fixture.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

using test::ImageFolder;

constexpr int kCorruptions = 20;

// Small files of every kind that is read.
class DamagedFileTest : public QObject {
  Q_OBJECT

  ImageFolder folder_;
  std::vector<std::string> files_;

  void own(const char* name, SampleType type, const std::vector<std::string>& channels) {
    QVERIFY(writeImage(folder_.path(name), test::makeContent(90, 70, channels), type, {}));
    files_.push_back(name);
  }
  void foreign(const char* name, const char* format, OIIO::ImageSpec spec,
               const char* compression = "") {
    if (*compression != '\0') spec.attribute("compression", compression);
    const auto count = static_cast<std::size_t>(spec.width * spec.height * spec.nchannels);
    test::writeForeign(folder_.path(name), format, spec, test::noise(count));
    files_.push_back(name);
  }

  static Result<Image> read(const std::filesystem::path& path) {
    return readImage(path, {PixelFormat::float32}, nullptr, {});
  }

  // Whatever the outcome: one sentence that names the file.
  template <typename T>
  static void check(const Result<T>& result, const std::string& name) {
    if (result) return;
    QVERIFY(result.failed());
    const std::string sentence = result.error().text();
    QVERIFY2(sentence.find(name) != std::string::npos, sentence.c_str());
    QVERIFY2(sentence.find_first_of("\r\n") == std::string::npos, sentence.c_str());
    QVERIFY2(sentence.find(';') != std::string::npos, sentence.c_str());
    QVERIFY2(sentence.size() < 700, sentence.c_str());
  }

 private slots:
  void initTestCase() {
    own("a.png", SampleType::uint8, {"R", "G", "B"});
    own("b.png", SampleType::uint16, {"R", "G", "B", "A"});
    own("c.tif", SampleType::uint8, {"R", "G", "B"});
    own("d.tif", SampleType::float32, {"R", "G", "B"});
    own("e.exr", SampleType::half, {"R", "G", "B"});
    own("f.exr", SampleType::float32, {"R", "G", "B", "A"});
    own("g.jpg", SampleType::uint8, {"R", "G", "B"});
    OIIO::ImageSpec color(90, 70, 3, OIIO::TypeUInt8);
    foreign("h.bmp", "bmp", color);
    foreign("i.tga", "targa", color);
    foreign("j.hdr", "hdr", OIIO::ImageSpec(90, 70, 3, OIIO::TypeFloat));
    foreign("k.tif", "tiff", color, "none");
    foreign("l.tif", "tiff", color, "lzw");
    foreign("m.tif", "tiff", color, "jpeg");
    OIIO::ImageSpec tiled(90, 70, 3, OIIO::TypeHalf);
    tiled.tile_width = tiled.tile_height = 32;
    foreign("n.tif", "tiff", tiled);
    for (const char* compression : {"none", "rle", "zips", "piz", "pxr24", "b44", "dwaa"}) {
      foreign(qPrintable(QString("o_%1.exr").arg(compression)), "openexr", tiled, compression);
      OIIO::ImageSpec rows(90, 70, 3, OIIO::TypeHalf);
      foreign(qPrintable(QString("p_%1.exr").arg(compression)), "openexr", rows, compression);
    }
    MapsFile maps;
    maps.maps = ChromophoreMaps(90, 70);
    maps.attributes.profileName = "li2024";
    maps.attributes.profileJson = "{}";
    maps.attributes.sources = {{"a.png", "0123"}};
    maps.residuals = {maps.maps.values[0]};
    maps.residualNames = {"white.R"};
    EXPECT_OK(writeMaps(folder_.path("maps.exr"), maps, {}));
    files_.push_back("maps.exr");
  }

  void soundFilesAreRead() {
    for (const std::string& file : files_) {
      const auto image = read(folder_.path(file));
      EXPECT_OK(image);
      QCOMPARE(image.value().width, 90);
    }
  }

  void cutOffFilesAreTold() {
    for (const std::string& file : files_) {
      const QByteArray whole = test::readBytes(folder_.path(file));
      const bool maps = file == "maps.exr";
      const std::string name = "cut" + std::filesystem::path(file).extension().string();
      for (const double share : {0.0, 0.002, 0.01, 0.05, 0.2, 0.5, 0.8, 0.95}) {
        const auto length = static_cast<qsizetype>(share * static_cast<double>(whole.size()));
        test::writeBytes(folder_.path(name), whole.left(length));
        if (maps) {
          const auto result = readMaps(folder_.path(name), PixelFormat::float32, nullptr, {});
          QVERIFY2(result.failed(), qPrintable(QString("maps at %1").arg(share)));
          check(result, name);
          continue;
        }
        const auto result = read(folder_.path(name));
        QVERIFY2(result.failed(),
                 qPrintable(QString("%1 at %2").arg(QString::fromStdString(file)).arg(share)));
        check(result, name);
      }
    }
  }

  // Two letters do not make a bitmap.
  void textsAreNoBitmaps() {
    for (const char* text : {"BM", "BMI of the subjects, by year\n2024;23.5\n"}) {
      test::writeBytes(folder_.path("text.txt"), text);
      EXPECT_ERROR(read(folder_.path("text.txt")), "this is not an image of a supported kind");
    }
  }

  void theLastByteCounts() {
    for (const char* file : {"a.png", "e.exr", "g.jpg", "k.tif", "m.tif", "maps.exr"}) {
      const QByteArray whole = test::readBytes(folder_.path(file));
      const std::string name = "last" + std::filesystem::path(file).extension().string();
      // A TIFF written in one go ends in its directory, a JPEG in a marker.
      test::writeBytes(folder_.path(name), whole.left(whole.size() - 2));
      QVERIFY2(read(folder_.path(name)).failed() || std::string(file) == "maps.exr", file);
    }
  }

  void corruptionNeverCrashes() {
    std::mt19937 random(20240601);
    const auto below = [&](qsizetype n) {
      return static_cast<qsizetype>(random() %
                                    static_cast<std::uint32_t>(std::max<qsizetype>(n, 1)));
    };
    int survived = 0, refused = 0;
    for (const std::string& file : files_) {
      const QByteArray whole = test::readBytes(folder_.path(file));
      const std::string name = "bad" + std::filesystem::path(file).extension().string();
      for (int i = 0; i < kCorruptions; ++i) {
        QByteArray bytes = whole;
        // Headers are short and decide most: half of the damage goes there.
        const qsizetype reach = i % 2 == 0 ? std::min<qsizetype>(whole.size(), 400) : whole.size();
        const qsizetype count = 1 + below(i % 5 == 4 ? 64 : 6);
        for (qsizetype k = 0; k < count; ++k)
          bytes[below(reach)] = static_cast<char>(random());
        if (i % 7 == 6) {
          const qsizetype at = below(whole.size());
          bytes.replace(at, std::min<qsizetype>(50, whole.size() - at), QByteArray(50, '\xff'));
        }
        test::writeBytes(folder_.path(name), bytes);
        const auto image = read(folder_.path(name));
        check(image, name);
        ++(image ? survived : refused);
        if (file != "maps.exr") continue;
        check(readMaps(folder_.path(name), PixelFormat::float32, nullptr, {}), name);
        (void)isMapsFile(folder_.path(name));
      }
    }
    qInfo("%d damaged files were read all the same, %d were refused", survived, refused);
  }
};

CUTIS_TEST(DamagedFileTest)

}  // namespace
}  // namespace cutis

#include "damaged_file_test.moc"
