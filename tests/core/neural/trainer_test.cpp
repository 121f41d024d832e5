#include "core/neural/dense/trainer.h"

#include <cmath>

#include <QtTest>
#include <tbb/global_control.h>

#include "core/base/random.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

// A bent surface over a square.
TrainingSet surface(std::size_t count) {
  Random random(2);
  TrainingSet set;
  set.inputs = 2;
  set.outputs = 1;
  set.targetWeights = {1.0f};
  for (std::size_t i = 0; i < count; ++i) {
    const double x = random.uniform(-1.0, 1.0);
    const double y = random.uniform(-1.0, 1.0);
    set.inputRows.push_back(static_cast<float>(x));
    set.inputRows.push_back(static_cast<float>(y));
    set.targetRows.push_back(static_cast<float>(std::sin(2.0 * x) * y + x * x));
  }
  return set;
}

TrainerOptions quickOptions() {
  TrainerOptions options;
  options.rate = 0.01;
  options.epochs = 15;
  options.batch = 192;
  options.heldOutShare = 0.1;
  return options;
}

TrainingState freshState(Activation activation = Activation::squareplus) {
  TrainingState state;
  state.network = randomNetwork({2, 16, 16, 1}, activation, Activation::linear, 4);
  return state;
}

class TrainerTest : public QObject {
  Q_OBJECT

 private slots:
  void learns_data() {
    QTest::addColumn<QString>("activation");
    for (const char* name : {"relu", "sigmoid", "squareplus"})
      QTest::newRow(name) << name;
  }
  void learns() {
    QFETCH(QString, activation);
    const TrainingSet set = surface(8000);
    TrainingState state = freshState(*activationByName(activation.toStdString()));
    const auto before = meanError(state.network, set, 0, set.count(), {});
    EXPECT_OK(before);
    EXPECT_OK(trainNetwork(set, {}, quickOptions(), state, {}));
    QCOMPARE(state.curve.size(), std::size_t{15});
    EXPECT_AT_MOST(state.bestError, 0.02);
    EXPECT_AT_MOST(state.bestError, 0.1 * before.value());
    const auto after = meanError(state.best, set, 7200, 8000, {});
    EXPECT_OK(after);
    QCOMPARE(after.value(), state.bestError);
  }

  void threadsDoNotMatter() {
    const TrainingSet set = surface(4000);
    std::vector<TrainingState> states;
    for (const std::size_t threads : {1u, 2u, 5u}) {
      const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
      states.push_back(freshState());
      EXPECT_OK(trainNetwork(set, {}, quickOptions(), states.back(), {}));
    }
    QVERIFY(states[0] == states[1]);
    QVERIFY(states[0] == states[2]);
    TrainerOptions other = quickOptions();
    other.seed = 2;
    TrainingState state = freshState();
    EXPECT_OK(trainNetwork(set, {}, other, state, {}));
    QVERIFY(!(state == states[0]));
  }

  // Stopped in the middle of an epoch, and taken up again.
  void goesOnWhereItWasCancelled() {
    const TrainingSet set = surface(4000);
    TrainingState whole = freshState();
    EXPECT_OK(trainNetwork(set, {}, quickOptions(), whole, {}));
    TrainingState state = freshState();
    std::stop_source stop;
    JobContext context;
    context.stop = stop.get_token();
    context.progress = Progress([&](double done, const std::string&) {
      if (done > 0.42) stop.request_stop();
    });
    QVERIFY(trainNetwork(set, {}, quickOptions(), state, context).cancelled());
    QCOMPARE(state.curve.size(), std::size_t{6});
    QVERIFY(state.curve.size() < whole.curve.size());
    EXPECT_OK(trainNetwork(set, {}, quickOptions(), state, {}));
    QVERIFY(state == whole);
  }

  void stopsWhenNothingGetsBetter() {
    const TrainingSet set = surface(2000);
    TrainerOptions options = quickOptions();
    options.epochs = 200;
    options.patience = 3;
    options.rate = 1e-9;
    options.weightDecay = 1.0;
    TrainingState state = freshState();
    int called = 0;
    EXPECT_OK(trainNetwork(set, {}, options, state, {},
                           [&](const TrainingEpoch& epoch) { QCOMPARE(epoch.epoch, ++called); }));
    QVERIFY(called < 200);
    QCOMPARE(static_cast<int>(state.curve.size()), state.bestEpoch + 3);
  }

  void layersThatStayDoNotChange() {
    const TrainingSet set = surface(2000);
    TrainingState state = freshState();
    const DenseNetwork before = state.network;
    EXPECT_OK(trainNetwork(set, {0, 2}, quickOptions(), state, {}));
    QVERIFY(state.network.layers[2] == before.layers[2]);
    QVERIFY(!(state.network.layers[0] == before.layers[0]));
    QVERIFY(!(state.network.layers[1] == before.layers[1]));
  }

  void badInputIsNamed() {
    const TrainingSet set = surface(100);
    TrainingState state = freshState();
    EXPECT_ERROR(trainNetwork(set, {}, quickOptions(), state, {}), "fewer than a mini-batch");
    TrainerOptions options = quickOptions();
    options.rate = std::nan("");
    EXPECT_ERROR(trainNetwork(set, {}, options, state, {}), "learning rate");
    options = quickOptions();
    options.epochs = 0;
    EXPECT_ERROR(trainNetwork(set, {}, options, state, {}), "epochs");
    TrainingSet odd = surface(4000);
    odd.targetRows.pop_back();
    EXPECT_ERROR(trainNetwork(odd, {}, quickOptions(), state, {}), "does not fit the network");
    TrainingSet broken = surface(4000);
    broken.targetRows[17] = std::nanf("");
    EXPECT_ERROR(trainNetwork(broken, {}, quickOptions(), state, {}), "no longer a number");
    state.steps = 5;
    state.firstMoment.pop_back();
    EXPECT_ERROR(trainNetwork(surface(4000), {}, quickOptions(), state, {}),
                 "the state of training does not fit");
  }

  // Each could come out of a file.
  void statesOfOthersAreRefused() {
    const TrainingSet set = surface(4000);
    TrainerOptions options = quickOptions();
    options.epochs = 2;
    TrainingState done = freshState();
    EXPECT_OK(trainNetwork(set, {}, options, done, {}));
    const auto refused = [&](auto change) {
      TrainingState state = done;
      change(state);
      const Status status = trainNetwork(set, {}, quickOptions(), state, {});
      return status.failed() &&
             status.error().text().find("state of training") != std::string::npos;
    };
    QVERIFY(!refused([](TrainingState&) {}));
    QVERIFY(refused([](TrainingState& state) { state.steps += 1; }));
    QVERIFY(refused([](TrainingState& state) { state.curve.pop_back(); }));
    QVERIFY(refused([](TrainingState& state) { state.bestEpoch = 3; }));
    QVERIFY(refused([](TrainingState& state) { state.secondMoment.push_back(0.0f); }));
    QVERIFY(refused([](TrainingState& state) { state.best.layers.pop_back(); }));
    QVERIFY(refused([](TrainingState& state) { state.best.layers[0].bias.clear(); }));
    QVERIFY(refused([](TrainingState& state) {
      state.curve.resize(16);
      state.steps = 288;
    }));
  }
};

CUTIS_TEST(TrainerTest)

}  // namespace
}  // namespace cutis

#include "trainer_test.moc"
