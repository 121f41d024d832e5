#include "core/neural/network_pipeline.h"

#include <cmath>
#include <limits>

#include <QtTest>

#include "core/base/instruction_set.h"
#include "core/base/random.h"
#include "tests/core/neural/neural_fixture.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

using Eigen::Index;
using Eigen::MatrixXf;

// Random networks: the kernel has to agree with the plain one whatever they compute.
ChromophoreNetwork randomChromophores(Activation hidden) {
  ChromophoreNetwork network;
  network.profile = {1.0f};
  network.axes = test::li2024().profile().axes;
  network.network = randomNetwork({9, 30, 21, 5}, hidden, Activation::sigmoid, 1);
  return network;
}

SpectraNetwork randomSpectra(Activation hidden) {
  SpectraNetwork network;
  network.profile = {1.0f};
  network.axes = test::li2024().profile().axes;
  network.mean = test::sampledBasis().mean;
  network.components = test::sampledBasis().components.leftCols(7);
  network.network = randomNetwork({5, 26, 33, 7}, hidden, Activation::linear, 2);
  return network;
}

SpectrumRows monitorRows() {
  return responseRows(test::monitorRig());
}

MatrixXf randomPixels(Index count, Index channels) {
  Random random(3);
  return MatrixXf::NullaryExpr(count, channels,
                               [&] { return static_cast<float>(random.uniform(0.0, 0.9)); });
}

MatrixXf randomPeople(Index count) {
  Random random(4);
  const ParameterAxes& axes = test::li2024().profile().axes;
  return MatrixXf::NullaryExpr(count, kParameterCount, [&](Index, Index k) {
    return static_cast<float>(
        parameterOfCoordinate(axes[static_cast<std::size_t>(k)], random.uniform()));
  });
}

struct Passed {
  MatrixXf parameters;
  MatrixXf outputs;
};

Passed run(const NetworkPipeline& pipeline, const MatrixXf& in, bool hasEncoder) {
  Passed result = {MatrixXf::Zero(in.rows(), hasEncoder ? kParameterCount : 0),
                   MatrixXf::Zero(in.rows(), pipeline.outputCount())};
  pipeline.run(test::rowsOf(in), test::rowsOf(result.parameters), test::rowsOf(result.outputs));
  return result;
}

// NaN where either is.
double worst(const MatrixXf& a, const SampleMatrix<double>& b) {
  double largest = 0.0;
  for (Index i = 0; i < a.size(); ++i) {
    const double away = std::abs(double{a.reshaped()[i]} - b.reshaped()[i]);
    if (!(away <= largest)) largest = away;
  }
  return largest;
}

// One pixel a row.
SampleMatrix<double> coordinatesOf(const ParameterAxes& axes, const MatrixXf& parameters) {
  return SampleMatrix<double>::NullaryExpr(
      parameters.rows(), parameters.cols(), [&](Index i, Index k) {
        return networkCoordinate(axes[static_cast<std::size_t>(k)], double{parameters(i, k)});
      });
}

SampleMatrix<double> plainEncoder(const ChromophoreNetwork& network, const MatrixXf& channels) {
  const SampleMatrix<double> logs =
      channels.cast<double>().array().max(kSmallestNetworkChannel).log().matrix().transpose();
  return evaluate<double>(network.network, logs).transpose();
}

SampleMatrix<double> plainDecoder(const SpectraNetwork& network, const SpectrumRows& rows,
                                  const SampleMatrix<double>& coordinates) {
  const SampleMatrix<double> weights = evaluate<double>(network.network, coordinates.transpose());
  const SampleMatrix<double> spectra =
      (network.components * weights).colwise() + network.mean.matrix();
  return (rows.matrix() * spectra).transpose();
}

class NetworkPipelineTest : public QObject {
  Q_OBJECT

 private slots:
  void cleanup() { EXPECT_OK(pinInstructionSet("")); }

