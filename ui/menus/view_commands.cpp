#include "ui/menus/view_commands.h"

#include <algorithm>
#include <utility>

#include <QCoreApplication>

#include "src/app/document/document.h"
#include "ui/view/view_catalogue.h"
#include "ui/view/view_controller.h"

namespace cutis {
namespace {

using ViewRows = std::vector<CommandDescription>;

constexpr double kExposureStep = 0.25;  // stops

QString tr(const char* text) {
  return QCoreApplication::translate("ViewCommands", text);
}

QString nothingOpen(const Editor& editor) {
  return editor.document().isOpen() ? QString() : tr("Nothing is open yet");
}

QString unlessMap(const Editor& editor) {
  if (!editor.document().isOpen()) return nothingOpen(editor);
  return editor.page().views().canBeLogarithmic()
             ? QString()
             : tr("Only a map that has been fitted has a range of its own; choose one on the left");
}

QString unlessEvidence(const Editor& editor) {
  if (!editor.document().isOpen()) return nothingOpen(editor);
  return editor.document().scene().evidence != nullptr
             ? QString()
             : tr("Only maps whose photographs are open and fitted can be judged");
}

// One for each view of the catalogue; those that every document has are in the menu itself.
ViewRows catalogueCommands(const Editor& editor) {
  ViewRows rows;
  for (const ViewDescription& view : viewCatalogue()) {
    rows.push_back(
        {.id = "view." + view.id,
         .menu = Menu::view,
         .submenu = view.isUsual ? QString() : tr("More &views"),
         .text = view.name,
         .toolTip = view.toolTip,
         .shortcuts = {QKeySequence(view.shortcut)},
         .beginsSection = rows.empty(),
         .run = [editor, kind = view.kind] { editor.page().views().show(kind); },
         .objection =
             [editor, kind = view.kind] {
               if (!editor.document().isOpen()) return nothingOpen(editor);
               return viewObjection(kind, editor.document().scene());
             },
         .textNow = [editor, kind = view.kind] { return viewName(kind, editor.document()); },
         .isOn =
             [editor, kind = view.kind] {
               return editor.document().isOpen() && editor.page().views().current() == kind;
             },
         .exclusiveGroup = "views"});
  }
  return rows;
}

// Of the false colours of the map in front.
ViewRows rangeCommands(const Editor& editor) {
  return {
      {.id = "view.logarithmic",
       .menu = Menu::view,
       .text = tr("&Logarithmic scale"),
       .toolTip = tr("Small amounts are told apart as well as large ones"),
       .shortcuts = {QKeySequence(tr("Ctrl+L"))},
       .beginsSection = true,
       .run =
           [editor] {
             ViewController& views = editor.page().views();
             views.setLogarithmic(!views.isLogarithmic());
           },
       .objection = [editor] { return unlessMap(editor); },
       .isOn =
           [editor] {
             return editor.document().isOpen() && editor.page().views().isLogarithmic();
           }},
      {.id = "view.automaticRange",
       .menu = Menu::view,
       .text = tr("&Automatic range"),
       .toolTip =
           tr("The colours of the map reach over what is skin, from the 1st to the 99th of a "
              "hundred pixels"),
       .shortcuts = {QKeySequence(tr("Ctrl+Shift+A"))},
       .run = [editor] { editor.page().views().makeRangeAutomatic(); },
       .objection = [editor] { return unlessMap(editor); },
       .isOn =
           [editor] {
             return editor.document().isOpen() && editor.page().views().isRangeAutomatic();
           }},
  };
}

// Of what is seen; exports do not know of it.
ViewRows adjustmentCommands(const Editor& editor) {
  const auto expose = [editor](double stops) {
    ViewController& views = editor.page().views();
    ViewAdjustment adjustment = views.adjustment();
    adjustment.stops = std::clamp(adjustment.stops + stops, -ViewAdjustment::kMostStops,
                                  ViewAdjustment::kMostStops);
    views.setAdjustment(adjustment);
  };
  const auto objection = [editor] { return nothingOpen(editor); };
  return {
      {.id = "view.brighter",
       .menu = Menu::view,
       .submenu = tr("&Exposure of the view"),
       .text = tr("&Brighter"),
       .toolTip = tr("A quarter of a stop; it changes what you see, not what is exported"),
       .shortcuts = {QKeySequence(tr("Ctrl+Up"))},
       .run = [expose] { expose(kExposureStep); },
       .objection = objection},
      {.id = "view.darker",
       .menu = Menu::view,
       .submenu = tr("&Exposure of the view"),
       .text = tr("&Darker"),
       .toolTip = tr("A quarter of a stop; it changes what you see, not what is exported"),
       .shortcuts = {QKeySequence(tr("Ctrl+Down"))},
       .run = [expose] { expose(-kExposureStep); },
       .objection = objection},
      {.id = "view.neutral",
       .menu = Menu::view,
       .submenu = tr("&Exposure of the view"),
       .text = tr("&Reset"),
       .toolTip = tr("Back to exposure 0 and gamma 1"),
       .shortcuts = {QKeySequence(tr("Ctrl+0"))},
       .run = [editor] { editor.page().views().setAdjustment({}); },
       .objection = objection},
  };
}

CommandDescription hatchCommand(const Editor& editor, PixelMark mark, const QString& id,
                                const QString& text, const QString& toolTip,
                                const QString& shortcut) {
  return {.id = "hatch." + id,
          .menu = Menu::view,
          .submenu = tr("&Hatching"),
          .text = text,
          .toolTip = toolTip,
          .shortcuts = {QKeySequence(shortcut)},
          .run =
              [editor, mark] {
                ViewController& views = editor.page().views();
                views.setMarked(mark, !views.isMarked(mark));
              },
          .objection = [editor] { return unlessEvidence(editor); },
          .isOn = [editor, mark] { return editor.page().views().isMarked(mark); }};
}

ViewRows hatchCommands(const Editor& editor) {
  return {
      hatchCommand(editor, kNotSkin, "notSkin", tr("&Not like skin"),
                   tr("Pixels that no skin of the profile looks like"), tr("Ctrl+1")),
      hatchCommand(editor, kAtBound, "atBound", tr("At the &end of its range"),
                   tr("Pixels whose value would lie beyond its range if it could"), tr("Ctrl+2")),
      hatchCommand(editor, kMostlyPrior, "assumed", tr("&Assumed rather than measured"),
                   tr("Pixels whose uncertainty is above half of what it was before measuring"),
                   tr("Ctrl+3")),
  };
}

}  // namespace

std::vector<CommandDescription> viewCommands(const Editor& editor) {
  ViewRows all;
  for (const auto& part : {catalogueCommands, rangeCommands, adjustmentCommands, hatchCommands}) {
    for (CommandDescription& row : part(editor))
      all.push_back(std::move(row));
  }
  return all;
}

}  // namespace cutis
