#include "ui/dialogs/file_to_write.h"

#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QLineEdit>
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

 private:
  test::ScratchFolder folder_;
};

CUTIS_TEST(FileToWriteTest)

}  // namespace
}  // namespace cutis

#include "file_to_write_test.moc"
