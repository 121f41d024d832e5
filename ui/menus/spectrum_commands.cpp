#include "ui/menus/spectrum_commands.h"

#include <QCoreApplication>

#include "ui/spectrum/pin_controller.h"
#include "ui/spectrum/reference_curves.h"
#include "ui/spectrum/spectrum_export.h"

namespace cutis {
namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("SpectrumCommands", text);
}

}  // namespace

std::vector<CommandDescription> spectrumCommands(const Editor& editor) {
  const auto noCurves = [editor] { return editor.page().spectrumExport().objectionToCurves(); };
  const auto noPins = [editor] { return editor.page().spectrumExport().objectionToPins(); };
  const auto noMethods = [editor] { return editor.page().spectrumExport().objectionToMethods(); };
  return {
      {.id = "spectrum.copyCurves",
       .menu = Menu::edit,
       .submenu = tr("&Spectra"),
       .text = tr("&Copy curves as text"),
       .toolTip = tr("A table for spreadsheets"),
       .shortcuts = {QKeySequence(tr("Ctrl+Alt+C"))},
       .run = [editor] { editor.page().spectrumExport().copyCurves(); },
       .objection = noCurves},
      {.id = "spectrum.copyFigure",
       .menu = Menu::edit,
       .submenu = tr("&Spectra"),
       .text = tr("Copy f&igure"),
       .toolTip = tr("As a picture, with the caption of a paper"),
       .shortcuts = {QKeySequence(tr("Ctrl+Alt+F"))},
       .run = [editor] { editor.page().spectrumExport().copyFigure(); },
       .objection = noCurves},
      {.id = "spectrum.saveFigure",
       .menu = Menu::edit,
       .submenu = tr("&Spectra"),
       .text = tr("&Save figure or curves…"),
       .toolTip = tr("PDF, SVG or PNG, fit for a paper; or the curves as CSV"),
       .shortcuts = {QKeySequence(tr("Ctrl+Alt+P"))},
       .run = [editor] { editor.page().spectrumExport().saveFigure(); },
       .objection = noCurves},
      {.id = "spectrum.copyMethods",
       .menu = Menu::edit,
       .submenu = tr("&Spectra"),
       .text = tr("Copy &methods text"),
       .toolTip = tr("A paragraph for a paper: profile, rig, noise, prior, method, version"),
       .shortcuts = {QKeySequence(tr("Ctrl+Alt+M"))},
       .run = [editor] { editor.page().spectrumExport().copyMethods(); },
       .objection = noMethods},
      {.id = "spectrum.addReference",
       .menu = Menu::edit,
       .submenu = tr("&Spectra"),
       .text = tr("Add refere&nce spectra…"),
       .toolTip = tr("Measured spectra from a file, drawn beside those of the picture"),
       .shortcuts = {QKeySequence(tr("Ctrl+Alt+N"))},
       .beginsSection = true,
       .run = [editor] { editor.page().references().choose(); },
       .objection = noMethods},
      {.id = "spectrum.removeReferences",
       .menu = Menu::edit,
       .submenu = tr("&Spectra"),
       .text = tr("Rem&ove reference spectra"),
       .shortcuts = {QKeySequence(tr("Ctrl+Alt+X"))},
       .run = [editor] { editor.page().references().removeAll(); },
       .objection = [editor] { return editor.page().references().objectionToRemoving(); }},
      {.id = "spectrum.copyPins",
       .menu = Menu::edit,
       .submenu = tr("&Spectra"),
       .text = tr("Copy &table of pins"),
       .toolTip = tr("As text with tabs, for spreadsheets"),
       .shortcuts = {QKeySequence(tr("Ctrl+Alt+B"))},
       .beginsSection = true,
       .run = [editor] { editor.page().spectrumExport().copyPins(); },
       .objection = noPins},
      {.id = "spectrum.savePins",
       .menu = Menu::edit,
       .submenu = tr("&Spectra"),
       .text = tr("Sa&ve table of pins…"),
       .toolTip = tr("As CSV"),
       .shortcuts = {QKeySequence(tr("Ctrl+Alt+V"))},
       .run = [editor] { editor.page().spectrumExport().savePins(); },
       .objection = noPins},
      {.id = "spectrum.referencePin",
       .menu = Menu::edit,
       .submenu = tr("&Spectra"),
       .text = tr("Re&ference pin"),
       .toolTip = tr("Colours of the other pins are compared with this one, ΔE2000"),
       .shortcuts = {QKeySequence(tr("Ctrl+Alt+R"))},
       .beginsSection = true,
       .run = [editor] { editor.page().pins().toggleReference(); },
       .objection = [editor] { return editor.page().pins().objectionToOne(); },
       .isOn = [editor] { return editor.page().pins().isReference(); }},
      {.id = "spectrum.renamePin",
       .menu = Menu::edit,
       .submenu = tr("&Spectra"),
       .text = tr("&Rename pin…"),
       .shortcuts = {QKeySequence(tr("Ctrl+Shift+R"))},
       .run = [editor] { editor.page().pins().rename(); },
       .objection = [editor] { return editor.page().pins().objectionToOne(); }},
      {.id = "spectrum.deletePin",
       .menu = Menu::edit,
       .submenu = tr("&Spectra"),
       .text = tr("&Delete pin"),
       .shortcuts = {Qt::Key_Delete},
       .run = [editor] { editor.page().pins().removeSelected(); },
       .objection = [editor] { return editor.page().pins().objectionToOne(); }},
      {.id = "spectrum.deleteAllPins",
       .menu = Menu::edit,
       .submenu = tr("&Spectra"),
       .text = tr("Delete &all pins"),
       .shortcuts = {QKeySequence(tr("Ctrl+Del"))},
       .run = [editor] { editor.page().pins().removeAll(); },
       .objection = [editor] { return editor.page().pins().objectionToAll(); }},
  };
}

}  // namespace cutis
