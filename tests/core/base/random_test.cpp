#include "core/base/random.h"

#include <array>
#include <cmath>
#include <vector>

#include <QtTest>

#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

class RandomTest : public QObject {
  Q_OBJECT

 private slots:
  // SplitMix64 from seed 1234567, the generator's published sequence (rosettacode.org, after
  // Steele, Lea, Flood 2014).
  void isSplitMix() {
    constexpr std::array<std::uint64_t, 5> published = {6457827717110365317u, 3203168211198807973u,
                                                        9817491932198370423u, 4593380528125082431u,
                                                        16408922859458223821u};
    std::uint64_t state = 1234567;
    for (const std::uint64_t expected : published) {
      QCOMPARE(mixBits(state), expected);
      state += 0x9e3779b97f4a7c15u;
    }
  }

  // Patches, populations and start polynomials are made from these: they must never change.
  void firstValuesArePinned() {
    Random random(31, 1);
    QCOMPARE(random.bits(), std::uint64_t{17234958809129591076u});
    QCOMPARE(random.bits(), std::uint64_t{11104875264365646711u});
    EXPECT_NEAR(random.uniform(), 0.35249553061221006, 1e-16);
    EXPECT_NEAR(random.normal(), 0.9930113702543675, 1e-14);
  }

  void uniformHasItsMoments() {
    Random random(1);
    constexpr int kCount = 200000;
    double sum = 0.0, squares = 0.0, lag = 0.0, last = 0.5;
    for (int i = 0; i < kCount; ++i) {
      const double u = random.uniform();
      QVERIFY(u >= 0.0 && u < 1.0);
      sum += u;
      squares += u * u;
      lag += (u - 0.5) * (last - 0.5);
      last = u;
    }
    // Five standard errors.
    EXPECT_NEAR(sum / kCount, 0.5, 5.0 * std::sqrt(1.0 / 12.0 / kCount));
    EXPECT_NEAR(squares / kCount, 1.0 / 3.0, 5.0 * std::sqrt(4.0 / 45.0 / kCount));
    EXPECT_NEAR(lag / kCount, 0.0, 5.0 / 12.0 / std::sqrt(kCount));
  }

  void normalHasItsMoments() {
    Random random(2);
    constexpr int kCount = 200000;
    double sum = 0.0, squares = 0.0, cubes = 0.0, fourths = 0.0;
    int beyondTwo = 0;
    for (int i = 0; i < kCount; ++i) {
      const double z = random.normal();
      QVERIFY(std::isfinite(z));
      sum += z;
      squares += z * z;
      cubes += z * z * z;
      fourths += z * z * z * z;
      beyondTwo += std::abs(z) > 2.0 ? 1 : 0;
    }
    EXPECT_NEAR(sum / kCount, 0.0, 5.0 / std::sqrt(kCount));
    EXPECT_NEAR(squares / kCount, 1.0, 5.0 * std::sqrt(2.0 / kCount));
    EXPECT_NEAR(cubes / kCount, 0.0, 5.0 * std::sqrt(15.0 / kCount));
    EXPECT_NEAR(fourths / kCount, 3.0, 5.0 * std::sqrt(96.0 / kCount));
    EXPECT_NEAR(beyondTwo / double{kCount}, std::erfc(std::sqrt(2.0)), 2.5e-3);
  }

  void rangesAreKept() {
    Random random(3);
    for (int i = 0; i < 1000; ++i) {
      const double u = random.uniform(-3.0, 5.0);
      QVERIFY(u >= -3.0 && u < 5.0);
    }
  }

  void streamsOfOneSeedAreUnrelated() {
    Random a(7, 0), b(7, 1), c(8, 0);
    double ab = 0.0, ac = 0.0;
    constexpr int kCount = 100000;
    for (int i = 0; i < kCount; ++i) {
      const double x = a.uniform() - 0.5;
      ab += x * (b.uniform() - 0.5);
      ac += x * (c.uniform() - 0.5);
    }
    EXPECT_NEAR(ab / kCount, 0.0, 5.0 / 12.0 / std::sqrt(kCount));
    EXPECT_NEAR(ac / kCount, 0.0, 5.0 / 12.0 / std::sqrt(kCount));
  }
};

CUTIS_TEST(RandomTest)

}  // namespace
}  // namespace cutis

#include "random_test.moc"
