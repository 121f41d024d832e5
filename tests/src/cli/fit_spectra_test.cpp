#include <cmath>
#include <sstream>
#include <utility>

#include "core/base/number_text.h"
#include "core/skin/profile/parameter_sampling.h"
#include "src/files/io/csv.h"
#include "tests/src/cli/program_run.h"
#include "tests/src/cli/refusal.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis::test {
namespace {

constexpr char kHeader[] =
    "id,melanin,melanin_blend,haemoglobin_dermal,haemoglobin_epidermal,carotene,rmse";

std::vector<Spectrum> people(int count) {
  std::vector<Spectrum> spectra;
  for (const ParameterVector& set : sampleBox(li2024().profile().axes, count, 40000)) {
    spectra.push_back(li2024().reflectance(set));
  }
  return spectra;
}

// Samples from 360 to 740 nm in steps of 10 nm.
constexpr int kFirst = 30, kLast = 220, kStep = 5;

std::string spectraInRows(const std::vector<Spectrum>& spectra) {
  std::string text = "id";
  for (int i = kFirst; i <= kLast; i += kStep)
    text += ',' + formatNumber(wavelengthNm(i));
  for (std::size_t s = 0; s < spectra.size(); ++s) {
    text += "\ns" + std::to_string(s);
    for (int i = kFirst; i <= kLast; i += kStep)
      text += ',' + formatNumber(spectra[s][i]);
  }
  return text + "\n";
}

std::string spectraInColumns(const std::vector<Spectrum>& spectra) {
  std::string text = "wavelength_nm";
  for (std::size_t s = 0; s < spectra.size(); ++s)
    text += ",s" + std::to_string(s);
  for (int i = kFirst; i <= kLast; i += kStep) {
    text += "\n" + formatNumber(wavelengthNm(i));
    for (const Spectrum& spectrum : spectra)
      text += ',' + formatNumber(spectrum[i]);
  }
  return text + "\n";
}

class FitSpectraTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void findsTheSkinOfSpectra() {
    run_.write("rows.csv", spectraInRows(people(50)));
    const Outcome outcome = run_.run("fit-spectra rows.csv -o out.csv --profile li2024");
    EXPECT_DONE(outcome);
    QVERIFY2(outcome.output.starts_with("50 spectra, RMSE mean "), outcome.output.c_str());
    QVERIFY(outcome.output.ends_with(" s\n"));
    const std::string text = run_.read("out.csv");
    const auto rows = splitCsv(text);
    QCOMPARE(text.substr(0, text.find('\n')), std::string(kHeader));
    QCOMPARE(rows.size(), std::size_t{51});
    for (std::size_t r = 1; r < rows.size(); ++r) {
      QCOMPARE(rows[r].fields.size(), std::size_t{7});
      QCOMPARE(std::string(rows[r].fields[0]), "s" + std::to_string(r - 1));
      EXPECT_AT_MOST(parseNumber(rows[r].fields[6]).value_or(NAN), 1e-6);
    }
  }

  void freeConstantsAreColumns() {
    run_.write("free.csv", spectraInRows(people(3)));
    const std::string five = std::string(kHeader).substr(0, std::string(kHeader).rfind(','));
    for (const auto& [names, columns] :
         {std::pair<QString, std::string>{"oxygenation", ",oxygenation,rmse"},
          {"thickness", ",thickness_mm,rmse"},
          {"thickness,oxygenation", ",oxygenation,thickness_mm,rmse"}}) {
      const QString options = " --profile li2024 --free " + names;
      EXPECT_DONE(run_.run("fit-spectra free.csv -o out.csv --threads 1" + options));
      EXPECT_DONE(run_.run("fit-spectra free.csv -o two.csv --threads 2" + options));
      const std::string text = run_.read("out.csv");
      QVERIFY(text == run_.read("two.csv"));
      const auto rows = splitCsv(text);
      QCOMPARE(text.substr(0, text.find('\n')), five + columns);
      for (std::size_t r = 1; r < rows.size(); ++r) {
        QCOMPARE(rows[r].fields.size(), rows[0].fields.size());
        EXPECT_AT_MOST(parseNumber(rows[r].fields.back()).value_or(NAN), 1e-6);
      }
    }
  }

  void whatCannotBeFreeIsRefused_data() {
    QTest::addColumn<QString>("names");
    QTest::addColumn<QString>("part");
    QTest::newRow("unknown") << "water"
                             << "'water' cannot be found by a fit";
    QTest::newRow("twice") << "thickness,thickness"
                           << "'thickness' is named twice";
  }
  void whatCannotBeFreeIsRefused() {
    QFETCH(QString, names);
    QFETCH(QString, part);
    run_.write("free.csv", spectraInRows(people(1)));
    const Outcome outcome = run_.run("fit-spectra free.csv -o none.csv --free " + names);
    QCOMPARE(outcome.status, 2);
    QVERIFY2(isOneError(outcome.errors), outcome.errors.c_str());
    QVERIFY2(outcome.errors.find(part.toStdString()) != std::string::npos, outcome.errors.c_str());
    QVERIFY(!std::filesystem::exists(run_ / "none.csv"));
  }

  void freeConstantsAskForMoreWavelengths() {
    run_.write("six.csv", "id,400,450,500,550,600,650\na,.1,.2,.3,.3,.4,.5\n");
    EXPECT_DONE(run_.run("fit-spectra six.csv -o out.csv --free oxygenation"));
    const Outcome outcome =
        run_.run("fit-spectra six.csv -o none.csv --free oxygenation,thickness");
    QCOMPARE(outcome.status, 3);
    QVERIFY2(outcome.errors.find("6 where at least 7 are needed") != std::string::npos,
             outcome.errors.c_str());
    QVERIFY(!std::filesystem::exists(run_ / "none.csv"));
  }

