#include "src/app/document/document.h"

#include <array>
#include <utility>

#include "core/skin/parameter_buffer.h"
#include "src/app/document/scene_fit.h"
#include "src/app/fit_method.h"
#include "src/app/open/source_for_profile.h"
#include "src/images/capture/capture_file.h"
#include "src/images/maps/maps_file.h"

namespace cutis {
namespace {

// Above this, tiles go to disk: a large texture must not push everything else out of memory.
constexpr std::size_t kMemoryForPlanes = std::size_t{2} << 30;
constexpr int kMapsIntervalMs = 50;

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
  });
}

// The same photographs whatever they are fitted with.
void Document::openSample() {
  startOpening(tr("Sample face patch"), {},
               [this](const auto& model, const JobContext& context) -> Result<Source> {
                 CUTIS_TRY(painted, engine_.model(kDefaultProfile, {}));
                 CUTIS_TRY(sample, cutis::openSample(*painted, store_, context));
                 return changeProfile(sample, {}, model, engine_, store_, context);
               });
}

void Document::open(const std::filesystem::path& path) {
  if (!looksLikeCapture(path) && isMapsFile(path)) return openMaps(path);
  startOpening(QString::fromStdString(path.filename().string()), {path},
               [this, path](const auto& model, const JobContext& context) {
                 return openForProfile(path, model, engine_, store_, context);
               });
}

JobContext Document::contextOf(const JobRunner::Handle& job) {
  JobContext context = job.context;
  context.notice = [this, post = job.post](const std::string& sentence) {
    post([this, text = QString::fromStdString(sentence)] { Q_EMIT noticed(text); });
  };
  return context;
}

void Document::startOpening(const QString& name, std::vector<std::filesystem::path> files,
                            Opener open) {
  jobs_.cancel(opening_);
  opening_ = jobs_.start(
      tr("Open %1").arg(name),
      [this, open = std::move(open), files, choice = usualFit_](const JobRunner::Handle& job) {
        const auto fail = [&](const Error& error) {
          job.post([this, sentence = sentenceOf(error)] { Q_EMIT failed(sentence); });
        };
        const JobContext context = contextOf(job);
        const auto model = engine_.model(choice.profile, {});
        if (model.failed()) return fail(model.error());
        auto source = open(model.value(), context.child(0.0, 1.0, "reading"));
        if (source.failed()) return fail(source.error());
        if (!source) return;
        auto shared = std::make_shared<const Source>(std::move(source).value());
        Scene scene;
        scene.model = model.value();
        scene.source = shared;
        scene.maps = FitPlanes(shared->measurements, {}, store_).maps;
        job.post([this, scene, files, choice] {
          take(scene, choice, QString::fromStdString(scene.source->name), files);
          startFit();
        });
      });
}

void Document::openMaps(const std::filesystem::path& path) {
  jobs_.cancel(opening_);
  const QString name = QString::fromStdString(path.filename().string());
  opening_ = jobs_.start(tr("Open %1").arg(name), [this, path, name](const JobRunner::Handle& job) {
    const auto fail = [&](const Error& error) {
      job.post([this, sentence = sentenceOf(error)] { Q_EMIT failed(sentence); });
    };
    const auto file = readMaps(path, PixelFormat::float32, store_, job.context);
    if (file.failed()) return fail(file.error());
    if (!file) return;
    const MapsAttributes& attributes = file.value().attributes;
    const auto model = attributes.profileJson.empty()
                           ? engine_.model(kDefaultProfile, path.string())
                           : engine_.modelFromText(attributes.profileJson, path.string());
    if (model.failed()) return fail(model.error());
    Scene scene;
    scene.model = model.value();
    scene.maps = file.value().maps;
    FitChoice choice = {model.value()->profile().name, FitMethod::refined, false};
    if (const auto method = fitMethodNamed(attributes.method, {})) choice.method = method.value();
    choice.shading = !file.value().shading.empty();
    job.post([this, scene, choice, name, path] {
      take(scene, choice, name, {path});
      fitted_ = true;
      Q_EMIT fitted();
    });
  });
}

void Document::take(Scene scene, const FitChoice& choice, const QString& name,
                    std::vector<std::filesystem::path> files) {
  cancelFit();
  scene_ = std::move(scene);
  choice_ = choice;
  name_ = name;
  sourceFiles_ = std::move(files);
  fitted_ = false;
  statistics_ = {};
  lastFit_.reset();
  history_ = {};
  Q_EMIT opened();
  Q_EMIT fitChoiceChanged();
}

