// A document and its project: what is saved comes back, what is not saved is known, and what has
// changed or gone is said.

#include <fstream>

#include <QSignalSpy>
#include <QtTest>

#include "src/app/document/autosave.h"
#include "src/app/document/document.h"
#include "src/app/export/export.h"
#include "src/app/project/manifest.h"
#include "src/app/project/project_save.h"
#include "tests/src/app/project_fixture.h"
#include "tests/support/expect.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_registry.h"

namespace cutis::test {
namespace {

namespace fs = std::filesystem;

constexpr int kPatienceMs = 120000;

Command lessMelanin(double factor) {
  return {"melanin",
          {},
          [factor](DocumentState& state) {
            if (state.edits.empty()) state.edits.emplace_back();
            state.edits.front().parameters[kMelanin].scale = factor;
          },
          false};
}

std::string bytesAt(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

// A document of its own, with all it says.
struct Desk {
  Engine& engine;
  JobRunner jobs;
  Document document{engine, jobs};
  QSignalSpy opened{&document, &Document::opened};
  QSignalSpy saved{&document, &Document::saved};
  QSignalSpy failed{&document, &Document::failed};
  QSignalSpy noticed{&document, &Document::noticed};
  QSignalSpy started{&jobs, &JobRunner::started};

  explicit Desk(Engine& shared) : engine(shared) {}
  ~Desk() { jobs.stopAll(); }

  bool isDone() const { return document.isOpen() && document.isFitted() && jobs.isIdle(); }
  bool hasFitted() const {
    return std::any_of(started.begin(), started.end(), [](const QList<QVariant>& job) {
      return job[1].toString().startsWith("Fit");
    });
  }
  QString notes() const {
    QString all;
    for (const auto& note : noticed)
      all += note[0].toString() + "\n";
    return all;
  }
  bool exportTo(const fs::path& path) {
    const Scene& scene = document.scene();
    return bool(cutis::exportTo({path}, EditedAlbedo{scene, scene.source}, engine,
                                std::make_shared<TileStore>(1 << 24), {}));
  }
};

#define WAIT_FOR(desk) QTRY_VERIFY_WITH_TIMEOUT((desk).isDone(), kPatienceMs)

class ProjectDocumentTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void whatIsSavedComesBack() {
    const ScratchFolder folder;
    saveTan(folder);
    QVERIFY2(!QTest::currentTestFailed(), "saving");
    const std::string manifest = bytesAt(folder / "face.cutis");
    Desk desk(engine_);
    desk.document.open(folder / "face.cutis");
    WAIT_FOR(desk);
    QVERIFY2(!desk.hasFitted(), "the maps that were saved hold");
    QCOMPARE(desk.notes(), QString());
    QCOMPARE(desk.document.name(), QString("face"));
    QCOMPARE(desk.document.projectPath(), folder / "face.cutis");
    QCOMPARE(desk.document.scene().edits.front().parameters[kMelanin].scale, 0.5);
    QVERIFY(!desk.document.isModified());
    QVERIFY(!desk.document.history().canUndo());
    QCOMPARE(desk.document.view().view, std::string("melanin"));
    QVERIFY(desk.exportTo(folder / "again.png"));
    QCOMPARE(bytesAt(folder / "again.png"), bytesAt(folder / "albedo.png"));
    desk.document.save(folder / "face.cutis");
    QTRY_COMPARE(desk.saved.count(), 1);
    QCOMPARE(bytesAt(folder / "face.cutis"), manifest);
  }

  void theSampleComesBack() {
    const ScratchFolder folder;
    Desk desk(engine_);
    desk.document.openSample();
    WAIT_FOR(desk);
    desk.document.save(folder / "sample.cutis");
    QTRY_COMPARE_WITH_TIMEOUT(desk.saved.count(), 1, kPatienceMs);
    Desk again(engine_);
    again.document.open(folder / "sample.cutis");
    WAIT_FOR(again);
    QVERIFY(!again.hasFitted());
    QVERIFY(again.document.scene().source != nullptr);
  }

  void mapsComeBack() {
    const ScratchFolder folder;
    EXPECT_OK(writeMaps(folder / "maps.exr", mapsOfTexture(), {}));
    Desk desk(engine_);
    desk.document.open(folder / "maps.exr");
    WAIT_FOR(desk);
    desk.document.apply(lessMelanin(2.0));
    desk.document.save(folder / "maps.cutis");
    QTRY_COMPARE(desk.saved.count(), 1);
    QVERIFY(!fs::exists(folder / "maps.cutis.data"));
    Desk again(engine_);
    again.document.open(folder / "maps.cutis");
    WAIT_FOR(again);
    QCOMPARE(again.document.scene().edits.size(), std::size_t{1});
    QCOMPARE(again.notes(), QString());
  }

  void modifiedIsWhatIsNotSaved() {
    const ScratchFolder folder;
    writeTexture(folder / "face.png");
    Desk desk(engine_);
    Document& document = desk.document;
    QVERIFY(!document.isModified());
    document.open(folder / "face.png");
    WAIT_FOR(desk);
    QVERIFY(!document.isModified());
    document.apply(lessMelanin(0.5));
    QVERIFY(document.isModified());
    document.apply(lessMelanin(1.0));
    QVERIFY2(!document.isModified(), "edits that change nothing");
    document.undo();
    document.save(folder / "face.cutis");
    document.apply(lessMelanin(0.7));
    QTRY_COMPARE(desk.saved.count(), 1);
    QVERIFY2(document.isModified(), "edited while it was saved");
    document.undo();
    QVERIFY(!document.isModified());
    document.undo();
    QVERIFY(document.isModified());
    document.redo();
    QVERIFY(!document.isModified());
    document.fitWith({kPaperProfile, FitMethod::refined, false});
    QVERIFY(document.isModified());
    QCOMPARE(desk.failed.count(), 0);
  }

  void aFailedSaveIsReportedAndTriedAgain() {
    const ScratchFolder folder;
    writeTexture(folder / "face.png");
    Desk desk(engine_);
    desk.document.open(folder / "face.png");
    WAIT_FOR(desk);
    desk.document.apply(lessMelanin(0.5));
    desk.document.save(folder / "no/such/face.cutis");
    QTRY_COMPARE(desk.failed.count(), 1);
    QVERIFY(desk.document.isModified());
    QVERIFY(desk.document.projectPath().empty());
    desk.document.save(folder / "face.cutis");
    desk.document.save(folder / "second.cutis");  // after the first
    QTRY_COMPARE(desk.saved.count(), 2);
    QCOMPARE(desk.document.projectPath(), folder / "second.cutis");
    QVERIFY(fs::exists(folder / "face.cutis"));
  }

  void whatChangedMeanwhileIsFittedAgain() {
    const ScratchFolder folder;
    saveTan(folder);
    QVERIFY2(!QTest::currentTestFailed(), "saving");
    writeTexture(folder / "face.png", 0.9f);
    Desk desk(engine_);
    desk.document.open(folder / "face.cutis");
    WAIT_FOR(desk);
    QVERIFY(desk.hasFitted());
    QVERIFY2(desk.notes().contains("face.png: this has changed since the project was saved"),
             qPrintable(desk.notes()));
    QCOMPARE(desk.document.scene().edits.front().parameters[kMelanin].scale, 0.5);
  }

  void damagedMapsAreFittedAgain() {
    const ScratchFolder folder;
    saveTan(folder);
    QVERIFY2(!QTest::currentTestFailed(), "saving");
    const auto project = readProject(folder / "face.cutis", {});
    EXPECT_OK(project);
    std::string maps = bytesAt(project.value().maps);
    maps[maps.size() / 2] ^= 1;
    std::ofstream(project.value().maps, std::ios::binary) << maps;
    Desk desk(engine_);
    desk.document.open(folder / "face.cutis");
    WAIT_FOR(desk);
    QVERIFY(desk.hasFitted());
    QVERIFY2(desk.notes().contains("missing or damaged; it is fitted again"),
             qPrintable(desk.notes()));
  }

  void aNewerProjectIsRefused() {
    const ScratchFolder folder;
    folder.write("later.cutis", R"({"cutis_project": 7})");
    Desk desk(engine_);
    desk.document.open(folder / "later.cutis");
    QTRY_COMPARE(desk.failed.count(), 1);
    QVERIFY(desk.failed[0][0].toString().contains("written by a newer version of Cutis"));
    QVERIFY(!desk.document.isOpen());
  }

  void aMissingSourceCanBeNamed() {
    const ScratchFolder folder;
    saveTan(folder);
    QVERIFY2(!QTest::currentTestFailed(), "saving");
    fs::create_directory(folder / "moved");
    fs::rename(folder / "face.png", folder / "moved/face.png");
    writeTexture(folder / "other.png", 0.8f);
    Desk desk(engine_);
    std::optional<MissingSource> missing;
    connect(&desk.document, &Document::sourceMissing,
            [&](const MissingSource& which) { missing = which; });
    QSignalSpy others(&desk.document, &Document::otherSourceFound);
    desk.document.open(folder / "face.cutis");
    QTRY_VERIFY(missing);
    QCOMPARE(missing->file, folder / "face.png");
    QVERIFY(!desk.document.isOpen());
    desk.document.openRelinked(*missing, folder / "other.png", false);
    QTRY_COMPARE(others.count(), 1);
    QVERIFY(!desk.document.isOpen());
    desk.document.openRelinked(*missing, folder / "moved/face.png", false);
    WAIT_FOR(desk);
    QVERIFY2(!desk.hasFitted(), "it is the same file");
    QVERIFY2(desk.document.isModified(), "the project still names the old place");
    desk.document.save(folder / "face.cutis");
    QTRY_COMPARE(desk.saved.count(), 1);
    const auto project = readProject(folder / "face.cutis", {});
    EXPECT_OK(project);
    QCOMPARE(project.value().source.path, folder / "moved/face.png");
  }

  void anotherFileIsTakenWhenSaidSo() {
    const ScratchFolder folder;
    saveTan(folder);
    QVERIFY2(!QTest::currentTestFailed(), "saving");
    fs::remove(folder / "face.png");
    writeTexture(folder / "other.png", 0.8f);
    const auto project = readProject(folder / "face.cutis", {});
    EXPECT_OK(project);
    Desk desk(engine_);
    desk.document.openRelinked({project.value(), folder / "face.cutis", folder / "face.png"},
                               folder / "other.png", true);
    WAIT_FOR(desk);
    QVERIFY(desk.hasFitted());
    QVERIFY2(desk.notes().contains("other.png"), qPrintable(desk.notes()));
  }

  void aSourceThatChangesIsNoticedOnce() {
    const ScratchFolder folder;
    writeTexture(folder / "face.png");
    Desk desk(engine_);
    Document& document = desk.document;
    QSignalSpy changed(&document, &Document::sourceChanged);
    document.open(folder / "face.png");
    WAIT_FOR(desk);
    document.apply(lessMelanin(0.5));
    document.checkSource();
    QTRY_VERIFY(desk.jobs.isIdle());
    QCOMPARE(changed.count(), 0);
    // Touched, and as it was.
    fs::last_write_time(folder / "face.png", fs::file_time_type::clock::now());
    document.checkSource();
    QTRY_VERIFY(desk.jobs.isIdle());
    QCOMPARE(changed.count(), 0);
    writeTexture(folder / "face.png", 0.9f);
    document.checkSource();
    QTRY_COMPARE(changed.count(), 1);
    QVERIFY(changed[0][0].toStringList().first().endsWith("face.png"));
    QTRY_VERIFY(desk.jobs.isIdle());
    document.checkSource();
    QTRY_VERIFY(desk.jobs.isIdle());
    QCOMPARE(changed.count(), 1);
    desk.opened.clear();
    document.reload();
    QTRY_COMPARE(desk.opened.count(), 1);
    WAIT_FOR(desk);
    QCOMPARE(document.scene().edits.front().parameters[kMelanin].scale, 0.5);
    QVERIFY2(document.history().canUndo(), "the history is kept");
    QVERIFY(document.isModified());
  }

  void whatIsRecoveredIsUntitledAndUnsaved() {
    const ScratchFolder folder;
    saveTan(folder);
    QVERIFY2(!QTest::currentTestFailed(), "saving");
    const std::string manifest = bytesAt(folder / "face.cutis");
    const auto project = readProject(folder / "face.cutis", {});
    EXPECT_OK(project);
    Desk desk(engine_);
    desk.document.recover(project.value());
    WAIT_FOR(desk);
    QVERIFY(desk.document.projectPath().empty());
    QVERIFY(desk.document.isModified());
    QCOMPARE(desk.document.scene().edits.size(), std::size_t{1});
    QCOMPARE(bytesAt(folder / "face.cutis"), manifest);
  }

  // Two seconds after the last edit there is a journal; what is saved needs none.
  void editsAreJournalled() {
    const ScratchFolder folder;
    writeTexture(folder / "face.png");
    auto journals = JournalFolder::open(folder / "journals");
    EXPECT_OK(journals);
    const auto journal = journals.value()->add();
    Desk desk(engine_);
    {
      Autosave autosave(desk.document, desk.jobs, journal);
      desk.document.open(folder / "face.png");
      WAIT_FOR(desk);
      desk.document.apply(lessMelanin(0.5));
      QVERIFY(!fs::exists(journal->path()));
      QTRY_VERIFY_WITH_TIMEOUT(fs::exists(journal->path()) && desk.jobs.isIdle(), 10000);
      const auto kept = readProject(journal->path(), {});
      EXPECT_OK(kept);
      QCOMPARE(kept.value().source.path, folder / "face.png");
      QCOMPARE(kept.value().edits.front().parameters[kMelanin].scale, 0.5);
      QVERIFY(kept.value().maps.empty());
      desk.document.undo();
      QVERIFY2(!fs::exists(journal->path()), "undone");
      desk.document.redo();
    }
    QVERIFY2(fs::exists(journal->path()), "ended without saving");
    {
      Autosave autosave(desk.document, desk.jobs, journal);
      desk.document.save(folder / "face.cutis");
      QTRY_COMPARE(desk.saved.count(), 1);
      QVERIFY2(!fs::exists(journal->path()), "saved");
      desk.document.apply(lessMelanin(0.6));
      autosave.discard();
    }
    QVERIFY2(!fs::exists(journal->path()), "discarded");
  }

 private:
  // A texture, its project with half the melanin and the view of it, and the albedo as exported.
  void saveTan(const ScratchFolder& folder) {
    writeTexture(folder / "face.png");
    Desk desk(engine_);
    desk.document.open(folder / "face.png");
    WAIT_FOR(desk);
    desk.document.apply(lessMelanin(0.5));
    desk.document.setView({"melanin", ViewPlace{3.0, 4.0, 2.0}, "D65", "cie1931", "none"});
    desk.document.save(folder / "face.cutis");
    QTRY_COMPARE(desk.saved.count(), 1);
    QVERIFY(desk.exportTo(folder / "albedo.png"));
    QCOMPARE(desk.failed.count(), 0);
    QVERIFY(!desk.document.isModified());
  }

  Engine engine_{fs::path()};
};

CUTIS_TEST(ProjectDocumentTest)

}  // namespace
}  // namespace cutis::test

#include "project_document_test.moc"
