// Profile, method and training in the window, by mouse and keys, on the embedded sample.

#include <utility>

#include <QApplication>
#include <QComboBox>
#include <QProgressBar>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QtTest>

#include "src/app/training/network_training.h"
#include "src/files/networks/network_file.h"
#include "src/files/resources.h"
#include "tests/support/expect.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_registry.h"
#include "tests/ui/ui_test.h"
#include "tests/ui/window_steps.h"
#include "ui/color/color_bar_control.h"
#include "ui/commands/command_registry.h"
#include "ui/dialogs/open_controller.h"
#include "ui/dialogs/training_controller.h"
#include "ui/dialogs/training_dialog.h"
#include "ui/docks/edit_controller.h"
#include "ui/docks/fit_controller.h"
#include "ui/view/view_controller.h"
#include "ui/view/view_strip.h"
#include "ui/view/viewport.h"
#include "ui/widgets/neutral_slider.h"
#include "ui/widgets/progress_strip.h"
#include "ui/window/main_window.h"

namespace cutis {
namespace {

constexpr int kFitPatienceMs = 120000;

NetworkTraining quickTraining(const Rig& rig, const std::string& profile) {
  NetworkTraining training = usualTraining(rig, profile);
  training.spectra.hidden = training.chromophores.hidden = {8, 8};
  training.spectra.people.count = training.chromophores.people.count = 2000;
  training.spectra.trainer.epochs = training.chromophores.trainer.epochs = 3;
  training.tableStep = 997;
  return training;
}

class FitWindowTest : public test::UiTest {
  Q_OBJECT

 private slots:
  void initTestCase() {
    test::keepSettingsIn(folder_.path());
    std::string text(*resource("profiles/li2024.json"));
    const std::string thickness = "\"thickness_mm\": 0.32";
    text.replace(text.find(thickness), thickness.size(), "\"thickness_mm\": 0.31");
    foreign_ = QString::fromStdString(folder_.write("foreign.json", text).string());
  }

  void theProfileChangesThePictureAndTheWayBackIsTheSame() {
    QTest::keyClick(sliderNamed("Melanin"), Qt::Key_PageUp);
    waitUntilIdle();
    const double factor = sliderNamed("Melanin")->number();
    const QRect view = viewOf();
    const QImage before = pictureOf();
    QTest::keyClick(boxNamed("Profile"), Qt::Key_Home);
    QCOMPARE(boxNamed("Profile")->currentText(), QString("li2024"));
    waitUntilIdle();
    QVERIFY(pictureOf() != before);
    QCOMPARE(sliderNamed("Melanin")->number(), factor);
    QCOMPARE(viewOf(), view);
    QTest::keyClick(boxNamed("Profile"), Qt::Key_End);
    waitUntilIdle();
    QVERIFY(pictureOf() == before);
    QCOMPARE(sliderNamed("Melanin")->number(), factor);
  }

  void changesDuringAFitEndWithTheLast() {
    for (const int key : {Qt::Key_Down, Qt::Key_Down, Qt::Key_Up}) {
      QTest::keyClick(boxNamed("Method"), static_cast<Qt::Key>(key));
      QTest::qWait(10);
    }
    waitUntilIdle();
    QCOMPARE(boxNamed("Method")->currentText(), QString("Network"));
    QCOMPARE(window_->document().fitChoice().method, FitMethod::network);
    QVERIFY(window_->document().isFitted());
  }

  void aFitThatIsCancelledLeavesThePictureAndThePanel() {
    const QImage before = pictureOf();
    QTest::keyClick(boxNamed("Profile"), Qt::Key_Home);
    QTRY_VERIFY(window_->progress().jobRuns());
    QTest::keyClick(window_.get(), Qt::Key_Period, Qt::ControlModifier);
    QCOMPARE(boxNamed("Profile")->currentText(), QString(kDefaultProfile));
    waitUntilIdle();
    QVERIFY(pictureOf() == before);
    QVERIFY(window_->document().isFitted());
  }

