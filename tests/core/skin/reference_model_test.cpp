#include <array>
#include <cmath>

#include <QtTest>

#include "core/skin/profile/parameter_sampling.h"
#include "core/transport/diffusion.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

const SkinModel& model() {
  return test::li2024();
}

int sampleAt(int nm) {
  return (nm - kFirstWavelengthNm) / kWavelengthStepNm;
}

// The multipole series itself: image sources mirrored between the two extrapolated boundaries of
// a slab (Donner & Jensen 2005), plane-integrated, pair by pair.
SlabOptics<double> seriesSlab(double absorption, double scattering, double thickness,
                              double factorNear, double factorFar) {
  const double extinction = absorption + scattering;
  const double albedo = scattering / extinction;
  const double path = 1.0 / extinction;
  const double effective = std::sqrt(3.0 * absorption * extinction);
  const auto oneSide = [&](double near, double far, double& reflectance, double& transmittance) {
    const double gapNear = 2.0 / 3.0 * near * path;
    const double gapFar = 2.0 / 3.0 * far * path;
    const double period = 2.0 * (thickness + gapNear + gapFar);
    reflectance = transmittance = 0.0;
    for (int i = -400; i <= 400; ++i) {
      const double real = i * period + path;
      const double mirror = i * period - path - 2.0 * gapNear;
      const auto flux = [&](double z, double plane) {
        const double away = z - plane;
        return std::copysign(0.5 * albedo * std::exp(-effective * std::abs(away)), away);
      };
      reflectance += flux(real, 0.0) - flux(mirror, 0.0);
      transmittance -= flux(real, thickness) - flux(mirror, thickness);
    }
  };
  SlabOptics<double> slab = {};
  oneSide(factorNear, factorFar, slab.reflectance, slab.transmittance);
  oneSide(factorFar, factorNear, slab.reflectanceFromBelow, slab.transmittanceFromBelow);
  return slab;
}

class ReferenceModelTest : public QObject {
  Q_OBJECT

 private slots:
  // The check values of resources/manual/model.md.
  void meetsTheCheckValues() {
    constexpr std::array<int, 12> nm = {300, 350, 414, 450, 500, 542,
                                        576, 600, 700, 850, 970, 1000};
    struct Row {
      ParameterVector parameters;
      std::array<double, 12> reflectance;
    };
    const std::array<Row, 5> rows = {{
        {{0, 0, 0, 0, 0},
         {0.4576923, 0.4831781, 0.5191804, 0.5399141, 0.5682213, 0.5880234, 0.5993388, 0.6043874,
          0.6066184, 0.5826497, 0.4903216, 0.4980497}},
        {{0.02, 0.5, 0.02, 0.01, 0.001},
         {0.1863149, 0.1920704, 0.1528857, 0.2157385, 0.2583752, 0.2530510, 0.2612924, 0.3429724,
          0.4358352, 0.4840787, 0.4425412, 0.4537763}},
        {{0.1, 0.7, 0.05, 0.05, 0.002},
         {0.0674415, 0.0672315, 0.0452838, 0.0757289, 0.0934838, 0.0911211, 0.0957461, 0.1258895,
          0.1801687, 0.2651907, 0.3004564, 0.3168824}},
        {{0.25, 0.9, 0.1, 0.02, 0.0005},
         {0.0331906, 0.0335369, 0.0322481, 0.0384610, 0.0439136, 0.0476972, 0.0519486, 0.0578300,
          0.0774601, 0.1204937, 0.1621367, 0.1754776}},
        {{0.5, 1, 0.5, 0.3, 0.01},
         {0.0170795, 0.0155826, 0.0088136, 0.0162981, 0.0206543, 0.0194032, 0.0203619, 0.0284833,
          0.0400246, 0.0608110, 0.0821301, 0.0890279}},
    }};
    for (const Row& row : rows) {
      for (std::size_t k = 0; k < nm.size(); ++k) {
        EXPECT_NEAR(model().reflectanceAt(sampleAt(nm[k]), row.parameters), row.reflectance[k],
                    1e-6);
      }
    }
  }

  void boundaryFactorIsThePaperIndexes() {
    EXPECT_NEAR(boundaryFactor(1.4), 3.251416633, 1e-9);
    EXPECT_NEAR(boundaryFactor(1.0), 1.0, 0.0);
  }

  // The geometric sum against the images themselves.
  void closedFormIsTheSummedSeries() {
    for (const double absorption : {0.05, 0.3, 1.0, 5.0, 40.0}) {
      for (const double scattering : {4.0, 10.0, 30.0}) {
        const double a = boundaryFactor(1.4);
        const auto closed = slabOptics(absorption, scattering, 0.32, a, 1.0);
        const auto series = seriesSlab(absorption, scattering, 0.32, a, 1.0);
        EXPECT_NEAR(closed.reflectance, series.reflectance, 1e-12);
        EXPECT_NEAR(closed.transmittance, series.transmittance, 1e-12);
        EXPECT_NEAR(closed.reflectanceFromBelow, series.reflectanceFromBelow, 1e-12);
        EXPECT_NEAR(closed.transmittanceFromBelow, series.transmittanceFromBelow, 1e-12);
      }
    }
  }

