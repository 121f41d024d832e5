#include "src/report/picture_file.h"

#include "src/files/io/atomic_write.h"
#include "src/files/io/file_extension.h"
#include "src/files/resources.h"
#include "src/files/system/platform.h"
#include "src/report/rasteriser.h"
#include "src/report/svg.h"

namespace cutis {
namespace {

constexpr double kPngScale = 2.0;
constexpr char kViewerFonts[] = "DejaVu Sans, Verdana, Helvetica, Arial, sans-serif";

bool isPng(const std::filesystem::path& path) {
  return lowerExtension(path) == ".png";
}

// Null if it is not there.
Rasterise rasteriser() {
  return reinterpret_cast<Rasterise>(moduleSymbol(kRasteriserModule, kRasteriserSymbol));
}

Error noRasteriser(const std::filesystem::path& path) {
  return resourceError(path.string(), "the part of the program that draws PNG (" +
                                          std::string(kRasteriserModule) +
                                          ") cannot be loaded; write an .svg or install the "
                                          "program anew");
}

}  // namespace

Status checkDrawingOutput(const std::filesystem::path& path) {
  if (lowerExtension(path) != ".svg" && !isPng(path)) {
    return usageError(path.string(),
                      "the plot is written as SVG or PNG; name the file with .svg or .png");
  }
  if (isPng(path) && rasteriser() == nullptr) return noRasteriser(path);
  return checkWritable(path);
}

Status writeDrawing(const std::filesystem::path& path, const Drawing& drawing) {
  if (!isPng(path)) return writeTextAtomically(path, svgOf(drawing, kViewerFonts));
  const Rasterise rasterise = rasteriser();
  if (rasterise == nullptr) return noRasteriser(path);
  const std::string svg = svgOf(drawing, kPlotFontFamily);
  const std::string_view font = resource(kPlotFont).value_or(std::string_view());
  return writeAtomically(path, [&](const std::filesystem::path& temporary) -> Status {
    const std::string name = temporary.string();
    const RasteriserJob job = {svg.data(),  svg.size(), font.data(),
                               font.size(), kPngScale,  name.c_str()};
    if (const char* failure = rasterise(&job)) return resourceError(path.string(), failure);
    return {};
  });
}

}  // namespace cutis
