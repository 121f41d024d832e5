#include "ui/compare/comparison_controller.h"

#include <QCoreApplication>
#include <QKeyEvent>

#include "ui/view/view_catalogue.h"
#include "ui/view/view_controller.h"
#include "ui/view/view_image.h"
#include "ui/view/viewport.h"

namespace cutis {
namespace {

constexpr int kTapMs = 350;

}  // namespace

ComparisonController::ComparisonController(Document& document, JobRunner& jobs, ViewServer& server,
                                           ViewController& views, Viewport& viewport,
                                           QObject* parent)
    : QObject(parent),
      document_(document),
      server_(server),
      views_(views),
      viewport_(viewport),
      detailWatch_(server.watch(ViewPriority::detail,
                                [this](const Part& part) {
                                  detail_ = part;
                                  showParts();
                                })),
      overviewWatch_(server.watch(ViewPriority::overview,
                                  [this](const Part& part) {
                                    overview_ = part;
                                    showParts();
                                  })),
      detailJob_(jobs,
                 [this](const Part& part) {
                   detailDifference_ = part;
                   showDifference();
                 }),
      overviewJob_(jobs, [this](const Part& part) {
        overviewDifference_ = part;
        showDifference();
      }) {
  connect(&document, &Document::opened, this, &ComparisonController::reset);
  connect(&document, &Document::sceneReplaced, this, &ComparisonController::refresh);
  connect(&views, &ViewController::currentChanged, this, &ComparisonController::refresh);
  connect(&views, &ViewController::rangeChanged, this, &ComparisonController::showParts);
  connect(&views, &ViewController::adjustmentChanged, this, &ComparisonController::showParts);
  connect(&views, &ViewController::partShown, this, [this] {
    if (showsDifference()) showParts();
  });
  connect(&viewport, &Viewport::viewChanged, this, &ComparisonController::wantParts);
  qApp->installEventFilter(this);
}

ComparisonController::~ComparisonController() = default;

// The kept edits were another document's.
void ComparisonController::reset() {
  mode_ = ComparisonMode::none;
  isTurned_ = false;
  kept_ = nullptr;
  if (partner_ == Partner::kept) partner_ = Partner::original;
  refresh();
}

ComparedView ComparisonController::compared() const {
  return partnerOf(views_.current(), partner_, kept_, document_);
}

void ComparisonController::setMode(ComparisonMode mode) {
  isTurned_ = false;
  mode_ = mode;
  refresh();
}

void ComparisonController::setPartner(Partner partner) {
  partner_ = partner;
  refresh();
}

void ComparisonController::setTurned(bool turned) {
  isTurned_ = turned;
  heldKey_ = lastKey_;
  sinceTurned_.start();
  refresh();
}

void ComparisonController::keepEdits() {
  kept_ = std::make_shared<const EditStack>(document_.scene().edits);
  partner_ = Partner::kept;
  refresh();
}

void ComparisonController::refresh() {
  detail_ = nullptr;
  overview_ = nullptr;
  viewport_.clearSecond();
  // What is wished once more is made once more.
  detailWatch_->want({});
  overviewWatch_->want({});
  detailJob_.stop();
  overviewJob_.stop();
  detailDifference_ = nullptr;
  overviewDifference_ = nullptr;
  views_.setBarInstead(std::nullopt);
  wantParts();
  if (!isComparing() || !document_.isOpen()) {
    viewport_.setSplit(SplitMode::none, {}, {});
  } else {
    const QString first = viewName(views_.current(), document_);
    const QString second = compared().name;
    viewport_.setSplit(splitMode(), first,
                       showsDifference() ? tr("Difference: %1 − %2").arg(first, second) : second);
  }
  Q_EMIT changed();
}

SplitMode ComparisonController::splitMode() const {
  if (isTurned_) return SplitMode::second;
  switch (mode_) {
    case ComparisonMode::none:
      return SplitMode::none;
    case ComparisonMode::wipe:
      return SplitMode::wipe;
    case ComparisonMode::sideBySide:
      return SplitMode::sideBySide;
    case ComparisonMode::difference:
      return SplitMode::second;
  }
  return SplitMode::none;
}

void ComparisonController::wantParts() {
  if (!isComparing() || !document_.isOpen()) {
    detailWatch_->want({});
    overviewWatch_->want({});
    return;
  }
  const ComparedView compared = this->compared();
  ViewRequest detail = views_.detailRequest();
  detail.view = compared.view;
  detail.marks = 0;
  detail.edits = compared.edits;
  ViewRequest overview = views_.overviewRequest();
  overview.view = compared.view;
  overview.edits = compared.edits;
  detailWatch_->want(detail);
  overviewWatch_->want(overview);
}

void ComparisonController::showParts() {
  if (!isComparing()) return;
  if (showsDifference()) {
    detailJob_.start(views_.detail(), detail_);
    overviewJob_.start(views_.overview(), overview_);
    return;
  }
  if (overview_) viewport_.setSecondOverview(views_.imageOf(*overview_));
  if (detail_)
    viewport_.setSecondDetail(views_.imageOf(*detail_), detail_->request.rect,
                              detail_->request.step);
}

// The range is that of the whole picture, so that it does not change with what is seen of it.
void ComparisonController::showDifference() {
  const Part& known = overviewDifference_ ? overviewDifference_ : detailDifference_;
  const bool ofColors = isColor(views_.current());
  const ViewDescription& view = describe(views_.current());
  ColorBarSpec bar;
  bar.name = ofColors ? tr("ΔE 2000") : tr("Difference of %1").arg(view.name);
  bar.unit = ofColors ? QString() : view.unit;
  bar.range = rangeOf(*known).value_or(DisplayRange());
  views_.setBarInstead(bar);
  const auto imageOf = [&](const Part& part) {
    return falseColorImage(*part, ScaleKind::sequential, bar.range);
  };
  if (overviewDifference_) viewport_.setSecondOverview(imageOf(overviewDifference_));
  if (detailDifference_)
    viewport_.setSecondDetail(imageOf(detailDifference_), detailDifference_->request.rect,
                              detailDifference_->request.step);
}

// A shortcut says nothing of its key's release.
bool ComparisonController::eventFilter(QObject*, QEvent* event) {
  const bool isPress =
      event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress;
  if (!isPress && event->type() != QEvent::KeyRelease) return false;
  const auto* key = static_cast<const QKeyEvent*>(event);
  if (key->isAutoRepeat()) return false;
  if (isPress) {
    lastKey_ = key->key();
    return false;
  }
  lastKey_ = 0;
  if (isTurned_ && key->key() == heldKey_ && sinceTurned_.hasExpired(kTapMs)) setTurned(false);
  return false;
}

}  // namespace cutis
