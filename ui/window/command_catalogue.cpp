#include "ui/window/command_catalogue.h"

#include <QCoreApplication>
#include <QWidget>

#include "src/app/document/document.h"
#include "ui/dialogs/about.h"
#include "ui/dialogs/export_controller.h"
#include "ui/dialogs/open_controller.h"
#include "ui/dialogs/training_controller.h"
#include "ui/docks/edit_controller.h"
#include "ui/docks/fit_controller.h"
#include "ui/docks/workspace.h"
#include "ui/view/view_catalogue.h"
#include "ui/view/view_controller.h"
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

Rows fileCommands(const Editor& editor) {
  OpenController& open = editor.open;
  ExportController& exports = editor.exports;
  QWidget& window = editor.window;
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
      {.id = "file.openImage",
       .menu = Menu::file,
       .text = tr("Open &image or maps…"),
       .shortcuts = QKeySequence::keyBindings(QKeySequence::Open),
       .run = [&open] { open.chooseImage(); }},
      {.id = "file.openImageAs",
       .menu = Menu::file,
       .text = tr("Open image &as…"),
       .toolTip = tr("Choose the colour space, layer, exposure and mask"),
       .shortcuts = {QKeySequence(tr("Ctrl+Alt+O"))},
       .run = [&open] { open.chooseImageAs(); }},
      {.id = "file.export",
       .menu = Menu::file,
       .text = tr("&Export edited albedo…"),
       .shortcuts = {QKeySequence(tr("Ctrl+E"))},
       .beginsSection = true,
       .run = [&exports] { exports.choose(); },
       .objection = [&exports] { return exports.objection(); }},
      {.id = "file.quit",
       .menu = Menu::file,
       .text = tr("&Quit"),
       .shortcuts = {QKeySequence(tr("Ctrl+Q"))},
       .beginsSection = true,
       .run = [&window] { window.close(); }},
  };
}

Rows editCommands(const Editor& editor) {
  Document& document = editor.document;
  const UndoHistory& history = document.history();
  return {
      {.id = "edit.undo",
       .menu = Menu::edit,
       .text = tr("&Undo"),
       .shortcuts = {QKeySequence(tr("Ctrl+Z"))},
       .run = [&document] { document.undo(); },
       .objection =
           [&history] { return history.canUndo() ? QString() : tr("There is nothing to undo"); },
       .textNow =
           [&history] {
             return history.canUndo() ? tr("&Undo %1").arg(history.undoName()) : tr("&Undo");
           }},
      {.id = "edit.redo",
       .menu = Menu::edit,
       .text = tr("&Redo"),
       .shortcuts = {QKeySequence(tr("Ctrl+Shift+Z")), QKeySequence(tr("Ctrl+Y"))},
       .run = [&document] { document.redo(); },
       .objection =
           [&history] { return history.canRedo() ? QString() : tr("There is nothing to redo"); },
       .textNow =
           [&history] {
             return history.canRedo() ? tr("&Redo %1").arg(history.redoName()) : tr("&Redo");
           }},
      {.id = "edit.reset",
       .menu = Menu::edit,
       .text = tr("Reset &all edits"),
       .toolTip = tr("Back to the skin as it was photographed; this can be undone"),
       .shortcuts = {QKeySequence(tr("Ctrl+R"))},
       .beginsSection = true,
       .run = [&edits = editor.edits] { edits.reset(); },
       .objection =
           [&document] {
             if (!document.isOpen()) return unlessOpen(document);
             return isNeutral(document.scene().edits) ? tr("There are no edits") : QString();
           }},
  };
}

Rows zoomCommands(const Editor& editor) {
  Viewport& viewport = editor.viewport;
  const auto objection = [&document = editor.document] { return unlessOpen(document); };
  return {
      {.id = "view.wholePicture",
       .menu = Menu::view,
       .text = tr("&Whole picture"),
       .shortcuts = {Qt::Key_F},
       .keyboardOf = &viewport,
       .run = [&viewport] { viewport.fitPicture(); },
       .objection = objection},
      {.id = "view.oneToOne",
       .menu = Menu::view,
       .text = tr("&One to one"),
       .toolTip = tr("Each pixel of the picture fills one pixel of the screen"),
       .shortcuts = {Qt::Key_1},
       .keyboardOf = &viewport,
       .run = [&viewport] { viewport.zoomOneToOne(); },
       .objection = objection},
      {.id = "view.zoomIn",
       .menu = Menu::view,
       .text = tr("Zoom &in"),
       .shortcuts = {Qt::Key_Plus, Qt::Key_Equal},
       .keyboardOf = &viewport,
       .run = [&viewport] { viewport.zoomIn(); },
       .objection = objection},
      {.id = "view.zoomOut",
       .menu = Menu::view,
       .text = tr("Zoom o&ut"),
       .shortcuts = {Qt::Key_Minus},
       .keyboardOf = &viewport,
       .run = [&viewport] { viewport.zoomOut(); },
       .objection = objection},
  };
}

