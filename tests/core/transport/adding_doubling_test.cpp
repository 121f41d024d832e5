#include "core/transport/adding_doubling.h"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <Eigen/Eigenvalues>
#include <QtTest>

#include "core/maths/quadrature.h"
#include "core/transport/doubling.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

TransportResult transport(const std::vector<TransportLayer>& layers,
                          const TransportOptions& options = {}) {
  const auto result = layeredTransport(layers, options);
  return result ? result.value() : TransportResult{NAN, NAN, NAN};
}

// Albedo a, optical depth b and anisotropy g as the tables have them.
TransportResult tabulatedSlab(double a, double b, double g, int streams = 32) {
  TransportOptions options;
  options.streams = streams;
  options.refractiveIndex = 1.0;
  options.anisotropy = g;
  return transport({{(1.0 - a) * b, a * b * (1.0 - g), 1.0}}, options);
}

TransportResult halfSpace(double albedo, const TransportOptions& options) {
  return transport({{1.0 - albedo, albedo}}, options);
}

// Ambartsumian's function of isotropic scattering, in closed form (van de Hulst 1980, chapter 8):
// ln H(μ) = −(μ/π) ∫₀^{π/2} ln(1 − a θ cot θ) / (cos² θ + μ² sin² θ) dθ.
double ambartsumian(double albedo, double cosine) {
  static const Quadrature angles = gaussQuadrature(200, 0.0, 0.5 * std::numbers::pi);
  double sum = 0.0;
  for (int i = 0; i < 200; ++i) {
    const double angle = angles.nodes[i], c = std::cos(angle), s = std::sin(angle);
    sum +=
        angles.weights[i] * std::log1p(-albedo * angle * c / s) / (c * c + cosine * cosine * s * s);
  }
  return std::exp(-cosine / std::numbers::pi * sum);
}

// The layer's operators from the eigenvectors of its equation instead of from doubling.
template <int N>
LayerAdmittance<N> eigenAdmittance(const LayerEquation<N>& equation, double depth) {
  const Eigen::SelfAdjointEigenSolver<StreamMatrix<N>> solver(equation.rates);
  const StreamVector<N> k = solver.eigenvalues().cwiseMax(0.0).cwiseSqrt();
  StreamVector<N> even, odd;
  for (int i = 0; i < N; ++i) {
    const double t = std::tanh(0.5 * k[i] * depth * equation.depthScale);
    even[i] = k[i] * t;
    odd[i] = k[i] / t;
  }
  const StreamMatrix<N> back = equation.root.inverse().transpose() * solver.eigenvectors();
  return {back * even.asDiagonal() * back.transpose(), back * odd.asDiagonal() * back.transpose()};
}

const std::array<double, 7> kAlbedos = {0.0, 0.3, 0.9, 0.99, 0.9999, 1.0 - 1e-6, 1.0 - 1e-9};

class AddingDoublingTest : public QObject {
  Q_OBJECT

 private slots:
  // Normal incidence, no change of index; fluxes as printed, to five digits. van de Hulst,
  // Multiple Light Scattering (1980), table 12 (isotropic) and table 35 (Henyey–Greenstein).
  void vanDeHulstsSlabs() {
    const TransportResult isotropic = tabulatedSlab(1.0, 1.0, 0.0);
    EXPECT_NEAR(isotropic.reflectance, 0.34133, 5e-6);
    EXPECT_NEAR(isotropic.transmittance, 0.65867, 5e-6);
    EXPECT_NEAR(tabulatedSlab(1.0, 1.0, 0.5).transmittance, 0.82389, 6e-6);
    EXPECT_NEAR(tabulatedSlab(0.9, 1.0, 0.5).transmittance, 0.73909, 5e-6);
    // Also the first check of Wang, Jacques & Zheng 1995 (MCML), table 1.
    const TransportResult forward = tabulatedSlab(0.9, 2.0, 0.75);
    EXPECT_NEAR(forward.reflectance, 0.09739, 6e-6);
    EXPECT_NEAR(forward.transmittance, 0.66096, 5e-6);
  }

