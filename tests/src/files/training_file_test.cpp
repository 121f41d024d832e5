// States of interrupted trainings: written and read they are the same; what is not one is refused
// with a sentence.

#include "src/files/networks/training_file.h"

#include <limits>

#include <QtTest>

#include "tests/support/expect.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

TrainingState someState(std::uint64_t seed) {
  TrainingState state;
  state.network = randomNetwork({2, 3, 1}, Activation::squareplus, Activation::linear, seed);
  state.best = randomNetwork({2, 3, 1}, Activation::squareplus, Activation::linear, seed + 1);
  const std::size_t weights = state.network.parameterCount();
  state.firstMoment.assign(weights, -1.0f / 3.0f);
  state.secondMoment.assign(weights, std::numeric_limits<float>::denorm_min());
  state.steps = 20;
  state.curve = {{1, 0.1, 1.0 / 3.0, 2e-9}, {2, 0.05, 1e-8, 1.0 / 7.0}};
  state.bestEpoch = 1;
  state.bestError = 2e-9;
  return state;
}

TrainingFile someTraining() {
  return {"train --rig \"mine\"", "0123", {someState(1), someState(5)}};
}

std::string changedTraining(const std::string& from, const std::string& to) {
  std::string text = trainingText(someTraining());
  const auto at = text.find(from);
  if (at == std::string::npos) return "test is wrong: " + from;
  return text.replace(at, from.size(), to);
}

class TrainingFileTest : public QObject {
  Q_OBJECT

 private slots:
  void readsWhatItWrote() {
    const TrainingFile file = someTraining();
    const auto path = folder_ / "state.json";
    EXPECT_OK(writeTraining(path, file));
    const auto read = readTraining(path);
    EXPECT_OK(read);
    QCOMPARE(read.value().command, file.command);
    QCOMPARE(read.value().identity, file.identity);
    QVERIFY(read.value().state.spectra == file.state.spectra);
    QVERIFY(read.value().state.chromophores == file.state.chromophores);
    TrainingFile first = file;
    first.state.chromophores = {};
    const auto half = parseTraining(trainingText(first), "state");
    EXPECT_OK(half);
    QVERIFY(half.value().state.chromophores == TrainingState());
  }

  void whatIsNoStateIsRefused_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("sentence");
    const std::string whole = trainingText(someTraining());
    const auto add = [](const char* name, const std::string& text, const char* sentence) {
      QVERIFY2(!text.starts_with("test is wrong"), text.c_str());
      QTest::newRow(name) << QString::fromStdString(text) << QString(sentence);
    };
    add("truncated", whole.substr(0, whole.size() / 2), "state.json:");
    add("foreign", "{\"cutis_network\": 1}", "\"cutis_training\": 1 is missing");
    add("newer", changedTraining("\"cutis_training\":1", "\"cutis_training\":2"),
        "a newer version");
    add("unknown field", changedTraining("\"best\":", "\"worst\":"),
        "unknown field 'spectra_nn.worst'");
    add("steps", changedTraining("\"steps\":20", "\"steps\":-20"),
        "steps must be a whole number from 1");
    add("half a step", changedTraining("\"steps\":20", "\"steps\":2.5"), "steps must be");
    add("best epoch", changedTraining("\"best_epoch\":1", "\"best_epoch\":0"),
        "best_epoch must be");
    add("best error", changedTraining("\"best_error\":2e-09", "\"best_error\":null"),
        "best_error must be");
    add("short epoch", changedTraining("\"curve\":[[0.1,", "\"curve\":[["),
        "curve[0] must be a list of 3");
    add("no epochs", changedTraining("\"curve\":[[", "\"curve\":[],\"x\":[["),
        "unknown field 'spectra_nn.x'");
    add("huge layer", changedTraining("\"outputs\":3", "\"outputs\":2000000000"), "from 1 to 512");
    add("layers", changedTraining("\"inputs\":3,\"outputs\":1", "\"inputs\":1,\"outputs\":3"),
        "network");
    add("moment", changedTraining("\"first_moment\":[", "\"first_moment\":[1e300,"),
        "first_moment");
  }
  void whatIsNoStateIsRefused() {
    QFETCH(QString, text);
    QFETCH(QString, sentence);
    const auto read = parseTraining(text.toStdString(), "state.json");
    EXPECT_ERROR(read, sentence.toStdString());
    QVERIFY(read.error().text().starts_with("state.json"));
    QVERIFY(read.error().text().find('\n') == std::string::npos);
  }

  void damageAnywhereIsNoCrash() {
    const std::string whole = trainingText(someTraining());
    for (std::size_t at = 0; at < whole.size(); at += 13) {
      QVERIFY(!parseTraining(whole.substr(0, at), "cut"));
      std::string bent = whole;
      bent[at] = static_cast<char>(bent[at] ^ 0x15);
      const auto read = parseTraining(bent, "bent");
      QVERIFY(read || read.failed());
    }
  }

 private:
  test::ScratchFolder folder_;
};

CUTIS_TEST(TrainingFileTest)

}  // namespace
}  // namespace cutis

#include "training_file_test.moc"
