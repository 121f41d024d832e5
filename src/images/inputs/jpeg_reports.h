#pragma once

// How libjpeg reports: by a jump out of its own functions where it gives up, else by a message that
// is kept.

#include <csetjmp>
#include <cstddef>
#include <cstdio>
#include <jpeglib.h>
#include <memory>

namespace cutis {

struct JpegFileCloser {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using JpegFile = std::unique_ptr<std::FILE, JpegFileCloser>;

// Not copied: the library keeps its address.
class JpegReports {
 public:
  JpegReports() = default;
  JpegReports(const JpegReports&) = delete;
  JpegReports& operator=(const JpegReports&) = delete;

  // For jpeg_decompress_struct::err.
  jpeg_error_mgr* connect() {
    jpeg_std_error(&all_.manager);
    all_.manager.error_exit = giveUp;
    all_.manager.emit_message = takeMessage;
    all_.manager.output_message = [](j_common_ptr) {};
    return &all_.manager;
  }

  // Runs steps of the library, in which nothing may have a destructor; false if it gave up.
  template <typename Steps>
  bool guarded(const Steps& steps) {
    all_.message[0] = '\0';
    if (setjmp(all_.giveUp) != 0) return false;
    steps();
    return true;
  }

  // Why it gave up, or its first warning since guarded() began; else empty.
  const char* message() const { return all_.message; }

 private:
  // The library finds all of it by the first member.
  struct All {
    jpeg_error_mgr manager = {};
    std::jmp_buf giveUp = {};
    char message[JMSG_LENGTH_MAX] = {};
  };

  static All& allOf(j_common_ptr info) { return *reinterpret_cast<All*>(info->err); }

  // The library must not go on after an error.
  [[noreturn]] static void giveUp(j_common_ptr info) {
    All& all = allOf(info);
    info->err->format_message(info, all.message);
    std::longjmp(all.giveUp, 1);
  }

  // Other messages trace what the library does.
  static void takeMessage(j_common_ptr info, int level) {
    All& all = allOf(info);
    if (level < 0 && all.message[0] == '\0') info->err->format_message(info, all.message);
  }

  All all_;
};

}  // namespace cutis