  void columnsThreadsAndQuietChangeNothing() {
    const auto spectra = people(100);
    run_.write("rows.csv", spectraInRows(spectra));
    run_.write("columns.csv", spectraInColumns(spectra));
    EXPECT_DONE(run_.run(
        "fit-spectra rows.csv -o one.csv --profile li2024 --threads 1 --specular excluded"));
    EXPECT_DONE(
        run_.run("fit-spectra rows.csv -o two.csv --profile li2024 --threads 2 --range 400:700"));
    const Outcome quiet =
        run_.run("fit-spectra columns.csv -o columns_out.csv --profile li2024 --quiet");
    EXPECT_DONE(quiet);
    QVERIFY(quiet.output.empty());
    QVERIFY(run_.read("one.csv") == run_.read("two.csv"));
    QVERIFY(run_.read("one.csv") == run_.read("columns_out.csv"));
  }

  void theRangeDecidesWhatCounts() {
    std::vector<Spectrum> spectra = people(1);
    spectra[0].tail(kSampleCount - 140) = 0.9;  // from 580 nm: no skin
    run_.write("cut.csv", spectraInRows(spectra));
    EXPECT_DONE(run_.run("fit-spectra cut.csv -o all.csv --profile li2024"));
    EXPECT_DONE(run_.run("fit-spectra cut.csv -o part.csv --profile li2024 --range 400:579.5"));
    const auto error = [&](const std::string& name) {
      const std::string text = run_.read(name);
      return parseNumber(splitCsv(text)[1].fields[6]).value_or(NAN);
    };
    QVERIFY(error("all.csv") > 0.01);
    EXPECT_AT_MOST(error("part.csv"), 1e-6);
  }

  // A name never turns its row into a comment.
  void namesSurvive() {
    std::string text = spectraInColumns(people(2));
    text.replace(text.find(",s0"), 3, ",#0");
    run_.write("names.csv", text);
    EXPECT_DONE(run_.run("fit-spectra names.csv -o out.csv"));
    const std::string written = run_.read("out.csv");
    const auto rows = splitCsv(written);
    QCOMPARE(rows.size(), std::size_t{3});
    QCOMPARE(std::string(rows[1].fields[0]), std::string("#0"));
  }

  void namesThatHoldSeparatorsAreQuoted() {
    run_.write("in.csv",
               "nm,\"cheek, left\",\"a\n\"\"b\"\"\"\n400,.1,.1\n450,.2,.2\n500,.2,.2\n"
               "550,.3,.3\n600,.4,.4\n");
    EXPECT_DONE(run_.run("fit-spectra in.csv -o out.csv"));
    const std::string written = run_.read("out.csv");
    QVERIFY2(written.find("\n\"cheek, left\",") != std::string::npos, written.c_str());
    QVERIFY2(written.find("\n\"a\n\"\"b\"\"\",") != std::string::npos, written.c_str());
  }

  void percentIsSaid() {
    run_.write("in.csv", "id;400;450;500;550;600\na;10,5;20;30;40;50\n");
    const Outcome outcome = run_.run("fit-spectra in.csv -o out.csv");
    QCOMPARE(outcome.status, 0);
    QCOMPARE(outcome.errors,
             std::string(
                 "cutis-cli: note: in.csv: reflectances are read as percent, since most are above "
                 "1.5\n"));
  }

  void wrongFilesLeaveNothing_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("part");
    const QString header = "id,400,450,500,550,600\n";
    QTest::newRow("word") << header + "a,.1,.2,.3,.4,x\n"
                          << "wrong.csv:2, column 6: 'x'";
    QTest::newRow("negative") << header + "a,.1,.2,.3,.4,-1\n"
                              << "wrong.csv:2, column 6: the reflectance -1";
    QTest::newRow("one in percent") << header + "a,.1,20,.3,.4,.5\n"
                                    << "wrong.csv:2, column 3: the reflectance 20 is not a share";
    QTest::newRow("short") << header + "a,.1\n"
                           << "wrong.csv:2: the row has 2 fields";
    QTest::newRow("four wavelengths")
        << "id,400,450,500,550\na,.1,.2,.3,.4\n"
        << "wrong.csv:1: too few wavelengths lie from 400 to 700 nm: 4";
  }
  void wrongFilesLeaveNothing() {
    QFETCH(QString, text);
    QFETCH(QString, part);
    run_.write("wrong.csv", text.toStdString());
    const Outcome outcome = run_.run("fit-spectra wrong.csv -o none.csv");
    EXPECT_REFUSED(outcome, 3, part.toStdString());
    QVERIFY(!std::filesystem::exists(run_ / "none.csv"));
  }

  void sourcesAreNotWrittenTo() {
    run_.write("same.csv", spectraInRows(people(1)));
    const std::string before = run_.read("same.csv");
    const Outcome outcome = run_.run("fit-spectra same.csv -o same.csv");
    QCOMPARE(outcome.status, 2);
    QVERIFY(run_.read("same.csv") == before);
  }

 private:
  ProgramRun run_;
};

CUTIS_TEST(FitSpectraTest)

}  // namespace
}  // namespace cutis::test

#include "fit_spectra_test.moc"
