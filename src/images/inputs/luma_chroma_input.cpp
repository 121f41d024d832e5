#include "src/images/inputs/luma_chroma_input.h"

#include <ImfChromaticitiesAttribute.h>
#include <ImfRgbaFile.h>
#include <ImfStandardAttributes.h>
#include <cstdint>
#include <cstring>
#include <memory>
#include <vector>

namespace cutis {
namespace {

// Threads of OpenEXR's own would have to be ended before the program (see ARCHITECTURE.md).
constexpr int kNoThreads = 0;

class LumaChromaInput final : public OIIO::ImageInput {
 public:
  explicit LumaChromaInput(const std::string& path) : file_(path.c_str(), kNoThreads) {
    const auto& stored = file_.dataWindow();
    const auto& shown = file_.displayWindow();
    const int width = stored.max.x - stored.min.x + 1, height = stored.max.y - stored.min.y + 1;
    m_spec = OIIO::ImageSpec(width, height, hasAlpha() ? 4 : 3, OIIO::TypeHalf);
    m_spec.x = stored.min.x;
    m_spec.y = stored.min.y;
    m_spec.full_x = shown.min.x;
    m_spec.full_y = shown.min.y;
    m_spec.full_width = shown.max.x - shown.min.x + 1;
    m_spec.full_height = shown.max.y - shown.min.y + 1;
    if (Imf::hasChromaticities(file_.header())) {
      const Imf::Chromaticities& c = Imf::chromaticities(file_.header());
      const float values[8] = {c.red.x,  c.red.y,  c.green.x, c.green.y,
                               c.blue.x, c.blue.y, c.white.x, c.white.y};
      m_spec.attribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8), values);
    }
  }

  bool isLumaChroma() const { return (file_.channels() & Imf::WRITE_C) != 0; }

  const char* format_name() const override { return "openexr"; }
  bool open(const std::string&, OIIO::ImageSpec& spec) override {
    spec = m_spec;
    return true;
  }
  bool close() override { return true; }
  bool seek_subimage(int part, int level) override { return part == 0 && level == 0; }

  bool read_native_scanline(int part, int level, int y, int, void* data) override try {
    if (!seek_subimage(part, level)) return false;
    const auto width = static_cast<std::size_t>(m_spec.width);
    std::vector<Imf::Rgba> row(width);
    // The frame buffer is addressed by the file's own coordinates.
    Imf::Rgba* base = row.data() - m_spec.x;
    file_.setFrameBuffer(base, 1, 0);
    file_.readPixels(y);
    const auto channels = static_cast<std::size_t>(m_spec.nchannels);
    auto* out = static_cast<std::uint16_t*>(data);
    for (std::size_t i = 0; i < width; ++i) {
      const std::uint16_t pixel[4] = {row[i].r.bits(), row[i].g.bits(), row[i].b.bits(),
                                      row[i].a.bits()};
      std::memcpy(out + channels * i, pixel, channels * sizeof(std::uint16_t));
    }
    return true;
  } catch (const std::exception& error) {
    errorfmt("{}", error.what());
    return false;
  }

 private:
  bool hasAlpha() const { return (file_.channels() & Imf::WRITE_A) != 0; }

  Imf::RgbaInputFile file_;
};

}  // namespace

OIIO::ImageInput::unique_ptr openLumaChroma(const std::filesystem::path& path) {
  auto input = std::make_unique<LumaChromaInput>(path.string());
  if (!input->isLumaChroma()) return nullptr;
  return input;
}

}  // namespace cutis