  // Nothing is shown as if it were an estimate, and the fit can be had again.
  void aFirstFitThatIsCancelledIsOfferedAgain() {
    window_->commands().run("file.close");
    QPushButton* fit = buttonNamed(*window_, "Fit");
    QVERIFY(!fit->isVisible());
    QSignalSpy opened(&window_->document(), &Document::opened);
    window_->opener().openSample();
    QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, kFitPatienceMs);
    QVERIFY(!window_->document().hasEstimate());
    window_->views().show(ViewKind::melanin);
    QCOMPARE(window_->viewport().notice(), QString("Not fitted yet"));
    QTest::keyClick(window_.get(), Qt::Key_Period, Qt::ControlModifier);
    waitUntilIdle();
    QVERIFY(!window_->document().isFitted());
    QVERIFY(fit->isVisible());
    if (!window_->document().hasEstimate()) {
      QCOMPARE(window_->viewport().notice(), QString("Not fitted yet"));
    } else {
      const ColorBarSpec bar = *window_->viewport().colorBar();
      QCOMPARE(bar.state, bar.isKnown ? QString("Incomplete") : QString("Not fitted yet"));
    }
    QTest::mouseClick(fit, Qt::LeftButton);
    QVERIFY(!fit->isVisible());
    QCOMPARE(window_->commands().run("fit.again"), QString("The fit is under way"));
    waitUntilIdle();
    QVERIFY(window_->document().isFitted());
    QVERIFY(window_->viewport().notice().isEmpty());
    QVERIFY(window_->viewport().colorBar()->isKnown);
    QCOMPARE(window_->viewport().colorBar()->state, QString());
    window_->edits().setFactor(kMelanin, 1.5, false);
    QCOMPARE(window_->viewport().colorBar()->state, QString("Edited"));
    window_->views().show(ViewKind::carotene);
    waitUntilIdle();
    QCOMPARE(window_->viewport().colorBar()->state, QString());
    window_->document().undo();
    window_->views().show(ViewKind::photograph);
    waitUntilIdle();
  }

  void aMapHasARangeThatCanBeDrawn() {
    window_->opener().openSample();
    waitUntilIdle();
    window_->views().show(ViewKind::melanin);
    waitUntilIdle();
    const ColorBarSpec usual = *window_->viewport().colorBar();
    QVERIFY(usual.axis.has_value() && usual.range.minimum > 0.0);
    auto* bar = window_->findChild<ColorBarControl*>();
    const QPoint handle = bar->handleAt(true).toPoint();
    QTest::mousePress(bar, Qt::LeftButton, {}, handle);
    QTest::mouseMove(bar, handle - QPoint(30, 0));
    QTest::mouseRelease(bar, Qt::LeftButton, {}, handle - QPoint(30, 0));
    QVERIFY(window_->viewport().colorBar()->range.maximum < usual.range.maximum);
    QVERIFY(!window_->commands().action("view.automaticRange")->isChecked());
    QTest::mouseDClick(bar, Qt::LeftButton, {}, handle);
    QVERIFY(window_->viewport().colorBar()->range == usual.range);
    QVERIFY(window_->commands().action("view.automaticRange")->isChecked());

    // What is in view and its thumbnail follow.
    const auto seen = [&] {
      auto* strip = window_->findChild<ViewStrip*>();
      return std::pair(window_->viewport().grab().toImage(), strip->grab().toImage());
    };
    const auto linear = seen();
    QTest::keyClick(&window_->viewport(), Qt::Key_L, Qt::ControlModifier);
    QCOMPARE(window_->viewport().colorBar()->state, QString("Logarithmic"));
    const auto logarithmic = seen();
    QVERIFY(logarithmic.first != linear.first && logarithmic.second != linear.second);
    QTest::keyClick(&window_->viewport(), Qt::Key_L, Qt::ControlModifier);
    QVERIFY(seen() == linear);
    window_->views().show(ViewKind::photograph);
    waitUntilIdle();
  }

