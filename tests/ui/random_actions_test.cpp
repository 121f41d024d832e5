// A person who presses everything: nothing breaks, and what was done can be undone.
//
// CUTIS_RANDOM_ACTIONS sets the number of actions per seed, of which there are few by default.

#include <random>

#include <QSettings>
#include <QtTest>

#include "src/files/edits/edits_file.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_registry.h"
#include "tests/ui/ui_test.h"
#include "tests/ui/window_steps.h"
#include "ui/commands/command_registry.h"
#include "ui/dialogs/open_controller.h"
#include "ui/documents/document_page.h"
#include "ui/documents/document_tabs.h"
#include "ui/view/viewport.h"
#include "ui/widgets/neutral_slider.h"
#include "ui/window/main_window.h"

namespace cutis {
namespace {

constexpr int kRandomPatienceMs = 60000;
constexpr int kUsualActions = 120;

// They ask for a file, begin something long, or leave.
const QStringList kOutOfBounds = {"file.", "help.", "fit."};

class RandomActionsTest : public test::UiTest {
  Q_OBJECT

 private slots:
  void initTestCase() {
    test::keepSettingsIn(folder_.path());
    QImage image(48, 32, QImage::Format_RGB32);
    image.fill(QColor(205, 150, 125));
    QVERIFY(image.save(file("skin.png")));
  }

  void whatWasDoneCanBeUndone_data() {
    QTest::addColumn<int>("seed");
    QTest::newRow("first") << 1;
    QTest::newRow("second") << 2;
  }
  void whatWasDoneCanBeUndone() {
    QFETCH(int, seed);
    random_.seed(static_cast<unsigned>(seed));
    open();
    const std::string atFirst = edits();
    bool isNumber = false;
    const int given = qEnvironmentVariableIntValue("CUTIS_RANDOM_ACTIONS", &isNumber);
    for (int k = 0; k < (isNumber ? given : kUsualActions); ++k) {
      act();
      if (k % 20 == 0) waitUntilIdle();
    }
    waitUntilIdle();
    while (window_->document().history().canUndo())
      window_->document().undo();
    QVERIFY(edits() == atFirst);
  }

 private:
  void setUp() override {
    QSettings().clear();
    window_ = std::make_unique<MainWindow>(std::make_unique<Engine>(folder_ / "cache"));
    window_->resize(1280, 900);
    window_->show();
  }
  void tearDown() override { window_.reset(); }

  int upTo(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }

  void act() {
    switch (upTo(4)) {
      case 0:
        return command();
      case 1:
        return moveSlider();
      case 2:
        return keyInPicture();
      default:
        return mouseInPicture();
    }
  }

  void command() {
    const auto& all = window_->commands().all();
    const CommandDescription& chosen =
        all[static_cast<std::size_t>(upTo(static_cast<int>(all.size())))];
    for (const QString& prefix : kOutOfBounds)
      if (chosen.id.startsWith(prefix)) return;
    if (!chosen.text.contains("…")) window_->commands().run(chosen.id);
  }

  void moveSlider() {
    const auto sliders = window_->tabs().current().findChildren<NeutralSlider*>();
    NeutralSlider* slider = sliders[upTo(static_cast<int>(sliders.size()))];
    if (!slider->isVisible() || !slider->isEnabled()) return;
    const QPoint from = slider->rect().center();
    const QPoint to(upTo(slider->width()), from.y());
    QTest::mousePress(slider, Qt::LeftButton, {}, from);
    QTest::mouseMove(slider, (from + to) / 2);
    QTest::mouseMove(slider, to);
    QTest::mouseRelease(slider, Qt::LeftButton, {}, to);
  }

  void keyInPicture() {
    constexpr std::array kKeys = {Qt::Key_F,    Qt::Key_1,    Qt::Key_Plus, Qt::Key_Minus,
                                  Qt::Key_Left, Qt::Key_Down, Qt::Key_Tab,  Qt::Key_Escape};
    QTest::keyClick(&window_->viewport(), kKeys[static_cast<std::size_t>(upTo(kKeys.size()))]);
  }

  void mouseInPicture() {
    Viewport& viewport = window_->viewport();
    const QPoint place(upTo(viewport.width()), upTo(viewport.height()));
    QTest::mouseMove(&viewport, place);
    if (upTo(2) == 0) QTest::mouseClick(&viewport, Qt::LeftButton, {}, place);
  }

  std::string edits() const { return editsText(window_->document().scene().edits); }
  QString file(const std::string& name) const {
    return QString::fromStdString((folder_ / name).string());
  }
  void open() {
    window_->opener().open(file("skin.png"));
    waitUntilIdle();
    QVERIFY(window_->document().isFitted());
  }
  void waitUntilIdle() {
    QTest::qWait(10);
    QTRY_VERIFY_WITH_TIMEOUT(window_->isIdle(), kRandomPatienceMs);
  }

  std::mt19937 random_;
  test::ScratchFolder folder_;
  std::unique_ptr<MainWindow> window_;
};

CUTIS_TEST(RandomActionsTest)

}  // namespace
}  // namespace cutis

#include "random_actions_test.moc"
