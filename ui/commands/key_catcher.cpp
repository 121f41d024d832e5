#include "ui/commands/key_catcher.h"

#include <QKeyEvent>

namespace cutis {
namespace {

bool isModifier(int key) {
  return key == Qt::Key_Control || key == Qt::Key_Shift || key == Qt::Key_Alt ||
         key == Qt::Key_Meta || key == Qt::Key_AltGr || key == Qt::Key_unknown;
}

// Shift is in the sign itself where it makes another one: "?", not "Shift+?".
QKeySequence sequenceOf(const QKeyEvent& event) {
  Qt::KeyboardModifiers modifiers = event.modifiers() & ~Qt::KeypadModifier;
  const QString sign = event.text();
  const bool isSign = sign.size() == 1 && sign[0].isPrint() && !sign[0].isLetter();
  if (isSign && modifiers == Qt::ShiftModifier) modifiers = Qt::NoModifier;
  return QKeySequence(QKeyCombination(modifiers, static_cast<Qt::Key>(event.key())));
}

}  // namespace

KeyCatcher::KeyCatcher(QWidget* parent) : QLineEdit(parent) {
  setReadOnly(true);
  setPlaceholderText(tr("Press keys"));
  setAccessibleName(tr("New shortcut"));
  setContextMenuPolicy(Qt::NoContextMenu);
}

bool KeyCatcher::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    event->accept();
    return true;
  }
  // Tab would move on before it is seen as a key.
  if (event->type() == QEvent::KeyPress) {
    keyPressEvent(static_cast<QKeyEvent*>(event));
    return true;
  }
  return QLineEdit::event(event);
}

void KeyCatcher::keyPressEvent(QKeyEvent* event) {
  event->accept();
  if (isModifier(event->key())) return;
  const bool isBare = (event->modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier;
  if (isBare && event->key() == Qt::Key_Escape) {
    Q_EMIT givenUp();
  } else if (isBare && (event->key() == Qt::Key_Backspace || event->key() == Qt::Key_Delete)) {
    Q_EMIT caught({});
  } else {
    Q_EMIT caught(sequenceOf(*event));
  }
}

void KeyCatcher::focusOutEvent(QFocusEvent* event) {
  QLineEdit::focusOutEvent(event);
  Q_EMIT givenUp();
}

}  // namespace cutis