void Document::fitWith(const FitChoice& choice) {
  const Status allowed = checkFitChoice(choice, *scene_->source);
  if (allowed.failed()) {
    Q_EMIT fitChoiceChanged();
    Q_EMIT failed(sentenceOf(allowed.error()));
    return;
  }
  if (choice == choice_ && (fitted_ || jobs_.isRunning(fitting_))) return;
  if (lastFit_ && choice == lastFit_->choice) return backToLastFit();
  choice_ = choice;
  startFit();
}

void Document::useNetwork(std::shared_ptr<const ChromophoreNetwork> network,
                          const std::string& profile) {
  engine_.addNetwork(std::move(network));
  choice_ = {profile, FitMethod::network, false};
  startFit();
}

void Document::startFit() {
  cancelFit();
  fitted_ = false;
  fitting_ =
      jobs_.start(tr("Fit %1").arg(name_),
                  [this, choice = choice_, scene = *scene_,
                   path = sourceFiles_.empty() ? std::filesystem::path() : sourceFiles_.front()](
                      const JobRunner::Handle& job) { fit(choice, scene, path, job); });
  Q_EMIT fitChoiceChanged();
}

void Document::cancelFit() {
  jobs_.cancel(std::exchange(fitting_, 0));
  mapsTimer_.stop();
}

void Document::fit(const FitChoice& choice, Scene scene, const std::filesystem::path& path,
                   const JobRunner::Handle& job) {
  SceneFitObserver observer;
  observer.begun = [this, post = job.post](const Scene& begun) {
    post([this, begun] { show(begun); });
  };
  observer.changed = [this, post = job.post] {
    post([this] {
      if (!mapsTimer_.isActive()) mapsTimer_.start();
    });
  };
  observer.view = [view = view_] { return view->get(); };
  const JobContext context = contextOf(job).child(0.0, 1.0, "preparing");
  const auto statistics = [&]() -> Result<FitStatistics> {
    CUTIS_TRY(model, engine_.model(choice.profile, {}));
    if (model != scene.model) {
      CUTIS_TRY(source, changeProfile(*scene.source, path, model, engine_, store_,
                                      context.child(0.0, 0.1)));
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
    return fitScene(scene, choice, engine_, store_, context.child(0.1, 1.0), observer);
  }();
  if (statistics.failed()) {
    job.post([this, sentence = sentenceOf(statistics.error())] {
      backToLastFit();
      Q_EMIT failed(sentence);
    });
  } else if (statistics) {
    job.post([this, result = statistics.value()] { completeFit(result); });
  }
}

void Document::show(const Scene& fitted) {
  const EditStack edits = scene_->edits;
  scene_ = fitted;
  scene_->edits = edits;
  Q_EMIT sceneReplaced();
}

void Document::completeFit(const FitStatistics& statistics) {
  statistics_ = statistics;
  fitted_ = true;
  lastFit_ = {choice_, *scene_, statistics};
  mapsTimer_.stop();
  Q_EMIT mapsChanged();
  Q_EMIT fitted();
}

void Document::backToLastFit() {
  cancelFit();
  if (!lastFit_) return;
  choice_ = lastFit_->choice;
  statistics_ = lastFit_->statistics;
  fitted_ = true;
  show(lastFit_->scene);
  Q_EMIT fitChoiceChanged();
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

void Document::setEdits(bool moving) {
  scene_->edits = history_.current().edits;
  Q_EMIT editsChanged(moving);
}

std::optional<Document::PixelSpectra> Document::spectraAt(int x, int y) const {
  if (!scene_ || !scene_->maps.state.bounds().contains(x, y)) return std::nullopt;
  const Rect pixel = {x, y, x + 1, y + 1};
  auto buffer = loadParameters(scene_->maps, pixel);
  if (!buffer || !buffer.value().present.front()) return std::nullopt;
  const auto parameters = [&] {
    ParameterVector vector;
    for (const Parameter k : kParameters) {
      vector[k] = double{buffer.value().values[static_cast<std::size_t>(k)].front()};
    }
    return vector;
  };
  PixelSpectra spectra;
  spectra.originalParameters = parameters();
  spectra.original = scene_->model->reflectance(spectra.originalParameters);
  if (!applyEdits(scene_->edits, scene_->model->profile().axes, pixel, 1, buffer.value())) {
    return std::nullopt;
  }
  spectra.editedParameters = parameters();
  spectra.edited = scene_->model->reflectance(spectra.editedParameters);
  return spectra;
}

}  // namespace cutis
