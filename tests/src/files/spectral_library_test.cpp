#include "src/files/spectral_library.h"

#include <algorithm>

#include <QtTest>

#include "src/files/io/suggestion.h"
#include "src/files/rig_file.h"
#include "tests/support/expect.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

bool has(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

class SpectralLibraryTest : public QObject {
  Q_OBJECT

 private slots:
  // What was left out of a file reaches whoever asked for the curve, by itself or through a rig.
  void noticesOfFilesAreHeard() {
    test::ScratchFolder folder;
    std::string light = "Title,400 nm,500 nm,600 nm,700 nm,CCT\nlamp,1,2,3,4,5600\n";
    folder.write("lamp.csv", light);
    std::vector<std::string> heard;
    const Notice notice = [&](const std::string& sentence) { heard.push_back(sentence); };
    EXPECT_OK(loadLight({(folder / "lamp.csv").string(), {}, "t", notice}));
    QCOMPARE(heard.size(), std::size_t{1});
    QVERIFY2(
        heard[0].find("columns behind the wavelengths are left out: 'CCT'") != std::string::npos,
        heard[0].c_str());
    EXPECT_OK(loadLight({(folder / "lamp.csv").string(), {}, "t"}));
    heard.clear();
    folder.write("rig.json", R"({"cutis_rig": 1, "name": "r", "camera": {"sensitivity": "cie1931"},
                                 "lights": [{"name": "lamp", "spectrum": "lamp.csv"}]})");
    EXPECT_OK(loadRig((folder / "rig.json").string(), {}, "t", notice));
    QCOMPARE(heard.size(), std::size_t{1});
  }

  // resources/manual/file_formats.md: stems of the library without `cie_`.
  void namesAreTheDocumentedOnes() {
    for (const char* name : {"D65", "A", "FL2", "LED_B3", "E"})
      QVERIFY2(has(lightNames(), name), name);
    QVERIFY(has(observerNames(), "cie1931") && has(observerNames(), "cie1964"));
    QVERIFY(has(cameraNames(), "Canon_EOS_R"));
    QVERIFY(has(displayNames(), "iset_LCD_Gechic"));
    for (const auto& names : {lightNames(), cameraNames(), observerNames(), displayNames()}) {
      QVERIFY(std::is_sorted(names.begin(), names.end()));
      QVERIFY(std::adjacent_find(names.begin(), names.end()) == names.end());
      for (const std::string& name : names)
        QVERIFY(!name.starts_with("cie_"));
    }
  }

  void everythingInTheLibraryLoads() {
    for (const std::string& name : lightNames()) {
      const auto light = loadLight({name, {}, "test"});
      EXPECT_OK(light);
      QVERIFY((light.value() >= 0.0).all() && light.value().sum() > 0.0);
    }
    for (const std::string& name : cameraNames()) {
      const auto camera = loadCamera({name, {}, "test"});
      EXPECT_OK(camera);
      QVERIFY(!camera.value().isObserver);
      QCOMPARE(camera.value().channelNames[2], std::string("B"));
      for (int c = 0; c < 3; ++c)
        QVERIFY(camera.value().sensor.sensitivity.row(c).sum() > 0.0);
    }
    for (const std::string& name : observerNames()) {
      const auto observer = loadCamera({name, {}, "test"});
      EXPECT_OK(observer);
      QVERIFY(observer.value().isObserver);
      QCOMPARE(observer.value().channelNames[0], std::string("X"));
    }
    for (const std::string& name : displayNames())
      EXPECT_OK(loadPrimaries({name, {}, "test"}));
    EXPECT_OK(loadChromophores({"chromophores", {}, "test"}));
  }

  // A display as a light is its white: all primaries at once.
  void aDisplayIsTheSumOfItsPrimaries() {
    const auto primaries = loadPrimaries({"iset_LCD_Gechic", {}, "test"});
    const auto white = loadLight({"iset_LCD_Gechic", {}, "test"});
    EXPECT_OK(primaries);
    EXPECT_OK(white);
    const Spectrum sum = primaries.value()[0] + primaries.value()[1] + primaries.value()[2];
    QVERIFY((white.value() - sum).abs().maxCoeff() < 1e-12 * sum.maxCoeff());
  }

  void theLongNameWorksToo() {
    QVERIFY((loadLight({"cie_D65", {}, "t"}).value() == loadLight({"D65", {}, "t"}).value()).all());
  }

  void unknownNamesSuggest() {
    EXPECT_ERROR(loadLight({"D56", {}, "--light"}),
                 "--light: unknown light 'D56'; did you mean 'D");
    EXPECT_ERROR(loadLight({"d65", {}, "--light"}), "did you mean 'D65'?");
    EXPECT_ERROR(loadLight({"zzzzzzzzz", {}, "--light"}), "known: A, ");
    EXPECT_ERROR(loadLight({"zzzzzzzzz", {}, "--light"}), "or name a CSV file");
    EXPECT_ERROR(loadCamera({"Canon_EOS_RR", {}, "rig.json"}), "did you mean 'Canon_EOS_R");
    EXPECT_ERROR(loadCamera({"cie1930", {}, "rig.json"}), "'cie19");
    EXPECT_ERROR(loadPrimaries({"D65", {}, "rig.json"}), "unknown display 'D65'");
    EXPECT_ERROR(loadChromophores({"chromofores", {}, "p.json"}), "did you mean 'chromophores'?");
  }

  void filesAreFoundWhereTheyAreNamed() {
    const test::ScratchFolder folder;
    folder.write("sub/lamp.csv", "nm,p\n300,2\n1000,2\n");
    folder.write("D65", "nm,p\n300,9\n1000,9\n");
    folder.write("mine", "nm,p\n300,4\n1000,4\n");
    EXPECT_NEAR(loadLight({"sub/lamp.csv", folder.path(), "t"}).value()[7], 2.0, 1e-12);
    EXPECT_NEAR(loadLight({"mine", folder.path(), "t"}).value()[7], 4.0, 1e-12);
    // An absolute path goes where it says.
    EXPECT_OK(loadLight({(folder / "sub/lamp.csv").string(), "/nowhere", "t"}));
    // Names win over files; a path with a folder in it is always a file.
    EXPECT_NEAR(loadLight({"D65", folder.path(), "t"}).value()[130], 100.0, 1e-9);  // 560 nm
    EXPECT_NEAR(loadLight({"./D65", folder.path(), "t"}).value()[130], 9.0, 1e-12);
    EXPECT_ERROR(loadLight({"D65.csv", folder.path(), "t"}), "there is no such file");
    EXPECT_ERROR(loadLight({"", folder.path(), "t"}), "");
  }

  void contentsAreChecked() {
    const test::ScratchFolder folder;
    const auto light = [&](const char* text) {
      return loadLight({folder.write("l.csv", text).string(), {}, "t"});
    };
    EXPECT_ERROR(light("nm,p\n300,1\n1000,-1\n"), "negative or no power");
    EXPECT_ERROR(light("nm,p\n300,0\n1000,0\n"), "negative or no power");
    EXPECT_ERROR(light("nm,p\n1100,1\n1200,1\n"), "between 300 and 1000 nm");
    EXPECT_NEAR(light("um,p\n0.3,1\n1.0,1\n").value()[7], 1.0, 1e-12);
    const auto three = folder.write("three.csv", "nm,r,g,b\n300,1,1,1\n1000,1,1,1\n").string();
    EXPECT_ERROR(loadCamera({three, {}, "t"}), "columns R, G, B (camera) or X, Y, Z (observer)");
    EXPECT_ERROR(loadPrimaries({three, {}, "t"}), "columns R, G, B");
    // Any order of the columns, and more of them.
    const auto mixed = folder.write("m.csv", "nm,B,x,G,R\n300,3,0,2,1\n1000,3,0,2,1\n").string();
    const auto camera = loadCamera({mixed, {}, "t"});
    EXPECT_OK(camera);
    EXPECT_NEAR(camera.value().sensor.sensitivity(0, 9), 1.0, 1e-12);
    EXPECT_NEAR(camera.value().sensor.sensitivity(2, 9), 3.0, 1e-12);
  }
};

class SuggestionTest : public QObject {
  Q_OBJECT

 private slots:
  void theNearestIsMeant() {
    const std::vector<std::string> known = {"A", "D50", "D65", "cie1931", "monitor"};
    QCOMPARE(suggestName("moniter", known),
             std::string("did you mean 'monitor'? Known: A, D50, D65, cie1931, monitor"));
    QCOMPARE(suggestName("MONITOR", known).substr(0, 23), std::string("did you mean 'monitor'?"));
    QCOMPARE(suggestName("cie31", known).substr(0, 23), std::string("did you mean 'cie1931'?"));
    QCOMPARE(suggestName("tungsten", known), std::string("known: A, D50, D65, cie1931, monitor"));
    QCOMPARE(suggestName("", known).substr(0, 6), std::string("known:"));
    QCOMPARE(suggestName("x", {}), std::string("known: "));
  }
};

CUTIS_TEST(SpectralLibraryTest)
CUTIS_TEST(SuggestionTest)

}  // namespace
}  // namespace cutis

#include "spectral_library_test.moc"
