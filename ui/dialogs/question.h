#pragma once

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

// Which of the answers Escape gives, and whoever closes the box.
enum class EscapeAnswer { first, last };

// The first answer is the usual one. The box goes with the window; then nobody has answered.
QMessageBox* askQuestion(QWidget& window, const QString& text, const QString& more,
                         const std::vector<Answer>& answers,
                         EscapeAnswer escape = EscapeAnswer::last);

}  // namespace cutis
