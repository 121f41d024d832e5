#pragma once

// Writes the unsaved edits of a document into a journal while somebody works: two seconds after the
// last edit, and every half minute while edits do not cease. What is saved, or undone to what was
// saved, has no journal.
//
// Interface thread only; the journal is written in the background.

#include <memory>

#include <QObject>
#include <QTimer>

#include "src/app/document/document.h"
#include "src/app/job_runner.h"
#include "src/app/project/journal.h"

namespace cutis {

class Autosave : public QObject {
  Q_OBJECT

 public:
  // Document and jobs outlive it. The journal may hold something already: what is recovered.
  Autosave(Document& document, JobRunner& jobs, std::shared_ptr<Journal> journal,
           QObject* parent = nullptr);
  // Whoever ends without having saved or discarded finds the edits in the journal.
  ~Autosave() override;

  // The edits are given up: the journal goes with them.
  void discard();

 Q_SIGNALS:
  void failed(const QString& sentence);

 private:
  void follow();
  void write();
  std::string text() const;

  Document& document_;
  JobRunner& jobs_;
  std::shared_ptr<Journal> journal_;
  QTimer rest_;     // since the last edit
  QTimer longest_;  // since the first edit that is not written
  bool written_;    // there is something in the journal
  bool discarded_ = false;
};

}  // namespace cutis
