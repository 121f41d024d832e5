#include "ui/window/dock_catalogue.h"

#include <QCoreApplication>

#include "ui/commands/command_registry.h"
#include "ui/docks/edit_controller.h"
#include "ui/docks/edit_panel.h"
#include "ui/docks/fit_controller.h"
#include "ui/docks/fit_panel.h"
#include "ui/docks/history_controller.h"
#include "ui/docks/history_panel.h"
#include "ui/docks/info_controller.h"
#include "ui/docks/info_panel.h"
#include "ui/docks/light_catalogue.h"
#include "ui/docks/light_controller.h"
#include "ui/docks/light_panel.h"
#include "ui/docks/spectrum_controller.h"
#include "ui/docks/workspace.h"
#include "ui/plot/spectrum_plot.h"
#include "ui/view/view_controller.h"
#include "ui/view/view_strip.h"
#include "ui/widgets/panel_scroll.h"

namespace cutis {
namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("DockCatalogue", text);
}

QWidget* makeViews(const Editor& editor) {
  auto* strip = new ViewStrip;
  editor.views.attach(*strip);
  return strip;
}

QWidget* makeSpectrum(const Editor& editor) {
  auto* plot = new SpectrumPlot;
  new SpectrumController(editor.document, editor.viewport, *plot, editor.progress, plot);
  return plot;
}

QWidget* makeEdit(const Editor& editor) {
  auto* panel = new EditPanel;
  editor.edits.attach(*panel);
  return new PanelScroll(panel);
}

QWidget* makeHistory(const Editor& editor) {
  auto* panel = new HistoryPanel;
  new HistoryController(editor.document, *panel, panel);
  return panel;
}

QWidget* makeInfo(const Editor& editor) {
  auto* panel = new InfoPanel;
  new InfoController(editor.document, editor.server, editor.exports, *panel, panel);
  return panel;
}

QWidget* makeLight(const Editor& editor) {
  auto* panel = new LightPanel;
  panel->setLights(lightGroups());
  panel->setObservers(observerChoices());
  editor.light.attach(*panel);
  return new PanelScroll(panel);
}

QWidget* makeFit(const Editor& editor) {
  auto* panel = new FitPanel;
  editor.fit.attach(*panel);
  CommandRegistry& commands = editor.commands;
  QObject::connect(panel, &FitPanel::loadWanted, panel,
                   [&commands] { commands.run("fit.loadProfile"); });
  QObject::connect(panel, &FitPanel::trainingWanted, panel,
                   [&commands] { commands.run("fit.train"); });
  auto* scroll = new PanelScroll(panel);
  // The offer must be seen. It has its place after the next layout.
  QObject::connect(
      panel, &FitPanel::trainingOffered, scroll,
      [scroll, panel, &workspace = editor.workspace] {
        workspace.present("fit");
        scroll->ensureVisible(0, panel->height());
      },
      Qt::QueuedConnection);
  return scroll;
}

}  // namespace

std::vector<DockDescription> dockCatalogue(const Editor& editor) {
  return {
      {.id = "views",
       .title = tr("&Views"),
       .area = Qt::LeftDockWidgetArea,
       .shortcut = Qt::Key_F5,
       .extent = 152,
       .makePanel = [=] { return makeViews(editor); },
       .seen = [&views = editor.views](QWidget&, bool seen) { views.setStripSeen(seen); }},
      {.id = "edit",
       .title = tr("&Edit"),
       .shortcut = Qt::Key_F6,
       .makePanel = [=] { return makeEdit(editor); }},
      {.id = "light",
       .title = tr("&Light"),
       .shortcut = Qt::Key_F7,
       .makePanel = [=] { return makeLight(editor); }},
      {.id = "fit",
       .title = tr("&Fit"),
       .shortcut = Qt::Key_F8,
       .makePanel = [=] { return makeFit(editor); }},
      {.id = "history",
       .title = tr("&History"),
       .shortcut = QKeySequence(tr("Ctrl+H")),
       .shownAtFirst = false,
       .makePanel = [=] { return makeHistory(editor); }},
      {.id = "info",
       .title = tr("&Info"),
       .shortcut = QKeySequence(tr("Ctrl+I")),
       .shownAtFirst = false,
       .makePanel = [=] { return makeInfo(editor); }},
      {.id = "spectrum",
       .title = tr("&Spectrum"),
       .area = Qt::BottomDockWidgetArea,
       .shortcut = Qt::Key_F9,
       .extent = 240,
       .makePanel = [=] { return makeSpectrum(editor); },
       .seen = [](QWidget& plot,
                  bool seen) { plot.findChild<SpectrumController*>()->setSeen(seen); }},
  };
}

}  // namespace cutis
