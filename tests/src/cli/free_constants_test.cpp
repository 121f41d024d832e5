// fit --free and what becomes of its maps: simulate → fit → render, edit, apply, simulate, info.

#include <cmath>

#include <nlohmann/json.hpp>

#include "tests/src/cli/program_run.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis::test {
namespace {

constexpr char kOptions[] =
    " --profile li2024 --free oxygenation --deviation --noise 0.00001,0.0005";

// Seven narrow lights in front of a camera of three broad curves; noise of its own.
void writeRig(const ProgramRun& run) {
  const auto tableOf = [](const std::string& head, const auto& row) {
    std::string text = "wavelength_nm," + head + "\n";
    for (int nm = 380; nm <= 1000; nm += 4)
      text += std::to_string(nm) + row(nm) + "\n";
    return text;
  };
  const auto bell = [](int nm, double middle, double width) {
    return ',' + std::to_string(0.05 + std::exp(-std::pow((nm - middle) / width, 2)));
  };
  run.write("camera.csv", tableOf("R,G,B", [&](int nm) {
              return bell(nm, 620, 190) + bell(nm, 540, 180) + bell(nm, 460, 200);
            }));
  nlohmann::json rig = {{"cutis_rig", 1},
                        {"name", "diodes"},
                        {"camera", {{"sensitivity", "camera.csv"}}},
                        {"lights", nlohmann::json::array()},
                        {"noise", {{"read", 0.0001}, {"proportional", 0.005}}}};
  for (const int middle : {420, 500, 545, 580, 640, 760, 900}) {
    const std::string name = std::to_string(middle);
    run.write(name + ".csv", tableOf("power", [&](int nm) {
                return ',' + std::to_string(std::max(0, 16 - std::abs(nm - middle)));
              }));
    rig["lights"].push_back({{"name", name}, {"spectrum", name + ".csv"}});
  }
  run.write("rig.json", rig.dump());
}

double meanOf(const Plane& plane, const Plane& state) {
  const std::vector<float> values = valuesOf(plane), states = valuesOf(state);
  double sum = 0.0, count = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (states[i] != 0.0f) continue;
    sum += double{values[i]};
    ++count;
  }
  return sum / count;
}

class FreeConstantsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  // Skin of another oxygenation: maps that say so, photographed.
  void initTestCase() {
    writeRig(run_);
    EXPECT_DONE(run_.run("simulate --patch 40x24 --profile li2024 -o patch"));
    MapsFile truth = run_.maps("patch/maps.exr");
    truth.maps.constants[kOxygenation] = planeOf(40, 24, std::vector<float>(960, 0.45f));
    EXPECT_OK(writeMaps(run_ / "truth.exr", truth, {}));
    EXPECT_DONE(run_.run("simulate truth.exr --rig rig.json --noise 0 -o cap"));
    EXPECT_DONE(run_.run(QString("fit cap -o maps.exr --quiet --report fit.json") + kOptions));
  }

  void theConstantComesBack() {
    const MapsFile maps = run_.maps("maps.exr");
    EXPECT_NEAR(meanOf(maps.maps.constants[kOxygenation], maps.maps.state), 0.45, 0.02);
    QVERIFY(maps.maps.constants[kThickness].empty());
    QCOMPARE(maps.constantDeviations.size(), std::size_t{1});
    QCOMPARE(maps.deviations.size(), std::size_t{kParameterCount});
    const auto report = nlohmann::json::parse(run_.read("fit.json"));
    EXPECT_NEAR(report["free"]["oxygenation"]["mean"].get<double>(), 0.45, 0.02);
    QVERIFY(!report["free"].contains("thickness_mm"));
    EXPECT_AT_MOST(report["residual"]["mean"].get<double>(), 5e-4);
    const Outcome told = run_.run("info maps.exr");
    EXPECT_DONE(told);
    QVERIFY2(told.output.find("oxygenation: median 0.4") != std::string::npos, told.output.c_str());
  }

  void threadsChangeNothing() {
    EXPECT_DONE(run_.run(QString("fit cap -o one.exr --quiet --threads 1") + kOptions));
    QVERIFY(run_.read("one.exr") == run_.read("maps.exr"));
  }

  // A picture under a light of the rig by its camera is the photograph that was fitted.
  void renderingShowsThePhotograph() {
    EXPECT_DONE(
        run_.run("render maps.exr -o seen.exr --light 545.csv --observer camera.csv "
                 "--bit-depth float"));
    const std::vector<float> states = valuesOf(run_.maps("maps.exr").maps.state);
    const Image seen = run_.image("seen.exr"), taken = run_.image("cap/545.exr");
    for (std::size_t c = 0; c < 3; ++c) {
      const std::vector<float> a = valuesOf(seen.channels[c]), b = valuesOf(taken.channels[c]);
      for (std::size_t i = 0; i < a.size(); ++i) {
        if (states[i] == 0.0f) EXPECT_NEAR(a[i], b[i], 2e-3f);
      }
    }
    MapsFile dropped = run_.maps("maps.exr");
    dropped.maps.constants = {};
    dropped.constantDeviations.clear();
    EXPECT_OK(writeMaps(run_ / "dropped.exr", dropped, {}));
    EXPECT_DONE(
        run_.run("render dropped.exr -o without.exr --light 545.csv --observer camera.csv "
                 "--bit-depth float"));
    QVERIFY(valuesOf(run_.image("without.exr").channels[1]) != valuesOf(seen.channels[1]));
  }

  void editPassesThemOn() {
    EXPECT_DONE(run_.run("edit maps.exr -o same.exr"));
    QCOMPARE(run_.maps("same.exr").constantDeviations.size(), std::size_t{1});
    const Outcome edited = run_.run("edit maps.exr -o edited.exr --melanin 1.5");
    QCOMPARE(edited.status, 0);
    const MapsFile maps = run_.maps("edited.exr");
    QVERIFY(maps.constantDeviations.empty());
    QVERIFY(valuesOf(maps.maps.constants[kOxygenation]) ==
            valuesOf(run_.maps("maps.exr").maps.constants[kOxygenation]));
    EXPECT_DONE(run_.run("apply cap --maps maps.exr -o albedo.exr --melanin 1.5"));
    EXPECT_DONE(run_.run("simulate edited.exr --rig rig.json -o again"));
  }

  void whatIsAssumedIsTold() {
    EXPECT_DONE(run_.run("simulate --patch 24x16 --profile li2024 -o monitor"));
    const Outcome told =
        run_.run("fit monitor -o m.exr --profile li2024 --free oxygenation --noise 0.01,0.05");
    QCOMPARE(told.status, 0);
    QVERIFY2(told.errors.find("oxygenation is mostly what was assumed") != std::string::npos,
             told.errors.c_str());
  }

  void wrongWordsAreRefused() {
    for (const auto& [options, sentence] :
         {std::pair{"--free oxygen", "'oxygen' cannot be found"},
          {"--free thickness,thickness", "is named twice"},
          {"--free oxygenation --shading", "does not go with --shading"},
          {"--free oxygenation --method three-stage", "only the method refined takes this"},
          {"--free oxygenation --lights 420", "3 independent channels where 6 values"}}) {
      const Outcome wrong = run_.run(QString("fit cap -o x.exr ") + options);
      QCOMPARE(wrong.status, 2);
      QVERIFY2(isOneError(wrong.errors) && wrong.errors.find(sentence) != std::string::npos,
               wrong.errors.c_str());
    }
    QVERIFY(!std::filesystem::exists(run_ / "x.exr"));
  }

 private:
  ProgramRun run_;
};

CUTIS_TEST(FreeConstantsTest)

}  // namespace
}  // namespace cutis::test

#include "free_constants_test.moc"
