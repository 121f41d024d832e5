// Photographs that nobody has described, from the drop to the capture.

#include "ui/dialogs/capture_assistant.h"

#include <QComboBox>
#include <QDropEvent>
#include <QFile>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QPushButton>
#include <QSettings>
#include <QtTest>

#include "tests/support/scratch_folder.h"
#include "tests/support/test_registry.h"
#include "tests/ui/ui_test.h"
#include "tests/ui/window_steps.h"
#include "ui/dialogs/open_controller.h"
#include "ui/documents/document_page.h"
#include "ui/documents/document_tabs.h"
#include "ui/widgets/progress_strip.h"
#include "ui/window/main_window.h"

namespace cutis {
namespace {

namespace assistant {

constexpr int kPatienceMs = 60000;
const QSize kSize(60, 40);

// A bright disc on a dark ground, in the colour of a light.
void writePhotograph(const QString& path, const QColor& light, bool mirrored = false) {
  QImage image(kSize, QImage::Format_RGB32);
  for (int y = 0; y < kSize.height(); ++y) {
    for (int x = 0; x < kSize.width(); ++x) {
      const int dx = (mirrored ? 45 : 20) - x, dy = 20 - y;
      const double share = dx * dx + dy * dy < 150 ? 0.8 : 0.1;
      image.setPixelColor(
          x, y,
          QColor::fromRgbF(share * light.redF(), share * light.greenF(), share * light.blueF()));
    }
  }
  QVERIFY(image.save(path));
}

template <typename Widget>
Widget* named(const QWidget& parent, const QString& name) {
  for (Widget* widget : parent.findChildren<Widget*>())
    if (widget->accessibleName() == name) return widget;
  return nullptr;
}

QPushButton* button(const QWidget& parent, const QString& text) {
  for (QPushButton* candidate : parent.findChildren<QPushButton*>())
    if (candidate->text().remove('&') == text) return candidate;
  return nullptr;
}

}  // namespace assistant

class CaptureAssistantTest : public test::UiTest {
  Q_OBJECT

 private slots:
  void initTestCase() { test::keepSettingsIn(scratch_.path()); }

  void aFolderOfPhotographsIsAskedAbout() {
    writeThree();
    drop({file("")});
    CaptureAssistant& asked = shown();
    QCOMPARE(light(asked, "b_white_blue.png")->currentText(), QString("white+blue"));
    QCOMPARE(light(asked, "a_white_green.png")->currentText(), QString("white+green"));
    QCOMPARE(light(asked, "c_white.png")->currentText(), QString("white"));
    QVERIFY(!QFile::exists(file("capture.json")));  // nothing is applied unseen
    QTest::mouseClick(assistant::button(asked, "Write capture.json and open"), Qt::LeftButton);
    waitUntilIdle();
    const QJsonObject written = capture();
    QCOMPARE(written["cutis_capture"].toInt(), 2);
    QCOMPARE(written["encoding"].toString(), QString("sRGB"));
    QCOMPARE(written["rig"].toString(), QString("monitor"));
    QCOMPARE(written["images"].toArray().size(), 3);
    QCOMPARE(written["images"].toArray()[0].toObject()["file"].toString(),
             QString("a_white_green.png"));
    QVERIFY(window_->document().isOpen());
    QCOMPARE(window_->document().scene().source->measurements.rig.lights.size(), 3u);
    QCOMPARE(window_->tabs().count(), 1);
  }

  void aMaskBesideThemIsProposed() {
    writeThree();
    assistant::writePhotograph(file("mask.png"), Qt::white);
    drop({file("")});
    QCOMPARE(assistant::named<QLineEdit>(shown(), "Mask")->text(), file("mask.png"));
    shown().reject();
  }

  void twoOfOneLightAreNoCapture() {
    writeThree();
    drop({file("a_white_green.png"), file("b_white_blue.png"), file("c_white.png")});
    CaptureAssistant& asked = shown();
    QPushButton* write = assistant::button(asked, "Write capture.json and open");
    QVERIFY(write->isEnabled());
    QTest::keyClick(light(asked, "c_white.png"), Qt::Key_Down);
    QVERIFY(!write->isEnabled());
    QVERIFY(assistant::named<QLabel>(asked, "What will happen")->text().contains("white+blue"));
    QTest::keyClick(light(asked, "b_white_blue.png"), Qt::Key_End);
    QCOMPARE(light(asked, "b_white_blue.png")->currentText(), QString("Not used"));
    QVERIFY(write->isEnabled());
    QCOMPARE(asked.description().photographs.size(), 2u);
    QTest::keyClick(&asked, Qt::Key_Escape);
    waitUntilIdle();
    QVERIFY(!QFile::exists(file("capture.json")));
    QVERIFY(!window_->document().isOpen());
  }

