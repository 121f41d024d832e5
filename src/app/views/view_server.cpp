#include "src/app/views/view_server.h"

#include <utility>

namespace cutis {
namespace {

constexpr int kCoarserWhileMoving = 2;
// Longer than the pause between two moves of a hand; the sharp picture comes this much later.
constexpr int kRestMs = 30;

bool showsMaps(const ViewRequest& request) {
  return !isPhotograph(request.view);
}

bool showsEdits(const ViewRequest& request) {
  return showsMaps(request) && request.edits == nullptr;
}

}  // namespace

ViewWatch::~ViewWatch() {
  server_.watches_.erase(id_);
}

void ViewWatch::want(const ViewRequest& request) {
  if (request == request_) return;
  server_.postponeAverage();
  request_ = request;
  due_ = !request.rect.empty();
  averageDue_ = false;
  samples_ = nullptr;
  coarse_ = nullptr;
  server_.startNext();
}

void ViewWatch::setSeen(bool seen) {
  if (seen == seen_) return;
  seen_ = seen;
  if (seen) server_.startNext();
}

ViewServer::ViewServer(Document& document, Engine& engine, JobRunner& jobs, QObject* parent)
    : QObject(parent), document_(document), engine_(engine), jobs_(jobs) {
  restTimer_.setSingleShot(true);
  restTimer_.setInterval(kRestMs);
  connect(&restTimer_, &QTimer::timeout, this, &ViewServer::controlRests);
  // The part it was to make stays out of date until something changes; others may still succeed.
  connect(&jobs, &JobRunner::failed, this, [this](JobId job) {
    if (job != job_) return;
    job_ = 0;
    startNext();
  });
  connectDocument();
}

void ViewServer::connectDocument() {
  connect(&document_, &Document::opened, this, &ViewServer::forget);
  connect(&document_, &Document::mapsChanged, this, [this] {
    forgetSamples();
    invalidate(showsMaps);
  });
  connect(&document_, &Document::sceneReplaced, this, [this] {
    // A part of the old scene must not be taken for one of the new.
    cancelJob();
    forgetSamples();
    invalidate([](const ViewRequest&) { return true; });
  });
  connect(&document_, &Document::editsChanged, this, &ViewServer::editsChanged);
  // Means are made of what is complete.
  connect(&document_, &Document::fitted, this, &ViewServer::startNext);
}

void ViewServer::editsChanged(bool moving) {
  moving_ = moving;
  resting_ = false;
  moving ? restTimer_.start() : restTimer_.stop();
  // A part at full resolution that is out of date would only delay the next.
  if (moving && job_ != 0 && task_.quality != Quality::coarse) cancelJob();
  invalidate(showsEdits);
}

void ViewServer::controlRests() {
  resting_ = true;
  invalidate(showsEdits);
}

std::unique_ptr<ViewWatch> ViewServer::watch(ViewPriority priority, ViewWatch::Show show) {
  const std::uint64_t id = nextId_++;
  std::unique_ptr<ViewWatch> watch(new ViewWatch(*this, id, priority, std::move(show)));
  watches_.emplace(id, watch.get());
  return watch;
}

void ViewServer::setPicture(const PictureRequest& picture) {
  if (picture == picture_) return;
  picture_ = picture;
  forgetSamples();
  invalidate([](const ViewRequest& request) { return request.view == ViewKind::skin; });
}

bool ViewServer::isIdle() const {
  return job_ == 0 && !restTimer_.isActive() && mostUrgent() == nullptr && notAveraged() == nullptr;
}

void ViewServer::invalidate(const std::function<bool(const ViewRequest&)>& concerns) {
  for (const auto& [id, watch] : watches_) {
    if (!concerns(watch->request_) || watch->request_.rect.empty()) continue;
    watch->due_ = true;
    watch->averageDue_ = false;
  }
  postponeAverage();
  startNext();
}

void ViewServer::forgetSamples() {
  ++state_;
  skin_ = nullptr;
  for (const auto& [id, watch] : watches_) {
    watch->samples_ = nullptr;
    watch->coarse_ = nullptr;
  }
}

// Another document is open: requests were for pixels of the old one.
void ViewServer::forget() {
  cancelJob();
  moving_ = false;
  restTimer_.stop();
  forgetSamples();
  for (const auto& [id, watch] : watches_) {
    watch->request_ = {};
    watch->due_ = false;
    watch->averageDue_ = false;
  }
}

void ViewServer::cancelJob() {
  jobs_.cancel(std::exchange(job_, 0));
}

void ViewServer::postponeAverage() {
  if (job_ == 0 || task_.quality != Quality::averaged) return;
  cancelJob();
  const auto found = watches_.find(task_.watch);
  if (found != watches_.end()) found->second->averageDue_ = !found->second->due_;
}

bool ViewServer::isServed(const ViewWatch& watch) const {
  return watch.seen_ && (!moving_ || watch.priority_ == ViewPriority::detail);
}

bool ViewServer::willBeAveraged(const ViewWatch& watch, const ViewRequest& request) const {
  return watch.priority_ == ViewPriority::detail && request.step > 1 && canBeAveraged(request.view);
}

ViewWatch* ViewServer::mostUrgent() const {
  ViewWatch* urgent = nullptr;
  for (const auto& [id, watch] : watches_) {
    if (!watch->due_ || !isServed(*watch)) continue;
    if (urgent == nullptr || watch->priority_ < urgent->priority_) urgent = watch;
  }
  return urgent;
}

ViewWatch* ViewServer::notAveraged() const {
  if (!document_.isFitted() || isCoarse()) return nullptr;
  for (const auto& [id, watch] : watches_) {
    if (watch->averageDue_ && isServed(*watch)) return watch;
  }
  return nullptr;
}

void ViewServer::startNext() {
  if (job_ != 0 || !document_.isOpen()) return;
  if (ViewWatch* watch = mostUrgent()) {
    watch->due_ = false;
    start(*watch, isCoarse() ? Quality::coarse : Quality::sharp);
  } else if (ViewWatch* rough = notAveraged()) {
    rough->averageDue_ = false;
    start(*rough, Quality::averaged);
  }
}

void ViewServer::start(ViewWatch& watch, Quality quality) {
  const bool hasMeans = willBeAveraged(watch, watch.request_);
  const bool isDraft =
      quality == Quality::coarse || (quality == Quality::sharp && document_.isFitted() && hasMeans);
  task_ = {watch.id_, quality,        isDraft ? ViewAccuracy::draft : ViewAccuracy::exact,
           hasMeans,  watch.request_, state_};
  Scene scene = document_.scene();
  if (watch.request_.edits != nullptr) scene.edits = *watch.request_.edits;
  job_ = jobs_.startQuiet(
      [this, task = task_, known = Made{nullptr, watch.samples_, watch.coarse_, skin_},
       scene = std::move(scene), picture = picture_](const JobRunner::Handle& job) {
        auto made = make(task, known, scene, picture, job.context);
        if (made.failed()) {
          job.post([this, sentence = QString::fromStdString(made.error().text())] {
            job_ = 0;
            Q_EMIT failed(sentence);
            startNext();
          });
        } else if (made) {
          job.post([this, task, result = std::move(made).value()] { deliver(task, result); });
        }
      });
}

Result<ViewServer::Made> ViewServer::make(const Task& task, Made known, const Scene& scene,
                                          const PictureRequest& picture,
                                          const JobContext& context) const {
  const bool isAveraged = task.quality == Quality::averaged;
  if (known.samples == nullptr && !isAveraged) {
    CUTIS_TRY(samples,
              ViewSamples::load(scene, engine_, picture, task.request, known.skin, context));
    if (samples.skin() != nullptr) known.skin = samples.skin();
    known.samples = std::make_shared<const ViewSamples>(std::move(samples));
  }
  // While there is time for it: the next move will ask for them.
  const bool isCoarse = task.quality == Quality::coarse;
  if ((isCoarse || isAveraged) && known.coarse == nullptr && known.samples != nullptr) {
    CUTIS_TRY(coarse, known.samples->thinned(kCoarserWhileMoving, context));
    known.coarse = std::make_shared<const ViewSamples>(std::move(coarse));
  }
  if (isAveraged) {
    known.part = nullptr;
    if (!task.hasMeans) return known;
    CUTIS_TRY(part, renderAveraged(scene, engine_, picture, task.request, context));
    if (known.samples != nullptr) part.marks = known.samples->marks();
    known.part = std::make_shared<const ViewPart>(std::move(part));
    return known;
  }
  CUTIS_TRY(part,
            (isCoarse ? known.coarse : known.samples)->render(scene.edits, task.accuracy, context));
  known.part = std::make_shared<const ViewPart>(std::move(part));
  return known;
}

void ViewServer::deliver(const Task& task, const Made& made) {
  job_ = 0;
  if (state_ == task.state) skin_ = made.skin;
  // The watch may be gone, or want another view by now.
  const auto found = watches_.find(task.watch);
  if (found != watches_.end() && found->second->request_.view == task.request.view) {
    ViewWatch& watch = *found->second;
    if (watch.request_ == task.request && state_ == task.state) {
      watch.samples_ = made.samples;
      watch.coarse_ = made.coarse;
    }
    watch.averageDue_ =
        task.quality == Quality::sharp && !watch.due_ && watch.priority_ == ViewPriority::detail;
    if (made.part != nullptr) watch.show_(made.part);
  }
  startNext();
}

}  // namespace cutis
