#include "ui/dialogs/question.h"

#include <QPushButton>

namespace cutis {

QMessageBox* askQuestion(QWidget& window, const QString& text, const QString& more,
                         const std::vector<Answer>& answers, EscapeAnswer escape) {
  auto* box = new QMessageBox(QMessageBox::Question, QObject::tr("%1 — Cutis").arg(text), text,
                              QMessageBox::NoButton, &window);
  box->setInformativeText(more);
  box->setAttribute(Qt::WA_DeleteOnClose);
  std::vector<QPushButton*> buttons;
  for (const Answer& answer : answers)
    buttons.push_back(box->addButton(answer.text, answer.role));
  box->setDefaultButton(buttons.front());
  // Before it is shown: then it is settled what Escape does.
  box->setEscapeButton(escape == EscapeAnswer::first ? buttons.front() : buttons.back());
  // From the event loop: what follows may close the window that the box belongs to.
  QObject::connect(box, &QDialog::finished, box, [box, buttons, answers] {
    for (std::size_t k = 0; k < answers.size(); ++k) {
      if (box->clickedButton() != buttons[k] || !answers[k].then) continue;
      QMetaObject::invokeMethod(box->parent(), answers[k].then, Qt::QueuedConnection);
    }
  });
  box->open();
  return box;
}

}  // namespace cutis
