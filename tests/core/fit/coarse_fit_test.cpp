#include "core/fit/coarse_fit.h"

#include <QtTest>

#include "core/fit/fit_run.h"
#include "core/fit/refined/refined_solver.h"
#include "tests/core/fit/fit_fixture.h"
#include "tests/core/fit/picture_fixture.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

class CoarseFitTest : public QObject {
  Q_OBJECT

 private slots:
  // Sizes that are no multiple of tiles or blocks.
  void eachBlockHasItsFirstPixelsValues() {
    const Measurements picture = test::skinPhotograph(test::albedoRig(), 300, 270);
    const auto solver = makeRefinedSolver(test::sharedModel(), picture.rig, {});
    const FitPlanes coarse(picture, {}, nullptr), fine(picture, {}, nullptr);
    EXPECT_OK(runCoarseFit(picture, *solver, coarse.maps, {}));
    EXPECT_OK(runFit(picture, *solver, fine, {}));
    for (std::size_t k = 0; k < kParameterCount; ++k) {
      const auto rough = test::pixelsOf(coarse.maps.values[k]);
      const auto exact = test::pixelsOf(fine.maps.values[k]);
      for (std::size_t y = 0; y < 270; ++y) {
        for (std::size_t x = 0; x < 300; ++x) {
          const std::size_t first = (y / kCoarseBlock * 300 + x / kCoarseBlock) * kCoarseBlock;
          QCOMPARE(rough[y * 300 + x], exact[first]);
        }
      }
    }
  }

  void whatIsNotToBeSolvedStaysEmpty() {
    const Measurements picture = test::photograph(
        test::albedoRig(), 64, 40,
        [](int, int) {
          return std::vector<float>{0.4f, 0.35f, 0.2f};
        },
        [](int x, int y) {
          if (x < 16 && y < 16) return x + y == 0 ? PixelState::masked : PixelState::solved;
          return x == 20 ? PixelState::saturated : PixelState::solved;
        });
    const auto solver = makeRefinedSolver(test::sharedModel(), picture.rig, {});
    const FitPlanes planes(picture, {}, nullptr);
    EXPECT_OK(runCoarseFit(picture, *solver, planes.maps, {}));
    const auto states = test::pixelsOf(planes.maps.state);
    const auto melanin = test::pixelsOf(planes.maps.values[kMelanin]);
    const auto stateAt = [&](std::size_t x, std::size_t y) {
      return pixelState(states[y * 64 + x]);
    };
    QCOMPARE(stateAt(5, 5), PixelState::masked);  // its block's first pixel is no skin
    QCOMPARE(stateAt(20, 30), PixelState::saturated);
    QCOMPARE(stateAt(40, 30), PixelState::solved);
    QCOMPARE(melanin[5 * 64 + 5], 0.0f);
    QCOMPARE(melanin[30 * 64 + 20], 0.0f);
    QVERIFY(melanin[30 * 64 + 40] > 0.0f);
  }

  void stopsWhenAsked() {
    const Measurements picture = test::skinPhotograph(test::albedoRig(), 300, 270);
    const auto solver = makeRefinedSolver(test::sharedModel(), picture.rig, {});
    std::stop_source stop;
    stop.request_stop();
    JobContext context;
    context.stop = stop.get_token();
    const FitPlanes planes(picture, {}, nullptr);
    QVERIFY(runCoarseFit(picture, *solver, planes.maps, context).cancelled());
  }
};

CUTIS_TEST(CoarseFitTest)

}  // namespace
}  // namespace cutis

#include "coarse_fit_test.moc"
