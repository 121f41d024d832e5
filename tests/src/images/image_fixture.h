#pragma once

// Pictures, folders and foreign files for the tests of src/images.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <OpenImageIO/imageio.h>
#include <QByteArray>
#include <QTemporaryDir>

#include "core/base/job_context.h"
#include "core/base/plane.h"
#include "src/images/image_file.h"

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

QByteArray readBytes(const std::filesystem::path& path);
void writeBytes(const std::filesystem::path& path, const QByteArray& bytes);

Plane makePlane(int width, int height, const std::function<float(int x, int y)>& value,
                PixelFormat format = PixelFormat::float32);
std::vector<float> valuesOf(const Plane& plane);
float pixelOf(const Plane& plane, int x, int y);

// Smooth colours with noise, values in [0, 1]; the same for the same arguments.
ImageContent makeContent(int width, int height, const std::vector<std::string>& channels,
                         unsigned seed = 1);

// A file as other programs write it, through OpenImageIO itself; samples are interleaved.
void writeForeign(const std::filesystem::path& path, const std::string& format,
                  const OIIO::ImageSpec& spec, const std::vector<float>& samples);
// A part of an OpenEXR file, all of whose samples are the number of the part and a tenth for each
// channel before.
struct ForeignPart {
  std::string name;
  std::vector<std::string> channels;
};
void writeForeignParts(const std::filesystem::path& path, const std::vector<ForeignPart>& parts);
// Says in a PNG file, by a chunk eXIf, how its picture lies.
void addPngOrientation(const std::filesystem::path& path, int tag);
// Interleaved noise in [0, 1].
std::vector<float> noise(std::size_t count, unsigned seed = 1);

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
