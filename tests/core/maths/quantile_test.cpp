#include "core/maths/quantile.h"

#include <QtTest>

#include "tests/support/test_registry.h"

namespace cutis {
namespace {

class QuantileTest : public QObject {
  Q_OBJECT

 private slots:
  void answersWithOneOfTheValues() {
    std::vector<float> values = {5, 1, 4, 2, 3};
    QCOMPARE(quantileOf(values, 0.0), 1.0f);
    QCOMPARE(quantileOf(values, 0.5), 3.0f);
    QCOMPARE(quantileOf(values, 0.74), 3.0f);
    QCOMPARE(quantileOf(values, 0.75), 4.0f);
    QCOMPARE(quantileOf(values, 1.0), 5.0f);
  }

  void aSingleValueIsEveryQuantile() {
    std::vector<double> values = {7};
    for (const double share : {0.0, 0.5, 1.0})
      QCOMPARE(quantileOf(values, share), 7.0);
  }
};

CUTIS_TEST(QuantileTest)

}  // namespace
}  // namespace cutis

#include "quantile_test.moc"
