// ChromNN as a pixel solver, with the networks that ship: accuracy, independence of neighbours, and
// what it says of networks of others.

#include "core/fit/network_solver.h"

#include <cmath>

#include <QtTest>

#include "core/fit/population.h"
#include "core/skin/pixel_state.h"
#include "src/files/networks/network_file.h"
#include "tests/core/fit/fit_fixture.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

constexpr int kNetworkPeople = 1000;

const ChromophoreNetwork& shippedNetwork() {
  static const ChromophoreNetwork network = [] {
    auto file = builtInNetworks("monitor_li2024");
    return file ? std::move(file).value().chromophores : ChromophoreNetwork();
  }();
  return network;
}

std::shared_ptr<const ResponseModel> monitorChannels() {
  static const auto channels =
      std::make_shared<const ResponseModel>(test::li2024(), responseRows(test::monitorRig()));
  return channels;
}

double meanError(double noise) {
  const auto people = drawPopulation(protocolPopulation(), kNetworkPeople, 77);
  const auto solver =
      makeNetworkSolver(shippedNetwork(), networkChannels(test::monitorRig()), monitorChannels());
  const auto solutions = test::solve(*solver, test::simulate(test::monitorRig(), people, noise));
  double sum = 0.0;
  for (std::size_t i = 0; i < people.size(); ++i)
    sum += test::visibleError(people[i], solutions.at(i));
  return sum / kNetworkPeople;
}

class NetworkSolverTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { EXPECT_OK(validate(shippedNetwork(), "shipped network")); }

  void findsThePopulationWithoutNoise() { EXPECT_AT_MOST(meanError(0.0), 1e-5); }

  // The refined fit has 3.8e-6 here.
  void bearsNoise() { EXPECT_AT_MOST(meanError(0.005), 1e-5); }

  void eachPixelIsSolvedByItself() {
    const auto people = drawPopulation(protocolPopulation(), 37, 5);
    const auto solver =
        makeNetworkSolver(shippedNetwork(), networkChannels(test::monitorRig()), monitorChannels());
    const auto pixels = test::simulate(test::monitorRig(), people);
    const auto together = test::solve(*solver, pixels);
    for (std::size_t i = 0; i < people.size(); ++i) {
      const auto alone = test::solve(*solver, test::simulate(test::monitorRig(), {people[i]}));
      QVERIFY((alone.at(0) == together.at(i)).all());
      QVERIFY(together.states[i] == PixelState::solved);
      QCOMPARE(together.iterations[i], std::uint16_t{0});
    }
    QVERIFY(!solver->hasDeviations());
  }

  void strangeChannelsHaveAnAnswerInTheBox() {
    const auto solver =
        makeNetworkSolver(shippedNetwork(), networkChannels(test::monitorRig()), monitorChannels());
    const auto solutions = test::solve(*solver, test::pixelsOf({std::vector<float>(9, 0.0f),
                                                                std::vector<float>(9, 1e30f),
                                                                {1, 0, 1, 0, 1, 0, 1, 0, 1}}));
    const ParameterAxes& axes = test::li2024().profile().axes;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < axes.size(); ++k) {
        const double value = solutions.at(i)[static_cast<Eigen::Index>(k)];
        QVERIFY(value >= 0.0);
        EXPECT_AT_MOST(value, axes[k].maximum * (1.0 + 1e-6));
      }
    }
  }

  // The paper's five inputs, made of the nine channels.
  void networksOfFiveChannelsFit() {
    auto file = builtInNetworks("monitor-5_li2024");
    EXPECT_OK(file);
    const ChromophoreNetwork& network = file.value().chromophores;
    const auto channels =
        matchNetwork(network, test::li2024().profile(), test::monitorRig(), "--weights");
    EXPECT_OK(channels);
    QCOMPARE(channels.value().inputCount(), 5);
    const auto solver = makeNetworkSolver(network, channels.value(), monitorChannels());
    const auto people = drawPopulation(protocolPopulation(), 300, 78);
    const auto pixels = test::simulate(test::monitorRig(), people);
    const auto solutions = test::solve(*solver, pixels);
    double sum = 0.0;
    for (std::size_t i = 0; i < people.size(); ++i)
      sum += test::visibleError(people[i], solutions.at(i));
    EXPECT_AT_MOST(sum / 300.0, 1e-5);
    // The plain way has inputs in double precision, and the network likewise.
    for (std::size_t i = 0; i < 20; ++i) {
      const Eigen::MatrixXd seen = pixels.at(i).transpose();
      const Eigen::MatrixXd logs = channels.value().inputs(seen).array().log();
      const auto coordinates = evaluate<double>(network.network, logs.transpose());
      for (std::size_t k = 0; k < network.axes.size(); ++k) {
        const auto row = static_cast<Eigen::Index>(k);
        EXPECT_NEAR(networkCoordinate(network.axes[k], solutions.at(i)[row]), coordinates(row, 0),
                    2e-5);
      }
    }
  }

  void overflowIsToldAndNotWritten() {
    ChromophoreNetwork network = shippedNetwork();
    std::vector<DenseLayer>& layers = network.network.layers;
    const DenseLayer middle = layers[1];
    layers.insert(layers.begin() + 1, 5, middle);
    for (DenseLayer& layer : layers) {
      for (std::size_t i = 0; i < layer.weights.size(); ++i)
        layer.weights[i] = i % 2 == 0 ? 1e7f : -9e6f;
    }
    EXPECT_OK(validate(network, "network"));
    const auto solver =
        makeNetworkSolver(network, networkChannels(test::monitorRig()), monitorChannels());
    const auto solutions =
        test::solve(*solver, test::pixelsOf({{.1f, .2f, .3f, .1f, .2f, .3f, .1f, .2f, .3f}}));
    QVERIFY(solutions.at(0).isFinite().all());
  }

  void networksOfOthersAreRefused() {
    const Profile& profile = test::li2024().profile();
    EXPECT_OK(matchNetwork(shippedNetwork(), profile, test::monitorRig(), "--weights"));
    const auto rig = matchNetwork(shippedNetwork(), profile, test::albedoRig(), "w");
    EXPECT_ERROR(rig, "w: the network was trained for other lights or another camera");
    Rig blind = test::monitorRig();
    blind.lights[1].mix.reset();
    EXPECT_OK(matchNetwork(shippedNetwork(), profile, blind, "w"));
    Profile other = profile;
    other.epidermalThicknessMm *= 1.5;
    EXPECT_ERROR(matchNetwork(shippedNetwork(), other, test::monitorRig(), "w"),
                 "another profile than 'li2024'");
  }
};

CUTIS_TEST(NetworkSolverTest)

}  // namespace
}  // namespace cutis

#include "network_solver_test.moc"