  void sixteenStreamsReproduceTheTables() {
    const TransportResult forward = tabulatedSlab(0.9, 2.0, 0.75, 16);
    EXPECT_NEAR(forward.reflectance, 0.09739, 1.5e-5);
    EXPECT_NEAR(forward.transmittance, 0.66096, 1e-5);
    EXPECT_NEAR(tabulatedSlab(1.0, 1.0, 0.0, 16).reflectance, 0.34133, 5e-6);
  }

  // Giovanelli 1955: isotropic half-space of albedo 0.9 and index 1.5, total reflectance 0.2600, as
  // quoted by Wang, Jacques & Zheng 1995 (MCML), table 2. The last digit is uncertain by one.
  void giovanellisHalfSpace() {
    TransportOptions options;
    options.refractiveIndex = 1.5;
    EXPECT_NEAR(halfSpace(0.9, options).total(), 0.2600, 1e-4);
  }

  // 1 − H(1) √(1 − a), and its mean over diffuse light.
  void matchedHalfSpaceIsAmbartsumians() {
    TransportOptions options;
    options.refractiveIndex = 1.0;
    const Quadrature cosines = gaussQuadrature(60, 0.0, 1.0);
    for (const double albedo : {0.1, 0.5, 0.9, 0.99, 0.999}) {
      const double root = std::sqrt(1.0 - albedo);
      options.illumination = Illumination::collimated;
      EXPECT_NEAR(halfSpace(albedo, options).reflectance, 1.0 - ambartsumian(albedo, 1.0) * root,
                  1e-7);
      double diffuse = 0.0;
      for (int i = 0; i < 60; ++i) {
        diffuse += 2.0 * cosines.weights[i] * cosines.nodes[i] *
                   (1.0 - ambartsumian(albedo, cosines.nodes[i]) * root);
      }
      options.illumination = Illumination::diffuse;
      EXPECT_NEAR(halfSpace(albedo, options).reflectance, diffuse, 1e-7);
    }
  }

  void doublingIsTheSolutionByEigenvectors() {
    const Streams<16> streams = makeStreams<16>(1.4);
    for (const double albedo : {0.0, 0.5, 0.9, 0.999}) {
      for (const double g : {0.0, 0.8}) {
        const auto equation = layerEquation(streams, Scatterer{albedo, g});
        for (const double depth : {1e-3, 0.1, 1.0, 10.0, 1000.0}) {
          const auto doubled = layerAdmittance(equation, depth);
          const auto exact = eigenAdmittance(equation, depth);
          EXPECT_AT_MOST((doubled.even - exact.even).cwiseAbs().maxCoeff(), 1e-10);
          EXPECT_AT_MOST((doubled.odd - exact.odd).cwiseAbs().maxCoeff(),
                         1e-10 * exact.odd.cwiseAbs().maxCoeff());
        }
        const auto deep = eigenAdmittance(equation, 1e9);
        EXPECT_AT_MOST((halfSpaceAdmittance(equation) - deep.even).cwiseAbs().maxCoeff(), 1e-10);
      }
    }
  }

  void moreStreamsChangeNothing() {
    TransportOptions many;
    many.streams = 32;
    for (const auto illumination : {Illumination::collimated, Illumination::diffuse}) {
      many.illumination = illumination;
      TransportOptions usual = many;
      usual.streams = 16;
      for (const double epidermal : {0.03, 0.5, 5.0, 200.0}) {
        for (const double thickness : {0.02, 0.1, 0.32}) {
          const std::vector<TransportLayer> skin = {{epidermal, 12.0, thickness}, {0.2, 8.0}};
          EXPECT_NEAR(transport(skin, usual).reflectance, transport(skin, many).reflectance, 1e-6);
        }
      }
    }
  }

