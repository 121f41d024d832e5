#pragma once

// Compares the current view with another picture of the same place: by a line that wipes, side by
// side, by the difference, or by turning from one to the other and back.
//
// While nothing is compared nothing is made. Interface thread only.

#include <memory>
#include <optional>

#include <QElapsedTimer>
#include <QObject>

#include "core/edit/edit_stack.h"
#include "src/app/document/document.h"
#include "src/app/job_runner.h"
#include "src/app/views/view_server.h"
#include "ui/compare/comparison.h"
#include "ui/compare/difference_job.h"
#include "ui/view/picture_split.h"

namespace cutis {

class ViewController;
class Viewport;

class ComparisonController : public QObject {
  Q_OBJECT

 public:
  // All outlive the controller.
  ComparisonController(Document& document, JobRunner& jobs, ViewServer& server,
                       ViewController& views, Viewport& viewport, QObject* parent = nullptr);
  ~ComparisonController() override;

  ComparisonMode mode() const { return mode_; }
  void setMode(ComparisonMode mode);
  Partner partner() const { return partner_; }
  // What the current view is compared with. Precondition: something is open.
  ComparedView compared() const;
  void setPartner(Partner partner);

  // The partner alone, in place of the view. A key that is held for longer than a tap turns back
  // when it is released.
  bool isTurned() const { return isTurned_; }
  void setTurned(bool turned);

  // Keeps the document's edits as a state to compare with.
  void keepEdits();
  bool hasKeptEdits() const { return kept_ != nullptr; }

 Q_SIGNALS:
  void changed();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  using Part = std::shared_ptr<const ViewPart>;

  void reset();
  bool isComparing() const { return mode_ != ComparisonMode::none || isTurned_; }
  bool showsDifference() const { return mode_ == ComparisonMode::difference && !isTurned_; }
  // Asks for what is to be seen, and shows what is there.
  void refresh();
  void wantParts();
  void showParts();
  void showDifference();
  SplitMode splitMode() const;

  Document& document_;
  ViewServer& server_;
  ViewController& views_;
  Viewport& viewport_;
  ComparisonMode mode_ = ComparisonMode::none;
  Partner partner_ = Partner::original;
  bool isTurned_ = false;
  QElapsedTimer sinceTurned_;
  int lastKey_ = 0;  // that was pressed
  int heldKey_ = 0;  // that has turned to the partner, or was pressed last before
  std::shared_ptr<const EditStack> kept_;
  Part detail_, overview_;  // of the partner
  std::unique_ptr<ViewWatch> detailWatch_, overviewWatch_;
  DifferenceJob detailJob_, overviewJob_;
  Part detailDifference_, overviewDifference_;
};

}  // namespace cutis
