#include "core/neural/dense/back_propagation.h"

#include <cmath>

#include <QtTest>

#include "core/base/instruction_set.h"
#include "core/base/random.h"
#include "core/neural/dense/dense_kernel.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

constexpr std::size_t kStride = 2 * kSampleStep;
constexpr std::size_t kLive = 61;

// Sizes that leave odd rests in every tile of the kernels.
DenseNetwork example(Activation hidden) {
  return randomNetwork({5, 13, 6, 7, 3}, hidden, Activation::sigmoid, 3);
}

struct Samples {
  std::vector<float> inputs = std::vector<float>(5 * kStride);
  std::vector<float> targets = std::vector<float>(3 * kStride);
  std::vector<float> weights = {1.0f, 0.5f, 4.0f};

  Samples() {
    Random random(8);
    for (float& x : inputs)
      x = static_cast<float>(random.normal());
    for (float& t : targets)
      t = static_cast<float>(random.uniform());
  }
  SamplePiece piece() const {
    return {{inputs.data(), 5, kLive, kStride}, {targets.data(), 3, kLive, kStride}};
  }

  // The definition, in double precision.
  double error(const DenseNetwork& network) const {
    using Columns = Eigen::Map<const Eigen::MatrixXf>;
    const SampleMatrix<double> in =
        Columns(inputs.data(), kStride, 5).topRows(kLive).transpose().cast<double>();
    const SampleMatrix<double> expected =
        Columns(targets.data(), kStride, 3).topRows(kLive).transpose().cast<double>();
    const SampleMatrix<double> away = evaluate<double>(network, in) - expected;
    double sum = 0.0;
    for (Eigen::Index k = 0; k < 3; ++k) {
      sum += double{weights[static_cast<std::size_t>(k)]} * away.row(k).squaredNorm();
    }
    return sum;
  }
};

// Central difference of the definition by one number of the network. Numbers are floats: the step
// is what really changed.
double slopeBy(float& number, const DenseNetwork& network, const Samples& samples) {
  const float before = number;
  number = before + 1e-3f;
  const double high = double{number};
  const double above = samples.error(network);
  number = before - 1e-3f;
  const double slope = (above - samples.error(network)) / (high - double{number});
  number = before;
  return slope;
}

class BackPropagationTest : public QObject {
  Q_OBJECT

 private slots:
  void cleanup() { EXPECT_OK(pinInstructionSet("")); }

  void gradientIsTheSlopeOfTheError_data() {
    QTest::addColumn<QString>("activation");
    QTest::addColumn<QString>("instructionSet");
    for (const char* activation : {"linear", "relu", "sigmoid", "squareplus"}) {
      for (const char* set : {"scalar", "sse4", "avx2", "avx512"}) {
        QTest::addRow("%s %s", activation, set) << activation << set;
      }
    }
  }
  void gradientIsTheSlopeOfTheError() {
    QFETCH(QString, activation);
    QFETCH(QString, instructionSet);
    if (!pinInstructionSet(instructionSet.toStdString())) QSKIP("not on this processor");
    DenseNetwork network = example(*activationByName(activation.toStdString()));
    const Samples samples;
    const BackPropagation propagation(network, samples.weights, {});
    QCOMPARE(propagation.gradientSize(), network.parameterCount());
    std::vector<float> gradient(propagation.gradientSize(), 0.0f);
    PropagationScratch scratch;
    const double error = propagation.addGradient(samples.piece(), scratch, gradient.data());
    EXPECT_NEAR(error, samples.error(network), 1e-5 * error);
    EXPECT_NEAR(propagation.error(samples.piece(), scratch), error, 0.0);

    std::size_t at = 0;
    double worst = 0.0;
    double largest = 0.0;
    for (DenseLayer& layer : network.layers) {
      for (std::vector<float>* numbers : {&layer.weights, &layer.bias}) {
        for (float& number : *numbers) {
          const double slope = slopeBy(number, network, samples);
          worst = std::max(worst, std::abs(slope - double{gradient[at++]}));
          largest = std::max(largest, std::abs(slope));
        }
      }
    }
    // A relu may turn its corner within the step.
    EXPECT_AT_MOST(worst, (activation == "relu" ? 3e-3 : 2e-5) * largest);
  }

  // The gradient of the layers that are trained is a part of the whole one.
  void layersThatStayAreLeftOut() {
    const DenseNetwork network = example(Activation::squareplus);
    const Samples samples;
    PropagationScratch scratch;
    const BackPropagation whole(network, samples.weights, {});
    const BackPropagation middle(network, samples.weights, {1, 3});
    std::vector<float> all(whole.gradientSize(), 0.0f);
    std::vector<float> part(middle.gradientSize(), 0.0f);
    whole.addGradient(samples.piece(), scratch, all.data());
    middle.addGradient(samples.piece(), scratch, part.data());
    const auto first = static_cast<std::ptrdiff_t>(13 * 5 + 13);
    const auto size = static_cast<std::ptrdiff_t>(part.size());
    QCOMPARE(part.size(), std::size_t{13 * 6 + 6 + 6 * 7 + 7});
    QVERIFY(part == std::vector<float>(all.begin() + first, all.begin() + first + size));
  }

  // Samples beyond the live ones change nothing, and the gradient is added to what was there.
  void onlyLiveSamplesCount() {
    const DenseNetwork network = example(Activation::relu);
    Samples samples;
    PropagationScratch scratch;
    const BackPropagation propagation(network, samples.weights, {});
    std::vector<float> once(propagation.gradientSize(), 0.0f);
    propagation.addGradient(samples.piece(), scratch, once.data());
    for (std::size_t k = 0; k < 5; ++k) {
      for (std::size_t i = kLive; i < kStride; ++i)
        samples.inputs[k * kStride + i] = 1e3f;
    }
    std::vector<float> twice(propagation.gradientSize(), 1.0f);
    propagation.addGradient(samples.piece(), scratch, twice.data());
    for (std::size_t k = 0; k < once.size(); ++k) {
      EXPECT_NEAR(twice[k], once[k] + 1.0f, 1e-5 * (1.0 + std::abs(double{once[k]})));
    }
  }
};

CUTIS_TEST(BackPropagationTest)

}  // namespace
}  // namespace cutis

#include "back_propagation_test.moc"
