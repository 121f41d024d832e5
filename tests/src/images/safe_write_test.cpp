#include <csignal>
#include <sys/resource.h>

#include <QtTest>

#include "src/images/codec/metadata.h"
#include "src/images/image_file.h"
#include "src/images/maps/maps_file.h"
#include "tests/src/images/image_fixture.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

using test::ImageFolder;
using test::makeContent;

// Files of this process cannot grow beyond a size, as on a full disk.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) {
    previous_ = std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &limit_);
    rlimit small = limit_;
    small.rlim_cur = bytes;
    setrlimit(RLIMIT_FSIZE, &small);
  }
  ~FullDisk() {
    setrlimit(RLIMIT_FSIZE, &limit_);
    std::signal(SIGXFSZ, previous_);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  rlimit limit_ = {};
  void (*previous_)(int) = nullptr;
};

class SafeWriteTest : public QObject {
  Q_OBJECT

  ImageFolder folder_;

  Image cameraPhotograph() {
    OIIO::ImageSpec spec(16, 16, 3, OIIO::TypeUInt8);
    spec.attribute("Make", "Canon");
    spec.attribute("Model", "EOS R");
    spec.attribute("Exif:DateTimeOriginal", "2024:01:02 03:04:05");
    spec.attribute("ExposureTime", 0.008f);
    spec.attribute("Copyright", "somebody");
    test::writeForeign(folder_.path("camera.jpg"), "jpeg", spec, test::noise(16 * 16 * 3));
    return readImage(folder_.path("camera.jpg"), {PixelFormat::float32}, nullptr, {}).value();
  }

  static ImageContent contentOf(const Image& image) {
    ImageContent content;
    content.channelNames = image.channelNames;
    content.channels = image.channels;
    content.metadata = image.metadata;
    return content;
  }

