#include "src/app/open/source_for_profile.h"

#include <utility>

#include "core/analyse/exposure.h"
#include "core/base/number_text.h"
#include "src/app/open/daylight_matrix.h"

namespace cutis {

Result<Source> openForProfile(const std::filesystem::path& path,
                              const std::shared_ptr<const SkinModel>& model, Engine& engine,
                              const std::shared_ptr<TileStore>& store, const JobContext& context) {
  auto source = openSource(path, {}, *model, store, context.child(0.0, 0.4));
  if (!source || !source.value().image) return source;
  const Measurements& measurements = source.value().measurements;
  CUTIS_TRY(solver, engine.solver(model, measurements.rig, {}, context.child(0.4, 0.5)));
  CUTIS_TRY(choice, chooseExposure(measurements, *solver, context.child(0.5, 0.6, "exposure")));
  if (choice.exposure == 1.0) return source;
  SourceOptions exposed;
  exposed.exposure = choice.exposure;
  context.say("Read at exposure " + formatNumber(choice.exposure, 3) + ", which brings " +
              formatNumber(100.0 * choice.inside, 2) +
              " % of the texture into the range of skin colours");
  return openSource(path, exposed, *model, store, context.child(0.6, 1.0));
}

Result<Source> changeProfile(const Source& source, const std::filesystem::path& path,
                             const std::shared_ptr<const SkinModel>& model, Engine& engine,
                             const std::shared_ptr<TileStore>& store, const JobContext& context) {
  if (!source.image) {
    Source changed = source;
    CUTIS_TRY(matrix, daylightMatrix(source.measurements.rig, *model));
    changed.toRec709 = matrix;
    return changed;
  }
  auto read = openForProfile(path, model, engine, store, context);
  if (!read || read.value().references == source.references) return read;
  return inputError(path.string(), "the file has changed since it was opened; open it again");
}

}  // namespace cutis
