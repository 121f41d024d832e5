#pragma once  // internal to src/app/document

// Undo by snapshots of a small state. Commands of one merge group that follow each other are one
// step, which bears the name of the last: a drag of a slider is undone at once.

#include <utility>
#include <vector>

#include <QString>

#include "core/edit/edit_stack.h"

namespace cutis {

// Everything of a document that undo restores. Cheap to copy: masks are handles.
struct DocumentState {
  EditStack edits;
};

class UndoHistory {
 public:
  UndoHistory() : UndoHistory(DocumentState()) {}
  explicit UndoHistory(DocumentState beginning) {
    steps_.push_back({{}, {}, std::move(beginning)});
  }

  // Replaces the current state. mergeGroup: empty never merges.
  void push(const QString& name, const QString& mergeGroup, DocumentState state);
  // The next push starts a step of its own, whatever its group (a drag has ended).
  void closeGroup() { open_ = false; }

  const DocumentState& current() const { return steps_[position_].state; }
  bool canUndo() const { return position_ > 0; }
  bool canRedo() const { return position_ + 1 < steps_.size(); }
  // Names of what would be undone and redone.
  QString undoName() const { return canUndo() ? steps_[position_].name : QString(); }
  QString redoName() const { return canRedo() ? steps_[position_ + 1].name : QString(); }
  // All steps in order; the first, without a name, is the state at the beginning.
  std::size_t stepCount() const { return steps_.size(); }
  std::size_t position() const { return position_; }  // of the current one
  const QString& stepName(std::size_t step) const { return steps_[step].name; }
  void goTo(std::size_t step);  // precondition: step < stepCount()
  void undo();                  // precondition: canUndo()
  void redo();                  // precondition: canRedo()

 private:
  struct Step {
    QString name;
    QString group;
    DocumentState state;
  };
  std::vector<Step> steps_;  // the first is the state at the beginning
  std::size_t position_ = 0;
  bool open_ = false;  // the current step may still be merged into
};

}  // namespace cutis
