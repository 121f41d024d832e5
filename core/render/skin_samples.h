#pragma once

// Samples of skin in memory, of which pictures are made again and again while the edits change: the
// work then follows the samples and not the picture that they are taken of.
//
// Thread-safe: pure functions.

#include <memory>
#include <vector>

#include "core/base/rect.h"
#include "core/base/result.h"
#include "core/render/edited_skin.h"
#include "core/skin/response_model.h"
#include "core/skin/response_table.h"

namespace cutis {

// One float per pixel and row of the response model, row by row of the picture; 0 where there is no
// estimate.
struct PictureBuffer {
  int width = 0;
  int height = 0;
  std::vector<std::vector<float>> channels;
  std::vector<bool> present;
};

struct SkinSamples {
  Rect rect;     // of the skin, in pixels
  int step = 1;  // every step-th pixel of every step-th row of it
  // Without edits; never null. Views of the same skin share them.
  std::shared_ptr<const ParameterBuffer> parameters;
  // What a response makes of them, one vector per row of it, and what its table does; empty where
  // nobody needs it.
  std::vector<std::vector<float>> original;
  std::vector<std::vector<float>> tabulated;

  int width() const { return (rect.width() + step - 1) / step; }
  int height() const { return (rect.height() + step - 1) / step; }
};

// Precondition: rect lies within the maps.
Result<SkinSamples> loadSamples(const EditedSkin& skin, const Rect& rect, int step);

// One vector per row of the response; 0 where there is no estimate. Precondition, here and below:
// the response has the free constants of the skin.
std::vector<std::vector<float>> responseTo(const ParameterBuffer& parameters,
                                           const ResponseModel& response);
std::vector<std::vector<float>> responseTo(const ParameterBuffer& parameters,
                                           const ResponseTable& table);

// Every n-th sample of every n-th row, the first among them.
SkinSamples thinned(const SkinSamples& samples, int n);
PictureBuffer thinned(const PictureBuffer& picture, int n);

// The pictures of core/render/render_picture.h, of samples with edits; axes: of their profile.
// Where the samples have `original`, it is what is rendered of them without edits.
Result<PictureBuffer> renderSamples(const SkinSamples& samples, const EditStack& edits,
                                    const ParameterAxes& axes, const ResponseModel& response);
Result<PictureBuffer> mapSamples(const SkinSamples& samples, const EditStack& edits,
                                 const ParameterAxes& axes, Parameter parameter);
// Precondition: the samples have `original`, of this response.
Result<PictureBuffer> editAlbedoSamples(PictureBuffer source, const SkinSamples& samples,
                                        const EditStack& edits, const ParameterAxes& axes,
                                        const ResponseModel& albedo, bool pure);

// Either picture while a control moves: what it is without edits, times the ratio by which the
// table says that they change it. Of parameters all over their ranges 99 in 100 colours are within
// ΔE2000 0.15 of the picture's and all within 0.3; within 0.2 and 0.5 where there is a discrepancy,
// whose part in the ratio is left out, and up to 1.5 where an edit takes a chromophore away
// altogether (tests/core/render/draft_samples_test.cpp). Precondition: the samples have
// `tabulated`, of this table.
Result<PictureBuffer> draftSamples(PictureBuffer unedited, const SkinSamples& samples,
                                   const EditStack& edits, const ParameterAxes& axes,
                                   const ResponseTable& table);

}  // namespace cutis
