#pragma once  // internal to src/app/views

// What a view is made of, at the resolution of the screen and in memory: while nothing changes but
// the edits, the next picture follows the samples, whatever the size of the file they are of.
//
// Thread-safe: const after construction.

#include <cstddef>
#include <memory>
#include <vector>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/render/skin_samples.h"
#include "src/app/document/scene.h"
#include "src/app/engine.h"
#include "src/app/views/view_part.h"

namespace cutis {

// The response that a view needs; null for maps, photographs and what a fit says of its values.
Result<std::shared_ptr<const ResponseModel>> responseFor(const ViewRequest& request,
                                                         const Scene& scene, Engine& engine,
                                                         const PictureRequest& picture,
                                                         const JobContext& context);

enum class ViewAccuracy { exact, draft };

// What views of one part at one step have in common, read once for all of them: the skin in bands
// of rows.
struct ViewSkin {
  Rect rect;
  int step = 1;
  std::vector<SkinSamples> bands;
};

class ViewSamples {
 public:
  // Loads the part that a request asks for, cut to the picture. read: what another view of the same
  // maps read, to be used if it is of the same part; may be null. Precondition: for photograph and
  // editedAlbedo the scene has a source.
  static Result<ViewSamples> load(const Scene& scene, Engine& engine, const PictureRequest& picture,
                                  const ViewRequest& request,
                                  const std::shared_ptr<const ViewSkin>& read,
                                  const JobContext& context);

  const ViewRequest& request() const { return request_; }
  // Of what was fitted, whatever the edits are; see ViewPart.
  std::vector<PixelMarks> marks() const;
  // For other views; null for photographs without marks.
  const std::shared_ptr<const ViewSkin>& skin() const { return skin_; }
  // Every n-th sample of every n-th row. Precondition: n divides the rows of a band, 32.
  Result<ViewSamples> thinned(int n, const JobContext& context) const;
  // With these edits; masks are read anew. A draft is for while a control moves, see
  // draftSamples(); what no table can say is rendered as ever.
  Result<ViewPart> render(const EditStack& edits, ViewAccuracy accuracy,
                          const JobContext& context) const;

 private:
  struct Band {
    SkinSamples skin;  // of a photograph: none
    // A photograph, or what else no edit changes.
    PictureBuffer picture;
    std::vector<PixelMarks> marks = {};
  };

  static Result<std::shared_ptr<const ViewSkin>> readSkin(const Scene& scene, const Rect& rect,
                                                          int step, const JobContext& context);
  Result<Band> loadBand(const Scene& scene, const FitEvidence::Tools* tools, std::size_t i) const;
  Result<PictureBuffer> renderBand(const Band& band, const EditStack& edits,
                                   ViewAccuracy accuracy) const;

  ViewRequest request_;
  std::shared_ptr<const SkinModel> model_;
  std::shared_ptr<const ResponseModel> response_;
  std::shared_ptr<const ResponseTable> table_;  // null: of nothing that a table could say
  std::shared_ptr<const ViewSkin> skin_;
  std::vector<Band> bands_;
};

}  // namespace cutis
