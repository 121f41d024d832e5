#include "src/files/profiles/calibration_file.h"

#include <cmath>

#include <QtTest>

#include "src/files/profiles/profile_edit.h"
#include "src/files/profiles/profile_file.h"
#include "src/files/resources.h"
#include "tests/support/expect.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

constexpr char kRecipe[] = R"({
  "cutis_calibration": 1, "name": "mine", "start": "li2024", "step_nm": 10, "pull": 0.1,
  "spectra": [{"name": "a", "specular": "included", "specular_share": 0.03,
               "aperture_radius_mm": 4, "aims": [{"from_nm": 400, "to_nm": 700, "rms": 0.01}]}],
  "prior": {"spectra": "a", "noise": 0.01},
  "constants": [{"field": "epidermis.thickness_mm", "low": 0.1, "high": 0.5, "expected": 0.2,
                 "sd": 0.3, "scale": "log", "note": "why"},
                {"field": "specular_share", "spectra": "a", "low": 0, "high": 0.1,
                 "expected": 0.04, "sd": 0.01}]
})";

constexpr char kLearnedRecipe[] = R"({
  "cutis_calibration": 1, "name": "mine", "start": "li2024",
  "spectra": [{"name": "a", "specular": "crossed"}], "discrepancy": {"components": 3}
})";

std::string changed(const std::string& from, const std::string& to,
                    const std::string& recipe = kRecipe) {
  std::string text = recipe;
  const auto at = text.find(from);
  if (at == std::string::npos) return "test is wrong: " + from;
  return text.replace(at, from.size(), to);
}

class CalibrationFileTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  // Whoever has the spectra can make the profile again.
  void builtInRecipesBeginFromProfilesThatHaveTheFields() {
    const auto names = resourceStems("calibrations", ".json");
    QVERIFY(!names.empty());
    for (const std::string& name : names) {
      const auto recipe = loadCalibrationRecipe(name, "RECIPE");
      QVERIFY2(bool(recipe), recipe.failed() ? recipe.error().text().c_str() : "");
      for (const CalibrationConstant& constant : recipe.value().constants) {
        if (constant.spectra) continue;
        const auto value = profileNumber(recipe.value().startText, constant.constant.name, name);
        QVERIFY2(bool(value), constant.constant.name.c_str());
        QVERIFY(value.value() >= constant.constant.low && value.value() <= constant.constant.high);
      }
    }
  }

  void everythingIsRead() {
    folder_.write("mine.json", kRecipe);
    const auto read = loadCalibrationRecipe((folder_ / "mine.json").string(), "RECIPE");
    QVERIFY2(bool(read), read.failed() ? read.error().text().c_str() : "");
    const CalibrationRecipe& recipe = read.value();
    QCOMPARE(recipe.name, std::string("mine"));
    QCOMPARE(recipe.spectra.size(), std::size_t{1});
    QVERIFY(recipe.spectra[0].specular == SpecularPart::included);
    EXPECT_NEAR(recipe.spectra[0].edgeLossPerMm, edgeLossOfAperture(4.0), 1e-12);
    QCOMPARE(recipe.spectra[0].aims[0].rms, 0.01);
    QCOMPARE(recipe.constants.size(), std::size_t{2});
    QVERIFY(recipe.constants[0].constant.isLog);
    QVERIFY(!recipe.constants[0].spectra);
    QCOMPARE(recipe.constants[0].note, std::string("why"));
    QCOMPARE(*recipe.constants[1].spectra, std::size_t{0});
    QCOMPARE(recipe.priorNoise, 0.01);
  }

  void aDiscrepancyKeepsAllConstants() {
    folder_.write("learned.json", kLearnedRecipe);
    const auto read = loadCalibrationRecipe((folder_ / "learned.json").string(), "RECIPE");
    QVERIFY2(bool(read), read.failed() ? read.error().text().c_str() : "");
    QVERIFY(read.value().learnsDiscrepancy());
    QCOMPARE(read.value().components, 3);
    QVERIFY(read.value().constants.empty());
    QVERIFY(read.value().spectra[0].specular == SpecularPart::crossPolarised);
  }

  void aStartBesideTheRecipeIsFound() {
    folder_.write("mine.json", changed("\"li2024\"", "\"start.json\""));
    const std::string path = (folder_ / "mine.json").string();
    QVERIFY(loadCalibrationRecipe(path, "RECIPE").error().text().find("start.json") !=
            std::string::npos);
    folder_.write("start.json", profileText("skin2026", "").value());
    const auto read = loadCalibrationRecipe(path, "RECIPE");
    QVERIFY(bool(read));
    QCOMPARE(parseProfile(read.value().startText, "start").value().name, std::string("skin2026"));
  }

  void wrongRecipesAreTold_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("part");
    const auto row = [](const char* name, const std::string& text, const char* part) {
      QTest::newRow(name) << QString::fromStdString(text) << part;
    };
    row("newer", changed(": 1, \"name\"", ": 2, \"name\""), "newer");
    row("misspelt", changed("\"pull\"", "\"pul\""), "pul");
    row("odd step", changed("\"step_nm\": 10", "\"step_nm\": 3"), "step_nm");
    row("no step", changed("\"step_nm\": 10", "\"step_nm\": 0"), "step_nm");
    row("negative pull", changed("\"pull\": 0.1", "\"pull\": -1"), "pull");
    row("specular", changed("\"included\"", "\"some\""), "spectra[0].specular");
    row("share", changed("\"specular_share\": 0.03", "\"specular_share\": 1"), "specular_share");
    row("radius", changed("\"aperture_radius_mm\": 4", "\"aperture_radius_mm\": 0"), "aperture");
    row("no aims", changed("[{\"from_nm\": 400, \"to_nm\": 700, \"rms\": 0.01}]", "[]"), "aims");
    row("aim backwards", changed("\"to_nm\": 700", "\"to_nm\": 300"), "to_nm");
    row("aim of nothing", changed("\"rms\": 0.01", "\"rms\": 0"), "rms");
    row("prior of nobody", changed("{\"spectra\": \"a\",", "{\"spectra\": \"b\","),
        "prior.spectra");
    row("same constant twice",
        changed("\"field\": \"specular_share\", \"spectra\": \"a\"",
                "\"field\": \"epidermis.thickness_mm\""),
        "constants[1].field");
    row("same spectra twice",
        changed("\"spectra\": [",
                "\"spectra\": [{\"name\": \"a\", \"specular\": \"excluded\", "
                "\"aims\": [{\"from_nm\": 400, \"to_nm\": 700, \"rms\": 1}]}, "),
        "spectra[1].name");
    row("no range", changed("\"high\": 0.5", "\"high\": 0.1"), "constants[0].high");
    row("no spread", changed("\"sd\": 0.3", "\"sd\": 0"), "constants[0].sd");
    row("scale", changed("\"log\"", "\"cubic\""), "constants[0].scale");
    row("log of nothing", changed("\"low\": 0.1", "\"low\": 0"), "constants[0].low");
    row("field of spectra", changed("\"field\": \"specular_share\"", "\"field\": \"gain\""),
        "constants[1].field");
    const auto learned = [&](const char* name, const char* from, const char* to, const char* part) {
      row(name, changed(from, to, kLearnedRecipe), part);
    };
    learned("no components", "3", "0", "discrepancy.components");
    learned("too many components", "3", "9", "discrepancy.components");
    learned("constants beside it", "\"start\"", "\"pull\": 1, \"start\"", "pull");
    learned("aims beside it", "\"crossed\"", "\"crossed\", \"aims\": []", "aims");
    learned("nobody", "{\"name\": \"a\", \"specular\": \"crossed\"}", "", "spectra");
  }
  void wrongRecipesAreTold() {
    QFETCH(QString, text);
    QFETCH(QString, part);
    folder_.write("wrong.json", text.toStdString());
    const auto read = loadCalibrationRecipe((folder_ / "wrong.json").string(), "RECIPE");
    QVERIFY(read.failed());
    const std::string error = read.error().text();
    QVERIFY2(error.find("wrong.json") != std::string::npos, error.c_str());
    QVERIFY2(error.find(part.toStdString()) != std::string::npos, error.c_str());
  }

  void unknownNamesAreTold() {
    const auto read = loadCalibrationRecipe("skin2062", "RECIPE");
    QVERIFY(read.failed());
    QVERIFY(read.error().text().find("skin2026") != std::string::npos);
  }

 private:
  test::ScratchFolder folder_;
};

CUTIS_TEST(CalibrationFileTest)

}  // namespace
}  // namespace cutis

#include "calibration_file_test.moc"
