#include "ui/menus/preset_commands.h"

#include <QCoreApplication>

#include "ui/edits/preset_catalogue.h"
#include "ui/edits/preset_controller.h"

namespace cutis {
namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("PresetCommands", text);
}

CommandDescription commandOf(const Editor& editor, const PresetDescription& preset) {
  return {.id = "edit.preset." + preset.id,
          .menu = Menu::edit,
          .submenu = tr("&Presets"),
          .text = preset.title,
          .toolTip = preset.toolTip,
          .run = [editor, id = preset.id] { editor.page().presets().useBuiltIn(id); },
          .objection = [editor] { return editor.page().presets().objectionToUse(); }};
}

}  // namespace

std::vector<CommandDescription> presetCommands(const Editor& editor) {
  const auto toUse = [editor] { return editor.page().presets().objectionToUse(); };
  const auto toKeep = [editor] { return editor.page().presets().objectionToKeeping(); };
  std::vector<CommandDescription> rows = {
      {.id = "edit.copyEdits",
       .menu = Menu::edit,
       .text = tr("&Copy edits"),
       .toolTip = tr("As text, for another picture or a file"),
       .shortcuts = {QKeySequence(tr("Ctrl+Shift+C"))},
       .run = [editor] { editor.page().presets().copy(); },
       .objection = toKeep},
      {.id = "edit.pasteEdits",
       .menu = Menu::edit,
       .text = tr("&Paste edits"),
       .toolTip = tr("In place of the picture's edits; this can be undone"),
       .shortcuts = {QKeySequence(tr("Ctrl+Shift+V"))},
       .run = [editor] { editor.page().presets().paste(); },
       .objection = toUse},
  };
  int number = 0;
  for (const PresetDescription& preset : presetCatalogue()) {
    rows.push_back(commandOf(editor, preset));
    rows.back().shortcuts = {QKeySequence(QString("Ctrl+Alt+%1").arg(++number))};
  }
  rows.push_back({.id = "edit.loadPreset",
                  .menu = Menu::edit,
                  .submenu = tr("&Presets"),
                  .text = tr("&Load preset…"),
                  .toolTip = tr("Edits from a file"),
                  .shortcuts = {QKeySequence(tr("Ctrl+Alt+I"))},
                  .run = [editor] { editor.page().presets().load(); },
                  .objection = toUse});
  rows.push_back({.id = "edit.savePreset",
                  .menu = Menu::edit,
                  .submenu = tr("&Presets"),
                  .text = tr("&Save preset…"),
                  .toolTip = tr("The picture's edits as a file"),
                  .shortcuts = {QKeySequence(tr("Ctrl+Alt+E"))},
                  .run = [editor] { editor.page().presets().save(); },
                  .objection = toKeep});
  return rows;
}

}  // namespace cutis
