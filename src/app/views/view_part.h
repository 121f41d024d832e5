#pragma once

// What the editor can show of a scene, computed part by part.

#include <memory>
#include <vector>

#include "core/base/job_context.h"
#include "core/base/rect.h"
#include "core/base/result.h"
#include "core/render/render_picture.h"
#include "src/app/document/pixel_marks.h"
#include "src/app/document/scene.h"
#include "src/app/engine.h"
#include "src/app/picture_request.h"
#include "src/app/views/view_kind.h"

namespace cutis {

struct ViewRequest {
  ViewKind view = ViewKind::photograph;
  Rect rect;                                         // of the picture, in pixels
  int step = 1;                                      // every step-th pixel of every step-th row
  PixelMarks marks = 0;                              // that are wanted with it
  double wavelengthNm = 550.0;                       // of the view `band`, 300 to 1000
  std::shared_ptr<const EditStack> edits = nullptr;  // instead of the scene's; null: the scene's
  bool operator==(const ViewRequest&) const = default;
};

struct ViewPart {
  ViewRequest request;
  PictureBuffer pixels;
  // Of each pixel; empty where none are wanted, or nothing is known that could tell.
  std::vector<PixelMarks> marks = {};
};

// The part of the picture that a request asks for, each sample the mean of the step × step texels
// that it stands for, all of them computed exactly; what lies outside of the picture is left out.
// `picture` is the light and eyes of the view `skin`. On all cores. Precondition: canShow() and
// canBeAveraged() of the view.
Result<ViewPart> renderAveraged(const Scene& scene, Engine& engine, const PictureRequest& picture,
                                const ViewRequest& request, const JobContext& context);

}  // namespace cutis
