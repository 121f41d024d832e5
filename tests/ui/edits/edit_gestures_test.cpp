// Sliders, keys and wheel as they change a document, on the embedded sample.

#include <array>
#include <cmath>
#include <memory>

#include <QCheckBox>
#include <QLineEdit>
#include <QShortcut>
#include <QVBoxLayout>
#include <QWheelEvent>
#include <QtTest>

#include "src/app/views/view_server.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_registry.h"
#include "tests/ui/ui_test.h"
#include "ui/docks/edit_controller.h"
#include "ui/docks/edit_panel.h"
#include "ui/edits/history_controller.h"
#include "ui/edits/history_panel.h"
#include "ui/view/view_controller.h"
#include "ui/view/viewport.h"
#include "ui/widgets/factor_field.h"
#include "ui/widgets/neutral_slider.h"
#include "ui/widgets/panel_scroll.h"

namespace cutis {
namespace {

constexpr int kGesturePatienceMs = 120000;
constexpr int kPauseMs = 900;

class EditGesturesTest : public test::UiTest {
  Q_OBJECT

 private slots:
  void initTestCase() {
    factors_.attach(panel_);
    document_.openSample();
    QTRY_VERIFY_WITH_TIMEOUT(document_.isFitted(), kGesturePatienceMs);
  }
  void cleanupTestCase() { jobs_.stopAll(); }

  void aBurstOfKeysIsOneStep() {
    NeutralSlider* melanin = slider("Melanin");
    melanin->setFocus();
    for (int i = 0; i < 4; ++i)
      QTest::keyClick(melanin, Qt::Key_Right);
    QCOMPARE(steps(), 1);
    QVERIFY(std::abs(factor(kMelanin) - 1.2) < 1e-9);
    QTest::qWait(kPauseMs);
    QTest::keyClick(melanin, Qt::Key_Right);
    QCOMPARE(steps(), 2);
    document_.undo();
    QVERIFY(std::abs(factor(kMelanin) - 1.2) < 1e-9);
    document_.undo();
    QCOMPARE(melanin->number(), 1.0);
  }

  void aBurstOfNotchesIsOneStep() {
    NeutralSlider* carotene = slider("Carotene");
    carotene->setFocus();
    QTRY_VERIFY(carotene->hasFocus());
    for (int i = 0; i < 3; ++i)
      turnWheel(*carotene, 1);
    QCOMPARE(steps(), 1);
    QVERIFY(factor(kCarotene) > 1.1);
  }

  void linkedSlidersAreOneStep() {
    NeutralSlider* blood = slider("Dermal haemoglobin");
    blood->setFocus();
    QTest::keyClick(blood, Qt::Key_Right);
    QTest::keyClick(blood, Qt::Key_Right);
    QCOMPARE(steps(), 1);
    QCOMPARE(factor(kHaemoglobinDermal), factor(kHaemoglobinEpidermal));
    document_.undo();
    QCOMPARE(factor(kHaemoglobinEpidermal), 1.0);
  }

  // An undo in the midst of a burst ends it; what follows is a step of its own.
  void undoEndsABurst() {
    NeutralSlider* melanin = slider("Melanin");
    melanin->setFocus();
    QTest::keyClick(melanin, Qt::Key_Right);
    document_.undo();
    QTest::keyClick(melanin, Qt::Key_Left);
    QTest::qWait(kPauseMs);
    QCOMPARE(steps(), 1);
    QVERIFY(std::abs(factor(kMelanin) - 0.95) < 1e-9);
  }

  void aClickIsNoStep() {
    NeutralSlider* melanin = slider("Melanin");
    QTest::mouseClick(melanin, Qt::LeftButton, {}, melanin->rect().center() + QPoint(30, 0));
    QTest::mouseClick(melanin, Qt::LeftButton, {}, melanin->rect().center());
    QCOMPARE(steps(), 0);
  }

  void aTypedNumberIsUndone() {
    auto* field = slider("Melanin")->parentWidget()->findChild<FactorField*>();
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, "1,5");
    QTest::keyClick(field, Qt::Key_Return);
    QCOMPARE(factor(kMelanin), 1.5);
    QTest::keyClick(field, Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(factor(kMelanin), 1.0);
    QVERIFY(field->text().startsWith("×1"));
    QCOMPARE(slider("Melanin")->number(), 1.0);
  }

