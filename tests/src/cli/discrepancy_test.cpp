// What the model leaves over, through fit, maps, pictures and spectra.

#include <algorithm>
#include <cmath>
#include <fstream>

#include <nlohmann/json.hpp>

#include "core/base/number_text.h"
#include "core/fit/spectrum_posterior.h"
#include "src/files/io/csv.h"
#include "src/files/profiles/profile_file.h"
#include "src/files/rig_file.h"
#include "tests/src/cli/program_run.h"
#include "tests/src/cli/refusal.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis::test {
namespace {

class DiscrepancyTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    EXPECT_DONE(run_.run("simulate --patch 48x32 --profile skin2026b -o cap"));
    EXPECT_DONE(run_.run("fit cap -o on.exr --profile skin2026b --discrepancy on"));
    EXPECT_DONE(run_.run("fit cap -o off.exr --profile skin2026b"));
  }

  // A simulated capture is of the model's own skin.
  void isOffForSimulatedSkin() {
    QVERIFY(nlohmann::json::parse(run_.read("cap/capture.json"))["simulated"].get<bool>());
    QVERIFY(run_.maps("off.exr").maps.coefficients.empty());
    EXPECT_DONE(run_.run("fit cap -o skin2026.exr --profile skin2026"));
    const MapsFile with = run_.maps("off.exr"), without = run_.maps("skin2026.exr");
    for (std::size_t k = 0; k < kParameterCount; ++k)
      QVERIFY(valuesOf(with.maps.values[k]) == valuesOf(without.maps.values[k]));
  }

  void mapsHoldTheCoefficients() {
    const MapsFile maps = run_.maps("on.exr");
    QCOMPARE(maps.maps.coefficients.size(), std::size_t{6});
    QVERIFY(maps.maps.surface == SurfaceLight::included);
    const auto info = run_.run("info on.exr");
    QVERIFY2(info.output.find("further parts: discrepancy") != std::string::npos,
             info.output.c_str());
    EXPECT_DONE(
        run_.run("fit cap -o below.exr --profile skin2026b --discrepancy on --specular excluded"));
    QVERIFY(run_.maps("below.exr").maps.surface == SurfaceLight::removed);
  }

  // The picture under a light and the spectra are of the same skin.
  void picturesAndSpectraUseThem() {
    const auto spectra = run_.run("spectrum --maps on.exr");
    QCOMPARE(spectra.status, 0);
    const auto lines = std::count(spectra.output.begin(), spectra.output.end(), '\n');
    const std::vector<float> states = valuesOf(run_.maps("on.exr").maps.state);
    QCOMPARE(lines - 1, std::count(states.begin(), states.end(), 0.0f));
    QVERIFY(spectra.output.starts_with("x,y,300,302,"));
    const auto single = run_.run("spectrum --maps on.exr --at 24,16");
    QCOMPARE(std::count(single.output.begin(), single.output.end(), '\n'), std::ptrdiff_t{2});
    const auto row = single.output.find("24,16,");
    QVERIFY(row != std::string::npos);
    QVERIFY(spectra.output.find(single.output.substr(row)) != std::string::npos);
    EXPECT_DONE(run_.run("render on.exr -o band.exr --band 650:650 --bit-depth float"));
    const Image band = run_.image("band.exr");
    // Column 2 + (650 − 300) / 2 of the row.
    std::size_t at = row;
    for (int column = 0; column < 2 + 175; ++column)
      at = single.output.find(',', at) + 1;
    const double reflectance = std::stod(single.output.substr(at));
    const std::vector<float> seen = valuesOf(band.channels.front());
    EXPECT_NEAR(double{seen[16 * 48 + 24]}, reflectance, 2e-4);
  }

  // Maps carry all that deviations take.
  void spectraComeWithDeviations() {
    const auto run = run_.run("spectrum --maps on.exr --at 24,16 --deviation");
    QCOMPARE(run.status, 0);
    const CsvTable table = splitCsv(run.output);
    QCOMPARE(table.size(), std::size_t{2});
    QCOMPARE(table[1].fields.size(), std::size_t{2 + 2 * kSampleCount});
    QCOMPARE(table[0].fields[2 + kSampleCount], std::string_view("sd300"));
    QCOMPARE(table[0].fields.back(), std::string_view("sd1000"));
    const MapsFile file = run_.maps("on.exr");
    const auto model =
        SkinModel::create(parseProfile(file.attributes.profileJson, "maps").value()).value();
    FitOptions options;
    options.discrepancy = true;
    const SpectrumPosterior posterior(*model, loadRig("monitor", "", "test").value(), options);
    std::vector<double> values;
    for (const Plane& plane : file.maps.planes())
      values.push_back(double{valuesOf(plane)[16 * 48 + 24]});
    const Spectrum expected = posterior.deviation(posterior.channels(values), values);
    for (int i = 0; i < kSampleCount; ++i) {
      const auto column = static_cast<std::size_t>(2 + kSampleCount + i);
      const double deviation = parseNumber(table[1].fields[column]).value();
      QVERIFY(deviation > 0.0);
      EXPECT_NEAR(deviation, expected[i], 1e-5 * expected[i]);
    }
  }

  // An edit changes what physics explains, and nothing else.
  void editedMapsKeepIt() {
    EXPECT_DONE(run_.run("edit on.exr -o darker.exr --melanin 1.2"));
    const ChromophoreMaps before = run_.maps("on.exr").maps, after = run_.maps("darker.exr").maps;
    QVERIFY(!before.coefficients.empty());
    QCOMPARE(after.coefficients.size(), before.coefficients.size());
    QCOMPARE(after.surface, before.surface);
    for (std::size_t k = 0; k < before.coefficients.size(); ++k)
      QVERIFY(valuesOf(after.coefficients[k]) == valuesOf(before.coefficients[k]));
    QVERIFY(valuesOf(after.values[kMelanin]) != valuesOf(before.values[kMelanin]));
  }

  void deviationsOfWhatIsNoFitAreRefused() {
    EXPECT_DONE(run_.run("edit on.exr -o edited.exr --melanin 1.2"));
    const auto edited = run_.run("spectrum --maps edited.exr --deviation");
    QCOMPARE(edited.status, 3);
    QVERIFY2(edited.errors.find("leave out --deviation") != std::string::npos,
             edited.errors.c_str());
    EXPECT_DONE(run_.run("fit cap -o network.exr --method network --weights monitor-5"));
    const auto network = run_.run("spectrum --maps network.exr --deviation");
    QCOMPARE(network.status, 2);
    QVERIFY2(network.errors.find("network") != std::string::npos, network.errors.c_str());
    QCOMPARE(run_.run("fit cap -o free.exr --free oxygenation").status, 0);
    const auto free = run_.run("spectrum --maps free.exr --deviation");
    QCOMPARE(free.status, 3);
    QVERIFY2(free.errors.find("constants found for each pixel") != std::string::npos,
             free.errors.c_str());
  }

  // Whoever does not get the usual discrepancy is told, and how to get it.
  void fitSaysWhatBecomesOfIt() {
    const auto says = [&](const QString& command, const std::string& words) {
      const auto outcome = run_.run(command);
      QCOMPARE(outcome.status, 0);
      QVERIFY2(outcome.errors.find(words) != std::string::npos, outcome.errors.c_str());
    };
    // A capture that does not say that it is simulated.
    EXPECT_DONE(run_.run("simulate --patch 48x32 -o real"));
    auto manifest = nlohmann::json::parse(run_.read("real/capture.json"));
    manifest.erase("simulated");
    std::ofstream(run_ / "real/capture.json") << manifest.dump();
    says("fit real -o x.exr --noise 0,0", "count as the model's own skin; --discrepancy on");
    says("fit real -o x.exr --free oxygenation", "the constants found for each pixel explain it");
    says("fit real -o x.exr --specular excluded", "surface reflection was removed");
    for (const char* command :
         {"fit real -o x.exr", "fit real -o x.exr --discrepancy off", "fit cap -o x.exr"}) {
      const auto silent = run_.run(command);
      QVERIFY2(silent.errors.find("leaves over") == std::string::npos, silent.errors.c_str());
    }
  }

  void wrongWordsAreRefused() {
    const auto refused = [&](const QString& command, const std::string& words) {
      const auto outcome = run_.run(command);
      QCOMPARE(outcome.status, 2);
      QVERIFY2(outcome.errors.find(words) != std::string::npos, outcome.errors.c_str());
    };
    refused("fit cap -o x.exr --discrepancy maybe", "on or off");
    refused("fit cap -o x.exr --method three-stage --discrepancy on", "only the method refined");
    refused("fit cap -o x.exr --free oxygenation --discrepancy on", "--free");
    // Whoever asks for it must not get a fit without it.
    refused("fit cap -o x.exr --profile skin2026 --discrepancy on", "such as --profile skin2026b");
    refused("spectrum --maps on.exr --at 24", "two numbers");
    refused("spectrum --deviation --params 0.02,0.5,0.02,0.01,0.001", "--maps");
    refused("spectrum --at 24,16 --params 0.02,0.5,0.02,0.01,0.001", "--maps");
    const auto outside = run_.run("spectrum --maps on.exr --at 48,0");
    QCOMPARE(outside.status, 3);
    QVERIFY2(outside.errors.find("48 × 32") != std::string::npos, outside.errors.c_str());
  }

 private:
  ProgramRun run_;
};

CUTIS_TEST(DiscrepancyTest)

}  // namespace
}  // namespace cutis::test

#include "discrepancy_test.moc"
