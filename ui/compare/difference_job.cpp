#include "ui/compare/difference_job.h"

#include <utility>

#include "core/render/color_difference.h"

namespace cutis {
namespace {

using Part = DifferenceJob::Part;

PictureBuffer atStep(const ViewPart& part, int step) {
  const int n = step / part.request.step;
  return n == 1 ? part.pixels : thinned(part.pixels, n);
}

bool isOfOnePlace(const ViewPart& a, const ViewPart& b) {
  const int coarse = std::max(a.request.step, b.request.step);
  const int fine = std::min(a.request.step, b.request.step);
  return a.request.rect == b.request.rect && coarse % fine == 0 &&
         a.pixels.channels.size() == b.pixels.channels.size();
}

Result<Part> differenceOf(const ViewPart& first, const ViewPart& second,
                          const JobContext& context) {
  auto part = std::make_shared<ViewPart>();
  part->request = first.request;
  part->request.step = std::max(first.request.step, second.request.step);
  const PictureBuffer a = atStep(first, part->request.step);
  const PictureBuffer b = atStep(second, part->request.step);
  if (a.channels.size() == 3) {
    CUTIS_TRY(difference, colorDifference(a, b, context));
    part->pixels = std::move(difference);
  } else {
    part->pixels = absoluteDifference(a, b);
  }
  return Part(std::move(part));
}

}  // namespace

DifferenceJob::DifferenceJob(JobRunner& jobs, Show show) : jobs_(jobs), show_(std::move(show)) {}

DifferenceJob::~DifferenceJob() {
  stop();
}

void DifferenceJob::start(const Part& first, const Part& second) {
  stop();
  if (!first || !second || first->pixels.channels.empty() || !isOfOnePlace(*first, *second)) return;
  job_ = jobs_.startQuiet([this, first, second](const JobRunner::Handle& job) {
    auto difference = differenceOf(*first, *second, job.context);
    if (!difference) return;  // stopped
    job.post([this, part = std::move(difference).value()] {
      job_ = 0;
      show_(part);
    });
  });
}

void DifferenceJob::stop() {
  jobs_.cancel(std::exchange(job_, 0));
}

}  // namespace cutis