// One for each view of the catalogue, on Alt and a digit as long as there are digits.
Rows viewCommands(const Editor& editor) {
  Rows rows;
  for (const ViewDescription& view : viewCatalogue()) {
    const auto number = rows.size() + 1;
    rows.push_back(
        {.id = "view." + view.id,
         .menu = Menu::view,
         .text = view.name,
         .toolTip = view.toolTip,
         .beginsSection = rows.empty(),
         .run = [&views = editor.views, kind = view.kind] { views.show(kind); },
         .objection =
             [&document = editor.document, &views = editor.views, kind = view.kind] {
               if (!document.isOpen()) return unlessOpen(document);
               return views.isOffered(kind)
                          ? QString()
                          : tr("Maps alone hold no photograph; open the photographs "
                               "they were fitted to");
             },
         .isOn = [&document = editor.document, &views = editor.views,
                  kind = view.kind] { return document.isOpen() && views.current() == kind; }});
    if (number <= 10) {
      rows.back().shortcuts = {QKeySequence(QString("Alt+%1").arg(number % 10))};
    }
  }
  return rows;
}

// One for each dock.
Rows dockCommands(const Editor& editor) {
  Workspace& workspace = editor.workspace;
  const auto objection = [&document = editor.document] { return unlessOpen(document); };
  Rows rows;
  for (const DockDescription& dock : workspace.all()) {
    rows.push_back({.id = "dock." + dock.id,
                    .menu = Menu::view,
                    .submenu = tr("&Docks"),
                    .text = dock.title,
                    .shortcuts = {dock.shortcut},
                    .beginsSection = rows.empty(),
                    .run = [&workspace, id = dock.id] { workspace.toggle(id); },
                    .objection = objection,
                    .isOn = [&workspace, id = dock.id] { return workspace.isInFront(id); }});
  }
  rows.push_back({.id = "dock.resetLayout",
                  .menu = Menu::view,
                  .submenu = tr("&Docks"),
                  .text = tr("&Reset layout"),
                  .toolTip = tr("Every dock back to its place"),
                  .shortcuts = {QKeySequence(tr("Shift+F5"))},
                  .run = [&workspace] { workspace.resetLayout(); },
                  .objection = objection});
  return rows;
}

Rows fitCommands(const Editor& editor) {
  FitController& fit = editor.fit;
  TrainingController& training = editor.training;
  QWidget& window = editor.window;
  const auto objection = [&document = editor.document] { return unlessFittable(document); };
  return {
      {.id = "fit.loadProfile",
       .menu = Menu::fit,
       .text = tr("Load &profile…"),
       .toolTip = tr("A profile of the skin model from a JSON file"),
       .shortcuts = {QKeySequence(tr("Ctrl+Shift+L"))},
       .run = [&fit, &window] { fit.chooseProfile(window); },
       .objection = objection},
      {.id = "fit.train",
       .menu = Menu::fit,
       .text = tr("&Train a network…"),
       .shortcuts = {QKeySequence(tr("Ctrl+T"))},
       .run = [&training] { training.train(); },
       .objection = objection},
  };
}

Rows helpCommands(const Editor& editor) {
  return {
      {.id = "help.about",
       .menu = Menu::help,
       .text = tr("&About Cutis"),
       .shortcuts = {QKeySequence(tr("Shift+F1"))},
       .run = [&window = editor.window] { showAbout(window); }},
  };
}

}  // namespace

std::vector<CommandDescription> commandCatalogue(const Editor& editor) {
  Rows all;
  for (const auto& part : {fileCommands, editCommands, zoomCommands, viewCommands, dockCommands,
                           fitCommands, helpCommands}) {
    for (CommandDescription& row : part(editor))
      all.push_back(std::move(row));
  }
  return all;
}

}  // namespace cutis