  void eachCanBeOpenedByItself() {
    writeThree();
    drop({file("a_white_green.png"), file("b_white_blue.png"), file("c_white.png")});
    QTest::mouseClick(assistant::button(shown(), "Open each by itself"), Qt::LeftButton);
    waitUntilIdle();
    QCOMPARE(window_->tabs().count(), 3);
    QVERIFY(!QFile::exists(file("capture.json")));
  }

  // Two faces, and tiles of one texture.
  void whatIsNoCaptureIsNotAskedAbout_data() {
    QTest::addColumn<QStringList>("names");
    QTest::newRow("two scenes") << QStringList{"one.png", "mirrored.png"};
    QTest::newRow("tiles") << QStringList{"skin.1001.png", "skin.1002.png"};
  }
  void whatIsNoCaptureIsNotAskedAbout() {
    QFETCH(QStringList, names);
    for (const QString& name : names)
      assistant::writePhotograph(file(name), Qt::white, name.contains("mirrored"));
    drop({file(names[0]), file(names[1])});
    waitUntilIdle();
    QVERIFY(window_->findChild<CaptureAssistant*>() == nullptr);
    QCOMPARE(window_->tabs().count(), 2);
  }

  void aFolderThatCannotBeWrittenIsTold() {
    writeThree();
    drop({file("")});
    CaptureAssistant& asked = shown();
    // Where capture.json would be there is a folder.
    QVERIFY(QDir().mkdir(file("capture.json")));
    asked.accept();
    waitUntilIdle();
    QVERIFY(window_->progress().messageIsError());
    QVERIFY(window_->progress().message().contains("capture.json"));
  }

 private:
  void setUp() override {
    QSettings().clear();
    folder_ = std::make_unique<test::ScratchFolder>();
    window_ = std::make_unique<MainWindow>(std::make_unique<Engine>(scratch_ / "cache"));
    window_->resize(1280, 900);
    window_->show();
  }
  void tearDown() override { window_.reset(); }

  QString file(const QString& name) const {
    return QString::fromStdString((*folder_ / name.toStdString()).string());
  }
  void writeThree() {
    assistant::writePhotograph(file("a_white_green.png"), QColor(150, 255, 150));
    assistant::writePhotograph(file("b_white_blue.png"), QColor(150, 150, 255));
    assistant::writePhotograph(file("c_white.png"), Qt::white);
  }
  QJsonObject capture() const {
    QFile json(file("capture.json"));
    return json.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(json.readAll()).object()
                                          : QJsonObject();
  }
  void drop(const QStringList& paths) {
    QMimeData data;
    QList<QUrl> urls;
    for (const QString& path : paths)
      urls << QUrl::fromLocalFile(path);
    data.setUrls(urls);
    QDragEnterEvent enter({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(window_.get(), &enter);
    QDropEvent event({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(window_.get(), &event);
  }
  CaptureAssistant& shown() {
    CaptureAssistant* dialog = nullptr;
    [&] {
      QTRY_VERIFY_WITH_TIMEOUT((dialog = window_->findChild<CaptureAssistant*>()) != nullptr,
                               assistant::kPatienceMs);
    }();
    if (dialog == nullptr) qFatal("no assistant is shown");
    return *dialog;
  }
  static QComboBox* light(const QWidget& dialog, const QString& photograph) {
    return assistant::named<QComboBox>(dialog, "Light of " + photograph);
  }
  void waitUntilIdle() {
    QTest::qWait(10);
    QTRY_VERIFY_WITH_TIMEOUT(window_->isIdle(), assistant::kPatienceMs);
  }

  test::ScratchFolder scratch_;
  std::unique_ptr<test::ScratchFolder> folder_;
  std::unique_ptr<MainWindow> window_;
};

CUTIS_TEST(CaptureAssistantTest)

}  // namespace
}  // namespace cutis

#include "capture_assistant_test.moc"
