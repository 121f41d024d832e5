#include "ui/docks/fit_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QStandardItemModel>
#include <QtTest>

#include "tests/support/test_registry.h"
#include "tests/ui/ui_test.h"

namespace cutis {
namespace {

using Subject = FitPanel::Subject;

class FitPanelTest : public test::UiTest {
  Q_OBJECT

 private slots:
  void theKeyboardChooses() {
    QSignalSpy changed(panel_.get(), &FitPanel::changed);
    QTest::keyClick(box("Method"), Qt::Key_Down);
    QTest::keyClick(box("Profile"), Qt::Key_Home);
    QCOMPARE(changed.count(), 2);
    const auto choice = changed.last()[0].value<FitChoice>();
    QVERIFY(choice == (FitChoice{kPaperProfile, FitMethod::network, false}));
    QVERIFY(panel_->choice() == choice);
  }

  void theMouseChoosesShading() {
    QSignalSpy changed(panel_.get(), &FitPanel::changed);
    QTest::mouseClick(shading(), Qt::LeftButton, {}, {8, shading()->height() / 2});
    QCOMPARE(changed.count(), 1);
    QVERIFY(changed[0][0].value<FitChoice>().shading);
  }

  void choicesAreShownSilently() {
    QSignalSpy changed(panel_.get(), &FitPanel::changed);
    for (const FitMethod method :
         {FitMethod::refined, FitMethod::threeStage, FitMethod::fullSearch, FitMethod::network}) {
      const FitChoice choice = {kPaperProfile, method, false};
      panel_->show(choice, Subject::photographs);
      QVERIFY(panel_->choice() == choice);
    }
    QCOMPARE(changed.count(), 0);
  }

