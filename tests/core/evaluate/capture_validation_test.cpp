// Spectra that are photographed by arithmetic: the channels are the sums they should be, the fit
// finds a model's own skin again, and figures are those of numbers that can be worked out by hand.

#include "core/evaluate/capture_validation.h"

#include <cmath>

#include <QtTest>
#include <tbb/global_control.h>

#include "core/base/random.h"
#include "core/fit/population.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

constexpr int kCapturedPeople = 40;

// The paper's skin on the whole grid.
const MeasuredSpectra& capturedSkin() {
  static const MeasuredSpectra spectra = [] {
    MeasuredSpectra made;
    for (int sample = 0; sample < kSampleCount; ++sample)
      made.wavelengthsNm.push_back(wavelengthNm(sample));
    for (const ParameterVector& person : drawPopulation(protocolPopulation(), kCapturedPeople, 3)) {
      made.ids.push_back(std::to_string(made.ids.size()));
      const Spectrum spectrum = test::li2024().reflectance(person);
      made.reflectances.insert(made.reflectances.end(), spectrum.begin(), spectrum.end());
    }
    return made;
  }();
  return spectra;
}

std::vector<std::size_t> everySpectrum(const MeasuredSpectra& spectra) {
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < spectra.ids.size(); ++i)
    all.push_back(i);
  return all;
}

std::shared_ptr<const SkinModel> sharedModel() {
  return std::make_shared<const SkinModel>(test::li2024().profile());
}

Result<EstimatedSpectra> fitted(const FitOptions& options, const Eigen::MatrixXd& channels,
                                const MeasurementGeometry& geometry = {}) {
  return fitPhotographs(sharedModel(), test::monitorRig(), options, channels,
                        everySpectrum(capturedSkin()), geometry, capturedSkin().wavelengthsNm, {});
}

// Three people, the last with two spectra, at 390 to 710 nm; each is as bright as told.
MeasuredSpectra flatSpectra(const std::vector<double>& values) {
  MeasuredSpectra spectra;
  spectra.ids = {"a", "b", "c", "c"};
  spectra.wavelengthsNm = {390.0, 400.0, 500.0, 600.0, 700.0, 710.0};
  for (const double value : values)
    spectra.reflectances.insert(spectra.reflectances.end(), spectra.wavelengthsNm.size(), value);
  return spectra;
}

class CaptureValidationTest : public QObject {
  Q_OBJECT

 private slots:
  void channelsAreSumsOfReflectance() {
    const SpectrumRows rows = responseRows(test::monitorRig());
    const MeasurementGeometry shiny{0.03, 0.95, 0.0};
    const auto plain = photographSpectra(test::monitorRig(), capturedSkin(), {}, 0.0, 1);
    const auto below = photographSpectra(test::monitorRig(), capturedSkin(), shiny, 0.0, 1);
    for (std::size_t i = 0; i < kCapturedPeople; ++i) {
      const Eigen::VectorXd exact = rows.matrix() * onGrid(capturedSkin(), i).matrix();
      const auto column = static_cast<Eigen::Index>(i);
      EXPECT_AT_MOST((plain.col(column) - exact).cwiseAbs().maxCoeff(), 1e-12);
      const Eigen::VectorXd taken = (exact.array() - 0.03) / 0.95;
      EXPECT_AT_MOST((below.col(column) - taken).cwiseAbs().maxCoeff(), 1e-12);
    }
  }

  void noiseIsProportionalAndSeeded() {
    const auto take = [](double noise, std::uint64_t key) {
      return photographSpectra(test::monitorRig(), capturedSkin(), {}, noise, key);
    };
    const Eigen::ArrayXXd relative = take(0.01, 5).array() / take(0.0, 5).array() - 1.0;
    EXPECT_NEAR(relative.mean(), 0.0, 0.002);
    EXPECT_NEAR(std::sqrt(relative.square().mean()), 0.01, 0.002);
    QVERIFY(take(0.01, 5) == take(0.01, 5));
    QVERIFY(take(0.01, 5) != take(0.01, 6));
  }

