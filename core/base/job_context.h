#pragma once

// What a long operation is given besides its inputs: a way to be asked to stop, a place to report
// progress and a place to say something the user should know although all went well.

#include <functional>
#include <stop_token>
#include <string>

#include "core/base/progress.h"

namespace cutis {

// Hears one sentence, no final full stop. Called from any thread; may be empty.
using Notice = std::function<void(const std::string& sentence)>;

struct JobContext {
  // Checked at least every 0.05 s by everything that takes longer. A stopped operation returns
  // Cancelled and leaves nothing behind.
  std::stop_token stop;
  Progress progress;
  Notice notice;

  bool stopRequested() const { return stop.stop_requested(); }
  void say(const std::string& sentence) const {
    if (notice) notice(sentence);
  }
  // The same context, reporting to a part of the progress.
  JobContext child(double from, double to, std::string stage = {}) const {
    return {stop, progress.child(from, to, std::move(stage)), notice};
  }
};

}  // namespace cutis
