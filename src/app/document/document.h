#pragma once

// One subject: what was opened, its maps, its edits.
//
// All change goes through apply(), undo(), fitWith() and open…(): they cancel what they invalidate,
// keep the history and notify who watches. Reading and fitting run in the background; whatever can
// be shown is shown before they end. The document never waits.
//
// Lives on the interface thread. What pictures are made of is handed out as a Scene, which any
// thread may read.

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include <QObject>
#include <QString>
#include <QTimer>

#include "core/analyse/skin_values.h"
#include "core/base/result.h"
#include "core/fit/fit_run.h"
#include "src/app/document/place_spectra.h"
#include "src/app/document/scene.h"
#include "src/app/document/shared_rect.h"
#include "src/app/document/undo_history.h"
#include "src/app/engine.h"
#include "src/app/job_runner.h"
#include "src/app/open/fit_choice.h"
#include "src/app/open/source_fit.h"
#include "src/app/open/source_preview.h"
#include "src/app/project/project.h"
#include "src/app/project/project_open.h"
#include "src/images/maps/maps_file.h"

namespace cutis {

// A change of the state that undo restores.
struct Command {
  QString name;        // "Melanin × 1.4"
  QString mergeGroup;  // commands of one group in a row are one step; empty never merges
  std::function<void(DocumentState&)> change;
  // A control is being dragged: pictures may be coarse until the next command.
  bool moving = false;
};

// How an image is read, where a person has chosen.
struct OpenChoice {
  SourceOptions source;
  std::optional<double> exposure = {};  // found anew by each fit unless given
};

class Document : public QObject {
  Q_OBJECT

 public:
  // Both outlive the document.
  Document(Engine& engine, JobRunner& jobs, QObject* parent = nullptr);

  // How what is opened from now on is fitted at first.
  void setUsualFit(const FitChoice& choice) { usualFit_ = choice; }

  // Each replaces what is open once it could be read; a failure leaves it as it was.
  void openSample();
  // A capture's folder, capture.json, an image, maps or a project.
  void open(const std::filesystem::path& path, const OpenChoice& choice = {});
  // A project with `found` for the file that it is missing; whatever it holds, or only where it is
  // the file that the project was saved with.
  void openRelinked(const MissingSource& missing, const std::filesystem::path& found,
                    bool whateverItHolds);
  // What a journal kept, without a place of its own and with edits that are not saved.
  void recover(const Project& project);

  bool isOpen() const { return scene_.has_value(); }
  // Not yet, but what will be can be seen.
  bool isPreviewed() const { return isPreviewed_; }
  QString name() const { return name_; }
  // Whether the fit is complete.
  bool isFitted() const { return fitted_; }
  // Whether the maps hold anything, a first impression at least.
  bool hasEstimate() const { return hasEstimate_; }
  // Whether a fit is under way. Neither fitted nor fitting: the first one was cancelled.
  bool isFitting() const { return jobs_.isRunning(fitting_); }
  // The files this was made from; never written to.
  const std::vector<std::filesystem::path>& sourceFiles() const { return sourceFiles_; }
  // Precondition: isOpen().
  const Scene& scene() const { return *scene_; }
  const FitStatistics& statistics() const { return statistics_; }
  // How the fitted values are spread over skin, without edits; null where it is not known yet.
  std::shared_ptr<const SkinValues> skinValues() const { return fitted_ ? skin_ : nullptr; }
  // The place of the project; empty while it has none.
  const std::filesystem::path& projectPath() const { return state_.path; }
  // Whether something would be lost that a project keeps: edits and pins, and of a project that is
  // saved already the fit and the places of its source, too.
  bool isModified() const;
  // How it is looked at: kept for the project, and what an opened project brings.
  const ProjectView& view() const { return state_.view; }
  void setView(const ProjectView& view) { state_.view = view; }
  // Places that are kept, without a history. Setting them changes what is saved.
  const PinSet& pins() const { return state_.pins; }
  void setPins(const PinSet& pins);
  // All that a project holds. Precondition, here and below: isOpen().
  Project project() const;
  // The fitted maps as a file of their own, without edits; reads the profile again, any thread may
  // call what is returned. Precondition: isFitted().
  std::function<Result<MapsFile>()> mapsFile() const;
  // Writes the project in the background; saved() or failed() follows. One save follows another.
  void save(const std::filesystem::path& path);
  bool isSaving() const { return jobs_.isRunning(saving_); }
  // What is being saved is left as it was before.
  void stopSaving();
  // Looks in the background whether files of the source hold something else than was read; each
  // change is reported once, by sourceChanged(), and each file that is no longer there, by
  // noticed().
  void checkSource();
  // Reads the source again and fits it again; edits are kept. Precondition: it came from files.
  void reload() { readAgain(state_.source, choice_); }
  // How an image or a capture was read: the only ones that can be read in another way.
  bool canReopen() const;
  SourceKind sourceKind() const { return state_.source.kind; }
  OpenChoice openChoice() const { return {state_.source.options, choice_.exposure}; }
  // As reload(), but read as chosen now. A failure leaves it as it was. Precondition: canReopen().
  void reopen(const OpenChoice& choice);
  // A picture that by its name is the mask of this one, which was opened without; empty: none.
  const std::filesystem::path& maskBeside() const { return state_.maskBeside; }
  // Whether there is something to fit: opened maps stay what they are.
  bool canFit() const { return isOpen() && scene_->source != nullptr; }
  // How the maps were fitted, or are being fitted.
  const FitChoice& fitChoice() const { return choice_; }
  // Which share of a single image the exposure that was found brings into the range of skin; none
  // where it was chosen, or is not known any more.
  std::optional<double> shareInRange() const;