 private slots:
  void fullDisksLeaveTheOldFile_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<int>("type");
    for (const auto& [file, type] :
         {std::pair{"a.png", SampleType::uint8}, std::pair{"b.png", SampleType::uint16},
          std::pair{"c.tif", SampleType::uint8}, std::pair{"d.tif", SampleType::float32},
          std::pair{"e.exr", SampleType::half}, std::pair{"f.exr", SampleType::float32},
          std::pair{"g.jpg", SampleType::uint8}}) {
      QTest::newRow(file) << QString(file) << static_cast<int>(type);
    }
  }
  void fullDisksLeaveTheOldFile() {
    QFETCH(QString, file);
    QFETCH(int, type);
    const auto path = folder_.path(file.toStdString());
    test::writeBytes(path, "the old content");
    const auto before = folder_.names();
    const ImageContent content = makeContent(700, 700, {"R", "G", "B"});
    for (const rlim_t room : {0u, 100u, 5000u, 60000u}) {
      Status written;
      {
        const FullDisk disk(room);
        written = writeImage(path, content, static_cast<SampleType>(type), {});
      }
      EXPECT_ERROR(written, "free");
      QVERIFY(written.error().kind == ErrorKind::resource);
      QVERIFY(written.error().text().find(file.toStdString()) != std::string::npos);
      QVERIFY(written.error().text().find("partial") == std::string::npos);
      QCOMPARE(test::readBytes(path), QByteArray("the old content"));
      QVERIFY(folder_.names() == before);
    }
    EXPECT_OK(writeImage(path, content, static_cast<SampleType>(type), {}));
  }

  void fullDisksLeaveTheOldMaps() {
    const auto path = folder_.path("maps.exr");
    test::writeBytes(path, "the old maps");
    MapsFile maps;
    maps.maps = ChromophoreMaps(500, 500);
    const ImageContent noisy = makeContent(500, 500, {"a", "b", "c", "d", "e"});
    std::copy(noisy.channels.begin(), noisy.channels.end(), maps.maps.values.begin());
    for (const rlim_t room : {0u, 3000u, 100000u}) {
      Status written;
      {
        const FullDisk disk(room);
        written = writeMaps(path, maps, {});
      }
      QVERIFY(written.failed());
      QCOMPARE(test::readBytes(path), QByteArray("the old maps"));
    }
    EXPECT_OK(writeMaps(path, maps, {}));
  }

  void stoppedWritesLeaveTheOldFile() {
    const ImageContent content = makeContent(900, 2000, {"R", "G", "B"});
    for (const auto& [file, type] :
         {std::pair{"s.png", SampleType::uint8}, std::pair{"s.tif", SampleType::float32},
          std::pair{"s.exr", SampleType::half}, std::pair{"s.jpg", SampleType::uint8}}) {
      test::writeBytes(folder_.path(file), "the old content");
      const auto before = folder_.names();
      test::Stopper stopper;
      QVERIFY(writeImage(folder_.path(file), content, type, stopper.context()).cancelled());
      QCOMPARE(test::readBytes(folder_.path(file)), QByteArray("the old content"));
      QVERIFY(folder_.names() == before);
    }
  }

  void aFolderInTheWayIsTold() {
    std::filesystem::create_directory(folder_.path("folder.exr"));
    EXPECT_ERROR(
        writeImage(folder_.path("folder.exr"), makeContent(4, 4, {"Y"}), SampleType::half, {}),
        "this is a folder");
  }

  void metadataIsCarriedOver() {
    const Image camera = cameraPhotograph();
    for (const auto& [file, type] :
         {std::pair{"meta.exr", SampleType::half}, std::pair{"meta.tif", SampleType::uint16},
          std::pair{"meta.png", SampleType::uint8}, std::pair{"meta.jpg", SampleType::uint8}}) {
      EXPECT_OK(writeImage(folder_.path(file), contentOf(camera), type, {}));
      const auto header = readImageHeader(folder_.path(file), {});
      EXPECT_OK(header);
      const ImageMetadata& metadata = header.value().metadata;
      QCOMPARE(metadata.text("Make").value_or(""), std::string("Canon"));
      QCOMPARE(metadata.text("Model").value_or(""), std::string("EOS R"));
      QCOMPARE(metadata.text("Exif:DateTimeOriginal").value_or(""),
               std::string("2024:01:02 03:04:05"));
      QCOMPARE(metadata.text("Copyright").value_or(""), std::string("somebody"));
    }
  }

  void storageIsNotMetadata() {
    const Image camera = cameraPhotograph();
    for (const std::string& name : camera.metadata.names()) {
      for (const char* storage :
           {"oiio:", "jpeg:", "Exif:ColorSpace", "ICCProfile", "compression"}) {
        QVERIFY2(name.find(storage) == std::string::npos, name.c_str());
      }
    }
    QVERIFY(ImageMetadata().empty());
    QVERIFY(ImageMetadata().names().empty() && !ImageMetadata().text("Make"));
  }

  // Names that mean something else in an EXR header, names and values of absurd size.
  void hostileMetadataDoesNotKeepFromWriting() {
    OIIO::ImageSpec spec(8, 8, 3, OIIO::TypeUInt8);
    for (const char* name : {"channels",
                             "dataWindow",
                             "displayWindow",
                             "lineOrder",
                             "compression",
                             "type",
                             "name",
                             "tiles",
                             "chunkCount",
                             "version",
                             "preview",
                             "pixelAspectRatio",
                             "envmap",
                             "view",
                             "multiView",
                             "chromaticities",
                             "keyCode",
                             "timeCode",
                             "framesPerSecond",
                             "owner",
                             "worldToCamera",
                             "isoSpeed",
                             "dwaCompressionLevel",
                             "screenWindowWidth",
                             "xDensity",
                             "Orientation",
                             "PixelAspectRatio",
                             "cutis:version",
                             "oiio:ColorSpace",
                             "a b c",
                             "ü"}) {
      spec.attribute(name, "nonsense");
    }
    spec.attribute(std::string(79, 'n'), "long name");
    spec.attribute("big", std::string(1 << 20, 'v'));
    test::writeForeign(folder_.path("hostile.png"), "png", spec, test::noise(8 * 8 * 3));
    const auto image = readImage(folder_.path("hostile.png"), {PixelFormat::float32}, nullptr, {});
    EXPECT_OK(image);
    for (const auto& [file, type] :
         {std::pair{"out.exr", SampleType::half}, std::pair{"out.tif", SampleType::uint8},
          std::pair{"out.png", SampleType::uint8}, std::pair{"out.jpg", SampleType::uint8}}) {
      EXPECT_OK(writeImage(folder_.path(file), contentOf(image.value()), type, {}));
      EXPECT_OK(readImage(folder_.path(file), {PixelFormat::float32}, nullptr, {}));
    }
    MapsFile maps;
    maps.maps = ChromophoreMaps(8, 8);
    maps.metadata = image.value().metadata;
    EXPECT_OK(writeMaps(folder_.path("out_maps.exr"), maps, {}));
    EXPECT_OK(readMaps(folder_.path("out_maps.exr"), PixelFormat::float32, nullptr, {}));
  }
};

CUTIS_TEST(SafeWriteTest)

}  // namespace
}  // namespace cutis

#include "safe_write_test.moc"
