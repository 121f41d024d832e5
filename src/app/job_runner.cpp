#include "src/app/job_runner.h"

#include <algorithm>
#include <exception>
#include <mutex>
#include <new>
#include <utility>

namespace cutis {
namespace {

constexpr int kProgressIntervalMs = 33;

// Written by the job's threads, read by the interface.
struct SharedProgress {
  std::mutex mutex;
  std::string stage;
  double fraction = 0.0;
  bool changed = false;
};

// Does the work; what it throws, in words for the user, or nothing. An exception that leaves a
// thread ends the program with everything that is open in it.
QString failureOf(const std::function<void(const JobRunner::Handle&)>& work,
                  const JobRunner::Handle& handle) noexcept {
  try {
    work(handle);
    return {};
  } catch (const std::bad_alloc&) {
    return JobRunner::tr(
        "There was not enough memory for this; close other programs or open a smaller picture");
  } catch (const std::exception& error) {
    return JobRunner::tr("Internal error (%1). Your document is not affected.")
        .arg(QString::fromUtf8(error.what()).simplified());
  } catch (...) {
    return JobRunner::tr("Internal error. Your document is not affected.");
  }
}

}  // namespace

struct JobRunner::Job {
  JobId id = 0;
  QString name;
  bool quiet = false;
  std::stop_source stop;
  std::shared_ptr<SharedProgress> progress = std::make_shared<SharedProgress>();
  QElapsedTimer since;
  std::thread thread;
  bool cancelled = false;
};

JobRunner::JobRunner(QObject* parent) : QObject(parent) {
  progressTimer_.setInterval(kProgressIntervalMs);
  connect(&progressTimer_, &QTimer::timeout, this, &JobRunner::reportProgress);
}

JobRunner::~JobRunner() {
  stopAll();
}

void JobRunner::stopAll() {
  for (const auto& job : jobs_)
    job->stop.request_stop();
  for (const auto& job : jobs_)
    job->thread.join();
  jobs_.clear();
}

JobId JobRunner::start(const QString& name, std::function<void(const Handle&)> work) {
  return launch(name, false, std::move(work));
}

JobId JobRunner::startQuiet(std::function<void(const Handle&)> work) {
  return launch({}, true, std::move(work));
}

JobId JobRunner::launch(const QString& name, bool quiet, std::function<void(const Handle&)> work) {
  auto job = std::make_unique<Job>();
  const JobId id = nextId_++;
  job->id = id;
  job->name = name;
  job->quiet = quiet;
  job->since.start();

  Handle handle;
  handle.context.stop = job->stop.get_token();
  handle.context.progress =
      Progress([shared = job->progress](double fraction, const std::string& stage) {
        const std::scoped_lock lock(shared->mutex);
        // Several threads report; a late one does not take the bar back within a stage.
        if (stage == shared->stage && fraction < shared->fraction) return;
        shared->stage = stage;
        shared->fraction = fraction;
        shared->changed = true;
      });
  handle.post = [this, stop = job->stop.get_token()](std::function<void()> action) {
    QMetaObject::invokeMethod(
        this,
        [stop, action = std::move(action)] {
          if (!stop.stop_requested()) action();
        },
        Qt::QueuedConnection);
  };
  job->thread = std::thread([this, id, handle, work = std::move(work)] {
    const QString failure = failureOf(work, handle);
    QMetaObject::invokeMethod(
        this, [this, id, failure] { retire(id, failure); }, Qt::QueuedConnection);
  });
  jobs_.push_back(std::move(job));
  if (!quiet) {
    Q_EMIT started(id, name);
    progressTimer_.start();
  }
  return id;
}

void JobRunner::cancel(JobId id) {
  Job* job = find(id);
  if (job == nullptr || job->cancelled) return;
  job->cancelled = true;
  job->stop.request_stop();
  if (!job->quiet) Q_EMIT finished(id);
}

bool JobRunner::isBusy() const {
  return std::any_of(jobs_.begin(), jobs_.end(),
                     [](const auto& job) { return !job->cancelled && !job->quiet; });
}

bool JobRunner::isIdle() const {
  return std::all_of(jobs_.begin(), jobs_.end(), [](const auto& job) { return job->cancelled; });
}

bool JobRunner::isRunning(JobId id) const {
  const Job* job = find(id);
  return job != nullptr && !job->cancelled;
}

void JobRunner::reportProgress() {
  for (const auto& job : jobs_) {
    if (job->quiet || job->cancelled) continue;
    double fraction = 0.0;
    QString stage;
    {
      const std::scoped_lock lock(job->progress->mutex);
      if (!job->progress->changed) continue;
      job->progress->changed = false;
      fraction = job->progress->fraction;
      stage = QString::fromStdString(job->progress->stage);
    }
    // The first percents say little about the rest.
    constexpr double kEnoughToEstimate = 0.05;
    const double seconds = static_cast<double>(job->since.elapsed()) * 1e-3;
    const double left = fraction < kEnoughToEstimate ? -1.0 : seconds * (1.0 - fraction) / fraction;
    Q_EMIT progressed(job->id, stage, fraction, left);
  }
}

void JobRunner::retire(JobId id, const QString& failure) {
  const auto found =
      std::find_if(jobs_.begin(), jobs_.end(), [id](const auto& job) { return job->id == id; });
  if (found == jobs_.end()) return;
  const std::unique_ptr<Job> job = std::move(*found);
  jobs_.erase(found);
  job->thread.join();  // its last act was to call this
  if (!failure.isEmpty() && !job->cancelled) Q_EMIT failed(id, failure);
  if (!job->quiet && !job->cancelled) Q_EMIT finished(id);
  if (!isBusy()) progressTimer_.stop();
  if (isIdle()) Q_EMIT idle();
}

JobRunner::Job* JobRunner::find(JobId id) const {
  const auto found =
      std::find_if(jobs_.begin(), jobs_.end(), [id](const auto& job) { return job->id == id; });
  return found == jobs_.end() ? nullptr : found->get();
}

}  // namespace cutis