  void aFileThatIsNoProfileIsTold() {
    const QString broken = QString::fromStdString(folder_.write("broken.json", "{").string());
    window_->fit().fitWithProfile(broken);
    waitUntilIdle();
    QVERIFY(window_->progress().message().contains("broken.json"));
    QCOMPARE(boxNamed("Profile")->currentText(), QString(kDefaultProfile));
    QCOMPARE(boxNamed("Profile")->findData(broken), -1);
  }

  void aNetworkIsTrainedAndUsed() {
    window_->fit().fitWithProfile(foreign_);
    waitUntilIdle();
    QPushButton* train = buttonNamed(*window_, "Train one (about 15 s)");
    QVERIFY(!train->isVisible());
    QTest::keyClick(boxNamed("Method"), Qt::Key_Down);
    waitUntilIdle();
    QVERIFY(train->isVisible());
    QCOMPARE(boxNamed("Method")->currentText(), QString("Refined"));
    const QImage before = pictureOf();

    QTest::mouseClick(train, Qt::LeftButton);
    TrainingDialog& dialog = window_->training().dialog();
    QVERIFY(dialog.isVisible() && dialog.isTraining() && !dialog.isModal());
    QVERIFY(!buttonNamed(dialog, "Use it")->isVisible());
    // Whatever is looked at meanwhile: the network is of the profile it was trained for.
    window_->fit().fitWithProfile(kDefaultProfile);
    waitUntilIdle();
    QVERIFY(!dialog.isTraining() && window_->training().isTrained());
    QTest::mouseClick(buttonNamed(dialog, "Use it"), Qt::LeftButton);
    QVERIFY(!dialog.isVisible());
    waitUntilIdle();
    QCOMPARE(boxNamed("Method")->currentText(), QString("Network"));
    QVERIFY(!train->isVisible());
    QVERIFY(pictureOf() == before);  // the photograph
    QVERIFY(window_->document().fitChoice().profile == foreign_.toStdString());
  }

  void weightsAreSavedAsTheCommandLineReadsThem() {
    window_->training().train();
    waitUntilIdle();
    const QString path = file("weights.json");
    window_->training().save(path);
    waitUntilIdle();
    const auto read = readNetworks(path.toStdString());
    EXPECT_OK(read);
    QCOMPARE(read.value().rig, std::string("monitor"));
    QCOMPARE(read.value().profile, std::string(kDefaultProfile));
    QVERIFY(read.value().command.find("--lights white,white+blue,white+green") !=
            std::string::npos);
    window_->training().save(file("no/such/folder/weights.json"));
    waitUntilIdle();
    QVERIFY(window_->training().dialog().isVisible());
  }

  void trainingIsCancelledAtOnce_data() {
    QTest::addColumn<QString>("how");
    for (const char* how : {"button", "escape", "close", "strip"}) {
      QTest::newRow(how) << how;
    }
  }
  void trainingIsCancelledAtOnce() {
    QFETCH(QString, how);
    window_->training().setPlan(usualTraining);
    QTest::keyClick(window_.get(), Qt::Key_T, Qt::ControlModifier | Qt::ShiftModifier);
    TrainingDialog& dialog = window_->training().dialog();
    QVERIFY(dialog.isVisible());
    QTRY_VERIFY(dialog.findChild<QProgressBar*>()->value() > 0);
    QElapsedTimer timer;
    timer.start();
    if (how == "button") {
      QTest::mouseClick(buttonNamed(dialog, "Cancel"), Qt::LeftButton);
    } else if (how == "escape") {
      QTest::keyClick(&dialog, Qt::Key_Escape);
    } else if (how == "close") {
      dialog.close();
    } else {
      Q_EMIT window_->progress().cancelWanted();
    }
    QVERIFY(!dialog.isVisible() && !dialog.isTraining());
    QVERIFY(!window_->training().isTrained());
    waitUntilIdle();
    QVERIFY(window_->document().isFitted());
  }

