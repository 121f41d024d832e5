#pragma once  // internal to src/report

// The way into the module that draws SVG as pixels: plain C, as it is found by name.

#include <cstddef>

namespace cutis {

inline constexpr char kRasteriserModule[] = "cutis_rasteriser";
inline constexpr char kRasteriserSymbol[] = "cutisRasterise";
// The family of the font that is handed over, as the SVG has to name it.
inline constexpr char kPlotFontFamily[] = "Cutis Plot";
inline constexpr char kPlotFont[] = "fonts/plot.ttf";

struct RasteriserJob {
  const char* svg = nullptr;
  std::size_t svgSize = 0;
  const char* font = nullptr;  // TrueType; lives until the call is over
  std::size_t fontSize = 0;
  double scale = 1.0;          // pixels per unit of the SVG
  const char* path = nullptr;  // of the PNG
};

// Null when the PNG was written, else a sentence that lives for ever. Not thread-safe.
using Rasterise = const char* (*)(const RasteriserJob*);

}  // namespace cutis
