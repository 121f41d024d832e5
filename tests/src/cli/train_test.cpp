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
    for (const char* part : {"components", "error left", "used: ", "seconds", "SpectraNN",
                             "ChromNN and the skin model", "the rig's noise"}) {
      QVERIFY2(trained_.output.find(part) != std::string::npos, part);
    }
    const auto file = nlohmann::json::parse(run_.read("weights.json"));
    QCOMPARE(file["command"].get<std::string>(),
             std::string("train --rig albedo --profile li2024 --hidden 8,8 --people 2000 "
                         "--table-step 997 --epochs 2"));
    QCOMPARE(file["rig"].get<std::string>(), std::string("albedo"));
  }

  void optionsReachTheFile() {
    EXPECT_DONE(
        run_.run("train --rig albedo --profile li2024 --hidden 8,8 --people 2000 --table-step 997 "
                 "--activation relu --components 9 --rate 0.01 --weight-decay 1e-5 --batch 192 "
                 "--patience 1 --epochs 30 -o options.json"));
    const auto file = nlohmann::json::parse(run_.read("options.json"));
    QVERIFY(file["command"].get<std::string>().find(
                "--activation relu --components 9 --people 2000 --table-step 997 --epochs 30 "
                "--patience 1 --rate 0.01 --weight-decay 1e-5 --batch 192") != std::string::npos);
    for (const char* network : {"spectra_nn", "chrom_nn"}) {
      const auto& trained = file[network]["trained"];
      QCOMPARE(trained["activation"].get<std::string>(), std::string("relu"));
      QCOMPARE(trained["trainer"]["rate"].get<double>(), 0.01);
      QCOMPARE(trained["trainer"]["weight_decay"].get<double>(), 1e-5);
      QCOMPARE(trained["trainer"]["batch"].get<int>(), 192);
      QCOMPARE(trained["trainer"]["patience"].get<int>(), 1);
    }
    QCOMPARE(file["spectra_nn"]["components"].size(), std::size_t{9});
  }

  // Killed by Ctrl-C in the middle, and gone on with.
  void anInterruptedTrainingGoesOn() {
    const QString line =
        "train --rig albedo --profile li2024 --hidden 8,8 --people 20000 --epochs "
        "90 --table-step 997 --threads 1 --state state.json";
    QString whole = line;
    EXPECT_DONE(run_.run(whole.remove(" --state state.json") + " -o whole.json"));
    const auto process = run_.start(line + " -o gone_on.json");
    QVERIFY(process->waitForStarted());
    QTRY_VERIFY_WITH_TIMEOUT(std::filesystem::exists(run_ / "state.json"), 60000);
    ::kill(static_cast<pid_t>(process->processId()), SIGINT);
    QVERIFY(process->waitForFinished(20000));
    if (process->exitCode() == 0) QSKIP("it was done before it could be interrupted");
    QCOMPARE(process->exitCode(), 130);
    const std::string state = run_.read("state.json");
    QVERIFY(state.starts_with("{\n\"cutis_training\":1"));
    const Outcome other = run_.run(line + " -o gone_on.json --seed 2");
    QVERIFY2(isOneError(other.errors) && other.errors.find("state of another training, 'train "
                                                           "--rig albedo") != std::string::npos,
             other.errors.c_str());
    QCOMPARE(other.status, 3);
    run_.write("state.json", state.substr(0, state.size() / 2));
    const Outcome cut = run_.run(line + " -o gone_on.json");
    QVERIFY2(isOneError(cut.errors) && cut.errors.find("state.json") != std::string::npos,
             cut.errors.c_str());
    // A state that reads well and leads nowhere: the file is named, and what to do with it.
    std::string wrong = state;
    const auto steps = wrong.find("\"steps\":") + 8;
    wrong.insert(steps, "9");
    run_.write("state.json", wrong);
    const Outcome astray = run_.run(line + " -o gone_on.json");
    QVERIFY2(isOneError(astray.errors) && astray.errors.find("state.json") != std::string::npos &&
                 astray.errors.find("delete it") != std::string::npos,
             astray.errors.c_str());
    run_.write("state.json", state);
    EXPECT_DONE(run_.run(line + " -o gone_on.json"));
    QVERIFY(run_.read("gone_on.json") == run_.read("whole.json"));
    QVERIFY2(!std::filesystem::exists(run_ / "state.json"),
             "the state of a finished training stays");
  }

  void aTrainingIsDrawn() {
    EXPECT_DONE(run_.run(QString(kQuick) + " -o drawn.json --plot train.svg"));
    const std::string picture = run_.read("train.svg");
    for (const char* part : {"Error while training", "paper's 10", "Mean and first ten components",
                             "SpectraNN itself", "The difference"}) {
      QVERIFY2(picture.find(part) != std::string::npos, part);
    }
    QVERIFY(picture.find("nan") == std::string::npos);
  }

  void sizesAreCompared() {
    const auto before = run_.contents();
    const Outcome table = run_.run(QString(kQuick) + " --sizes 4;8,8;default");
    EXPECT_DONE(table);
    for (const char* part :
         {"hidden layers", "multiply-adds", "\n  4 ", "\n  8,8 ", "\n  default "}) {
      QVERIFY2(table.output.find(part) != std::string::npos, table.output.c_str());
    }
    QVERIFY(run_.contents() == before);
  }

  void fiveChannelsFit() {
    EXPECT_DONE(run_.run("fit cap -o nine.exr --profile li2024 --quiet --method network"));
    EXPECT_DONE(run_.run(
        "fit cap -o five.exr --profile li2024 --quiet --method network --weights monitor-5 "
        "--report five.json"));
    QVERIFY(valuesOf(run_.maps("five.exr").maps.values[0]) !=
            valuesOf(run_.maps("nine.exr").maps.values[0]));
    const auto report = nlohmann::json::parse(run_.read("five.json"));
    EXPECT_AT_MOST(report["residual"]["mean"].get<double>(), 5e-3);
    EXPECT_DONE(
        run_.run("train --rig monitor --profile li2024 --channels paper --hidden 8 --people "
                 "2000 --epochs 2 --table-step 997 -o own5.json"));
    const auto file = nlohmann::json::parse(run_.read("own5.json"));
    QCOMPARE(file["chrom_nn"]["inputs"].dump(), std::string("[\"r\",\"g\",\"b\",\"sb\",\"sg\"]"));
    EXPECT_DONE(run_.run(
        "fit cap -o own5.exr --profile li2024 --quiet --method network --weights own5.json"));
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
    EXPECT_DONE(
        run_.run("fit cap -o maps.exr --profile li2024 --quiet --method network --report r.json"));
    const auto report = nlohmann::json::parse(run_.read("r.json"));
    QCOMPARE(report["method"].get<std::string>(), std::string("network"));
    QCOMPARE(report["pixels"]["no_convergence"].get<int>(), 0);
    EXPECT_AT_MOST(report["residual"]["mean"].get<double>(), 5e-3);
    EXPECT_DONE(
        run_.run("fit cap -o white.exr --profile li2024 --quiet --method network --lights white"));
    EXPECT_DONE(
        run_.run("fit cap -o again.exr --profile li2024 --quiet --method network --threads 1"));
    QVERIFY(valuesOf(run_.maps("again.exr").maps.values[0]) ==
            valuesOf(run_.maps("maps.exr").maps.values[0]));
  }

  void ownNetworksFit() {
    run_.writeImage("skin.exr", skinTexture(24, 16, {"R", "G", "B"}), SampleType::float32);
    EXPECT_DONE(
        run_.run("fit skin.exr -o own.exr --profile li2024 --quiet --method network --weights "
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
             {"fit cap -o a.exr --profile li2024 --quiet --method network --weights weights.json",
              3, "--weights: the network was trained for other lights or another camera"},
             {"fit cap -o a.exr --profile li2024 --quiet --method network --lights "
              "white,white+blue",
              3,
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
             {"fit cap -o a.exr --method network --weights monitor-6", 3,
              "did you mean 'monitor-5'"},
             {"fit cap -o a.exr --method network --weights monitor-5 --lights white", 3,
              "--weights: the network was trained for other lights"},
             {"train --rig albedo --channels paper -o a.json", 3, "the paper's channels sb and sg"},
             {"train --rig albedo --channels five -o a.json", 2, "choose all or paper"},
             {"train --rig albedo -o a.json --activation tanh", 2, "choose relu, sigmoid"},
             {"train --rig albedo -o a.json --components 65", 2, "--components"},
             {"train --rig albedo -o a.json --rate 0", 2, "--rate"},
             {"train --rig albedo -o a.json --rate nan", 2, "--rate"},
             {"train --rig albedo -o a.json --weight-decay 2", 2, "--weight-decay"},
             {"train --rig albedo -o a.json --batch 10", 2, "--batch"},
             {"train --rig albedo -o a.json --patience -1", 2, "--patience"},
             {"train --rig albedo -o a.json --state a.json", 2, "two results cannot be one file"},
             {"train --rig albedo -o a.json --plot a.gif", 2, ".svg"},
             {"train --rig albedo --sizes 8,8 -o a.json", 2, "writes no file"},
             {"train --rig albedo --sizes 8;0", 2, "--sizes"},
             {"train -o a.json", 2, "--rig is required"},
             {"train --rig albedo", 2, "-o"},
             {"train --rig albdo -o a.json", 3, "did you mean 'albedo'"},
             {"train --rig monitor --lights red -o a.json", 3, "has no light 'red'"},
             {"train --rig albedo -o a.json --preset big", 2, "choose default or paper"},
             {"train --rig albedo -o a.json --hidden 0", 2, "--hidden"},
             {"train --rig albedo -o a.json --hidden 1,1,1,1,1,1,1,1,1", 2,
              "one to 8 hidden layers"},
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
