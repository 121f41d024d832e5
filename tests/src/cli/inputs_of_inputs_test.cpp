// What an input names is an input, too, and no command writes over it.

#include <filesystem>

#include "tests/src/cli/program_run.h"
#include "tests/src/cli/refusal.h"
#include "tests/support/folders.h"
#include "tests/support/test_registry.h"

namespace cutis::test {
namespace {

namespace fs = std::filesystem;

constexpr char kFlat[] = "nm,R,G,B\n300,1,1,1\n1000,1,1,1\n";

class InputsOfInputsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    run_.write("studio/camera.csv", kFlat);
    run_.write("studio/display.csv", kFlat);
    run_.write("studio/lamp.csv", "nm,power\n300,1\n1000,1\n");
    run_.write("rig.json",
               R"({"cutis_rig": 1, "name": "studio", "camera": {"sensitivity": "studio/camera.csv"},
                   "primaries": {"file": "studio/display.csv"},
                   "lights": [{"name": "lamp", "spectrum": "studio/lamp.csv"}]})");
    fs::copy_file(sourceFolder() / "resources/spectra/chromophores.csv", run_ / "pure.csv");
    std::string profile = textOf(sourceFolder() / "resources/profiles/li2024.json");
    const std::string named = "\"chromophores\": \"chromophores\"";
    const auto at = profile.find(named);
    QVERIFY(at != std::string::npos);
    profile.replace(at, named.size(), "\"chromophores\": \"pure.csv\"");
    run_.write("profile.json", profile);
    run_.write("spectra.csv", "id,400,450,500,550,600,650\na,.1,.2,.3,.3,.4,.4\n");
    run_.write("calibration.json", R"({"cutis_calibration": 1, "start": "profile.json"})");
    EXPECT_DONE(run_.run("simulate --patch 16x12 --rig rig.json -o cap"));
    fs::create_hard_link(run_ / "studio/lamp.csv", run_ / "hard.csv");
    fs::create_symlink("studio/camera.csv", run_ / "soft.csv");
  }

  void whatInputsNameIsKept_data() {
    QTest::addColumn<QString>("command");
    const auto row = [](const char* command) { QTest::newRow(command) << command; };
    row("fit-spectra spectra.csv --profile profile.json -o pure.csv");
    row("fit-spectra spectra.csv --profile profile.json -o ./studio/../pure.csv");
    row("spectrum --params 0,0,0,0,0 --profile profile.json -o pure.csv");
    row("validate spectra.csv --profile profile.json --plot pure.csv");
    row("calibrate-profile calibration.json spectra.csv -o pure.csv");
    row("calibrate-profile calibration.json spectra.csv -o profile.json");
    row("train --rig rig.json -o studio/camera.csv");
    row("train --rig rig.json -o x.weights --state studio/lamp.csv");
    row("train --rig rig.json -o hard.csv");
    row("train --rig rig.json -o soft.csv");
    row("rig identify --rig rig.json --plot studio/display.csv");
    row("bench --quick --profile profile.json --report pure.csv");
    // A capture names its rig, and that its lamp.
    row("fit cap -o m.exr --report rig.json");
    row("fit cap -o m.exr --report studio/lamp.csv");
    row("fit cap/capture.json -o m.exr --report cap/mask.png");
    row("fit cap -o cap/lamp.exr");
  }
  void whatInputsNameIsKept() {
    QFETCH(QString, command);
    const auto before = run_.contents();
    const Outcome outcome = run_.run(command);
    QVERIFY2(outcome.errors.find("sources are never written to") != std::string::npos ||
                 // Its plots are named by the files that are judged.
                 command.startsWith("validate"),
             outcome.errors.c_str());
    QVERIFY(outcome.status != 0);
    QVERIFY(run_.contents() == before);
  }

  void simulateAsksBeforePhotographsAreReplaced() {
    const auto before = run_.contents();
    const Outcome refused = run_.run("simulate --patch 16x12 --seed 2 --rig rig.json -o cap");
    QCOMPARE(refused.status, 2);
    QVERIFY2(refused.errors.find("give --overwrite to replace them") != std::string::npos,
             refused.errors.c_str());
    QVERIFY(run_.contents() == before);
    EXPECT_DONE(run_.run("simulate --patch 16x12 --seed 2 --rig rig.json -o cap --overwrite"));
    QVERIFY(run_.contents() != before);
  }

  void simulateKeepsWhatItReads() {
    const auto before = run_.contents();
    for (const char* command :
         {"simulate cap/maps.exr --recipe x -o cap --overwrite",
          "simulate --patch 16x12 --rig cap/capture.json -o cap --overwrite"}) {
      QVERIFY(run_.run(command).status != 0);
      QVERIFY(run_.contents() == before);
    }
    fs::copy_file(run_ / "cap/maps.exr", run_ / "cap/lamp_2.exr");
    fs::rename(run_ / "cap/lamp_2.exr", run_ / "cap/lamp.exr");
    const auto changed = run_.contents();
    const Outcome outcome = run_.run("simulate cap/lamp.exr --rig rig.json -o cap --overwrite");
    QVERIFY2(outcome.errors.find("sources are never written to") != std::string::npos,
             outcome.errors.c_str());
    QVERIFY(run_.contents() == changed);
  }

 private:
  static std::string textOf(const fs::path& path) {
    QFile file(path.c_str());
    return file.open(QFile::ReadOnly) ? file.readAll().toStdString() : std::string();
  }

  ProgramRun run_;
};

CUTIS_TEST(InputsOfInputsTest)

}  // namespace
}  // namespace cutis::test

#include "inputs_of_inputs_test.moc"
