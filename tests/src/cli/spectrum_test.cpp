#include <array>
#include <charconv>
#include <cmath>
#include <sstream>

#include "core/spectra/grid.h"
#include "tests/src/cli/program_run.h"
#include "tests/src/cli/refusal.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis::test {
namespace {

std::vector<std::vector<double>> numbers(const std::string& text) {
  std::vector<std::vector<double>> rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    rows.emplace_back();
    std::istringstream fields(line);
    for (std::string field; std::getline(fields, field, ',');) {
      double value = NAN;
      std::from_chars(field.data(), field.data() + field.size(), value);
      rows.back().push_back(value);
    }
  }
  return rows;
}

// The check values of resources/manual/model.md.
constexpr std::array<int, 12> kWavelengths = {300, 350, 414, 450, 500, 542,
                                              576, 600, 700, 850, 970, 1000};
constexpr char kSets[] =
    "# check values\n"
    "melanin,melanin_blend,haemoglobin_dermal,haemoglobin_epidermal,carotene\n"
    "0,0,0,0,0\n"
    "0.02,0.5,0.02,0.01,0.001\n"
    "0.5,1,0.5,0.3,0.01\n";
constexpr double kExpected[3][12] = {
    {0.4576923, 0.4831781, 0.5191804, 0.5399141, 0.5682213, 0.5880234, 0.5993388, 0.6043874,
     0.6066184, 0.5826497, 0.4903216, 0.4980497},
    {0.1863149, 0.1920704, 0.1528857, 0.2157385, 0.2583752, 0.2530510, 0.2612924, 0.3429724,
     0.4358352, 0.4840787, 0.4425412, 0.4537763},
    {0.0170795, 0.0155826, 0.0088136, 0.0162981, 0.0206543, 0.0194032, 0.0203619, 0.0284833,
     0.0400246, 0.0608110, 0.0821301, 0.0890279}};

class SpectrumTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void agreesWithTheCheckValues() {
    run_.write("sets.csv", kSets);
    EXPECT_DONE(run_.run("spectrum --csv sets.csv -o out.csv --profile li2024"));
    const auto rows = numbers(run_.read("out.csv"));
    QCOMPARE(rows.size(), std::size_t{4});
    for (const auto& row : rows)
      QCOMPARE(row.size(), std::size_t{kSampleCount});
    for (int i = 0; i < kSampleCount; ++i) {
      QCOMPARE(rows[0][static_cast<std::size_t>(i)], wavelengthNm(i));
    }
    for (std::size_t set = 0; set < 3; ++set) {
      for (std::size_t w = 0; w < kWavelengths.size(); ++w) {
        const auto column = static_cast<std::size_t>((kWavelengths[w] - 300) / 2);
        EXPECT_NEAR(rows[set + 1][column], kExpected[set][w], 1e-6);
      }
    }
  }

  void oneSetGoesToStandardOutput() {
    const Outcome outcome = run_.run("spectrum --params 0.02,0.5,0.02,0.01,0.001 --profile li2024");
    EXPECT_DONE(outcome);
    const auto rows = numbers(outcome.output);
    QCOMPARE(rows.size(), std::size_t{2});
    EXPECT_NEAR(rows[1][0], kExpected[1][0], 1e-6);
  }

  void columnsAreFoundByName() {
    run_.write("turned.csv",
               "carotene,haemoglobin_epidermal,haemoglobin_dermal,melanin_blend,melanin\n"
               "0.001,0.01,0.02,0.5,0.02\n");
    const Outcome outcome = run_.run("spectrum --csv turned.csv --profile li2024");
    EXPECT_DONE(outcome);
    EXPECT_NEAR(numbers(outcome.output)[1][0], kExpected[1][0], 1e-6);
  }

  void wrongSetsAreNamedByLine_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("part");
    const QString header =
        "melanin,melanin_blend,haemoglobin_dermal,haemoglobin_epidermal,carotene\n";
    QTest::newRow("range") << header + "0,0,0,0,0\n0,2,0,0,0\n"
                           << "wrong.csv:3: melanin_blend is 2";
    QTest::newRow("negative") << header + "-0.1,0,0,0,0\n"
                              << "wrong.csv:2: melanin is -0.1";
    QTest::newRow("nan") << header + "nan,0,0,0,0\n"
                         << "wrong.csv:2: melanin is 'nan'";
    QTest::newRow("short") << header + "0,0,0,0\n"
                           << "wrong.csv:2: the row has 4 values";
    QTest::newRow("header") << "melanine,b\n"
                            << "did you mean 'melanin'?";
    QTest::newRow("comment") << "# nothing\n"
                             << "wrong.csv: the file has no rows";
  }

  void wrongSetsAreNamedByLine() {
    QFETCH(QString, text);
    QFETCH(QString, part);
    run_.write("wrong.csv", text.toStdString());
    const Outcome outcome = run_.run("spectrum --csv wrong.csv -o none.csv");
    EXPECT_REFUSED(outcome, 3, part.toStdString());
    QVERIFY(!std::filesystem::exists(run_ / "none.csv"));
  }

 private:
  ProgramRun run_;
};

CUTIS_TEST(SpectrumTest)

}  // namespace
}  // namespace cutis::test

#include "spectrum_test.moc"
