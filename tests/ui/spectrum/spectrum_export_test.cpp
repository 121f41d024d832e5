// What is taken out of the spectrum dock: files, clipboard, words; and the table beside the plot.

#include "ui/spectrum/spectrum_export.h"

#include <cmath>
#include <memory>

#include <QClipboard>
#include <QGuiApplication>
#include <QTableWidget>
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
#include "ui/plot/drawing_pages.h"
#include "ui/plot/spectrum_plot.h"
#include "ui/spectrum/pin_controller.h"
#include "ui/spectrum/reference_curves.h"
#include "ui/view/viewport.h"
#include "ui/widgets/progress_strip.h"
#include "ui/window/main_window.h"

namespace cutis {
namespace {

constexpr int kExportPatienceMs = 120000;

class SpectrumExportTest : public test::UiTest {
  Q_OBJECT

 private slots:
  void initTestCase() { test::keepSettingsIn(folder_.path()); }

  void figuresAreWrittenInEveryFormat() {
    pinTwo();
    for (const auto& [name, beginning] :
         {std::pair("f.pdf", "%PDF-"), std::pair("f.svg", "<svg"), std::pair("f.png", "\x89PNG"),
          std::pair("f.csv", "wavelength_nm,")}) {
      exporter().writeFigure(file(name));
      waitUntilIdle();
      const std::string bytes = folder_.read(name);
      QVERIFY2(bytes.find(beginning) < 200, name);
    }
    const QStringList rows = QString::fromStdString(folder_.read("f.csv")).split('\n');
    QCOMPARE(rows.size(), 353);
    QVERIFY(rows[0].contains("A original") && rows[0].contains("B left cheek original"));
    QVERIFY(rows[1].startsWith("300,"));
    const std::string svg = folder_.read("f.svg");
    for (const char* words : {"Wavelength, nm", "Profile skin2026", "rig monitor", "Extrapolated"})
      QVERIFY2(svg.find(words) != std::string::npos, words);
  }

  void theClipboardTakesThem() {
    pinTwo();
    window_->commands().run("spectrum.copyFigure");
    QVERIFY(QGuiApplication::clipboard()->image().width() >= 1300);
    window_->commands().run("spectrum.copyCurves");
    QVERIFY(QGuiApplication::clipboard()->text().startsWith("wavelength_nm\t"));
    window_->commands().run("spectrum.copyMethods");
    const QString methods = QGuiApplication::clipboard()->text();
    for (const char* words : {"Li, G. C. Guarnera", "skin2026", "white+blue", "Canon", "prior",
                              "300 to 1000 nm", "maximum a posteriori"})
      QVERIFY2(methods.contains(words), qPrintable(methods));
  }

  void theTableSaysWhatIsKnownOfPins() {
    pinTwo();
    pins().select("A");
    window_->commands().run("spectrum.referencePin");
    window_->edits().setFactor(kMelanin, 2.0, false);
    waitUntilIdle();
    auto* table = window_->findChild<QTableWidget*>();
    QCOMPARE(table->rowCount(), 2);
    QCOMPARE(table->item(1, 1)->text(), QString("left cheek"));
    QVERIFY(table->item(0, 3)->text().contains("±"));
    QVERIFY(table->item(0, 3)->text().contains("→"));
    QVERIFY(!table->item(0, 5)->text().contains("→"));
    QCOMPARE(table->item(0, table->columnCount() - 1)->text(), QString("reference"));
    QVERIFY(table->item(1, table->columnCount() - 1)->text().size() >= 4);
    table->item(0, 1)->setText("nose");
    QCOMPARE(window_->document().pins().pins[0].name, std::string("nose"));
    waitUntilIdle();
    window_->commands().run("spectrum.copyPins");
    const QStringList rows = QGuiApplication::clipboard()->text().split('\n');
    QCOMPARE(rows.size(), 4);
    QCOMPARE(rows[0].split('\t').size(), 29);
    QCOMPARE(rows[1].split('\t').size(), rows[0].split('\t').size());
    QVERIFY(rows[0].endsWith("delta_e2000_to_A"));
    QVERIFY(rows[1].startsWith("A\tnose\t"));
    QCOMPARE(rows[1].split('\t').last(), QString("0"));
    exporter().writePins(file("pins.csv"));
    waitUntilIdle();
    QVERIFY(folder_.read("pins.csv").starts_with("pin,name,x,y,pixels,melanin,melanin_sd,"));
  }

  // Between its first and last wavelength, under the name of its file.
  void referencesAreDrawnFromFiles() {
    folder_.write("forearm.csv", "wavelength,reflectance\n400,0.2\n500,0.3\n600,0.5\n");
    ReferenceCurves& references = window_->tabs().current().references();
    references.add(file("forearm.csv"));
    waitUntilIdle();
    const auto& drawn = window_->findChild<SpectrumPlot*>()->figure().references;
    QCOMPARE(drawn.size(), std::size_t{1});
    QCOMPARE(drawn[0].name, QString("forearm"));
    QVERIFY(std::abs(drawn[0].values[75] - 0.25) < 1e-9);  // 450 nm
    QVERIFY(std::isnan(drawn[0].values[40]) && std::isnan(drawn[0].values[160]));
    references.add(file("nowhere.csv"));
    waitUntilIdle();
    QVERIFY(window_->progress().messageIsError());
    QCOMPARE(drawn.size(), std::size_t{1});
    window_->commands().run("spectrum.removeReferences");
    QVERIFY(drawn.empty());
  }

  void whatCannotBeWrittenIsSaid() {
    pinTwo();
    exporter().writePins(file("nowhere/pins.csv"));
    waitUntilIdle();
    QVERIFY(window_->progress().messageIsError());
  }

  void aPageOfPdfIsAsLargeAsTheDrawing() {
    Drawing drawing;
    drawing.width = 192;
    drawing.height = 96;
    drawing.add(Disc{{96, 48}, 20, Color::rgb(0xff0000), kNoStroke});
    QVERIFY(pdfOf(drawing).contains("/MediaBox [0 0 144.000000 72.000000]"));
    const QImage image = imageOf(drawing, 2);
    QCOMPARE(image.size(), QSize(384, 192));
    QCOMPARE(image.pixelColor(192, 96), QColor(255, 0, 0));
    QCOMPARE(image.pixelColor(5, 5), QColor(Qt::white));
  }

 private:
  void setUp() override {
    window_ = std::make_unique<MainWindow>(std::make_unique<Engine>(folder_ / "cache"));
    window_->resize(1440, 900);
    window_->show();
    window_->opener().openSample();
    waitUntilIdle();
    QVERIFY(window_->document().isFitted());
  }
  void tearDown() override { window_.reset(); }

  PinController& pins() { return window_->tabs().current().pins(); }
  SpectrumExport& exporter() { return window_->tabs().current().spectrumExport(); }
  QString file(const std::string& name) const {
    return QString::fromStdString((folder_ / name).string());
  }
  void pinTwo() {
    pins().add(500, 500);
    pins().add(400, 600);
    pins().setName("B", "left cheek");
    waitUntilIdle();
    QCOMPARE(pins().readings().size(), std::size_t{2});
  }
  void waitUntilIdle() {
    QTest::qWait(10);
    QTRY_VERIFY_WITH_TIMEOUT(window_->isIdle(), kExportPatienceMs);
  }

  test::ScratchFolder folder_;
  std::unique_ptr<MainWindow> window_;
};

CUTIS_TEST(SpectrumExportTest)

}  // namespace
}  // namespace cutis

#include "spectrum_export_test.moc"
