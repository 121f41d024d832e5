#include "src/files/rig_file.h"

#include <algorithm>
#include <filesystem>

#include <QtTest>

#include "src/files/spectral_library.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

// A rig of the documented kind that uses files of its own.
constexpr char kStudio[] = R"({
  "cutis_rig": 1, "name": "studio",
  "camera": {"sensitivity": "camera.csv"},
  "primaries": {"file": "screens/display.csv"},
  "lights": [ {"name": "white", "mix": {"R": 1, "G": 1, "B": 1}},
              {"name": "white+blue", "mix": {"R": 0.5, "G": 0.5, "B": 1}},
              {"name": "lamp", "spectrum": "lamp.csv"},
              {"name": "sky", "spectrum": "D65"} ],
  "noise": {"read": 0.001, "proportional": 0.02}
})";

void writeStudio(const test::ScratchFolder& folder) {
  folder.write("studio/rig.json", kStudio);
  folder.write("studio/camera.csv", "nm,R,G,B\n300,1,2,3\n1000,1,2,3\n");
  folder.write("studio/screens/display.csv", "nm,R,G,B\n300,1,2,4\n1000,1,2,4\n");
  folder.write("studio/lamp.csv", "nm,power\n300,7\n1000,7\n");
}

std::string changedRig(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  if (at == std::string::npos) return "test is wrong: " + from;
  return text.replace(at, from.size(), to);
}

class RigFileTest : public QObject {
  Q_OBJECT

 private slots:
  void builtInRigs() {
    const std::vector<std::string> names = rigNames();
    QVERIFY(std::find(names.begin(), names.end(), "monitor") != names.end());
    QVERIFY(std::find(names.begin(), names.end(), "albedo") != names.end());
    for (const std::string& name : names)
      EXPECT_OK(loadRig(name, {}, "--rig"));
    // Wherever the caller stands.
    EXPECT_OK(loadRig("monitor", "/nowhere", "--rig"));
  }

  // resources/manual/file_formats.md: white = R+G+B, white+blue = ⅓, ⅓, 1, white+green = ⅓, 1, ⅓;
  // Canon EOS R.
  void monitorIsAsDocumented() {
    const Rig& rig = test::monitorRig();
    const double third = 1.0 / 3.0;
    QVERIFY(rig.lights[0].mix->isApprox(Eigen::Vector3d(1, 1, 1)));
    QVERIFY(rig.lights[1].mix->isApprox(Eigen::Vector3d(third, third, 1)));
    QVERIFY(rig.lights[2].mix->isApprox(Eigen::Vector3d(third, 1, third)));
    QCOMPARE(rig.camera.name, std::string("Canon_EOS_R"));
    QVERIFY(!rig.camera.isObserver);
    const auto primaries = loadPrimaries({"iset_LCD_Gechic", {}, "t"}).value();
    const Spectrum blue = third * primaries[0] + third * primaries[1] + primaries[2];
    QVERIFY((rig.lights[1].power - blue).abs().maxCoeff() < 1e-12 * blue.maxCoeff());
  }

  void albedoIsAsDocumented() {
    const Rig& rig = test::albedoRig();
    QCOMPARE(rig.lights.size(), std::size_t{1});
    QCOMPARE(rig.lights[0].name, std::string("D65"));
    QVERIFY(!rig.lights[0].mix);
    QVERIFY(rig.camera.isObserver);
    QCOMPARE(rig.channelName(1), std::string("D65.Y"));
  }

  // Paths start at the file, not at the working directory.
  void pathsAreRelativeToTheFile() {
    const test::ScratchFolder folder;
    writeStudio(folder);
    const auto absolute = loadRig((folder / "studio/rig.json").string(), {}, "--rig");
    const auto relative = loadRig("studio/rig.json", folder.path().string(), "--rig");
    const auto here = std::filesystem::current_path();
    std::filesystem::current_path(folder.path());
    const auto working = loadRig("studio/rig.json", {}, "--rig");
    std::filesystem::current_path(folder / "studio");
    const auto bare = loadRig("rig.json", {}, "--rig");
    std::filesystem::current_path(here);
    for (const auto* rig : {&absolute, &relative, &working, &bare}) {
      EXPECT_OK(*rig);
      const Rig& studio = rig->value();
      QCOMPARE(studio.name, std::string("studio"));
      QCOMPARE(studio.channelCount(), 12);
      EXPECT_NEAR(studio.lights[1].power[9], 0.5 + 1.0 + 4.0, 1e-12);
      EXPECT_NEAR(studio.lights[2].power[9], 7.0, 1e-12);
      EXPECT_NEAR(studio.camera.sensor.sensitivity(1, 9), 2.0, 1e-12);
      QVERIFY((studio.lights[3].power == test::light("D65")).all());
      EXPECT_NEAR(studio.noise.read, 0.001, 0.0);
      EXPECT_NEAR(studio.noise.proportional, 0.02, 0.0);
    }
  }

  // resources/manual/file_formats.md: built-in rigs assume 0.0001, 0.005; so does a file that
  // says nothing.
  void noiseHasADefault() {
    const test::ScratchFolder folder;
    writeStudio(folder);
    folder.write(
        "studio/rig.json",
        changedRig(kStudio, ",\n  \"noise\": {\"read\": 0.001, \"proportional\": 0.02}", ""));
    const auto rig = loadRig((folder / "studio/rig.json").string(), {}, "t");
    EXPECT_OK(rig);
    EXPECT_NEAR(rig.value().noise.read, 0.0001, 0.0);
    EXPECT_NEAR(rig.value().noise.proportional, 0.005, 0.0);
  }

