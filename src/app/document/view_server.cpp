#include "src/app/document/view_server.h"

#include <utility>

namespace cutis {
namespace {

constexpr int kCoarserWhileMoving = 2;

bool showsMaps(ViewKind view) {
  return view != ViewKind::photograph;
}

}  // namespace

ViewWatch::~ViewWatch() {
  server_.watches_.erase(id_);
}

void ViewWatch::want(const ViewRequest& request) {
  if (request == request_) return;
  request_ = request;
  due_ = !request.rect.empty();
  server_.startNext();
}

void ViewWatch::setSeen(bool seen) {
  if (seen == seen_) return;
  seen_ = seen;
  if (seen) server_.startNext();
}

ViewServer::ViewServer(Document& document, Engine& engine, JobRunner& jobs, QObject* parent)
    : QObject(parent), document_(document), engine_(engine), jobs_(jobs) {
  connect(&document, &Document::opened, this, &ViewServer::forget);
  // The part it was to make stays out of date until something changes; others may still succeed.
  connect(&jobs, &JobRunner::failed, this, [this](JobId job) {
    if (job != job_) return;
    job_ = 0;
    startNext();
  });
  connect(&document, &Document::mapsChanged, this, [this] { invalidate(showsMaps); });
  connect(&document, &Document::sceneReplaced, this, [this] {
    // A part of the old scene must not be taken for one of the new.
    jobs_.cancel(job_);
    job_ = 0;
    invalidate([](ViewKind) { return true; });
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

std::unique_ptr<ViewWatch> ViewServer::watch(ViewPriority priority, ViewWatch::Show show) {
  const std::uint64_t id = nextId_++;
  std::unique_ptr<ViewWatch> watch(new ViewWatch(*this, id, priority, std::move(show)));
  watches_.emplace(id, watch.get());
  return watch;
}

void ViewServer::setPicture(const PictureRequest& picture) {
  if (picture == picture_) return;
  picture_ = picture;
  invalidate([](ViewKind view) { return view == ViewKind::skin; });
}

bool ViewServer::isIdle() const {
  return job_ == 0 && mostUrgent() == nullptr;
}

void ViewServer::invalidate(const std::function<bool(ViewKind)>& concerns) {
  for (const auto& [id, watch] : watches_) {
    if (concerns(watch->request_.view) && !watch->request_.rect.empty()) watch->due_ = true;
  }
  startNext();
}

// Another document is open: requests were for pixels of the old one.
void ViewServer::forget() {
  jobs_.cancel(job_);
  job_ = 0;
  moving_ = false;
  for (const auto& [id, watch] : watches_) {
    watch->request_ = {};
    watch->due_ = false;
  }
}

ViewWatch* ViewServer::mostUrgent() const {
  ViewWatch* urgent = nullptr;
  for (const auto& [id, watch] : watches_) {
    if (!watch->due_ || !watch->seen_ || (moving_ && watch->priority_ != ViewPriority::detail))
      continue;
    if (urgent == nullptr || watch->priority_ < urgent->priority_) urgent = watch;
  }
  return urgent;
}

void ViewServer::startNext() {
  if (job_ != 0 || !document_.isOpen()) return;
  ViewWatch* watch = mostUrgent();
  if (watch == nullptr) return;
  watch->due_ = false;
  jobIsCoarse_ = moving_;
  ViewRequest request = watch->request_;
  if (moving_) request.step *= kCoarserWhileMoving;
  job_ = jobs_.startQuiet([this, id = watch->id_, request, scene = document_.scene(),
                           picture = picture_](const JobRunner::Handle& job) {
    auto part = renderView(scene, engine_, picture, request, job.context);
    if (part.failed()) {
      job.post([this, sentence = QString::fromStdString(part.error().text())] {
        job_ = 0;
        Q_EMIT failed(sentence);
        startNext();
      });
    } else if (part) {
      auto shared = std::make_shared<const ViewPart>(std::move(part).value());
      job.post([this, id, shared] { deliver(id, shared); });
    }
  });
}

void ViewServer::deliver(std::uint64_t watch, const std::shared_ptr<const ViewPart>& part) {
  job_ = 0;
  // The watch may be gone, or want another view by now.
  const auto found = watches_.find(watch);
  if (found != watches_.end() && found->second->request_.view == part->request.view) {
    found->second->show_(part);
  }
  startNext();
}

}  // namespace cutis
