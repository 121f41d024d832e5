#include "src/files/profiles/table_cache.h"

#include <fstream>

#include <QtTest>

#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

namespace fs = std::filesystem;

// Small enough to be built in an instant.
SkinModel modelOf(int melaninSamples) {
  Profile profile = test::li2024().profile();
  const int samples[] = {melaninSamples, 3, 5, 2, 2};
  for (std::size_t k = 0; k < profile.axes.size(); ++k)
    profile.axes[k].samples = samples[k];
  return SkinModel(profile);
}

// A table, what was said about it, and whether it was built.
struct Outcome {
  std::shared_ptr<const SkinTable> table;
  std::vector<std::string> notices;
  bool built = false;
};

Outcome tableFrom(const fs::path& folder, const SkinModel& model, const SpectrumRows& rows) {
  Outcome outcome;
  JobContext context;
  context.notice = [&](const std::string& sentence) { outcome.notices.push_back(sentence); };
  context.progress = Progress([&](double, const std::string&) { outcome.built = true; });
  const auto table = cachedSkinTable(model, rows, folder, context);
  if (table) outcome.table = table.value();
  return outcome;
}

bool same(const Outcome& a, const Outcome& b) {
  if (!a.table || !b.table || a.table->channelCount() != b.table->channelCount()) return false;
  for (int k = 0; k < a.table->channelCount(); ++k) {
    if (a.table->channel(k) != b.table->channel(k)) return false;
  }
  return a.table->size() == b.table->size();
}

class TableCacheTest : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    folder_ = std::make_unique<test::ScratchFolder>();
    first_ = cached();
    QVERIFY(first_.table && first_.built && first_.notices.empty());
    QCOMPARE(folder_->names().size(), std::size_t{1});
    name_ = folder_->names().front();
    bytes_ = folder_->read(name_);
  }

  void theSecondTimeItIsLoaded() {
    const Outcome second = cached();
    QVERIFY(!second.built && second.notices.empty());
    QVERIFY(same(first_, second));
    QCOMPARE(second.table->parameters(17)[2], first_.table->parameters(17)[2]);
  }

  void foldersAreCreated() {
    const Outcome deep = tableFrom(*folder_ / "a/b", model_, rows_);
    QVERIFY(same(first_, deep));
    QVERIFY(!tableFrom(*folder_ / "a/b", model_, rows_).built);
  }

  void withoutAFolderNothingIsCached() {
    QVERIFY(tableFrom({}, model_, rows_).built);
    QVERIFY(tableFrom({}, model_, rows_).built);
  }

  // Any change to the file: built again, said so, and repaired.
  void damageIsNoticed_data() {
    QTest::addColumn<int>("damage");
    QTest::newRow("first byte") << 0;
    QTest::newRow("other version") << 1;
    QTest::newRow("key") << 2;
    QTest::newRow("checksum") << 3;
    QTest::newRow("first value") << 4;
    QTest::newRow("middle") << 5;
    QTest::newRow("last byte") << 6;
    QTest::newRow("truncated by one") << 7;
    QTest::newRow("truncated to half") << 8;
    QTest::newRow("header alone") << 9;
    QTest::newRow("empty") << 10;
    QTest::newRow("one byte more") << 11;
    QTest::newRow("text") << 12;
  }
  void damageIsNoticed() {
    QFETCH(int, damage);
    std::string bytes = bytes_;
    const auto flip = [&](std::size_t at) { bytes[at] = static_cast<char>(bytes[at] ^ 0x10); };
    const std::size_t version = bytes.find('1');
    const std::size_t header = bytes.find('\n') + 1 + 64;
    switch (damage) {
      case 0:
        flip(0);
        break;
      case 1:
        bytes[version] = '2';
        break;
      case 2:
        flip(header - 50);
        break;
      case 3:
        flip(header - 1);
        break;
      case 4:
        flip(header);
        break;
      case 5:
        flip(bytes.size() / 2);
        break;
      case 6:
        flip(bytes.size() - 1);
        break;
      case 7:
        bytes.pop_back();
        break;
      case 8:
        bytes.resize(bytes.size() / 2);
        break;
      case 9:
        bytes.resize(header);
        break;
      case 10:
        bytes.clear();
        break;
      case 11:
        bytes += '\0';
        break;
      default:
        bytes = "not a table\n";
    }
    folder_->write(name_, bytes);
    const Outcome again = cached();
    QVERIFY(again.built);
    QVERIFY(same(first_, again));
    QCOMPARE(again.notices.size(), std::size_t{1});
    QVERIFY(again.notices[0].find("built again") != std::string::npos);
    QVERIFY(!again.notices[0].ends_with('.'));
    const Outcome repaired = cached();
    QVERIFY(!repaired.built && repaired.notices.empty());
    QVERIFY(same(first_, repaired));
    QVERIFY(folder_->read(name_) == bytes_);
  }

  // A whole and healthy table of something else under this name.
  void anotherTablesContentIsRefused() {
    const test::ScratchFolder other;
    QVERIFY(tableFrom(other.path(), modelOf(5), rows_).built);
    folder_->write(name_, other.read(other.names().front()));
    const Outcome again = cached();
    QVERIFY(again.built && again.notices.size() == 1);
    QVERIFY(same(first_, again));
  }

  void whatChangesATableChangesItsName() {
    QVERIFY(tableFrom(folder_->path(), modelOf(5), rows_).built);
    SpectrumRows rows = rows_;
    rows(0, 100) += 1e-9;
    QVERIFY(tableFrom(folder_->path(), model_, rows).built);
    QVERIFY(tableFrom(folder_->path(), model_, rows_.topRows(2)).built);
    QCOMPARE(folder_->names().size(), std::size_t{4});
    QVERIFY(!cached().built);
  }

  void aCacheThatCannotBeWrittenIsNoError() {
    folder_->write("file", "x");
    const Outcome underFile = tableFrom(*folder_ / "file/cache", model_, rows_);
    QVERIFY(same(first_, underFile));
    fs::permissions(folder_->path(), fs::perms(0755));
    fs::create_directory(*folder_ / "locked");
    fs::permissions(*folder_ / "locked", fs::perms(0555));
    {
      const test::OrdinaryUser user;
      const Outcome locked = tableFrom(*folder_ / "locked", model_, rows_);
      QVERIFY(same(first_, locked));
    }
    QVERIFY(fs::is_empty(*folder_ / "locked"));
    fs::permissions(*folder_ / "locked", fs::perms(0755));
  }

  void stoppedBuildsLeaveNothing() {
    const test::ScratchFolder empty;
    std::stop_source source;
    source.request_stop();
    JobContext context;
    context.stop = source.get_token();
    QVERIFY(cachedSkinTable(model_, rows_, empty.path(), context).cancelled());
    QVERIFY(empty.names().empty());
  }

 private:
  Outcome cached() const { return tableFrom(folder_->path(), model_, rows_); }

  const SkinModel model_ = modelOf(4);
  const SpectrumRows rows_ = responseRows(test::albedoRig());
  std::unique_ptr<test::ScratchFolder> folder_;
  Outcome first_;
  std::string name_, bytes_;
};

CUTIS_TEST(TableCacheTest)

}  // namespace
}  // namespace cutis

#include "table_cache_test.moc"
