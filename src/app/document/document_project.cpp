// What a document does with projects: it opens, saves and reloads them, and knows what is not
// saved.

#include <optional>
#include <set>
#include <utility>

#include "core/fit/discrepancy_choice.h"
#include "src/app/document/document.h"
#include "src/app/project/manifest.h"
#include "src/app/project/project_save.h"
#include "src/files/edits/edits_file.h"
#include "src/files/profiles/profile_file.h"
#include "src/images/codec/source_file.h"

namespace cutis {
namespace {

namespace fs = std::filesystem;

QString textOf(const fs::path& path) {
  return QString::fromStdString(path.string());
}

// Edits that change nothing are like none.
std::string textOf(const EditStack& edits) {
  return isNeutral(edits) ? std::string() : editsText(edits);
}

}  // namespace

void Document::openProject(const fs::path& path) {
  startOpening(textOf(path.filename()), path,
               [this, path](const JobContext& context, const PreviewSink*) -> Result<Opened> {
                 removeLeftovers(path);
                 CUTIS_TRY(project, readProject(path, context.notice));
                 return openedProject(project, path, context);
               });
}

Result<Document::Opened> Document::openedProject(const Project& project, const fs::path& path,
                                                 const JobContext& context) {
  Opened opened;
  opened.project = project;
  opened.path = path;
  opened.missing = missingFile(project.source);
  if (!opened.missing.empty()) return opened;
  Project read = project;
  if (read.source.kind == SourceKind::maps) {
    CUTIS_TRY(maps, openedMaps(read.source, context));
    opened = maps;
    CUTIS_CHECK(addHashes(read.source.path, {}, opened.project.source.files, context));
    checkUnchanged(read.source.files, opened.project.source.files, context);
    read.source.files = opened.project.source.files;
  } else {
    CUTIS_TRY(source, openProjectSource(read, engine_, store_, context));
    opened.name = QString::fromStdString(source.source->name);
    opened.isFitted = source.maps.has_value();
    opened.scene.model = source.model;
    opened.scene.source = source.source;
    opened.scene.maps =
        source.maps ? *source.maps : FitPlanes(source.source->measurements, {}, store_).maps;
    if (opened.isFitted) {
      CUTIS_TRY(options, fitOptions(read.fit, source.model->profile()));
      opened.scene.evidence = std::make_shared<FitEvidence>(source.model, source.source, options);
      CUTIS_TRY(pixels, judgePixels(opened.scene.maps, context));
      opened.skin = skinOf(pixels, *source.model);
    }
  }
  if (!path.empty()) opened.name = QString::fromStdString(path.stem().string());
  opened.project = std::move(read);
  opened.path = path;
  return opened;
}

void Document::openRelinked(const MissingSource& missing, const fs::path& found,
                            bool whateverItHolds) {
  const auto open = [this, missing, found, whateverItHolds](const JobContext& context,
                                                            const PreviewSink*) -> Result<Opened> {
    const std::string wanted = savedHash(missing.project, missing.file);
    if (!whateverItHolds && !wanted.empty()) {
      CUTIS_TRY(hash, hashFile(found, context));
      if (hash != wanted) {
        Opened other;
        other.project = missing.project;
        other.path = missing.path;
        other.missing = missing.file;
        other.other = found;
        return other;
      }
    }
    CUTIS_TRY(opened,
              openedProject(relinked(missing.project, missing.file, found), missing.path, context));
    opened.isMoved = true;
    opened.isUnsaved = missing.path.empty();
    return opened;
  };
  startOpening(textOf(found.filename()), missing.path, open);
}

void Document::recover(const Project& project) {
  startOpening(tr("what was not saved"), {},
               [this, project](const JobContext& context, const PreviewSink*) -> Result<Opened> {
                 CUTIS_TRY(opened, openedProject(project, {}, context));
                 opened.isUnsaved = true;
                 return opened;
               });
}

void Document::takeOrReport(const Opened& opened) {
  if (opened.missing.empty()) return take(opened);
  const MissingSource missing = {opened.project, opened.path, opened.missing};
  if (opened.other.empty()) {
    Q_EMIT sourceMissing(missing);
  } else {
    Q_EMIT otherSourceFound(missing, textOf(opened.other));
  }
}

void Document::takeProject(const Opened& opened) {
  state_.source = opened.project.source;
  state_.maps = opened.project.maps;
  state_.maskBeside = opened.maskBeside;
  sourceFiles_.clear();
  if (!state_.source.path.empty()) sourceFiles_.push_back(state_.source.path);
  if (opened.isReload) {
    state_.isMoved = true;
    return;
  }
  state_.path = opened.path;
  state_.view = opened.project.view;
  state_.pins = opened.project.pins;
  state_.isMoved = opened.isMoved;
  state_.fit = choice_;
  state_.edits = opened.isUnsaved ? std::string() : textOf(opened.project.edits);
  state_.savedPins = opened.isUnsaved ? PinSet() : opened.project.pins;
  history_ = UndoHistory(DocumentState{opened.project.edits});
}

bool Document::isModified() const {
  if (!isOpen()) return false;
  if (textOf(history_.current().edits) != state_.edits) return true;
  if (state_.pins != state_.savedPins) return true;
  return !state_.path.empty() && (choice_ != state_.fit || state_.isMoved);
}

Project Document::project() const {
  return {state_.source, choice_, history_.current().edits, state_.view, state_.maps, {},
          state_.pins};
}

void Document::setPins(const PinSet& pins) {
  if (pins == state_.pins) return;
  state_.pins = pins;
  Q_EMIT pinsChanged();
  Q_EMIT modifiedChanged();
}

std::function<Result<MapsFile>()> Document::mapsFile() const {
  FittedSource fitted;
  fitted.model = scene_->model;
  fitted.source = scene_->source;
  fitted.planes.maps = scene_->maps;
  return [fitted, choice = choice_, &engine = engine_]() mutable -> Result<MapsFile> {
    CUTIS_TRY(text, profileText(choice.profile, {}));
    CUTIS_TRY(model, engine.modelFromText(text, choice.profile));
    if (model != fitted.model) {
      return inputError(choice.profile,
                        "the profile has changed since it was fitted with; choose the profile "
                        "again");
    }
    CUTIS_TRY(options, fitOptions(choice, model->profile()));
    fitted.options = suitedTo(fitted.source->measurements, options);
    return mapsFileOf(fitted, text);
  };
}

void Document::save(const fs::path& place) {
  const fs::path path = fs::absolute(place).lexically_normal();
  if (isSaving()) {
    saveNext_ = path;
    return;
  }
  const bool bringsMaps = fitted_ && scene_->source != nullptr && state_.maps.empty();
  const auto maps = bringsMaps ? mapsFile() : std::function<Result<MapsFile>()>();
  saving_ = jobs_.start(
      tr("Save %1").arg(textOf(path.filename())),
      [this, path, asked = project(), maps](const JobRunner::Handle& job) {
        const auto saved = [&]() -> Result<Project> {
          Project project = asked;
          CUTIS_CHECK(addHashes(project.source.path, {}, project.source.files, job.context));
          if (!maps) return saveProject(path, project, nullptr, job.context);
          CUTIS_TRY(file, maps());
          return saveProject(path, project, &file, job.context);
        }();
        if (saved.failed()) {
          job.post([this, sentence = QString::fromStdString(saved.error().text())] {
            Q_EMIT failed(sentence);
          });
        } else if (saved) {
          job.post(
              [this, path, asked, project = saved.value()] { completeSave(path, asked, project); });
        }
      });
}

void Document::stopSaving() {
  jobs_.cancel(saving_);
}

void Document::completeSave(const fs::path& path, const Project& asked, const Project& saved) {
  saving_ = 0;
  state_.path = path;
  state_.fit = asked.fit;
  state_.edits = textOf(asked.edits);
  state_.savedPins = asked.pins;
  state_.isMoved = false;
  state_.source.files = saved.source.files;
  // Another fit may have begun meanwhile.
  if (fitted_ && choice_ == asked.fit) state_.maps = saved.maps;
  name_ = QString::fromStdString(path.stem().string());
  Q_EMIT this->saved(textOf(path));
  Q_EMIT modifiedChanged();
  if (!saveNext_.empty()) save(std::exchange(saveNext_, {}));
}

void Document::checkSource() {
  if (!isOpen() || state_.source.files.empty() || jobs_.isRunning(checking_)) return;
  checking_ =
      jobs_.startQuiet([this, files = state_.source.files](const JobRunner::Handle& job) mutable {
        job.post([this, missing = missingFiles(files)] { noteMissing(missing); });
        const auto changed = changedFiles(files, job.context);
        if (!changed || changed.value().empty()) return;
        job.post([this, files, changed = changed.value()] {
          state_.source.files = files;
          QStringList names;
          for (const fs::path& file : changed)
            names << textOf(file);
          Q_EMIT sourceChanged(names);
        });
      });
}

// A program that replaces a file may take it away for a moment: it is missing when two looks in a
// row do not find it.
void Document::noteMissing(const std::vector<fs::path>& missing) {
  const std::set<fs::path> before = std::exchange(missing_, {missing.begin(), missing.end()});
  std::erase_if(reportedMissing_,
                [this](const fs::path& file) { return !missing_.contains(file); });
  for (const fs::path& file : missing_) {
    if (!before.contains(file) || !reportedMissing_.insert(file).second) continue;
    Q_EMIT noticed(tr("%1 is no longer there; put it back before you reload it or open a project "
                      "of it, what is open now stays")
                       .arg(textOf(file)));
  }
}

bool Document::canReopen() const {
  return isOpen() &&
         (state_.source.kind == SourceKind::image || state_.source.kind == SourceKind::capture);
}

void Document::reopen(const OpenChoice& choice) {
  ProjectSource source = state_.source;
  source.options = choice.source;
  FitChoice fit = choice_;
  fit.exposure = choice.exposure;
  readAgain(source, fit);
}

void Document::readAgain(const ProjectSource& source, const FitChoice& choice) {
  startOpening(name_, {},
               [this, source, choice, name = name_](const JobContext& context,
                                                    const PreviewSink*) -> Result<Opened> {
                 CUTIS_TRY(opened, source.kind == SourceKind::maps
                                       ? openedMaps(source, context)
                                       : openedSource(source, choice, context));
                 opened.name = name;
                 opened.isReload = true;
                 return std::move(opened);
               });
}

void Document::sayWhatIsMasked() {
  const fs::path& mask = state_.source.options.mask;
  if (mask.empty()) return;
  Q_EMIT noticed(
      tr("%1: what is black in the mask %2 is left out").arg(name_, textOf(mask.filename())));
}

}  // namespace cutis
