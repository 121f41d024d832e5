// Ends that come from outside, with a thread that exists before main.

#include <csignal>
#include <fstream>
#include <sys/stat.h>

#include "tests/src/cli/program_run.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis::test {
namespace {

constexpr int kInterrupted = 130;

// Whether the process handles the signal by itself.
bool handles(qint64 process, int signal) {
  std::ifstream status("/proc/" + std::to_string(process) + "/status");
  for (std::string line; std::getline(status, line);) {
    if (!line.starts_with("SigCgt:")) continue;
    return ((std::stoull(line.substr(7), nullptr, 16) >> (signal - 1)) & 1) != 0;
  }
  return false;
}

class SignalTest : public QObject {
  Q_OBJECT

  // Started with a thread of a library that was there before the program.
  std::unique_ptr<QProcess> startAmongThreads(const QString& commandLine) {
    qputenv("LD_PRELOAD", CUTIS_EARLY_THREAD);
    auto process = run_.start(commandLine);
    qunsetenv("LD_PRELOAD");
    process->waitForStarted();
    for (int i = 0; i < 6000 && !handles(process->processId(), SIGTERM); ++i)
      QThread::msleep(5);
    return process;
  }

  static void send(const QProcess& process, int signal) {
    ::kill(static_cast<pid_t>(process.processId()), signal);
  }

  void expectInterrupted(QProcess& process, const QByteArray& errors) {
    QVERIFY(process.waitForFinished(30000));
    QCOMPARE(process.exitStatus(), QProcess::NormalExit);
    QCOMPARE(process.exitCode(), kInterrupted);
    QCOMPARE(process.readAllStandardError(), errors);
  }

 private slots:
  void initTestCase() {
    EXPECT_DONE(run_.run("simulate --patch 768x768 --noise 0.005 -o large"));
    QCOMPARE(::mkfifo((run_ / "pipe.csv").c_str(), 0600), 0);
    QCOMPARE(::mkfifo((run_ / "pipe.json").c_str(), 0600), 0);
  }

  void everySignalLeavesNothingBehind_data() {
    QTest::addColumn<int>("signal");
    QTest::newRow("interrupt") << SIGINT;
    QTest::newRow("terminate") << SIGTERM;
    QTest::newRow("terminal closed") << SIGHUP;
  }
  void everySignalLeavesNothingBehind() {
    QFETCH(int, signal);
    const auto before = run_.contents();
    const auto process = startAmongThreads("fit large -o maps.exr --noise 0,0 --report r.json");
    QThread::msleep(300);
    QCOMPARE(process->state(), QProcess::Running);
    send(*process, signal);
    expectInterrupted(*process, "cutis-cli: interrupted\n");
    QVERIFY(run_.contents() == before);
  }

  void aSecondSignalEndsAtOnce() {
    const auto before = run_.contents();
    const auto process = startAmongThreads("simulate --patch 3000x3000 -o other");
    QThread::msleep(600);
    send(*process, SIGTERM);
    send(*process, SIGINT);
    QVERIFY(process->waitForFinished(30000));
    QCOMPARE(process->exitStatus(), QProcess::NormalExit);
    QCOMPARE(process->exitCode(), kInterrupted);
    QVERIFY(run_.contents() == before);
  }

  // Nobody writes into the pipe, or somebody who does not go on.
  void pipesDoNotBlockBeyondAStop_data() {
    QTest::addColumn<QString>("commandLine");
    QTest::addColumn<bool>("written");
    for (const bool written : {false, true}) {
      const char* mark = written ? " (writer)" : "";
      for (const char* line : {"fit-spectra pipe.csv -o o.csv", "spectrum --csv pipe.csv -o o.csv",
                               "spectrum --params 0,0,0,0,0 --profile ./pipe.json -o o.csv",
                               "fit large -o m.exr --prior pipe.json", "info pipe.json",
                               "fit large -o m.exr --rig ./pipe.json"}) {
        QTest::addRow("%s%s", line, mark) << QString(line) << written;
      }
    }
  }
  void pipesDoNotBlockBeyondAStop() {
    QFETCH(QString, commandLine);
    QFETCH(bool, written);
    const auto before = run_.contents();
    const auto process = startAmongThreads(commandLine);
    std::ofstream writer;
    if (written) {
      writer.open(run_ / (commandLine.contains("csv pipe") || commandLine.contains("pipe.csv")
                              ? "pipe.csv"
                              : "pipe.json"));
      writer << "{" << std::flush;
    }
    QThread::msleep(200);
    QCOMPARE(process->state(), QProcess::Running);
    send(*process, SIGTERM);
    expectInterrupted(*process, "cutis-cli: interrupted\n");
    QVERIFY(run_.contents() == before);
  }

  // As images pipes are refused: the formats' readers go back and forth.
  void imagesAreNoPipes() {
    for (const char* line :
         {"fit pipe.csv -o m.exr", "info pipe.csv", "render pipe.csv -o p.png"}) {
      const Outcome outcome = run_.run(line);
      QVERIFY2(isOneError(outcome.errors) &&
                   outcome.errors.find("not a regular file") != std::string::npos,
               outcome.errors.c_str());
      QCOMPARE(outcome.status, 3);
    }
  }

  void closedPipesAreErrorsOfTheWrite() {
    QProcess shell;
    shell.start(
        "bash",
        {"-c", QString("set -o pipefail; %1 spectrum --params 0,0,0,0,0 | true").arg(CUTIS_CLI)});
    QVERIFY(shell.waitForFinished(60000));
    const QByteArray errors = shell.readAllStandardError();
    if (shell.exitCode() == 0) QSKIP("the spectrum fitted into the pipe before it was closed");
    QCOMPARE(shell.exitCode(), 4);
    QVERIFY2(isOneError(errors.toStdString()), errors.constData());
  }

  void limitsOfFilesAreErrorsOfTheWrite() {
    const auto before = run_.contents();
    QProcess shell;
    shell.setWorkingDirectory(QString::fromStdString((run_ / "").string()));
    shell.start(
        "bash",
        {"-c", QString("ulimit -f 16; exec %1 edit large/maps.exr -o o.exr").arg(CUTIS_CLI)});
    QVERIFY(shell.waitForFinished(60000));
    const QByteArray errors = shell.readAllStandardError();
    QCOMPARE(shell.exitCode(), 4);
    QVERIFY2(isOneError(errors.toStdString()), errors.constData());
    QVERIFY(run_.contents() == before);
  }

 private:
  ProgramRun run_;
};

CUTIS_TEST(SignalTest)

}  // namespace
}  // namespace cutis::test

#include "signal_test.moc"
