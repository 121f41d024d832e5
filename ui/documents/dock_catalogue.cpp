#include "ui/documents/dock_catalogue.h"

#include <QCoreApplication>

#include "ui/commands/command_registry.h"
#include "ui/commands/context_menu.h"
#include "ui/dialogs/export_controller.h"
#include "ui/docks/edit_controller.h"
#include "ui/docks/edit_panel.h"
#include "ui/docks/fit_controller.h"
#include "ui/docks/fit_panel.h"
#include "ui/docks/info_controller.h"
#include "ui/docks/info_panel.h"
#include "ui/docks/light_catalogue.h"
#include "ui/docks/light_controller.h"
#include "ui/docks/light_panel.h"
#include "ui/docks/workspace.h"
#include "ui/documents/document_page.h"
#include "ui/edits/history_controller.h"
#include "ui/edits/history_panel.h"
#include "ui/edits/preset_catalogue.h"
#include "ui/inspector/distribution_controller.h"
#include "ui/inspector/distribution_panel.h"
#include "ui/inspector/inspector_controller.h"
#include "ui/inspector/inspector_panel.h"
#include "ui/plot/spectrum_plot.h"
#include "ui/spectrum/pin_controller.h"
#include "ui/spectrum/pin_table.h"
#include "ui/spectrum/reference_curves.h"
#include "ui/spectrum/spectrum_controller.h"
#include "ui/spectrum/spectrum_export.h"
#include "ui/spectrum/spectrum_panel.h"
#include "ui/view/view_controller.h"
#include "ui/view/view_strip.h"
#include "ui/widgets/panel_scroll.h"

namespace cutis {
namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("DockCatalogue", text);
}

QWidget* makeViews(DocumentPage& page, CommandRegistry& commands) {
  auto* strip = new ViewStrip;
  giveContextMenu(*strip, commands,
                  {"view.wholePicture", "view.oneToOne", "", "file.export", "", "dock.views"});
  page.views().attach(*strip);
  return strip;
}

QWidget* makeSpectrum(DocumentPage& page, CommandRegistry& commands) {
  auto* panel = new SpectrumPanel;
  const QStringList exports = {"spectrum.copyCurves",
                               "spectrum.copyFigure",
                               "spectrum.saveFigure",
                               "",
                               "spectrum.copyPins",
                               "spectrum.savePins",
                               "",
                               "spectrum.copyMethods"};
  panel->setExports(commandMenu(*panel, commands, exports));
  giveContextMenu(panel->plot(), commands,
                  exports + QStringList{"", "spectrum.addReference", "spectrum.removeReferences",
                                        "", "dock.spectrum"});
  giveContextMenu(panel->table(), commands,
                  {"spectrum.referencePin", "spectrum.renamePin", "spectrum.deletePin", "",
                   "spectrum.copyPins", "spectrum.savePins"});
  page.spectrumExport().attach(*panel);
  page.references().attach(*panel);
  page.spectrum().attach(*panel);
  page.pins().attach(*panel);
  return panel;
}

QWidget* makeEdit(DocumentPage& page, CommandRegistry& commands) {
  auto* panel = new EditPanel;
  QStringList presets;
  for (const PresetDescription& preset : presetCatalogue())
    presets << "edit.preset." + preset.id;
  panel->setPresets(commandMenu(*panel, commands,
                                presets + QStringList{"", "edit.loadPreset", "edit.savePreset"}));
  page.edits().attach(*panel);
  return new PanelScroll(panel);
}

QWidget* makeHistory(DocumentPage& page) {
  auto* panel = new HistoryPanel;
  new HistoryController(page.document(), *panel, panel);
  return panel;
}

QWidget* makeInfo(DocumentPage& page) {
  auto* panel = new InfoPanel;
  auto* controller = new InfoController(page.document(), page.server(), *panel, panel);
  QObject::connect(&page.exports(), &ExportController::noticed, controller, &InfoController::add);
  return panel;
}

