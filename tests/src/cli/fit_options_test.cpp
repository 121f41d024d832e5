// fit with a factor of shading, with a profile by radiative transfer, and without noise where there
// is some; and what a rig can tell apart.

#include <nlohmann/json.hpp>

#include "tests/src/cli/program_run.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis::test {
namespace {

class FitOptionsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { EXPECT_DONE(run_.run("simulate --patch 48x32 --noise 0.005 -o cap")); }

  void shadingIsWrittenBesideTheMaps() {
    EXPECT_DONE(run_.run("fit cap -o shaded.exr --shading"));
    const MapsFile maps = run_.maps("shaded.exr");
    QVERIFY(!maps.shading.empty());
    const std::vector<float> factors = valuesOf(maps.shading), states = valuesOf(maps.maps.state);
    int solved = 0;
    double sum = 0.0;
    for (std::size_t i = 0; i < factors.size(); ++i) {
      if (states[i] != 0.0f) continue;
      QVERIFY(factors[i] > 0.2f && factors[i] < 2.0f);
      sum += double{factors[i]};
      ++solved;
    }
    QVERIFY(solved > 100);
    EXPECT_NEAR(sum / solved, 1.0, 0.15);  // the sample has no shades
    EXPECT_DONE(run_.run("fit cap -o plain.exr"));
    QVERIFY(run_.maps("plain.exr").shading.empty());
  }

  void theExactSettingWarnsOfNoise() {
    const Outcome noisy = run_.run("fit cap -o exact.exr --noise 0,0");
    QCOMPARE(noisy.status, 0);
    QVERIFY2(noisy.errors.find("no skin meets these channels exactly") != std::string::npos,
             noisy.errors.c_str());
    EXPECT_DONE(run_.run("simulate --patch 48x32 --noise 0 -o clean"));
    const Outcome clean = run_.run("fit clean -o clean.exr --noise 0,0");
    EXPECT_DONE(clean);
    QVERIFY2(clean.errors.find("exactly") == std::string::npos, clean.errors.c_str());
  }

  // The same way through all commands with the other theory of light in skin.
  void radiativeTransferFindsItsOwnSkin() {
    EXPECT_DONE(run_.run("simulate --patch 48x32 --noise 0.002 --profile skin2026 -o own"));
    EXPECT_DONE(run_.run("fit own -o own.exr --profile skin2026 --report own.json"));
    QCOMPARE(run_.maps("own.exr").attributes.profileName, std::string("skin2026"));
    const auto report = nlohmann::json::parse(run_.read("own.json"));
    EXPECT_AT_MOST(report["residual"]["mean"].get<double>(), 1e-3);
    QCOMPARE(report["pixels"]["no_convergence"].get<int>(), 0);
    EXPECT_DONE(run_.run("render own.exr -o own.png --light A"));
    EXPECT_DONE(run_.run("fit own -o searched.exr --profile skin2026 --method three-stage"));
  }

  void rigsAreIdentified() {
    const Outcome told = run_.run("rig identify --people 20 --plot rig.svg");
    EXPECT_DONE(told);
    for (const char* part : {"all, 9 channels", "r, g, b, sb, sg", "0.5 %", "one more light"}) {
      QVERIFY2(told.output.find(part) != std::string::npos, part);
    }
    QVERIFY(run_.read("rig.svg").starts_with("<svg") ||
            run_.read("rig.svg").starts_with("<?xml"));
    EXPECT_DONE(run_.run("rig identify --people 20 --rig albedo --profile skin2026"));
    for (const auto& [line, sentence] :
         {std::pair{"rig", "ACTION"}, {"rig check", "not in this version"},
          {"rig identfy", "unknown action"}, {"rig identify --noise 0,0", "without noise"},
          {"rig identify --plot rig.pdf", "rig.pdf"}, {"rig identify --people 3", "--people"}}) {
      const Outcome wrong = run_.run(line);
      QCOMPARE(wrong.status, 2);
      QVERIFY2(isOneError(wrong.errors) && wrong.errors.find(sentence) != std::string::npos,
               wrong.errors.c_str());
    }
  }

 private:
  ProgramRun run_;
};

CUTIS_TEST(FitOptionsTest)

}  // namespace
}  // namespace cutis::test

#include "fit_options_test.moc"
