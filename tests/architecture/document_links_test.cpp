// Documents that code, tests and other documents name are there: a reader who follows a reference
// arrives, and the references of a page that is renamed are found by this test.

#include <cctype>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <QtTest>

#include "tests/support/folders.h"
#include "tests/support/test_registry.h"

namespace cutis::test {
namespace {

namespace fs = std::filesystem;

// Texts by their path from the root of the repository.
using Texts = std::map<std::string, std::string>;

std::string contentOf(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

bool isRead(const fs::path& path) {
  static const std::set<std::string> extensions = {".h",  ".cpp", ".txt", ".cmake",
                                                   ".sh", ".md",  ".cff"};
  return extensions.contains(path.extension().string());
}

void addText(const fs::path& path, Texts& texts) {
  if (isRead(path)) texts[fs::relative(path, sourceFolder()).generic_string()] = contentOf(path);
}

Texts allTexts() {
  Texts texts;
  for (const auto& entry : fs::directory_iterator(sourceFolder())) {
    if (entry.is_regular_file()) addText(entry.path(), texts);
  }
  for (const char* folder : {"core", "src", "ui", "tests", "packaging", "resources"}) {
    for (const auto& entry : fs::recursive_directory_iterator(sourceFolder() / folder)) {
      if (entry.is_regular_file()) addText(entry.path(), texts);
    }
  }
  return texts;
}

std::vector<std::string> matches(const std::string& text, const std::regex& pattern) {
  std::vector<std::string> found;
  for (auto it = std::sregex_iterator(text.begin(), text.end(), pattern);
       it != std::sregex_iterator(); ++it) {
    found.push_back((*it)[1].str());
  }
  return found;
}

// Names of documents, "ARCHITECTURE.md" or "resources/manual/model.md", wherever they stand.
std::vector<std::string> documentNames(const std::string& text) {
  static const std::regex pattern(R"((?:^|[^\w./-])((?:[\w-]+/)*[\w-]+\.md)\b)");
  return matches(text, pattern);
}

// Files and folders that a text names by their path from the root: "core/base/plane.h".
std::vector<std::string> pathNames(const std::string& text) {
  static const std::regex pattern(
      R"((?:^|[^\w./-])((?:core|src|ui|tests|resources|packaging)/[\w./-]*\.(?:h|cpp|md|json|csv|svg|png|sh))\b)");
  return matches(text, pattern);
}

// Where the links of a Markdown text lead, those into the net left out: "model.md#layers".
std::vector<std::string> linkTargets(const std::string& text) {
  static const std::regex pattern(R"(\]\(([^)\s]+)\))");
  std::vector<std::string> targets;
  for (const std::string& target : matches(text, pattern)) {
    if (target.find("://") == std::string::npos) targets.push_back(target);
  }
  return targets;
}

// The anchor of a heading as GitHub makes it: small letters, blanks as hyphens, no punctuation.
std::string anchorOf(const std::string& heading) {
  std::string anchor;
  for (const char c : heading) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == ' ') {
      anchor += '-';
    } else if (std::isalnum(byte) != 0 || c == '-' || c == '_' || byte >= 0x80) {
      anchor += static_cast<char>(std::tolower(byte));
    }
  }
  return anchor;
}

bool hasHeading(const std::string& text, const std::string& anchor) {
  static const std::regex pattern(R"((?:^|\n)#+ ([^\n]+))");
  for (const std::string& heading : matches(text, pattern)) {
    if (anchorOf(heading) == anchor) return true;
  }
  return false;
}

bool isThere(const fs::path& relative) {
  return fs::exists(sourceFolder() / relative);
}

// What a text at `path` names and the repository does not hold.
std::vector<std::string> missingDocuments(const std::string& path, const std::string& text) {
  std::vector<std::string> missing;
  const fs::path folder = fs::path(path).parent_path();
  for (const std::string& name : documentNames(text)) {
    if (!isThere(name) && !isThere(folder / name)) missing.push_back(path + " names " + name);
  }
  return missing;
}

std::vector<std::string> missingPaths(const std::string& path, const std::string& text) {
  std::vector<std::string> missing;
  for (const std::string& name : pathNames(text)) {
    if (name.find("NAME") != std::string::npos) continue;  // stands for any name
    if (!isThere(name)) missing.push_back(path + " names " + name);
  }
  return missing;
}

std::vector<std::string> brokenLinks(const std::string& path, const std::string& text) {
  std::vector<std::string> broken;
  const fs::path folder = fs::path(path).parent_path();
  for (const std::string& target : linkTargets(text)) {
    const auto hash = target.find('#');
    const std::string file = target.substr(0, hash);
    const fs::path to = file.empty() ? fs::path(path) : (folder / file).lexically_normal();
    if (!isThere(to)) {
      broken.push_back(path + " links to " + target);
    } else if (hash != std::string::npos &&
               !hasHeading(contentOf(sourceFolder() / to), target.substr(hash + 1))) {
      broken.push_back(path + " links to " + target + ", which has no such heading");
    }
  }
  return broken;
}

QString onePerLine(const std::vector<std::string>& lines) {
  QString text;
  for (const std::string& line : lines)
    text += "\n" + QString::fromStdString(line);
  return text;
}

void append(std::vector<std::string>& all, const std::vector<std::string>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

class DocumentLinksTest : public QObject {
  Q_OBJECT

 private slots:
  void namesAreFound() {
    const std::string document = std::string("resources/manual/nowhere") + ".md";
    QCOMPARE(documentNames("// See README.md, and (" + document + ").").size(), std::size_t{2});
    QCOMPARE(documentNames("README.md").front(), std::string("README.md"));
    QVERIFY(documentNames("a.mdx and {\".md\"}").empty());
    QCOMPARE(missingDocuments("core/base/a.h", "// " + document).size(), std::size_t{1});
    QVERIFY(missingDocuments("core/base/a.h", "// README.md").empty());
    const std::string header = std::string("core/base/nowhere") + ".h";
    QCOMPARE(missingPaths("a.md", "`" + header + "`").size(), std::size_t{1});
    QVERIFY(missingPaths("a.md", "`core/base/plane.h`").empty());
  }

  void linksAreFollowed() {
    const std::string text = "[a](README.md) [b](https://x.org/y) ![c](#heading-here)\n";
    QCOMPARE(linkTargets(text).size(), std::size_t{2});
    QVERIFY(hasHeading("# Title\n\n## Heading here\n", "heading-here"));
    QCOMPARE(anchorOf("Layers: by `diffusion`"), std::string("layers-by-diffusion"));
    QCOMPARE(brokenLinks("README.md", "[a](nowhere.txt)").size(), std::size_t{1});
    QCOMPARE(brokenLinks("README.md", "[a](README.md#no-such-heading)").size(), std::size_t{1});
    QVERIFY(brokenLinks("README.md", "[a](README.md#licence-and-sources)").empty());
  }

  void everyDocumentIsThere() {
    std::vector<std::string> missing;
    std::size_t names = 0;
    for (const auto& [path, text] : allTexts()) {
      if (path.ends_with("document_links_test.cpp")) continue;  // has made-up ones
      names += documentNames(text).size();
      append(missing, missingDocuments(path, text));
    }
    QVERIFY(names > 20);
    QVERIFY2(missing.empty(), qPrintable(onePerLine(missing)));
  }

  // Comments name headers, and documents name files of every kind; both move.
  void everyPathIsThere() {
    std::vector<std::string> missing;
    for (const auto& [path, text] : allTexts()) {
      // Tests of the architecture have made-up paths; CMake's start at their own folder.
      if (path.starts_with("tests/architecture/") || path.ends_with("CMakeLists.txt")) continue;
      append(missing, missingPaths(path, text));
    }
    QVERIFY2(missing.empty(), qPrintable(onePerLine(missing)));
  }

  void everyLinkLeadsSomewhere() {
    std::vector<std::string> broken;
    for (const auto& [path, text] : allTexts()) {
      if (path.ends_with(".md")) append(broken, brokenLinks(path, text));
    }
    QVERIFY2(broken.empty(), qPrintable(onePerLine(broken)));
  }

  void theReadmeIsShort() { QVERIFY(fs::file_size(sourceFolder() / "README.md") <= 7000); }
};

CUTIS_TEST(DocumentLinksTest)

}  // namespace
}  // namespace cutis::test

#include "document_links_test.moc"
