// validate, and how spectra are measured: skin that a profile made is found again whatever the
// measurement, every profile and plot is there, wrong input is reported.

#include <algorithm>
#include <cmath>
#include <sstream>

#include <QXmlStreamReader>

#include "core/base/number_text.h"
#include "src/files/io/csv.h"
#include "src/files/profiles/profile_file.h"
#include "tests/src/cli/program_run.h"
#include "tests/src/cli/refusal.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis::test {
namespace {

constexpr char kMeasuredSets[] =
    "melanin,melanin_blend,haemoglobin_dermal,haemoglobin_epidermal,carotene\n"
    "0.01,0.5,0.01,0.005,0.0005\n"
    "0.02,0.4,0.02,0.01,0.001\n"
    "0.04,0.6,0.015,0.02,0.002\n"
    "0.08,0.7,0.03,0.01,0.001\n"
    "0.15,0.8,0.02,0.02,0.002\n"
    "0.25,0.9,0.05,0.03,0.003\n";
constexpr std::size_t kPeople = 6;
constexpr std::size_t kColumns = 9;

// The numbers of a profile's row; empty if there is none.
std::vector<double> rowOf(const std::string& table, const std::string& profile) {
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word != profile) continue;
    std::vector<double> row;
    while (words >> word)
      row.push_back(parseNumber(word).value_or(NAN));
    return row;
  }
  return {};
}

std::vector<double> numbersIn(const std::string& text, std::size_t line) {
  std::vector<double> numbers;
  const auto rows = splitCsv(text);
  for (const std::string_view field : rows[line].fields)
    numbers.push_back(parseNumber(field).value_or(NAN));
  return numbers;
}

class ValidateTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    run_.write("sets.csv", kMeasuredSets);
    for (const char* line :
         {"spectrum --csv sets.csv --profile li2024 -o skin.csv",
          "spectrum --csv sets.csv --profile li2024 -o shiny.csv --specular included",
          "spectrum --csv sets.csv --profile li2024 -o spot.csv --specular included "
          "--specular-share 0.05 --aperture-radius 4"}) {
      EXPECT_DONE(run_.run(line));
    }
  }

  // resources/manual/model.md: the refractive index of li2024 is 1.4.
  void theSurfaceReflectionIsAdded() {
    const auto skin = numbersIn(run_.read("skin.csv"), 2);
    const auto shiny = numbersIn(run_.read("shiny.csv"), 2);
    const auto spot = numbersIn(run_.read("spot.csv"), 2);
    const double entering = 1.0 - std::pow(0.4 / 2.4, 2);
    QCOMPARE(skin.size(), shiny.size());
    for (std::size_t i = 0; i < skin.size(); ++i) {
      EXPECT_NEAR(shiny[i], 0.04 + entering * skin[i], 1e-8);
      EXPECT_AT_MOST(spot[i], 0.05 + entering * skin[i] + 1e-8);
    }
    // Where skin absorbs little, much is lost sideways.
    constexpr std::size_t at700 = 200;
    EXPECT_AT_MOST(spot[at700], 0.04 + entering * skin[at700]);
  }

  void fittedSpectraAreToldWhetherItIsThere() {
    const auto worst = [&](const std::string& options) {
      const Outcome outcome =
          run_.run(QString::fromStdString("fit-spectra --profile li2024 " + options));
      double most = outcome.status == 0 ? 0.0 : NAN;
      for (std::size_t i = 1; i <= kPeople; ++i)
        most = std::max(most, numbersIn(run_.read("fits.csv"), i).back());
      return most;
    };
    EXPECT_AT_MOST(worst("shiny.csv -o fits.csv --specular included"), 1e-6);
    EXPECT_AT_MOST(worst("spot.csv -o fits.csv --specular included --specular-share 0.05 "
                         "--aperture-radius 4"),
                   1e-6);
    QVERIFY(worst("shiny.csv -o fits.csv") > 1e-3);
  }

  void ownSkinIsFoundAgain() {
    const std::vector<QString> lines = {
        "validate skin.csv --profile li2024",
        "validate shiny.csv --profile li2024 --specular included",
        "validate spot.csv --profile li2024 --specular included --specular-share 0.05 "
        "--aperture-radius 4"};
    for (const Outcome& outcome : run_.runAll(lines)) {
      EXPECT_DONE(outcome);
      const auto row = rowOf(outcome.output, "li2024");
      QCOMPARE(row.size(), kColumns - 1);
      for (std::size_t i = 0; i < 4; ++i)
        EXPECT_AT_MOST(row[i], 0.0);
      // What the visible leaves open of the parameters matters little beyond.
      EXPECT_AT_MOST(row[4], 1e-3);
      EXPECT_AT_MOST(row[5], 1e-3);
      // A colour is no spectrum.
      QVERIFY(row[6] > 0.0);
      EXPECT_AT_MOST(row[6], 0.03);
    }
  }

  void everyProfileHasRowAndPlot() {
    const Outcome outcome = run_.run("validate skin.csv shiny.csv --plot plots.svg");
    EXPECT_DONE(outcome);
    QVERIFY(outcome.output.find("skin.csv: 6 spectra, 300-1000 nm, surface reflection excluded") !=
            std::string::npos);
    QVERIFY(outcome.output.find("shiny.csv: 6 spectra") != std::string::npos);
    for (const std::string& profile : profileNames()) {
      const auto row = rowOf(outcome.output, profile);
      QCOMPARE(row.size(), kColumns - 1);
      QVERIFY(std::all_of(row.begin(), row.end(), [](double value) { return value >= 0.0; }));
      for (const char* data : {"skin", "shiny"}) {
        const std::string name = std::string("plots_") + data + "_" + profile + ".svg";
        QXmlStreamReader reader(QString::fromStdString(run_.read(name)));
        int areas = 0;
        while (!reader.atEnd()) {
          reader.readNext();
          if (reader.isStartElement() && reader.name() == QLatin1String("polygon")) ++areas;
        }
        QVERIFY2(!reader.hasError(), qPrintable(reader.errorString()));
        QCOMPARE(areas, 3);
      }
    }
  }

  // Plots are drawn on a machine that has neither a display nor fonts.
  void severalPlotsAreDrawnAsPng() {
    const QByteArray fonts = qgetenv("FONTCONFIG_FILE"), platform = qgetenv("QT_QPA_PLATFORM");
    run_.write("fonts.conf", "<?xml version=\"1.0\"?>\n<fontconfig></fontconfig>\n");
    qputenv("FONTCONFIG_FILE", QByteArray::fromStdString((run_ / "fonts.conf").string()));
    qunsetenv("QT_QPA_PLATFORM");
    const Outcome outcome = run_.run("validate skin.csv shiny.csv --profile li2024 --plot p.png");
    qputenv("FONTCONFIG_FILE", fonts);
    if (fonts.isNull()) qunsetenv("FONTCONFIG_FILE");
    qputenv("QT_QPA_PLATFORM", platform);
    EXPECT_DONE(outcome);
    for (const char* name : {"p_skin_li2024.png", "p_shiny_li2024.png"}) {
      const Image image = run_.image(name);
      const auto values = valuesOf(image.channels.front());
      const auto dark =
          std::count_if(values.begin(), values.end(), [](float v) { return v < 0.3f; });
      // Words and lines are there, and most is ground.
      QVERIFY2(dark > 2000 && dark < 300000, std::to_string(dark).c_str());
    }
  }

  // Neither ultraviolet nor infrared nor a colour, and fewer spectra than thirds.
  void littleIsEnough() {
    run_.write("little.csv", "id,420,460,500,540,580,620\na,.2,.22,.25,.24,.26,.4\n");
    const Outcome outcome = run_.run("validate little.csv --profile li2024 --plot l.svg");
    EXPECT_DONE(outcome);
    QVERIFY(outcome.output.find("1 spectrum, 420-620 nm") != std::string::npos);
    const auto row = rowOf(outcome.output, "li2024");
    QCOMPARE(row.size(), kColumns - 1);
    for (std::size_t i = 0; i < row.size(); ++i)
      QCOMPARE(std::isnan(row[i]), i >= 4);
  }

  void wrongInputIsTold_data() {
    QTest::addColumn<QString>("line");
    QTest::addColumn<int>("status");
    QTest::addColumn<QString>("part");
    run_.write("infrared.csv", "id,420,460,710,720,730,740\na,.2,.22,.25,.24,.26,.4\n");
    std::filesystem::create_directory(run_ / "other");
    run_.write("other/skin.csv", run_.read("skin.csv"));
    QTest::newRow("too few") << "validate infrared.csv" << 3
                             << "infrared.csv: too few wavelengths lie from 400 to 700 nm: 2";
    QTest::newRow("no file") << "validate none.csv" << 3 << "none.csv: ";
    QTest::newRow("no profile") << "validate skin.csv --profile li2042" << 3 << "li2042";
    QTest::newRow("same names") << "validate skin.csv other/skin.csv --plot a.svg" << 2
                                << "two plots would have this name";
    QTest::newRow("no folder") << "validate skin.csv --plot none/a.svg" << 4 << "none";
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

CUTIS_TEST(ValidateTest)

}  // namespace
}  // namespace cutis::test

#include "validate_test.moc"
