// Skin that a model made validates that model; what is measured decides what is judged.

#include "core/evaluate/validation.h"

#include <cmath>

#include <QtTest>

#include "core/fit/population.h"
#include "core/skin/model/instrument_model.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

constexpr int kPeople = 6;

// The model's own skin, every 10 nm.
MeasuredSpectra ownSkin(double fromNm, double toNm, const MeasurementGeometry& geometry = {}) {
  const InstrumentModel model(test::li2024(), geometry);
  MeasuredSpectra spectra;
  for (double nm = fromNm; nm <= toNm; nm += 10.0)
    spectra.wavelengthsNm.push_back(nm);
  for (const ParameterVector& person : drawPopulation(protocolPopulation(), kPeople, 5)) {
    spectra.ids.push_back(std::to_string(spectra.ids.size()));
    const Spectrum spectrum = model.reflectance(person);
    for (const double nm : spectra.wavelengthsNm) {
      const auto sample = std::lround((nm - kFirstWavelengthNm) / kWavelengthStepNm);
      spectra.reflectances.push_back(spectrum[static_cast<Eigen::Index>(sample)]);
    }
  }
  return spectra;
}

Result<ValidationFigures> validated(const MeasuredSpectra& spectra,
                                    const MeasurementGeometry& geometry = {}) {
  return validateModel(test::li2024(), spectra, geometry, test::albedoRig(), {});
}

class ValidationTest : public QObject {
  Q_OBJECT

 private slots:
  void ownSkinIsDescribedAndPredicted() {
    const auto figures = validated(ownSkin(320.0, 1000.0));
    EXPECT_OK(figures);
    EXPECT_AT_MOST(figures.value().fitted.most, 1e-6);
    EXPECT_AT_MOST(figures.value().ultraviolet.most, 0.01);
    EXPECT_AT_MOST(figures.value().nearInfrared.most, 0.01);
    QVERIFY(figures.value().fromColor.median > 0.0);
    std::size_t all = 0;
    double lightest = 0.0;
    for (const ToneResiduals& tone : figures.value().tones) {
      QVERIFY(tone.darkest >= lightest && tone.lightest >= tone.darkest);
      lightest = tone.lightest;
      QCOMPARE(tone.mean.size(), std::size_t{69});
      all += tone.spectra;
    }
    QCOMPARE(all, std::size_t{kPeople});
  }

  void theWrongGeometryLeavesAnError() {
    const auto shiny = measurementGeometry(SpecularPart::included, 1.4, 0.05);
    const MeasuredSpectra spectra = ownSkin(400.0, 700.0, shiny);
    const auto right = validated(spectra, shiny), wrong = validated(spectra);
    EXPECT_OK(right);
    EXPECT_OK(wrong);
    EXPECT_AT_MOST(right.value().fitted.most, 1e-6);
    QVERIFY(wrong.value().fitted.mean > 1e-4);
  }

  void whatIsNotMeasuredIsNotJudged() {
    const MeasuredSpectra visible = ownSkin(410.0, 690.0);
    QVERIFY(!measuredPart(visible, kUltravioletRange) &&
            !measuredPart(visible, kNearInfraredRange));
    const auto figures = validated(visible);
    EXPECT_OK(figures);
    QVERIFY(std::isnan(figures.value().ultraviolet.mean));
    QVERIFY(std::isnan(figures.value().nearInfrared.most));
    QVERIFY(std::isnan(figures.value().fromColor.median));
    const auto part = measuredPart(ownSkin(380.0, 760.0), kUltravioletRange);
    QVERIFY(part);
    EXPECT_NEAR(part->fromNm, 380.0, 0.0);
    EXPECT_NEAR(part->toNm, 400.0, 0.0);
  }

  void distributionsAreOfSortedErrors() {
    std::vector<double> errors;
    for (int i = 100; i >= 1; --i)
      errors.push_back(i);
    const ErrorDistribution distribution = distributionOf(errors);
    EXPECT_NEAR(distribution.mean, 50.5, 1e-12);
    EXPECT_NEAR(distribution.median, 50.5, 0.0);
    EXPECT_NEAR(distribution.within95, 95.0, 0.0);
    EXPECT_NEAR(distribution.most, 100.0, 0.0);
    EXPECT_NEAR(distributionOf({3.0}).within95, 3.0, 0.0);
    QVERIFY(std::isnan(distributionOf({}).mean));
  }

  void stopsWhenAsked() {
    std::stop_source source;
    source.request_stop();
    const auto stopped = validateModel(test::li2024(), ownSkin(400.0, 700.0), {}, test::albedoRig(),
                                       {source.get_token(), {}, {}});
    QVERIFY(stopped.cancelled());
  }
};

CUTIS_TEST(ValidationTest)

}  // namespace
}  // namespace cutis

#include "validation_test.moc"
