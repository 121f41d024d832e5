#include "src/files/spectra/measured_spectra_file.h"

#include <QtTest>

#include "tests/support/expect.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

using Strings = std::vector<std::string>;
using Numbers = std::vector<double>;

Result<MeasuredSpectra> parse(std::string_view text, const WavelengthRange& range = {}) {
  return parseMeasuredSpectra(text, "m.csv", range, 2, {});
}

class MeasuredSpectraTest : public QObject {
  Q_OBJECT

 private slots:
  void readsBothDirections_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("ids");
    const auto row = [](const char* name, const char* text, const char* ids) {
      QTest::newRow(name) << text << ids;
    };
    row("rows", "id,390,400,450.5,710\na,9,.1,.2,9\nb,9,.3,.4,9\n", "a b");
    row("rows without names", "390,400,450.5,710\n9,.1,.2,9\n9,.3,.4,9\n", "1 2");
    row("numbered rows", "record,400,450.5\n7,.1,.2\n8,.3,.4\n", "7 8");
    row("large numbers", "record,400,450.5\n700,.1,.2\n800,.3,.4\n", "700 800");
    row("named beside others", "site,Sample,400,450.5\nx,a,.1,.2\ny,b,.3,.4\n", "a b");
    row("first of others", "site,age,400,450.5\nx,20,.1,.2\ny,30,.3,.4\n", "x y");
    row("empty name", "id,400,450.5\n,.1,.2\nb,.3,.4\n", "1 b");
    row("corner names wavelengths", "wavelength,400,450.5\n1,.1,.2\n2,.3,.4\n", "1 2");
    row("units", "id,400nm,450.5 nm\na,.1,.2\nb,.3,.4\n", "a b");
    row("columns", "nm,a,b\n390,9,9\n400,.1,.3\n450.5,.2,.4\n710,9,9\n", "a b");
    row("columns without names", "400,.1,.3\n450.5,.2,.4\n", "1 2");
    row("numbered columns", "nm,1,2\n400,.1,.3\n450.5,.2,.4\n", "1 2");
    row("large numbered columns", "wavelength_nm,501,502\n400,.1,.3\n450.5,.2,.4\n", "501 502");
    row("as a table program writes it",
        "\xEF\xBB\xBF# skin\r\n\"id\",400,450.5\r\n\r\n\"a\",0.1, 2e-1\r\n# b\r\nb,+.3,.4", "a b");
  }
  void readsBothDirections() {
    QFETCH(QString, text);
    QFETCH(QString, ids);
    const auto spectra = parse(text.toStdString());
    EXPECT_OK(spectra);
    QVERIFY((spectra.value().wavelengthsNm == Numbers{400.0, 450.5}));
    QVERIFY((spectra.value().reflectances == Numbers{0.1, 0.2, 0.3, 0.4}));
    QStringList found;
    for (const std::string& id : spectra.value().ids)
      found += QString::fromStdString(id);
    QCOMPARE(found.join(' '), ids);
  }

  void theRangeIncludesItsEnds() {
    const auto spectra = parse("id,400,500,600\na,.1,.2,.3\n", {500.0, 600.0});
    EXPECT_OK(spectra);
    QVERIFY((spectra.value().wavelengthsNm == Numbers{500.0, 600.0}));
    QVERIFY((spectra.value().reflectances == Numbers{0.2, 0.3}));
  }

  void whatIsOutsideTheRangeDoesNotMatter() {
    EXPECT_OK(parse("id,380,390,400,500,710,720\na,nan,,.2,.3,#N/A,1e9\n"));
    EXPECT_OK(parse("id,390,400,500,710\na,x,.2,.3\n"));
    EXPECT_OK(parse("nm,a\n390,-\n400,.2\n500,.3\n710,\n"));
  }

  // A file of a light has numbers that could be reflectances.
  void lightsAreQuestioned_data() {
    QTest::addColumn<QString>("head");
    QTest::addColumn<QString>("question");
    const auto row = [](const char* head, const char* question) {
      QTest::newRow(head) << QString(head) + "\n" << QString(question);
    };
    row("Spectral irradiance", "m.csv:1: 'irradiance' speaks of light that is emitted");
    row("Device: meter\nIlluminance,520", "m.csv:2: 'illuminance' speaks");
    row("unit: W/m2/nm", "m.csv:1: 'w/m2' speaks");
    row("unit: µW/cm²/nm", "m.csv:1: 'w/cm' speaks");
    row("Radiance factor", "");
    row("Reflectance under an irradiance of 1000 lx", "");
    row("Skin of the cheek", "");
  }
  void lightsAreQuestioned() {
    QFETCH(QString, head);
    QFETCH(QString, question);
    std::vector<std::string> said;
    JobContext context;
    context.notice = [&](const std::string& sentence) { said.push_back(sentence); };
    const std::string text = head.toStdString() + "nm,a\n400,.1\n450,.2\n500,.3\n550,.4\n";
    EXPECT_OK(parseMeasuredSpectra(text, "m.csv", {}, 2, context));
    QCOMPARE(said.size(), std::size_t{question.isEmpty() ? 0U : 1U});
    if (!said.empty())
      QVERIFY2(said[0].find(question.toStdString()) != std::string::npos, said[0].c_str());
  }

  // Instruments are noisy at their ends.
  void negativeValuesOutsideTheRangeDoNotMatter() {
    EXPECT_OK(parse("id,390,400,500\na,-.1,.2,.3\n"));
  }

  void errorsSayWhere_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("message");
    const auto row = [](const char* name, const char* text, const char* message) {
      QTest::newRow(name) << text << message;
    };
    row("comments only", "# nothing\n", "m.csv: the file has no rows");
    row("one column", "400\n500\n", "m.csv:1: there is one column only");
    row("no wavelengths", "# c\nid,a,b\nx,.1,.2\n", "m.csv:2: there are no wavelengths");
    row("micrometres", "id,0.4,0.5\na,.1,.2\n", "m.csv:1: there are no wavelengths");
    row("no spectra", "id,400,500\n", "m.csv: there are no spectra");
    row("misspelt wavelength", "id,4o0,500,600\na,.1,.2,.3\n",
        "m.csv:1, column 2: '4o0' is not a wavelength");
    row("word among wavelengths", "id,400,x,600\na,.1,.2,.3\n",
        "m.csv:1, column 3: 'x' is not a wavelength");
    row("unsorted", "id,500,400,600\na,.1,.2,.3\n",
        "m.csv:1, column 3: the wavelength 400 comes after 500");
    row("repeated", "nm,a\n400,.1\n500,.2\n500,.3\n",
        "m.csv:4, column 1: the wavelength 500 comes after 500");
    row("out of range", "id,800,900\na,.1,.2\n",
        "m.csv:1: too few wavelengths lie from 400 to 700 nm: 0 where at least 2");
    row("too few", "nm,a\n390,.1\n400,.2\n",
        "m.csv:1: too few wavelengths lie from 400 to 700 nm: 1");
    row("short row", "id,400,500\na,.1,.2\nb,.1\n", "m.csv:3: the row has 2 fields");
    row("long row", "nm,a\n400,.1\n500,.2,.3\n", "m.csv:3: the row has 3 fields");
    row("word", "id,400,500\na,.1,x\n", "m.csv:2, column 3: 'x' is not a finite number");
    row("empty", "id,400,500\na,.1,\n", "m.csv:2, column 3: '' is not a finite number");
    row("nan", "nm,a\n400,nan\n500,.1\n", "m.csv:2, column 2: 'nan' is not a finite number");
    row("infinite", "id,400,500\na,inf,.1\n", "m.csv:2, column 2: 'inf' is not a finite number");
    row("negative", "id,400,500\n\na,.1,-.2\n",
        "m.csv:3, column 3: the reflectance -0.2 is negative");
    row("no data", "#N/A\nid,400,500\na,.1,#N/A\n", "m.csv:3, column 3: '#N/A' is not a finite");
    row("one in percent", "id,400,500,600\na,.3,37.5,.4\n",
        "m.csv:2, column 3: the reflectance 37.5 is not a share from 0 to 1 as most others are");
    row("one spectrum in shares", "id,400,500\na,20,37.5\nb,20,30\nc,.2,.4\n",
        "m.csv:4, column 3: the reflectance 0.4 is the largest of its spectrum");
    row("beyond percent", "nm,a\n400,200\n500,300\n",
        "m.csv:3, column 2: the reflectance 300 is neither a share from 0 to 1 nor percent");
    row("open quote", "id,400,500\n\"a,.1,.2\nb,.3,.4\n", "m.csv:2: a quote opens here");
    row("wavenumbers", "wavenumber (cm-1),a\n25000,.1\n20000,.2\n",
        "m.csv:1, column 1: the heading names wavenumbers");
    row("not the unit of the heading", "wavelength_um,a\n400,.1\n500,.2\n",
        "m.csv:1, column 1: by the unit in this heading the wavelengths are 400000 to 500000 nm");
    row("thousands or decimals", "nm;a;b\n400;0,1;0,2\n500;1.234;0,3\n",
        "m.csv:3, column 2: '1.234' may be a decimal number or thousands");
    row("two decimal marks", "nm;a;b\n400;0,1;0,2\n500;0.1;0,3\n",
        "m.csv:3, column 2: '0.1' is not written as the other numbers are, with decimal commas");
    row("misspelt wavelength in a column", "nm,a\n4o0,.1\n500,.2\n600,.3\n",
        "m.csv:2, column 1: '4o0' is not a wavelength");
    row("misspelt below", "nm,a\n400,.1\n500,.2\n6o0,.3\n",
        "m.csv:4, column 1: '6o0' is not a wavelength");
  }
  void errorsSayWhere() {
    QFETCH(QString, text);
    QFETCH(QString, message);
    const auto spectra = parse(text.toStdString());
    EXPECT_ERROR(spectra, message.toStdString());
    QVERIFY(spectra.error().kind == ErrorKind::input);
  }

  void readsFilesByName() {
    const test::ScratchFolder folder;
    const auto good = folder.write("good.csv", "id,400,500\na,.1,.2\n");
    EXPECT_OK(readMeasuredSpectra(good, {}, 2, {}));
    EXPECT_ERROR(readMeasuredSpectra(folder / "gone.csv", {}, 2, {}), "there is no such file");
  }

  void stopsWhenAsked() {
    std::stop_source source;
    source.request_stop();
    JobContext context;
    context.stop = source.get_token();
    QVERIFY(parseMeasuredSpectra("id,400,500\na,.1,.2\n", "m.csv", {}, 2, context).cancelled());
  }
};

CUTIS_TEST(MeasuredSpectraTest)

}  // namespace
}  // namespace cutis

#include "measured_spectra_file_test.moc"
