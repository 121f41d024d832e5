#pragma once

// What tests of widgets have in common: a warning of Qt is a failure, and so is a window that is
// left open.

#include <QApplication>
#include <QRegularExpression>
#include <QtTest>

namespace cutis::test {

class UiTest : public QObject {
  Q_OBJECT

 protected:
  // Around each test function.
  virtual void setUp() {}
  virtual void tearDown() {}

 private Q_SLOTS:
  void init() {
    // What the platform without a display says of itself is no fault.
    QTest::failOnWarning(QRegularExpression("^(?!This plugin does not support)"));
    setUp();
  }

  void cleanup() {
    tearDown();
    for (const QWidget* widget : QApplication::topLevelWidgets())
      QVERIFY2(!widget->isVisible(), widget->metaObject()->className());
  }
};

}  // namespace cutis::test
