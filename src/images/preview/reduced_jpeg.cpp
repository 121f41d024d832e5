#include "src/images/preview/reduced_jpeg.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "src/images/inputs/jpeg_reports.h"

namespace cutis {
namespace {

constexpr int kRowsBetweenStops = 64;

class JpegReduction {
 public:
  explicit JpegReduction(JpegFile file) : file_(std::move(file)) { info_.err = reports_.connect(); }
  ~JpegReduction() { jpeg_destroy_decompress(&info_); }
  JpegReduction(const JpegReduction&) = delete;
  JpegReduction& operator=(const JpegReduction&) = delete;

  std::optional<ReducedJpeg> read(int reduction, const JobContext& context) {
    if (!reports_.guarded([&] { start(reduction); })) return std::nullopt;
    if (info_.output_components != 1 && info_.output_components != 3) return std::nullopt;
    ReducedJpeg image;
    image.width = static_cast<int>(info_.output_width);
    image.height = static_cast<int>(info_.output_height);
    image.channels = info_.output_components;
    const std::size_t rowBytes =
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.channels);
    image.samples.resize(rowBytes * static_cast<std::size_t>(image.height));
    for (int y = 0; y < image.height; y += kRowsBetweenStops) {
      if (context.stopRequested()) return std::nullopt;
      const int end = std::min(y + kRowsBetweenStops, image.height);
      JSAMPLE* const samples = image.samples.data();
      if (!reports_.guarded([&] { decode(samples, rowBytes, end); })) return std::nullopt;
    }
    return image;
  }

 private:
  void start(int reduction) {
    jpeg_create_decompress(&info_);
    jpeg_stdio_src(&info_, file_.get());
    jpeg_read_header(&info_, TRUE);
    if (info_.num_components == 3) info_.out_color_space = JCS_RGB;
    info_.scale_num = 1;
    info_.scale_denom = static_cast<unsigned>(reduction);
    jpeg_start_decompress(&info_);
  }

  void decode(JSAMPLE* samples, std::size_t rowBytes, int end) {
    while (static_cast<int>(info_.output_scanline) < end) {
      JSAMPLE* row = samples + rowBytes * info_.output_scanline;
      jpeg_read_scanlines(&info_, &row, 1);
    }
  }

  JpegFile file_;
  JpegReports reports_;
  jpeg_decompress_struct info_ = {};
};

}  // namespace

std::optional<ReducedJpeg> readReducedJpeg(const std::filesystem::path& path, int reduction,
                                           const JobContext& context) {
  JpegFile file(std::fopen(path.c_str(), "rb"));
  if (!file) return std::nullopt;
  return JpegReduction(std::move(file)).read(reduction, context);
}

}  // namespace cutis
