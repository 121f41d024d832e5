#include "core/neural/dense/dense_network.h"

#include <cmath>
#include <limits>

#include <QtTest>

#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

DenseNetwork smallNetwork() {
  return randomNetwork({3, 7, 4, 2}, Activation::squareplus, Activation::sigmoid, 5);
}

SampleMatrix<double> samples() {
  return SampleMatrix<double>::NullaryExpr(3, 20, [](Eigen::Index i, Eigen::Index j) {
    return std::sin(static_cast<double>(3 * j + i));
  });
}

class DenseNetworkTest : public QObject {
  Q_OBJECT

 private slots:
  // One unit of each kind, by hand.
  void activations_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<double>("below");
    QTest::addColumn<double>("above");
    QTest::newRow("linear") << "linear" << -0.75 << 0.75;
    QTest::newRow("relu") << "relu" << 0.0 << 0.75;
    QTest::newRow("sigmoid") << "sigmoid" << 1.0 / (1.0 + std::exp(0.75))
                             << 1.0 / (1.0 + std::exp(-0.75));
    QTest::newRow("squareplus") << "squareplus" << 0.25 << 1.0;
  }
  void activations() {
    QFETCH(QString, name);
    QFETCH(double, below);
    QFETCH(double, above);
    const auto activation = activationByName(name.toStdString());
    QVERIFY(activation.has_value());
    QCOMPARE(QString::fromUtf8(activationName(*activation).data()), name);
    DenseLayer unit = linearLayer(Eigen::MatrixXd::Constant(1, 1, 1.5), Eigen::VectorXd::Zero(1));
    unit.activation = *activation;
    SampleMatrix<double> at(1, 2);
    at << -0.5, 0.5;
    const SampleMatrix<double> values = evaluate<double>({{unit}}, at);
    EXPECT_NEAR(values(0, 0), below, 1e-12);
    EXPECT_NEAR(values(0, 1), above, 1e-12);
    QVERIFY(!activationByName("step").has_value());
  }

  void seedDecidesTheWeights() {
    QVERIFY(smallNetwork() == smallNetwork());
    const auto other = randomNetwork({3, 7, 4, 2}, Activation::squareplus, Activation::sigmoid, 6);
    QVERIFY(!(smallNetwork() == other));
    QCOMPARE(smallNetwork().parameterCount(), std::size_t{3 * 7 + 7 + 7 * 4 + 4 + 4 * 2 + 2});
    QCOMPARE(smallNetwork().workPerSample(), std::size_t{3 * 7 + 7 * 4 + 4 * 2});
  }

  void linearLayersFoldIntoTheNext() {
    const Eigen::MatrixXd turn = Eigen::MatrixXd::Random(3, 3);
    const Eigen::MatrixXd rows = Eigen::MatrixXd::Random(5, 2);
    DenseNetwork network;
    network.layers.push_back(linearLayer(turn, Eigen::VectorXd::Ones(3)));
    network.layers.push_back(linearLayer(turn, Eigen::VectorXd::Ones(3)));
    network = joined(network, smallNetwork());
    network.layers.push_back(linearLayer(rows, Eigen::VectorXd::Ones(5)));
    network.layers.push_back(linearLayer(rows.transpose(), Eigen::VectorXd::Ones(2)));
    const DenseNetwork folded = merged(network);
    QCOMPARE(folded.layers.size(), std::size_t{4});
    const double worst =
        (evaluate<double>(network, samples()) - evaluate<double>(folded, samples()))
            .cwiseAbs()
            .maxCoeff();
    EXPECT_AT_MOST(worst, 2e-6);
    const double single = (evaluate<float>(network, samples().cast<float>()).cast<double>() -
                           evaluate<double>(network, samples()))
                              .cwiseAbs()
                              .maxCoeff();
    EXPECT_AT_MOST(single, 5e-6);
  }

  void damageIsNamed() {
    EXPECT_OK(validate(smallNetwork(), "weights"));
    EXPECT_ERROR(validate(DenseNetwork(), "weights"), "weights: a network has 1 to 16 layers");
    DenseNetwork network = smallNetwork();
    network.layers[1].weights.pop_back();
    EXPECT_ERROR(validate(network, "weights"), "layer 2 needs 28 weights and 4 biases, not 27");
    network = smallNetwork();
    network.layers[2].bias[1] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_ERROR(validate(network, "weights"), "layer 3 has a weight that is not a finite number");
    network.layers[2].bias[1] = 1e30f;
    EXPECT_ERROR(validate(network, "weights"), "layer 3 has a weight that is not a finite number");
    network = smallNetwork();
    network.layers.erase(network.layers.begin() + 1);
    EXPECT_ERROR(validate(network, "weights"), "layer 2 has 4 inputs");
    network = smallNetwork();
    network.layers[0].inputs = -1;
    EXPECT_ERROR(validate(network, "weights"), "layer 1 must have 1 to 512");
    network.layers[0].inputs = 2'000'000'000;
    EXPECT_ERROR(validate(network, "weights"), "layer 1 must have 1 to 512");
  }
};

CUTIS_TEST(DenseNetworkTest)

}  // namespace
}  // namespace cutis

#include "dense_network_test.moc"
