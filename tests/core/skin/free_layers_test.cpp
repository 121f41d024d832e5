// Layers and blood with free constants against models that are made for those constants.

#include "core/skin/free/free_layers.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <QtTest>

#include "core/skin/free/free_blood.h"
#include "core/skin/layers/polynomial_fit.h"
#include "core/skin/layers/table.h"
#include "core/skin/profile/absorption.h"
#include "core/skin/profile/parameter_sampling.h"
#include "src/files/profiles/profile_file.h"
#include "tests/support/expect.h"
#include "tests/support/folders.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

const Profile& twoFreeLayers() {
  static const Profile profile =
      loadProfile(test::sourceFolder() / "tests/support/two_layer_profile.json", "test").value();
  return profile;
}

const Profile& profileLi2024() {
  return test::li2024().profile();
}

// 340, 390 … 990 nm.
std::vector<int> freeSamples() {
  std::vector<int> samples;
  for (int i = 20; i < kSampleCount; i += 25)
    samples.push_back(i);
  return samples;
}

// Absorptions of one profile over its box, and room for the thicknesses.
struct States {
  States(const Profile& profile, double thicknessMm, int count) : thickness(count, thicknessMm) {
    const AbsorptionLaw law(profile);
    const auto people = sampleBox(profile.axes, count, 5000);
    for (const int sample : freeSamples()) {
      for (const ParameterVector& person : people) {
        const LayerPair absorption = law.at(sample, person);
        epidermal.push_back(absorption.epidermal);
        dermal.push_back(absorption.dermal);
      }
    }
  }

  LayerStates states() const {
    return {thickness.data(), epidermal.data(), dermal.data(), thickness.size()};
  }

  std::vector<double> thickness, epidermal, dermal;
};

class FreeLayersTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void transferIsThatOfATableForTheThickness() {
    const auto samples = freeSamples();
    const FreeLayers layers = FreeLayers::make(twoFreeLayers(), samples, {true, true}).value();
    for (const SkinConstants& constants :
         {SkinConstants{0.6, 0.02}, SkinConstants{0.0, 0.035}, SkinConstants{1.0, 0.06},
          SkinConstants{0.6, 0.093}, SkinConstants{0.3, 0.17}, SkinConstants{0.8, 0.25},
          SkinConstants{0.0, 0.36}, SkinConstants{1.0, 0.5}}) {
      const Profile profile = withConstants(twoFreeLayers(), constants);
      const LayerTable table = LayerTable::make(profile, samples).value();
      const States given(profile, constants.thicknessMm, 400);
      const LayerSpectra spectra = layers.evaluate(given.states(), false);
      double squares = 0.0, worst = 0.0;
      for (std::size_t at = 0; at < spectra.reflectance.size(); ++at) {
        const double exact =
            evaluate(table.at(samples[at / 400]), given.epidermal[at], given.dermal[at])
                .reflectance;
        const double error = spectra.reflectance[at] - exact;
        squares += error * error;
        worst = std::max(worst, std::abs(error));
      }
      EXPECT_AT_MOST(std::sqrt(squares / static_cast<double>(spectra.reflectance.size())), 1e-5);
      EXPECT_AT_MOST(worst, 5e-5);
    }
  }

  void diffusionIsExact() {
    const auto samples = freeSamples();
    const FreeLayers layers = FreeLayers::make(profileLi2024(), samples, {true, true}).value();
    for (const double thickness : {0.29, 0.32, 0.5}) {
      const SkinModel model(withConstants(profileLi2024(), {0.4, thickness}));
      const States given(model.profile(), thickness, 100);
      const LayerSpectra spectra = layers.evaluate(given.states(), true);
      for (std::size_t at = 0; at < spectra.reflectance.size(); ++at) {
        const LayeredReflectance exact =
            model.optics().evaluate(samples[at / 100], given.epidermal[at], given.dermal[at]);
        EXPECT_NEAR(spectra.reflectance[at], exact.reflectance, 1e-14);
        EXPECT_NEAR(spectra.perEpidermalAbsorption[at], exact.perEpidermalAbsorption, 1e-12);
        EXPECT_NEAR(spectra.perDermalAbsorption[at], exact.perDermalAbsorption, 1e-12);
      }
    }
  }

  void slopesAreThoseOfTheReflectance() {
    const auto samples = freeSamples();
    for (const Profile& profile : {twoFreeLayers(), profileLi2024()}) {
      const FreeLayers layers = FreeLayers::make(profile, samples, {false, true}).value();
      const double thickness = 0.31, step = 1e-5;
      const States given(profile, thickness, 100);
      const LayerSpectra spectra = layers.evaluate(given.states(), true);
      States above = given, below = given;
      const auto expectSlope = [&](const std::vector<double>& slopes) {
        const LayerSpectra up = layers.evaluate(above.states(), false);
        const LayerSpectra down = layers.evaluate(below.states(), false);
        for (std::size_t at = 0; at < slopes.size(); ++at) {
          const double difference = (up.reflectance[at] - down.reflectance[at]) / (2.0 * step);
          EXPECT_NEAR(slopes[at], difference, 1e-4 * std::max(std::abs(difference), 1e-3));
        }
      };
      const auto move = [&](std::vector<double> States::*which) {
        above = below = given;
        for (double& value : above.*which)
          value += step;
        for (double& value : below.*which)
          value -= step;
      };
      move(&States::thickness);
      expectSlope(spectra.perThickness);
      move(&States::epidermal);
      expectSlope(spectra.perEpidermalAbsorption);
      move(&States::dermal);
      expectSlope(spectra.perDermalAbsorption);
    }
  }

  void aFixedThicknessIsTheProfiles() {
    const auto samples = freeSamples();
    const FreeLayers layers = FreeLayers::make(twoFreeLayers(), samples, {}).value();
    const LayerTable table = LayerTable::make(twoFreeLayers(), samples).value();
    const States given(twoFreeLayers(), 0.4, 50);
    const LayerSpectra spectra = layers.evaluate(given.states(), false);
    for (std::size_t at = 0; at < spectra.reflectance.size(); ++at) {
      EXPECT_NEAR(
          spectra.reflectance[at],
          evaluate(table.at(samples[at / 50]), given.epidermal[at], given.dermal[at]).reflectance,
          1e-12);
    }
  }

  void bloodIsThatOfTheOxygenation() {
    const auto samples = freeSamples();
    for (const Profile& profile : {twoFreeLayers(), profileLi2024()}) {
      const FreeBlood blood(profile, samples, true);
      for (double oxygenation = 0.0; oxygenation <= 1.0; oxygenation += 0.0625) {
        const Profile exact = withConstants(profile, {oxygenation, 0.3});
        const Spectrum upper = chromophoreTable()[kHaemoglobinEpidermal].absorption(exact);
        const Spectrum lower = chromophoreTable()[kHaemoglobinDermal].absorption(exact);
        const double largest = std::max(upper.maxCoeff(), lower.maxCoeff());
        const FreeBlood::Values values = blood.at(std::vector<double>{oxygenation});
        const double step = 1e-6;
        const FreeBlood::Values near = blood.at(
            std::vector<double>{oxygenation < 0.5 ? oxygenation + step : oxygenation - step});
        const double toNear = oxygenation < 0.5 ? step : -step;
        for (std::size_t s = 0; s < samples.size(); ++s) {
          EXPECT_NEAR(values.dermal[s], lower[samples[s]], 2e-5 * largest);
          EXPECT_NEAR(values.epidermal[s], upper[samples[s]], 2e-5 * largest);
          EXPECT_NEAR(values.dermalSlope[s], (near.dermal[s] - values.dermal[s]) / toNear, 1e-3);
          // Beyond 0.9 the blood of the epidermis of skin2026 is at its bound.
          EXPECT_NEAR(values.epidermalSlope[s], (near.epidermal[s] - values.epidermal[s]) / toNear,
                      1e-3);
        }
      }
    }
  }

  void oxygenationsMoveTogetherWithinTheirRange() {
    QCOMPARE(withConstants(twoFreeLayers(), {0.5, 0.1}).dermalBlood.oxygenation, 0.5);
    EXPECT_NEAR(withConstants(twoFreeLayers(), {0.5, 0.1}).epidermalBlood.oxygenation, 0.6, 1e-12);
    QCOMPARE(withConstants(twoFreeLayers(), {0.97, 0.1}).epidermalBlood.oxygenation, 1.0);
    const Profile same = withConstants(twoFreeLayers(), constantsOf(twoFreeLayers()));
    QCOMPARE(fingerprint(same), fingerprint(twoFreeLayers()));
  }

  void whatIsFoundIsAValidProfile() {
    for (const Profile& profile : {twoFreeLayers(), profileLi2024()}) {
      const ThicknessRange range = thicknessRange(profile).value();
      for (const double thickness : {range.lowMm, range.highMm}) {
        for (const double oxygenation : {0.0, 1.0})
          EXPECT_OK(validate(withConstants(profile, {oxygenation, thickness}), "test"));
      }
    }
    QCOMPARE(thicknessRange(twoFreeLayers()).value().lowMm, 0.02);
    QVERIFY(thicknessRange(profileLi2024()).value().lowMm > 0.25);
  }

  void aProfileBeyondTheRangeKeepsItsThickness() {
    Profile thick = twoFreeLayers();
    thick.epidermalThicknessMm = 0.8;
    EXPECT_ERROR(FreeLayers::make(thick, freeSamples(), {false, true}),
                 "keep the thickness of this profile");
    EXPECT_OK(FreeLayers::make(thick, freeSamples(), {true, false}));
  }
};

CUTIS_TEST(FreeLayersTest)

}  // namespace
}  // namespace cutis

#include "free_layers_test.moc"
