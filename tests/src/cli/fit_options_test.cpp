// fit with a factor of shading, with a profile by radiative transfer, and without noise where there
// is some; and what a rig can tell apart.

#include <cmath>

#include <nlohmann/json.hpp>

#include "core/skin/model/measurement_geometry.h"
#include "src/images/capture/capture_file.h"
#include "tests/src/cli/program_run.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis::test {
namespace {

class FitOptionsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { EXPECT_DONE(run_.run("simulate --patch 48x32 --noise 0.005 -o cap")); }

  // The sample is dark skin in places, where scattering no longer outweighs absorption.
  void outsideOfDiffusionIsSaid() {
    const auto diffusion = run_.run("fit cap -o diffusion.exr --profile li2024 --report d.json");
    QCOMPARE(diffusion.status, 0);
    QVERIFY2(
        diffusion.errors.find("absorbs more visible light than it scatters") != std::string::npos,
        diffusion.errors.c_str());
    const double share =
        nlohmann::json::parse(run_.read("d.json"))["outside_diffusion_share"].get<double>();
    QVERIFY(share > 0.05 && share <= 1.0);
    const auto info = run_.run("info diffusion.exr");
    QVERIFY2(info.output.find("outside diffusion's domain") != std::string::npos,
             info.output.c_str());
    // Radiative transfer holds everywhere.
    EXPECT_DONE(run_.run("fit cap -o transfer.exr --profile skin2026 --report t.json"));
    QVERIFY(!nlohmann::json::parse(run_.read("t.json")).contains("outside_diffusion_share"));
  }

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
    EXPECT_DONE(run_.run("render own.exr -o own.png --light A --quiet"));
    EXPECT_DONE(run_.run("fit own -o searched.exr --profile skin2026 --method three-stage"));
  }

  // Photographs with the sheen of the surface give the skin below it where the option says so.
  void theSurfaceReflectionIsTakenOff() {
    const MeasurementGeometry surface = measurementGeometry(SpecularPart::included, 1.4, 0.05);
    const auto capture = readCapture(run_ / "cap", {}, nullptr, {});
    EXPECT_OK(capture);
    Measurements shiny = capture.value().measurements;
    for (Plane& channel : shiny.channels) {
      std::vector<float> values = valuesOf(channel);
      for (float& value : values)
        value = static_cast<float>(measuredReflectance(surface, double{value}));
      channel = Plane(shiny.width(), shiny.height());
      EXPECT_OK(channel.store(channel.bounds(), values));
    }
    EXPECT_OK(writeCapture(run_ / "shiny", shiny,
                           {.rig = "monitor", .sampleType = SampleType::float32}, {}));
    EXPECT_DONE(run_.run("fit cap -o below.exr"));
    EXPECT_DONE(run_.run("fit shiny -o told.exr --specular included --specular-share 0.05"));
    EXPECT_DONE(run_.run("fit shiny -o untold.exr --specular cross-polarised"));
    QCOMPARE(run_.maps("told.exr").attributes.specularShare, 0.05);
    QCOMPARE(run_.maps("untold.exr").attributes.specularShare, 0.0);
    const auto melaninAway = [&](const std::string& name) {
      const auto below = valuesOf(run_.maps("below.exr").maps.values[kMelanin]);
      const auto other = valuesOf(run_.maps(name).maps.values[kMelanin]);
      const auto states = valuesOf(run_.maps("below.exr").maps.state);
      double away = 0.0, all = 0.0;
      for (std::size_t i = 0; i < below.size(); ++i) {
        if (states[i] != 0.0f) continue;
        away += std::abs(double{other[i]} - double{below[i]});
        all += double{below[i]};
      }
      return away / all;
    };
    EXPECT_AT_MOST(melaninAway("told.exr"), 0.02);
    const Outcome dark = run_.run("fit shiny -o dark.exr --specular included --specular-share 0.5");
    QCOMPARE(dark.status, 0);
    QVERIFY2(dark.errors.find("smaller specular share") != std::string::npos, dark.errors.c_str());
    QVERIFY(melaninAway("untold.exr") > 0.1);

    // The edited albedo of what lies below: the same whether it is fitted now or was before.
    EXPECT_DONE(run_.run("apply shiny --maps told.exr -o before.exr --melanin 1.5"));
    EXPECT_DONE(
        run_.run("apply shiny -o now.exr --melanin 1.5 --specular included --specular-share 0.05"));
    const Image before = run_.image("before.exr"), now = run_.image("now.exr");
    for (std::size_t c = 0; c < before.channels.size(); ++c)
      QVERIFY(valuesOf(before.channels[c]) == valuesOf(now.channels[c]));
    for (const auto& [line, sentence] :
         {std::pair{"fit now.exr -o x.exr --specular included", "single image"},
          {"fit shiny -o x.exr --specular shiny", "cross-polarised"},
          {"fit shiny -o x.exr --specular-share 0.1", "--specular included"},
          {"fit shiny -o x.exr --specular included --shading", "told apart"}}) {
      const Outcome wrong = run_.run(line);
      QCOMPARE(wrong.status, 2);
      QVERIFY2(isOneError(wrong.errors) && wrong.errors.find(sentence) != std::string::npos,
               wrong.errors.c_str());
    }
  }

  void rigsAreIdentified() {
    const Outcome told = run_.run("rig identify --people 20 --plot rig.svg");
    EXPECT_DONE(told);
    for (const char* part : {"all, 9 channels", "r, g, b, sb, sg", "0.5 %", "one more light"}) {
      QVERIFY2(told.output.find(part) != std::string::npos, part);
    }
    // Its camera's curves end at 780 nm.
    for (const char* unseen : {"820 nm", "880 nm", "960 nm"})
      QVERIFY2(told.output.find(unseen) == std::string::npos, unseen);
    QVERIFY(run_.read("rig.svg").starts_with("<svg") || run_.read("rig.svg").starts_with("<?xml"));
    EXPECT_DONE(run_.run("rig identify --people 20 --rig albedo --profile skin2026"));
    for (const auto& [line, sentence] : {std::pair{"rig", "ACTION"},
                                         {"rig check", "not in this version"},
                                         {"rig identfy", "unknown action"},
                                         {"rig identify --noise 0,0", "without noise"},
                                         {"rig identify --plot rig.pdf", "rig.pdf"},
                                         {"rig identify --people 3", "--people"}}) {
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
