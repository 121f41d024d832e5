// The sheet of chromaticities that skin can have.

#include "core/analyse/skin_locus.h"

#include <cmath>

#include <QtTest>

#include "core/spectra/colorimetry.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

class SkinLocusTest : public QObject {
  Q_OBJECT

 private slots:
  // CIE 15: D65 lies at u′ 0.1978, v′ 0.4683.
  void whiteIsWhereItShouldBe() {
    const Eigen::Vector2d white = chromaticityOf(test::daylightWhite());
    EXPECT_NEAR(white[0], 0.1978, 2e-4);
    EXPECT_NEAR(white[1], 0.4683, 2e-4);
  }

  void blackHasNone() { QVERIFY(std::isnan(chromaticityOf({0.0, 0.0, 0.0})[0])); }

  // Blood makes light skin redder.
  void bloodReddens() {
    ParameterVector others = ParameterVector::Zero();
    others[kMelaninBlend] = 0.5;
    const auto lines =
        skinLocus(test::li2024(), others, tristimulusRows(test::light("D65"), test::cie1931()));
    QCOMPARE(lines.size(), std::size_t{12});
    for (const LocusLine& line : lines) {
      for (const Eigen::Vector2d& point : line.points)
        QVERIFY(point.allFinite());
    }
    QVERIFY(lines[0].points[4][0] > lines[0].points[0][0]);
    QVERIFY(lines[0].amount < lines[1].amount && lines[5].amount > 0.0);
  }
};

CUTIS_TEST(SkinLocusTest)

}  // namespace
}  // namespace cutis

#include "skin_locus_test.moc"
