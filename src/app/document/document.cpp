#include "src/app/document/document.h"

#include <utility>
#include <vector>

#include "src/app/fit_method.h"
#include "src/app/open/source_fit.h"
#include "src/app/project/manifest.h"
#include "src/images/capture/capture_file.h"
#include "src/images/maps/maps_file.h"

namespace cutis {
namespace {

// Above this, tiles go to disk: a large texture must not push everything else out of memory.
constexpr std::size_t kMemoryForPlanes = std::size_t{2} << 30;
constexpr int kMapsIntervalMs = 50;

// The planes of a larger picture do not all stay in memory. Every look at all of it would fetch
// them from disk, tile by tile, while the fit needs the others: it is shown again when it is
// complete.
bool isShownWhileFitted(const ChromophoreMaps& maps) {
  constexpr double kMostPixels = 4e7;
  return double{1} * maps.width() * maps.height() <= kMostPixels;
}

QString sentenceOf(const Error& error) {
  return QString::fromStdString(error.text());
}

}  // namespace

Document::Document(Engine& engine, JobRunner& jobs, QObject* parent)
    : QObject(parent),
      engine_(engine),
      jobs_(jobs),
      store_(std::make_shared<TileStore>(kMemoryForPlanes)) {
  mapsTimer_.setSingleShot(true);
  mapsTimer_.setInterval(kMapsIntervalMs);
  connect(&mapsTimer_, &QTimer::timeout, this, &Document::mapsChanged);
  // Cancelled by the user: a fit that is replaced or has failed is no longer under way here.
  connect(&jobs, &JobRunner::finished, this, [this](JobId job) {
    if (job == fitting_ && !fitted_) backToLastFit();
    if (job == opening_) endPreview();
    if (job == saving_) {
      saving_ = 0;
      saveNext_.clear();
      Q_EMIT notSaved();
    }
  });
}

void Document::openSample() {
  startOpening(tr("Sample face patch"), {},
               [this, choice = usualFit_](const JobContext& context, const PreviewSink*) {
                 return openedSource({}, choice, context);
               });
}

void Document::open(const std::filesystem::path& path, const OpenChoice& choice) {
  const QString name = QString::fromStdString(path.filename().string());
  if (isProjectFile(path)) return openProject(std::filesystem::absolute(path).lexically_normal());
  const ProjectSource source = {
      SourceKind::image, std::filesystem::absolute(path).lexically_normal(), choice.source, {}};
  FitChoice fit = usualFit_;
  fit.exposure = choice.exposure;
  startOpening(
      name, path,
      [this, source, fit](const JobContext& context, const PreviewSink* preview) -> Result<Opened> {
        ProjectSource found = source;
        if (looksLikeCapture(source.path)) {
          found.kind = SourceKind::capture;
        } else if (isMapsFile(source.path)) {
          found.kind = SourceKind::maps;
          return openedMaps(found, context);
        }
        CUTIS_TRY(opened, openedSource(found, fit, context, preview));
        opened.maskBeside = unusedMaskBeside(opened.project.source);
        return opened;
      },
      choice.source);
}

JobContext Document::contextOf(const JobRunner::Handle& job) {
  JobContext context = job.context;
  context.notice = [this, post = job.post](const std::string& sentence) {
    post([this, text = QString::fromStdString(sentence)] { Q_EMIT noticed(text); });
  };
  return context;
}

void Document::startOpening(const QString& name, const std::filesystem::path& path, Opener open,
                            const std::optional<SourceOptions>& preview) {
  jobs_.cancel(opening_);
  Q_EMIT openingStarted();
  const bool showsPreview = !isOpen() && preview.has_value();
  opening_ =
      jobs_.start(tr("Open %1").arg(name),
                  [this, name, path, options = preview.value_or(SourceOptions()), showsPreview,
                   open = std::move(open)](const JobRunner::Handle& job) {
                    const PreviewSink rows = previewSink(options, [&](SourcePreview seen) {
                      job.post([this, name, shown = std::move(seen)] { showPreview(name, shown); });
                    });
                    const bool isSeen = showsPreview && showSource(path, rows, job.context);
                    auto opened = open(contextOf(job), showsPreview && !isSeen ? &rows : nullptr);
                    if (opened.failed()) {
                      job.post([this, path, sentence = sentenceOf(opened.error())] {
                        if (!path.empty())
                          Q_EMIT openingFailed(QString::fromStdString(path.string()), sentence);
                        Q_EMIT failed(sentence);
                      });
                    } else if (opened) {
                      job.post([this, result = opened.value()] { takeOrReport(result); });
                    }
                  });
}

Result<Document::Opened> Document::openedSource(ProjectSource source, const FitChoice& choice,
                                                const JobContext& context,
                                                const PreviewSink* preview) {
  CUTIS_TRY(read, openSourceOf(source, choice, engine_, store_, context.child(0.0, 1.0, "reading"),
                               preview));
  Opened opened;
  opened.name = QString::fromStdString(read.source->name);
  opened.project.source = std::move(source);
  opened.project.fit = choice;
  opened.scene.model = read.model;
  opened.scene.source = read.source;
  opened.scene.maps = FitPlanes(read.source->measurements, {}, store_).maps;
  return opened;
}

Result<Document::Opened> Document::openedMaps(ProjectSource source, const JobContext& context) {
  const std::filesystem::path path = source.path;
  source.files = listSourceFiles(path, {});
  CUTIS_TRY(file, readMaps(path, PixelFormat::float32, store_, context.child(0.0, 0.5, "reading")));
  const MapsAttributes& attributes = file.attributes;
  CUTIS_TRY(model, attributes.profileJson.empty()
                       ? engine_.model(kDefaultProfile, path.string())
                       : engine_.modelFromText(attributes.profileJson, path.string()));
  CUTIS_CHECK(checkCoefficients(file.maps, model->profile(), path.string()));
  Opened opened;
  opened.name = QString::fromStdString(path.filename().string());
  opened.isFitted = true;
  opened.project.source = std::move(source);
  opened.scene.model = model;
  opened.scene.maps = file.maps;
  opened.project.fit = {model->profile().name, FitMethod::refined, false};
  if (const auto method = fitMethodNamed(attributes.method, {})) {
    opened.project.fit.method = method.value();
  }
  opened.project.fit.shading = !file.shading.empty();
  CUTIS_TRY(pixels, judgePixels(file.maps, context.child(0.5, 0.5)));
  opened.skin = skinOf(pixels, *model);
  if (file.maps.free().count() == 0) return opened;
  CUTIS_TRY(spectra,
            SkinSpectra::make(model, file.maps.perPixel(), context.child(0.5, 1.0, "spectra")));
  opened.scene.spectra = std::make_shared<const SkinSpectra>(std::move(spectra));
  return opened;
}

void Document::take(const Opened& opened) {
  cancelFit();
  scene_ = opened.scene;
  choice_ = opened.project.fit;
  name_ = opened.name;
  isPreviewed_ = false;
  hasEstimate_ = scene_->source == nullptr || opened.isFitted;
  fitted_ = false;
  statistics_ = {};
  lastFit_.reset();
  takeProject(opened);
  scene_->edits = history_.current().edits;
  if (opened.isFitted) {
    fitted_ = true;
    skin_ = opened.skin;
    lastFit_ = {choice_, *scene_, {}, {}, skin_};
  }
  Q_EMIT this->opened();
  Q_EMIT modifiedChanged();
  Q_EMIT fitChoiceChanged();
  sayWhatIsMasked();
  if (!opened.isFitted) return startFit();
  Q_EMIT fitted();
}

void Document::fitWith(const FitChoice& choice, const std::vector<std::string>& lights) {
  const Status allowed = checkFitChoice(choice, *scene_->source);
  if (allowed.failed()) {
    Q_EMIT fitChoiceChanged();
    Q_EMIT failed(sentenceOf(allowed.error()));
    return;
  }
  // A choice takes the place of one that the source is still being read for.
  jobs_.cancel(std::exchange(opening_, 0));
  if (lights != state_.source.options.lights || needsReading(choice_, choice)) {
    ProjectSource source = state_.source;
    source.options.lights = lights;
    return readAgain(source, choice);
  }
  if (choice == choice_ && (fitted_ || jobs_.isRunning(fitting_))) return;
  if (lastFit_ && choice == lastFit_->choice) return backToLastFit();
  choice_ = choice;
  startFit();
}

void Document::useNetwork(std::shared_ptr<const ChromophoreNetwork> network,
                          const std::string& profile) {
  engine_.addNetwork(std::move(network));
  const std::optional<double> exposure = choice_.exposure;
  choice_ = {profile, FitMethod::network, false, exposure};
  startFit();
}

void Document::startFit() {
  cancelFit();
  fitted_ = false;
  state_.maps.clear();
  fitting_ = jobs_.start(tr("Fit %1").arg(name_),
                         [this, choice = choice_, scene = *scene_](const JobRunner::Handle& job) {
                           fit(choice, scene, job);
                         });
  Q_EMIT fitChoiceChanged();
  Q_EMIT modifiedChanged();
}

void Document::cancelFit() {
  jobs_.cancel(std::exchange(fitting_, 0));
  mapsTimer_.stop();
}

void Document::fit(const FitChoice& choice, Scene scene, const JobRunner::Handle& job) {
  const JobContext context = contextOf(job).child(0.0, 1.0, "preparing");
  const auto fitted = [&]() -> Result<FittedSource> {
    CUTIS_TRY(model, engine_.model(choice.profile, {}));
    if (model != scene.model) {
      CUTIS_TRY(source, sourceForModel(*scene.source, *model));
      scene.model = model;
      scene.source = std::make_shared<const Source>(std::move(source));
    }
    if (choice.method == FitMethod::network) {
      CUTIS_TRY(network, engine_.network(model->profile(), scene.source->measurements.rig));
      if (network == nullptr) {
        job.post([this] { fitWithoutNetwork(); });
        return Cancelled{};
      }
    }
    CUTIS_TRY(options, fitOptions(choice, model->profile()));
    scene.source = atChosenExposure(scene.source, choice);
    return fitSource(model, scene.source, {options, !choice.exposure}, engine_, store_, context,
                     observerOf(scene, options, job));
  }();
  if (fitted.failed()) {
    job.post([this, sentence = sentenceOf(fitted.error())] {
      backToLastFit();
      Q_EMIT failed(sentence);
    });
  } else if (fitted) {
    const FittedSource& found = fitted.value();
    job.post([this, statistics = found.statistics, exposure = found.exposure,
              skin = skinOf(found.pixels, *found.model),
              remarks = found.remarks] { completeFit(statistics, exposure, skin, remarks); });
  }
}

SourceFitObserver Document::observerOf(const Scene& scene, const FitOptions& options,
                                       const JobRunner::Handle& job) {
  SourceFitObserver observer;
  observer.begun = [this, scene, options, post = job.post](
                       const std::shared_ptr<const Source>& source,
                       const std::shared_ptr<const PixelSolver>& solver,
                       const ChromophoreMaps& maps) {
    Scene begun = scene;
    begun.source = source;
    begun.maps = maps;
    begun.evidence = std::make_shared<FitEvidence>(scene.model, source, options, solver);
    post([this, begun] { show(begun); });
  };
  observer.changed = [this, post = job.post] {
    post([this] {
      if (!mapsTimer_.isActive() && isShownWhileFitted(scene_->maps)) mapsTimer_.start();
    });
  };
  observer.view = [view = view_] { return view->get(); };
  return observer;
}

void Document::show(const Scene& fitted) {
  const EditStack edits = scene_->edits;
  scene_ = fitted;
  scene_->edits = edits;
  hasEstimate_ = true;
  Q_EMIT sceneReplaced();
}

void Document::completeFit(const FitStatistics& statistics,
                           const std::optional<ExposureChoice>& exposure,
                           const std::shared_ptr<const SkinValues>& skin,
                           const std::vector<FitRemark>& remarks) {
  statistics_ = statistics;
  skin_ = skin;
  fitted_ = true;
  lastFit_ = {choice_, *scene_, statistics, exposure, skin};
  mapsTimer_.stop();
  giveMemoryBack();
  Q_EMIT mapsChanged();
  Q_EMIT fitted();
  for (const FitRemark& remark : remarks) {
    const QString sentence = tr("%1: %2").arg(name_, QString::fromStdString(remark.sentence));
    if (remark.kind == FitRemark::Kind::nothingFitted) {
      Q_EMIT failed(sentence);
    } else {
      Q_EMIT noticed(sentence);
    }
  }
}

std::optional<double> Document::shareInRange() const {
  if (!fitted_ || !lastFit_ || !lastFit_->exposure) return std::nullopt;
  return lastFit_->exposure->inside;
}

void Document::backToLastFit() {
  cancelFit();
  if (!lastFit_) {
    Q_EMIT fitChoiceChanged();
    return;
  }
  choice_ = lastFit_->choice;
  statistics_ = lastFit_->statistics;
  skin_ = lastFit_->skin;
  fitted_ = true;
  show(lastFit_->scene);
  Q_EMIT fitChoiceChanged();
  Q_EMIT modifiedChanged();
}

void Document::fitWithoutNetwork() {
  const bool hadAnother = lastFit_ && lastFit_->choice.method != FitMethod::network;
  choice_.method = hadAnother ? lastFit_->choice.method : FitMethod::refined;
  if (lastFit_ && lastFit_->choice == choice_) {
    backToLastFit();
  } else {
    startFit();
  }
  Q_EMIT networkMissing();
}

void Document::lookAt(const Rect& view) {
  view_->set(view);
}

void Document::apply(const Command& command) {
  DocumentState state = history_.current();
  command.change(state);
  history_.push(command.name, command.mergeGroup, std::move(state));
  setEdits(command.moving);
}

void Document::undo() {
  if (!history_.canUndo()) return;
  history_.undo();
  setEdits(false);
}

void Document::redo() {
  if (!history_.canRedo()) return;
  history_.redo();
  setEdits(false);
}

void Document::goToStep(std::size_t step) {
  if (step >= history_.stepCount() || step == history_.position()) return;
  history_.goTo(step);
  setEdits(false);
}

void Document::setEdits(bool moving) {
  scene_->edits = history_.current().edits;
  Q_EMIT editsChanged(moving);
  Q_EMIT modifiedChanged();
}

}  // namespace cutis
