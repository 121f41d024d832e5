// bench: a small run has all its figures; wrong outputs are told before any work.

#include <nlohmann/json.hpp>

#include "tests/src/cli/program_run.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis::test {
namespace {

constexpr std::size_t kMethods = 7;
constexpr std::size_t kNoises = 5;

class BenchTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    outcome_ = run_.run("bench --pixels 200 --quick --report bench.json --plot bench.svg");
    EXPECT_DONE(outcome_);
    report_ = nlohmann::json::parse(run_.read("bench.json"));
  }

  void theReportHasAllFigures() {
    for (const char* key :
         {"version",    "processor", "isa",    "threads", "profile",   "rig",        "pixels",
          "subsample",  "quick",     "bounds", "methods", "sample",    "coverage",   "lights",
          "parameters", "encodings", "sizes",  "scaling", "published", "speed_ratio"}) {
      QVERIFY2(report_.contains(key), key);
    }
    QCOMPARE(report_["methods"].size(), kMethods * kNoises);
    QCOMPARE(report_["sample"].size(), kMethods);
    QCOMPARE(report_["bounds"].size(), kNoises - 1);
    QCOMPARE(report_["pixels"].get<int>(), 200);
    for (const auto& row : report_["methods"]) {
      for (const char* key : {"visible_mse", "ultraviolet_mse", "near_infrared_mse",
                              "delta_e2000_d65", "delta_e2000_a", "parameter_rmse"}) {
        QVERIFY2(row["errors"].contains(key), key);
      }
      QVERIFY(row["ns_per_pixel"].get<double>() > 0.0);
      QCOMPARE(row["tones"].size(), std::size_t{4});
      QCOMPARE(row.contains("over_bound"), row["noise"].get<double>() > 0.0);
    }
  }

  // The same answers, ties included.
  void indicesFindWhatExhaustiveSearchesFind() {
    QCOMPARE(errorsOf("three_stage"), errorsOf("three_stage_exhaustive"));
    QCOMPARE(errorsOf("full_search"), errorsOf("full_search_exhaustive"));
  }

  void theTablesNameTheMachineAndTheScaledRows() {
    for (const char* part : {"profile li2024, rig monitor", "those marked *", "/bound",
                             "What the paper published", "2048²", "ITA°"}) {
      QVERIFY2(outcome_.output.find(part) != std::string::npos, part);
    }
    QVERIFY(outcome_.output.find("nan") == std::string::npos);
  }

  void thePlotNamesItsPoints() {
    const std::string plot = run_.read("bench.svg");
    QVERIFY(plot.starts_with("<svg"));
    for (const char* part : {"refined, wide prior", "paper: network", "the best possible"})
      QVERIFY2(plot.find(part) != std::string::npos, part);
  }

  void errorsAreToldBeforeAnyWork_data() {
    QTest::addColumn<QString>("options");
    QTest::addColumn<int>("status");
    QTest::addColumn<QString>("part");
    QTest::newRow("folder") << "--report none/bench.json" << 4 << "none";
    QTest::newRow("plot") << "--plot none/bench.svg" << 4 << "none";
    QTest::newRow("picture") << "--plot bench.png" << 2 << "name the file with .svg";
    QTest::newRow("twice") << "--plot a.svg --report a.svg" << 2 << "two results";
    QTest::newRow("few") << "--pixels 10" << 2 << "--pixels";
    QTest::newRow("profile") << "--profile nobody" << 3 << "nobody";
  }

  void errorsAreToldBeforeAnyWork() {
    QFETCH(QString, options);
    QFETCH(int, status);
    QFETCH(QString, part);
    const auto before = run_.contents();
    const Outcome outcome = run_.run("bench " + options);
    QVERIFY2(isOneError(outcome.errors), outcome.errors.c_str());
    QVERIFY2(outcome.errors.find(part.toStdString()) != std::string::npos, outcome.errors.c_str());
    QCOMPARE(outcome.status, status);
    QVERIFY(outcome.output.empty());
    QVERIFY(run_.contents() == before);
  }

 private:
  std::vector<double> errorsOf(const std::string& method) const {
    std::vector<double> errors;
    for (const auto& row : report_["methods"]) {
      if (row["method"] == method) errors.push_back(row["errors"]["visible_mse"]);
    }
    return errors;
  }

  ProgramRun run_;
  Outcome outcome_;
  nlohmann::json report_;
};

CUTIS_TEST(BenchTest)

}  // namespace
}  // namespace cutis::test

#include "bench_test.moc"