  void theHistoryFollowsAndLeads() {
    factors_.setFactor(kMelanin, 1.3, false);
    factors_.setFactor(kCarotene, 2, false);
    const int newest = history_.currentRow();
    QVERIFY(history_.item(newest)->text().contains("Carotene"));
    QTest::mouseClick(history_.viewport(), Qt::LeftButton, {},
                      history_.visualItemRect(history_.item(newest - 1)).center());
    QTRY_COMPARE(factor(kCarotene), 1.0);
    QCOMPARE(factor(kMelanin), 1.3);
    QCOMPARE(slider("Melanin")->number(), 1.3);
    QCOMPARE(history_.currentRow(), newest - 1);
    QCOMPARE(history_.count(), newest + 1);
  }

  // Whatever has the keyboard, as long as the mouse is over the picture and no text is typed.
  void spacePansFromAnywhere() {
    auto* link = panel_.findChild<QCheckBox*>();
    link->setFocus();
    QTRY_VERIFY(link->hasFocus());
    const bool wasLinked = link->isChecked();
    viewport_.zoomOneToOne();
    const QPoint middle = viewport_.rect().center();
    QTest::mouseMove(&viewport_, middle);
    const QPointF before = viewport_.toImage(middle);
    QTest::keyPress(link, Qt::Key_Space);
    QTest::mousePress(&viewport_, Qt::LeftButton, {}, middle);
    QTest::mouseMove(&viewport_, middle + QPoint(20, 10));
    QTest::mouseRelease(&viewport_, Qt::LeftButton, {}, middle + QPoint(20, 10));
    QTest::keyRelease(link, Qt::Key_Space);
    QCOMPARE(link->isChecked(), wasLinked);
    QVERIFY((viewport_.toImage(middle) - before).manhattanLength() > 20);
    auto* field = panel_.findChild<FactorField*>();
    field->setFocus();
    field->clear();
    QTest::keyClick(field, Qt::Key_Space);
    QCOMPARE(field->text(), QString(" "));
    QTest::keyClick(field, Qt::Key_Escape);
    viewport_.fitPicture();
  }

  // While it is not over the picture space is the control's.
  void spaceElsewhereIsTheControls() {
    auto* link = panel_.findChild<QCheckBox*>();
    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(&viewport_, &leave);
    link->setFocus();
    const bool wasLinked = link->isChecked();
    QTest::keyClick(link, Qt::Key_Space);
    QCOMPARE(link->isChecked(), !wasLinked);
    QTest::keyClick(link, Qt::Key_Space);
  }

 private:
  // A window of its own for each test: one that was hidden would not become active again.
  void setUp() override {
    document_.goToStep(0);
    window_ = std::make_unique<QWidget>();
    auto* column = new QVBoxLayout(window_.get());
    column->addWidget(&viewport_, 1);
    column->addWidget(&scroll_, 1);
    column->addWidget(&history_);
    auto* undo = new QShortcut(QKeySequence::Undo, window_.get());
    connect(undo, &QShortcut::activated, this, [this] { document_.undo(); });
    window_->resize(320, 700);
    for (QWidget* part : parts())
      part->show();
    window_->show();
    window_->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(window_.get()));
    viewport_.setFocus();
    QTRY_VERIFY(viewport_.hasFocus());
  }
  void tearDown() override {
    for (QWidget* part : parts())
      part->setParent(nullptr);
    window_.reset();
  }

  std::array<QWidget*, 3> parts() { return {&viewport_, &scroll_, &history_}; }
  int steps() const { return static_cast<int>(document_.history().position()); }
  double factor(Parameter parameter) const {
    const EditStack& edits = document_.scene().edits;
    return edits.empty() ? 1.0 : edits.front().parameters[parameter].scale;
  }
  NeutralSlider* slider(const QString& name) const {
    for (NeutralSlider* found : panel_.findChildren<NeutralSlider*>()) {
      if (found->accessibleName() == name) return found;
    }
    return nullptr;
  }
  static void turnWheel(QWidget& widget, int notches) {
    const QPointF place = widget.rect().center();
    QWheelEvent event(place, widget.mapToGlobal(place), {}, {0, 120 * notches}, Qt::NoButton,
                      Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&widget, &event);
  }

  test::ScratchFolder folder_;
  Engine engine_{folder_ / "cache"};
  JobRunner jobs_;
  Document document_{engine_, jobs_};
  ViewServer server_{document_, engine_, jobs_};
  std::unique_ptr<QWidget> window_;
  Viewport viewport_;
  EditPanel& panel_ = *new EditPanel;
  PanelScroll scroll_{&panel_};
  HistoryPanel history_;
  ViewController views_{document_, server_, viewport_};
  EditController factors_{document_, views_};
  HistoryController steps_{document_, history_};
};

CUTIS_TEST(EditGesturesTest)

}  // namespace
}  // namespace cutis

#include "edit_gestures_test.moc"
