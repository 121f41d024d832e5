#include "ui/menus/compare_commands.h"

#include <utility>

#include <QClipboard>
#include <QCoreApplication>
#include <QGuiApplication>

#include "src/app/document/document.h"
#include "ui/compare/comparison_controller.h"
#include "ui/view/viewport.h"

namespace cutis {
namespace {

using CompareRows = std::vector<CommandDescription>;

QString tr(const char* text) {
  return QCoreApplication::translate("CompareCommands", text);
}

QString unlessSomethingOpen(const Editor& editor) {
  return editor.document().isOpen() ? QString() : tr("Nothing is open yet");
}

CommandDescription rowOf(const Editor& editor, const QString& id, const QString& text,
                         const QString& toolTip, const QKeySequence& shortcut) {
  CommandDescription row;
  row.id = "compare." + id;
  row.menu = Menu::view;
  row.submenu = tr("&Compare");
  row.text = text;
  row.toolTip = toolTip;
  row.shortcuts = {shortcut};
  row.objection = [editor] { return unlessSomethingOpen(editor); };
  return row;
}

CommandDescription modeRow(const Editor& editor, ComparisonMode mode, const QString& id,
                           const QString& text, const QString& toolTip,
                           const QKeySequence& shortcut) {
  CommandDescription row = rowOf(editor, id, text, toolTip, shortcut);
  row.run = [editor, mode] {
    ComparisonController& comparison = editor.page().comparison();
    comparison.setMode(comparison.mode() == mode ? ComparisonMode::none : mode);
  };
  row.isOn = [editor, mode] {
    return editor.document().isOpen() && editor.page().comparison().mode() == mode;
  };
  row.exclusiveGroup = "comparison";
  return row;
}

CommandDescription partnerRow(const Editor& editor, Partner partner, const QString& id,
                              const QString& text, const QString& toolTip,
                              const QKeySequence& shortcut) {
  CommandDescription row = rowOf(editor, id, text, toolTip, shortcut);
  row.run = [editor, partner] { editor.page().comparison().setPartner(partner); };
  row.isOn = [editor, partner] {
    return editor.document().isOpen() && editor.page().comparison().partner() == partner;
  };
  row.exclusiveGroup = "partner";
  return row;
}

CommandDescription turnRow(const Editor& editor) {
  CommandDescription row = rowOf(editor, "turn", tr("&Turn to the other picture"),
                                 tr("Held, it shows the other picture as long as it is held; "
                                    "tapped, until it is tapped again"),
                                 Qt::Key_T);
  row.run = [editor] {
    ComparisonController& comparison = editor.page().comparison();
    comparison.setTurned(!comparison.isTurned());
  };
  row.isOn = [editor] {
    return editor.document().isOpen() && editor.page().comparison().isTurned();
  };
  return row;
}

CompareRows modeRows(const Editor& editor) {
  return {
      modeRow(editor, ComparisonMode::wipe, "wipe", tr("&Wipe"),
              tr("A line in the picture, with the other picture right of it; drag it, or move it "
                 "with Shift and the arrow keys"),
              Qt::Key_W),
      modeRow(editor, ComparisonMode::sideBySide, "sideBySide", tr("&Side by side"),
              tr("Both pictures, always at the same place"), QKeySequence(tr("Shift+W"))),
      modeRow(editor, ComparisonMode::difference, "difference", tr("&Difference"),
              tr("How different the two look (ΔE 2000), or by how much two maps differ"),
              Qt::Key_D),
      turnRow(editor),
  };
}

CompareRows partnerRows(const Editor& editor) {
  CompareRows rows = {
      partnerRow(editor, Partner::original, "original", tr("With the &original"),
                 tr("The photograph; for a map, the map without edits"),
                 QKeySequence(tr("Ctrl+5"))),
      partnerRow(editor, Partner::reconstruction, "reconstruction", tr("With the s&kin model"),
                 tr("What the model makes of the skin without edits"), QKeySequence(tr("Ctrl+6"))),
      partnerRow(editor, Partner::edited, "edited", tr("With the &edited albedo"),
                 tr("What an export writes"), QKeySequence(tr("Ctrl+7"))),
      partnerRow(editor, Partner::kept, "kept", tr("With the &kept edits"),
                 tr("The same view, with the edits that were kept"), QKeySequence(tr("Ctrl+8"))),
  };
  rows.front().beginsSection = true;
  rows.back().objection = [editor] {
    if (!editor.document().isOpen()) return unlessSomethingOpen(editor);
    return editor.page().comparison().hasKeptEdits()
               ? QString()
               : tr("No edits have been kept yet; “Keep the edits to compare with” does it");
  };
  CommandDescription keep =
      rowOf(editor, "keep", tr("Kee&p the edits to compare with"),
            tr("The edits as they are now can be compared with later ones"), Qt::Key_K);
  keep.run = [editor] { editor.page().comparison().keepEdits(); };
  rows.push_back(keep);
  CommandDescription copy =
      rowOf(editor, "copy", tr("Copy the p&icture"),
            tr("What is seen of it, with what lies over it, for the clipboard"),
            QKeySequence(tr("Ctrl+Alt+G")));
  copy.run = [editor] {
    QGuiApplication::clipboard()->setImage(editor.page().viewport().picture());
  };
  copy.beginsSection = true;
  rows.push_back(copy);
  return rows;
}

}  // namespace

std::vector<CommandDescription> compareCommands(const Editor& editor) {
  CompareRows all = modeRows(editor);
  for (CommandDescription& row : partnerRows(editor))
    all.push_back(std::move(row));
  return all;
}

}  // namespace cutis
