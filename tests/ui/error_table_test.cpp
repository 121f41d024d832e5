#include "ui/widgets/error_table.h"

#include <QLabel>
#include <QtTest>

#include "tests/support/test_registry.h"
#include "tests/ui/ui_test.h"

namespace cutis {
namespace {

class ErrorTableTest : public test::UiTest {
  Q_OBJECT

 private slots:
  void initTestCase() { QLocale::setDefault(QLocale::c()); }

  // The root of 1e-6 is a thousandth of the diffuser's reflectance.
  void errorsAreInPercent() {
    QCOMPARE(errorText(1e-6), QString("0.1 %"));
    QCOMPARE(errorText(8.3e-7), QString("0.091 %"));
    QCOMPARE(errorText(1e-2), QString("10 %"));
    QCOMPARE(errorText(0), QString("0 %"));
  }

  void theVerdictFollowsTheErrorOfTheFit_data() {
    QTest::addColumn<double>("error");
    QTest::addColumn<QString>("verdict");
    QTest::newRow("small") << 1e-6 << "Too small";
    QTest::newRow("middle") << 1e-4 << "slight";
    QTest::newRow("large") << 1e-3 << "visible difference";
    QTest::newRow("no number") << std::nan("") << "visible difference";
  }
  void theVerdictFollowsTheErrorOfTheFit() {
    QFETCH(double, error);
    QFETCH(QString, verdict);
    ErrorTable table;
    table.setErrors({1e-6, 1e-6, 1e-6, error, 1e-6});
    QStringList texts;
    for (const QLabel* label : table.findChildren<QLabel*>())
      texts << label->text();
    QCOMPARE(texts.filter(verdict).size(), 1);
  }
};

CUTIS_TEST(ErrorTableTest)

}  // namespace
}  // namespace cutis

#include "error_table_test.moc"
