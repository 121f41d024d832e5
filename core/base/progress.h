#pragma once  // internal to core/base

// Progress that composes by fractions.
//
// A job hands `progress.child(0.2, 0.9, "melanin")` to one of its stages; the stage reports 0…1 and
// knows nothing of the whole. Copies are cheap and report to the same place.

#include <functional>
#include <memory>
#include <string>
#include <utility>

namespace cutis {

class Progress {
 public:
  // fraction in [0, 1] of the whole job; stage is the name of what is being done. Called from
  // whichever thread reports, several at once: the sink does its own locking and returns quickly.
  using Sink = std::function<void(double fraction, const std::string& stage)>;

  // Reports to nobody.
  Progress() = default;
  explicit Progress(Sink sink, std::string stage = {})
      : sink_(std::make_shared<const Sink>(std::move(sink))), stage_(std::move(stage)) {}

  // The part [from, to] of this progress. An empty stage keeps the current name.
  Progress child(double from, double to, std::string stage = {}) const {
    Progress part = *this;
    part.from_ = from_ + from * (to_ - from_);
    part.to_ = from_ + to * (to_ - from_);
    if (!stage.empty()) part.stage_ = std::move(stage);
    return part;
  }

  // fraction in [0, 1] of this part.
  void report(double fraction) const {
    if (sink_) (*sink_)(from_ + fraction * (to_ - from_), stage_);
  }

 private:
  std::shared_ptr<const Sink> sink_;
  std::string stage_;
  double from_ = 0.0;
  double to_ = 1.0;
};

}  // namespace cutis
