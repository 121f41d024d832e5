// A mask for what is open, in the window: chosen, dropped or found beside it, and never in silence.

#include <QComboBox>
#include <QDropEvent>
#include <QFileDialog>
#include <QImage>
#include <QLineEdit>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QSettings>
#include <QtTest>

#include "src/app/project/manifest.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_registry.h"
#include "tests/ui/ui_test.h"
#include "tests/ui/window_steps.h"
#include "ui/commands/command_registry.h"
#include "ui/dialogs/open_as_dialog.h"
#include "ui/dialogs/open_controller.h"
#include "ui/dialogs/save_controller.h"
#include "ui/docks/edit_controller.h"
#include "ui/docks/info_panel.h"
#include "ui/documents/document_page.h"
#include "ui/documents/document_tabs.h"
#include "ui/view/viewport.h"
#include "ui/widgets/notice_bar.h"
#include "ui/widgets/progress_strip.h"
#include "ui/window/main_window.h"

namespace cutis {
namespace {

namespace mask_window {

constexpr int kPatienceMs = 60000;
constexpr int kWidth = 40, kHeight = 30;
constexpr std::uint64_t kHalf = std::uint64_t{kWidth} * kHeight / 2;

}  // namespace mask_window

class MaskWindowTest : public test::UiTest {
  Q_OBJECT

 private slots:
  void initTestCase() {
    test::keepSettingsIn(folder_.path());
    using namespace mask_window;
    paint("face.png", QColor(200, 150, 130), QSize(kWidth, kHeight));
    paint("plain/skin.png", QColor(190, 140, 120), QSize(kWidth, kHeight));
    paint("small mask.png", Qt::white, QSize(4, 4));
    paint("black mask.png", Qt::black, QSize(kWidth, kHeight));
    for (const char* name : {"face_mask.png", "plain/half (mask).png"}) {
      QImage half(kWidth, kHeight, QImage::Format_RGB32);
      half.fill(Qt::white);
      for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth / 2; ++x)
          half.setPixelColor(x, y, Qt::black);
      QVERIFY(half.save(file(name)));
    }
  }

  void aMaskBesideIsOfferedAndRemembered() {
    open("face.png");
    QVERIFY(notice().isVisible());
    QCOMPARE(notice().text(), QString("face_mask.png lies beside it: use it as the mask?"));
    QCOMPARE(masked(), std::uint64_t{0});
    window_->edits().setFactor(kMelanin, 2.0, false);
    test::pressButton(notice(), "Use as mask");
    waitUntilIdle();
    QVERIFY(!notice().isVisible());
    QCOMPARE(masked(), mask_window::kHalf);
    QCOMPARE(melanin(), 2.0);
    QVERIFY(hasInfo("black in the mask face_mask.png"));
    window_->saves().saveTo(file("masked.cutis"));
    waitUntilIdle();
    makeWindow();
    open("masked.cutis");
    QVERIFY(!notice().isVisible());
    QCOMPARE(window_->document().openChoice().source.mask, folder_ / "face_mask.png");
    window_->commands().run("file.removeMask");
    waitUntilIdle();
    QCOMPARE(masked(), std::uint64_t{0});
    QCOMPARE(melanin(), 2.0);
    QVERIFY(window_->isWindowModified());
    QVERIFY2(!notice().isVisible(), "once");
    QVERIFY(!window_->commands().action("file.removeMask")->isEnabled());
  }

  void whoDeclinesIsNotAskedAgain() {
    open("face.png");
    test::pressButton(notice(), "No");
    QVERIFY(!notice().isVisible());
    window_->document().reload();
    waitUntilIdle();
    QVERIFY(!notice().isVisible());
    QCOMPARE(masked(), std::uint64_t{0});
  }

  void aDroppedMaskIsAskedAbout() {
    open("plain/skin.png");
    QVERIFY(!notice().isVisible());
    drop({"plain/half (mask).png"});
    QVERIFY(question() != nullptr);
    QVERIFY(question()->text().contains("half (mask).png the mask of skin.png"));
    answer("Cancel");
    QCOMPARE(masked(), std::uint64_t{0});
    drop({"plain/half (mask).png"});
    answer("Use as mask");
    waitUntilIdle();
    QCOMPARE(masked(), mask_window::kHalf);
    QCOMPARE(window_->tabs().count(), 1);
    drop({"plain/half (mask).png"});
    answer("Open as a picture");
    waitUntilIdle();
    QCOMPARE(window_->tabs().count(), 2);
    drop({"face.png"});
    QVERIFY2(question() == nullptr, "its name is no mask's");
    waitUntilIdle();
    QCOMPARE(window_->tabs().count(), 3);
  }

  // Both dropped at once are one picture, whose mask is offered.
  void aMaskDroppedWithItsPictureIsNoPicture() {
    drop({"face_mask.png", "face.png"});
    waitUntilIdle();
    QCOMPARE(window_->tabs().count(), 1);
    QVERIFY(notice().text().startsWith("face_mask.png"));
  }

