#pragma once  // internal to ui

// A question before the window that does not stop the program: whoever asks goes on when it is
// answered. Interface thread only.

#include <functional>
#include <vector>

#include <QMessageBox>
#include <QString>

namespace cutis {

struct Answer {
  QString text;  // of its button
  QMessageBox::ButtonRole role = QMessageBox::AcceptRole;
  std::function<void()> then = {};  // may be empty
};

// The first answer is the usual one, the last that of Escape. The box goes with the window; then
// nobody has answered.
QMessageBox* askQuestion(QWidget& window, const QString& text, const QString& more,
                         const std::vector<Answer>& answers);

}  // namespace cutis
