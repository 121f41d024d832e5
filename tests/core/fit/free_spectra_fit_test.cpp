#include "core/fit/spectra/free_spectra_fit.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <span>
#include <stop_token>
#include <vector>

#include <QtTest>

#include "core/fit/spectra/free_misfit.h"
#include "core/skin/layers/polynomial_fit.h"
#include "core/skin/layers/table.h"
#include "core/skin/profile/absorption.h"
#include "src/files/profiles/profile_file.h"
#include "tests/support/expect.h"
#include "tests/support/folders.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

const SkinModel& skin2026() {
  static const auto model =
      SkinModel::create(
          loadProfile(test::sourceFolder() / "resources/profiles/skin2026.json", "test").value())
          .value();
  return *model;
}

// 400, 410 … 700 nm, all of them on the grid.
std::vector<double> measuredWavelengths() {
  std::vector<double> nm;
  for (double w = 400.0; w <= 700.0; w += 10.0)
    nm.push_back(w);
  return nm;
}

std::vector<int> samplesOf(const std::vector<double>& nm) {
  std::vector<int> samples;
  for (const double w : nm)
    samples.push_back((static_cast<int>(w) - kFirstWavelengthNm) / kWavelengthStepNm);
  return samples;
}

struct MeasuredPerson {
  ParameterVector parameters;
  SkinConstants constants;
};

// Faces with blood enough to tell its oxygenation and melanin enough to tell where it lies.
std::vector<MeasuredPerson> measuredPeople(const FreeConstants& free, const Profile& profile,
                                           int count) {
  std::mt19937 random(3);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const bool thin = profile.layerOptics == LayerOpticsKind::addingDoubling;
  std::vector<MeasuredPerson> measuredPeople;
  for (int i = 0; i < count; ++i) {
    MeasuredPerson person;
    person.parameters << between(0.01, 0.15), between(0.2, 0.9), between(0.02, 0.1),
        between(0.005, 0.04), between(0.0005, 0.003);
    person.constants = constantsOf(profile);
    if (free.oxygenation) person.constants.oxygenation = between(0.3, 0.9);
    if (free.thickness)
      person.constants.thicknessMm = thin ? between(0.05, 0.25) : between(0.3, 0.45);
    measuredPeople.push_back(person);
  }
  return measuredPeople;
}

// By models made for each person's constants.
std::vector<double> freeSpectraOf(const Profile& profile,
                                  const std::vector<MeasuredPerson>& measuredPeople,
                                  const std::vector<double>& nm, double noise = 0.0) {
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  const std::vector<int> samples = samplesOf(nm);
  std::vector<double> values;
  for (const MeasuredPerson& person : measuredPeople) {
    const Profile own = withConstants(profile, person.constants);
    const AbsorptionLaw law(own);
    const bool diffuses = own.layerOptics == LayerOpticsKind::diffusion;
    const auto optics = diffuses ? makeDiffusionOptics(own)
                                 : makeTabulatedOptics(std::make_shared<const LayerTable>(
                                       LayerTable::make(own, samples).value()));
    for (const int sample : samples) {
      const LayerPair absorption = law.at(sample, person.parameters);
      values.push_back(optics->reflectance(sample, absorption.epidermal, absorption.dermal) +
                       noise * normal(random));
    }
  }
  return values;
}

class FreeSpectraFitTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void findsWhatIsFree_data() {
    QTest::addColumn<bool>("transfer");
    QTest::addColumn<bool>("oxygenation");
    QTest::addColumn<bool>("thickness");
    for (const bool transfer : {false, true}) {
      const char* const name = transfer ? "skin2026" : "li2024";
      QTest::addRow("%s, oxygenation", name) << transfer << true << false;
      QTest::addRow("%s, thickness", name) << transfer << false << true;
      QTest::addRow("%s, both", name) << transfer << true << true;
    }
  }
  void findsWhatIsFree() {
    QFETCH(bool, transfer);
    QFETCH(bool, oxygenation);
    QFETCH(bool, thickness);
    const SkinModel& model = transfer ? skin2026() : test::li2024();
    const FreeConstants free = {oxygenation, thickness};
    const auto crowd = measuredPeople(free, model.profile(), 40);
    const auto nm = measuredWavelengths();
    const auto spectra = freeSpectraOf(model.profile(), crowd, nm);
    const auto fits = fitSpectraFreely(model, nm, spectra, free, {}).value();
    double misfit = 0.0;
    std::vector<double> ofOxygenation, ofThickness;
    for (std::size_t i = 0; i < crowd.size(); ++i) {
      misfit = std::max(misfit, fits[i].fit.rmse);
      ofOxygenation.push_back(
          std::abs(fits[i].constants.oxygenation - crowd[i].constants.oxygenation));
      ofThickness.push_back(
          std::abs(std::log(fits[i].constants.thicknessMm / crowd[i].constants.thicknessMm)));
    }
    // Diffusion is exact; the tables of radiative transfer are not, and a thickness shows it.
    EXPECT_AT_MOST(misfit, transfer ? 2e-5 : 1e-9);
    EXPECT_AT_MOST(std::ranges::max(ofOxygenation), transfer ? 0.005 : 1e-6);
    EXPECT_AT_MOST(std::ranges::max(ofThickness), transfer ? 0.02 : 1e-6);
  }

  void slopesAreThoseOfTheMisfit() {
    using Misfit = FreeMisfit<7>;
    for (const SkinModel* model : {&test::li2024(), &skin2026()}) {
      const ParameterAxes& axes = model->profile().axes;
      for (const double edgeLoss : {0.0, 0.4}) {
        const auto misfit =
            Misfit::make(*model, measuredWavelengths(), {true, true}, edgeLoss, {}).value();
        const std::vector<double> measured(measuredWavelengths().size(), 0.3);
        Misfit::Set set;
        set << 0.05, 0.4, 0.06, 0.03, 0.002, 0.55, 0.45;
        const auto cost = [&](int k, double step) {
          Misfit::Set moved = set;
          moved[k] += step;
          return misfit.equations({{moved}}, {{measured.data()}})[0].cost;
        };
        const EquationsOf<7> equations = misfit.equations({{set}}, {{measured.data()}})[0];
        for (const int k : {2, 3, 4, 5, 6}) {
          const double range =
              k < kParameterCount ? axes[static_cast<std::size_t>(k)].maximum : 1.0;
          const double step = 1e-5 * range;
          const double difference = (cost(k, step) - cost(k, -step)) / 2e-5;
          EXPECT_NEAR(-2.0 * equations.downhill[k], difference,
                      1e-5 * (1.0 + std::abs(difference)));
        }
      }
    }
  }

  void neverWorseAndWithinBounds() {
    const auto nm = measuredWavelengths();
    for (const SkinModel* model : {&test::li2024(), &skin2026()}) {
      const Profile& profile = model->profile();
      const ThicknessRange range = thicknessRange(profile).value();
      auto spectra = freeSpectraOf(profile, measuredPeople({}, profile, 20), nm, 0.01);
      // No skin at all, and as bright as nothing.
      spectra.insert(spectra.end(), nm.size(), 0.5);
      spectra.insert(spectra.end(), nm.size(), 0.0);
      const auto own = fitSpectra(*model, nm, spectra, {}).value();
      const auto fits = fitSpectraFreely(*model, nm, spectra, {true, true}, {}).value();
      for (std::size_t i = 0; i < own.size(); ++i) {
        EXPECT_AT_MOST(fits[i].fit.rmse, own[i].rmse + 2e-5);
        const SkinConstants& found = fits[i].constants;
        QVERIFY(found.oxygenation >= 0.0 && found.oxygenation <= 1.0);
        QVERIFY(found.thicknessMm >= range.lowMm && found.thicknessMm <= range.highMm);
        for (const Parameter k : kParameters) {
          QVERIFY(fits[i].fit.parameters[k] >= 0.0);
          QVERIFY(fits[i].fit.parameters[k] <= profile.axes[k].maximum);
        }
      }
    }
  }

  void nothingFreeIsTheFitOfFive() {
    const auto nm = measuredWavelengths();
    const auto spectra = freeSpectraOf(skin2026().profile(),
                                       measuredPeople({true, true}, skin2026().profile(), 20), nm);
    const auto five = fitSpectra(skin2026(), nm, spectra, {}).value();
    const auto fits = fitSpectraFreely(skin2026(), nm, spectra, {}, {}).value();
    for (std::size_t i = 0; i < five.size(); ++i) {
      QVERIFY((fits[i].fit.parameters == five[i].parameters).all());
      QVERIFY(fits[i].fit.rmse == five[i].rmse);
      QVERIFY(fits[i].constants.thicknessMm == skin2026().profile().epidermalThicknessMm);
    }
  }

  void aResultIsItsOwnSpectrumsAlone() {
    const auto nm = measuredWavelengths();
    const Profile& profile = skin2026().profile();
    const auto spectra =
        freeSpectraOf(profile, measuredPeople({true, true}, profile, 20), nm, 0.005);
    const auto together = fitSpectraFreely(skin2026(), nm, spectra, {true, true}, {}).value();
    for (const std::size_t i : {0U, 15U, 16U, 19U}) {
      const std::span<const double> one(spectra.data() + i * nm.size(), nm.size());
      const auto alone = fitSpectraFreely(skin2026(), nm, one, {true, true}, {}).value()[0];
      QVERIFY((alone.fit.parameters == together[i].fit.parameters).all());
      QVERIFY(alone.constants.oxygenation == together[i].constants.oxygenation);
      QVERIFY(alone.constants.thicknessMm == together[i].constants.thicknessMm);
    }
  }

  void eachNumberAsksForAWavelength() {
    QCOMPARE(fewestWavelengths({}), std::size_t{5});
    QCOMPARE(fewestWavelengths({true, false}), std::size_t{6});
    QCOMPARE(fewestWavelengths({true, true}), std::size_t{7});
  }

  void stopsWhenAsked() {
    std::stop_source source;
    source.request_stop();
    JobContext context;
    context.stop = source.get_token();
    const auto nm = measuredWavelengths();
    const std::vector<double> spectrum(nm.size(), 0.3);
    QVERIFY(fitSpectraFreely(skin2026(), nm, spectrum, {true, true}, context).cancelled());
  }
};

CUTIS_TEST(FreeSpectraFitTest)

}  // namespace
}  // namespace cutis

#include "free_spectra_fit_test.moc"
