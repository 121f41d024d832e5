#include "ui/commands/shortcut_settings.h"

#include <algorithm>

#include <QAction>
#include <QSettings>
#include <QStringList>

#include "ui/commands/command_registry.h"

namespace cutis {
namespace {

constexpr char kShortcutGroup[] = "shortcuts";

QString settingOf(const QString& id) {
  return QString("%1/%2").arg(kShortcutGroup, id);
}

QList<QKeySequence> toKeys(const QStringList& texts) {
  QList<QKeySequence> keys;
  for (const QString& text : texts) {
    const QKeySequence read = QKeySequence::fromString(text, QKeySequence::PortableText);
    if (!read.isEmpty()) keys << read;
  }
  return keys;
}

// What lists, sliders and fields need for themselves.
bool belongsToControls(const QKeySequence& keys) {
  static const QList<int> own = {Qt::Key_Space,  Qt::Key_Tab,   Qt::Key_Backtab, Qt::Key_Escape,
                                 Qt::Key_Return, Qt::Key_Enter, Qt::Key_Left,    Qt::Key_Right,
                                 Qt::Key_Up,     Qt::Key_Down,  Qt::Key_Menu};
  const QKeyCombination first = keys[0];
  return (first.keyboardModifiers() & ~Qt::ShiftModifier) == Qt::NoModifier &&
         own.contains(static_cast<int>(first.key()));
}

const CommandDescription& rowOf(const CommandRegistry& commands, const QString& id) {
  const auto& all = commands.all();
  return *std::find_if(all.begin(), all.end(), [&](const auto& row) { return row.id == id; });
}

}  // namespace

void ShortcutSettings::restore() {
  QSettings settings;
  settings.beginGroup(kShortcutGroup);
  QList<QKeySequence> chosen;
  for (const CommandDescription& row : commands_.all()) {
    if (!settings.contains(row.id)) continue;
    QList<QKeySequence> keys = toKeys(settings.value(row.id).toStringList());
    keys.removeIf([&](const QKeySequence& k) { return chosen.contains(k); });
    commands_.action(row.id)->setShortcuts(keys);
    chosen << keys;
  }
  for (const CommandDescription& row : commands_.all()) {
    if (settings.contains(row.id)) continue;
    QList<QKeySequence> keys = row.shortcuts;
    keys.removeIf([&](const QKeySequence& k) { return chosen.contains(k); });
    commands_.action(row.id)->setShortcuts(keys);
  }
}

QString ShortcutSettings::objectionTo(const QString& id, const QKeySequence& keys) const {
  const QString text = keys.toString(QKeySequence::NativeText);
  if (belongsToControls(keys)) {
    return CommandRegistry::tr("%1 moves within lists, sliders and fields; press other keys.")
        .arg(text);
  }
  for (const CommandDescription& other : commands_.all()) {
    if (other.id == id || !commands_.action(other.id)->shortcuts().contains(keys)) continue;
    return CommandRegistry::tr("%1 belongs to “%2”; press other keys, or change that one first.")
        .arg(text, commands_.nameOf(other));
  }
  return {};
}

QString ShortcutSettings::choose(const QString& id, const QKeySequence& keys) {
  const QString objection = keys.isEmpty() ? QString() : objectionTo(id, keys);
  if (!objection.isEmpty()) return objection;
  QStringList kept;
  if (!keys.isEmpty()) kept << keys.toString(QKeySequence::PortableText);
  QSettings().setValue(settingOf(id), kept);
  commands_.action(id)->setShortcuts(toKeys(kept));
  return {};
}

QString ShortcutSettings::reset(const QString& id) {
  const CommandDescription& row = rowOf(commands_, id);
  for (const QKeySequence& keys : row.shortcuts) {
    const QString objection = keys.isEmpty() ? QString() : objectionTo(id, keys);
    if (!objection.isEmpty()) return objection;
  }
  QSettings().remove(settingOf(id));
  commands_.action(id)->setShortcuts(row.shortcuts);
  return {};
}

void ShortcutSettings::resetAll() {
  QSettings().remove(kShortcutGroup);
  for (const CommandDescription& row : commands_.all())
    commands_.action(row.id)->setShortcuts(row.shortcuts);
}

bool ShortcutSettings::isUsual(const QString& id) const {
  return commands_.action(id)->shortcuts() == rowOf(commands_, id).shortcuts;
}

}  // namespace cutis
