#include "src/cli/console.h"

#include <algorithm>
#include <cmath>

#include "core/base/echoed_text.h"
#include "src/files/system/error_stream.h"
#include "src/files/system/platform.h"

namespace cutis {
namespace {

constexpr std::chrono::milliseconds kBetweenUpdates(100);
// Before this nobody can tell how long it will take.
constexpr double kFirstEstimateSeconds = 1.0;
constexpr double kFirstEstimateFraction = 0.02;

}  // namespace

Console::Console() : isTerminal_(standardErrorIsTerminal()), start_(Clock::now()), shown_(start_) {}

void Console::write(const std::string& text) {
  writeError(text);
}

void Console::clearLine() {
  if (lineShown_) write("\r\x1b[K");
  lineShown_ = false;
}

void Console::error(const std::string& text) {
  const std::scoped_lock lock(mutex_);
  clearLine();
  write("cutis-cli: " + onOneLine(text) + "\n");
}

void Console::note(const std::string& sentence) {
  if (quiet_) return;
  const std::scoped_lock lock(mutex_);
  clearLine();
  write("cutis-cli: note: " + onOneLine(sentence) + "\n");
}

void Console::progress(double fraction, const std::string& stage) {
  if (!isTerminal_ || quiet_) return;
  const std::scoped_lock lock(mutex_);
  const auto now = Clock::now();
  if (now - shown_ < kBetweenUpdates) return;
  shown_ = now;
  const double share = std::clamp(fraction, 0.0, 1.0);
  std::string line = stage.empty() ? "working" : stage;
  line += ", " + std::to_string(std::lround(100.0 * share)) + " %";
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  if (elapsed > kFirstEstimateSeconds && share > kFirstEstimateFraction) {
    line += ", " + durationText(elapsed * (1.0 - share) / share) + " left";
  }
  write("\r" + onOneLine(line) + "\x1b[K");
  lineShown_ = true;
}

void Console::clear() {
  const std::scoped_lock lock(mutex_);
  clearLine();
}

std::string durationText(double seconds) {
  const long whole = std::lround(std::max(0.0, seconds));
  if (whole < 60) return std::to_string(whole) + " s";
  const long minutes = whole / 60;
  if (minutes < 60) return std::to_string(minutes) + " min " + std::to_string(whole % 60) + " s";
  return std::to_string(minutes / 60) + " h " + std::to_string(minutes % 60) + " min";
}

}  // namespace cutis
