// Parts of src/app/document/document.h: what is seen before anything is open, and what is given
// back after it was closed.

#include <utility>

#include "src/app/document/document.h"
#include "src/files/system/free_memory.h"

namespace cutis {

void Document::showPreview(const QString& name, const SourcePreview& preview) {
  if (isPreviewed_) {
    Q_EMIT previewRefined(preview);
    return;
  }
  name_ = name;
  isPreviewed_ = true;
  Q_EMIT previewed(preview);
}

void Document::endPreview() {
  if (std::exchange(isPreviewed_, false)) Q_EMIT previewEnded();
}

// What a fit and pictures before it have left.
void Document::giveMemoryBack() {
  jobs_.startQuiet([](const JobRunner::Handle&) { giveFreeMemoryBack(); });
}

}  // namespace cutis
