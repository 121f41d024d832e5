#include <cmath>
#include <limits>
#include <string>

#include <QtTest>

#include "core/simulate/skin_patch.h"
#include "src/files/recipe_file.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

Result<RecipeFile> parseSkin(const std::string& skin) {
  return parseRecipe("{\"cutis_recipe\": 1, \"skin\": " + skin + "}", "test.json");
}

class SkinRecipeTest : public QObject {
  Q_OBJECT

 private slots:
  void theSampleIsTheDefault() {
    const auto sample = loadRecipe(kSampleRecipe, "--recipe");
    EXPECT_OK(sample);
    QVERIFY(sample.value().skin == SkinRecipe());
    QCOMPARE(sample.value().width, 1024);
    QCOMPARE(sample.value().height, 1024);
    QCOMPARE(sample.value().seed, std::uint64_t{1});
  }

  void theDefaultIsValid() { EXPECT_OK(validate(SkinRecipe(), "default")); }

  void fieldsLeftOutKeepTheSamples() {
    const auto recipe = parseSkin(R"({"warp": 0.01, "lips": {"half_width": 0.1}})");
    EXPECT_OK(recipe);
    SkinRecipe expected;
    expected.warp = 0.01;
    expected.lips.halfWidth = 0.1;
    QVERIFY(recipe.value().skin == expected);
  }

  void listsReplaceTheSamples() {
    const auto recipe = parseSkin(R"({"moles": [{"x": 0.25, "melanin": 0.3}], "veins": []})");
    EXPECT_OK(recipe);
    QCOMPARE(recipe.value().skin.moles.size(), std::size_t{1});
    QCOMPARE(recipe.value().skin.moles[0].x, 0.25);
    QCOMPARE(recipe.value().skin.moles[0].radius, MoleRecipe().radius);
    QVERIFY(recipe.value().skin.veins.empty());
  }

  void brokenRecipesAreToldWhere_data() {
    QTest::addColumn<QString>("skin");
    QTest::addColumn<QString>("sentence");
    QTest::newRow("unknown field") << R"({"lips": {"colour": 1}})"
                                   << "test.json: unknown field 'skin.lips.colour'; known here: x";
    QTest::newRow("not a number") << R"({"pores": {"radius": "small"}})"
                                  << "test.json: skin.pores.radius must be a finite number";
    QTest::newRow("not an object") << R"({"tones": [3]})"
                                   << "test.json: skin.tones[0] must be an object";
    QTest::newRow("parameter") << R"({"tones": [{"parameters": {"melanin": 2}}]})"
                               << "test.json: skin.tones[0].parameters.melanin must be between 0 "
                                  "and 1";
    QTest::newRow("no tone") << R"({"tones": []})"
                             << "test.json: skin.tones is empty";
    QTest::newRow("too fine") << R"({"stubble": {"spacing": 0.00001}})"
                              << "test.json: skin.stubble.spacing must be between 0.002 and 1";
    QTest::newRow("endless vein") << R"({"veins": [{"length": 9}]})"
                                  << "test.json: skin.veins[0].length must be between 0 and 1";
    QTest::newRow("octaves") << R"({"noise": {"carotene": {"octaves": 2.5}}})"
                             << "test.json: skin.noise.carotene.octaves must be a whole number";
    QTest::newRow("area") << R"({"stubble": {"areas": [{"radius_x": 0}]}})"
                          << "test.json: skin.stubble.areas[0].radius_x must be between";
  }
  void brokenRecipesAreToldWhere() {
    QFETCH(QString, skin);
    QFETCH(QString, sentence);
    const auto recipe = parseSkin(skin.toStdString());
    QVERIFY(recipe.failed());
    const QString text = QString::fromStdString(recipe.error().text());
    QVERIFY2(text.startsWith(sentence), qPrintable(text));
  }

  void otherFilesAndNewerVersionsAreRefused() {
    EXPECT_ERROR(parseRecipe("{\"cutis_rig\": 1}", "rig.json"), "\"cutis_recipe\": 1 is missing");
    EXPECT_ERROR(parseRecipe("{\"cutis_recipe\": 2}", "new.json"), "newer version of Cutis");
    for (const char* width : {"0", "-5", "8193", "2000000000"}) {
      EXPECT_ERROR(
          parseRecipe(std::string("{\"cutis_recipe\": 1, \"skin\": {}, \"width\": ") + width + "}",
                      "w.json"),
          "w.json: width must be between 1 and 8192");
    }
    EXPECT_ERROR(parseRecipe("{\"cutis_recipe\": 1,\n oops}", "bad.json"), "bad.json:2:");
    EXPECT_ERROR(parseRecipe("{\"cutis_recipe\": 1}", "empty.json"), "skin must be an object");
    EXPECT_ERROR(loadRecipe("smaple", "--recipe"), "--recipe: unknown recipe 'smaple'");
  }

  void simulatingChecksItsRecipe() {
    SkinRecipe recipe;
    recipe.warp = std::numeric_limits<double>::quiet_NaN();
    EXPECT_ERROR(simulateSkin(recipe, 8, 8, 1, test::li2024().profile().axes, nullptr, {}),
                 "skin.warp must be between 0 and 1");
  }
};

CUTIS_TEST(SkinRecipeTest)

}  // namespace
}  // namespace cutis

#include "skin_recipe_test.moc"