  // The wheel scrolls the panel past them.
  void theWheelChoosesNothing() {
    QSignalSpy changed(panel_.get(), &FitPanel::changed);
    QWheelEvent down({5, 5}, box("Method")->mapToGlobal(QPointF(5, 5)), {}, {0, -120}, Qt::NoButton,
                     Qt::NoModifier, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(box("Method"), &down);
    QCOMPARE(changed.count(), 0);
    QCOMPARE(panel_->choice().method, FitMethod::refined);
  }

  void whatCannotBeIsDisabledAndSaysWhy() {
    panel_->show({kDefaultProfile, FitMethod::network, false}, Subject::photographs);
    QVERIFY(!shading()->isEnabled());
    QVERIFY(shading()->toolTip().contains("Refined"));
    panel_->show({}, Subject::texture);
    QVERIFY(!shading()->isEnabled());
    QVERIFY(shading()->toolTip().contains("texture"));
    panel_->show({kDefaultProfile, FitMethod::refined, true}, Subject::photographs);
    QVERIFY(shading()->isEnabled());
    const auto* items = qobject_cast<QStandardItemModel*>(box("Method")->model());
    for (int row = 0; row < items->rowCount(); ++row) {
      QCOMPARE(items->item(row)->isEnabled(), row == 0);
      QCOMPARE(items->item(row)->toolTip().contains("switch that off"), row > 0);
    }
    QTest::keyClick(box("Method"), Qt::Key_Down);  // skips what is disabled
    QCOMPARE(panel_->choice().method, FitMethod::refined);
  }

  void mapsStayWhatTheyAre() {
    panel_->show({"a stranger's", FitMethod::threeStage, false}, Subject::maps);
    QVERIFY(!box("Profile")->isEnabled() && !box("Method")->isEnabled());
    QVERIFY(!panel_->findChild<QPushButton*>()->isEnabled() && !shading()->isEnabled());
    for (const QWidget* control : panel_->findChildren<QWidget*>()) {
      if (control->isEnabled() || control->parentWidget() != panel_.get()) continue;
      QVERIFY(control->toolTip().startsWith("Maps stay"));
    }
    QCOMPARE(box("Profile")->placeholderText(), QString("a stranger's"));
    QCOMPARE(box("Profile")->findData("a stranger's"), -1);
    QCOMPARE(box("Method")->currentText(), QString("Three-stage"));
  }

  void theExposureIsANumberWithItsReason() {
    panel_->showExposure(0.71, 0.98);
    panel_->show({}, Subject::photographs);
    auto* field = panel_->findChild<QLineEdit*>();
    QVERIFY2(!field->isVisibleTo(panel_.get()), "photographs are calibrated");
    panel_->show({}, Subject::texture);
    QVERIFY(field->isVisibleTo(panel_.get()));
    QCOMPARE(field->text(), QString("×0.71"));
    QVERIFY(label("Why this exposure")->text().contains("98 %"));
    QSignalSpy changed(panel_.get(), &FitPanel::changed);
    type(field, "0,5");
    QCOMPARE(changed.count(), 1);
    QCOMPARE(changed[0][0].value<FitChoice>().exposure, std::optional<double>(0.5));
    panel_->show(changed[0][0].value<FitChoice>(), Subject::texture);
    panel_->showExposure(0.5, {});
    QVERIFY(label("Why this exposure")->text().contains("you"));
    type(field, "much");
    QCOMPARE(changed.count(), 1);
    QCOMPARE(field->text(), QString("much"));
    QTest::keyClick(field, Qt::Key_Escape);
    QCheckBox* automatic = nullptr;
    for (QCheckBox* box : panel_->findChildren<QCheckBox*>())
      if (box->text() == "Automatic") automatic = box;
    QVERIFY(!automatic->isChecked());
    QTest::mouseClick(automatic, Qt::LeftButton, {}, {8, automatic->height() / 2});
    QCOMPARE(changed.count(), 2);
    QVERIFY(!changed[1][0].value<FitChoice>().exposure);
  }

  // A file is offered as long as it is shown, and for good once it was fitted with.
  void filesAreOfferedOnceTheyAreGood() {
    const int count = box("Profile")->count();
    panel_->show({"/some/where/broken.json", FitMethod::refined, false}, Subject::photographs);
    QCOMPARE(box("Profile")->currentText(), QString("broken"));
    panel_->show({}, Subject::photographs);
    QCOMPARE(box("Profile")->count(), count);
    QCOMPARE(panel_->choice().profile, std::string(kDefaultProfile));
    panel_->show({"/some/where/good.json", FitMethod::refined, false}, Subject::photographs);
    panel_->keepProfile();
    panel_->show({}, Subject::photographs);
    QCOMPARE(box("Profile")->count(), count + 1);
    QCOMPARE(box("Profile")->itemData(count, Qt::ToolTipRole).toString(),
             QString("/some/where/good.json"));
  }

  void trainingIsOfferedUntilTheChoiceChanges() {
    QSignalSpy wanted(panel_.get(), &FitPanel::trainingWanted);
    QPushButton* train = nullptr;
    for (QPushButton* button : panel_->findChildren<QPushButton*>()) {
      if (button->text().startsWith("Train")) train = button;
    }
    QVERIFY(train != nullptr);
    QVERIFY(!train->isVisibleTo(panel_.get()));
    panel_->offerTraining();
    QVERIFY(train->isVisibleTo(panel_.get()));
    QTest::mouseClick(train, Qt::LeftButton);
    QCOMPARE(wanted.count(), 1);
    panel_->show({}, Subject::photographs);
    QVERIFY(!train->isVisibleTo(panel_.get()));
  }

 private:
  void setUp() override {
    panel_ = std::make_unique<FitPanel>();
    panel_->show({}, Subject::photographs);
  }

  QComboBox* box(const QString& name) const {
    for (QComboBox* candidate : panel_->findChildren<QComboBox*>()) {
      if (candidate->accessibleName() == name) return candidate;
    }
    return nullptr;
  }
  QLabel* label(const QString& name) const {
    for (QLabel* candidate : panel_->findChildren<QLabel*>()) {
      if (candidate->accessibleName() == name) return candidate;
    }
    return nullptr;
  }
  static void type(QLineEdit* field, const QString& text) {
    field->selectAll();
    QTest::keyClicks(field, text);
    QTest::keyClick(field, Qt::Key_Return);
  }
  QCheckBox* shading() const { return panel_->findChild<QCheckBox*>(); }

  std::unique_ptr<FitPanel> panel_;
};

CUTIS_TEST(FitPanelTest)

}  // namespace
}  // namespace cutis

#include "fit_panel_test.moc"
