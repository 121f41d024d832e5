// Pins as a person sets them: with mouse and keys, in a whole window on the embedded sample.

#include <memory>

#include <QComboBox>
#include <QInputDialog>
#include <QLineEdit>
#include <QSignalSpy>
#include <QtTest>

#include "tests/support/scratch_folder.h"
#include "tests/support/test_registry.h"
#include "tests/ui/ui_test.h"
#include "tests/ui/window_steps.h"
#include "ui/commands/command_registry.h"
#include "ui/dialogs/open_controller.h"
#include "ui/docks/edit_controller.h"
#include "ui/documents/document_page.h"
#include "ui/documents/document_tabs.h"
#include "ui/plot/spectrum_plot.h"
#include "ui/spectrum/pin_controller.h"
#include "ui/view/viewport.h"
#include "ui/window/main_window.h"

namespace cutis {
namespace {

constexpr int kWindowPatienceMs = 120000;

class PinWindowTest : public test::UiTest {
  Q_OBJECT

 private slots:
  void initTestCase() { test::keepSettingsIn(folder_.path()); }

  void aClickPinsAPlace() {
    click(500, 500);
    QCOMPARE(window_->document().pins().pins.size(), std::size_t{1});
    click(400, 600);
    waitUntilIdle();
    const SpectrumFigure& figure = plot().figure();
    QCOMPARE(figure.pins.size(), std::size_t{2});
    QCOMPARE(figure.pins[1].letter, QString("B"));
    QCOMPARE(figure.pins[1].curves.original.size(), 351);
    QVERIFY(figure.pins[0].curves.edited.isEmpty());
    const auto& markers = window_->viewport().markers();
    QCOMPARE(markers.size(), 2);
    QVERIFY(markers[0].color != markers[1].color);
    QVERIFY(markers[1].isSelected && !markers[0].isSelected);
  }

  void panningPinsNothing() {
    Viewport& view = window_->viewport();
    QTest::mousePress(&view, Qt::MiddleButton, {}, at(500, 500));
    QTest::mouseMove(&view, at(520, 500));
    QTest::mouseRelease(&view, Qt::MiddleButton, {}, at(520, 500));
    QTest::mousePress(&view, Qt::LeftButton, {}, at(500, 500));
    QTest::mouseMove(&view, at(600, 500));
    QTest::mouseRelease(&view, Qt::LeftButton, {}, at(600, 500));
    QVERIFY(window_->document().pins().pins.empty());
  }

  void aMarkerIsDragged() {
    click(500, 500);
    Viewport& view = window_->viewport();
    QTest::mousePress(&view, Qt::LeftButton, {}, at(500, 500));
    QTest::mouseMove(&view, at(520, 520));
    QTest::mouseMove(&view, at(560, 540));
    QTest::mouseRelease(&view, Qt::LeftButton, {}, at(560, 540));
    const auto& pins = window_->document().pins().pins;
    QCOMPARE(pins.size(), std::size_t{1});
    QVERIFY2(std::abs(pins[0].x - 560) <= 2 && std::abs(pins[0].y - 540) <= 2,
             qPrintable(QString("%1, %2").arg(pins[0].x).arg(pins[0].y)));
    waitUntilIdle();
    const auto expected = window_->document().spectraAt(pins[0].x, pins[0].y);
    QCOMPARE(plot().figure().pins[0].curves.original[100], expected->original[100]);
  }

  void deleteTakesTheSelectedOneAway() {
    click(500, 500);
    click(400, 600);
    QTest::mouseClick(&window_->viewport(), Qt::LeftButton, {}, at(500, 500));
    QTest::keyClick(window_.get(), Qt::Key_Delete);
    const auto& pins = window_->document().pins().pins;
    QCOMPARE(pins.size(), std::size_t{1});
    QCOMPARE(pins[0].letter, std::string("B"));
    // Nothing is selected any more.
    QTest::keyClick(window_.get(), Qt::Key_Delete);
    QCOMPARE(pins.size(), std::size_t{1});
    window_->commands().run("spectrum.deleteAllPins");
    QVERIFY(pins.empty());
    waitUntilIdle();
    QVERIFY(plot().figure().pins.empty());
  }

