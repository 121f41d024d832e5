#include "ui/window/document_page.h"

#include <QVBoxLayout>

#include "ui/commands/context_menu.h"
#include "ui/dialogs/export_controller.h"
#include "ui/dialogs/training_controller.h"
#include "ui/docks/edit_controller.h"
#include "ui/docks/fit_controller.h"
#include "ui/docks/light_controller.h"
#include "ui/docks/preset_controller.h"
#include "ui/docks/workspace.h"
#include "ui/view/view_controller.h"
#include "ui/view/viewport.h"
#include "ui/window/dock_catalogue.h"

namespace cutis {

DocumentPage::DocumentPage(Engine& engine, ProgressStrip& progress, CommandRegistry& commands,
                           QWidget* parent)
    : QWidget(parent),
      document_(std::make_unique<Document>(engine, jobs_)),
      server_(std::make_unique<ViewServer>(*document_, engine, jobs_)),
      viewport_(new Viewport(this)),
      workspace_(new Workspace(viewport_, this)),
      views_(std::make_unique<ViewController>(*document_, *server_, *viewport_)),
      edits_(std::make_unique<EditController>(*document_, *views_)),
      presets_(std::make_unique<PresetController>(*document_, *views_, progress, this)),
      light_(std::make_unique<LightController>(*server_, *views_)),
      fit_(std::make_unique<FitController>(*document_)),
      training_(std::make_unique<TrainingController>(*document_, engine, jobs_, this)),
      exports_(std::make_unique<ExportController>(*document_, engine, jobs_, progress, this)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(workspace_);
  workspace_->add(dockCatalogue(*this, progress, commands));
  giveContextMenu(
      *viewport_, commands,
      {"view.wholePicture", "view.oneToOne", "view.zoomIn", "view.zoomOut", "", "view.photograph",
       "view.albedo", "view.skin", "", "edit.copyEdits", "edit.pasteEdits", "", "file.export"});
}

DocumentPage::~DocumentPage() {
  jobs_.stopAll();
  // Docks that go out of sight say so: while those they say it to are still there.
  hide();
}

void DocumentPage::open(const std::filesystem::path& path, const OpenChoice& choice) {
  wanted_ = path;
  if (path.empty()) {
    document_->openSample();
  } else {
    document_->open(path, choice);
  }
}

bool DocumentPage::isFor(const std::filesystem::path& path) const {
  return wanted_ == path && !isBlank();
}

bool DocumentPage::isIdle() const {
  return !jobs_.isBusy() && jobs_.isIdle() && server_->isIdle();
}

void DocumentPage::closeDialogs() {
  training_->stop();
}

}  // namespace cutis
