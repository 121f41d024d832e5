// Journals: for their owner's eyes, found once after a crash, and never while their instance runs.

#include "src/app/project/journal.h"

#include <QSysInfo>
#include <QtTest>

#include "tests/src/app/project_fixture.h"
#include "tests/support/expect.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_registry.h"

namespace cutis::test {
namespace {

namespace fs = std::filesystem;

bool isPrivate(const fs::path& path) {
  const auto others = fs::perms::group_all | fs::perms::others_all;
  return (fs::status(path).permissions() & others) == fs::perms::none;
}

// As a process that was killed leaves them: journals under a lock that names a process which is no
// more.
void leaveJournal(const ScratchFolder& folder, const std::string& instance,
                  const std::string& text) {
  folder.write("journals/" + instance + "-0.cutis", text);
  folder.write("journals/" + instance + ".lock",
               "4194304\ntest_src_app\n" + QSysInfo::machineHostName().toStdString() + "\n");
}

class JournalTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void onlyTheOwnerReadsThem() {
    const ScratchFolder folder;
    auto journals = JournalFolder::open(folder / "state/journals");
    EXPECT_OK(journals);
    QVERIFY(isPrivate(folder / "state/journals"));
    const auto journal = journals.value()->add();
    EXPECT_OK(journal->write(journal->nextTurn(), "{}"));
    QVERIFY(isPrivate(journal->path()));
    EXPECT_OK(journal->write(journal->nextTurn(), "{ }"));
    QVERIFY(isPrivate(journal->path()));
    QCOMPARE(folder.read("state/journals/" + journal->path().filename().string()),
             std::string("{ }"));
  }

  void whatLiesThereIsCounted() {
    const ScratchFolder folder;
    QCOMPARE(countAbandonedJournals(folder / "journals"), 0);
    leaveJournal(folder, "0123", "{}");
    leaveJournal(folder, "4567", "");
    QCOMPARE(countAbandonedJournals(folder / "journals"), 1);
    QVERIFY2(folder.read("journals/0123-0.cutis") == "{}", "counting takes nothing away");
  }

  void theLastStateHolds() {
    const ScratchFolder folder;
    auto journals = JournalFolder::open(folder / "journals");
    EXPECT_OK(journals);
    const auto journal = journals.value()->add();
    const auto first = journal->nextTurn(), second = journal->nextTurn();
    EXPECT_OK(journal->write(second, "second"));
    EXPECT_OK(journal->write(first, "first"));
    const std::string name = "journals/" + journal->path().filename().string();
    QCOMPARE(folder.read(name), std::string("second"));
    const auto late = journal->nextTurn();
    journal->erase();
    EXPECT_OK(journal->write(late, "late"));
    QVERIFY(!fs::exists(journal->path()));
  }

  // A second instance takes nothing of the first while that runs.
  void whoRunsIsNotMistakenForACrash() {
    const ScratchFolder folder;
    auto first = JournalFolder::open(folder / "journals");
    EXPECT_OK(first);
    const auto journal = first.value()->add();
    EXPECT_OK(journal->write(journal->nextTurn(), "{}"));
    auto second = JournalFolder::open(folder / "journals");
    EXPECT_OK(second);
    QVERIFY(second.value()->takeAbandoned().empty());
    QCOMPARE(removeAbandonedJournals(folder / "journals"), 0);
    QVERIFY(fs::exists(journal->path()));
    // It ends without a word.
    first.value().reset();
    QCOMPARE(second.value()->takeAbandoned().size(), std::size_t{1});
  }

  void whatACrashLeftIsFoundOnce() {
    const ScratchFolder folder;
    leaveJournal(folder, "0123", "left");
    folder.write("journals/4567-0.cutis", "");  // killed before the first byte
    folder.write("journals/.4567-0-99-0.partial.cutis", "{");
    auto journals = JournalFolder::open(folder / "journals");
    EXPECT_OK(journals);
    const auto left = journals.value()->takeAbandoned();
    QCOMPARE(left.size(), std::size_t{1});
    QCOMPARE(folder.read("journals/" + left[0]->path().filename().string()), std::string("left"));
    QVERIFY(journals.value()->takeAbandoned().empty());
    auto another = JournalFolder::open(folder / "journals");
    EXPECT_OK(another);
    QVERIFY(another.value()->takeAbandoned().empty());
    left[0]->erase();
    QCOMPARE(allNames(folder / "journals").size(), std::size_t{2});  // two locks
  }

  void whatNobodyHoldsCanBeCleared() {
    const ScratchFolder folder;
    leaveJournal(folder, "0123", "left");
    QCOMPARE(removeAbandonedJournals(folder / "journals"), 1);
    QVERIFY(allNames(folder / "journals").empty());
    QCOMPARE(removeAbandonedJournals(folder / "no such folder"), 0);
  }

  void whereNothingCanBeWrittenIsSaid() {
    const ScratchFolder folder;
    folder.write("state", "a file");
    EXPECT_ERROR(JournalFolder::open(folder / "state/journals"),
                 "unsaved edits cannot be written there and a crash would lose them");
  }
};

CUTIS_TEST(JournalTest)

}  // namespace
}  // namespace cutis::test

#include "journal_test.moc"
