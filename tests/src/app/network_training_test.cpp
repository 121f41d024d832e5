// Training of both networks: what is reported while it runs, and going on after it was stopped.

#include "src/app/training/network_training.h"

#include <QtTest>

#include "src/app/training/network_errors.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

NetworkTraining quickTraining() {
  NetworkTraining training;
  training.spectra.hidden = training.chromophores.hidden = {8, 8};
  training.spectra.people.count = training.chromophores.people.count = 2000;
  training.spectra.trainer.epochs = 5;
  training.chromophores.trainer.epochs = 4;
  training.tableStep = 997;
  training.command = "a test";
  return training;
}

Result<TrainedNetworks> train(NetworkTrainingState& state, const JobContext& context = {},
                              const NetworkObserver& observer = {}) {
  return trainNetworks(test::li2024(), test::albedoRig(), quickTraining(), state, context,
                       observer);
}

class NetworkTrainingTest : public QObject {
  Q_OBJECT

 private slots:
  void everyEpochIsToldInOrder() {
    std::vector<TrainingEpoch> spectra, chromophores;
    NetworkTrainingState state;
    const auto trained = train(state, {}, [&](const NetworkEpoch& told) {
      const bool first = told.network == NetworkKind::spectra;
      QVERIFY(!first || chromophores.empty());
      QCOMPARE(told.epochs, first ? 5 : 4);
      (first ? spectra : chromophores).push_back(told.epoch);
      QCOMPARE(state.spectra.curve.size(), spectra.size());
      QCOMPARE(state.chromophores.curve.size(), chromophores.size());
    });
    EXPECT_OK(trained);
    QCOMPARE(spectra.size(), std::size_t{5});
    QVERIFY(trained.value().spectraCurve == spectra);
    QVERIFY(trained.value().chromophoreCurve == chromophores);
    QCOMPARE(trained.value().components(), trained.value().file.spectra.network.outputs());
  }

  void goesOnWhereItWasCancelled_data() {
    QTest::addColumn<int>("network");
    QTest::addColumn<int>("epoch");
    QTest::newRow("SpectraNN") << int(NetworkKind::spectra) << 2;
    QTest::newRow("ChromNN") << int(NetworkKind::chromophores) << 3;
  }
  void goesOnWhereItWasCancelled() {
    QFETCH(int, network);
    QFETCH(int, epoch);
    NetworkTrainingState whole, state;
    const auto uninterrupted = train(whole);
    EXPECT_OK(uninterrupted);
    std::stop_source stop;
    JobContext context;
    context.stop = stop.get_token();
    QVERIFY(train(state, context, [&](const NetworkEpoch& told) {
              if (int(told.network) == network && told.epoch.epoch == epoch) stop.request_stop();
            }).cancelled());
    QVERIFY(!(state.chromophores == whole.chromophores));
    const auto resumed = train(state);
    EXPECT_OK(resumed);
    QVERIFY(networkText(resumed.value().file) == networkText(uninterrupted.value().file));
    QVERIFY(resumed.value().chromophoreCurve == uninterrupted.value().chromophoreCurve);
  }

  void errorsAreMeasured() {
    NetworkTrainingState state;
    const auto trained = train(state);
    EXPECT_OK(trained);
    const auto errors =
        measureNetworks(test::li2024(), test::albedoRig(), trained.value().file, {});
    EXPECT_OK(errors);
    // The whole variance of such spectra is some 1e-2.
    EXPECT_AT_MOST(errors.value().decoded, 3e-3);
    EXPECT_AT_MOST(errors.value().encoded, 1e-2);
    EXPECT_AT_MOST(errors.value().encoded, errors.value().encodedNoisy);
  }
};

CUTIS_TEST(NetworkTrainingTest)

}  // namespace
}  // namespace cutis

#include "network_training_test.moc"
