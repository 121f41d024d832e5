#pragma once

// What a picture carries besides its pixels: EXIF, copyright, description. Kept as it was read and
// handed on to what is made of the picture; nobody else looks inside.
//
// What describes only the storage (compression, windows, sample types, how the picture lies in its
// file) or the colours, which an output states anew, is not part of it. A value
// of this class never changes: copies share, threads may read.

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace cutis {

class ImageMetadata {
 public:
  // Nothing.
  ImageMetadata() = default;

  bool empty() const;
  std::vector<std::string> names() const;
  // A value as text; nothing if there is none of that name ("Make", "Exif:DateTimeOriginal").
  std::optional<std::string> text(const std::string& name) const;

 private:
  friend struct MetadataAccess;
  struct Attributes;
  std::shared_ptr<const Attributes> attributes_;
};

}  // namespace cutis