  void aMaskIsChosenByKey() {
    open("plain/skin.png");
    chooseInDialog(file("plain/half (mask).png"));
    window_->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(window_.get()));
    QTest::keyClick(&window_->viewport(), Qt::Key_M, Qt::ControlModifier);
    waitUntilIdle();
    QCOMPARE(masked(), mask_window::kHalf);
  }

  void whatCannotBeIsSaid() {
    open("plain/skin.png");
    window_->edits().setFactor(kMelanin, 2.0, false);
    useMask("small mask.png");
    QVERIFY(window_->progress().messageIsError());
    QVERIFY(window_->progress().message().contains("make them the same size"));
    QVERIFY(window_->document().openChoice().source.mask.empty());
    QVERIFY(window_->document().isFitted());
    useMask("black mask.png");
    QVERIFY(hasInfo("the mask is empty, it leaves out every pixel"));
    QVERIFY(hasInfo("no pixel could be fitted"));
    QCOMPARE(melanin(), 2.0);
    window_->opener().openSample();
    waitUntilIdle();
    QVERIFY(window_->commands().action("file.chooseMask")->toolTip().contains("take no mask"));
  }

  // And its edits, its mask and its tab are kept.
  void whatIsOpenIsReadInAnotherWay() {
    open("face.png");
    test::pressButton(notice(), "Use as mask");
    waitUntilIdle();
    window_->edits().setFactor(kMelanin, 2.0, false);
    window_->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(window_.get()));
    QTest::keyClick(&window_->viewport(), Qt::Key_A, Qt::ControlModifier | Qt::AltModifier);
    waitUntilIdle();
    auto* dialog = window_->findChild<OpenAsDialog*>();
    QVERIFY(dialog != nullptr && dialog->windowTitle() == "Interpret as");
    QCOMPARE(dialog->choice().source.mask, folder_ / "face_mask.png");
    for (QComboBox* box : dialog->findChildren<QComboBox*>()) {
      if (box->accessibleName() != "Colour space") continue;
      const int linear = box->findData("Linear Rec.709");
      QVERIFY(linear > 0);
      for (int step = 0; step < linear; ++step)
        QTest::keyClick(box, Qt::Key_Down);
    }
    const std::string space = dialog->choice().source.colorSpace;
    QVERIFY(!space.empty());
    test::pressButton(*dialog, "&Apply");
    waitUntilIdle();
    QCOMPARE(window_->document().openChoice().source.colorSpace, space);
    QVERIFY(window_->document().scene().source->colors.followed.space.isLinear());
    QCOMPARE(masked(), mask_window::kHalf);
    QCOMPARE(melanin(), 2.0);
    QCOMPARE(window_->tabs().count(), 1);
  }

 private:
  void setUp() override {
    QSettings().clear();
    makeWindow();
  }
  void tearDown() override { window_.reset(); }
  void makeWindow() {
    window_.reset();
    window_ = std::make_unique<MainWindow>(std::make_unique<Engine>(folder_ / "cache"));
    window_->resize(1280, 900);
    window_->show();
  }

  QString file(const std::string& name) const {
    return QString::fromStdString((folder_ / name).string());
  }
  void paint(const std::string& name, const QColor& color, const QSize& size) {
    std::filesystem::create_directories((folder_ / name).parent_path());
    QImage image(size, QImage::Format_RGB32);
    image.fill(color);
    QVERIFY(image.save(file(name)));
  }
  void waitUntilIdle() {
    QTest::qWait(10);
    QTRY_VERIFY_WITH_TIMEOUT(window_->isIdle(), mask_window::kPatienceMs);
  }
  void open(const std::string& name) {
    window_->opener().open(file(name));
    waitUntilIdle();
  }
  void useMask(const std::string& name) {
    chooseInDialog(file(name));
    window_->commands().run("file.chooseMask");
    waitUntilIdle();
  }
  void drop(const std::vector<std::string>& names) {
    QList<QUrl> urls;
    for (const std::string& name : names)
      urls << QUrl::fromLocalFile(file(name));
    QMimeData data;
    data.setUrls(urls);
    QDragEnterEvent enter({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(window_.get(), &enter);
    QDropEvent event({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(window_.get(), &event);
    // The window looks at what was dropped when the program that it comes from is free again.
    QTest::qWait(1);
  }

  NoticeBar& notice() const { return window_->tabs().current().notice(); }
  std::uint64_t masked() const { return window_->document().statistics().pixels.masked; }
  double melanin() const {
    return window_->document().scene().edits.front().parameters[kMelanin].scale;
  }
  bool hasInfo(const QString& part) const {
    const auto* panel = window_->tabs().current().findChild<InfoPanel*>();
    return !panel->findItems(part, Qt::MatchContains).isEmpty();
  }
  QMessageBox* question() const { return test::questionBefore(*window_); }
  void answer(const QString& text) { test::answerQuestion(*window_, text); }
  void chooseInDialog(const QString& path) { test::chooseInNextDialog(*window_, path); }

  test::ScratchFolder folder_;
  std::unique_ptr<MainWindow> window_;
};

CUTIS_TEST(MaskWindowTest)

}  // namespace
}  // namespace cutis

#include "mask_window_test.moc"