  void agreesWithThePlainNetworks_data() {
    QTest::addColumn<QString>("activation");
    QTest::addColumn<QString>("instructionSet");
    for (const char* activation : {"relu", "sigmoid", "squareplus"}) {
      for (const char* set : {"scalar", "sse4", "avx2", "avx512"}) {
        QTest::addRow("%s %s", activation, set) << activation << set;
      }
    }
  }
  void agreesWithThePlainNetworks() {
    QFETCH(QString, activation);
    QFETCH(QString, instructionSet);
    if (!pinInstructionSet(instructionSet.toStdString())) QSKIP("not on this processor");
    const Activation hidden = *activationByName(activation.toStdString());
    const ChromophoreNetwork chromophores = randomChromophores(hidden);
    const SpectraNetwork spectra = randomSpectra(hidden);
    const auto both = NetworkPipeline::encoderDecoder(chromophores, spectra, monitorRows());
    EXPECT_OK(both);
    const MatrixXf channels = randomPixels(203, 9);
    const Passed passed = run(both.value(), channels, true);
    const SampleMatrix<double> coordinates = plainEncoder(chromophores, channels);
    EXPECT_AT_MOST(worst(coordinatesOf(spectra.axes, passed.parameters).cast<float>(), coordinates),
                   2e-5);
    EXPECT_AT_MOST(worst(passed.outputs, plainDecoder(spectra, monitorRows(), coordinates)), 2e-5);

    const MatrixXf people = randomPeople(203);
    const Passed decoded = run(NetworkPipeline::decoder(spectra, monitorRows()), people, false);
    EXPECT_AT_MOST(worst(decoded.outputs,
                         plainDecoder(spectra, monitorRows(), coordinatesOf(spectra.axes, people))),
                   2e-5);
    const Passed encoded = run(NetworkPipeline::encoder(chromophores), channels, true);
    QVERIFY(encoded.parameters == passed.parameters);
  }

  void anyDivisionGivesTheSameBits() {
    const auto both =
        NetworkPipeline::encoderDecoder(randomChromophores(Activation::squareplus),
                                        randomSpectra(Activation::squareplus), monitorRows());
    EXPECT_OK(both);
    const MatrixXf channels = randomPixels(200, 9);
    const Passed whole = run(both.value(), channels, true);
    for (const Index size : {1, 2, 47, 48, 49, 96, 199}) {
      const Passed part = run(both.value(), channels.bottomRows(size), true);
      QVERIFY(part.parameters == whole.parameters.bottomRows(size));
      QVERIFY(part.outputs == whole.outputs.bottomRows(size));
    }
    run(both.value(), channels.topRows(0), true);
  }

  void whatIsNotANumberStaysInItsPixel() {
    const auto both = NetworkPipeline::encoderDecoder(
        randomChromophores(Activation::relu), randomSpectra(Activation::relu), monitorRows());
    EXPECT_OK(both);
    const MatrixXf channels = randomPixels(100, 9);
    const Passed good = run(both.value(), channels, true);
    for (const float bad :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
          -std::numeric_limits<float>::infinity()}) {
      MatrixXf damaged = channels;
      damaged(17, 4) = bad;
      const Passed passed = run(both.value(), damaged, true);
      QVERIFY(passed.parameters.row(17).array().isNaN().all());
      QVERIFY(passed.outputs.row(17).array().isNaN().all());
      QVERIFY(passed.outputs.topRows(17) == good.outputs.topRows(17));
      QVERIFY(passed.outputs.bottomRows(82) == good.outputs.bottomRows(82));
    }
    const auto decoder = NetworkPipeline::decoder(randomSpectra(Activation::relu), monitorRows());
    MatrixXf people = randomPeople(60);
    people(59, 0) = std::numeric_limits<float>::quiet_NaN();
    const Passed decoded = run(decoder, people, false);
    QVERIFY(decoded.outputs.row(59).array().isNaN().all());
    QVERIFY(decoded.outputs.topRows(59).allFinite());
  }

  // Black, negative and blinding channels, and parameters beyond their axes.
  void extremesStayFinite() {
    const ChromophoreNetwork chromophores = randomChromophores(Activation::squareplus);
    const SpectraNetwork spectra = randomSpectra(Activation::squareplus);
    MatrixXf channels = MatrixXf::Zero(4, 9);
    channels.row(1).setConstant(-3.0f);
    channels.row(2).setConstant(1e30f);
    channels.row(3).setConstant(1e-4f);
    const Passed encoded = run(NetworkPipeline::encoder(chromophores), channels, true);
    QVERIFY(encoded.parameters.allFinite());
    QVERIFY(encoded.parameters.row(0) == encoded.parameters.row(1));
    QVERIFY(encoded.parameters.row(0) == encoded.parameters.row(3));
    MatrixXf people(3, kParameterCount);
    people << 0, 0, 0, 0, 0, -1, -1, -1, -1, -1, 9, 9, 9, 9, 9;
    const Passed decoded = run(NetworkPipeline::decoder(spectra, monitorRows()), people, false);
    QVERIFY(decoded.outputs.allFinite());
    QVERIFY(decoded.outputs.row(0) == decoded.outputs.row(1));
  }

  void networksOfDifferentProfilesAreRefused() {
    ChromophoreNetwork chromophores = randomChromophores(Activation::relu);
    chromophores.profile = {2.0f};
    EXPECT_ERROR(NetworkPipeline::encoderDecoder(chromophores, randomSpectra(Activation::relu),
                                                 monitorRows()),
                 "different profiles");
  }
};

CUTIS_TEST(NetworkPipelineTest)

}  // namespace
}  // namespace cutis

#include "network_pipeline_test.moc"
