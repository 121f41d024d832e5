#include "tests/src/cli/program_run.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <deque>
#include <iostream>
#include <random>

#include <QThread>

namespace cutis::test {

namespace fs = std::filesystem;

namespace {

constexpr int kTimeoutMs = 120000;
constexpr char kCache[] = "cache";

// A fixture that does not work is no test result.
template <typename T>
T need(Result<T> result) {
  if (result) return std::move(result).value();
  std::cerr << (result.failed() ? result.error().text() : "cancelled") << "\n";
  std::abort();
}

Outcome outcomeOf(QProcess& process) {
  // Not running any more also means that it ended before anyone waited.
  if (!process.waitForFinished(kTimeoutMs) && process.state() != QProcess::NotRunning) {
    process.kill();
    process.waitForFinished();
    return {-1, {}, "did not end"};
  }
  const bool ended = process.exitStatus() == QProcess::NormalExit;
  return {ended ? process.exitCode() : -1, process.readAllStandardOutput().toStdString(),
          process.readAllStandardError().toStdString()};
}

}  // namespace

std::unique_ptr<QProcess> ProgramRun::start(const QString& commandLine) const {
  auto process = std::make_unique<QProcess>();
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.insert("XDG_CACHE_HOME", QString::fromStdString((folder_ / kCache).string()));
  environment.remove("OCIO");
  process->setProcessEnvironment(environment);
  process->setWorkingDirectory(QString::fromStdString(folder_.path().string()));
  process->start(CUTIS_CLI, commandLine.split(' ', Qt::SkipEmptyParts));
  return process;
}

Outcome ProgramRun::run(const QString& commandLine) const {
  return outcomeOf(*start(commandLine));
}

std::vector<Outcome> ProgramRun::runAll(const std::vector<QString>& commandLines) const {
  const auto atOnce = static_cast<std::size_t>(std::max(2, QThread::idealThreadCount()));
  std::deque<std::unique_ptr<QProcess>> running;
  std::vector<Outcome> outcomes;
  const auto finishFirst = [&] {
    outcomes.push_back(outcomeOf(*running.front()));
    running.pop_front();
  };
  for (const QString& commandLine : commandLines) {
    if (running.size() == atOnce) finishFirst();
    running.push_back(start(commandLine));
  }
  while (!running.empty())
    finishFirst();
  return outcomes;
}

std::vector<std::pair<std::string, std::string>> ProgramRun::contents() const {
  std::vector<std::pair<std::string, std::string>> contents;
  for (auto entry = fs::recursive_directory_iterator(folder_.path());
       entry != fs::recursive_directory_iterator(); ++entry) {
    const std::string name = fs::relative(entry->path(), folder_.path()).generic_string();
    if (name == kCache) {
      entry.disable_recursion_pending();
      continue;
    }
    contents.emplace_back(name, entry->is_regular_file() ? read(name) : std::string());
  }
  std::sort(contents.begin(), contents.end());
  return contents;
}

Image ProgramRun::image(const std::string& name) const {
  return need(readImage(folder_ / name, {PixelFormat::float32}, nullptr, {}));
}

MapsFile ProgramRun::maps(const std::string& name) const {
  return need(readMaps(folder_ / name, PixelFormat::float32, nullptr, {}));
}

void ProgramRun::writeImage(const std::string& name, const ImageContent& content,
                            SampleType type) const {
  const Status status = cutis::writeImage(folder_ / name, content, type, {});
  if (status) return;
  std::cerr << (status.failed() ? status.error().text() : "cancelled") << "\n";
  std::abort();
}

bool isOneError(const std::string& errors) {
  return errors.starts_with("cutis-cli: ") && errors.ends_with("\n") &&
         std::count(errors.begin(), errors.end(), '\n') == 1;
}

std::vector<float> valuesOf(const Plane& plane) {
  std::vector<float> values(plane.bounds().pixelCount());
  if (!plane.load(plane.bounds(), values)) std::abort();
  return values;
}

Plane planeOf(int width, int height, const std::vector<float>& values) {
  Plane plane(width, height);
  if (!plane.store(plane.bounds(), values)) std::abort();
  return plane;
}

ImageContent skinTexture(int width, int height, const std::vector<std::string>& channels) {
  ImageContent content;
  content.channelNames = channels;
  std::mt19937 random(7);
  std::uniform_real_distribution<float> noise(-0.02f, 0.02f);
  for (const std::string& name : channels) {
    const float level = name == "R" ? 0.62f : name == "G" ? 0.46f : name == "B" ? 0.38f : 0.7f;
    std::vector<float> values;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const float wave =
            std::sin(0.2f * static_cast<float>(x)) * std::cos(0.15f * static_cast<float>(y));
        values.push_back(level + 0.05f * wave + noise(random));
      }
    }
    content.channels.push_back(planeOf(width, height, values));
  }
  return content;
}

}  // namespace cutis::test
