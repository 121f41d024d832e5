#include "core/analyse/diffusion_domain.h"

#include <algorithm>
#include <optional>
#include <vector>

#include <QtTest>

#include "core/skin/pixel_state.h"
#include "core/skin/profile/absorption.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

const ParameterVector kPale = {0.01, 0.5, 0.01, 0.01, 0.0};
const ParameterVector kDark = {0.4, 1.0, 0.01, 0.01, 0.0};

// The first `dark` pixels dark, the others pale, the last row masked, all in a row of ten.
ChromophoreMaps mapsOf(int dark, const FreeConstants& free = {}, float oxygenation = 0.75f) {
  ChromophoreMaps maps(10, 2, PixelFormat::float32, nullptr, free);
  for (int i = 0; i < 20; ++i) {
    const Rect pixel = {i % 10, i / 10, i % 10 + 1, i / 10 + 1};
    const bool isMasked = i >= 10;
    const auto store = [&](Plane& plane, float value) {
      (void)plane.store(pixel, std::vector<float>{value});
    };
    for (const Parameter k : kParameters)
      store(maps.values[k], static_cast<float>((i < dark || isMasked ? kDark : kPale)[k]));
    store(maps.state, static_cast<float>(isMasked ? PixelState::masked : PixelState::solved));
    if (free.oxygenation) store(maps.constants[kOxygenation], oxygenation);
  }
  return maps;
}

std::optional<double> shareOf(const ChromophoreMaps& maps,
                              const Profile& profile = test::li2024().profile()) {
  return shareOutsideDiffusion(maps, profile, {}).value();
}

class DiffusionDomainTest : public QObject {
  Q_OBJECT

 private slots:
  void sharesAreOfThePixelsWithAnEstimate() {
    for (const int dark : {0, 3, 10})
      EXPECT_NEAR(shareOf(mapsOf(dark)).value(), dark / 10.0, 1e-15);
  }

  // The two bloods absorb differently: the same amount of the one takes a pixel outside.
  void theOxygenationOfAPixelCounts() {
    ChromophoreMaps rich = mapsOf(0, {true, false}, 1.0f), poor = mapsOf(0, {true, false}, 0.0f);
    const Profile& profile = test::li2024().profile();
    // Between the limits of the dermis with the one blood and with the other.
    const Spectrum scattering = dermalScattering(profile);
    const auto most = [&](double oxygenation) {
      const AbsorptionLaw absorption(
          withConstants(profile, {oxygenation, profile.epidermalThicknessMm}));
      double limit = 1.0;
      for (int i = kVisibleBand.first; i <= kVisibleBand.last; i += 5) {
        limit = std::min(limit, (scattering[i] - absorption.base(SkinLayer::dermis, i)) /
                                    absorption.perUnit(kHaemoglobinDermal, i));
      }
      return limit;
    };
    const double between = 0.5 * (most(1.0) + most(0.0));
    for (ChromophoreMaps* maps : {&rich, &poor}) {
      const std::vector<float> blood(20, static_cast<float>(between));
      EXPECT_OK(maps->values[kHaemoglobinDermal].store({0, 0, 10, 2}, blood));
    }
    const bool deoxygenatedIsDarker = most(0.0) < most(1.0);
    EXPECT_NEAR(shareOf(rich).value(), deoxygenatedIsDarker ? 0.0 : 1.0, 0.0);
    EXPECT_NEAR(shareOf(poor).value(), deoxygenatedIsDarker ? 1.0 : 0.0, 0.0);
  }

  void radiativeTransferHasNoSuchDomain() {
    Profile profile = test::li2024().profile();
    profile.layerOptics = LayerOpticsKind::addingDoubling;
    QVERIFY(!shareOf(mapsOf(10), profile));
  }

  void withoutEstimatesThereIsNoShare() {
    ChromophoreMaps maps = mapsOf(3);
    EXPECT_OK(maps.state.store({0, 0, 10, 1},
                               std::vector<float>(10, static_cast<float>(PixelState::invalid))));
    QVERIFY(!shareOf(maps));
  }
};

CUTIS_TEST(DiffusionDomainTest)

}  // namespace
}  // namespace cutis

#include "diffusion_domain_test.moc"
