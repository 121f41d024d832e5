// A study finds the constant that made the spectra, knows how far it can be believed, and does not
// depend on anything but its seed.

#include "core/calibrate/calibration_study.h"

#include <cmath>

#include <QtTest>

#include "core/fit/population.h"
#include "core/skin/model/instrument_model.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

constexpr double kStudiedThickness = 0.21;
constexpr double kStudiedShare = 0.03;
constexpr int kStudyPeople = 12;

Profile withThickness(double thicknessMm) {
  Profile profile = test::li2024().profile();
  profile.epidermalThicknessMm = thicknessMm;
  return profile;
}

// Skin of that thickness with a shine, every 10 nm.
MeasuredSpectra studiedSpectraOf(double fromNm, double toNm) {
  const Profile profile = withThickness(kStudiedThickness);
  const SkinModel skin(profile);
  const InstrumentModel model(
      skin, measurementGeometry(SpecularPart::included, profile.refractiveIndex, kStudiedShare));
  MeasuredSpectra spectra;
  for (double nm = fromNm; nm <= toNm; nm += 10.0)
    spectra.wavelengthsNm.push_back(nm);
  for (const ParameterVector& person : drawPopulation(protocolPopulation(), kStudyPeople, 9)) {
    spectra.ids.push_back(std::to_string(spectra.ids.size()));
    const Spectrum spectrum = model.reflectance(person);
    for (const double nm : spectra.wavelengthsNm) {
      const auto sample = std::lround((nm - kFirstWavelengthNm) / kWavelengthStepNm);
      spectra.reflectances.push_back(spectrum[static_cast<Eigen::Index>(sample)]);
    }
  }
  return spectra;
}

CalibrationStudy studyOf(const MeasuredSpectra& spectra) {
  CalibrationStudy study;
  study.spectra = {
      {spectra, SpecularPart::included, 0.05, 0.0, {{400.0, 700.0, 0.005}, {340.0, 400.0, 0.012}}}};
  study.constants = {{{"thickness", 0.1, 0.4, 0.25, 0.5, true}, 0.25, {}},
                     {{"share", 0.0, 0.1, 0.04, 0.05, false}, 0.05, 0}};
  study.profileAt = [](std::span<const double> constants) -> Result<Profile> {
    return withThickness(constants[0]);
  };
  study.pull = 1e-4;
  study.priorNoise = 0.002;
  study.colorRig = test::albedoRig();
  return study;
}

class CalibrationStudyTest : public QObject {
  Q_OBJECT

 private slots:
  void constantsAndIntervalsAreFound() {
    CalibrationStudy study = studyOf(studiedSpectraOf(340.0, 760.0));
    study.halvings = 1;
    study.bootstraps = 3;
    const auto figures = runStudy(study, {});
    EXPECT_OK(figures);
    const CalibrationFigures& found = figures.value();
    QCOMPARE(found.constants.size(), std::size_t{2});
    EXPECT_NEAR(found.constants[0].value, kStudiedThickness, 0.005);
    EXPECT_NEAR(found.constants[1].value, kStudiedShare, 0.003);
    for (const ConstantFigures& constant : found.constants)
      QVERIFY(constant.low <= constant.high);
    EXPECT_NEAR(found.constants[0].low, kStudiedThickness, 0.02);
    QCOMPARE(found.errors.size(), std::size_t{1});
    for (const JudgedRange range :
         {JudgedRange::fitted, JudgedRange::ultraviolet, JudgedRange::fromColor}) {
      const CalibrationError& error = found.errors[0][static_cast<std::size_t>(range)];
      QVERIFY(error.all >= 0.0 && error.leftOut >= 0.0 && error.worst >= error.leftOut);
    }
    EXPECT_AT_MOST(found.errors[0][0].all, 1e-3);
    EXPECT_OK(validate(found.prior, "prior"));
  }

  void withoutRepetitionsThereIsNoTelling() {
    const auto figures = runStudy(studyOf(studiedSpectraOf(340.0, 700.0)), {});
    EXPECT_OK(figures);
    QVERIFY(std::isnan(figures.value().constants[0].low));
    QVERIFY(std::isnan(figures.value().errors[0][0].leftOut));
    // Beyond 700 nm nothing was measured.
    const auto infrared = static_cast<std::size_t>(JudgedRange::nearInfrared);
    QVERIFY(std::isnan(figures.value().errors[0][infrared].all));
  }

  void theSeedDecidesAndErrorsEndIt() {
    CalibrationStudy study = studyOf(studiedSpectraOf(340.0, 700.0));
    study.bootstraps = 2;
    const auto once = runStudy(study, {}), again = runStudy(study, {});
    EXPECT_OK(once);
    EXPECT_OK(again);
    EXPECT_NEAR(once.value().constants[0].low, again.value().constants[0].low, 0.0);
    study.profileAt = [](std::span<const double>) -> Result<Profile> {
      return inputError("here", "no such profile");
    };
    EXPECT_ERROR(runStudy(study, {}), "here: no such profile");
    std::stop_source source;
    source.request_stop();
    QVERIFY(runStudy(studyOf(studiedSpectraOf(340.0, 700.0)), {source.get_token(), {}, {}})
                .cancelled());
  }
};

CUTIS_TEST(CalibrationStudyTest)

}  // namespace
}  // namespace cutis

#include "calibration_study_test.moc"
