#include "src/files/spectra/spectral_csv.h"

#include <QtTest>

#include "tests/support/expect.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

class SpectralCsvTest : public QObject {
  Q_OBJECT

 private slots:
  void readsATable() {
    const auto table = parseSpectralCsv(
        "\xEF\xBB\xBF# camera\r\nwavelength_nm,R,\"G\",B\r\n400,1,2,3\r\n# middle\r\n\r\n"
        "410.5,4,5,-6e-1\r\n",
        "camera.csv");
    EXPECT_OK(table);
    QVERIFY((table.value().names == std::vector<std::string>{"R", "G", "B"}));
    QVERIFY((table.value().wavelengthsNm == std::vector<double>{400, 410.5}));
    QVERIFY((table.value().columns[2] == std::vector<double>{3, -0.6}));
    QCOMPARE(table.value().place, std::string("camera.csv"));
    const Spectrum green = table.value().onGrid(1);
    EXPECT_NEAR(green[50], 2.0, 0.0);
    EXPECT_NEAR(green[51], 2.0 + 3.0 * 2.0 / 10.5, 1e-12);
    EXPECT_NEAR(green[56], 0.0, 0.0);  // 412 nm
  }

  void readsWhatElseThereIs_data() {
    QTest::addColumn<QString>("text");
    const auto row = [](const char* name, const char* text) { QTest::newRow(name) << text; };
    row("no header", "400,1000\n410,2000\n");
    row("semicolons", "nm;p\n400;1000\n410;2000\n");
    row("decimal commas", "nm;p\n400,0;1000,0\n410,0;2,0e3\n");
    row("tabs and nothing above", "400\t1000\n410\t2000\n");
    row("blanks", "  400   1000\n  410   2000\n");
    row("falling", "nm,p\n410,2000\n400,1000\n");
    row("in a row", "name,400 nm,410 nm\nlamp,1000,2000\n");
    row("bad values where none are needed", "nm,p\n200,x\n400,1000\n410,2000\n1100,\n");
    row("counts beside", "Wave;Sample;Irradiance\n[nm];[counts];[uW]\n400;9;1000\n410;8;2000\n");
  }
  void readsWhatElseThereIs() {
    QFETCH(QString, text);
    const auto table = parseSpectralCsv(text.toStdString(), "l.csv");
    EXPECT_OK(table);
    QVERIFY((table.value().wavelengthsNm == std::vector<double>{400, 410}));
    QVERIFY((table.value().columns == std::vector<std::vector<double>>{{1000, 2000}}));
  }

  void errorsSayLineAndColumn_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("message");
    const auto row = [](const char* name, const char* text, const char* message) {
      QTest::newRow(name) << text << message;
    };
    row("empty", "", "l.csv: the file has no rows");
    row("one row", "nm,p\n400,1\n", "l.csv:1: a curve needs at least two wavelengths");
    row("one column", "nm\n400\n410\n", "l.csv:1: there is one column only");
    row("value missing", "nm,p\n400,1\n410\n420,3\n", "l.csv:3: the row has 1 fields");
    row("value too many", "nm,p\n400,1\n410,2,3\n", "l.csv:3: the row has 3 fields");
    row("empty value", "nm,p,q\n400,1,1\n410,,2\n", "l.csv:3, column 2: '' is not a finite number");
    row("not a number", "nm,p,q\n400,1,nan\n410,2,3\n",
        "l.csv:2, column 3: 'nan' is not a finite number");
    row("infinite", "nm,p\n400,inf\n410,2\n", "l.csv:2, column 2: 'inf' is not a finite");
    row("word", "nm,p\n400,1\n4l0,2\n420,3\n", "l.csv:3, column 1: '4l0' is not a wavelength");
    row("decimal comma", "nm,p\n400,1,5\n410,2,5\n", "l.csv:2: the row has 3 fields");
    row("unsorted", "nm,p\n400,1\n390,2\n395,2\n410,2\n420,2\n",
        "l.csv:3, column 1: the wavelength 390 comes after 400");
    row("repeated", "nm,p\n# c\n400,1\n410,2\n410,2\n",
        "l.csv:5, column 1: the wavelength 410 comes after 410");
    row("CRLF", "nm,p\r\n400,1\r\n410,x\r\n", "l.csv:3, column 2: 'x' is not a finite number");
    row("counts alone", "Wave;Sample;Dark\n[nm];[counts];[counts]\n400;9;1\n410;8;1\n",
        "l.csv:1: all columns are counts of the detector ('Sample', 'Dark')");
  }
  void errorsSayLineAndColumn() {
    QFETCH(QString, text);
    QFETCH(QString, message);
    const auto table = parseSpectralCsv(text.toStdString(), "l.csv");
    QVERIFY(table.failed());
    QVERIFY2(table.error().text().find(message.toStdString()) != std::string::npos,
             table.error().text().c_str());
    QVERIFY(table.error().kind == ErrorKind::input);
  }

  void readsFilesByName() {
    const test::ScratchFolder folder;
    const auto good = folder.write("good.csv", "nm,p\n400,1\n500,1\n");
    EXPECT_OK(readSpectralCsv(good));
    QCOMPARE(readSpectralCsv(good).value().place, good.string());
    EXPECT_ERROR(readSpectralCsv(folder / "gone.csv"), "there is no such file");
    const auto bad = folder.write("bad.csv", "nm,p\n400,1\n500,?\n");
    EXPECT_ERROR(readSpectralCsv(bad), bad.string() + ":3, column 2: '?'");
  }
};

CUTIS_TEST(SpectralCsvTest)

}  // namespace
}  // namespace cutis

#include "spectral_csv_test.moc"