  // Similar media: the anisotropic one of the same reduced scattering is close, not equal.
  void similarityHoldsForThickMedia() {
    TransportOptions forward;
    forward.anisotropy = 0.8;
    EXPECT_NEAR(transport({{0.1, 10.0}}, forward).reflectance, transport({{0.1, 10.0}}).reflectance,
                0.01);
  }

  void energyIsConserved() {
    TransportOptions options;
    for (const double index : {1.0, 1.4}) {
      for (const double g : {0.0, 0.8}) {
        options.refractiveIndex = index;
        options.anisotropy = g;
        for (const double depth : {1e-6, 0.01, 1.0, 30.0}) {
          const TransportResult lossless = transport({{0.0, 1.0, depth}}, options);
          EXPECT_NEAR(lossless.reflectance + lossless.transmittance, 1.0, 1e-9);
        }
        for (const double albedo : kAlbedos) {
          for (const double depth : {1e-6, 1.0, 100.0, 5000.0}) {
            const TransportResult slab = transport({{1.0 - albedo, albedo, depth}}, options);
            QVERIFY(slab.reflectance >= 0.0 && slab.transmittance >= -1e-12);
            EXPECT_AT_MOST(slab.reflectance + slab.transmittance, 1.0 + 1e-9);
          }
        }
      }
    }
    // 1 − R of a nearly white half-space is 4/√3 √(1 − a) times a factor near 1.
    options = {};
    options.refractiveIndex = 1.0;
    const double absorbed = 1.0 - halfSpace(1.0 - 1e-9, options).reflectance;
    EXPECT_NEAR(absorbed / std::sqrt(1e-9), ambartsumian(1.0, 1.0), 1e-3);
  }

  // Diffuse light gets through two layers as well one way as the other.
  void transmissionIsReciprocal() {
    TransportOptions options;
    options.illumination = Illumination::diffuse;
    for (const double g : {0.0, 0.8}) {
      options.anisotropy = g;
      const TransportLayer first = {2.0, 10.0, 0.1}, second = {0.1, 5.0, 0.5};
      EXPECT_NEAR(transport({first, second}, options).transmittance,
                  transport({second, first}, options).transmittance, 1e-12);
    }
  }

  void aCutThroughALayerChangesNothing() {
    for (const double g : {0.0, 0.8}) {
      TransportOptions options;
      options.anisotropy = g;
      for (const double absorption : {0.0, 0.1, 3.0, 100.0}) {
        const TransportLayer below = {0.2, 8.0};
        const double whole = transport({{absorption, 10.0, 0.3}, below}, options).reflectance;
        for (const double cut : {1e-4, 0.1, 0.15}) {
          EXPECT_NEAR(
              transport({{absorption, 10.0, cut}, {absorption, 10.0, 0.3 - cut}, below}, options)
                  .reflectance,
              whole, 1e-9);
        }
      }
      const double half = transport({{0.2, 8.0}}, options).reflectance;
      EXPECT_NEAR(transport({{0.2, 8.0, 0.7}, {0.2, 8.0}}, options).reflectance, half, 1e-9);
    }
  }

  void thinAndBlackEpidermis() {
    const double bare = transport({{0.2, 8.0}}).reflectance;
    EXPECT_NEAR(transport({{50.0, 10.0, 0.0}, {0.2, 8.0}}).reflectance, bare, 1e-14);
    EXPECT_NEAR(transport({{50.0, 10.0, 1e-9}, {0.2, 8.0}}).reflectance, bare, 1e-6);
    EXPECT_NEAR(transport({{0.0, 0.0, 5.0}, {0.2, 8.0}}).reflectance, bare, 1e-14);
    EXPECT_NEAR(transport({{1e6, 10.0, 0.1}, {0.2, 8.0}}).reflectance, 0.0, 1e-5);
    // Nothing scatters: what enters is absorbed on its way, but for the reflection at the far side.
    const TransportResult glass = transport({{3.0, 0.0, 1.0}});
    const double through = std::exp(-3.0), rho = 1.0 / 36.0;
    EXPECT_NEAR(glass.transmittance, (1 - rho) * through / (1 - rho * rho * through * through),
                1e-9);
  }