  void rigsAreBlindWhereNothingWasMeasured() {
    const Rig within = rigWithin(test::albedoRig(), {400.0, 700.0});
    const SpectrumRows rows = responseRows(within);
    EXPECT_NEAR(rows.leftCols(50).abs().maxCoeff(), 0.0, 0.0);
    EXPECT_NEAR(rows.rightCols(150).abs().maxCoeff(), 0.0, 0.0);
    EXPECT_NEAR(rows.row(1).sum(), 1.0, 1e-12);
    QCOMPARE(fingerprint(rigWithin(test::albedoRig(), {300.0, 1000.0})),
             fingerprint(test::albedoRig()));
  }

  void spectraAreReadBetweenWavelengths() {
    MeasuredSpectra spectra = flatSpectra({0.1, 0.2, 0.3, 0.4});
    spectra.reflectances[2] = 0.5;  // of a, at 500 nm
    const Eigen::MatrixXd values =
        resampled(spectra, std::vector{380.0, 400.0, 450.0, 500.0, 710.0});
    QVERIFY(std::isnan(values(0, 0)));
    EXPECT_NEAR(values(1, 0), 0.1, 1e-15);
    EXPECT_NEAR(values(2, 0), 0.3, 1e-15);
    EXPECT_NEAR(values(3, 0), 0.5, 1e-15);
    EXPECT_NEAR(values(4, 3), 0.4, 1e-15);
  }

  void ownSkinIsFoundAgain() {
    FitOptions options;
    options.noise = NoiseModel{0.0, 0.0, 0.0};
    for (const MeasurementGeometry& geometry :
         {MeasurementGeometry{}, MeasurementGeometry{0.03, 0.95, 0.0}}) {
      const auto exact =
          fitted(options, photographSpectra(test::monitorRig(), capturedSkin(), geometry, 0.0, 1),
                 geometry);
      EXPECT_OK(exact);
      const auto figures =
          captureFigures(kFittedRange, capturedSkin(), exact.value(), peopleOf(capturedSkin()));
      // Light that is no skin of the model's is another matter.
      if (geometry.specularShare > 0.0) {
        EXPECT_AT_MOST(figures.median, 0.02);
      } else {
        EXPECT_AT_MOST(figures.median, 2e-4);
      }
    }
  }

  // Two deviations hold 95 in 100 people who are as the prior says.
  void deviationsHoldWhatTheyPromise() {
    FitOptions options;
    options.prior = test::li2024().profile().prior;
    options.noise = NoiseModel{0.0001, 0.005, 0.0};
    const auto found =
        fitted(options, photographSpectra(test::monitorRig(), capturedSkin(), {}, 0.005, 1));
    EXPECT_OK(found);
    const auto figures =
        captureFigures(kFittedRange, capturedSkin(), found.value(), peopleOf(capturedSkin()));
    EXPECT_AT_MOST(figures.median, 0.004);
    EXPECT_NEAR(figures.coverage, 0.955, 0.045);
  }

  // What the discrepancy leaves over has a share in the channels; a fit that takes these for exact
  // makes something else of it.
  void deviationsHoldWhatTheRestMakesOfChannels() {
    Profile profile = test::li2024().profile();
    profile.prior.deviation *= 0.3;
    Discrepancy known;
    known.components = Eigen::MatrixXd::Zero(kSampleCount, 1);
    known.rest = Eigen::MatrixXd::Zero(kSampleCount, 4);
    for (int i = 0; i < kSampleCount; ++i) {
      known.components(i, 0) = 0.01 * std::sin(i / 9.0);
      for (int k = 0; k < 4; ++k)
        known.rest(i, k) = 0.004 * std::sin(i / (5.0 + 3.0 * k) + k);
    }
    known.slope = Eigen::MatrixXd::Zero(1, kParameterCount);
    known.covariance = Eigen::MatrixXd::Identity(1, 1);
    known.prior = profile.prior;
    profile.discrepancies.surfaceIncluded = known;
    const auto model = std::make_shared<const SkinModel>(profile);
    MeasuredSpectra skin = capturedSkin();
    skin.reflectances.clear();
    Random random(5);
    for (const ParameterVector& person :
         drawFromPrior(known.prior, profile.axes, kCapturedPeople, 5)) {
      Eigen::VectorXd unseen(4);
      for (double& value : unseen)
        value = random.normal();
      const Eigen::VectorXd z = Eigen::VectorXd::Constant(1, random.normal());
      const Spectrum spectrum =
          model->reflectance(person) * (known.factor(z) + (known.rest * unseen).array());
      skin.reflectances.insert(skin.reflectances.end(), spectrum.begin(), spectrum.end());
    }
    FitOptions options;
    options.noise = NoiseModel{0.0, 0.0, 0.0};
    options.discrepancy = true;
    const auto found = fitPhotographs(model, test::monitorRig(), options,
                                      photographSpectra(test::monitorRig(), skin, {}, 0.0, 1),
                                      everySpectrum(skin), {}, skin.wavelengthsNm, {});
    EXPECT_OK(found);
    for (const WavelengthRange& range : kCaptureRanges) {
      const auto figures = captureFigures(range, skin, found.value(), peopleOf(skin));
      EXPECT_NEAR(figures.coverage, 0.955, 0.06);
    }
  }

