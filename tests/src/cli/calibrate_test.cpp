// calibrate-profile: the constants and the prior that made spectra are found, with intervals and
// figures, the same for any number of cores; wrong input is reported.

#include <QtTest>

#include "src/files/profiles/profile_file.h"
#include "tests/src/cli/program_run.h"
#include "tests/src/cli/refusal.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis::test {
namespace {

// The spectra below are of a skin with an epidermis of 0.36 mm.
constexpr char kRecipe[] = R"({
  "cutis_calibration": 1, "name": "mine", "description": "Mine.", "start": "START.json",
  "step_nm": 10, "pull": 0.0001,
  "spectra": [{"name": "a", "specular": "included", "specular_share": 0.05,
               "aims": [{"from_nm": 400, "to_nm": 700, "rms": 0.005},
                        {"from_nm": 320, "to_nm": 400, "rms": 0.012}]}],
  "prior": {"spectra": "a", "noise": 0.002},
  "constants": [{"field": "epidermis.thickness_mm", "low": 0.3, "high": 0.6, "expected": 0.4,
                 "sd": 0.5, "scale": "log", "note": "Thick."},
                {"field": "specular_share", "spectra": "a", "low": 0, "high": 0.1,
                 "expected": 0.04, "sd": 0.05}]
})";

constexpr char kLearnedRecipe[] = R"({
  "cutis_calibration": 1, "name": "ours", "start": "li2024",
  "spectra": [{"name": "us", "specular": "included"}], "discrepancy": {"components": 3}
})";

std::string parametersOfPeople() {
  std::string text = "melanin,melanin_blend,haemoglobin_dermal,haemoglobin_epidermal,carotene\n";
  for (int i = 0; i < 16; ++i) {
    const double share = (i + 0.5) / 16.0;
    const double other = (i * 7 % 16 + 0.5) / 16.0;
    text += std::to_string(0.01 + 0.2 * share) + "," + std::to_string(0.3 + 0.6 * other) + "," +
            std::to_string(0.01 + 0.06 * (1.0 - other)) + "," +
            std::to_string(0.01 + 0.03 * share) + "," + std::to_string(0.0005 + 0.002 * other) +
            "\n";
  }
  return text;
}

std::string withThickness(const std::string& thickness) {
  std::string text = profileText("li2024", "").value();
  const std::string field = "\"thickness_mm\": ";
  const auto at = text.find(field) + field.size();
  return text.replace(at, text.find(',', at) - at, thickness);
}

class CalibrateTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    run_.write("sets.csv", parametersOfPeople());
    run_.write("truth.json", withThickness("0.36"));
    run_.write("START.json", withThickness("0.45"));
    run_.write("recipe.json", kRecipe);
    run_.write("learned.json", kLearnedRecipe);
    EXPECT_DONE(
        run_.run("spectrum --csv sets.csv --profile truth.json -o skin.csv --specular "
                 "included --specular-share 0.03"));
  }

  void theThicknessIsFound() {
    const Outcome outcome =
        run_.run("calibrate-profile recipe.json skin.csv -o made.json --halvings 1 --bootstraps 3");
    EXPECT_DONE(outcome);
    for (const char* part :
         {"epidermis.thickness_mm", "a specular_share", "left out", "400-700 nm"}) {
      QVERIFY2(outcome.output.find(part) != std::string::npos, outcome.output.c_str());
    }
    const auto made = loadProfile((run_ / "made.json").string(), "made");
    QVERIFY2(bool(made), made.failed() ? made.error().text().c_str() : "");
    EXPECT_NEAR(made.value().epidermalThicknessMm, 0.36, 0.007);
    QCOMPARE(made.value().name, std::string("mine"));
    QVERIFY(made.value().description.starts_with("Mine. Mean RMSE on halves left out: a 400-700"));
    const std::string text = run_.read("made.json");
    QVERIFY(text.find("\"epidermis.thickness_mm\": \"Calibrated: 0.") != std::string::npos);
    // The prior is that of the spectra.
    const Profile before = loadProfile("li2024", "").value();
    QVERIFY(made.value().prior.deviation[kMelanin] < before.prior.deviation[kMelanin]);
    EXPECT_NEAR(made.value().prior.mean[kMelanin], 0.09, 0.03);
    EXPECT_DONE(run_.run("validate skin.csv --profile made.json --specular included"));
  }

  void anyNumberOfCoresMakesTheSame() {
    const std::string options = " skin.csv --halvings 1 --bootstraps 1 --threads ";
    const auto outcomes = run_.runAll(
        {QString::fromStdString("calibrate-profile recipe.json -o one.json" + options + "1"),
         QString::fromStdString("calibrate-profile recipe.json -o two.json" + options + "2")});
    for (const Outcome& outcome : outcomes)
      EXPECT_DONE(outcome);
    QVERIFY(run_.read("one.json") == run_.read("two.json"));
    QVERIFY(outcomes[0].output == outcomes[1].output);
  }

  void withoutRepetitionsThereAreNoIntervals() {
    EXPECT_DONE(run_.run(
        "calibrate-profile recipe.json skin.csv -o bare.json --halvings 0 --bootstraps 0"));
    const std::string text = run_.read("bare.json");
    QVERIFY(text.find("\"Calibrated. Thick.\"") != std::string::npos);
    QVERIFY(text.find("left out") == std::string::npos);
  }

  // All constants are kept, and it says what that gains.
  void aDiscrepancyIsLearned() {
    const std::string options = " skin.csv --halvings 1 --threads ";
    const auto outcomes = run_.runAll(
        {QString::fromStdString("calibrate-profile learned.json -o first.json" + options + "1"),
         QString::fromStdString("calibrate-profile learned.json -o second.json" + options + "2")});
    for (const Outcome& outcome : outcomes)
      EXPECT_DONE(outcome);
    QVERIFY(run_.read("first.json") == run_.read("second.json"));
    QVERIFY(outcomes[0].output == outcomes[1].output);
    for (const char* part : {"people left out", "without", "with", "monitor, no noise",
                             "monitor, 0.5 % noise", "400-700 nm", "700-1000 nm"}) {
      QVERIFY2(outcomes[0].output.find(part) != std::string::npos, outcomes[0].output.c_str());
    }
    const auto made = loadProfile((run_ / "first.json").string(), "made");
    QVERIFY2(bool(made), made.failed() ? made.error().text().c_str() : "");
    QCOMPARE(made.value().name, std::string("ours"));
    QCOMPARE(made.value().discrepancies.surfaceIncluded->count(), 3);
    QCOMPARE(made.value().discrepancies.surfaceRemoved->count(), 3);
    QCOMPARE(made.value().epidermalThicknessMm,
             loadProfile("li2024", "").value().epidermalThicknessMm);
    QVERIFY(run_.read("first.json").find("Learned from 16 spectra of us.") != std::string::npos);
  }

  void wrongInputIsTold_data() {
    QTest::addColumn<QString>("line");
    QTest::addColumn<int>("status");
    QTest::addColumn<QString>("part");
    run_.write("short.csv",
               "id,400,420,440,460,480,500,700\na,.1,.1,.1,.2,.2,.2,.3\nb,.1,.1,.1,.2,.2,.2,.3\n"
               "c,.1,.1,.1,.2,.2,.2,.3\nd,.1,.1,.1,.2,.2,.2,.3\n");
    std::string eight = "id,400,420,440,460,480,500,700\n";
    for (int i = 0; i < 8; ++i)
      eight += "a,.1,.1,.1,.2,.2,.2,.3\n";
    run_.write("eight.csv", eight);
    run_.write("black.csv", QString::fromStdString(eight)
                                .replace("a,.1,.1,.1,.2,.2,.2,.3\na,.1,.1,.1",
                                         "a,.1,.1,.1,.2,.2,.2,.3\na,.1,.1,0")
                                .toStdString());
    run_.write("violet.csv", QString::fromStdString(eight).replace("700", "690").toStdString());
    run_.write("few.csv", "id,300,400,440,460,480,500,700\na,.1,.1,.1,.2,.2,.2,.3\n");
    run_.write("nofield.json", QString(kRecipe).replace("thickness_mm", "depth_mm").toStdString());
    const char* line = "calibrate-profile %1 -o %2";
    const auto row = [&](const char* name, const char* inputs, const char* output, int status,
                         const char* part) {
      QTest::newRow(name) << QString(line).arg(inputs, output) << status << part;
    };
    row("no recipe", "none.json skin.csv", "x.json", 3, "none.json");
    row("unknown recipe", "skin2062 skin.csv", "x.json", 3, "skin2026");
    row("no such field", "nofield.json skin.csv", "x.json", 3, "epidermis.depth_mm");
    row("too many files", "recipe.json skin.csv skin.csv", "x.json", 2,
        "takes 1 file, given were 2");
    row("no file", "recipe.json none.csv", "x.json", 3, "none.csv");
    row("range", "recipe.json short.csv", "x.json", 3, "320 to 700 nm");
    row("constants kept", "learned.json skin.csv --bootstraps 3", "x.json", 2, "--bootstraps");
    row("few to halve", "learned.json eight.csv", "x.json", 3, "--halvings 0");
    row("few to learn from", "learned.json short.csv --halvings 0", "x.json", 3,
        "short.csv: too few people to learn from: 4");
    row("not positive", "learned.json black.csv --halvings 0", "x.json", 3,
        "black.csv: spectrum 2 has a reflectance that is not positive at 440 nm");
    row("too short", "learned.json violet.csv", "x.json", 3, "400 to 700 nm");
    row("few", "recipe.json few.csv", "x.json", 3, "too few spectra: 1");
    row("over an input", "recipe.json skin.csv", "skin.csv", 2, "skin.csv");
    row("no folder", "recipe.json skin.csv", "none/x.json", 4, "none");
    row("halvings", "recipe.json skin.csv --halvings x", "x.json", 2, "--halvings");
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

CUTIS_TEST(CalibrateTest)

}  // namespace
}  // namespace cutis::test

#include "calibrate_test.moc"
