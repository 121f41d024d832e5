#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <QtTest>

#include "core/base/instruction_set.h"
#include "core/skin/layers/table.h"
#include "core/skin/layers/table_batch.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

const LayerTable& table() {
  static const LayerTable made = [] {
    const std::vector<int> samples = {0, 57, 80, 125, 200, 350};
    return LayerTable::make(test::li2024().profile(), samples).value();
  }();
  return made;
}

template <typename T>
LayerPolynomial<T> polynomialOf(const LayerPolynomial<double>& exact) {
  if constexpr (sizeof(T) == 4) {
    return singlePrecision(exact);
  } else {
    return exact;
  }
}

// Pairs over the whole range, denser towards clear skin, and beyond its ends.
template <typename T>
struct Pairs {
  Pairs(const LayerPolynomial<double>& p, int count) {
    for (int i = 0; i < count; ++i) {
      const double a = std::fmod(0.7548776662 * i, 1.0), b = std::fmod(0.5698402910 * i, 1.0);
      epidermal.push_back(static_cast<T>(p.epidermis.high * (1.05 * a * a * a)));
      dermal.push_back(static_cast<T>(p.dermis.high * (1.05 * b * b)));
    }
    value.resize(epidermal.size());
    perEpidermal = perDermal = value;
  }
  LayerTableBatch<T> batch(bool derivatives = true) {
    return {epidermal.data(),
            dermal.data(),
            epidermal.size(),
            value.data(),
            derivatives ? perEpidermal.data() : nullptr,
            derivatives ? perDermal.data() : nullptr};
  }
  std::vector<T> epidermal, dermal, value, perEpidermal, perDermal;
};

struct KernelErrors {
  double value = 0.0, slope = 0.0;  // slope in units of max(|∂R|, 1e-2)
};

template <typename T>
KernelErrors errorsAgainstDouble() {
  KernelErrors errors;
  for (const LayerPolynomial<double>& exact : table().polynomials()) {
    Pairs<T> pairs(exact, 3001);
    evaluateBatch(polynomialOf<T>(exact), pairs.batch());
    for (std::size_t i = 0; i < pairs.value.size(); ++i) {
      const LayeredReflectance r = evaluate(exact, pairs.epidermal[i], pairs.dermal[i]);
      const auto slopeError = [](double a, double b) {
        return std::abs(a - b) / std::max(std::abs(b), 1e-2);
      };
      errors.value = std::max(errors.value, std::abs(pairs.value[i] - r.reflectance));
      errors.slope =
          std::max({errors.slope, slopeError(pairs.perEpidermal[i], r.perEpidermalAbsorption),
                    slopeError(pairs.perDermal[i], r.perDermalAbsorption)});
    }
  }
  return errors;
}

class LayerTableKernelTest : public QObject {
  Q_OBJECT

 private slots:
  void init() { EXPECT_OK(pinInstructionSet("")); }
  void cleanup() { EXPECT_OK(pinInstructionSet("")); }

  void agreesWithTheOracle_data() {
    QTest::addColumn<QString>("instructionSet");
    for (const char* name : {"scalar", "sse4", "avx2", "avx512"})
      QTest::newRow(name) << name;
  }
  void agreesWithTheOracle() {
    QFETCH(QString, instructionSet);
    if (!pinInstructionSet(instructionSet.toStdString())) QSKIP("not on this processor");
    const KernelErrors single = errorsAgainstDouble<float>();
    qInfo("float: %.2g, derivatives %.2g", single.value, single.slope);
    EXPECT_AT_MOST(single.value, 2e-6);
    EXPECT_AT_MOST(single.slope, 1e-3);
    const KernelErrors twice = errorsAgainstDouble<double>();
    qInfo("double: %.2g, derivatives %.2g", twice.value, twice.slope);
    EXPECT_AT_MOST(twice.value, 1e-13);
    EXPECT_AT_MOST(twice.slope, 1e-10);
  }

  void valuesAreTheSameWithoutDerivatives() {
    const LayerPolynomial<float> p = singlePrecision(table().at(125));
    Pairs<float> with(table().at(125), 100), without(table().at(125), 100);
    evaluateBatch(p, with.batch());
    evaluateBatch(p, without.batch(false));
    QCOMPARE(with.value, without.value);
  }

  void aPairDoesNotDependOnItsPlace() {
    const LayerPolynomial<float> p = singlePrecision(table().at(125));
    Pairs<float> together(table().at(125), 37);
    evaluateBatch(p, together.batch());
    for (std::size_t i = 0; i < together.value.size(); ++i) {
      float value = 0.0f, perE = 0.0f, perD = 0.0f;
      evaluateBatch<float>(p,
                           {&together.epidermal[i], &together.dermal[i], 1, &value, &perE, &perD});
      QCOMPARE(value, together.value[i]);
      QCOMPARE(perE, together.perEpidermal[i]);
      QCOMPARE(perD, together.perDermal[i]);
    }
  }

  void notANumberStaysInItsPair() {
    const LayerPolynomial<float> p = singlePrecision(table().at(125));
    Pairs<float> clean(table().at(125), 20);
    Pairs<float> spoiled = clean;
    spoiled.epidermal[7] = std::numeric_limits<float>::quiet_NaN();
    evaluateBatch(p, clean.batch());
    evaluateBatch(p, spoiled.batch());
    for (std::size_t i = 0; i < clean.value.size(); ++i) {
      if (i != 7) QCOMPARE(spoiled.value[i], clean.value[i]);
    }
  }
};

CUTIS_TEST(LayerTableKernelTest)

}  // namespace
}  // namespace cutis

#include "layer_table_kernel_test.moc"
