// Saving projects: the maps beside the manifest, only what is its own replaced, and whole or not at
// all, also where the program is killed.

#include "src/app/project/project_save.h"

#include <fstream>

#include <QProcess>
#include <QRandomGenerator>
#include <QtTest>

#include "src/app/project/journal.h"
#include "src/app/project/manifest.h"
#include "src/app/project/project_open.h"
#include "tests/src/app/project_fixture.h"
#include "tests/support/expect.h"
#include "tests/support/folders.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_registry.h"

namespace cutis::test {
namespace {

namespace fs = std::filesystem;

constexpr int kUsualKills = 10;
constexpr char kKills[] = "CUTIS_KILLS";  // how many instead
constexpr int kLongestLifeMs = 60;

std::string bytesOf(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

class ProjectSaveTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void mapsAreNamedByTheirContent() {
    const ScratchFolder folder;
    writeTexture(folder / "face.png");
    const MapsFile maps = mapsOfTexture();
    const auto saved =
        saveProject(folder / "face.cutis", projectOf(folder / "face.png"), &maps, {});
    EXPECT_OK(saved);
    QCOMPARE(saved.value().maps.parent_path(), folder / "face.cutis.data");
    QCOMPARE(saved.value().maps.stem().string().size(), std::size_t{32});
    const auto names = allNames(folder.path());
    QCOMPARE(names.size(), std::size_t{4});  // image, manifest, folder, maps
    const auto read = readProject(folder / "face.cutis", {});
    EXPECT_OK(read);
    QCOMPARE(read.value().maps, saved.value().maps);
    // Saved again as it is, and again with the same maps.
    const std::string manifest = bytesOf(folder / "face.cutis");
    EXPECT_OK(saveProject(folder / "face.cutis", read.value(), nullptr, {}));
    QCOMPARE(bytesOf(folder / "face.cutis"), manifest);
    EXPECT_OK(saveProject(folder / "face.cutis", projectOf(folder / "face.png"), &maps, {}));
    QCOMPARE(bytesOf(folder / "face.cutis"), manifest);
    QCOMPARE(allNames(folder.path()), names);
  }

  void replacedMapsGoAndOthersStay() {
    const ScratchFolder folder;
    writeTexture(folder / "face.png");
    const Project project = projectOf(folder / "face.png");
    const MapsFile first = mapsOfTexture(), second = mapsOfTexture(0.5);
    const auto saved = saveProject(folder / "face.cutis", project, &first, {});
    EXPECT_OK(saved);
    folder.write("face.cutis.data/notes.txt", "mine");
    // A copy of the manifest names the same maps.
    fs::copy_file(folder / "face.cutis", folder / "copy.cutis");
    EXPECT_OK(saveProject(folder / "copy.cutis", project, &second, {}));
    QVERIFY(fs::exists(saved.value().maps));
    EXPECT_OK(saveProject(folder / "face.cutis", project, &second, {}));
    QVERIFY(!fs::exists(saved.value().maps));
    QVERIFY(fs::exists(folder / "face.cutis.data/notes.txt"));
    // Without maps there is nothing left to keep.
    EXPECT_OK(saveProject(folder / "copy.cutis", project, nullptr, {}));
    QVERIFY(!fs::exists(folder / "copy.cutis.data"));
  }

  void savedElsewhereItTakesItsMapsAlong() {
    const ScratchFolder folder;
    writeTexture(folder / "face.png");
    fs::create_directory(folder / "other");
    const MapsFile maps = mapsOfTexture();
    const auto saved =
        saveProject(folder / "face.cutis", projectOf(folder / "face.png"), &maps, {});
    EXPECT_OK(saved);
    const auto again = saveProject(folder / "other/second.cutis", saved.value(), nullptr, {});
    EXPECT_OK(again);
    QVERIFY(fs::exists(saved.value().maps) && fs::exists(again.value().maps));
    QCOMPARE(again.value().maps.filename(), saved.value().maps.filename());
    QVERIFY(bytesOf(folder / "other/second.cutis").find("\"path\": \"../face.png\"") !=
            std::string::npos);
  }

  void whereNothingCanBeWrittenAllStays() {
    const ScratchFolder folder;
    writeTexture(folder / "face.png");
    const MapsFile first = mapsOfTexture(), second = mapsOfTexture(0.5);
    const Project project = projectOf(folder / "face.png");
    EXPECT_OK(saveProject(folder / "face.cutis", project, &first, {}));
    const std::string manifest = bytesOf(folder / "face.cutis");
    const auto names = allNames(folder.path());
    fs::permissions(folder.path(), fs::perms::owner_read | fs::perms::owner_exec |
                                       fs::perms::others_read | fs::perms::others_exec);
    {
      const OrdinaryUser user;
      EXPECT_ERROR(saveProject(folder / "face.cutis", project, &second, {}), "face.cutis");
    }
    fs::permissions(folder.path(), fs::perms::owner_all);
    QCOMPARE(bytesOf(folder / "face.cutis"), manifest);
    QCOMPARE(allNames(folder.path()), names);
    EXPECT_ERROR(saveProject(folder / "no/such.cutis", project, &first, {}), "such.cutis");
  }

  // Ended at a random moment: the project opens with its maps, the source is as it was, and the
  // next start leaves no stray file. CUTIS_KILLS=100 does it a hundred times.
  void aKillLosesNothing() {
    const ScratchFolder folder;
    writeTexture(folder / "face.png");
    const std::string image = bytesOf(folder / "face.png");
    const int kills = qEnvironmentVariableIntValue(kKills);
    for (int n = 0; n < (kills > 0 ? kills : kUsualKills); ++n) {
      killOnce(folder);
      if (QTest::currentTestFailed()) return;
      QCOMPARE(bytesOf(folder / "face.png"), image);
    }
  }

 private:
  void killOnce(const ScratchFolder& folder) {
    QProcess saver;
    saver.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    saver.start(CUTIS_TEST_SAVER, {QString::fromStdString((folder / "face.png").string()),
                                   QString::fromStdString((folder / "face.cutis").string()),
                                   QString::fromStdString((folder / "journals").string())});
    QVERIFY(saver.waitForReadyRead(60000));
    QTest::qSleep(static_cast<int>(QRandomGenerator::global()->bounded(kLongestLifeMs)));
    saver.kill();
    QVERIFY(saver.waitForFinished());
    QVERIFY2(saver.exitStatus() == QProcess::CrashExit, "it ended by itself");
    checkProject(folder);
    checkJournals(folder);
  }

  void checkProject(const ScratchFolder& folder) {
    removeLeftovers(folder / "face.cutis");
    auto project = readProject(folder / "face.cutis", {});
    EXPECT_OK(project);
    const fs::path maps = project.value().maps;
    const auto opened =
        openProjectSource(project.value(), engine_, std::make_shared<TileStore>(1 << 20), {});
    EXPECT_OK(opened);
    QVERIFY(opened.value().maps);
    QCOMPARE(allNames(folder / "face.cutis.data"),
             std::vector<std::string>{maps.filename().string()});
    for (const std::string& name : folder.names())
      QVERIFY2(!name.starts_with('.'), name.c_str());
  }

  static void checkJournals(const ScratchFolder& folder) {
    const auto journals = JournalFolder::open(folder / "journals");
    EXPECT_OK(journals);
    const auto left = journals.value()->takeAbandoned();
    EXPECT_AT_MOST(static_cast<double>(left.size()), 1.0);
    for (const auto& journal : left) {
      EXPECT_OK(readProject(journal->path(), {}));
      journal->erase();
    }
    QCOMPARE(allNames(folder / "journals").size(), std::size_t{1});  // the lock
  }

  Engine engine_{fs::path()};
};

CUTIS_TEST(ProjectSaveTest)

}  // namespace
}  // namespace cutis::test

#include "project_save_test.moc"
