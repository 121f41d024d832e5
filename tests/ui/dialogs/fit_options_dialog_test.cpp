#include "ui/dialogs/fit_options_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QtTest>

#include "src/files/profiles/profile_file.h"
#include "tests/support/test_registry.h"
#include "tests/ui/ui_test.h"

namespace cutis {
namespace {

namespace fit_options {

template <typename Widget>
Widget& named(const QWidget& dialog, const QString& name) {
  for (Widget* widget : dialog.findChildren<Widget*>())
    if (widget->accessibleName() == name) return *widget;
  qFatal("no widget is called %s", qPrintable(name));
}

QCheckBox& box(const QWidget& dialog, const QString& text) {
  for (QCheckBox* candidate : dialog.findChildren<QCheckBox*>())
    if (candidate->text() == text) return *candidate;
  qFatal("no box is called %s", qPrintable(text));
}

}  // namespace fit_options

class FitOptionsDialogTest : public test::UiTest {
  Q_OBJECT

 private slots:
  void initTestCase() {
    auto profile = loadProfile("skin2026", {});
    QVERIFY(static_cast<bool>(profile));
    profile_ = profile.value();
  }

  void whatIsInForceIsShownAndComesBack() {
    FitChoice choice;
    choice.noise = {0.002, 0.01};
    choice.fixed[kCarotene] = 0.001;
    choice.prior = "/folder/prior.json";
    choice.discrepancy = false;
    FitOptionsDialog dialog(choice, profile_, kUsual, {});
    dialog.show();
    QVERIFY(dialog.choice() == choice);
    QVERIFY(fit_options::box(dialog, "Carotene").isChecked());
    QVERIFY(!fit_options::named<QDoubleSpinBox>(dialog, "Melanin, held at").isEnabled());
    dialog.close();
  }

  void aParameterIsHeldByMouseAndKeys() {
    FitOptionsDialog dialog({}, profile_, kUsual, {});
    dialog.show();
    QCheckBox& held = fit_options::box(dialog, "Melanin");
    QTest::mouseClick(&held, Qt::LeftButton, {}, QPoint(6, held.height() / 2));
    auto& value = fit_options::named<QDoubleSpinBox>(dialog, "Melanin, held at");
    QVERIFY(value.isEnabled());
    value.selectAll();
    QTest::keyClicks(&value, "0.12");
    QTest::keyClick(&value, Qt::Key_Tab);
    QCOMPARE(dialog.choice().fixed[kMelanin], std::optional<double>(0.12));
    dialog.close();
  }

  void exactIsNoNoise() {
    FitOptionsDialog dialog({}, profile_, kUsual, {});
    dialog.show();
    auto& noise = fit_options::named<QComboBox>(dialog, "Noise");
    QVERIFY(noise.itemText(0).contains("0.005"));
    QTest::keyClick(&noise, Qt::Key_End);
    const std::array<double, 2> none = {0.0, 0.0};
    QVERIFY(dialog.choice().noise == none);
    dialog.close();
  }

  // And the other methods know none of it.
  void optionsAskForTheMethodRefined() {
    FitChoice choice;
    choice.method = FitMethod::threeStage;
    FitOptionsDialog dialog(choice, profile_, kUsual, {});
    dialog.show();
    QVERIFY(dialog.choice() == choice);
    fit_options::box(dialog, "Carotene").click();
    QVERIFY(dialog.choice().method == FitMethod::refined);
    dialog.close();
  }

  void whatCannotBeIsSaid() {
    FitOptionsDialog dialog({}, profile_, kUsual, {});
    dialog.show();
    auto& note = fit_options::named<QLabel>(dialog, "What cannot be");
    for (const char* name :
         {"Melanin", "Melanin blend", "Dermal haemoglobin", "Epidermal haemoglobin", "Carotene"}) {
      QVERIFY(!note.isVisible());
      fit_options::box(dialog, name).click();
    }
    QVERIFY(note.isVisible() && note.text().contains("five"));
    QTest::mouseClick(button(dialog, "&Reset"), Qt::LeftButton);
    QVERIFY(!note.isVisible());
    QVERIFY(dialog.choice() == FitChoice{});
    fit_options::box(dialog, "Thickness of the epidermis").click();
    QTest::keyClick(&fit_options::named<QComboBox>(dialog, "Discrepancy"), Qt::Key_Down);
    QVERIFY(note.isVisible());
    QVERIFY(!button(dialog, "&Fit")->isEnabled());
    dialog.close();
  }

  void lightsAndReflectionAreOfCaptures() {
    FitOptionsDialog texture({}, profile_, kUsual, {});
    texture.show();
    QVERIFY(!fit_options::named<QComboBox>(texture, "Surface reflection").isVisible());
    QVERIFY(texture.lights().empty());
    texture.close();
    FitOptionsDialog dialog({}, profile_, kUsual, {{"white", "blue"}, {"white", "blue"}});
    dialog.show();
    auto& note = fit_options::named<QLabel>(dialog, "What cannot be");
    QVERIFY2(dialog.lights().empty(), "all");
    QCheckBox& white = fit_options::box(dialog, "white");
    QTest::mouseClick(&white, Qt::LeftButton, {}, QPoint(6, white.height() / 2));
    QCOMPARE(dialog.lights(), std::vector<std::string>{"blue"});
    fit_options::box(dialog, "blue").click();
    QVERIFY(note.isVisible() && note.text().contains("No light"));
    QVERIFY(!button(dialog, "&Fit")->isEnabled());
    QTest::mouseClick(button(dialog, "&Reset"), Qt::LeftButton);
    QVERIFY(dialog.lights().empty());
    QTest::keyClick(&fit_options::named<QComboBox>(dialog, "Surface reflection"), Qt::Key_End);
    auto& share = fit_options::named<QDoubleSpinBox>(dialog, "Surface reflection, share");
    QVERIFY(share.isEnabled());
    share.selectAll();
    QTest::keyClicks(&share, "0.03");
    QTest::keyClick(&share, Qt::Key_Tab);
    QVERIFY(dialog.choice().specular == SpecularPart::included);
    QCOMPARE(dialog.choice().specularShare, 0.03);
    dialog.close();
  }

  void whatIsKeptOutStaysAsItWasSaid() {
    FitChoice choice;
    choice.specular = SpecularPart::crossPolarised;
    FitOptionsDialog dialog(choice, profile_, kUsual, {{"white"}, {"white"}});
    QVERIFY(dialog.choice() == choice);
    choice.specular = SpecularPart::included;
    choice.shading = true;
    FitOptionsDialog shaded(choice, profile_, kUsual, {{"white"}, {"white"}});
    shaded.show();
    QVERIFY(fit_options::named<QLabel>(shaded, "What cannot be").text().contains("shading"));
    shaded.close();
  }

 private:
  static constexpr std::array<double, 2> kUsual = {0.0001, 0.005};

  static QPushButton* button(const QWidget& dialog, const QString& text) {
    for (QPushButton* candidate : dialog.findChildren<QPushButton*>())
      if (candidate->text() == text) return candidate;
    return nullptr;
  }

  Profile profile_;
};

CUTIS_TEST(FitOptionsDialogTest)

}  // namespace
}  // namespace cutis

#include "fit_options_dialog_test.moc"
