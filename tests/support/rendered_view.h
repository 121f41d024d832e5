#pragma once

// A part of a view as the server shows it at rest.

#include "src/app/views/view_samples.h"

namespace cutis::test {

inline Result<ViewPart> renderedView(const Scene& scene, Engine& engine,
                                     const PictureRequest& picture, const ViewRequest& request) {
  CUTIS_TRY(samples, ViewSamples::load(scene, engine, picture, request, nullptr, {}));
  return samples.render(scene.edits, ViewAccuracy::exact, {});
}

}  // namespace cutis::test
