// Sets of edits from presets, files and the clipboard, on maps without a fit.

#include "ui/edits/preset_controller.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QSignalSpy>
#include <QtTest>

#include "src/app/views/view_server.h"
#include "src/files/edits/edits_file.h"
#include "src/files/io/text_file.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_registry.h"
#include "tests/ui/ui_test.h"
#include "ui/docks/edit_controller.h"
#include "ui/edits/preset_catalogue.h"
#include "ui/view/view_controller.h"
#include "ui/view/viewport.h"
#include "ui/widgets/progress_strip.h"

namespace cutis {
namespace {

constexpr int kPresetPatienceMs = 120000;

class PresetControllerTest : public test::UiTest {
  Q_OBJECT

 private slots:
  void initTestCase() {
    document_.openSample();
    QTRY_VERIFY_WITH_TIMEOUT(document_.isFitted(), kPresetPatienceMs);
  }
  void cleanupTestCase() { jobs_.stopAll(); }

  // They change what they say, in one step, and sliders show them.
  void everyPresetIsOneStep() {
    for (const PresetDescription& preset : presetCatalogue()) {
      const auto before = document_.history().position();
      presets_.useBuiltIn(preset.id);
      QCOMPARE(document_.history().position(), before + 1);
      QVERIFY(document_.history().undoName().contains(preset.title));
      QVERIFY2(!isNeutral(edits()), qPrintable(preset.id));
      QVERIFY2(slidersShow(edits()), qPrintable(preset.id));
      document_.undo();
      QVERIFY(isNeutral(edits()));
    }
    QCOMPARE(static_cast<int>(presetCatalogue().size()), 6);
  }

  void presetsReplaceEachOther() {
    presets_.useBuiltIn("tan");
    presets_.useBuiltIn("flushed");
    QCOMPARE(edits().front().parameters[kMelanin].scale, 1.0);
    QVERIFY(edits().front().parameters[kHaemoglobinDermal].scale > 1.0);
  }

  void editsGoRoundByTheClipboard() {
    factors_.setFactor(kCarotene, 2.25, false);
    presets_.copy();
    QVERIFY(QGuiApplication::clipboard()->text().contains("cutis_edits"));
    factors_.reset();
    presets_.paste();
    QCOMPARE(edits().size(), std::size_t{1});
    QCOMPARE(edits().front().parameters[kCarotene].scale, 2.25);
  }

  void editsGoRoundByAFile() {
    factors_.setFactor(kMelanin, 1.75, false);
    const QString file = QString::fromStdString((folder_ / "my tan.json").string());
    presets_.saveFile(file);
    factors_.reset();
    presets_.useFile(file);
    QCOMPARE(edits().front().parameters[kMelanin].scale, 1.75);
    QVERIFY(document_.history().undoName().contains("my tan"));
    QCOMPARE(edits().front().name, std::string("my tan"));
  }

  // And nothing has changed.
  void whatIsNoPresetIsReported() {
    QSignalSpy failed(&document_, &Document::failed);
    const auto before = document_.history().position();
    presets_.useFile(QString::fromStdString((folder_ / "missing.json").string()));
    presets_.useFile(QString::fromStdString(folder_.write("bad.json", "{\"edits\": 3}").string()));
    for (const char* text : {"", "some words", "{\"cutis_edits\": 99, \"edits\": []}"}) {
      QGuiApplication::clipboard()->setText(text);
      presets_.paste();
    }
    QCOMPARE(failed.count(), 5);
    QVERIFY(failed[1][0].toString().contains("bad.json"));
    QVERIFY(failed[3][0].toString().contains("clipboard"));
    QCOMPARE(document_.history().position(), before);
  }

  // Nor does it act in silence.
  void whatTheSlidersDoNotShowIsSaid() {
    QSignalSpy noticed(&document_, &Document::noticed);
    QSignalSpy further(&factors_, &EditController::furtherEditsChanged);
    QGuiApplication::clipboard()->setText(
        R"({"cutis_edits": 1, "edits": [{"melanin": {"mode": "add", "value": 0.01}}], "regions": []})");
    presets_.paste();
    QCOMPARE(noticed.count(), 1);
    QCOMPARE(further.last()[0].toBool(), true);
    factors_.reset();
    QCOMPARE(further.last()[0].toBool(), false);
  }

  void thereMustBeEditsToKeep() {
    QVERIFY(!presets_.objectionToKeeping().isEmpty());
    factors_.setFactor(kMelanin, 1.5, false);
    QVERIFY(presets_.objectionToKeeping().isEmpty());
  }

 private:
  void setUp() override {
    if (document_.isOpen()) document_.goToStep(0);
  }
  const EditStack& edits() const { return document_.scene().edits; }

  test::ScratchFolder folder_;
  Engine engine_{folder_ / "cache"};
  JobRunner jobs_;
  Document document_{engine_, jobs_};
  ViewServer server_{document_, engine_, jobs_};
  Viewport viewport_;
  ProgressStrip progress_;
  ViewController views_{document_, server_, viewport_};
  EditController factors_{document_, views_};
  QWidget window_;
  PresetController& presets_ = *new PresetController(document_, views_, progress_, &window_);
};

CUTIS_TEST(PresetControllerTest)

}  // namespace
}  // namespace cutis

#include "preset_controller_test.moc"
