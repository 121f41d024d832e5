#include "src/app/open/sample_source.h"

#include "src/files/profiles/profile_file.h"

namespace cutis {

Result<Source> openSampleFor(const SkinModel& model, Engine& engine,
                             const std::shared_ptr<TileStore>& store, const JobContext& context) {
  CUTIS_TRY(painted, engine.model(kDefaultProfile, {}));
  CUTIS_TRY(sample, openSample(*painted, store, context));
  return sourceForModel(sample, model);
}

}  // namespace cutis
