// train, and fit --method network with what it wrote and with what is built in.

#include <csignal>

#include <QThread>
#include <nlohmann/json.hpp>

#include "tests/src/cli/program_run.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis::test {
namespace {

constexpr char kQuick[] =
    "train --rig albedo --profile li2024 --hidden 8,8 --people 2000 --epochs 2 --table-step 997";

class TrainTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    EXPECT_DONE(run_.run("simulate --patch 48x32 --noise 0.005 --profile li2024 -o cap"));
    trained_ = run_.run(QString(kQuick) + " -o weights.json");
    EXPECT_DONE(trained_);
  }

  void theFiguresArePrinted() {
    for (const char* part : {"components", "truncation error", "seconds", "SpectraNN",
                             "ChromNN and the skin model", "the rig's noise"}) {
      QVERIFY2(trained_.output.find(part) != std::string::npos, part);
    }
    const auto file = nlohmann::json::parse(run_.read("weights.json"));
    QCOMPARE(file["command"].get<std::string>(),
             std::string("train --rig albedo --profile li2024 --hidden 8,8 --epochs 2 --people "
                         "2000 --table-step 997"));
    QCOMPARE(file["rig"].get<std::string>(), std::string("albedo"));
  }

  void aSeedMakesTheSameBytes() {
    EXPECT_DONE(run_.run(QString(kQuick) + " -o again.json --threads 1"));
    QVERIFY(run_.read("again.json") == run_.read("weights.json"));
    EXPECT_DONE(run_.run(QString(kQuick) + " -o other.json --seed 7"));
    QVERIFY(run_.read("other.json") != run_.read("weights.json"));
  }

  void thePaperHasItsSizes() {
    EXPECT_DONE(
        run_.run("train --rig albedo --profile li2024 --preset paper --people 2000 "
                 "--epochs 1 --table-step 997 -o paper.json"));
    const auto file = nlohmann::json::parse(run_.read("paper.json"));
    QCOMPARE(file["spectra_nn"]["components"].size(), std::size_t{10});
    QCOMPARE(file["spectra_nn"]["trained"]["activation"].get<std::string>(), std::string("relu"));
    QCOMPARE(file["chrom_nn"]["trained"]["noise"][1].get<double>(), 0.0);
  }

  void builtInNetworksFit() {
    EXPECT_DONE(run_.run("fit cap -o maps.exr --profile li2024 --method network --report r.json"));
    const auto report = nlohmann::json::parse(run_.read("r.json"));
    QCOMPARE(report["method"].get<std::string>(), std::string("network"));
    QCOMPARE(report["pixels"]["no_convergence"].get<int>(), 0);
    EXPECT_AT_MOST(report["residual"]["mean"].get<double>(), 5e-3);
    EXPECT_DONE(run_.run("fit cap -o white.exr --profile li2024 --method network --lights white"));
    EXPECT_DONE(run_.run("fit cap -o again.exr --profile li2024 --method network --threads 1"));
    QVERIFY(valuesOf(run_.maps("again.exr").maps.values[0]) ==
            valuesOf(run_.maps("maps.exr").maps.values[0]));
  }

  void ownNetworksFit() {
    run_.writeImage("skin.exr", skinTexture(24, 16, {"R", "G", "B"}), SampleType::float32);
    EXPECT_DONE(
        run_.run("fit skin.exr -o own.exr --profile li2024 --method network --weights "
                 "weights.json"));
    QVERIFY(!run_.maps("own.exr").maps.values[0].empty());
  }

  void whatDoesNotFitIsRefused() {
    run_.write("broken.json", run_.read("weights.json").substr(0, 5000));
    struct Case {
      const char* line;
      int status;
      const char* sentence;
    };
    for (const auto& [line, status, sentence] : std::vector<Case>{
             {"fit cap -o a.exr --profile li2024 --method network --weights weights.json", 3,
              "--weights: the network was trained for other lights or another camera"},
             {"fit cap -o a.exr --profile li2024 --method network --lights white,white+blue", 3,
              "cutis-cli train --rig monitor --lights white,white+blue --profile li2024 -o "
              "WEIGHTS.json"},
             {"fit cap -o a.exr --method network --weights broken.json", 3, "broken.json:"},
             {"fit cap -o a.exr --method network --weights none.json", 3, "none.json"},
             {"fit cap -o a.exr --weights weights.json", 2,
              "--weights: only the method network takes this"},
             {"fit cap -o a.exr --method network --shading", 2, "--shading: only the method"},
             {"fit cap -o a.exr --method network --fix carotene=0", 2, "--fix: only the method"},
             {"fit cap -o a.exr --method network --noise 0,0", 2, "--noise: only the method"},
             {"fit cap -o a.exr --method network --deviation", 2, "--deviation: only the method"},
             {"fit cap -o weights.json --method network --weights weights.json", 2, "weights.json"},
             {"train -o a.json", 2, "--rig is required"},
             {"train --rig albedo", 2, "-o"},
             {"train --rig albdo -o a.json", 3, "did you mean 'albedo'"},
             {"train --rig monitor --lights red -o a.json", 3, "has no light 'red'"},
             {"train --rig albedo -o a.json --preset big", 2, "choose default or paper"},
             {"train --rig albedo -o a.json --hidden 0", 2, "--hidden"},
             {"train --rig albedo -o a.json --hidden 1,1,1,1,1,1,1,1,1", 2, "give fewer"},
             {"train --rig albedo -o a.json --epochs 0", 2, "--epochs"},
             {"train --rig albedo -o a.json --noise 0.1", 2, "--noise"},
             {"train --rig albedo -o a.json --people 10", 2, "--people"},
             {"train --rig albedo -o a.json --seed x", 2, "--seed"},
             {"train --rig albedo -o a.json --table-step 0", 2, "--table-step"},
             {"train --rig albedo -o no/such/a.json", 4, "no/such"}}) {
      const Outcome wrong = run_.run(line);
      QVERIFY2(isOneError(wrong.errors) && wrong.errors.find(sentence) != std::string::npos,
               (std::string(line) + ": " + wrong.errors).c_str());
      QVERIFY2(wrong.status == status, line);
    }
  }

  void interruptLeavesNothingBehind() {
    const auto before = run_.contents();
    const auto process = run_.start("train --rig monitor --profile li2024 -o long.json");
    QVERIFY(process->waitForStarted());
    QThread::msleep(1500);
    QCOMPARE(process->state(), QProcess::Running);
    ::kill(static_cast<pid_t>(process->processId()), SIGINT);
    QVERIFY(process->waitForFinished(20000));
    QCOMPARE(process->exitCode(), 130);
    QVERIFY(run_.contents() == before);
  }

 private:
  ProgramRun run_;
  Outcome trained_;
};

CUTIS_TEST(TrainTest)

}  // namespace
}  // namespace cutis::test

#include "train_test.moc"
