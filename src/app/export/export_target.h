#pragma once  // internal to src/app/export

// Where something is exported to, and the rules of sample type, colour space and overwriting that
// hold for all that window and command line write.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "src/app/open/source.h"
#include "src/images/codec/sample_type.h"

namespace cutis {

struct ExportTarget {
  std::filesystem::path path;  // its extension names the format (src/images/codec/image_formats.h)
  // The sample type of a picture; none: the source's where the format has it, else the next that
  // holds more, else the one that holds least less; without a source the most usual of the format.
  std::optional<SampleType> sampleType = {};
  // The colour space of a picture, a name of src/color; empty: the source's where both or neither
  // are integers and the format can say so, else sRGB in integers and Linear Rec.709 in floats.
  std::string colorSpace = {};
  // Files that were read, which are never written over.
  std::vector<std::string> inputs = {};
  // What was opened: an image, maps or a capture, which stands for all of its files. Never written
  // over either.
  std::vector<std::string> sources = {};
};

// Whether a picture could be written there, asked before any work is done: format, sample type,
// colour space, folder, and that it is none of the inputs.
Status checkPictureTarget(const ExportTarget& target);
// The same for maps.
Status checkMapsTarget(const ExportTarget& target);

struct PictureEncoding {
  SampleType sampleType = SampleType::half;
  ColorSpace colorSpace;
};

// By the rules above. image: of an albedo texture, with its colour space; null for pictures that
// come from no file. A notice where the file has other samples or colours than the texture.
Result<PictureEncoding> encodingFor(const ExportTarget& target, const ImageHeader* image,
                                    const ColorSpace& imageSpace, const JobContext& context);

}  // namespace cutis
