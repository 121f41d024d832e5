#include "src/files/resources.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <QtTest>

#include "src/files/system/platform.h"
#include "tests/support/expect.h"
#include "tests/support/folders.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

namespace fs = std::filesystem;

std::string bytesOf(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

class ResourcesTest : public QObject {
  Q_OBJECT

 private slots:
  // Every data file below resources/ is in the program, byte for byte.
  void theProgramCarriesItsFiles() {
    const fs::path root = test::sourceFolder() / "resources";
    int count = 0;
    for (const char* folder : {"spectra", "rigs", "profiles"}) {
      for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
        const std::string extension = entry.path().extension().string();
        if (extension != ".csv" && extension != ".json") continue;
        const std::string name = fs::relative(entry.path(), root).generic_string();
        const auto data = resource(name);
        QVERIFY2(data, name.c_str());
        QVERIFY2(*data == bytesOf(entry.path()), name.c_str());
        ++count;
      }
    }
    QVERIFY(count > 20);
  }

  void stemsAreThoseOfTheFolder() {
    const fs::path root = test::sourceFolder() / "resources";
    for (const char* folder : {"spectra/illuminants", "spectra/cameras", "spectra/observers",
                               "spectra/displays", "spectra", "rigs", "profiles"}) {
      const std::string suffix =
          folder == std::string("rigs") || folder == std::string("profiles") ? ".json" : ".csv";
      std::vector<std::string> expected;
      for (const auto& entry : fs::directory_iterator(root / folder)) {
        if (entry.path().extension() == suffix) {
          expected.push_back(entry.path().stem().string());
        }
      }
      std::sort(expected.begin(), expected.end());
      QVERIFY2(resourceStems(folder, suffix) == expected, folder);
    }
    QVERIFY(resourceStems("spectra/illum", ".csv").empty());
    QVERIFY(resourceStems("nowhere", ".csv").empty());
  }

  void whatIsNotThereIsNotThere() {
    for (const char* name : {"", "spectra", "spectra/", "rigs/monitor", "rigs/monitor.json ",
                             "../resources/rigs/monitor.json", "/rigs/monitor.json"}) {
      QVERIFY2(!resource(name), name);
    }
  }
};

class PlatformTest : public QObject {
  Q_OBJECT

 private slots:
  // XDG base directory specification: a relative path is invalid and passed over.
  void theCacheFolderFollowsXdg() {
    const QByteArray cache = qgetenv("XDG_CACHE_HOME"), home = qgetenv("HOME");
    qputenv("XDG_CACHE_HOME", "/somewhere");
    qputenv("HOME", "/home/someone");
    const fs::path named = cacheFolder();
    qputenv("XDG_CACHE_HOME", "relative");
    const fs::path relative = cacheFolder();
    qunsetenv("XDG_CACHE_HOME");
    const fs::path fromHome = cacheFolder();
    qunsetenv("HOME");
    const fs::path none = cacheFolder();
    if (!cache.isNull()) qputenv("XDG_CACHE_HOME", cache);
    if (!home.isNull()) qputenv("HOME", home);
    QVERIFY(named == "/somewhere/cutis");
    QVERIFY(relative == "/home/someone/.cache/cutis");
    QVERIFY(fromHome == "/home/someone/.cache/cutis");
    QVERIFY(none.empty());
  }

  void memoryIsMeasured() {
    const std::size_t before = peakMemoryBytes();
    QVERIFY(before > (std::size_t{1} << 20));
    std::vector<char> block(std::size_t{100} << 20, 1);
    QVERIFY(block[12345] == 1);
    QVERIFY(peakMemoryBytes() >= std::max(before, std::size_t{100} << 20));
  }
};

CUTIS_TEST(ResourcesTest)
CUTIS_TEST(PlatformTest)

}  // namespace
}  // namespace cutis

#include "resources_test.moc"
