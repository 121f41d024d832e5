// Small trainings of both networks: they learn, they are reproducible, and they can be stopped.

#include <QtTest>
#include <tbb/global_control.h>

#include "core/fit/population.h"
#include "core/neural/network_pipeline.h"
#include "tests/core/neural/neural_fixture.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::MatrixXf;

constexpr Index kPeople = 500;

struct People {
  MatrixXf parameters = MatrixXf(kPeople, kParameterCount);
  MatrixXd spectra = MatrixXd(kPeople, kSampleCount);

  People() {
    const auto drawn = drawPopulation(protocolPopulation(), kPeople, 21);
    for (Index i = 0; i < kPeople; ++i) {
      const ParameterVector& p = drawn[static_cast<std::size_t>(i)];
      parameters.row(i) = p.matrix().transpose().cast<float>();
      spectra.row(i) = test::li2024().reflectance(p).matrix().transpose();
    }
  }
};

// Mean squared error over 400–700 nm, of spectra by a pipeline.
double visibleError(const NetworkPipeline& pipeline, const MatrixXf& in, const People& people) {
  MatrixXf out(kPeople, kSampleCount);
  pipeline.run(test::rowsOf(in), {}, test::rowsOf(out));
  const MatrixXd away = out.cast<double>() - people.spectra;
  return away.middleCols(kVisibleBand.first, kVisibleBand.count()).squaredNorm() /
         static_cast<double>(kPeople * kVisibleBand.count());
}

SpectrumRows wholeSpectra() {
  SpectrumRows rows = SpectrumRows::Zero(kSampleCount, kSampleCount);
  rows.matrix().setIdentity();
  return rows;
}

JobContext stoppedContext() {
  std::stop_source stop;
  stop.request_stop();
  JobContext context;
  context.stop = stop.get_token();
  return context;
}

class TrainingTest : public QObject {
  Q_OBJECT

 private slots:
  void spectraNetworkLearns() {
    EXPECT_OK(validate(test::quickSpectraNetwork(), "SpectraNN"));
    const People people;
    const auto decoder = NetworkPipeline::decoder(test::quickSpectraNetwork(), wholeSpectra());
    EXPECT_AT_MOST(visibleError(decoder, people.parameters, people), 2e-5);
  }

  void chromophoreNetworkLearns() {
    EXPECT_OK(validate(test::quickChromophoreNetwork(), "ChromNN"));
    const People people;
    const auto both = NetworkPipeline::encoderDecoder(test::quickChromophoreNetwork(),
                                                      test::quickSpectraNetwork(), wholeSpectra());
    EXPECT_OK(both);
    const MatrixXf channels =
        (people.spectra * responseRows(test::monitorRig()).matrix().transpose()).cast<float>();
    EXPECT_AT_MOST(visibleError(both.value(), channels, people), 5e-5);
  }

  void threadsDoNotMatter() {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
    TrainingState state;
    const auto spectra = trainSpectraNetwork(test::li2024(), test::sampledBasis(),
                                             test::quickSpectraOptions(), state, {});
    EXPECT_OK(spectra);
    QVERIFY(spectra.value().network == test::quickSpectraNetwork().network);
    TrainingState other;
    const auto chromophores =
        trainChromophoreNetwork(test::li2024(), networkChannels(test::monitorRig()),
                                spectra.value(), test::quickChromophoreOptions(), other, {});
    EXPECT_OK(chromophores);
    QVERIFY(chromophores.value().network == test::quickChromophoreNetwork().network);
  }

  void cancels() {
    TrainingState state;
    QVERIFY(trainSpectraNetwork(test::li2024(), test::sampledBasis(), {}, state, stoppedContext())
                .cancelled());
    QVERIFY(trainChromophoreNetwork(test::li2024(), networkChannels(test::monitorRig()),
                                    test::quickSpectraNetwork(), {}, state, stoppedContext())
                .cancelled());
  }

  void badOptionsAreNamed() {
    TrainingState state;
    SpectraNetworkOptions options;
    options.hidden = {};
    EXPECT_ERROR(trainSpectraNetwork(test::li2024(), test::sampledBasis(), options, state, {}),
                 "one to eight hidden layers");
    options = {};
    options.components = 65;
    EXPECT_ERROR(trainSpectraNetwork(test::li2024(), test::sampledBasis(), options, state, {}),
                 "components must be from 1 to 64");
    options = {};
    options.activation = Activation::linear;
    EXPECT_ERROR(trainSpectraNetwork(test::li2024(), test::sampledBasis(), options, state, {}),
                 "a nonlinear activation");
    SpectraNetwork foreign = test::quickSpectraNetwork();
    foreign.profile = {1.0f};
    const NetworkChannels channels = networkChannels(test::monitorRig());
    EXPECT_ERROR(trainChromophoreNetwork(test::li2024(), channels, foreign, {}, state, {}),
                 "another profile");
    NetworkChannels odd = channels;
    odd.combination = MatrixXd::Ones(5, 4);
    EXPECT_ERROR(
        trainChromophoreNetwork(test::li2024(), odd, test::quickSpectraNetwork(), {}, state, {}),
        "does not fit the channels");
    odd = channels;
    odd.names.pop_back();
    EXPECT_ERROR(
        trainChromophoreNetwork(test::li2024(), odd, test::quickSpectraNetwork(), {}, state, {}),
        "the number of input names");
  }

  void statesOfOtherNetworksAreRefused() {
    SpectraNetworkOptions options = test::quickSpectraOptions();
    TrainingState state;
    state.network = randomNetwork({5, 7, 12}, Activation::relu, Activation::linear, 1);
    EXPECT_ERROR(trainSpectraNetwork(test::li2024(), test::sampledBasis(), options, state, {}),
                 "SpectraNN: the state of training belongs to another network");
    // One whose SpectraNN is not the one that ChromNN is to be trained through.
    const NetworkChannels channels = networkChannels(test::monitorRig());
    ChromophoreNetworkOptions quick = test::quickChromophoreOptions();
    quick.people.count = 2000;
    quick.trainer.epochs = 1;
    TrainingState whole;
    EXPECT_OK(trainChromophoreNetwork(test::li2024(), channels, test::quickSpectraNetwork(), quick,
                                      whole, {}));
    whole.best.layers.back().bias[0] += 1.0f;
    EXPECT_ERROR(trainChromophoreNetwork(test::li2024(), channels, test::quickSpectraNetwork(),
                                         quick, whole, {}),
                 "another SpectraNN");
  }

  void drawsAreReproducible() {
    const ParameterAxes& axes = test::li2024().profile().axes;
    const auto some = drawTrainingPeople({.count = 1000}, axes);
    const auto more = drawTrainingPeople({.count = 2000}, axes);
    for (std::size_t i = 0; i < some.size(); ++i)
      QVERIFY((some[i] == more[i]).all());
    for (const ParameterVector& p : more) {
      for (std::size_t k = 0; k < axes.size(); ++k) {
        QVERIFY(p[static_cast<Index>(k)] == axes[k].clamp(p[static_cast<Index>(k)]));
      }
    }
  }
};

CUTIS_TEST(TrainingTest)

}  // namespace
}  // namespace cutis

#include "training_test.moc"