QWidget* makeLight(DocumentPage& page) {
  auto* panel = new LightPanel;
  panel->setLights(lightGroups());
  panel->setObservers(observerChoices());
  page.light().attach(*panel);
  return new PanelScroll(panel);
}

QWidget* makeFit(DocumentPage& page, CommandRegistry& commands) {
  auto* panel = new FitPanel;
  page.fit().attach(*panel);
  QObject::connect(panel, &FitPanel::loadWanted, panel,
                   [&commands] { commands.run("fit.loadProfile"); });
  QObject::connect(panel, &FitPanel::optionsWanted, panel,
                   [&commands] { commands.run("fit.options"); });
  QObject::connect(panel, &FitPanel::trainingWanted, panel,
                   [&commands] { commands.run("fit.train"); });
  auto* scroll = new PanelScroll(panel);
  // The offer must be seen. It has its place after the next layout.
  QObject::connect(
      panel, &FitPanel::trainingOffered, scroll,
      [scroll, panel, &workspace = page.workspace()] {
        workspace.present("fit");
        scroll->ensureVisible(0, panel->height());
      },
      Qt::QueuedConnection);
  return scroll;
}

}  // namespace

std::vector<DockDescription> dockCatalogue(DocumentPage& page, CommandRegistry& commands) {
  return {
      {.id = "views",
       .title = tr("&Views"),
       .area = Qt::LeftDockWidgetArea,
       .shortcut = Qt::Key_F5,
       .extent = 152,
       .makePanel = [&page, &commands] { return makeViews(page, commands); },
       .seen = [&views = page.views()](QWidget&, bool seen) { views.setStripSeen(seen); }},
      {.id = "edit",
       .title = tr("&Edit"),
       .shortcut = Qt::Key_F6,
       .makePanel = [&page, &commands] { return makeEdit(page, commands); }},
      {.id = "light",
       .title = tr("&Light"),
       .shortcut = Qt::Key_F7,
       .makePanel = [&page] { return makeLight(page); }},
      {.id = "fit",
       .title = tr("&Fit"),
       .shortcut = Qt::Key_F8,
       .makePanel = [&page, &commands] { return makeFit(page, commands); }},
      {.id = "history",
       .title = tr("&History"),
       .shortcut = QKeySequence(tr("Ctrl+H")),
       .shownAtFirst = false,
       .makePanel = [&page] { return makeHistory(page); }},
      {.id = "info",
       .title = tr("&Info"),
       .shortcut = QKeySequence(tr("Ctrl+I")),
       .shownAtFirst = false,
       .behind = "history",
       .makePanel = [&page] { return makeInfo(page); }},
      {.id = "inspector",
       .title = tr("I&nspector"),
       .shortcut = QKeySequence(tr("Ctrl+Shift+I")),
       .shownAtFirst = false,
       .behind = "history",
       .makePanel =
           [&page] {
             auto* panel = new InspectorPanel;
             page.inspector().attach(*panel);
             return panel;
           },
       .seen = [&page](QWidget&, bool seen) { page.inspector().setSeen(seen); }},
      {.id = "distribution",
       .title = tr("&Distribution"),
       .shortcut = QKeySequence(tr("Ctrl+D")),
       .shownAtFirst = false,
       .behind = "history",
       .makePanel =
           [&page] {
             auto* panel = new DistributionPanel;
             page.distributions().attach(*panel);
             return panel;
           },
       .seen = [&page](QWidget&, bool seen) { page.distributions().setSeen(seen); }},
      {.id = "spectrum",
       .title = tr("&Spectrum"),
       .area = Qt::BottomDockWidgetArea,
       .shortcut = Qt::Key_F9,
       .extent = 240,
       .makePanel = [&page, &commands] { return makeSpectrum(page, commands); },
       .seen =
           [&page](QWidget&, bool seen) {
             page.spectrum().setSeen(seen);
             page.pins().setSeen(seen);
           }},
  };
}

}  // namespace cutis
