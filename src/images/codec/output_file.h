#pragma once  // internal to src/images/codec

// The file that a picture is written into. For the files of this folder.
//
// On a full disk libjpeg ends the process and OpenEXR waits for ever for its own threads. This file
// therefore takes everything its libraries hand it and remembers that it could not keep it; the
// writer looks after each band.

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <mutex>

#include <OpenImageIO/filesystem.h>

namespace cutis {

class OutputFile final : public OIIO::Filesystem::IOProxy {
 public:
  explicit OutputFile(const std::filesystem::path& path);

  // Something could not be stored.
  bool failed() const;
  // Whether all of it is in the hands of the system.
  bool finish();

  const char* proxytype() const override { return "cutis"; }
  void close() override {}
  size_t write(const void* bytes, size_t count) override;
  size_t pwrite(const void* bytes, size_t count, int64_t offset) override;
  size_t read(void* bytes, size_t count) override;
  size_t size() const override;

 private:
  void store(const void* bytes, size_t count, int64_t offset);

  mutable std::mutex mutex_;
  std::fstream stream_;
  int64_t end_ = 0;
  bool failed_ = false;
};

}  // namespace cutis
