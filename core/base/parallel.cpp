#include "core/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <mutex>
#include <new>
#include <optional>

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace cutis {
namespace {

Status guarded(const std::function<Status(std::size_t)>& work, std::size_t i) try {
  return work(i);
} catch (const std::bad_alloc&) {
  return resourceError("", "not enough memory; use a smaller picture or close other programs");
}

}  // namespace

Status parallelFor(std::size_t count, const JobContext& context,
                   const std::function<Status(std::size_t)>& work) {
  std::mutex mutex;
  std::optional<Failure> failure;
  std::atomic<std::size_t> failedPiece = count;  // lowest so far
  std::mutex progressMutex;
  std::size_t done = 0;

  tbb::parallel_for(
      std::size_t{0}, count,
      [&](std::size_t i) {
        // A failed piece stops only later ones: an earlier one may still fail first.
        if (context.stopRequested() || i > failedPiece) return;
        const Status status = guarded(work, i);
        if (!status) {
          const std::scoped_lock lock(mutex);
          if (i < failedPiece) {
            failedPiece = i;
            failure = status.failure();
          }
          return;
        }
        // Counted and reported in one step: a thread that was held up in between would report less
        // than has been reported already.
        const std::scoped_lock lock(progressMutex);
        context.progress.report(static_cast<double>(++done) / static_cast<double>(count));
      },
      tbb::simple_partitioner());

  if (failure) return *failure;
  if (context.stopRequested()) return Cancelled{};
  return {};
}

int parallelThreadCount() {
  const auto allowed =
      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  return std::min(tbb::this_task_arena::max_concurrency(), static_cast<int>(allowed));
}

}  // namespace cutis
