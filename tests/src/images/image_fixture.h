#pragma once

// Pictures, folders and foreign files for the tests of src/images.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <QTemporaryDir>

#include "core/base/job_context.h"
#include "core/base/plane.h"
#include "src/images/image_file.h"
#include "tests/src/images/foreign_file.h"

namespace cutis::test {

class ImageFolder {
 public:
  std::filesystem::path path(const std::string& name) const;
  std::filesystem::path root() const { return folder_.path().toStdString(); }
  // Names in the folder, hidden ones and subfolders included, sorted.
  std::vector<std::string> names() const;

 private:
  QTemporaryDir folder_;
};

Plane makePlane(int width, int height, const std::function<float(int x, int y)>& value,
                PixelFormat format = PixelFormat::float32);
std::vector<float> valuesOf(const Plane& plane);
float pixelOf(const Plane& plane, int x, int y);

// Smooth colours with noise, values in [0, 1]; the same for the same arguments.
ImageContent makeContent(int width, int height, const std::vector<std::string>& channels,
                         unsigned seed = 1);

// Collects what is said.
struct Listener {
  std::vector<std::string> sentences;
  JobContext context();
};

// A context that is asked to stop as soon as progress is reported.
struct Stopper {
  std::stop_source source;
  JobContext context();
};

}  // namespace cutis::test
