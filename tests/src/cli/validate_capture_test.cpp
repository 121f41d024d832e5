// validate --capture: the table and the plot, what threads and seeds do to them, and what is
// refused.

#include <cmath>
#include <map>

#include <QXmlStreamReader>

#include "core/base/number_text.h"
#include "src/files/io/csv.h"
#include "tests/src/cli/program_run.h"
#include "tests/src/cli/refusal.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis::test {
namespace {

constexpr int kCaptured = 18;

std::string capturedSets(int count) {
  std::string text = "melanin,melanin_blend,haemoglobin_dermal,haemoglobin_epidermal,carotene\n";
  for (int i = 0; i < count; ++i) {
    const double a = 0.5 + 0.5 * std::sin(1.0 + 2.0 * i), b = 0.5 + 0.5 * std::sin(2.0 + 3.0 * i);
    for (const double value : {0.01 + 0.2 * a, 0.2 + 0.6 * b, 0.005 + 0.05 * (1.0 - b),
                               0.005 + 0.02 * a * b, 0.003 * (1.0 - a)})
      text += formatNumber(value, 4) + ",";
    text.back() = '\n';
  }
  return text;
}

// "name,scheme,range" → the four figures.
std::map<std::string, std::vector<double>> figuresIn(const std::string& csv) {
  std::map<std::string, std::vector<double>> figures;
  const auto rows = splitCsv(csv);
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const auto fields = rows[i].fields;
    auto& row = figures[std::string(fields[0]) + "," + std::string(fields[1]) + "," +
                        std::string(fields[2])];
    for (std::size_t k = 3; k < fields.size(); ++k)
      row.push_back(parseNumber(fields[k]).value_or(NAN));
  }
  return figures;
}

class ValidateCaptureTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    run_.write("sets.csv", capturedSets(kCaptured));
    run_.write("few.csv", capturedSets(9));
    EXPECT_DONE(run_.run("spectrum --csv sets.csv --profile li2024 -o skin.csv"));
    EXPECT_DONE(run_.run("spectrum --csv few.csv --profile li2024 -o nine.csv"));
    std::filesystem::create_directory(run_ / "other");
    run_.write("other/skin.csv", run_.read("skin.csv"));
    run_.write("little.csv", "id,420,460,500,540,580,620\na,.2,.22,.25,.24,.26,.4\n");
    run_.write("black.csv", "id,400,460,500,540,580,700\na,.2,.22,.01,.24,.26,.4\n");
  }

  void tableAndPlotHaveEveryRow() {
    const Outcome outcome = run_.run(
        "validate skin.csv --capture monitor --noise 0.005 --profile li2024 --halvings 1 "
        "-o table.csv --plot errors.svg");
    EXPECT_DONE(outcome);
    const std::string csv = run_.read("table.csv");
    QVERIFY(csv.starts_with("name,scheme,range,median,p95,worst,coverage\n"));
    const auto figures = figuresIn(csv);
    // Four results of three ranges, all people and three thirds.
    QCOMPARE(figures.size(), std::size_t{48});
    for (const char* range : {"400-700", "320-400", "700-1000"}) {
      for (const char* name : {"refined,as-shipped", "refined,people-left-out",
                               "wiener,people-left-out", "wiener2,people-left-out"}) {
        for (const char* tone : {"", " dark", " middle", " light"}) {
          const auto row = figures.find(std::string(name) + tone + "," + range);
          QVERIFY2(row != figures.end(), name);
          const std::vector<double>& values = row->second;
          QVERIFY(values[0] >= 0.0 && values[0] <= values[1] && values[1] <= values[2]);
          const bool isRefined = std::string(name).starts_with("refined");
          QCOMPARE(std::isnan(values[3]), !isRefined);
          if (isRefined) QVERIFY(values[3] >= 0.0 && values[3] <= 1.0);
        }
      }
    }
    // The profile's own skin.
    EXPECT_AT_MOST(figures.at("refined,as-shipped,400-700")[0], 0.005);
    for (const char* words : {"under the rig monitor, 0.5 % of noise, spectra as they are",
                              "skin.csv: 18 people, 300-1000 nm", "wiener2", "people-left-out"})
      QVERIFY2(outcome.output.find(words) != std::string::npos, outcome.output.c_str());
    QXmlStreamReader reader(QString::fromStdString(run_.read("errors.svg")));
    int curves = 0;
    while (!reader.atEnd()) {
      reader.readNext();
      if (reader.isStartElement() && reader.name() == QLatin1String("polyline")) ++curves;
    }
    QVERIFY2(!reader.hasError(), qPrintable(reader.errorString()));
    QVERIFY2(curves >= 4, std::to_string(curves).c_str());
  }

  void threadsChangeNothingAndSeedsDo() {
    const QString line =
        "validate nine.csv --capture monitor --noise 0.01 --profile li2024 --halvings 0 ";
    const auto outcomes =
        run_.runAll({line + "-o one.csv --threads 1", line + "-o two.csv --threads 2",
                     line + "-o other.csv --seed 2"});
    for (const Outcome& outcome : outcomes)
      EXPECT_DONE(outcome);
    QVERIFY(run_.read("one.csv") == run_.read("two.csv"));
    QVERIFY(run_.read("one.csv") != run_.read("other.csv"));
    QVERIFY(run_.read("one.csv").find("people-left-out") == std::string::npos);
  }

  void partsAreLeftOut() {
    const Outcome outcome = run_.run(
        "validate skin.csv --capture albedo --profile li2024 --halvings 0 --folds 3 -o parts.csv "
        "--plot parts.svg");
    EXPECT_DONE(outcome);
    const auto figures = figuresIn(run_.read("parts.csv"));
    for (const char* key : {"refined,fold-left-out,400-700", "wiener,fold-left-out,700-1000",
                            "wiener2,fold-left-out dark,320-400"})
      QVERIFY2(figures.contains(key), key);
    for (const auto& [key, values] : figures)
      QVERIFY2(key.find("people-left-out") == std::string::npos, key.c_str());
    QVERIFY2(outcome.output.find("the people in 3 random parts") != std::string::npos,
             outcome.output.c_str());
    QVERIFY(run_.read("parts.svg").find("learned from all but a few of the people") !=
            std::string::npos);
  }

  // A colour alone, in the exact setting; files are judged by each other.
  void filesAreLeftOut() {
    const Outcome outcome = run_.run(
        "validate skin.csv nine.csv --capture albedo --profile li2024 --halvings 0 -o "
        "sets.csv.csv");
    EXPECT_DONE(outcome);
    const auto figures = figuresIn(run_.read("sets.csv.csv"));
    for (const char* key : {"refined,as-shipped skin,400-700", "refined,as-shipped nine,400-700",
                            "refined,set-left-out skin from nine,400-700",
                            "wiener,set-left-out nine from skin,700-1000"})
      QVERIFY2(figures.contains(key), key);
  }

  void theSurfaceIsTakenOff() {
    EXPECT_DONE(
        run_.run("spectrum --csv few.csv --profile li2024 -o shiny.csv --specular included"));
    const QString line = " --capture monitor --profile li2024 --halvings 0 -o off.csv";
    const auto median = [&](const QString& words) {
      const Outcome outcome = run_.run("validate " + words + line);
      return outcome.status == 0
                 ? figuresIn(run_.read("off.csv")).at("refined,as-shipped,400-700")[0]
                 : NAN;
    };
    EXPECT_AT_MOST(median("nine.csv"), 1e-3);
    EXPECT_AT_MOST(median("nine.csv --specular excluded"), 1e-3);
    EXPECT_AT_MOST(median("shiny.csv --specular included"), 1e-3);
    QVERIFY(median("shiny.csv") > 1e-3);
  }

  void wrongInputIsTold_data() {
    QTest::addColumn<QString>("line");
    QTest::addColumn<int>("status");
    QTest::addColumn<QString>("part");
    const QString good = "validate skin.csv --profile li2024 --capture monitor ";
    QTest::newRow("no rig") << "validate skin.csv --profile li2024 --capture monitr" << 3
                            << "did you mean 'monitor'?";
    QTest::newRow("too narrow") << "validate little.csv --profile li2024 --capture monitor" << 3
                                << "little.csv: a photograph takes spectra from 400 to 700 nm, "
                                   "measured are 420 to 620 nm";
    QTest::newRow("too few") << "validate nine.csv --profile li2024 --capture monitor" << 3
                             << "nine.csv: too few people for halves: 9 where at least 16";
    QTest::newRow("too few of one")
        << "validate skin.csv black.csv --profile li2024 --capture monitor --halvings 0" << 3
        << "black.csv: too few people to learn from: 1";
    QTest::newRow("much noise") << good + "--noise 0.5" << 2 << "--noise";
    QTest::newRow("negative noise") << good + "--noise=-0.1" << 2 << "--noise";
    QTest::newRow("halvings") << good + "--halvings 1.5" << 2 << "--halvings";
    QTest::newRow("one part") << good + "--folds 1" << 2 << "--folds";
    QTest::newRow("too few for parts")
        << "validate nine.csv --profile li2024 --capture monitor --halvings 0 --folds 2" << 3
        << "nine.csv: too few people for 2 parts";
    QTest::newRow("more parts than people")
        << good + "--halvings 0 --folds 19" << 3 << "skin.csv: too few people for 19 parts";
    QTest::newRow("parts without a capture")
        << "validate skin.csv --folds 3" << 2 << "--folds: this goes with --capture";
    QTest::newRow("aperture") << good + "--aperture-radius 4" << 2 << "--aperture-radius";
    QTest::newRow("same names") << good + "other/skin.csv" << 2 << "two files are called the same";
    QTest::newRow("darker than the surface")
        << "validate black.csv --profile li2024 --capture monitor --halvings 0 --specular included"
        << 3 << "black.csv: the spectrum 'a' at 500 nm is 0.01";
    QTest::newRow("over its input") << good + "-o skin.csv" << 2 << "sources are never written to";
    QTest::newRow("one file twice") << good + "-o a.svg --plot a.svg" << 2 << "a.svg";
    QTest::newRow("no plot") << good + "--plot a.jpg" << 2 << "a.jpg";
    QTest::newRow("no capture") << "validate skin.csv -o a.csv" << 2 << "-o: this goes with";
    QTest::newRow("no capture's noise")
        << "validate skin.csv --noise 0.1" << 2 << "--noise: this goes with --capture";
  }
  void wrongInputIsTold() {
    QFETCH(QString, line);
    QFETCH(int, status);
    QFETCH(QString, part);
    const auto before = run_.contents();
    const Outcome outcome = run_.run(line);
    EXPECT_REFUSED(outcome, status, part.toStdString());
    QVERIFY(run_.contents() == before);
  }

 private:
  ProgramRun run_;
};

CUTIS_TEST(ValidateCaptureTest)

}  // namespace
}  // namespace cutis::test

#include "validate_capture_test.moc"
