// The window as a person uses it: mouse and keys, on the embedded sample.

#include "ui/window/main_window.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QApplication>
#include <QComboBox>
#include <QDropEvent>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QSettings>
#include <QtTest>

#include "tests/support/scratch_folder.h"
#include "tests/support/test_registry.h"
#include "tests/ui/ui_test.h"
#include "tests/ui/window_steps.h"
#include "ui/commands/command_registry.h"
#include "ui/dialogs/export_controller.h"
#include "ui/dialogs/open_controller.h"
#include "ui/docks/edit_controller.h"
#include "ui/documents/document_page.h"
#include "ui/documents/document_tabs.h"
#include "ui/plot/spectrum_plot.h"
#include "ui/view/view_controller.h"
#include "ui/view/view_strip.h"
#include "ui/view/viewport.h"
#include "ui/widgets/neutral_slider.h"
#include "ui/widgets/progress_strip.h"

namespace cutis {
namespace {

constexpr int kPatienceMs = 120000;

class MainWindowTest : public test::UiTest {
  Q_OBJECT

 private slots:
  void initTestCase() { test::keepSettingsIn(folder_.path()); }

  void theSampleOpensAndIsFitted() {
    openSample();
    const FitStatistics& statistics = window_->document().statistics();
    QCOMPARE(statistics.pixels.total, 1024u * 1024u);
    QVERIFY(statistics.pixels.solved > statistics.pixels.total / 2);
    QVERIFY(statistics.pixels.noConvergence < statistics.pixels.total / 1000);
    QVERIFY(window_->windowTitle().contains("Sample"));
    // Twenty views in five groups.
    auto* strip = window_->findChild<ViewStrip*>();
    QCOMPARE(strip->count(), 25);
  }

  // The read-out and the spectrum follow the cursor.
  void theCursorShowsTheSpectrum() {
    openSample();
    Viewport& viewport = window_->viewport();
    QTest::mouseMove(&viewport, viewport.toWidget({500.5, 500.5}).toPoint());
    auto* plot = window_->findChild<SpectrumPlot*>();
    QTRY_VERIFY(plot->maximum() < 1.0);
    const auto spectra = window_->document().spectraAt(500, 500);
    QVERIFY(spectra.has_value());
    QVERIFY(plot->maximum() >= spectra->original.maxCoeff());
    // The background is no skin.
    QVERIFY(!window_->document().spectraAt(2, 2).has_value());
    QVERIFY(!window_->document().spectraAt(-1, 5000).has_value());
  }

  // The read-out goes on; the spectrum comes when the plot is seen again.
  void aHiddenSpectrumIsNotComputed() {
    openSample();
    auto* plot = window_->findChild<SpectrumPlot*>();
    Viewport& viewport = window_->viewport();
    Q_EMIT viewport.cursorMoved(500, 501);
    QTRY_VERIFY(plot->heading().contains("501"));
    window_->commands().run("dock.spectrum");
    QTRY_VERIFY(!plot->isVisible());
    QTest::qWait(50);
    Q_EMIT viewport.cursorMoved(400, 420);
    QVERIFY(!plot->heading().contains("420"));
    window_->commands().run("dock.spectrum");
    QTRY_VERIFY(plot->heading().contains("420"));
  }

  // The skin changes colour; its thumbnail follows when it is seen again.
  void hiddenThumbnailsAreNotComputed() {
    openSample();
    auto* strip = window_->findChild<ViewStrip*>();
    const auto thumbnails = [&] {
      std::vector<QImage> images;
      for (int row = 0; row < strip->count(); ++row)
        images.push_back(strip->item(row)->data(Qt::UserRole + 1).value<QImage>());
      return images;
    };
    const auto before = thumbnails();
    window_->commands().run("dock.views");
    QTRY_VERIFY(!strip->isVisible());
    QTest::qWait(50);
    window_->edits().setFactor(kMelanin, 2.5, false);
    waitUntilIdle();
    QVERIFY(thumbnails() == before);
    window_->commands().run("dock.views");
    QTRY_VERIFY(strip->isVisible());
    QTest::qWait(50);
    waitUntilIdle();
    QVERIFY(thumbnails() != before);
  }

