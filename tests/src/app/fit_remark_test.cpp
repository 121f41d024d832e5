#include "src/app/open/fit_remark.h"

#include <algorithm>

#include <QtTest>

#include "src/files/profiles/profile_file.h"
#include "src/files/rig_file.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

using Kind = FitRemark::Kind;

FitStatistics settled() {
  FitStatistics statistics;
  statistics.pixels.total = statistics.pixels.solved = 1000;
  return statistics;
}

std::vector<Kind> kindsOf(const std::vector<FitRemark>& remarks) {
  std::vector<Kind> kinds;
  for (const FitRemark& remark : remarks)
    kinds.push_back(remark.kind);
  return kinds;
}

class FitRemarkTest : public QObject {
  Q_OBJECT

 private slots:
  void ofAnOrdinaryFitThereIsNothingToSay() {
    QVERIFY(remarksOn(settled(), {}, FitMethod::refined, NoiseModel{1e-4, 5e-3}, {}, {}).empty());
  }

  void eachFactIsSaidWithoutOptions() {
    FitStatistics rough = settled();
    rough.pixels.noConvergence = 20;
    rough.meanResidual = 0.01;
    const std::vector<ConstantSummary> constants = {{kOxygenation, 0.6, 0.4, 0.8, 0.9},
                                                    {kThickness, 0.1, 0.1, 0.1, 0.2}};
    const auto remarks = remarksOn(rough, constants, FitMethod::refined, NoiseModel{0.0, 0.0}, 0.2,
                                   ExposureChoice{0.7, 1.0});
    QVERIFY(kindsOf(remarks) ==
            (std::vector{Kind::exposureChosen, Kind::notSettled, Kind::outsideDiffusion,
                         Kind::mostlyAssumed, Kind::inexact}));
    for (const FitRemark& remark : remarks)
      QVERIFY2(remark.sentence.find("--") == std::string::npos, remark.sentence.c_str());
  }

  void ofAnExposureThatStaysThereIsNothingToSay() {
    QVERIFY(remarksOn(settled(), {}, FitMethod::refined, NoiseModel{1e-4, 5e-3}, {},
                      ExposureChoice{1.0, 0.4})
                .empty());
  }

  void whatBecomesOfTheDiscrepancyIsSaid() {
    const Profile profile = loadProfile("skin2026b", "test").value();
    Measurements measurements;
    measurements.rig = loadRig("monitor", "", "test").value();
    const auto kindOf = [&](const FitOptions& options) {
      const auto remark = remarkOnDiscrepancy(profile, measurements, options);
      return remark ? std::optional(remark->kind) : std::nullopt;
    };
    FitOptions options;
    QVERIFY(!kindOf(options));
    options.surface = SurfaceLight::removed;
    QVERIFY(kindOf(options) == Kind::discrepancyOfSurface);
    options = {};
    options.free.oxygenation = true;
    QVERIFY(kindOf(options) == Kind::discrepancyUnknown);
    options = {};
    options.noise = NoiseModel{0.0, 0.0};
    QVERIFY(kindOf(options) == Kind::discrepancyOff);
    options = {};
    options.noise = NoiseModel{0.0, 0.0};
    options.discrepancy = false;
    QVERIFY(!kindOf(options));
    options.discrepancy.reset();
    measurements.isSimulated = true;
    QVERIFY(!kindOf(options));
    measurements.isSimulated = false;
    options = {};
    options.method = FitMethod::network;
    QVERIFY(!kindOf(options));
  }

  void nothingFittedIsOneOfThem() {
    FitStatistics none;
    none.pixels.total = none.pixels.masked = 10;
    QVERIFY(kindsOf(remarksOn(none, {}, FitMethod::network, {}, {}, {})) ==
            std::vector{Kind::nothingFitted});
  }
};

CUTIS_TEST(FitRemarkTest)

}  // namespace
}  // namespace cutis

#include "fit_remark_test.moc"