  void threadsChangeNothing() {
    FitOptions options;
    options.noise = NoiseModel{0.0001, 0.005, 0.0};
    const auto channels = photographSpectra(test::monitorRig(), capturedSkin(), {}, 0.005, 1);
    const auto all = fitted(options, channels);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const auto alone = fitted(options, channels);
    EXPECT_OK(all);
    EXPECT_OK(alone);
    QVERIFY(all.value().reflectance == alone.value().reflectance);
    QVERIFY(all.value().deviation == alone.value().deviation);
  }

  void figuresAreOverPeople() {
    const MeasuredSpectra spectra = flatSpectra({0.1, 0.2, 0.3, 0.4});
    const auto people = peopleOf(spectra);
    QCOMPARE(people.size(), std::size_t{3});
    QVERIFY(people[2] == (std::vector<std::size_t>{2, 3}));
    QVERIFY(toneThirdsOf(spectra, people) == (std::vector<std::size_t>{0, 1, 2}));
    EstimatedSpectra estimated;
    estimated.reflectance = resampled(spectra, spectra.wavelengthsNm);
    estimated.reflectance.col(0).array() += 0.01;
    estimated.reflectance.col(1).array() -= 0.02;
    estimated.reflectance.col(2).array() += 0.03;
    estimated.reflectance.col(3).array() += 0.04;
    const auto blind = captureFigures(kFittedRange, spectra, estimated, people);
    const double last = std::sqrt((0.03 * 0.03 + 0.04 * 0.04) / 2.0);
    EXPECT_NEAR(blind.median, 0.02, 1e-12);
    EXPECT_NEAR(blind.within95, last, 1e-12);
    EXPECT_NEAR(blind.worst, last, 1e-12);
    QVERIFY(std::isnan(blind.coverage));
    estimated.deviation = Eigen::MatrixXd::Constant(6, 4, 0.011);
    EXPECT_NEAR(captureFigures(kFittedRange, spectra, estimated, people).coverage, 0.5, 1e-12);
    const auto errors = medianErrors(spectra, estimated, people);
    QCOMPARE(errors.size(), std::size_t{6});
    EXPECT_NEAR(errors.front(), 0.02, 1e-12);
  }

  void whatIsNotKnownHasNoFigure() {
    const MeasuredSpectra spectra = flatSpectra({0.1, 0.2, 0.3, 0.4});
    const auto people = peopleOf(spectra);
    EstimatedSpectra estimated;
    estimated.reflectance = resampled(spectra, spectra.wavelengthsNm);
    estimated.reflectance.row(0).setConstant(std::nan(""));
    EXPECT_NEAR(captureFigures(kFittedRange, spectra, estimated, people).median, 0.0, 0.0);
    QVERIFY(std::isnan(captureFigures(kUltravioletRange, spectra, estimated, people).median));
    QVERIFY(std::isnan(medianErrors(spectra, estimated, people).front()));
    QVERIFY(std::isnan(captureFigures(kFittedRange, spectra, estimated, {}).median));
  }

  void stopsOnDemand() {
    std::stop_source source;
    source.request_stop();
    const auto channels = photographSpectra(test::monitorRig(), capturedSkin(), {}, 0.0, 1);
    QVERIFY(fitPhotographs(sharedModel(), test::monitorRig(), {}, channels,
                           everySpectrum(capturedSkin()), {}, capturedSkin().wavelengthsNm,
                           {source.get_token(), {}, {}})
                .cancelled());
  }
};

CUTIS_TEST(CaptureValidationTest)

}  // namespace
}  // namespace cutis

#include "capture_validation_test.moc"