  void aDraggedSliderChangesThePictureInOneStep() {
    openSample();
    const QImage before = window_->viewport().grab().toImage();
    NeutralSlider* slider = sliderNamed("Melanin");
    const QPoint middle = slider->rect().center();
    QTest::mousePress(slider, Qt::LeftButton, {}, middle);
    for (int x = 1; x <= 5; ++x) {
      QTest::mouseMove(slider, middle + QPoint(8 * x, 0));
      QTest::qWait(20);
    }
    QTest::mouseRelease(slider, Qt::LeftButton, {}, middle + QPoint(40, 0));
    waitUntilIdle();
    QCOMPARE(window_->views().current(), ViewKind::editedAlbedo);
    const double factor = slider->number();
    QVERIFY(factor > 1.1);
    QVERIFY(window_->viewport().grab().toImage() != before);
    const auto spectra = window_->document().spectraAt(500, 500);
    QVERIFY(std::abs(spectra->editedParameters[kMelanin] -
                     factor * spectra->originalParameters[kMelanin]) < 1e-6);

    QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier);
    waitUntilIdle();
    QCOMPARE(slider->number(), 1.0);
    QVERIFY(!window_->document().history().canUndo());
    QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(slider->number(), factor);
  }

  void ultravioletIsAClickAway() {
    openSample();
    QAbstractButton* button = nullptr;
    for (QAbstractButton* candidate : window_->findChildren<QAbstractButton*>()) {
      if (candidate->text() == "UV") button = candidate;
    }
    QVERIFY(button != nullptr);
    QTest::mouseClick(button, Qt::LeftButton);
    waitUntilIdle();
    QCOMPARE(window_->views().current(), ViewKind::ultraviolet);
    // Shown in grey.
    const QImage picture = window_->viewport().grab().toImage();
    const QPoint cheek = window_->viewport().toWidget({400, 400}).toPoint();
    const QColor color = picture.pixelColor(cheek);
    QCOMPARE(color.red(), color.green());
    QCOMPARE(color.green(), color.blue());
    QVERIFY(color.red() > 10);
  }

  void anotherLightColoursTheSkin() {
    openSample();
    QComboBox* lights = nullptr;
    for (QComboBox* candidate : window_->findChildren<QComboBox*>()) {
      if (candidate->accessibleName() == "Light source") lights = candidate;
    }
    QVERIFY(lights != nullptr);
    lights->setFocus();
    // Open it is searched by typing; closed, letters are commands of the picture.
    lights->showPopup();
    QTest::keyClicks(lights->view(), "Tungsten");
    QTest::keyClick(lights->view(), Qt::Key_Return);
    waitUntilIdle();
    QCOMPARE(lights->currentData().toString(), "A");
    QCOMPARE(window_->views().current(), ViewKind::skin);
  }

  void theEditedAlbedoIsExported() {
    openSample();
    const QString plain = file("plain.png"), edited = file("edited.png");
    window_->exports().exportAlbedo(plain);
    waitUntilIdle();
    QTest::keyClick(sliderNamed("Melanin"), Qt::Key_PageUp);
    waitUntilIdle();
    window_->exports().exportAlbedo(edited);
    waitUntilIdle();
    const QImage a(plain), b(edited);
    QCOMPARE(a.size(), QSize(1024, 1024));
    QCOMPARE(b.size(), QSize(1024, 1024));
    QCOMPARE(a.pixel(1, 1), b.pixel(1, 1));  // background
    QVERIFY(qGreen(b.pixel(500, 500)) < qGreen(a.pixel(500, 500)));
    QVERIFY(window_->progress().message().contains("edited.png"));
  }

  void whatCannotBeOpenedIsToldAndChangesNothing() {
    openSample();
    window_->opener().open(file("missing.exr"));
    waitUntilIdle();
    QVERIFY(window_->progress().message().contains("missing.exr"));
    QVERIFY(window_->document().isFitted());
    folder_.write("noise.png", "this is no picture");
    window_->opener().open(file("noise.png"));
    waitUntilIdle();
    QVERIFY(window_->progress().message().contains("noise.png"));
  }

  void oneThingDroppedIsOpened() {
    folder_.write("noise.png", "this is no picture");
    QVERIFY(drop({QUrl::fromLocalFile(file("noise.png"))}));
    waitUntilIdle();
    QVERIFY(window_->progress().message().contains("noise.png"));
  }

  // What cannot be opened is reported and gets no tab; the rest is opened.
  void eachOfSeveralDroppedGetsATab() {
    openSample();
    writePicture("a.png", QColor(200, 150, 130));
    writePicture("b.png", QColor(120, 80, 60));
    QVERIFY(drop({QUrl::fromLocalFile(file("a.png")), QUrl::fromLocalFile(file("missing.png")),
                  QUrl::fromLocalFile(file("b.png"))}));
    waitUntilIdle();
    QCOMPARE(window_->tabs().count(), 3);
    QCOMPARE(window_->tabs().pages().size(), 3u);
    QVERIFY2(window_->progress().message().contains("missing.png"),
             qPrintable(window_->progress().message()));
  }

