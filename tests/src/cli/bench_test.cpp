// bench: a small run has all its figures; wrong outputs are reported before any work.

#include <algorithm>
#include <fstream>

#include <QXmlStreamReader>
#include <nlohmann/json.hpp>

#include "tests/src/cli/program_run.h"
#include "tests/src/cli/refusal.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis::test {
namespace {

constexpr std::size_t kMethods = 8;
constexpr std::size_t kNoises = 5;
// The exact setting is judged without noise alone.
constexpr std::size_t kRows = (kMethods - 1) * kNoises + 1;

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
         {"version",  "processor", "isa",        "threads",     "profile", "rig",
          "pixels",   "subsample", "quick",      "bounds",      "methods", "sample",
          "coverage", "lights",    "parameters", "encodings",   "sizes",   "scaling",
          "networks", "starts",    "published",  "speed_ratio", "goals",   "first_picture"}) {
      QVERIFY2(report_.contains(key), key);
    }
    QCOMPARE(report_["methods"].size(), kRows);
    QCOMPARE(report_["sample"].size(), kMethods - 1);
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

  void theExactSettingIsJudgedWithoutNoise() {
    for (const char* part : {"methods", "sample", "sizes"}) {
      for (const auto& row : report_[part]) {
        if (row["method"] == "refined_exact") QCOMPARE(row["noise"].get<double>(), 0.0);
      }
    }
  }

  void memoryIsThatOfTheFit() {
    std::vector<double> bytes;
    for (const auto& row : report_["sizes"]) {
      if (row["method"] != "refined_wide" || row["content"] != "uncorrelated") continue;
      QVERIFY(row.contains("fit_memory_bytes"));
      bytes.push_back(row["fit_memory_bytes"]);
      const double pixels = row["size"].get<double>() * row["size"].get<double>();
      // Five maps and a state in float at least; the photographs, nine channels, are not in it.
      QVERIFY2(bytes.back() > 0.8 * 24.0 * pixels, std::to_string(bytes.back() / pixels).c_str());
      QVERIFY2(bytes.back() < 80.0 * pixels + 4e7, std::to_string(bytes.back() / pixels).c_str());
    }
    QCOMPARE(bytes.size(), std::size_t{2});
    QVERIFY(bytes[1] > bytes[0]);
  }

  void theGoalsAreJudged() {
    std::vector<std::string> keys;
    for (const auto& goal : report_["goals"]) {
      keys.push_back(goal["goal"]);
      const double reached = goal["reached"];
      const bool met = (!goal.contains("least") || reached >= goal["least"].get<double>()) &&
                       (!goal.contains("most") || reached <= goal["most"].get<double>());
      QCOMPARE(goal["met"].get<bool>(), met);
      QVERIFY(outcome_.output.find(goal["what"].get<std::string>()) != std::string::npos);
    }
    for (const char* key :
         {"refined_seconds", "first_picture_seconds", "over_bound_population", "over_bound_wide",
          "exact_visible_mse", "exact_seconds", "coverage_measured_wide", "coverage_elsewhere_wide",
          "coverage_measured_population", "coverage_elsewhere_population", "speed_ratio",
          "three_stage_microseconds", "full_search_microseconds", "network_visible_mse",
          "spectra_network_visible_mse", "network_seconds"}) {
      QVERIFY2(std::find(keys.begin(), keys.end(), key) != keys.end(), key);
    }
    // Only smaller pictures were run.
    QVERIFY(outcome_.output.find("scaled from 1024²") != std::string::npos);
  }

  // Networks of all channels, the paper's five and white light alone, at each noise; the paper's
  // protocol has none and comes first.
  void networksAreJudged() {
    std::vector<int> channels;
    for (const auto& row : report_["networks"])
      channels.push_back(row["channels"].get<int>());
    QVERIFY(channels == std::vector<int>({9, 5, 3}));
    for (const auto& row : report_["networks"]) {
      QCOMPARE(row["errors"].size(), kNoises);
      // What the shipped networks are known to reach, with room for 200 people by chance.
      QVERIFY(row["spectra_network"]["visible_mse"].get<double>() < 2e-7);
      QVERIFY(row["errors"][0]["encode_decode_visible_mse"].get<double>() < 1e-5);
      QVERIFY(row["encode_seconds"].get<double>() < row["encode_decode_seconds"].get<double>());
    }
    // ChromNN and the skin model, once as networks and once as a method of fitting.
    for (std::size_t i = 0; i < kNoises; ++i) {
      const double once = report_["networks"][0]["errors"][i]["encode_visible_mse"];
      const double again = errorsOf("network")[i];
      QVERIFY2(std::abs(once - again) < 1e-6 * again, std::to_string(again).c_str());
    }
  }

  // Another start changes the way, not the answer.
  void startsLeadToTheSameErrors() {
    QVERIFY(report_["starts"].size() == 3);
    const double own = report_["starts"][0]["visible_mse"];
    for (const auto& row : report_["starts"])
      QVERIFY(std::abs(row["visible_mse"].get<double>() - own) < 0.05 * own);
  }

  void coverageIsPooled() {
    for (const auto& row : report_["coverage"]) {
      double pixels = 0.0, inside = 0.0;
      for (const auto& count : row["elsewhere"]) {
        pixels += count["pixels"].get<double>();
        inside += count["inside"].get<double>();
      }
      QVERIFY(pixels > 0.0);
      QCOMPARE(row["elsewhere_share"].get<double>(), inside / pixels);
    }
  }

  void tablesAppearInTheirOrder() {
    std::size_t from = 0;
    for (const char* heading :
         {"cutis-cli " CUTIS_VERSION " bench --quick", "What the paper published", "Bayesian",
          "Networks, vis MSE", "SpectraNN by itself", "drawn from the protocol's population",
          "errors of parameters", "by skin tone", "pixels of the sample",
          "two posterior deviations", "White light alone", "Carotene held at 0",
          "refined fit begins", "Kinds of input", "pictures by size", "pictures by threads",
          "What was to be reached"}) {
      const auto found = outcome_.output.find(heading, from);
      QVERIFY2(found != std::string::npos, heading);
      from = found;
    }
  }

  // The first tables do not wait for the end.
  void firstTablesAppearAtOnce() {
    const auto process = run_.start("bench --quick");
    QVERIFY(process->waitForStarted());
    QByteArray printed;
    while (!printed.contains("Bayesian") && process->waitForReadyRead(60000))
      printed += process->readAllStandardOutput();
    QVERIFY(printed.contains("Bayesian"));
    QCOMPARE(process->state(), QProcess::Running);
    // What draws is loaded by who asks for a plot alone: it would cost every start of the program.
    std::ifstream maps("/proc/" + std::to_string(process->processId()) + "/maps");
    for (std::string line; std::getline(maps, line);)
      QVERIFY2(line.find("Qt6Gui") == std::string::npos, line.c_str());
    process->kill();
    process->waitForFinished();
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
    for (const char* part :
         {"refined, wide prior", "refined, exact", "paper: network", "Bayesian", "own population",
          "full search, exhaustive (scaled)", "Memory, MB", "threads"})
      QVERIFY2(plot.find(part) != std::string::npos, part);
  }

  void thePlotIsWellFormed() {
    QXmlStreamReader reader(QByteArray::fromStdString(run_.read("bench.svg")));
    while (!reader.atEnd())
      reader.readNext();
    QVERIFY2(!reader.hasError(), qPrintable(reader.errorString()));
  }

  void errorsAreToldBeforeAnyWork_data() {
    QTest::addColumn<QString>("options");
    QTest::addColumn<int>("status");
    QTest::addColumn<QString>("part");
    QTest::newRow("folder") << "--report none/bench.json" << 4 << "none";
    QTest::newRow("plot") << "--plot none/bench.svg" << 4 << "none";
    QTest::newRow("picture") << "--plot bench.pdf" << 2 << "name the file with .svg or .png";
    QTest::newRow("no ending") << "--plot bench" << 2 << "name the file with .svg or .png";
    QTest::newRow("png folder") << "--plot none/bench.png" << 4 << "none";
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
    EXPECT_REFUSED(outcome, status, part.toStdString());
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
