#pragma once

// What the window has of one document: the document itself, its picture, its docks and all that
// works for it. A page that nothing was opened in yet is blank. Interface thread only.

#include <filesystem>
#include <memory>
#include <optional>

#include <QWidget>

#include "src/app/document/document.h"
#include "src/app/engine.h"
#include "src/app/job_runner.h"
#include "src/app/project/journal.h"
#include "src/app/views/view_server.h"

namespace cutis {

class Autosave;
class CommandRegistry;
class ComparisonController;
class DistributionController;
class EditController;
class ExportController;
class FitController;
class InspectorController;
class LightController;
class NoticeBar;
class PinController;
class PresetController;
class ProgressStrip;
class ReferenceCurves;
class ReopenController;
class SaveController;
class SpectrumController;
class SpectrumExport;
class TrainingController;
class ViewController;
class Viewport;
class Workspace;

class DocumentPage : public QWidget {
  Q_OBJECT

 public:
  // All outlive the page. The strip shows the read-out under the cursor and what controllers have
  // to say.
  DocumentPage(Engine& engine, ProgressStrip& progress, CommandRegistry& commands,
               QWidget* parent = nullptr);
  // Stops what the page has under way and waits for it.
  ~DocumentPage() override;

  // Opens a file, or the embedded sample where the path is empty.
  void open(const std::filesystem::path& path, const OpenChoice& choice);
  // What a journal kept; the journal is the page's from now on.
  void recover(const Project& project, const std::shared_ptr<Journal>& journal);
  // As Document::openRelinked(); with the journal where one kept it.
  void openRelinked(const MissingSource& missing, const std::filesystem::path& found,
                    bool whateverItHolds, const std::shared_ptr<Journal>& journal);
  // What was last opened or saved here, or is on its way, is this.
  bool isFor(const std::filesystem::path& path) const;

  // Nothing of it is being read, fitted, drawn or written.
  bool isIdle() const;
  // A file of it is being written, which ends with the page.
  bool isWriting() const;
  void stopWriting();
  // How many files have not been written, so far, for an error or because somebody stopped it.
  std::size_t lostWrites() const;
  // Nothing is open or on its way.
  bool isBlank() const { return !document_->isOpen() && jobs_.isIdle(); }
  // From now on unsaved edits are written down there. Until then, and while it is null, nowhere.
  void keepJournal(std::shared_ptr<Journal> journal);
  std::shared_ptr<Journal> journal() const { return journal_; }
  // The edits are given up.
  void discardEdits();
  // Closes what stands before the window because of the page.
  void closeDialogs();

  JobRunner& jobs() { return jobs_; }
  Document& document() { return *document_; }
  ViewServer& server() { return *server_; }
  Viewport& viewport() { return *viewport_; }
  Workspace& workspace() { return *workspace_; }
  ViewController& views() { return *views_; }
  ComparisonController& comparison() { return *comparison_; }
  EditController& edits() { return *edits_; }
  PresetController& presets() { return *presets_; }
  DistributionController& distributions() { return *distributions_; }
  InspectorController& inspector() { return *inspector_; }
  LightController& light() { return *light_; }
  SpectrumController& spectrum() { return *spectrum_; }
  PinController& pins() { return *pins_; }
  SpectrumExport& spectrumExport() { return *spectrumExport_; }
  ReferenceCurves& references() { return *references_; }
  FitController& fit() { return *fit_; }
  TrainingController& training() { return *training_; }
  ExportController& exports() { return *exports_; }
  SaveController& saves() { return *saves_; }
  ReopenController& reopening() { return *reopening_; }
  NoticeBar& notice() { return *notice_; }

 private:
  void connectSource();

  ProgressStrip& progress_;
  JobRunner jobs_;
  std::optional<std::filesystem::path> wanted_;
  std::unique_ptr<Document> document_;
  std::unique_ptr<ViewServer> server_;
  Viewport* viewport_;
  Workspace* workspace_;
  NoticeBar* notice_;
  // They go before what they work on.
  std::unique_ptr<ViewController> views_;
  std::unique_ptr<ComparisonController> comparison_;
  std::unique_ptr<EditController> edits_;
  std::unique_ptr<PresetController> presets_;
  std::unique_ptr<DistributionController> distributions_;
  std::unique_ptr<InspectorController> inspector_;
  std::unique_ptr<LightController> light_;
  std::unique_ptr<SpectrumController> spectrum_;
  std::unique_ptr<PinController> pins_;
  std::unique_ptr<SpectrumExport> spectrumExport_;
  std::unique_ptr<ReferenceCurves> references_;
  std::unique_ptr<FitController> fit_;
  std::unique_ptr<TrainingController> training_;
  std::unique_ptr<ExportController> exports_;
  std::unique_ptr<SaveController> saves_;
  std::unique_ptr<ReopenController> reopening_;
  std::shared_ptr<Journal> journal_;
  std::unique_ptr<Autosave> autosave_;
};

}  // namespace cutis
