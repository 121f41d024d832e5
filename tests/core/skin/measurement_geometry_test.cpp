#include "core/skin/model/measurement_geometry.h"

#include <cmath>
#include <vector>

#include <QtTest>

#include "core/transport/adding_doubling.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

class MeasurementGeometryTest : public QObject {
  Q_OBJECT

 private slots:
  void theModelItselfIsTheDefault() {
    EXPECT_NEAR(measuredReflectance({}, 0.37), 0.37, 0.0);
    const EffectiveAbsorption same = withEdgeLoss({}, 0.2, 4.0);
    EXPECT_NEAR(same.absorption, 0.2, 0.0);
    EXPECT_NEAR(same.slope, 1.0, 0.0);
  }

  void theSurfaceReflectsItsShare() {
    const auto included = measurementGeometry(SpecularPart::included, 1.4, 0.045);
    EXPECT_NEAR(measuredReflectance(included, 0.5), 0.045 + (1.0 - 0.0277778) * 0.5, 1e-7);
    for (const auto part : {SpecularPart::excluded, SpecularPart::crossPolarised}) {
      const auto geometry = measurementGeometry(part, 1.4, 0.045);
      EXPECT_NEAR(measuredReflectance(geometry, 0.5), (1.0 - 1.0 / 36.0) * 0.5, 1e-15);
    }
    EXPECT_NEAR(modelReflectance(included, measuredReflectance(included, 0.31)), 0.31, 1e-15);
    // Skin as smooth as glass: what the transport of light reports as total.
    const auto skin = layeredTransport(std::vector<TransportLayer>{{0.1, 5.0}});
    EXPECT_OK(skin);
    EXPECT_NEAR(measuredReflectance(measurementGeometry(SpecularPart::included, 1.4, 1.0 / 36.0),
                                    skin.value().reflectance),
                skin.value().total(), 1e-15);
  }

  // A mode of wave number k dies towards the depth as √(σ_tr² + k²), with σ_tr² = σ_a / D.
  void lightLostSidewaysCountsAsAbsorbed() {
    EXPECT_NEAR(edgeLossOfAperture(5.5), 0.437, 3e-4);
    MeasurementGeometry geometry;
    geometry.edgeLossPerMm = edgeLossOfAperture(5.5);
    const double absorption = 0.02, scattering = 3.0;
    const double diffusion = 1.0 / (3.0 * (absorption + scattering));
    const EffectiveAbsorption lossy = withEdgeLoss(geometry, absorption, scattering);
    EXPECT_NEAR(lossy.absorption / diffusion,
                absorption / diffusion + geometry.edgeLossPerMm * geometry.edgeLossPerMm, 1e-13);
    const double step = 1e-6;
    EXPECT_NEAR(lossy.slope,
                (withEdgeLoss(geometry, absorption + step, scattering).absorption -
                 withEdgeLoss(geometry, absorption - step, scattering).absorption) /
                    (2.0 * step),
                1e-8);
  }

  void impossibleGeometriesAreRefused() {
    EXPECT_OK(validate(MeasurementGeometry(), "m"));
    EXPECT_OK(validate(measurementGeometry(SpecularPart::included, 1.4), "m"));
    EXPECT_ERROR(validate({-0.1, 1.0, 0.0}, "m"), "m: the specular share must be at least 0");
    EXPECT_ERROR(validate({1.0, 1.0, 0.0}, "m"), "the specular share");
    EXPECT_ERROR(validate({NAN, 1.0, 0.0}, "m"), "the specular share");
    EXPECT_ERROR(validate({0.0, 0.0, 0.0}, "m"), "the share of light that enters");
    EXPECT_ERROR(validate({0.0, 1.1, 0.0}, "m"), "the share of light that enters");
    EXPECT_ERROR(validate({0.0, 1.0, -1.0}, "m"), "the edge loss must be finite");
    EXPECT_ERROR(validate({0.0, 1.0, INFINITY}, "m"), "the edge loss must be finite");
  }
};

CUTIS_TEST(MeasurementGeometryTest)

}  // namespace
}  // namespace cutis

#include "measurement_geometry_test.moc"
