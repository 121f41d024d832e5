#pragma once

// cutis-cli itself, run as people run it, in a folder of its own.

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <QProcess>
#include <QStringList>
#include <QtTest>

#include "core/base/plane.h"
#include "src/images/image_file.h"
#include "src/images/maps/maps_file.h"
#include "tests/support/scratch_folder.h"

namespace cutis::test {

struct Outcome {
  int status = -1;  // −1: ended by a signal
  std::string output;
  std::string errors;
};

class ProgramRun {
 public:
  // "fit cap -o maps.exr": words are separated by blanks; paths are relative to the folder.
  Outcome run(const QString& commandLine) const;
  // The same for many that do not depend on each other, some at a time.
  std::vector<Outcome> runAll(const std::vector<QString>& commandLines) const;
  // The same, still running.
  std::unique_ptr<QProcess> start(const QString& commandLine) const;

  std::filesystem::path operator/(const std::string& name) const { return folder_ / name; }
  std::string read(const std::string& name) const { return folder_.read(name); }
  std::filesystem::path write(const std::string& name, std::string_view bytes) const {
    return folder_.write(name, bytes);
  }
  // All files and folders below, with the bytes of the files; the cache is left out.
  std::vector<std::pair<std::string, std::string>> contents() const;

  // Files, read and written by the library. Fail the test on errors.
  Image image(const std::string& name) const;
  MapsFile maps(const std::string& name) const;
  void writeImage(const std::string& name, const ImageContent& content, SampleType type) const;

 private:
  ScratchFolder folder_;
};

// One line, "cutis-cli: …".
bool isOneError(const std::string& errors);

std::vector<float> valuesOf(const Plane& plane);
Plane planeOf(int width, int height, const std::vector<float>& values);
// A smooth picture of skin colours with the given channels; all values in (0, 1).
ImageContent skinTexture(int width, int height, const std::vector<std::string>& channels);

}  // namespace cutis::test

// Runs a command that must succeed without a word.
#define EXPECT_DONE(outcome)                                                                  \
  do {                                                                                        \
    const auto& expect_o = (outcome);                                                         \
    QVERIFY2(expect_o.status == 0,                                                            \
             ("status " + std::to_string(expect_o.status) + ": " + expect_o.errors).c_str()); \
    QVERIFY2(expect_o.errors.empty(), expect_o.errors.c_str());                               \
  } while (false)
