#pragma once

// What the program says while it works, on the standard error: errors, notes, and on a terminal one
// line of progress that is gone in the end.
//
// Thread-safe. A text never takes more than one line, whatever is in the names of files.

#include <chrono>
#include <mutex>
#include <string>

#include "core/base/result.h"

namespace cutis {

class Console {
 public:
  Console();

  void setQuiet(bool quiet) { quiet_ = quiet; }

  // "cutis-cli: place: message"
  void error(const std::string& text);
  // "cutis-cli: note: sentence"
  void note(const std::string& sentence);
  // fraction in [0, 1] of the whole; shown a few times a second.
  void progress(double fraction, const std::string& stage);
  // Takes the line of progress away.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;

  void write(const std::string& text);
  void clearLine();

  const bool isTerminal_;
  bool quiet_ = false;
  std::mutex mutex_;
  bool lineShown_ = false;
  Clock::time_point start_;
  Clock::time_point shown_;
};

// "12 s", "3 min 5 s", "2 h 10 min"
std::string durationText(double seconds);

}  // namespace cutis
