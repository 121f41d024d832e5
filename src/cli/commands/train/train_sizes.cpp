#include "src/cli/commands/train/train_sizes.h"

#include <optional>
#include <sstream>
#include <vector>

#include "core/base/number_text.h"
#include "src/app/training/size_study.h"
#include "src/cli/options/train_options.h"
#include "src/cli/text_table.h"

namespace cutis {
namespace {

constexpr std::size_t kMostSizes = 20;
constexpr char kDefaultSize[] = "default";

struct NetworkSize {
  std::string name;
  std::optional<std::vector<int>> hidden;  // none: as they are
};

Result<std::vector<NetworkSize>> sizesOf(const std::string& text) {
  std::vector<NetworkSize> sizes;
  std::istringstream fields(text);
  for (std::string field; std::getline(fields, field, ';');) {
    if (field == kDefaultSize) {
      sizes.push_back({field, {}});
      continue;
    }
    CUTIS_TRY(hidden, hiddenLayers("--sizes", field));
    sizes.push_back({field, hidden});
  }
  if (sizes.empty() || sizes.size() > kMostSizes) {
    return usageError("--sizes", "give 1 to " + std::to_string(kMostSizes) +
                                     " sizes with semicolons between them, such as "
                                     "\"16,16;default;64,64,64\"");
  }
  return sizes;
}

Result<std::vector<std::string>> rowOf(const NetworkSize& size, const SkinModel& model,
                                       const Rig& rig, NetworkTraining training,
                                       const JobContext& context) {
  if (size.hidden) training.spectra.hidden = training.chromophores.hidden = *size.hidden;
  CUTIS_TRY(figures, studySize(model, rig, training, context));
  return std::vector<std::string>{size.name,
                                  std::to_string(figures.weights),
                                  std::to_string(figures.workPerPixel),
                                  fixedNumber(figures.encodeNanoseconds, 0),
                                  fixedNumber(figures.decodeNanoseconds, 0),
                                  shortScientific(figures.errors.decoded),
                                  shortScientific(figures.errors.encoded),
                                  shortScientific(figures.errors.encodedNoisy),
                                  shortScientific(figures.errors.both),
                                  fixedNumber(figures.trainingSeconds, 0)};
}

}  // namespace

Status checkSizes(const std::string& sizes) {
  const auto read = sizesOf(sizes);
  return read ? Status() : Status(read.failure());
}

Result<std::string> sizesTable(const std::string& sizes, const SkinModel& model, const Rig& rig,
                               const NetworkTraining& training, const JobContext& context) {
  CUTIS_TRY(list, sizesOf(sizes));
  TextTable table({"hidden layers", "weights", "multiply-adds", "encode, ns", "and decode, ns",
                   "SpectraNN", "ChromNN", "with noise", "both", "training, s"});
  for (std::size_t i = 0; i < list.size(); ++i) {
    const auto share = [&](std::size_t at) {
      return static_cast<double>(at) / static_cast<double>(list.size());
    };
    CUTIS_TRY(row, rowOf(list[i], model, rig, training, context.child(share(i), share(i + 1))));
    table.add(row);
  }
  return "  networks by size: weights of both; multiply-adds and time per pixel, one core, from "
         "channels to parameters\n  and on to the rig's channels; mean squared errors, 400-700 "
         "nm: SpectraNN; ChromNN and the skin model, without\n  and with the rig's noise; ChromNN "
         "and SpectraNN without noise\n" +
         table.text();
}

}  // namespace cutis
