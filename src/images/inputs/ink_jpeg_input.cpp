#include "src/images/inputs/ink_jpeg_input.h"

#include <cstddef>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>

#include "src/images/inputs/jpeg_reports.h"

namespace cutis {
namespace {

class InkJpegInput final : public OIIO::ImageInput {
 public:
  InkJpegInput(std::string path, const OIIO::ImageSpec& head) : path_(std::move(path)) {
    m_spec = head;
    m_spec.nchannels = 4;
    m_spec.channelnames = {"C", "M", "Y", "K"};
    m_spec.alpha_channel = -1;
    info_.err = reports_.connect();
  }
  ~InkJpegInput() override { jpeg_destroy_decompress(&info_); }

  const char* format_name() const override { return "jpeg"; }
  bool open(const std::string&, OIIO::ImageSpec& spec) override {
    spec = m_spec;
    return start();
  }
  bool close() override { return true; }
  bool seek_subimage(int part, int level) override { return part == 0 && level == 0; }

  bool read_native_scanline(int part, int level, int y, int, void* data) override {
    if (!seek_subimage(part, level)) return false;
    // Rows are decoded from the top.
    if (isDecoding_ && y < static_cast<int>(info_.output_scanline) && !start()) return false;
    auto* row = static_cast<JSAMPLE*>(data);
    if (!guarded([&] { decodeUpTo(y, row); })) return false;
    if (info_.saw_Adobe_marker == 0) return true;
    const std::size_t samples = 4 * static_cast<std::size_t>(m_spec.width);
    for (std::size_t i = 0; i < samples; ++i)
      row[i] = static_cast<JSAMPLE>(MAXJSAMPLE - row[i]);
    return true;
  }

 private:
  // To the first row.
  bool start() {
    jpeg_destroy_decompress(&info_);
    isDecoding_ = false;
    file_.reset(std::fopen(path_.c_str(), "rb"));
    if (!file_) {
      errorfmt("the file cannot be opened");
      return false;
    }
    const bool read = guarded([this] {
      jpeg_create_decompress(&info_);
      jpeg_stdio_src(&info_, file_.get());
      jpeg_read_header(&info_, TRUE);
      info_.out_color_space = JCS_CMYK;
    });
    if (!read) return false;
    const bool same = static_cast<int>(info_.image_width) == m_spec.width &&
                      static_cast<int>(info_.image_height) == m_spec.height;
    if (!same) errorfmt("the file changed while it was read");
    return same;
  }

  void decodeUpTo(int y, JSAMPLE* row) {
    if (!isDecoding_) jpeg_start_decompress(&info_);
    isDecoding_ = true;
    while (static_cast<int>(info_.output_scanline) <= y)
      jpeg_read_scanlines(&info_, &row, 1);
  }

  template <typename Steps>
  bool guarded(const Steps& steps) {
    if (!reports_.guarded(steps)) {
      errorfmt("{}", reports_.message());
      return false;
    }
    if (reports_.message()[0] != '\0') errorfmt("{}", reports_.message());
    return true;
  }

  std::string path_;
  JpegFile file_;
  JpegReports reports_;
  jpeg_decompress_struct info_ = {};
  bool isDecoding_ = false;
};

}  // namespace

bool isInkJpeg(const OIIO::ImageSpec& head) {
  const std::string stored = head.get_string_attribute("jpeg:ColorSpace");
  return stored == "CMYK" || stored == "YCbCrK";
}

OIIO::ImageInput::unique_ptr openInkJpeg(const std::filesystem::path& path,
                                         const OIIO::ImageSpec& head) {
  return std::make_unique<InkJpegInput>(path.string(), head);
}

}  // namespace cutis