  void unknownNamesSuggest() {
    EXPECT_ERROR(loadRig("moniter", {}, "--rig"),
                 "--rig: unknown rig 'moniter'; did you mean 'monitor'?");
    EXPECT_ERROR(loadRig("gone.json", {}, "--rig"), "there is no such file");
    EXPECT_ERROR(loadRig("rigs/monitor", {}, "--rig"), "there is no such file");
  }

  void errorsNameFileAndField_data() {
    QTest::addColumn<QString>("from");
    QTest::addColumn<QString>("to");
    QTest::addColumn<QString>("message");
    const auto row = [](const char* name, const char* from, const char* to, const char* message) {
      QTest::newRow(name) << from << to << message;
    };
    row("newer", "\"cutis_rig\": 1", "\"cutis_rig\": 2", "newer version");
    row("of another kind", "\"cutis_rig\": 1", "\"cutis_maps\": 1", "\"cutis_rig\": 1 is missing");
    row("no name", "\"name\": \"studio\",", "", "name must be a text (it is missing)");
    row("unknown field", "\"camera\"", "\"kamera\"", "unknown field 'kamera'");
    row("no camera", "\"camera\": {\"sensitivity\": \"camera.csv\"},", "",
        "camera must be an object");
    row("misspelt sensitivity", "sensitivity", "sensitivty", "unknown field 'camera.sensitivty'");
    row("unknown camera", "\"camera.csv\"", "\"Canon\"", "unknown camera or observer 'Canon'");
    row("lost camera", "\"camera.csv\"", "\"lost.csv\"", "lost.csv: there is no such file");
    row("lost primaries", "screens/display.csv", "display.csv",
        "display.csv: there is no such file");
    row("lights not a list", "\"lights\": [", "\"lights\": 5, \"old\": [", "unknown field 'old'");
    row("a light that is text", "{\"name\": \"sky\", \"spectrum\": \"D65\"}", "\"D65\"",
        "lights[3] must be an object");
    row("no light name", "\"name\": \"lamp\", ", "", "lights[2].name must be a text");
    row("name is a number", "\"name\": \"lamp\"", "\"name\": 3", "lights[2].name must be a text");
    row("mix and spectrum", "\"spectrum\": \"D65\"", "\"spectrum\": \"D65\", \"mix\": {\"R\": 1}",
        "lights[3].mix must be given, or spectrum, and not both");
    row("neither", ", \"spectrum\": \"D65\"", "", "lights[3].mix must be given, or spectrum");
    row("unknown light", "\"D65\"", "\"D66\"", "unknown light 'D66'; did you mean 'D6");
    row("negative share", "\"B\": 1}}", "\"B\": -1}}", "lights[0].mix.B must be zero or positive");
    row("share is text", "\"B\": 1}}", "\"B\": \"1\"}}", "lights[0].mix.B must be a finite number");
    row("unknown primary", "\"B\": 1}}", "\"W\": 1}}", "unknown field 'lights[0].mix.W'");
    row("dark mix", "{\"R\": 1, \"G\": 1, \"B\": 1}", "{}",
        "light 'white' has negative, missing or no");
    row("mix without primaries", "\"primaries\": {\"file\": \"screens/display.csv\"},", "",
        "lights[0].mix must be left out unless the rig names primaries");
    row("the same name twice", "\"white+blue\"", "\"white\"", "two lights are called 'white'");
    row("negative noise", "\"read\": 0.001", "\"read\": -0.001", "noise must be finite and not");
    row("half a noise", "\"read\": 0.001, ", "", "noise.read must be a number (it is missing)");
    row("noise is a list", "{\"read\": 0.001, \"proportional\": 0.02}", "[0.001, 0.02]",
        "noise must be an object");
  }
  void errorsNameFileAndField() {
    QFETCH(QString, from);
    QFETCH(QString, to);
    QFETCH(QString, message);
    const test::ScratchFolder folder;
    writeStudio(folder);
    const auto path =
        folder.write("studio/rig.json", changedRig(kStudio, from.toStdString(), to.toStdString()));
    const auto rig = loadRig(path.string(), {}, "--rig");
    QVERIFY(rig.failed());
    QVERIFY2(rig.error().text().find(message.toStdString()) != std::string::npos,
             rig.error().text().c_str());
    // The file that is wrong: the rig, or one beside it.
    QVERIFY2(rig.error().place.find(folder.path().string()) == 0, rig.error().place.c_str());
  }

  void noLightsAndNegativeCameras() {
    const test::ScratchFolder folder;
    writeStudio(folder);
    const auto empty = folder.write("studio/e.json", R"({"cutis_rig": 1, "name": "e",
        "camera": {"sensitivity": "camera.csv"}, "lights": []})");
    EXPECT_ERROR(loadRig(empty.string(), {}, "t"), "e.json: lights is empty");
    folder.write("studio/camera.csv", "nm,R,G,B\n300,1,2,3\n1000,1,-2,3\n");
    EXPECT_ERROR(loadRig((folder / "studio/rig.json").string(), {}, "t"), "values in column G");
  }

  void syntaxErrorsSayWhere() {
    const test::ScratchFolder folder;
    const auto path = folder.write("rig.json", "{\r\n  \"cutis_rig\": 1,\r\n  \"name\" 3\r\n}");
    EXPECT_ERROR(loadRig(path.string(), {}, "t"), path.string() + ":3:10: not valid JSON");
  }
};

CUTIS_TEST(RigFileTest)

}  // namespace
}  // namespace cutis

#include "rig_file_test.moc"