  void trainingEndsWithItsDocument() {
    window_->training().setPlan(usualTraining);
    window_->training().train();
    window_->commands().run("file.close");
    waitUntilIdle();
    QVERIFY(!window_->document().isOpen());
    QVERIFY(!window_->progress().jobRuns());
  }

  // A fit beside it is shown while it runs, and the training again after it.
  void theStripShowsTheNewestJob() {
    window_->training().setPlan(usualTraining);
    window_->training().train();
    QVERIFY(window_->progress().jobRuns());
    QSignalSpy fitted(&window_->document(), &Document::fitted);
    window_->fit().fitWithProfile("li2024");
    QTRY_COMPARE_WITH_TIMEOUT(fitted.count(), 1, kFitPatienceMs);
    QTest::qWait(50);
    QVERIFY(window_->progress().jobRuns());
    QVERIFY(window_->training().dialog().isTraining());
    Q_EMIT window_->progress().cancelWanted();
    QVERIFY(!window_->training().dialog().isVisible());
    QVERIFY(!window_->progress().jobRuns());
  }

  void closingDuringTrainingIsSafe() {
    window_->training().setPlan(usualTraining);
    window_->training().train();
    QTest::qWait(200);
    window_->close();
    QVERIFY(!window_->training().dialog().isVisible());
    window_.reset();
  }

  void everyControlHasAName() {
    for (const QWidget* owner : {static_cast<QWidget*>(window_.get()),
                                 static_cast<QWidget*>(&window_->training().dialog())}) {
      for (const QComboBox* box : owner->findChildren<QComboBox*>()) {
        QVERIFY(!box->accessibleName().isEmpty());
      }
      for (const QAbstractButton* button : owner->findChildren<QAbstractButton*>()) {
        // Qt's own inside of scroll areas, menus and fields are not ours to name.
        if (button->objectName().startsWith("qt_") || button->inherits("QLineEditIconButton")) {
          continue;
        }
        // A bar has its buttons' names when it has something to say.
        if (button->parentWidget()->isHidden()) continue;
        QVERIFY2(!button->text().isEmpty() || !button->accessibleName().isEmpty(),
                 button->metaObject()->className());
      }
    }
  }

 private:
  void tearDown() override { window_.reset(); }

  void setUp() override {
    window_ = std::make_unique<MainWindow>(std::make_unique<Engine>(folder_ / "cache"));
    window_->training().setPlan(quickTraining);
    window_->resize(1280, 800);
    window_->show();
    window_->opener().openSample();
    waitUntilIdle();
  }

  QString file(const std::string& name) const {
    return QString::fromStdString((folder_ / name).string());
  }
  void waitUntilIdle() {
    QTest::qWait(10);
    QTRY_VERIFY_WITH_TIMEOUT(window_->isIdle(), kFitPatienceMs);
  }
  QImage pictureOf() const { return window_->viewport().grab().toImage(); }
  QRect viewOf() const {
    const Rect rect = window_->viewport().visibleRect();
    return {rect.x0, rect.y0, rect.width(), rect.height()};
  }
  QComboBox* boxNamed(const QString& name) const {
    for (QComboBox* box : window_->findChildren<QComboBox*>()) {
      if (box->accessibleName() == name) return box;
    }
    return nullptr;
  }
  QPushButton* buttonNamed(const QWidget& owner, const QString& text) const {
    for (QPushButton* button : owner.findChildren<QPushButton*>()) {
      if (button->text() == text) return button;
    }
    return nullptr;
  }
  NeutralSlider* sliderNamed(const QString& name) const {
    for (NeutralSlider* slider : window_->findChildren<NeutralSlider*>()) {
      if (slider->accessibleName() == name) return slider;
    }
    return nullptr;
  }

  test::ScratchFolder folder_;
  QString foreign_;
  std::unique_ptr<MainWindow> window_;
};

CUTIS_TEST(FitWindowTest)

}  // namespace
}  // namespace cutis

#include "fit_window_test.moc"
