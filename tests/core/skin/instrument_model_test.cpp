// The model as an instrument sees it: the model itself where nothing is in between, and derivatives
// that are those of its values.

#include "core/skin/model/instrument_model.h"

#include <cmath>

#include <QtTest>

#include "core/skin/profile/parameter_sampling.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis::test {
namespace {

class MeasuredModelTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void withoutAnythingBetweenItIsTheModel() {
    const InstrumentModel measured(li2024(), {});
    for (const ParameterVector& set : sampleBox(li2024().profile().axes, 50, 700)) {
      QVERIFY((measured.reflectance(set) == li2024().reflectance(set)).all());
      ParameterVector own, seen;
      QCOMPARE(measured.reflectanceAt(77, set, seen), li2024().reflectanceAt(77, set, own));
      QVERIFY((own == seen).all());
    }
  }

  void derivativesAreThoseOfTheValues() {
    const InstrumentModel measured(li2024(), {0.03, 0.97, 0.5});
    const ParameterAxes& axes = li2024().profile().axes;
    for (ParameterVector set : sampleBox(axes, 40, 900)) {
      set = 0.05 * set + 0.001;  // where skin is, off the bounds
      for (const int sample : {20, 60, 121, 250}) {
        ParameterVector derivatives;
        EXPECT_NEAR(measured.reflectanceAt(sample, set, derivatives),
                    measured.reflectanceAt(sample, set), 1e-12);
        for (int k = 0; k < kParameterCount; ++k) {
          const double step = 1e-6 * axes[static_cast<std::size_t>(k)].maximum;
          ParameterVector low = set, high = set;
          low[k] -= step;
          high[k] += step;
          const double slope =
              (measured.reflectanceAt(sample, high) - measured.reflectanceAt(sample, low)) /
              (2.0 * step);
          EXPECT_NEAR(derivatives[k], slope, 1e-5 * std::max(1.0, std::abs(slope)));
        }
      }
    }
  }

  void edgeLossDarkens() {
    ParameterVector set;
    set << 0.02, 0.5, 0.02, 0.01, 0.001;
    const InstrumentModel wide(li2024(), {}), narrow(li2024(), {0.0, 1.0, 0.437});
    QVERIFY((narrow.reflectance(set) < wide.reflectance(set)).all());
  }
};

CUTIS_TEST(MeasuredModelTest)

}  // namespace
}  // namespace cutis::test

#include "instrument_model_test.moc"