  // What somebody looks at: a fit that is under way does its tiles first.
  void lookAt(const Rect& view);

  // Fits again, edits are kept; a choice that cannot be is reported. Where the fit fails or is
  // cancelled the last complete one comes back. Precondition: canFit().
  // lights: those of a capture to use; empty: all. Where these or the reflection of the surface are
  // others than before, the source is read again first.
  void fitWith(const FitChoice& choice) { fitWith(choice, state_.source.options.lights); }
  void fitWith(const FitChoice& choice, const std::vector<std::string>& lights);
  // Once more with the same choice, after a fit was cancelled. Precondition: canFit().
  void fitAgain() { startFit(); }
  // Adds a network of the profile and the source's lights to the engine and fits with it.
  // Precondition: canFit().
  void useNetwork(std::shared_ptr<const ChromophoreNetwork> network, const std::string& profile);

  // Precondition for the rest: isOpen().
  void apply(const Command& command);
  // The drag of a control has ended: the next command starts a step of its own.
  void endGroup() { history_.closeGroup(); }
  void undo();
  void redo();
  // Undoes or redoes up to a step of the history; one that is not there is ignored.
  void goToStep(std::size_t step);
  const UndoHistory& history() const { return history_; }

  // What is known of one pixel; nothing where there is no estimate. About 0.5 ms.
  std::optional<PlaceSpectra> spectraAt(int x, int y) const;
  // The parameters alone, which need no model.
  struct PixelParameters {
    ParameterVector original;
    ParameterVector edited;
  };
  std::optional<PixelParameters> parametersAt(int x, int y) const;

 Q_SIGNALS:
  // Nothing is open yet, and this is a first impression of what will be: opened() or previewEnded()
  // follows.
  void previewed(const cutis::SourcePreview& preview);
  // More of it was read meanwhile.
  void previewRefined(const cutis::SourcePreview& preview);
  // Nothing came of it: it could not be read, or was cancelled.
  void previewEnded();
  // What is said from now on is about what is being opened. It ends with opened() or with
  // openingFailed(), or with neither where it is cancelled, or read again and cannot be.
  void openingStarted();
  // Something else is open now; its maps may still be empty.
  void opened();
  // The maps have new values. At most 20 times a second; of a picture that does not
  // fit into memory only when it is fitted.
  void mapsChanged();
  // Maps, profile and what depends on the profile are others; size and edits are as they were.
  void sceneReplaced();
  void fitted();
  // Or the first fit was cancelled, which leaves the choice as it is.
  void fitChoiceChanged();
  // There is no network for the lights and the profile; another method is used instead.
  void networkMissing();
  void editsChanged(bool moving);
  void pinsChanged();
  // A file that was to be opened could not be, not one that is read again; before failed().
  void openingFailed(const QString& path, const QString& sentence);
  // A project, or what a journal kept, cannot be opened while a file is not there.
  void sourceMissing(const cutis::MissingSource& missing);
  // What was named for the missing file is another one.
  void otherSourceFound(const cutis::MissingSource& missing, const QString& found);
  void saved(const QString& path);
  // A save failed, which failed() has said, or was cancelled.
  void notSaved();
  // isModified() may be another now, or the place of the project.
  void modifiedChanged();
  void sourceChanged(const QStringList& files);
  // One sentence for the user.
  void failed(const QString& sentence);
  void noticed(const QString& sentence);

 private:
  void noteMissing(const std::vector<std::filesystem::path>& missing);

