#pragma once

// Spectra as rows of comma-separated text, written while they are computed: of parameter sets, or
// of the pixels of maps. Reflectances have nine significant digits, columns are the wavelengths
// 300, 302, …, 1000.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/fit/fit_record.h"
#include "core/skin/chromophore_maps.h"
#include "core/skin/model/instrument_model.h"

namespace cutis {

using TextSink = std::function<Status(std::string_view text)>;

// The header row and a row per set, in parts and in order. Errors: those of `write`. Cancelled if
// asked to stop.
Status writeSpectra(const InstrumentModel& model, const std::vector<ParameterVector>& sets,
                    const TextSink& write, const JobContext& context);

struct PixelPlace {
  int x = 0, y = 0;
};

struct MapSpectraOptions {
  std::vector<PixelPlace> places;  // none: all pixels with an estimate
  // The fit that made the maps: it adds columns sd300, sd302, …, sd1000 with the posterior standard
  // deviations, at about 0.2 ms a pixel and core.
  std::optional<FitRecord> deviationsOf;
};

// The header row with x,y in front, and a row for each pixel with an estimate, in reading order; or
// for those at the places, in their order. What the maps hold beside the parameters counts. Errors:
// those of `write` and of reading tiles, a place outside or without an estimate, and deviations of
// maps with constants per pixel, which nobody knows; `name` stands in front of these. Cancelled if
// asked to stop.
Status writeMapSpectra(const std::shared_ptr<const SkinModel>& model, const ChromophoreMaps& maps,
                       const MapSpectraOptions& options, const std::string& name,
                       const TextSink& write, const JobContext& context);

}  // namespace cutis