  void darkerSkinReflectsLess() {
    double before = 1.0;
    for (double absorption = 0.01; absorption < 300.0; absorption *= 1.3) {
      const double now = transport({{absorption, 12.0, 0.1}, {0.2, 8.0}}).reflectance;
      QVERIFY(now < before && now > 0.0);
      before = now;
    }
  }

  void specularIsApart() {
    TransportOptions options;
    const TransportResult collimated = transport({{0.2, 8.0}}, options);
    EXPECT_NEAR(collimated.specular, 1.0 / 36.0, 1e-15);
    EXPECT_NEAR(collimated.total(), collimated.specular + collimated.diffuse(), 1e-15);
    EXPECT_NEAR(collimated.diffuse(), collimated.reflectance * 35.0 / 36.0, 1e-15);
    options.refractiveIndex = 1.0;
    EXPECT_NEAR(transport({{0.2, 8.0}}, options).specular, 0.0, 1e-12);
  }

  void theGridIsItsPairs() {
    const std::vector<double> epidermal = {0.0, 0.3, 40.0}, dermal = {0.05, 1.0};
    const auto grid = twoLayerReflectances({0.1, 12.0, 7.0, epidermal, dermal});
    EXPECT_OK(grid);
    for (Eigen::Index i = 0; i < 3; ++i) {
      for (Eigen::Index j = 0; j < 2; ++j) {
        const auto e = epidermal[static_cast<std::size_t>(i)];
        const auto d = dermal[static_cast<std::size_t>(j)];
        QCOMPARE(grid.value()(i, j), transport({{e, 12.0, 0.1}, {d, 7.0}}).reflectance);
      }
    }
  }

  void neverNotANumber() {
    for (const double absorption : {0.0, 1e-12, 1.0, 1e6}) {
      for (const double scattering : {1e-9, 1.0, 1e4}) {
        for (const double thickness : {1e-12, 0.3, 1e5}) {
          const TransportResult r =
              transport({{absorption, scattering, thickness}, {absorption, scattering}});
          QVERIFY2(r.reflectance >= 0.0 && r.reflectance <= 1.0 + 1e-9,
                   qPrintable(QString("%1 %2 %3: %4")
                                  .arg(absorption)
                                  .arg(scattering)
                                  .arg(thickness)
                                  .arg(r.reflectance)));
        }
      }
    }
  }

  void refusesWhatHasNoAnswer() {
    const auto attempt = [](const std::vector<TransportLayer>& layers, TransportOptions options) {
      return layeredTransport(layers, options);
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_ERROR(attempt({}, {}), "at least one layer");
    EXPECT_ERROR(attempt({{nan, 1.0}}, {}), "finite and not negative");
    EXPECT_ERROR(attempt({{0.1, -1.0}}, {}), "finite and not negative");
    EXPECT_ERROR(attempt({{0.1, 1.0, nan}}, {}), "thickness must not be negative");
    EXPECT_ERROR(attempt({{0.1, 1.0}, {0.1, 1.0}}, {}), "only the last layer");
    EXPECT_ERROR(attempt({{0.0, 0.0}}, {}), "must absorb or scatter");
    EXPECT_ERROR(attempt({{0.1, 1.0}}, {.streams = 7}), "8, 16 or 32");
    EXPECT_ERROR(attempt({{0.1, 1.0}}, {.refractiveIndex = nan}), "between 1 and 3");
    EXPECT_ERROR(attempt({{0.1, 1.0}}, {.anisotropy = 1.0}), "between -0.95 and 0.95");
    EXPECT_ERROR(twoLayerReflectances({kSemiInfinite, 1.0, 1.0, {}, {}}), "finite thickness");
  }
};

CUTIS_TEST(AddingDoublingTest)

}  // namespace
}  // namespace cutis

#include "adding_doubling_test.moc"