  // What was read, on its way to being shown.
  struct Opened {
    Scene scene;
    QString name;
    Project project;             // its source, fit, edits and view
    std::filesystem::path path;  // of the project; empty: it has none
    bool isFitted = false;
    std::shared_ptr<const SkinValues> skin = {};  // where it is fitted
    bool isReload = false;                        // edits, view and path are those of what is open
    bool isUnsaved = false;                       // what a journal kept
    bool isMoved = false;  // the source lies somewhere else than the project says
    std::filesystem::path maskBeside = {};
    // Instead of all this: what kept it from being opened.
    std::filesystem::path missing;
    std::filesystem::path other;
  };
  // preview: who looks on; null: nobody.
  using Opener =
      std::function<Result<Opened>(const JobContext& context, const PreviewSink* preview)>;

  // path: empty for the sample. preview: how the file is read, where it can be seen coarsely first.
  void startOpening(const QString& name, const std::filesystem::path& path, Opener open,
                    const std::optional<SourceOptions>& preview = std::nullopt);
  void showPreview(const QString& name, const SourcePreview& preview);
  void endPreview();
  void openProject(const std::filesystem::path& path);
  void readAgain(const ProjectSource& source, const FitChoice& choice);
  void sayWhatIsMasked();
  // On the thread of the job.
  Result<Opened> openedSource(ProjectSource source, const FitChoice& choice,
                              const JobContext& context, const PreviewSink* preview = nullptr);
  Result<Opened> openedMaps(ProjectSource source, const JobContext& context);
  Result<Opened> openedProject(const Project& project, const std::filesystem::path& path,
                               const JobContext& context);
  void takeOrReport(const Opened& opened);
  void take(const Opened& opened);
  void takeProject(const Opened& opened);
  void completeSave(const std::filesystem::path& path, const Project& asked, const Project& saved);
  // With notices for the user.
  JobContext contextOf(const JobRunner::Handle& job);
  void startFit();
  void cancelFit();
  // On the thread of the job.
  void fit(const FitChoice& choice, Scene scene, const JobRunner::Handle& job);
  SourceFitObserver observerOf(const Scene& scene, const FitOptions& options,
                               const JobRunner::Handle& job);
  void show(const Scene& fitted);
  void completeFit(const FitStatistics& statistics, const std::optional<ExposureChoice>& exposure,
                   const std::shared_ptr<const SkinValues>& skin,
                   const std::vector<FitRemark>& remarks);
  static std::shared_ptr<const SkinValues> skinOf(const JudgedPixels& pixels,
                                                  const SkinModel& model);
  void backToLastFit();
  void fitWithoutNetwork();
  void setEdits(bool moving);

  void giveMemoryBack();

  Engine& engine_;
  JobRunner& jobs_;
  // Goes when the members below have gone.
  std::shared_ptr<void> lastAct_{nullptr, [this](void*) { giveMemoryBack(); }};
  std::shared_ptr<TileStore> store_;
  JobId opening_ = 0;
  JobId fitting_ = 0;
  QTimer mapsTimer_;

  std::optional<Scene> scene_;
  QString name_;
  std::vector<std::filesystem::path> sourceFiles_;
  // What of a project is neither scene nor history.
  struct ProjectState {
    ProjectSource source;
    ProjectView view;
    PinSet pins;
    std::filesystem::path path;
    std::filesystem::path maps;  // the file that holds the maps of now; empty: none
    std::filesystem::path maskBeside;
    // As last saved or opened; a fit is only compared where there is a project.
    std::string edits;
    PinSet savedPins;
    FitChoice fit;
    bool isMoved = false;
  };
  ProjectState state_;
  JobId saving_ = 0;
  std::filesystem::path saveNext_;
  JobId checking_ = 0;
  // Files of the source that were not there when it was last looked at, and of these the ones that
  // were reported.
  std::set<std::filesystem::path> missing_;
  std::set<std::filesystem::path> reportedMissing_;
  FitChoice usualFit_;
  FitChoice choice_;
  bool isPreviewed_ = false;
  bool hasEstimate_ = false;
  bool fitted_ = false;
  FitStatistics statistics_;
  std::shared_ptr<const SkinValues> skin_;
  // The last one that was complete.
  struct Fit {
    FitChoice choice;
    Scene scene;
    FitStatistics statistics;
    std::optional<ExposureChoice> exposure;  // where it was found
    std::shared_ptr<const SkinValues> skin;
  };
  std::optional<Fit> lastFit_;
  std::shared_ptr<SharedRect> view_ = std::make_shared<SharedRect>();  // shared with the fit
  UndoHistory history_;
};

}  // namespace cutis
