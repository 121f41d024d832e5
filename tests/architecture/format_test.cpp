// Sources are as clang-format leaves them. Versions of it differ in details, so that only the one
// of Debian 12 can tell.

#include <filesystem>

#include <QProcess>
#include <QStandardPaths>
#include <QtTest>

#include "tests/support/folders.h"
#include "tests/support/test_registry.h"

namespace cutis::test {
namespace {

constexpr int kFormatMs = 300'000;

// Its standard output and error together; nothing if it cannot be started.
QString output(const QString& program, const QStringList& arguments) {
  QProcess process;
  process.setWorkingDirectory(QString::fromStdString(sourceFolder().string()));
  process.setProcessChannelMode(QProcess::MergedChannels);
  process.start(program, arguments);
  if (!process.waitForFinished(kFormatMs)) return {};
  return QString::fromUtf8(process.readAll());
}

// The clang-format of version 14; empty if there is none.
QString formatter() {
  for (const char* name : {"clang-format-14", "clang-format"}) {
    const QString program = QStandardPaths::findExecutable(name);
    if (program.isEmpty()) continue;
    if (output(program, {"--version"}).contains("version 14.")) return program;
  }
  return {};
}

QStringList allSources() {
  QStringList paths;
  for (const char* folder : {"core", "src", "ui", "tests", "resources"}) {
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(sourceFolder() / folder)) {
      const std::string extension = entry.path().extension().string();
      if (extension != ".h" && extension != ".cpp") continue;
      paths << QString::fromStdString(entry.path().string());
    }
  }
  return paths;
}

class FormatTest : public QObject {
  Q_OBJECT

 private slots:
  void aFileThatIsNotFormattedIsFound() {
    if (formatter().isEmpty()) QSKIP("clang-format 14 is not installed");
    QTemporaryFile file(QDir::tempPath() + "/cutis-XXXXXX.cpp");
    QVERIFY(file.open());
    file.write("int  x ;\n");
    file.close();
    QVERIFY(!output(formatter(), {"--dry-run", file.fileName()}).isEmpty());
  }

  void sourcesAreFormatted() {
    const QString program = formatter();
    if (program.isEmpty()) QSKIP("clang-format 14 is not installed: the layout is not checked");
    QStringList arguments = {"--dry-run", "-ferror-limit=20"};
    arguments << allSources();
    QVERIFY(arguments.size() > 700);
    const QString warnings = output(program, arguments);
    QVERIFY2(warnings.isEmpty(), qPrintable(warnings));
  }
};

CUTIS_TEST(FormatTest)

}  // namespace
}  // namespace cutis::test

#include "format_test.moc"
