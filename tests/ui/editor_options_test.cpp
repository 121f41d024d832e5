// The program cutis itself: what it says to options that are wrong, that right ones are taken, and
// how signals end it.

#include <csignal>
#include <fstream>

#include <QImage>
#include <QProcess>
#include <QtTest>

#include "tests/support/scratch_folder.h"
#include "tests/support/test_registry.h"
#include "tests/ui/ui_test.h"

namespace cutis {
namespace {

class EditorOptionsTest : public test::UiTest {
  Q_OBJECT

 private slots:
  void wrongOnesAreTold_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("status");
    QTest::addColumn<QString>("sentence");
    QTest::newRow("profile") << QStringList{"--profile", "skin2027"} << 3
                             << "cutis: --profile: unknown profile 'skin2027'; did you mean "
                                "'skin2026'?";
    QTest::newRow("file") << QStringList{"--profile", "none.json"} << 3
                          << "cutis: none.json: there is no such file";
    QTest::newRow("method") << QStringList{"--method", "refind"} << 2
                            << "cutis: --method: unknown method 'refind'; did you mean 'refined'?";
  }
  void wrongOnesAreTold() {
    QFETCH(QStringList, arguments);
    QFETCH(int, status);
    QFETCH(QString, sentence);
    QCOMPARE(run(arguments), status);
    QVERIFY2(errors_.contains(sentence), qPrintable(errors_));
    QCOMPARE(errors_.count('\n'), 1);
  }

  void signalsCloseTheWindow_data() {
    QTest::addColumn<int>("signal");
    QTest::newRow("interrupt") << SIGINT;
    QTest::newRow("terminate") << SIGTERM;
    QTest::newRow("terminal closed") << SIGHUP;
  }
  void signalsCloseTheWindow() {
    QFETCH(int, signal);
    QProcess process;
    prepare(process);
    process.start(CUTIS_EDITOR, {"--sample"});
    QVERIFY(process.waitForStarted());
    const auto id = static_cast<pid_t>(process.processId());
    QTRY_VERIFY_WITH_TIMEOUT(handlesTermination(id), 60000);
    ::kill(id, signal);
    QVERIFY(process.waitForFinished(60000));
    QCOMPARE(process.exitStatus(), QProcess::NormalExit);
    QCOMPARE(process.exitCode(), 130);
  }

  void rightOnesAreTaken() {
    const QStringList usual = {"--sample", "--size", "1024x640", "--screenshot"};
    QCOMPARE(run(usual + QStringList{file("usual.png")}), 0);
    QCOMPARE(
        run(usual + QStringList{file("chosen.png"), "--profile", "li2024", "--method", "network"}),
        0);
    const QImage first(file("usual.png")), second(file("chosen.png"));
    QCOMPARE(first.size(), QSize(1024, 640));
    QCOMPARE(second.size(), first.size());
    QVERIFY(first != second);
  }

 private:
  static bool handlesTermination(pid_t process) {
    std::ifstream status("/proc/" + std::to_string(process) + "/status");
    for (std::string line; std::getline(status, line);) {
      if (!line.starts_with("SigCgt:")) continue;
      return ((std::stoull(line.substr(7), nullptr, 16) >> (SIGTERM - 1)) & 1) != 0;
    }
    return false;
  }
  void prepare(QProcess& process) const {
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("QT_QPA_PLATFORM", "offscreen");
    environment.insert("XDG_CONFIG_HOME", file("config"));
    environment.insert("XDG_RUNTIME_DIR", file("."));
    process.setProcessEnvironment(environment);
    process.setWorkingDirectory(file("."));
  }
  int run(const QStringList& arguments) {
    QProcess process;
    prepare(process);
    process.start(CUTIS_EDITOR, arguments);
    if (!process.waitForFinished(120000)) return -1;
    errors_ = QString::fromUtf8(process.readAllStandardError());
    return process.exitCode();
  }
  QString file(const std::string& name) const {
    return QString::fromStdString((folder_ / name).string());
  }

  test::ScratchFolder folder_;
  QString errors_;
};

CUTIS_TEST(EditorOptionsTest)

}  // namespace
}  // namespace cutis

#include "editor_options_test.moc"
