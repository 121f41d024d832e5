#pragma once

// A picture file being written, part by part. For the files of this folder.

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <OpenImageIO/imageio.h>

#include "core/base/job_context.h"
#include "core/base/plane.h"
#include "src/images/codec/output_file.h"
#include "src/images/codec/sample_type.h"
#include "src/images/codec/source_file.h"

namespace cutis {

struct OutputPart {
  OIIO::ImageSpec spec;         // complete, with its channels' names
  std::vector<Plane> channels;  // one per channel of the spec
};

// Writes to `file`, a temporary of writeAtomically; `place` is the name that errors give. What the
// file cannot keep of the metadata must not keep it from being written: if the header is refused,
// `plain` is tried, the same specs without what was carried over, and said in a notice.
// Chunks of a PNG file are put behind its head.
Status writeParts(const std::filesystem::path& file, const std::string& place, ImageFileKind kind,
                  SampleType type, const std::vector<OutputPart>& parts,
                  const std::vector<OIIO::ImageSpec>& plain, const std::string& pngChunks,
                  const JobContext& context);

}  // namespace cutis
