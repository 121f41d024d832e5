#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include <QtTest>

#include "core/base/instruction_set.h"
#include "core/skin/model/reflectance_batch.h"
#include "core/skin/profile/parameter_sampling.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

const SkinModel& profileModel() {
  return test::li2024();
}

std::vector<int> wholeGrid() {
  std::vector<int> samples(kSampleCount);
  std::iota(samples.begin(), samples.end(), 0);
  return samples;
}

// Evenly spread points, and the corners of the box.
std::vector<ParameterVector> testPoints() {
  std::vector<ParameterVector> points = sampleBox(profileModel().profile().axes, 3000);
  for (int corner = 0; corner < 32; ++corner) {
    ParameterVector p;
    for (int k = 0; k < kParameterCount; ++k) {
      p[k] = (corner >> k & 1) * profileModel().profile().axes[static_cast<std::size_t>(k)].maximum;
    }
    points.push_back(p);
  }
  return points;
}

struct ModelErrors {
  double value = 0.0;
  double slope = 0.0;  // in units of 1e-4 · max(|∂R|, 1e-3)
};

template <typename T>
ModelErrors errorsAgainstReference() {
  const CompiledModel nodes(profileModel(), wholeGrid());
  const std::vector<ParameterVector> points = testPoints();
  const PixelBuffer<T> parameters = parameterRows<T>(points);
  const std::size_t count = points.size();
  std::vector<T> value(count * kSampleCount), epidermal(value), dermal(value);
  const auto rowsOf = [&](std::vector<T>& of) {
    return packedRows(of.data(), kSampleCount, count);
  };
  reflectanceBatch<T>(nodes, parameters.rows(), rowsOf(value), rowsOf(epidermal), rowsOf(dermal));
  ModelErrors errors;
  for (std::size_t i = 0; i < count; ++i) {
    // The reference sees the rounded parameters: the kernel answers for its own arithmetic.
    ParameterVector p;
    for (std::size_t k = 0; k < kParameterCount; ++k)
      p[static_cast<Eigen::Index>(k)] = parameters[k][i];
    for (int s = 0; s < kSampleCount; ++s) {
      const LayerPair absorption = profileModel().absorption().at(s, p);
      const LayeredReflectance exact =
          profileModel().optics().evaluate(s, absorption.epidermal, absorption.dermal);
      const std::size_t at = static_cast<std::size_t>(s) * count + i;
      errors.value = std::max(errors.value, std::abs(value[at] - exact.reflectance));
      const auto slopeError = [](double a, double b) {
        return std::abs(a - b) / (1e-4 * std::max(std::abs(b), 1e-3));
      };
      errors.slope =
          std::max({errors.slope, slopeError(epidermal[at], exact.perEpidermalAbsorption),
                    slopeError(dermal[at], exact.perDermalAbsorption)});
    }
  }
  return errors;
}

class VectorisedModelTest : public QObject {
  Q_OBJECT

 private slots:
  void init() { EXPECT_OK(pinInstructionSet("")); }
  void cleanup() { EXPECT_OK(pinInstructionSet("")); }

  void agreesWithTheReference_data() {
    QTest::addColumn<QString>("instructionSet");
    for (const char* name : {"scalar", "sse4", "avx2", "avx512"})
      QTest::newRow(name) << name;
  }
  void agreesWithTheReference() {
    QFETCH(QString, instructionSet);
    if (!pinInstructionSet(instructionSet.toStdString())) QSKIP("not on this processor");
    const ModelErrors single = errorsAgainstReference<float>();
    qInfo("float: %.2g, derivatives %.2g of the allowed error", single.value, single.slope);
    EXPECT_AT_MOST(single.value, 2e-6);
    EXPECT_AT_MOST(single.slope, 1.0);
    const ModelErrors twice = errorsAgainstReference<double>();
    qInfo("double: %.2g, derivatives %.2g of the allowed error", twice.value, twice.slope);
    EXPECT_AT_MOST(twice.value, 1e-12);
    EXPECT_AT_MOST(twice.slope, 1e-4);
  }

  void aPixelDoesNotDependOnItsPlace() {
    const CompiledModel nodes(profileModel(), {20, 60, 100, 140, 180});
    const std::vector<ParameterVector> points = sampleBox(profileModel().profile().axes, 37);
    const PixelBuffer<float> parameters = parameterRows<float>(points);
    PixelBuffer<float> together(5, points.size());
    reflectanceBatch<float>(nodes, parameters.rows(), together.rows());
    for (std::size_t i = 0; i < points.size(); ++i) {
      float alone[5];
      reflectanceBatch<float>(nodes, parameters.rows().part(i, 1), packedRows(alone, 5, 1));
      for (std::size_t n = 0; n < 5; ++n)
        QCOMPARE(alone[n], together[n][i]);
    }
  }

  // Rows that lie apart, in and out: what is between them is not touched.
  void rowsMayLieApart() {
    const CompiledModel nodes(profileModel(), {20, 60, 100});
    const std::vector<ParameterVector> points = sampleBox(profileModel().profile().axes, 40);
    const PixelBuffer<float> parameters = parameterRows<float>(points);
    PixelBuffer<float> whole(3, 40), part(3, 40);
    reflectanceBatch<float>(nodes, parameters.rows(), whole.rows());
    reflectanceBatch<float>(nodes, parameters.rows().part(7, 21), part.rows().part(7, 21));
    for (std::size_t n = 0; n < 3; ++n) {
      for (std::size_t i = 0; i < 40; ++i)
        QCOMPARE(part[n][i], i >= 7 && i < 28 ? whole[n][i] : 0.0f);
    }
  }

  void notANumberStaysInItsPixel() {
    const CompiledModel nodes(profileModel(), {100});
    std::vector<ParameterVector> points = sampleBox(profileModel().profile().axes, 20);
    PixelBuffer<float> clean(1, points.size()), spoiled(clean);
    reflectanceBatch<float>(nodes, parameterRows<float>(points).rows(), clean.rows());
    points[7][kMelanin] = std::numeric_limits<double>::quiet_NaN();
    reflectanceBatch<float>(nodes, parameterRows<float>(points).rows(), spoiled.rows());
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (i != 7) QCOMPARE(spoiled[0][i], clean[0][i]);
    }
  }

  void unknownInstructionSetsAreNamed() {
    EXPECT_ERROR(pinInstructionSet("mmx"), "scalar, sse4, avx2, avx512");
  }
};

CUTIS_TEST(VectorisedModelTest)

}  // namespace
}  // namespace cutis

#include "vectorised_model_test.moc"
