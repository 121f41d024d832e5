#include "src/app/layer_server.h"

#include <algorithm>
#include <utility>

namespace cutis {
namespace {

// While a control is dragged only these are served: the picture itself, not its thumbnails.
constexpr int kPictureItself = 0;
constexpr int kCoarserWhileMoving = 2;

bool showsMaps(LayerKind layer) {
  return layer != LayerKind::photograph;
}

}  // namespace

LayerWatch::~LayerWatch() {
  server_.remove(this);
}

void LayerWatch::want(const LayerRequest& request) {
  if (request == request_) return;
  request_ = request;
  due_ = !request.rect.empty();
  server_.startNext();
}

LayerServer::LayerServer(Document& document, Engine& engine, JobRunner& jobs, QObject* parent)
    : QObject(parent), document_(document), engine_(engine), jobs_(jobs) {
  connect(&document, &Document::opened, this, &LayerServer::forget);
  connect(&document, &Document::mapsChanged, this, [this] { invalidate(showsMaps); });
  connect(&document, &Document::sceneReplaced, this, [this] {
    // A part of the old scene must not be taken for one of the new.
    jobs_.cancel(job_);
    job_ = 0;
    invalidate([](LayerKind) { return true; });
  });
  connect(&document, &Document::editsChanged, this, [this](bool moving) {
    moving_ = moving;
    // A part at full resolution that is out of date would only delay the next.
    if (moving && !jobIsCoarse_) {
      jobs_.cancel(job_);
      job_ = 0;
    }
    invalidate(showsMaps);
  });
}

std::unique_ptr<LayerWatch> LayerServer::watch(int priority, LayerWatch::Show show) {
  std::unique_ptr<LayerWatch> watch(new LayerWatch(*this, priority, std::move(show)));
  watches_.push_back(watch.get());
  return watch;
}

void LayerServer::setPicture(const PictureRequest& picture) {
  if (picture == picture_) return;
  picture_ = picture;
  invalidate([](LayerKind layer) { return layer == LayerKind::skin; });
}

bool LayerServer::isIdle() const {
  return job_ == 0 && mostUrgent() == nullptr;
}

void LayerServer::invalidate(const std::function<bool(LayerKind)>& concerns) {
  for (LayerWatch* watch : watches_) {
    if (concerns(watch->request_.layer) && !watch->request_.rect.empty()) watch->due_ = true;
  }
  startNext();
}

// Another document is open: requests were for pixels of the old one.
void LayerServer::forget() {
  jobs_.cancel(job_);
  job_ = 0;
  moving_ = false;
  for (LayerWatch* watch : watches_) {
    watch->request_ = {};
    watch->due_ = false;
  }
}

void LayerServer::remove(const LayerWatch* watch) {
  std::erase(watches_, watch);
}

LayerWatch* LayerServer::mostUrgent() const {
  LayerWatch* urgent = nullptr;
  for (LayerWatch* watch : watches_) {
    if (!watch->due_ || (moving_ && watch->priority_ > kPictureItself)) continue;
    if (urgent == nullptr || watch->priority_ < urgent->priority_) urgent = watch;
  }
  return urgent;
}

void LayerServer::startNext() {
  if (job_ != 0 || !document_.isOpen()) return;
  LayerWatch* watch = mostUrgent();
  if (watch == nullptr) {
    Q_EMIT becameIdle();
    return;
  }
  watch->due_ = false;
  jobIsCoarse_ = moving_;
  LayerRequest request = watch->request_;
  if (moving_) request.step *= kCoarserWhileMoving;
  job_ = jobs_.startQuiet([this, watch, request, scene = document_.scene(),
                           picture = picture_](const JobRunner::Handle& job) {
    auto part = renderLayer(scene, engine_, picture, request, job.context);
    if (part.failed()) {
      job.post([this, sentence = QString::fromStdString(part.error().text())] {
        job_ = 0;
        Q_EMIT failed(sentence);
        startNext();
      });
    } else if (part) {
      auto shared = std::make_shared<const LayerPart>(std::move(part).value());
      job.post([this, watch, shared] { deliver(watch, shared); });
    }
  });
}

void LayerServer::deliver(const LayerWatch* watch, const std::shared_ptr<const LayerPart>& part) {
  job_ = 0;
  // The watch may be gone, or want another layer by now.
  const bool wanted = std::find(watches_.begin(), watches_.end(), watch) != watches_.end() &&
                      watch->request_.layer == part->request.layer;
  if (wanted) watch->show_(part);
  startNext();
}

}  // namespace cutis