  // Without absorption every photon leaves on one side or the other.
  void clearSlabConservesEnergy() {
    for (const double thickness : {0.32, 1.0, 10.0}) {
      const auto slab = slabOptics(0.0, 8.0, thickness, boundaryFactor(1.4), 1.0);
      EXPECT_NEAR(slab.reflectance + slab.transmittance, 1.0, 1e-6);
      EXPECT_NEAR(slab.reflectanceFromBelow + slab.transmittanceFromBelow, 1.0, 1e-6);
    }
    EXPECT_NEAR(halfSpaceReflectance(0.0, 8.0, 1.0), 1.0, 1e-6);
  }

  void noAbsorptionIsTheLimitOfLittle() {
    const auto none = slabOptics(0.0, 8.0, 0.32, boundaryFactor(1.4), 1.0);
    const auto little = slabOptics(1e-9, 8.0, 0.32, boundaryFactor(1.4), 1.0);
    EXPECT_NEAR(none.reflectance, little.reflectance, 1e-7);
    EXPECT_NEAR(none.transmittance, little.transmittance, 1e-7);
  }

  void thickSlabIsTheHalfSpace() {
    for (const double absorption : {0.05, 1.0, 20.0}) {
      const auto slab = slabOptics(absorption, 8.0, 200.0, 3.25, 1.0);
      EXPECT_NEAR(slab.reflectance, halfSpaceReflectance(absorption, 8.0, 3.25), 1e-12);
      EXPECT_NEAR(slab.transmittance, 0.0, 1e-12);
      QVERIFY(std::isfinite(slab.reflectanceFromBelow));
    }
  }

  void energyHoldsOverTheBox() {
    for (const ParameterVector& p : sampleBox(model().profile().axes, 500)) {
      const Spectrum r = model().reflectance(p);
      QVERIFY(r.isFinite().all() && (r > 0.0).all() && (r < 1.0).all());
    }
  }

  // resources/manual/model.md: R falls with C_m, C_hd and C_he at every wavelength.
  void monotoneWhereTheModelSaysSo() {
    for (const ParameterVector& p : sampleBox(model().profile().axes, 300)) {
      SpectrumJacobian slopes;
      model().reflectance(p, slopes);
      for (const Parameter parameter : {kMelanin, kHaemoglobinDermal, kHaemoglobinEpidermal}) {
        QVERIFY2((slopes.col(parameter) <= 0.0).all(), parameterName(parameter).data());
      }
    }
  }

  void derivativesAreCentralDifferences() {
    for (const ParameterVector& p : sampleBox(model().profile().axes, 60)) {
      SpectrumJacobian slopes;
      const Spectrum value = model().reflectance(p, slopes);
      QVERIFY(((value - model().reflectance(p)).abs() < 1e-15).all());
      for (int k = 0; k < kParameterCount; ++k) {
        const double maximum = model().profile().axes[static_cast<std::size_t>(k)].maximum;
        const double step = 1e-3 * std::max(p[k], 1e-3 * maximum);
        ParameterVector above = p, below = p;
        above[k] += step;
        below[k] -= step;
        const Spectrum difference =
            (model().reflectance(above) - model().reflectance(below)) / (2.0 * step);
        const double scale = slopes.col(k).abs().maxCoeff();
        for (int i = 0; i < kSampleCount; i += 7) {
          EXPECT_NEAR(slopes(i, k), difference[i],
                      1e-4 * std::max(std::abs(difference[i]), 1e-3 * scale));
        }
      }
    }
  }

  void reportsWhereDiffusionEnds() {
    const ParameterVector pale = {0.01, 0.5, 0.01, 0.01, 0.0};
    const ParameterVector dark = {0.4, 1.0, 0.01, 0.01, 0.0};
    const auto holds = [](int nm, const ParameterVector& skin) {
      const LayerPair absorption = model().absorption().at(sampleAt(nm), skin);
      return model().optics().holds(sampleAt(nm), absorption.epidermal, absorption.dermal);
    };
    QVERIFY(holds(550, pale));
    QVERIFY(!holds(450, dark));
  }

  void refusesAnEpidermisThinnerThanOneMeanFreePath() {
    Profile thin = model().profile();
    thin.epidermalThicknessMm = 0.2;
    EXPECT_ERROR(validate(thin, "thin.json"), "epidermis.thickness_mm");
    EXPECT_ERROR(validate(thin, "thin.json"), "adding-doubling");
    EXPECT_OK(validate(model().profile(), "li2024"));
  }

  void axesInvertThemselves() {
    for (const ParameterAxis& axis : model().profile().axes) {
      for (int i = 0; i < axis.samples; ++i)
        EXPECT_NEAR(axis.index(axis.value(i)), i, 1e-9);
      EXPECT_NEAR(axis.value(axis.samples - 1), axis.maximum, 1e-15);
    }
  }
};

CUTIS_TEST(ReferenceModelTest)

}  // namespace
}  // namespace cutis

#include "reference_model_test.moc"
