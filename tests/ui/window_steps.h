#pragma once

// What tests of a whole window do again and again: settings of their own, and answers to the
// questions and dialogs that stand before it.

#include <filesystem>

#include <QApplication>
#include <QCoreApplication>
#include <QFileDialog>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <QTimer>
#include <QtTest>

namespace cutis::test {

// From now on settings are read from there and written there.
inline void keepSettingsIn(const std::filesystem::path& folder) {
  QSettings::setDefaultFormat(QSettings::IniFormat);
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope,
                     QString::fromStdString(folder.string()));
  QCoreApplication::setOrganizationName("cutis-test");
}

// That stands before the window; null if none does.
inline QMessageBox* questionBefore(const QWidget& window) {
  for (QMessageBox* box : window.findChildren<QMessageBox*>()) {
    if (box->isVisible()) return box;
  }
  return nullptr;
}

inline void pressButton(QWidget& parent, const QString& text) {
  for (QPushButton* button : parent.findChildren<QPushButton*>()) {
    if (button->text() == text) return QTest::mouseClick(button, Qt::LeftButton);
  }
  QFAIL(qPrintable("no button " + text));
}

inline void answerQuestion(const QWidget& window, const QString& text) {
  QMessageBox* box = questionBefore(window);
  QVERIFY2(box != nullptr, qPrintable(text));
  pressButton(*box, text);
  QTest::qWait(1);
}

// In the dialog of files that opens next before the window, as if typed.
inline void chooseInNextDialog(QWidget& window, const QString& path) {
  auto* timer = new QTimer(&window);
  QObject::connect(timer, &QTimer::timeout, &window, [timer, path] {
    for (QWidget* widget : QApplication::topLevelWidgets()) {
      auto* dialog = qobject_cast<QFileDialog*>(widget);
      if (dialog == nullptr || !dialog->isVisible()) continue;
      timer->deleteLater();
      dialog->findChild<QLineEdit*>("fileNameEdit")->setText(path);
      static_cast<QDialog*>(dialog)->accept();
      return;
    }
  });
  timer->start(50);
}

}  // namespace cutis::test
