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
#include <string>

#include <OpenImageIO/filesystem.h>

namespace cutis {

class OutputFile final : public OIIO::Filesystem::IOProxy {
 public:
  explicit OutputFile(const std::filesystem::path& path);

  // Puts bytes into the file, before which so many of the writer's own lie; the writer does not see
  // them. Called before anything is written, for writers that do not go back.
  void insert(int64_t offset, std::string bytes);

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
  void place(const void* bytes, size_t count, int64_t offset);
  void store(const void* bytes, size_t count, int64_t offset);

  mutable std::mutex mutex_;
  std::fstream stream_;
  int64_t end_ = 0;
  int64_t insertAt_ = 0;
  std::string inserted_;
  bool failed_ = false;
};

}  // namespace cutis
