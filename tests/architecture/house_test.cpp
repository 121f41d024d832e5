// "Includes run only downwards" (ARCHITECTURE.md): the rules on the house itself.

#include <filesystem>
#include <fstream>
#include <sstream>

#include <QLibraryInfo>
#include <QtTest>

#include "tests/architecture/header_rules.h"
#include "tests/architecture/house_plan.h"
#include "tests/architecture/house_rules.h"
#include "tests/support/folders.h"
#include "tests/support/test_registry.h"

namespace cutis::test {
namespace {

namespace fs = std::filesystem;

std::string textOf(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

// Texts with one of these extensions, by their path from the root.
SourceTree sources(const std::vector<std::string>& folders,
                   const std::vector<std::string>& extensions) {
  const fs::path root = sourceFolder();
  SourceTree tree;
  for (const std::string& folder : folders) {
    if (!fs::is_directory(root / folder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      const std::string extension = entry.path().extension().string();
      if (!entry.is_regular_file()) continue;
      if (std::find(extensions.begin(), extensions.end(), extension) == extensions.end()) continue;
      tree[fs::relative(entry.path(), root).generic_string()] = textOf(entry.path());
    }
  }
  return tree;
}

// Looks where the headers of this Qt lie.
std::string qtModuleOf(const std::string& header) {
  const fs::path headers = QLibraryInfo::path(QLibraryInfo::HeadersPath).toStdString();
  const auto slash = header.find('/');
  if (slash != std::string::npos) return header.substr(0, slash);
  for (const char* module : {"QtCore", "QtGui", "QtWidgets", "QtSvg", "QtSvgWidgets", "QtTest",
                             "QtPrintSupport", "QtConcurrent"}) {
    if (header == module || fs::exists(headers / module / header)) return module;
  }
  return {};
}

QString joined(const std::vector<std::string>& violations) {
  QString text;
  for (const std::string& violation : violations)
    text += "\n" + QString::fromStdString(violation);
  return text;
}

class HouseTest : public QObject {
  Q_OBJECT

 private slots:
  void thePlanHasNoCircle() {
    const auto errors = planErrors();
    QVERIFY2(errors.empty(), qPrintable(joined(errors)));
  }

  void includesRunDownwards() {
    const SourceTree tree = sources({"core", "src", "ui"}, {".h", ".cpp"});
    QVERIFY(tree.size() > 100);
    QCOMPARE(QString::fromStdString(qtModuleOf("QString")), QString("QtCore"));
    const auto violations = checkIncludes(tree, qtModuleOf);
    QVERIFY2(violations.empty(), qPrintable(joined(violations)));
  }

  void vectorisedCodeSeesNoEigen() {
    const SourceTree tree = sources({"core", "src", "ui"}, {".h", ".cpp"});
    QVERIFY(tree.contains("core/skin/layers/diffusion-inl.h"));
    const auto violations = checkVectorised(tree);
    QVERIFY2(violations.empty(), qPrintable(joined(violations)));
  }

  void linksRunDownwards() {
    const std::string report = textOf(buildFolder() / "links.txt");
    QVERIFY2(report.find("core/skin: core/base core/maths") != std::string::npos, report.c_str());
    const auto violations = checkLinks(report);
    QVERIFY2(violations.empty(), qPrintable(joined(violations)));
  }

  void headersOpenWithASentence() {
    std::vector<std::string> violations;
    for (const auto& [path, text] : sources({"core", "src", "ui", "resources", "tests"}, {".h"})) {
      for (const std::string& violation : checkOpening(path, text))
        violations.push_back(violation);
    }
    QVERIFY2(violations.empty(), qPrintable(joined(violations)));
  }

  void internalHeadersAreToldApart() {
    const auto violations = checkInternal(sources({"core", "src", "ui"}, {".h", ".cpp"}));
    QVERIFY2(violations.empty(), qPrintable(joined(violations)));
  }

  void roomsAreSmall() {
    const auto violations = checkRoomSizes(sources({"core", "src", "ui", "tests"}, {".h", ".cpp"}));
    QVERIFY2(violations.empty(), qPrintable(joined(violations)));
  }

  void filesAreShortAndFinished() {
    std::vector<std::string> violations;
    for (const auto& [path, text] :
         sources({"core", "src", "ui", "tests", "packaging", "resources"},
                 {".h", ".cpp", ".txt", ".cmake", ".py", ".sh", ".md"})) {
      for (const std::string& violation : checkStyle(path, text))
        violations.push_back(violation);
    }
    QVERIFY2(violations.empty(), qPrintable(joined(violations)));
  }
};

CUTIS_TEST(HouseTest)

}  // namespace
}  // namespace cutis::test

#include "house_test.moc"
