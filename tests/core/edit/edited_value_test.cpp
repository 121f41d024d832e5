// The edit factors of resources/manual/model.md: melanin, blend and carotene scale linearly;
// the haemoglobins by index, C · (1 + (s − 1) · i/N) with i/N = (C/0.5)^⅓ dermal and C/0.3
// epidermal.

#include <algorithm>
#include <cmath>

#include <QtTest>

#include "core/edit/edit_stack.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

const ParameterAxis& axisOf(Parameter parameter) {
  return test::li2024().profile().axes[static_cast<std::size_t>(parameter)];
}

double edited(const ParameterEdit& edit, Parameter parameter, double value) {
  const Chromophore& row = chromophoreTable()[static_cast<std::size_t>(parameter)];
  return editedValue(edit, row.editLaw, axisOf(parameter), value);
}

// The page's formulas, with its numbers.
double formula(Parameter parameter, double c, double s) {
  switch (parameter) {
    case kMelanin:
      return std::clamp(c * s, 0.0, 0.5);
    case kMelaninBlend:
      return std::clamp(c * s, 0.0, 1.0);
    case kHaemoglobinDermal:
      return std::clamp(c * (1.0 + (s - 1.0) * std::cbrt(c / 0.5)), 0.0, 0.5);
    case kHaemoglobinEpidermal:
      return std::clamp(c * (1.0 + (s - 1.0) * c / 0.3), 0.0, 0.3);
    case kCarotene:
      return std::clamp(c * s, 0.0, 0.01);
  }
  return -1.0;
}

class EditedValueTest : public QObject {
  Q_OBJECT

 private slots:
  void scalesAsDocumented() {
    for (const Parameter parameter : kParameters) {
      const double maximum = axisOf(parameter).maximum;
      for (int i = 0; i <= 200; ++i) {
        const double c = maximum * i / 200.0;
        for (const double s : {0.0, 0.25, 0.5, 0.9, 1.0, 1.1, 1.5, 2.0, 5.0, 1000.0}) {
          ParameterEdit edit;
          edit.scale = s;
          EXPECT_NEAR(edited(edit, parameter, c), formula(parameter, c, s), 1e-5 * maximum);
        }
      }
    }
  }

  // Blood varies more after an increase: what is little grows little.
  void haemoglobinIsAccentuated() {
    ParameterEdit edit;
    edit.scale = 2.0;
    const double little = edited(edit, kHaemoglobinDermal, 0.001) / 0.001;
    const double much = edited(edit, kHaemoglobinDermal, 0.05) / 0.05;
    QVERIFY(1.0 < little && little < much && much < 2.0);
  }

  void addsInTheParametersUnit() {
    for (const Parameter parameter : kParameters) {
      const double maximum = axisOf(parameter).maximum;
      ParameterEdit edit;
      edit.add = 0.1 * maximum;
      EXPECT_NEAR(edited(edit, parameter, 0.3 * maximum), 0.4 * maximum, 1e-12);
      EXPECT_NEAR(edited(edit, parameter, 0.95 * maximum), maximum, 1e-15);
      edit.add = -0.1 * maximum;
      EXPECT_NEAR(edited(edit, parameter, 0.05 * maximum), 0.0, 0.0);
    }
  }

  // Scaled first, then added; a given value replaces both.
  void orderOfTheThree() {
    ParameterEdit edit;
    edit.scale = 2.0;
    edit.add = 0.01;
    EXPECT_NEAR(edited(edit, kMelanin, 0.1), 0.21, 1e-15);
    edit.set = 0.3;
    EXPECT_NEAR(edited(edit, kMelanin, 0.1), 0.3, 0.0);
    edit.set = 0.0;
    EXPECT_NEAR(edited(edit, kMelanin, 0.1), 0.0, 0.0);
    // The sum is clamped, not its parts.
    edit.set.reset();
    edit.scale = 10.0;
    edit.add = -0.6;
    EXPECT_NEAR(edited(edit, kMelanin, 0.1), 0.4, 1e-15);
  }

  void clampsWhateverIsAsked() {
    for (const Parameter parameter : kParameters) {
      const ParameterAxis& axis = axisOf(parameter);
      for (const double wild : {-1e30, -1.0, 1e30}) {
        ParameterEdit set, add;
        set.set = wild;
        add.add = wild;
        for (const ParameterEdit& edit : {set, add}) {
          const double value = edited(edit, parameter, 0.5 * axis.maximum);
          EXPECT_NEAR(value, wild < 0.0 ? 0.0 : axis.maximum, 0.0);
        }
      }
    }
  }

  void neutralIsNeutral() {
    QVERIFY(ParameterEdit().isNeutral());
    QVERIFY(Edit().isNeutral());
    ParameterEdit scaled;
    scaled.scale = 1.1;
    ParameterEdit added;
    added.add = 1e-9;
    ParameterEdit zero;
    zero.set = 0.0;
    for (const ParameterEdit& change : {scaled, added, zero}) {
      QVERIFY(!change.isNeutral());
      Edit edit;
      edit.parameters[kCarotene] = change;
      QVERIFY(!edit.isNeutral());
      edit.opacity = 0.0;
      QVERIFY(edit.isNeutral());
      edit.opacity = 1.0;
      edit.enabled = false;
      QVERIFY(edit.isNeutral());
    }
  }
};

CUTIS_TEST(EditedValueTest)

}  // namespace
}  // namespace cutis

#include "edited_value_test.moc"