  void nothingIsFetchedFromTheNetwork() {
    QVERIFY(drop({QUrl("https://example.org/face.exr")}));
    QTRY_VERIFY(window_->progress().message().contains("save it here first"));
    QTRY_VERIFY(window_->isIdle());
    QVERIFY(!window_->document().isOpen());
  }

  void anExportThatCannotBeWrittenIsTold() {
    openSample();
    window_->exports().exportAlbedo(file("no/such/folder/a.png"));
    waitUntilIdle();
    QVERIFY(window_->progress().message().contains("a.png"));
    window_->exports().exportAlbedo(file("a.gif"));
    waitUntilIdle();
    QVERIFY(window_->progress().message().contains("a.gif"));
  }

  void whatIsUnderWayIsNotOpenedAgain() {
    window_->opener().openSample();
    QTest::qWait(30);
    window_->opener().openSample();
    waitUntilIdle();
    QVERIFY(window_->document().isFitted());
    QCOMPARE(window_->tabs().count(), 1);
  }

  void cancellingStopsSoon() {
    window_->opener().openSample();
    QTest::qWait(50);
    Q_EMIT window_->progress().cancelWanted();
    QTRY_VERIFY_WITH_TIMEOUT(window_->isIdle(), kPatienceMs);
    QVERIFY(!window_->document().isFitted());
  }

  // What was to be waited for has not come; the window stays, with what it says of it.
  void quittingStaysWhereAFileIsNotWritten() {
    openSample();
    window_->exports().exportAlbedo(file("no_such_folder/never.png"));
    window_->close();
    if (QMessageBox* asked = question()) {
      QTest::mouseClick(asked->defaultButton(), Qt::LeftButton);
      QTest::qWait(500);
    }
    waitUntilIdle();
    QVERIFY(window_->isVisible());
    QVERIFY2(window_->progress().messageIsError(), qPrintable(window_->progress().message()));
    window_->close();
    QTRY_VERIFY(!window_->isVisible());
  }

  void clearingPrivateDataIsNotTheUsualAnswer() {
    window_->commands().run("file.clearPrivateData");
    QVERIFY(question() != nullptr);
    QCOMPARE(question()->defaultButton()->text(), QString("Cancel"));
    QVERIFY(question()->informativeText().contains("nsaved edits"));
    QTest::keyClick(question(), Qt::Key_Return);
    QTRY_VERIFY(question() == nullptr);
  }

  void closingWhileWorkingIsSafe() {
    window_->opener().openSample();
    QTest::qWait(100);
    window_->close();
    window_.reset();
  }

 private:
  void tearDown() override { window_.reset(); }

  void setUp() override {
    window_ = std::make_unique<MainWindow>(std::make_unique<Engine>(folder_ / "cache"));
    window_->resize(1280, 800);
    window_->show();
  }

  QMessageBox* question() const { return test::questionBefore(*window_); }
  QString file(const std::string& name) const {
    return QString::fromStdString((folder_ / name).string());
  }
  bool drop(const QList<QUrl>& urls) {
    QMimeData data;
    data.setUrls(urls);
    QDragEnterEvent enter({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(window_.get(), &enter);
    if (!enter.isAccepted()) return false;
    QDropEvent event({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(window_.get(), &event);
    return event.isAccepted();
  }
  void writePicture(const std::string& name, QColor color) const {
    QImage image(32, 24, QImage::Format_RGB32);
    image.fill(color);
    QVERIFY(image.save(file(name)));
  }
  void waitUntilIdle() {
    QTest::qWait(10);
    QTRY_VERIFY_WITH_TIMEOUT(window_->isIdle(), kPatienceMs);
  }
  void openSample() {
    window_->opener().openSample();
    waitUntilIdle();
    QVERIFY(window_->document().isFitted());
  }
  NeutralSlider* sliderNamed(const QString& name) const {
    for (NeutralSlider* slider : window_->findChildren<NeutralSlider*>()) {
      if (slider->accessibleName() == name) return slider;
    }
    return nullptr;
  }

  test::ScratchFolder folder_;
  std::unique_ptr<MainWindow> window_;
};

CUTIS_TEST(MainWindowTest)

}  // namespace
}  // namespace cutis

#include "main_window_test.moc"
