#include "ui/documents/document_page.h"

#include <utility>

#include <QFileInfo>
#include <QVBoxLayout>

#include "src/app/document/autosave.h"
#include "ui/commands/context_menu.h"
#include "ui/compare/comparison_controller.h"
#include "ui/dialogs/export_controller.h"
#include "ui/dialogs/reopen_controller.h"
#include "ui/dialogs/save_controller.h"
#include "ui/dialogs/training_controller.h"
#include "ui/docks/edit_controller.h"
#include "ui/docks/fit_controller.h"
#include "ui/docks/light_controller.h"
#include "ui/docks/workspace.h"
#include "ui/documents/dock_catalogue.h"
#include "ui/documents/project_view.h"
#include "ui/edits/preset_controller.h"
#include "ui/inspector/distribution_controller.h"
#include "ui/inspector/inspector_controller.h"
#include "ui/spectrum/pin_controller.h"
#include "ui/spectrum/reference_curves.h"
#include "ui/spectrum/spectrum_controller.h"
#include "ui/spectrum/spectrum_export.h"
#include "ui/view/view_controller.h"
#include "ui/view/viewport.h"
#include "ui/widgets/notice_bar.h"
#include "ui/widgets/progress_strip.h"

namespace cutis {

DocumentPage::DocumentPage(Engine& engine, ProgressStrip& progress, CommandRegistry& commands,
                           QWidget* parent)
    : QWidget(parent),
      progress_(progress),
      document_(std::make_unique<Document>(engine, jobs_)),
      server_(std::make_unique<ViewServer>(*document_, engine, jobs_)),
      viewport_(new Viewport(this)),
      workspace_(new Workspace(viewport_, this)),
      notice_(new NoticeBar(this)),
      views_(std::make_unique<ViewController>(*document_, *server_, *viewport_)),
      comparison_(
          std::make_unique<ComparisonController>(*document_, jobs_, *server_, *views_, *viewport_)),
      edits_(std::make_unique<EditController>(*document_, *views_)),
      presets_(std::make_unique<PresetController>(*document_, *views_, progress, this)),
      distributions_(std::make_unique<DistributionController>(*document_, jobs_, *server_, *views_,
                                                              *viewport_)),
      inspector_(std::make_unique<InspectorController>(*document_, jobs_, *views_, *viewport_)),
      light_(std::make_unique<LightController>(*server_, *views_)),
      spectrum_(std::make_unique<SpectrumController>(*document_, jobs_, *viewport_, progress)),
      pins_(std::make_unique<PinController>(*document_, jobs_, *viewport_, progress, this)),
      spectrumExport_(std::make_unique<SpectrumExport>(*document_, jobs_, *pins_, progress, this)),
      references_(std::make_unique<ReferenceCurves>(jobs_, progress, this)),
      fit_(std::make_unique<FitController>(*document_)),
      training_(std::make_unique<TrainingController>(*document_, engine, jobs_, this)),
      exports_(std::make_unique<ExportController>(*document_, engine, jobs_, progress, this)),
      saves_(std::make_unique<SaveController>(
          *document_, progress, [this] { return projectViewOf(*this); }, this)),
      reopening_(std::make_unique<ReopenController>(*document_, jobs_, progress, *notice_, this)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(notice_);
  column->addWidget(workspace_, 1);
  workspace_->add(dockCatalogue(*this, commands));
  connect(document_.get(), &Document::opened, this,
          [this] { showProjectView(*this, document_->view()); });
  // What is read again is shown as it is looked at now.
  connect(document_.get(), &Document::openingStarted, this, [this] {
    if (document_->isOpen()) document_->setView(projectViewOf(*this));
  });
  connectSource();
  giveContextMenu(*viewport_, commands,
                  {"view.wholePicture",
                   "view.oneToOne",
                   "view.zoomIn",
                   "view.zoomOut",
                   "",
                   "view.photograph",
                   "view.albedo",
                   "view.skin",
                   "",
                   "view.logarithmic",
                   "view.automaticRange",
                   "",
                   "hatch.notSkin",
                   "hatch.atBound",
                   "hatch.assumed",
                   "",
                   "compare.wipe",
                   "compare.sideBySide",
                   "compare.difference",
                   "compare.copy",
                   "",
                   "edit.copyEdits",
                   "edit.pasteEdits",
                   "",
                   "spectrum.referencePin",
                   "spectrum.renamePin",
                   "spectrum.deletePin",
                   "",
                   "file.export"});
}

DocumentPage::~DocumentPage() {
  jobs_.stopAll();
  // The last state of what is not saved is that of the document.
  autosave_.reset();
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

void DocumentPage::recover(const Project& project, const std::shared_ptr<Journal>& journal) {
  keepJournal(journal);
  document_->recover(project);
}

void DocumentPage::openRelinked(const MissingSource& missing, const std::filesystem::path& found,
                                bool whateverItHolds, const std::shared_ptr<Journal>& journal) {
  if (journal != nullptr) keepJournal(journal);
  wanted_ = missing.path;
  document_->openRelinked(missing, found, whateverItHolds);
}

bool DocumentPage::isFor(const std::filesystem::path& path) const {
  if (isBlank()) return false;
  return document_->projectPath().empty() ? wanted_ == path : document_->projectPath() == path;
}

bool DocumentPage::isWriting() const {
  return document_->isSaving() || exports_->isExporting();
}

std::size_t DocumentPage::lostWrites() const {
  return saves_->lostCount() + exports_->lostCount();
}

void DocumentPage::stopWriting() {
  document_->stopSaving();
  exports_->stop();
}

void DocumentPage::keepJournal(std::shared_ptr<Journal> journal) {
  journal_ = std::move(journal);
  autosave_ = std::make_unique<Autosave>(*document_, jobs_, journal_);
  connect(autosave_.get(), &Autosave::failed, this,
          [this](const QString& sentence) { progress_.showMessage(sentence, true); });
}

void DocumentPage::discardEdits() {
  if (autosave_) autosave_->discard();
}

// Another program has written a file that this was made of.
void DocumentPage::connectSource() {
  connect(document_.get(), &Document::sourceChanged, this, [this](const QStringList& files) {
    const QString name = QFileInfo(files.first()).fileName();
    notice_->ask(
        files.size() == 1
            ? tr("%1 has changed on disk. Reloaded, it is fitted again and keeps the edits.")
                  .arg(name)
            : tr("%1 and %2 more have changed on disk. Reloaded, it is fitted again and "
                 "keeps the edits.")
                  .arg(name)
                  .arg(files.size() - 1),
        tr("Reload"), tr("Keep"), [this] { document_->reload(); });
  });
}

bool DocumentPage::isIdle() const {
  return !jobs_.isBusy() && jobs_.isIdle() && server_->isIdle();
}

void DocumentPage::closeDialogs() {
  training_->stop();
}

}  // namespace cutis
