#include "src/app/document/undo_history.h"

#include <utility>

namespace cutis {

void UndoHistory::push(const QString& name, const QString& mergeGroup, DocumentState state) {
  if (open_ && !mergeGroup.isEmpty() && steps_[position_].group == mergeGroup) {
    steps_[position_] = {name, mergeGroup, std::move(state)};
    return;
  }
  steps_.resize(position_ + 1);
  steps_.push_back({name, mergeGroup, std::move(state)});
  ++position_;
  open_ = true;
}

void UndoHistory::goTo(std::size_t step) {
  position_ = step;
  open_ = false;
}

void UndoHistory::undo() {
  goTo(position_ - 1);
}

void UndoHistory::redo() {
  goTo(position_ + 1);
}

}  // namespace cutis
