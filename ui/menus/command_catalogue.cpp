#include "ui/menus/command_catalogue.h"

#include <QCoreApplication>
#include <QWidget>

#include "src/app/document/document.h"
#include "ui/commands/command_palette.h"
#include "ui/commands/shortcut_sheet.h"
#include "ui/dialogs/about.h"
#include "ui/dialogs/export_controller.h"
#include "ui/dialogs/fit_options_dialog.h"
#include "ui/dialogs/open_controller.h"
#include "ui/dialogs/reopen_controller.h"
#include "ui/dialogs/save_controller.h"
#include "ui/dialogs/training_controller.h"
#include "ui/docks/edit_controller.h"
#include "ui/docks/fit_controller.h"
#include "ui/docks/workspace.h"
#include "ui/documents/job_display.h"
#include "ui/menus/compare_commands.h"
#include "ui/menus/preset_commands.h"
#include "ui/menus/private_data.h"
#include "ui/menus/spectrum_commands.h"
#include "ui/menus/view_commands.h"
#include "ui/view/viewport.h"

namespace cutis {
namespace {

using Rows = std::vector<CommandDescription>;

QString tr(const char* text) {
  return QCoreApplication::translate("CommandCatalogue", text);
}

QString unlessOpen(const Document& document) {
  return document.isOpen() ? QString() : tr("Nothing is open yet");
}

QString unlessFittable(const Document& document) {
  if (!document.isOpen()) return unlessOpen(document);
  return document.canFit()
             ? QString()
             : tr("Maps stay as they were fitted; open their photographs to fit them again");
}

Rows openCommands(const Editor& editor) {
  OpenController& open = editor.open;
  return {
      {.id = "file.openSample",
       .menu = Menu::file,
       .text = tr("Open &sample"),
       .shortcuts = {QKeySequence(tr("Ctrl+Shift+O"))},
       .run = [&open] { open.openSample(); }},
      {.id = "file.openCapture",
       .menu = Menu::file,
       .text = tr("Open &capture…"),
       .toolTip = tr("Photographs of one subject under several lights, with their capture.json"),
       .shortcuts = {QKeySequence(tr("Ctrl+K"))},
       .run = [&open] { open.chooseCapture(); }},
      {.id = "file.openPhotographs",
       .menu = Menu::file,
       .text = tr("Open &photographs…"),
       .toolTip = tr("Photographs of one subject under several lights, without a capture.json: you "
                     "say which is which"),
       .shortcuts = {QKeySequence(tr("Ctrl+Shift+K"))},
       .run = [&open] { open.choosePhotographs(); }},
      {.id = "file.openImage",
       .menu = Menu::file,
       .text = tr("Open &image, maps or project…"),
       .shortcuts = QKeySequence::keyBindings(QKeySequence::Open),
       .run = [&open] { open.chooseImage(); }},
      {.id = "file.openImageAs",
       .menu = Menu::file,
       .text = tr("Open image &as…"),
       .toolTip = tr("Choose the colour space, layer, exposure and mask"),
       .shortcuts = {QKeySequence(tr("Ctrl+Alt+O"))},
       .run = [&open] { open.chooseImageAs(); }},
  };
}

// What is open, read in another way.
Rows sourceCommands(const Editor& editor) {
  return {
      {.id = "file.interpretAs",
       .menu = Menu::file,
       .text = tr("I&nterpret as…"),
       .toolTip =
           tr("Another colour space, layer, exposure or mask for what is open; its edits are "
              "kept"),
       .shortcuts = {QKeySequence(tr("Ctrl+Alt+A"))},
       .beginsSection = true,
       .run = [editor] { editor.page().reopening().interpret(); },
       .objection = [editor] { return editor.page().reopening().interpretObjection(); }},
      {.id = "file.chooseMask",
       .menu = Menu::file,
       .text = tr("Choose mas&k…"),
       .toolTip = tr("A picture of the same size: what is black in it is left out"),
       .shortcuts = {QKeySequence(tr("Ctrl+M"))},
       .run = [editor] { editor.page().reopening().chooseMask(); },
       .objection = [editor] { return editor.page().reopening().maskObjection(); }},
      {.id = "file.removeMask",
       .menu = Menu::file,
       .text = tr("&Remove mask"),
       .toolTip = tr("The whole picture counts again; a capture's own mask comes back"),
       .shortcuts = {QKeySequence(tr("Ctrl+Shift+M"))},
       .run = [editor] { editor.page().reopening().useMask({}); },
       .objection = [editor] { return editor.page().reopening().removeObjection(); }},
  };
}

Rows fileCommands(const Editor& editor) {
  return {
      {.id = "file.save",
       .menu = Menu::file,
       .text = tr("&Save project"),
       .toolTip = tr("What is open, its fit, its edits and the view of it, in a file of its own"),
       .shortcuts = QKeySequence::keyBindings(QKeySequence::Save),
       .beginsSection = true,
       .run = [editor] { editor.page().saves().save(); },
       .objection = [editor] { return editor.page().saves().objection(); }},
      {.id = "file.saveAs",
       .menu = Menu::file,
       .text = tr("Save project &as…"),
       .shortcuts = {QKeySequence(tr("Ctrl+Shift+S"))},
       .run = [editor] { editor.page().saves().saveAs(); },
       .objection = [editor] { return editor.page().saves().objection(); }},
      {.id = "file.saveMaps",
       .menu = Menu::file,
       .text = tr("Save &maps…"),
       .toolTip = tr("The fitted maps, without the edits"),
       .shortcuts = {QKeySequence(tr("Ctrl+Alt+S"))},
       .run = [editor] { editor.page().exports().chooseMaps(); },
       .objection = [editor] { return editor.page().exports().mapsObjection(); }},
      {.id = "file.export",
       .menu = Menu::file,
       .text = tr("&Export edited albedo…"),
       .shortcuts = {QKeySequence(tr("Ctrl+E"))},
       .run = [editor] { editor.page().exports().choose(); },
       .objection = [editor] { return editor.page().exports().objection(); }},
      {.id = "file.clearPrivateData",
       .menu = Menu::file,
       .text = tr("Clear private &data…"),
       .toolTip = tr("Journals of earlier sessions, caches, and the names of recent files"),
       .shortcuts = {QKeySequence(tr("Ctrl+Shift+Del"))},
       .beginsSection = true,
       .run = [editor] { askToClearPrivateData(editor.window); }},
      {.id = "file.close",
       .menu = Menu::file,
       .text = tr("&Close"),
       .shortcuts = {QKeySequence(tr("Ctrl+W"))},
       .beginsSection = true,
       .run = [editor] { Q_EMIT editor.tabs.closeWanted(editor.page()); },
       .objection = [editor] { return unlessOpen(editor.document()); }},
      {.id = "file.quit",
       .menu = Menu::file,
       .text = tr("&Quit"),
       .shortcuts = {QKeySequence(tr("Ctrl+Q"))},
       .run = [editor] { editor.window.close(); }},
  };
}

Rows editCommands(const Editor& editor) {
  const auto history = [editor]() -> const UndoHistory& { return editor.document().history(); };
  return {
      {.id = "edit.undo",
       .menu = Menu::edit,
       .text = tr("&Undo"),
       .shortcuts = {QKeySequence(tr("Ctrl+Z"))},
       .run = [editor] { editor.document().undo(); },
       .objection =
           [history] { return history().canUndo() ? QString() : tr("There is nothing to undo"); },
       .textNow =
           [history] {
             return history().canUndo() ? tr("&Undo %1").arg(history().undoName()) : tr("&Undo");
           }},
      {.id = "edit.redo",
       .menu = Menu::edit,
       .text = tr("&Redo"),
       .shortcuts = {QKeySequence(tr("Ctrl+Shift+Z")), QKeySequence(tr("Ctrl+Y"))},
       .run = [editor] { editor.document().redo(); },
       .objection =
           [history] { return history().canRedo() ? QString() : tr("There is nothing to redo"); },
       .textNow =
           [history] {
             return history().canRedo() ? tr("&Redo %1").arg(history().redoName()) : tr("&Redo");
           }},
      {.id = "edit.cancelJob",
       .menu = Menu::edit,
       .text = tr("&Cancel what is running"),
       .toolTip = tr("The job at the foot of the window: opening, fitting, writing a file"),
       .shortcuts = {QKeySequence(tr("Ctrl+."))},
       .run = [&jobs = editor.jobs] { jobs.cancelShown(); },
       .objection =
           [&jobs = editor.jobs] {
             return jobs.showsJob() ? QString() : tr("Nothing is running");
           }},
      {.id = "edit.reset",
       .menu = Menu::edit,
       .text = tr("Reset &all edits"),
       .toolTip = tr("Back to the skin as it was photographed; this can be undone"),
       .shortcuts = {QKeySequence(tr("Ctrl+R"))},
       .beginsSection = true,
       .run = [editor] { editor.page().edits().reset(); },
       .objection =
           [editor] {
             if (!editor.document().isOpen()) return unlessOpen(editor.document());
             return isNeutral(editor.document().scene().edits) ? tr("There are no edits")
                                                               : QString();
           }},
  };
}

Rows zoomCommands(const Editor& editor) {
  const auto objection = [editor] { return unlessOpen(editor.document()); };
  return {
      {.id = "view.wholePicture",
       .menu = Menu::view,
       .text = tr("&Whole picture"),
       .shortcuts = {Qt::Key_F},
       .run = [editor] { editor.page().viewport().fitPicture(); },
       .objection = objection},
      {.id = "view.oneToOne",
       .menu = Menu::view,
       .text = tr("&One to one"),
       .toolTip = tr("Each pixel of the picture fills one pixel of the screen"),
       .shortcuts = {Qt::Key_1},
       .run = [editor] { editor.page().viewport().zoomOneToOne(); },
       .objection = objection},
      {.id = "view.zoomIn",
       .menu = Menu::view,
       .text = tr("Zoom &in"),
       .shortcuts = {Qt::Key_Plus, Qt::Key_Equal},
       .run = [editor] { editor.page().viewport().zoomIn(); },
       .objection = objection},
      {.id = "view.zoomOut",
       .menu = Menu::view,
       .text = tr("Zoom o&ut"),
       .shortcuts = {Qt::Key_Minus},
       .run = [editor] { editor.page().viewport().zoomOut(); },
       .objection = objection},
  };
}

Rows tabCommands(const Editor& editor) {
  const auto objection = [editor] {
    return editor.tabs.count() > 1 ? QString() : tr("There is no other document");
  };
  return {
      {.id = "view.nextDocument",
       .menu = Menu::view,
       .text = tr("&Next document"),
       .shortcuts = {QKeySequence(tr("Ctrl+Tab")), QKeySequence(tr("Ctrl+PgDown"))},
       .beginsSection = true,
       .run = [editor] { editor.tabs.step(1); },
       .objection = objection},
      {.id = "view.previousDocument",
       .menu = Menu::view,
       .text = tr("&Previous document"),
       .shortcuts = {QKeySequence(tr("Ctrl+Shift+Tab")), QKeySequence(tr("Ctrl+PgUp"))},
       .run = [editor] { editor.tabs.step(-1); },
       .objection = objection},
  };
}

// One for each dock.
Rows dockCommands(const Editor& editor) {
  const auto objection = [editor] { return unlessOpen(editor.document()); };
  Rows rows;
  for (const DockDescription& dock : editor.page().workspace().all()) {
    rows.push_back(
        {.id = "dock." + dock.id,
         .menu = Menu::view,
         .submenu = tr("&Docks"),
         .text = dock.title,
         .shortcuts = {dock.shortcut},
         .beginsSection = rows.empty(),
         .run = [editor, id = dock.id] { editor.page().workspace().toggle(id); },
         .objection = objection,
         .isOn = [editor, id = dock.id] { return editor.page().workspace().isInFront(id); }});
  }
  rows.push_back({.id = "dock.resetLayout",
                  .menu = Menu::view,
                  .submenu = tr("&Docks"),
                  .text = tr("&Reset layout"),
                  .toolTip = tr("Every dock back to its place"),
                  .shortcuts = {QKeySequence(tr("Shift+F5"))},
                  .run = [editor] { editor.page().workspace().resetLayout(); },
                  .objection = objection});
  return rows;
}

Rows fitCommands(const Editor& editor) {
  const auto objection = [editor] { return unlessFittable(editor.document()); };
  return {
      {.id = "fit.again",
       .menu = Menu::fit,
       .text = tr("&Fit"),
       .toolTip = tr("As the Fit panel says, where a fit was cancelled"),
       .shortcuts = {QKeySequence(tr("Ctrl+F5"))},
       .run = [editor] { editor.page().fit().fitAgain(); },
       .objection = [editor] { return editor.page().fit().objection(); }},
      {.id = "fit.loadProfile",
       .menu = Menu::fit,
       .text = tr("Load &profile…"),
       .toolTip = tr("A profile of the skin model from a JSON file"),
       .shortcuts = {QKeySequence(tr("Ctrl+Shift+L"))},
       .run = [editor] { editor.page().fit().chooseProfile(editor.window); },
       .objection = objection},
      {.id = "fit.options",
       .menu = Menu::fit,
       .text = tr("Fit &options…"),
       .toolTip =
           tr("Lights, surface reflection, noise, prior, parameters that are held, constants "
              "found per pixel"),
       .shortcuts = {QKeySequence(tr("Ctrl+Shift+F"))},
       .run = [editor] { askForFitOptions(editor.document(), editor.window); },
       .objection = objection},
      {.id = "fit.train",
       .menu = Menu::fit,
       .text = tr("&Train a network…"),
       .shortcuts = {QKeySequence(tr("Ctrl+Shift+T"))},
       .run = [editor] { editor.page().training().train(); },
       .objection = objection},
  };
}

Rows helpCommands(const Editor& editor) {
  return {
      {.id = "help.palette",
       .menu = Menu::help,
       .text = tr("&Find command…"),
       .toolTip = tr("Any command by a few letters of its name"),
       .shortcuts = {QKeySequence(tr("Ctrl+Shift+P"))},
       .run = [&palette = editor.palette] { palette.open(); }},
      {.id = "help.shortcuts",
       .menu = Menu::help,
       .text = tr("&Keyboard shortcuts"),
       .toolTip = tr("All shortcuts, to look at and to change"),
       .shortcuts = {Qt::Key_Question},
       .run = [&shortcuts = editor.shortcuts] { shortcuts.open(); }},
      {.id = "help.about",
       .menu = Menu::help,
       .text = tr("&About Cutis"),
       .shortcuts = {QKeySequence(tr("Shift+F1"))},
       .beginsSection = true,
       .run = [&window = editor.window] { showAbout(window); }},
  };
}

}  // namespace

std::vector<CommandDescription> commandCatalogue(const Editor& editor) {
  Rows all;
  for (const auto& part : {openCommands, sourceCommands, fileCommands, editCommands, presetCommands,
                           spectrumCommands, zoomCommands, viewCommands, compareCommands,
                           dockCommands, tabCommands, fitCommands, helpCommands}) {
    for (CommandDescription& row : part(editor))
      all.push_back(std::move(row));
  }
  return all;
}

}  // namespace cutis
