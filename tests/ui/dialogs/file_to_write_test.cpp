#include "ui/dialogs/file_to_write.h"

#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QTimer>

#include "tests/support/scratch_folder.h"
#include "tests/support/test_registry.h"
#include "tests/ui/ui_test.h"

namespace cutis {
namespace {

const QString kFilters = "OpenEXR (*.exr);;TIFF (*.tif *.tiff);;PNG (*.png)";

class FileToWriteTest : public test::UiTest {
  Q_OBJECT

 private slots:
  void filtersHaveAnExtension() {
    QCOMPARE(extensionOf("OpenEXR (*.exr)"), QString("exr"));
    QCOMPARE(extensionOf("TIFF (*.tif *.tiff)"), QString("tif"));
    QCOMPARE(extensionOf("All files (*)"), QString());
  }

  void aNameWithoutExtensionHasTheFiltersOwn_data() {
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QString>("filter");
    QTest::addColumn<QString>("written");
    QTest::newRow("first filter") << "noext"
                                  << ""
                                  << "noext.exr";
    QTest::newRow("another filter") << "noext"
                                    << "PNG (*.png)"
                                    << "noext.png";
    QTest::newRow("several extensions") << "noext"
                                        << "TIFF (*.tif *.tiff)"
                                        << "noext.tif";
    QTest::newRow("own extension") << "own.tiff"
                                   << ""
                                   << "own.tiff";
  }
  void aNameWithoutExtensionHasTheFiltersOwn() {
    QFETCH(QString, typed);
    QFETCH(QString, filter);
    QFETCH(QString, written);
    QTimer::singleShot(0, [&] {
      auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
      QVERIFY(dialog != nullptr);
      if (!filter.isEmpty()) {
        dialog->selectNameFilter(filter);
        Q_EMIT dialog->filterSelected(filter);
      }
      dialog->findChild<QLineEdit*>()->setText(typed);
      QTest::keyClick(dialog->findChild<QLineEdit*>(), Qt::Key_Return);
    });
    const QString suggested = QString::fromStdString((folder_ / "edited.exr").string());
    const QString chosen = chooseFileToWrite(nullptr, "Export", suggested, kFilters);
    QCOMPARE(QFileInfo(chosen).fileName(), written);
    QCOMPARE(QFileInfo(chosen).path(), QFileInfo(suggested).path());
  }

  // Before anybody is asked whether the file may be replaced.
  void anObjectionKeepsTheDialogOpen() {
    const QString taken = QString::fromStdString(folder_.write("source.exr", "source").string());
    QString said;
    QTimer::singleShot(0, [&] {
      auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
      QVERIFY(dialog != nullptr);
      QTimer::singleShot(0, dialog, [&] {
        auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
        QVERIFY(box != nullptr);
        said = box->text();
        QTest::keyClick(box, Qt::Key_Return);
      });
      QTest::keyClick(dialog->findChild<QLineEdit*>(), Qt::Key_Return);
      QVERIFY(dialog->isVisible());
      QTest::keyClick(dialog, Qt::Key_Escape);
    });
    const auto objection = [](const QString& path) { return path + " is a source"; };
    QVERIFY(chooseFileToWrite(nullptr, "Export", taken, kFilters, objection).isEmpty());
    QCOMPARE(said, taken + " is a source");
  }

 private:
  test::ScratchFolder folder_;
};

CUTIS_TEST(FileToWriteTest)

}  // namespace
}  // namespace cutis

#include "file_to_write_test.moc"