  void aPinIsRenamed() {
    click(500, 500);
    window_->commands().run("spectrum.renamePin");
    auto* dialog = window_->findChild<QInputDialog*>();
    QVERIFY(dialog != nullptr && dialog->isVisible());
    dialog->findChild<QLineEdit*>()->setText(" left   cheek ");
    dialog->accept();
    QCOMPARE(window_->document().pins().pins[0].name, std::string("left cheek"));
    QCOMPARE(window_->viewport().markers()[0].name, QString("left cheek"));
    waitUntilIdle();
    QCOMPARE(plot().figure().pins[0].name, QString("left cheek"));
  }

  void pinsFollowTheEditsAndTheSizeOfTheMean() {
    click(500, 500);
    QTest::mouseMove(&window_->viewport(), at(500, 500));
    window_->edits().setFactor(kMelanin, 2.0, false);
    waitUntilIdle();
    QCOMPARE(plot().figure().pins[0].curves.edited.size(), 351);
    const double before = plot().figure().pins[0].curves.original[100];
    window_->tabs().current().pins().setSize(11);
    waitUntilIdle();
    QVERIFY(plot().figure().pins[0].curves.original[100] != before);
    QCOMPARE(window_->tabs().current().pins().readings()[0].place->pixelCount, 121);
    QVERIFY(plot().heading().contains("11 × 11"));
  }

  void anotherQuantityTakesThePlaceOfReflectance() {
    // A mouse that is there already does not move.
    QTest::mouseMove(&window_->viewport(), at(450, 500));
    QTest::mouseMove(&window_->viewport(), at(500, 500));
    waitUntilIdle();
    QComboBox* quantities = nullptr;
    for (QComboBox* box : window_->findChildren<QComboBox*>()) {
      if (box->accessibleName() == "What the plot shows") quantities = box;
    }
    QTest::keyClick(quantities, Qt::Key_Down);
    waitUntilIdle();
    QCOMPARE(plot().figure().parts.size(), std::size_t{2});
    QVERIFY(plot().figure().title.startsWith("Absorption"));
    plot().grab();
    QTest::keyClick(quantities, Qt::Key_Down);
    waitUntilIdle();
    QCOMPARE(plot().figure().parts.size(), std::size_t{4});
    plot().grab();
    QTest::keyClick(quantities, Qt::Key_Home);
    waitUntilIdle();
    QVERIFY(plot().figure().parts.empty());
    QCOMPARE(plot().figure().place.original.size(), 351);
  }

  // Jobs are counted: a hidden dock starts none, neither for pins nor for the mouse.
  void nothingIsComputedForAHiddenDock() {
    DocumentPage& page = window_->tabs().current();
    window_->commands().run("dock.spectrum");
    QTRY_VERIFY(!plot().isVisible());
    waitUntilIdle();
    QSignalSpy jobs(&page.jobs(), &JobRunner::idle);
    click(500, 500);
    click(400, 600);
    QTest::mouseMove(&window_->viewport(), at(450, 550));
    waitUntilIdle();
    QCOMPARE(jobs.count(), 0);
    QVERIFY(page.pins().readings().empty());
    QCOMPARE(window_->viewport().markers().size(), 2);
    window_->commands().run("dock.spectrum");
    QTRY_COMPARE(page.pins().readings().size(), std::size_t{2});
    waitUntilIdle();
    QVERIFY(jobs.count() > 0);
  }

 private:
  void setUp() override {
    window_ = std::make_unique<MainWindow>(std::make_unique<Engine>(folder_ / "cache"));
    window_->resize(1440, 900);
    window_->show();
    QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
    window_->opener().openSample();
    waitUntilIdle();
    QVERIFY(window_->document().isFitted());
  }
  void tearDown() override { window_.reset(); }

  void waitUntilIdle() {
    QTest::qWait(10);
    QTRY_VERIFY_WITH_TIMEOUT(window_->isIdle(), kWindowPatienceMs);
  }
  SpectrumPlot& plot() const { return *window_->findChild<SpectrumPlot*>(); }
  QPoint at(int x, int y) const {
    return window_->viewport().toWidget({x + 0.5, y + 0.5}).toPoint();
  }
  void click(int x, int y) {
    QTest::mouseClick(&window_->viewport(), Qt::LeftButton, {}, at(x, y));
  }

  test::ScratchFolder folder_;
  std::unique_ptr<MainWindow> window_;
};

CUTIS_TEST(PinWindowTest)

}  // namespace
}  // namespace cutis

#include "pin_window_test.moc"
