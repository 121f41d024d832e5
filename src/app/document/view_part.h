#pragma once

// What the editor can show of a scene, computed part by part.

#include "core/base/job_context.h"
#include "core/base/rect.h"
#include "core/base/result.h"
#include "core/render/render_picture.h"
#include "src/app/document/scene.h"
#include "src/app/engine.h"
#include "src/app/picture_request.h"

namespace cutis {

enum class ViewKind {
  photograph,    // linear Rec.709
  editedAlbedo,  // linear Rec.709: what an export writes
  skin,          // under the chosen light, linear Rec.709 or a camera's channels
  melanin,       // one channel each, in the parameter's unit, with edits
  melaninBlend,
  haemoglobinDermal,
  haemoglobinEpidermal,
  carotene,
  ultraviolet,  // one channel: mean reflectance
  nearInfrared,
};

// Nothing for the views that are no map.
std::optional<Parameter> parameterOf(ViewKind view);

struct ViewRequest {
  ViewKind view = ViewKind::photograph;
  Rect rect;     // of the picture, in pixels
  int step = 1;  // every step-th pixel of every step-th row
  bool operator==(const ViewRequest&) const = default;
};

struct ViewPart {
  ViewRequest request;
  PictureBuffer pixels;
};

// Whether the view shows light: concentrations are never averaged.
bool canBeAveraged(ViewKind view);

// The part of the picture that a request asks for, each sample the mean of the step × step texels
// that it stands for, all of them computed exactly; what lies outside of the picture is left out.
// `picture` is the light and eyes of the view `skin`. On all cores. Precondition: canBeAveraged()
// of the view; for photograph and editedAlbedo the scene has a source.
Result<ViewPart> renderAveraged(const Scene& scene, Engine& engine, const PictureRequest& picture,
                                const ViewRequest& request, const JobContext& context);

}  // namespace cutis
