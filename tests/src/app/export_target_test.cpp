#include "src/app/export/export_target.h"

#include <QtTest>

#include "tests/support/expect.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

ImageHeader textureOf(SampleType type) {
  ImageHeader header;
  header.sourceType = type;
  return header;
}

class ExportTargetTest : public QObject {
  Q_OBJECT

 private slots:
  void theSourcesTypeAndSpaceStayWhereTheFormatHasThem_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<int>("source");
    QTest::addColumn<int>("type");
    QTest::addColumn<QString>("space");
    using enum SampleType;
    QTest::newRow("same") << "a.png" << int(uint16) << int(uint16) << "Display P3";
    QTest::newRow("integers") << "a.jpg" << int(uint16) << int(uint8) << "Display P3";
    QTest::newRow("to floats") << "a.exr" << int(uint8) << int(half) << "Linear Rec.709";
    QTest::newRow("to integers") << "a.png" << int(half) << int(uint16) << "sRGB";
    QTest::newRow("the next wider") << "a.tif" << int(half) << int(float32) << "Display P3";
    QTest::newRow("wider integers") << "a.exr" << int(uint16) << int(float32) << "Linear Rec.709";
    QTest::newRow("doubles") << "a.exr" << int(float64) << int(float32) << "Display P3";
    QTest::newRow("narrower") << "a.jpg" << int(float32) << int(uint8) << "sRGB";
    QTest::newRow("case") << "a.EXR" << int(float32) << int(float32) << "Display P3";
  }
  void theSourcesTypeAndSpaceStayWhereTheFormatHasThem() {
    QFETCH(QString, file);
    QFETCH(int, source);
    QFETCH(int, type);
    QFETCH(QString, space);
    const ImageHeader texture = textureOf(static_cast<SampleType>(source));
    std::vector<std::string> notes;
    JobContext context;
    context.notice = [&](const std::string& note) { notes.push_back(note); };
    const auto found = encodingFor({file.toStdString()}, &texture, "Display P3", context);
    EXPECT_OK(found);
    QCOMPARE(int(found.value().sampleType), type);
    QCOMPARE(QString::fromStdString(found.value().colorSpace), space);
    QCOMPARE(notes.size(), std::size_t{type == source ? 0u : 1u});
  }

  void whatIsAskedForIsTaken() {
    ExportTarget target = {"a.exr"};
    target.sampleType = SampleType::float32;
    target.colorSpace = "acescg";
    const auto found = encodingFor(target, nullptr, {}, {});
    EXPECT_OK(found);
    QVERIFY(found.value().sampleType == SampleType::float32);
    QCOMPARE(found.value().colorSpace, std::string("ACEScg"));
  }

  void whatIsReadIsNotWrittenOver() {
    const std::string photograph = folder_.write("cap/white.exr", "x").string();
    folder_.write("cap/capture.json",
                  R"({"cutis_capture": 1, "images": [{"light": "white", "file": "white.exr"}]})");
    ExportTarget target = {photograph};
    target.sources = {(folder_ / "cap").string()};
    EXPECT_ERROR(checkPictureTarget(target), "sources are never written to");
    EXPECT_ERROR(checkMapsTarget(target), "sources are never written to");
    target.path = folder_ / "cap" / "new.exr";
    EXPECT_OK(checkPictureTarget(target));
    target.inputs = {target.path.string()};
    EXPECT_ERROR(checkPictureTarget(target), "sources are never written to");
  }

  void otherFormatsAreRefused() {
    EXPECT_ERROR(checkPictureTarget({folder_ / "a.gif"}), ".exr, .tif, .png or .jpg");
    EXPECT_ERROR(checkMapsTarget({folder_ / "a.tif"}), "OpenEXR");
    EXPECT_OK(checkMapsTarget({folder_ / "A.EXR"}));
  }

 private:
  test::ScratchFolder folder_;
};

CUTIS_TEST(ExportTargetTest)

}  // namespace
}  // namespace cutis

#include "export_target_test.moc"
