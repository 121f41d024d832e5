// States of pixels as planes hold them.

#include "core/skin/pixel_state.h"

#include <limits>

#include <QtTest>

#include "tests/support/test_registry.h"

namespace cutis {
namespace {

class PixelStateTest : public QObject {
  Q_OBJECT

 private slots:
  void everyStateComesBack() {
    for (const PixelState state : {PixelState::solved, PixelState::masked, PixelState::invalid,
                                   PixelState::saturated, PixelState::noConvergence}) {
      QVERIFY(isPixelState(storedState(state)));
      QVERIFY(pixelState(storedState(state)) == state);
    }
  }

  void whatIsNoStateIsInvalid() {
    for (const float stored : {-1.0f, 0.5f, 5.0f, 1e30f, std::numeric_limits<float>::quiet_NaN(),
                               std::numeric_limits<float>::infinity()}) {
      QVERIFY(!isPixelState(stored));
      QVERIFY(pixelState(stored) == PixelState::invalid);
    }
  }

  void onlySolvedPixelsHaveAnEstimate() {
    QVERIFY(hasEstimate(PixelState::solved));
    QVERIFY(hasEstimate(PixelState::noConvergence));
    QVERIFY(!hasEstimate(PixelState::masked));
    QVERIFY(!hasEstimate(PixelState::invalid));
    QVERIFY(!hasEstimate(PixelState::saturated));
  }
};

CUTIS_TEST(PixelStateTest)

}  // namespace
}  // namespace cutis

#include "pixel_state_test.moc"
