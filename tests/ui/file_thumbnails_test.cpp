// Small pictures of recent files: kept for their owner alone, and gone with what they show.

#include "ui/window/file_thumbnails.h"

#include <filesystem>

#include <QFile>
#include <QListWidget>
#include <QSignalSpy>
#include <QtTest>

#include "src/app/job_runner.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_registry.h"
#include "tests/ui/ui_test.h"
#include "ui/widgets/recent_list.h"
#include "ui/window/recent_menu.h"

namespace cutis {
namespace {
namespace thumbnails_test {

namespace fs = std::filesystem;

QImage picture(const QColor& color) {
  QImage image(400, 200, QImage::Format_RGB32);
  image.fill(color);
  return image;
}

class FileThumbnailsTest : public test::UiTest {
  Q_OBJECT

 private slots:
  void theyAreKeptForTheirOwnerAlone() {
    const QString file = makeFile("one.png");
    FileThumbnails thumbnails(jobs_, kept_);
    keep(thumbnails, file, {});
    QCOMPARE(thumbnails.of(file).size(), QSize(FileThumbnails::kSide, FileThumbnails::kSide / 2));
    QCOMPARE(files().size(), std::size_t{1});
    QVERIFY(fs::status(files().front()).permissions() ==
            (fs::perms::owner_read | fs::perms::owner_write));
    QVERIFY(fs::status(kept_).permissions() == fs::perms::owner_all);
    QVERIFY(!QString::fromStdString(files().front().string()).contains("one"));
  }

  void theNextSessionFindsThem() {
    const QString file = makeFile("one.png");
    {
      FileThumbnails thumbnails(jobs_, kept_);
      keep(thumbnails, file, {});
    }
    FileThumbnails thumbnails(jobs_, kept_);
    QVERIFY(thumbnails.of(file).isNull());
    look(thumbnails, {file});
    QCOMPARE(thumbnails.of(file).pixelColor(10, 10), QColor(200, 150, 130));
  }

  void aFileThatHasChangedOrGoneHasNone() {
    const QString file = makeFile("one.png"), other = makeFile("two.png");
    FileThumbnails thumbnails(jobs_, kept_);
    keep(thumbnails, file, {});
    fs::last_write_time(file.toStdString(),
                        fs::last_write_time(file.toStdString()) + std::chrono::seconds(5));
    look(thumbnails, {file});
    QVERIFY(thumbnails.of(file).isNull());
    fs::remove(file.toStdString());
    keep(thumbnails, other, {file, other});
    QCOMPARE(files().size(), std::size_t{1});
  }

  void thereAreNoMoreThanRecentFiles() {
    FileThumbnails thumbnails(jobs_, kept_);
    const QString one = makeFile("one.png"), two = makeFile("two.png"), three = makeFile("3.png");
    keep(thumbnails, one, {one});
    keep(thumbnails, two, {two, one});
    QCOMPARE(files().size(), std::size_t{2});
    keep(thumbnails, three, {three, two});
    QCOMPARE(files().size(), std::size_t{2});
    look(thumbnails, {three, two, one});
    QVERIFY(!thumbnails.of(two).isNull());
    QVERIFY(thumbnails.of(one).isNull());
  }

  void whatIsDamagedIsNotShown() {
    const QString file = makeFile("one.png");
    FileThumbnails thumbnails(jobs_, kept_);
    keep(thumbnails, file, {});
    QFile damaged(QString::fromStdString(files().front().string()));
    QVERIFY(damaged.open(QIODevice::WriteOnly));
    damaged.write("no picture");
    damaged.close();
    look(thumbnails, {file});
    QVERIFY(thumbnails.of(file).isNull());
  }

  void clearingRemovesThemAll() {
    const QString file = makeFile("one.png");
    FileThumbnails thumbnails(jobs_, kept_);
    keep(thumbnails, file, {});
    thumbnails.clear();
    QVERIFY(thumbnails.of(file).isNull());
    QVERIFY(!fs::exists(kept_));
    FileThumbnails nowhere(jobs_, {});
    nowhere.keep(file, picture(Qt::red), {});
    nowhere.look({file});
    QTRY_VERIFY(jobs_.isIdle());
    QVERIFY(nowhere.of(file).isNull());
  }

  void theListShowsThemBesideTheNames() {
    RecentList list;
    list.setFiles({"/data/one.cutis", "/data/two.cutis"});
    list.resize(300, 200);
    list.show();
    const QImage without = list.grab().toImage();
    list.showThumbnails(
        [](const QString& path) { return path.contains("one") ? picture(Qt::red) : QImage(); });
    QVERIFY(without != list.grab().toImage());
    const QRect row = list.visualItemRect(list.item(0));
    QCOMPARE(list.viewport()->grab().toImage().pixelColor(row.left() + row.height() / 2,
                                                          row.center().y()),
             QColor(Qt::red));
    QCOMPARE(list.item(0)->data(Qt::AccessibleTextRole).toString(), QString("one.cutis in /data"));
  }

  void theMenuShowsThemBesideTheNames() {
    RecentMenu menu([] { return QStringList{"/data/one.cutis", "/data/two.cutis"}; });
    Q_EMIT menu.aboutToShow();
    menu.showThumbnails(
        [](const QString& path) { return path.contains("one") ? picture(Qt::red) : QImage(); });
    QVERIFY(!menu.actions()[0]->icon().isNull());
    QVERIFY(menu.actions()[1]->icon().isNull());
    QVERIFY(menu.actions().last()->icon().isNull());
  }

 private:
  void setUp() override { fs::remove_all(kept_); }

  QString makeFile(const std::string& name) {
    return QString::fromStdString(folder_.write(name, name).string());
  }
  std::vector<fs::path> files() const {
    std::vector<fs::path> paths;
    for (const auto& entry : fs::directory_iterator(kept_))
      paths.push_back(entry.path());
    return paths;
  }
  void keep(FileThumbnails& thumbnails, const QString& file, const QStringList& recent) {
    QSignalSpy changed(&thumbnails, &FileThumbnails::changed);
    thumbnails.keep(file, picture(QColor(200, 150, 130)), recent);
    QTRY_COMPARE(changed.count(), 1);
  }
  void look(FileThumbnails& thumbnails, const QStringList& list) {
    thumbnails.look(list);
    QTRY_VERIFY(jobs_.isIdle());
    QCoreApplication::processEvents();
  }

  test::ScratchFolder folder_;
  fs::path kept_ = folder_ / "kept";
  JobRunner jobs_;
};

CUTIS_TEST(FileThumbnailsTest)

}  // namespace thumbnails_test
}  // namespace
}  // namespace cutis

#include "file_thumbnails_test.moc"
