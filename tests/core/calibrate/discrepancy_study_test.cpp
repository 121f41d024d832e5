// What was learned does not depend on whether the instrument saw the surface's reflection, and
// people left out are estimated better with it, in every range that was measured.

#include "core/calibrate/discrepancy_study.h"

#include <cmath>
#include <numbers>

#include <QtTest>

#include "core/base/random.h"
#include "core/fit/population.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

constexpr int kStudied = 24;
constexpr double kShare = 0.04;

// People of li2024 whose skin differs from the model by a wave, everybody's alike but for its
// height.
DiscrepancyStudy madeStudy(SpecularPart part) {
  const SkinModel& model = test::li2024();
  const Profile& profile = model.profile();
  const auto geometry = measurementGeometry(part, profile.refractiveIndex, kShare);
  Prior prior = profile.prior;
  prior.deviation *= 0.5;
  Random random(6);
  DiscrepancyStudy study;
  study.profile = profile;
  study.spectra.specular = part;
  study.spectra.specularShare = kShare;
  study.components = 3;
  MeasuredSpectra& spectra = study.spectra.spectra;
  for (int wavelength = 350; wavelength <= 750; wavelength += 10)
    spectra.wavelengthsNm.push_back(wavelength);
  for (const ParameterVector& person : drawFromPrior(prior, profile.axes, kStudied, 4)) {
    const double height = 0.05 + 0.02 * random.normal();
    spectra.ids.push_back("someone");
    for (const double wavelength : spectra.wavelengthsNm) {
      const int sample = static_cast<int>(wavelength - kFirstWavelengthNm) / kWavelengthStepNm;
      const double wave = std::sin(2.0 * std::numbers::pi * wavelength / 80.0);
      spectra.reflectances.push_back(measuredReflectance(
          geometry, model.reflectanceAt(sample, person) * (1.0 + height * wave)));
    }
  }
  return study;
}

double farthest(const Discrepancy& a, const Discrepancy& b) {
  const Eigen::MatrixXd spreadOfA = a.components * a.components.transpose();
  const Eigen::MatrixXd spreadOfB = b.components * b.components.transpose();
  return std::max((a.mean - b.mean).abs().maxCoeff(),
                  (spreadOfA - spreadOfB).cwiseAbs().maxCoeff());
}

class DiscrepancyStudyTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void theInstrumentsSurfaceDoesNotMatter() {
    const auto included = runDiscrepancyStudy(madeStudy(SpecularPart::included), {});
    const auto excluded = runDiscrepancyStudy(madeStudy(SpecularPart::excluded), {});
    EXPECT_OK(included);
    EXPECT_OK(excluded);
    const Discrepancies& one = included.value().discrepancies;
    const Discrepancies& other = excluded.value().discrepancies;
    EXPECT_NEAR(farthest(*one.surfaceIncluded, *other.surfaceIncluded), 0.0, 1e-6);
    EXPECT_NEAR(farthest(*one.surfaceRemoved, *other.surfaceRemoved), 0.0, 1e-6);
    QVERIFY(farthest(*one.surfaceIncluded, *one.surfaceRemoved) > 1e-3);
    QVERIFY(included.value().gains.empty());
  }

  void peopleLeftOutGain() {
    DiscrepancyStudy study = madeStudy(SpecularPart::excluded);
    study.channels = {{test::monitorRig(), 0.0}, {test::monitorRig(), 0.005}};
    study.halvings = 1;
    QCOMPARE(fewestToHalve(study), std::size_t{16});
    const auto figures = runDiscrepancyStudy(study, {});
    EXPECT_OK(figures);
    QCOMPARE(figures.value().gains.size(), std::size_t{2});
    for (const auto& gains : figures.value().gains) {
      const auto& visible = gains[static_cast<std::size_t>(GainRange::visible)];
      EXPECT_AT_MOST(visible.with, 0.6 * visible.without);
    }
    study.spectra.specularShare = 0.02;  // taken from the study, not from the profile
    QVERIFY(farthest(*runDiscrepancyStudy(study, {}).value().discrepancies.surfaceIncluded,
                     *figures.value().discrepancies.surfaceIncluded) > 1e-3);
  }

  void stops() {
    std::stop_source source;
    source.request_stop();
    QVERIFY(runDiscrepancyStudy(madeStudy(SpecularPart::included), {source.get_token(), {}, {}})
                .cancelled());
  }
};

CUTIS_TEST(DiscrepancyStudyTest)

}  // namespace
}  // namespace cutis

#include "discrepancy_study_test.moc"
