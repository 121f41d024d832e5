// A document whose source is read in another way, or fitted at another exposure: edits are kept,
// and a project remembers it.

#include <QSignalSpy>
#include <QtTest>

#include "src/app/document/document.h"
#include "src/images/capture/capture_file.h"
#include "tests/src/app/project_fixture.h"
#include "tests/support/expect.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_registry.h"

namespace cutis::test {
namespace {

namespace reopen {

constexpr int kPatienceMs = 120000;

struct Desk {
  JobRunner jobs;
  Document document;
  QSignalSpy failed{&document, &Document::failed};
  QSignalSpy opened{&document, &Document::opened};

  explicit Desk(Engine& engine) : document(engine, jobs) {}
  ~Desk() { jobs.stopAll(); }

  bool isDone() const { return document.isOpen() && document.isFitted() && jobs.isIdle(); }
  bool wait() {
    return QTest::qWaitFor([this] { return isDone(); }, kPatienceMs);
  }
  bool open(const std::filesystem::path& path) {
    document.open(path);
    return wait();
  }
  bool save(const std::filesystem::path& path) {
    document.save(path);
    return QTest::qWaitFor([this] { return !document.isSaving(); }, kPatienceMs);
  }
  void tan() {
    document.apply({"melanin",
                    {},
                    [](DocumentState& state) {
                      state.edits.emplace_back();
                      state.edits.front().parameters[kMelanin].scale = 2.0;
                    },
                    false});
  }
  double melanin() const { return document.scene().edits.front().parameters[kMelanin].scale; }
  double exposure() const { return document.scene().source->measurements.exposure; }
  std::size_t lightCount() const { return document.scene().source->measurements.rig.lights.size(); }
};

}  // namespace reopen

class DocumentReopenTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void anExposureIsChosenAndFoundAgain() {
    const ScratchFolder folder;
    writeTexture(folder / "face.png");
    reopen::Desk desk(engine_);
    QVERIFY(desk.open(folder / "face.png"));
    desk.tan();
    const double found = desk.exposure();
    QVERIFY(desk.document.shareInRange().has_value());
    FitChoice choice = desk.document.fitChoice();
    choice.exposure = 0.5;
    desk.document.fitWith(choice);
    QVERIFY(desk.wait());
    QCOMPARE(desk.exposure(), 0.5);
    QVERIFY(!desk.document.shareInRange());
    QVERIFY2(desk.opened.count() == 1, "no file is read for it");
    QVERIFY(desk.save(folder / "face.cutis"));
    reopen::Desk again(engine_);
    QVERIFY(again.open(folder / "face.cutis"));
    QVERIFY(again.document.fitChoice() == choice);
    QCOMPARE(again.exposure(), 0.5);
    choice.exposure.reset();
    again.document.fitWith(choice);
    QVERIFY(again.wait());
    QCOMPARE(again.exposure(), found);
    QVERIFY(again.document.isModified());
    QCOMPARE(again.melanin(), 2.0);
    choice.exposure = -1.0;
    again.document.fitWith(choice);
    QVERIFY(again.failed.takeLast()[0].toString().contains("positive"));
    QCOMPARE(again.exposure(), found);
  }

  // Cancelled, the exposure is again that of the maps.
  void aCancelledFitTakesItsExposureAlong() {
    const ScratchFolder folder;
    writeTexture(folder / "face.png");
    reopen::Desk desk(engine_);
    QVERIFY(desk.open(folder / "face.png"));
    const double found = desk.exposure();
    FitChoice choice = desk.document.fitChoice();
    choice.exposure = 0.5;
    desk.document.fitWith(choice);
    choice.exposure.reset();
    desk.document.fitWith(choice);
    QVERIFY(desk.wait());
    QCOMPARE(desk.exposure(), found);
    QVERIFY(!desk.document.fitChoice().exposure);
  }

  void lightsAndReflectionAreOfTheFit() {
    const ScratchFolder folder;
    {
      reopen::Desk sample(engine_);
      sample.document.openSample();
      QVERIFY(sample.wait());
      EXPECT_OK(
          writeCapture(folder / "capture", sample.document.scene().source->measurements, {}, {}));
    }
    reopen::Desk desk(engine_);
    QVERIFY(desk.open(folder / "capture"));
    desk.tan();
    QCOMPARE(desk.lightCount(), std::size_t{3});
    QCOMPARE(desk.document.scene().source->lights.size(), std::size_t{3});
    FitChoice choice = desk.document.fitChoice();
    choice.specular = SpecularPart::included;
    choice.specularShare = 0.03;
    const std::string light = desk.document.scene().source->lights.front();
    desk.document.fitWith(choice, {light});
    QVERIFY(desk.wait());
    QCOMPARE(desk.lightCount(), std::size_t{1});
    QCOMPARE(desk.document.scene().source->lights.size(), std::size_t{3});
    QCOMPARE(desk.document.scene().source->surface.specularShare, 0.03);
    QCOMPARE(desk.melanin(), 2.0);
    QVERIFY(desk.save(folder / "face.cutis"));
    reopen::Desk again(engine_);
    QVERIFY(again.open(folder / "face.cutis"));
    QVERIFY(again.document.fitChoice() == choice);
    QCOMPARE(again.lightCount(), std::size_t{1});
    QCOMPARE(again.document.scene().source->surface.specularShare, 0.03);
    again.document.fitWith({}, {});
    QVERIFY(again.wait());
    QCOMPARE(again.lightCount(), std::size_t{3});
    QCOMPARE(again.document.scene().source->surface.specularShare, 0.0);
    choice.shading = true;
    again.document.fitWith(choice);
    QVERIFY(again.failed.takeLast()[0].toString().contains("shading"));
  }

  // What is open stays, and nobody is asked how a file of no name is to be read.
  void whatCannotBeReadAgainStaysAsItIs() {
    const ScratchFolder folder;
    writeTexture(folder / "face.png");
    reopen::Desk desk(engine_);
    QVERIFY(desk.open(folder / "face.png"));
    desk.tan();
    QSignalSpy openingFailed(&desk.document, &Document::openingFailed);
    OpenChoice choice = desk.document.openChoice();
    choice.source.mask = folder / "missing_mask.png";
    desk.document.reopen(choice);
    QTRY_COMPARE(desk.failed.count(), 1);
    QCOMPARE(openingFailed.count(), 0);
    QVERIFY(desk.wait());
    QVERIFY(desk.document.openChoice().source.mask.empty());
    QCOMPARE(desk.melanin(), 2.0);
  }

  void aTextureHasNoReflection() {
    const ScratchFolder folder;
    writeTexture(folder / "face.png");
    reopen::Desk desk(engine_);
    QVERIFY(desk.open(folder / "face.png"));
    FitChoice choice = desk.document.fitChoice();
    choice.specular = SpecularPart::included;
    desk.document.fitWith(choice);
    QVERIFY(desk.failed.takeLast()[0].toString().contains("captures"));
    QVERIFY(desk.wait());
  }

 private:
  Engine engine_{std::filesystem::path()};
};

CUTIS_TEST(DocumentReopenTest)

}  // namespace
}  // namespace cutis::test

#include "document_reopen_test.moc"
