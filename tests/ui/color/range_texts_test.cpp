#include "ui/color/range_texts.h"

#include <QLocale>
#include <QtTest>

#include "tests/support/test_registry.h"

namespace cutis {
namespace {

class RangeTextsTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { QLocale::setDefault(QLocale::c()); }

  void textsHaveTheDigitsTheyNeed() {
    QCOMPARE(rangeTexts({0, 0.25})[1], QString("0.125"));
    QCOMPARE(rangeTexts({0, 0.2})[2], QString("0.2"));
    QCOMPARE(rangeTexts({-1, 1})[1], QString("0"));
    QCOMPARE(rangeTexts({0, 0.0317})[2], QString("0.0317"));
    QCOMPARE(rangeTexts({0.01, 0.25, true})[0], QString("0.01"));
    QCOMPARE(rangeTexts({0.01, 0.25, true})[1], QString("0.05"));
  }
};

CUTIS_TEST(RangeTextsTest)

}  // namespace
}  // namespace cutis

#include "range_texts_test.moc"
