// One table of spectra, written in every way that programs write tables.

#include <QtTest>

#include "src/files/spectra/measured_spectra_file.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

std::string inUtf16(std::string_view text, bool big, bool marked) {
  std::string bytes;
  const auto add = [&](unsigned code) {
    const char high = static_cast<char>(code >> 8), low = static_cast<char>(code & 0xFF);
    bytes += big ? high : low;
    bytes += big ? low : high;
  };
  if (marked) add(0xFEFF);
  for (const char c : text)
    add(static_cast<unsigned char>(c));  // Latin-1
  return bytes;
}

class TableDialectsTest : public QObject {
  Q_OBJECT

 private:
  static Result<MeasuredSpectra> parse(std::string_view text, std::vector<std::string>& notes) {
    JobContext context;
    context.notice = [&](const std::string& sentence) { notes.push_back(sentence); };
    return parseMeasuredSpectra(text, "d.csv", {400.0, 500.0}, 2, context);
  }

 private slots:
  void readsOneTable_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("note");
    const auto row = [](const char* name, const std::string& text, const char* note = "") {
      QTest::newRow(name) << QByteArray::fromStdString(text) << note;
    };
    const char percent[] = "d.csv: reflectances are read as percent, since most are above 1.5";
    const auto declared = [](int line) {
      return "d.csv:" + std::to_string(line) + ": reflectances are read as percent, as declared";
    };
    row("plain", "nm,a,b\n400,.1,.2\n450,.3,.4\n500,.5,.6\n");
    row("byte order mark", "\xEF\xBB\xBFnm,a,b\n400,.1,.2\n450,.3,.4\n500,.5,.6\n");
    row("carriage returns", "nm,a,b\r400,.1,.2\r450,.3,.4\r500,.5,.6\r");
    row("semicolons", "nm;a;b\n400;0,1;0,2\n450;0,3;0,4\n500;0,5;0,6\n");
    row("semicolons and points", "nm;a;b\n400;0.1;0.2\n450;0.3;0.4\n500;0.5;0.6\n");
    row("tabs", "nm\ta\tb\n400\t0,1\t0,2\n450\t0,3\t0,4\n500\t0,5\t0,6\n");
    row("blanks", "nm   a   b\n400  0.1 0.2\n450  0.3 0.4\n 500  0.5 0.6\n");
    row("decimal commas in quotes",
        "nm,a,b\n400,\"0,1\",\"0,2\"\n450,\"0,3\",\"0,4\"\n500,\"0,5\",\"0,6\"\n");
    row("decimal commas of wavelengths", "nm;a;b\n400,0;0,1;0,2\n450,0;0,3;0,4\n500,00;0,5;0,6\n");
    row("exponents", "nm,a,b\n400,1e-1,2E-01\n450,+3.0e-1,40e-2\n5e2,.5,0.06e1\n");
    row("exponents and commas", "nm;a;b\n400;1,0e-1;2E-01\n450;3e-1;4,0e-1\n5,0e2;0,5;6e-1\n");
    row("quoted numbers", "\"nm\",\"a\",\"b\"\n\"400\",\" .1\",\".2\"\n450,.3,.4\n500,.5,.6\n");
    row("falling", "nm,a,b\n500,.5,.6\n450,.3,.4\n400,.1,.2\n");
    row("falling in a row", "id,500,450,400\na,.5,.3,.1\nb,.6,.4,.2\n");
    row("percent", "nm,a,b\n400,10,20\n450,30,40\n500,50,60\n", percent);
    row("percent signs", "nm,a,b\n400,10%,20%\n450,30 %,40%\n500,50%,60%\n");
    row("micrometres", "wavelength_um,a,b\n0.4,.1,.2\n0.45,.3,.4\n0.5,.5,.6\n");
    row("micrometres in a row", "\"\xC2\xB5m\",0.4,0.45,0.5\na,.1,.3,.5\nb,.2,.4,.6\n");
    row("micrometres in Latin-1",
        "Wavelength [\xB5m];a;b\n0,4;0,1;0,2\n0,45;0,3;0,4\n0,5;0,5;0,6\n",
        "d.csv: the text is not UTF-8 and is read as Windows-1252");
    row("angstroms", "Wavelength (\xC3\x85),a,b\n4000,.1,.2\n4500,.3,.4\n5000,.5,.6\n");
    row("units of their own", "x,a,b\n0.4 um,.1,.2\n450[nm],.3,.4\n5000 angstrom,.5,.6\n");
    row("labels", "id,R400,R_450,spectral_500\na,.1,.3,.5\nb,.2,.4,.6\n");
    row("trailing separators", "nm,a,b,\n400,.1,.2,\n450,.3,.4,\n500,.5,.6,\n");
    row("trailing separators of values", "nm,a,b\n400,.1,.2,\n450,.3,.4,\n500,.5,.6,\n");
    row("empty rows and columns",
        ",,,,\n,,nm,a,b,,\n,,,,\n,,400,.1,.2,,\n,,450,.3,.4,,\n,,500,.5,.6,,\n,,,,\n,,,,\n");
    row("empty rows and columns around rows",
        ";;;;;\n;id;400;450;500;;\n;a;0,1;0,3;0,5;;\n;;;;;\n;b;0,2;0,4;0,6;;\n;;;;;\n");
    row("text above",
        "Skin of two people\nmeasured, 3 May\n\nnm,a,b\n400,.1,.2\n450,.3,.4\n"
        "500,.5,.6\n");
    row("text above rows", "Skin\nOperator,X\n\nid,400,450,500\na,.1,.3,.5\nb,.2,.4,.6\n");
    row("row numbers", "No,wavelength,a,b\n101,400,.1,.2\n102,450,.3,.4\n103,500,.5,.6\n");
    row("columns behind", "id,400,450,500,L*,remark\na,.1,.3,.5,60,\nb,.2,.4,.6,70,dry\n",
        "d.csv:1: columns behind the wavelengths are left out: 'L*', 'remark'");
    row("percent by unit", "nm,a,b\n[nm],[%],[%]\n400,10,20\n450,30,40\n500,50,60\n",
        declared(2).c_str());
    row("percent by heading", "# Reflectance in %\nnm,a,b\n400,10,20\n450,30,40\n500,50,60\n",
        declared(1).c_str());
    row("percent by heading of rows", "id (%),400,450,500\na,10,30,50\nb,20,40,60\n",
        declared(1).c_str());
    row("percent by heading and signs",
        "# Reflectance in %\nnm,a,b\n400,10%,20%\n450,30%,40%\n500,50%,60%\n");
    row("a number of percent declares nothing",
        "# Reflectance, humidity 45 %\nnm,a,b\n400,.1,.2\n450,.3,.4\n500,.5,.6\n");
    const std::string plain = "nm;a;b\r\n400;0,1;0,2\r\n450;0,3;0,4\r\n500;0,5;0,6\r\n";
    row("UTF-16 little", inUtf16(plain, false, true));
    row("UTF-16 big", inUtf16(plain, true, true));
    row("UTF-16 little without a mark", inUtf16(plain, false, false));
    row("UTF-16 big without a mark", inUtf16(plain, true, false));
    row("UTF-16 with micrometres",
        inUtf16("Wavelength (\xB5m)\ta\tb\n0.4\t.1\t.2\n0.45\t.3\t.4\n0.5\t.5\t.6\n", false, true));
  }
  void readsOneTable() {
    QFETCH(QByteArray, text);
    QFETCH(QString, note);
    std::vector<std::string> notes;
    const auto spectra = parse(text.toStdString(), notes);
    EXPECT_OK(spectra);
    QVERIFY((spectra.value().ids == std::vector<std::string>{"a", "b"}));
    QVERIFY((spectra.value().wavelengthsNm == std::vector<double>{400.0, 450.0, 500.0}));
    const std::vector<double> right = {0.1, 0.3, 0.5, 0.2, 0.4, 0.6};
    for (std::size_t i = 0; i < right.size(); ++i)
      EXPECT_NEAR(spectra.value().reflectances[i], right[i], 1e-15);
    QCOMPARE(notes.size(), note.isEmpty() ? std::size_t{0} : std::size_t{1});
    if (!notes.empty()) QCOMPARE(QString::fromStdString(notes[0]), note);
  }

  // Dark skin under 450 nm reflects less than 1.5 %: what the file declares is believed.
  void declaredPercentIsBelieved_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<int>("line");
    QTest::newRow("comment") << "# Reflectance in %\nnm,a\n400,.9\n500,1.2\n" << 1;
    QTest::newRow("column") << "nm,%R\n400,.9\n500,1.2\n" << 1;
    QTest::newRow("named column") << "nm,s [%]\n400,.9\n500,1.2\n" << 1;
    QTest::newRow("unit below") << "nm,a\n[nm],[%]\n400,.9\n500,1.2\n" << 2;
    QTest::newRow("word") << "Unit: percent\n\nnm,a\n400,.9\n500,1.2\n" << 1;
  }
  void declaredPercentIsBelieved() {
    QFETCH(QString, text);
    QFETCH(int, line);
    std::vector<std::string> notes;
    const auto spectra = parse(text.toStdString(), notes);
    EXPECT_OK(spectra);
    EXPECT_NEAR(spectra.value().reflectances[0], 0.009, 1e-12);
    QCOMPARE(notes.size(), std::size_t{1});
    QCOMPARE(notes[0], "d.csv:" + std::to_string(line) +
                           ": reflectances are read as percent, as declared here, though none is "
                           "above 1.5 %; if they are shares from 0 to 1, correct this line");
  }

  // What is no UTF-8 comes out as UTF-8.
  void otherLettersAreReadAsWindows1252() {
    std::vector<std::string> notes;
    const auto spectra =
        parse("nm,H\xE4nde,\x80 \x96 5,\xC3(\n400,.1,.2,.3\n500,.1,.2,.3\n", notes);
    EXPECT_OK(spectra);
    QVERIFY((spectra.value().ids ==
             std::vector<std::string>{"H\xC3\xA4nde", "\xE2\x82\xAC \xE2\x80\x93 5", "\xC3\x83("}));
    QCOMPARE(notes.size(), std::size_t{1});
  }

  void namesMayHoldAnything() {
    std::vector<std::string> notes;
    const auto spectra = parse(
        "nm,\"cheek, left\",\"a \"\"b\"\"\nc\",\xC3\xA4\n400,.1,.2,.3\n500,.1,.2,.3\n", notes);
    EXPECT_OK(spectra);
    QVERIFY(
        (spectra.value().ids == std::vector<std::string>{"cheek, left", "a \"b\"\nc", "\xC3\xA4"}));
  }

  void thousandsAreGroupedWhereADecimalShowsIt() {
    std::vector<std::string> notes;
    JobContext context;
    const auto spectra = parseMeasuredSpectra("nm;a;b\n998,5;0,1;0,2\n1.000,0;0,3;0,4\n", "d.csv",
                                              {900.0, 1000.0}, 2, context);
    EXPECT_OK(spectra);
    QVERIFY((spectra.value().wavelengthsNm == std::vector<double>{998.5, 1000.0}));
  }

  void saysWhatIsNoTable_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("message");
    const auto row = [](const char* name, const std::string& text, const char* message) {
      QTest::newRow(name) << QByteArray::fromStdString(text) << message;
    };
    using namespace std::string_literals;
    row("nothing", "", "d.csv: the file has no rows");
    row("a mark alone", "\xEF\xBB\xBF", "d.csv: the file has no rows");
    row("separators alone", ",,,\n , \n", "d.csv: the file has no rows");
    row("one line", "400,500,600\n", "d.csv: there are no spectra below the wavelengths");
    row("a word", "spectra\n", "d.csv:1: there is one column only");
    row("binary", "nm\0\x01\x02\xff\xfe spectra"s, "d.csv: this is no text but a binary file");
    row("a spreadsheet", "PK\x03\x04\x14\0\x06\0"s, "d.csv: this is a spreadsheet or an archive");
    row("XML", "<?xml version=\"1.0\"?>\n<cc:CxF/>\n", "d.csv: this is XML or HTML");
    row("long", "nm,a\n400," + std::string(5'000'000, 'x') + "\n500,.1\n",
        ("d.csv:2, column 2: '" + std::string(80, 'x') + "…' is not a finite number").c_str());
    row("control characters", "nm,a\n400,\"1\t\n\"\n500,.1\n",
        "d.csv:2, column 2: '1  ' is not a finite number");
    row("micrometres without a unit", "x,a\n0.4,.1\n0.5,.2\n",
        "d.csv:1: there are no wavelengths in nm in the first row or column; where they have "
        "another unit, name it in the heading");
  }
  void saysWhatIsNoTable() {
    QFETCH(QByteArray, text);
    QFETCH(QString, message);
    std::vector<std::string> notes;
    EXPECT_ERROR(parse(text.toStdString(), notes), message.toStdString());
  }
};

CUTIS_TEST(TableDialectsTest)

}  // namespace
}  // namespace cutis

#include "table_dialects_test.moc"
