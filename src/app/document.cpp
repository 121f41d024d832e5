#include "src/app/document.h"

#include <array>
#include <utility>

#include "core/fit/coarse_fit.h"
#include "core/skin/parameter_buffer.h"
#include "src/app/exposure.h"
#include "src/files/csv.h"
#include "src/files/profile_file.h"
#include "src/images/capture_file.h"
#include "src/images/maps_file.h"

namespace cutis {
namespace {

// Above this, tiles go to disk: a large texture must not push everything else out of memory.
constexpr std::size_t kMemoryForPlanes = std::size_t{2} << 30;
constexpr int kMapsIntervalMs = 50;

QString sentenceOf(const Error& error) { return QString::fromStdString(error.text()); }

}  // namespace

Document::Document(Engine& engine, JobRunner& jobs, QObject* parent)
    : QObject(parent),
      engine_(engine),
      jobs_(jobs),
      store_(std::make_shared<TileStore>(kMemoryForPlanes)) {
  mapsTimer_.setSingleShot(true);
  mapsTimer_.setInterval(kMapsIntervalMs);
  connect(&mapsTimer_, &QTimer::timeout, this, &Document::mapsChanged);
}

void Document::openSample() {
  startOpening(tr("Sample face patch"), {},
               [store = store()](const auto& model, const JobContext& context) {
                 return cutis::openSample(*model, store, context);
               });
}

void Document::open(const std::filesystem::path& path) {
  if (!looksLikeCapture(path) && isMapsFile(path)) return openMaps(path);
  startOpening(QString::fromStdString(path.filename().string()), {path},
               [this, path](const auto& model, const JobContext& context) {
                 return openExposed(path, model, context);
               });
}

Result<Source> Document::openExposed(const std::filesystem::path& path,
                                     const std::shared_ptr<const SkinModel>& model,
                                     const JobContext& context) {
  CUTIS_TRY(source, openSource(path, {}, *model, store_, context.child(0.0, 0.4)));
  if (!source.image) return std::move(source);
  const Measurements& measurements = source.measurements;
  CUTIS_TRY(solver, engine_.solver(model, measurements.rig, {}, context.child(0.4, 0.5)));
  CUTIS_TRY(choice, chooseExposure(measurements, *solver, context.child(0.5, 0.6, "exposure")));
  if (choice.exposure == 1.0) return std::move(source);
  SourceOptions exposed;
  exposed.exposure = choice.exposure;
  context.say("Read at exposure " + formatNumber(choice.exposure, 3) + ", which brings " +
              formatNumber(100.0 * choice.inside, 2) +
              " % of the texture into the range of skin colours");
  return openSource(path, exposed, *model, store_, context.child(0.6, 1.0));
}

void Document::startOpening(const QString& name, std::vector<std::filesystem::path> files,
                            Opener open) {
  jobs_.cancel(opening_);
  opening_ = jobs_.start(tr("Open %1").arg(name), [this, open = std::move(open), files](
                                                      const JobRunner::Handle& job) {
    const auto fail = [&](const Error& error) {
      job.post([this, sentence = sentenceOf(error)] { Q_EMIT failed(sentence); });
    };
    JobContext context = job.context;
    context.notice = [this, post = job.post](const std::string& sentence) {
      post([this, text = QString::fromStdString(sentence)] { Q_EMIT noticed(text); });
    };
    const auto model = engine_.model(kDefaultProfile, {});
    if (model.failed()) return fail(model.error());
    auto source = open(model.value(), context.child(0.0, 1.0, "reading"));
    if (source.failed()) return fail(source.error());
    if (!source) return;
    auto shared = std::make_shared<const Source>(std::move(source).value());
    Scene scene;
    scene.model = model.value();
    scene.source = shared;
    const FitPlanes planes(shared->measurements, {}, store_);
    scene.maps = planes.maps;
    job.post([this, scene, files] {
      take(scene, QString::fromStdString(scene.source->name), files);
      startFit();
    });
  });
}

void Document::openMaps(const std::filesystem::path& path) {
  jobs_.cancel(opening_);
  const QString name = QString::fromStdString(path.filename().string());
  opening_ = jobs_.start(tr("Open %1").arg(name), [this, path, name](
                                                      const JobRunner::Handle& job) {
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
    job.post([this, scene, name, path] {
      take(scene, name, {path});
      fitted_ = true;
      Q_EMIT fitted();
    });
  });
}

void Document::take(Scene scene, const QString& name, std::vector<std::filesystem::path> files) {
  jobs_.cancel(fitting_);
  scene_ = std::move(scene);
  name_ = name;
  sourceFiles_ = std::move(files);
  fitted_ = false;
  statistics_ = {};
  history_ = {};
  Q_EMIT opened();
}

void Document::startFit() {
  fitting_ = jobs_.start(tr("Fit %1").arg(name_), [this, scene = *scene_, view = view_](
                                                      const JobRunner::Handle& job) {
    const auto fail = [&](const Error& error) {
      job.post([this, sentence = sentenceOf(error)] { Q_EMIT failed(sentence); });
    };
    const Measurements& measurements = scene.source->measurements;
    const auto solver = engine_.solver(scene.model, measurements.rig, {},
                                       job.context.child(0.0, 0.1, "preparing"));
    if (solver.failed()) return fail(solver.error());
    if (!solver) return;
    FitPlanes planes;
    planes.maps = scene.maps;
    FitObserver observer;
    observer.finished = [this, post = job.post](const Rect&) {
      post([this] {
        if (!mapsTimer_.isActive()) mapsTimer_.start();
      });
    };
    observer.view = [view] { return view->get(); };
    const Status coarse = runCoarseFit(measurements, *solver.value(), scene.maps,
                                       job.context.child(0.1, 0.15, "first impression"),
                                       observer.finished);
    if (coarse.failed()) return fail(coarse.error());
    const auto statistics = runFit(measurements, *solver.value(), planes,
                                   job.context.child(0.15, 1.0, solver.value()->stage()), observer);
    if (statistics.failed()) return fail(statistics.error());
    if (!statistics) return;
    job.post([this, result = statistics.value()] {
      statistics_ = result;
      fitted_ = true;
      mapsTimer_.stop();
      Q_EMIT mapsChanged();
      Q_EMIT fitted();
    });
  });
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
