#include "ui/docks/workspace.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <QDataStream>
#include <QDockWidget>
#include <QGuiApplication>
#include <QIODevice>
#include <QScreen>
#include <QStringList>
#include <QStyle>

namespace cutis {
namespace {

constexpr Qt::DockWidgetArea kAreas[] = {Qt::LeftDockWidgetArea, Qt::RightDockWidgetArea,
                                         Qt::TopDockWidgetArea, Qt::BottomDockWidgetArea};

// To be raised when what a layout holds becomes something else.
constexpr int kLayoutVersion = 1;
constexpr char kLayoutMark[] = "cutis layout";

bool standsAtSide(Qt::DockWidgetArea area) {
  return area == Qt::LeftDockWidgetArea || area == Qt::RightDockWidgetArea;
}

struct KeptLayout {
  QStringList docks;  // that it knows
  QByteArray state;   // of QMainWindow::saveState()
};

QByteArray pack(const KeptLayout& layout) {
  QByteArray content, packed;
  QDataStream inner(&content, QIODevice::WriteOnly);
  inner << layout.docks << layout.state;
  QDataStream outer(&packed, QIODevice::WriteOnly);
  outer << QByteArray(kLayoutMark) << kLayoutVersion << qChecksum(content) << content;
  return packed;
}

std::optional<KeptLayout> unpack(const QByteArray& packed) {
  QDataStream stream(packed);
  QByteArray mark, content;
  int version = 0;
  quint16 checksum = 0;
  stream >> mark >> version >> checksum >> content;
  const bool whole = stream.status() == QDataStream::Ok && mark == kLayoutMark &&
                     version == kLayoutVersion && checksum == qChecksum(content);
  if (!whole) return std::nullopt;
  KeptLayout layout;
  QDataStream inner(content);
  inner >> layout.docks >> layout.state;
  return layout;
}

}  // namespace

Workspace::Workspace(QWidget* middle, QWidget* parent) : QMainWindow(parent) {
  setWindowFlags(Qt::Widget);
  setCentralWidget(middle);
  // The spectrum stands below the picture, between the columns.
  for (const Qt::Corner corner : {Qt::TopLeftCorner, Qt::BottomLeftCorner})
    setCorner(corner, Qt::LeftDockWidgetArea);
  for (const Qt::Corner corner : {Qt::TopRightCorner, Qt::BottomRightCorner})
    setCorner(corner, Qt::RightDockWidgetArea);
}

void Workspace::add(const std::vector<DockDescription>& docks) {
  for (const DockDescription& description : docks) {
    Q_ASSERT(description.makePanel && !byId_.contains(description.id));
    docks_.push_back(description);
    addDock(description);
  }
}

void Workspace::addDock(const DockDescription& description) {
  auto* dock = new QDockWidget(description.title, this);
  dock->setObjectName(description.id);
  dock->setWidget(description.makePanel());
  byId_[description.id] = dock;
  addDockWidget(description.area, dock);
  dock->setVisible(description.shownAtFirst);
  // Later: while these are sent the dock is on its way.
  connect(dock, &QDockWidget::visibilityChanged, this, &Workspace::docksChanged,
          Qt::QueuedConnection);
  connect(dock, &QDockWidget::topLevelChanged, this, &Workspace::docksChanged,
          Qt::QueuedConnection);
}

QDockWidget* Workspace::dock(const QString& id) const {
  const auto found = byId_.find(id);
  return found == byId_.end() ? nullptr : found->second;
}

bool Workspace::isInFront(const QString& id) const {
  const QDockWidget* dock = byId_.at(id);
  // Qt keeps a dock that stands behind another one out of sight, above and left of the window.
  const QRect place = dock->geometry();
  return dock->isVisible() && (dock->isFloating() || (place.right() >= 0 && place.bottom() >= 0));
}

void Workspace::present(const QString& id) {
  QDockWidget* dock = byId_.at(id);
  dock->show();
  dock->raise();
}

void Workspace::toggle(const QString& id) {
  if (isInFront(id)) {
    byId_.at(id)->hide();
  } else {
    present(id);
  }
}

void Workspace::placeAsDescribed(const DockDescription& description) {
  QDockWidget* dock = byId_.at(description.id);
  dock->setFloating(false);
  removeDockWidget(dock);
  addDockWidget(description.area, dock);
  dock->setVisible(description.shownAtFirst);
}

void Workspace::resetLayout() {
  for (const DockDescription& description : docks_)
    placeAsDescribed(description);
  for (const Qt::DockWidgetArea area : kAreas)
    arrange(area);
  arranged_ = true;
  Q_EMIT docksChanged();
}

std::vector<QDockWidget*> Workspace::columnOf(Qt::DockWidgetArea area) const {
  std::vector<QDockWidget*> column;
  for (const DockDescription& description : docks_) {
    if (description.area == area && description.shownAtFirst)
      column.push_back(byId_.at(description.id));
  }
  return column;
}

int Workspace::heightWanted(const std::vector<QDockWidget*>& column) const {
  int height = -style()->pixelMetric(QStyle::PM_DockWidgetSeparatorExtent, nullptr, this);
  for (const QDockWidget* dock : column)
    height += dock->sizeHint().height() +
              style()->pixelMetric(QStyle::PM_DockWidgetSeparatorExtent, nullptr, this);
  return height;
}

// Docks at the side are as high as their panels; the last one has the rest.
void Workspace::arrange(Qt::DockWidgetArea area) {
  const std::vector<QDockWidget*> column = columnOf(area);
  if (column.empty()) return;
  const auto first = std::find_if(docks_.begin(), docks_.end(), [area](const auto& description) {
    return description.area == area && description.shownAtFirst;
  });
  resizeDocks({column.front()}, {first->extent},
              standsAtSide(area) ? Qt::Horizontal : Qt::Vertical);
  if (column.size() < 2 || !standsAtSide(area)) return;
  if (heightWanted(column) > height()) {
    for (std::size_t k = 1; k < column.size(); ++k)
      tabifyDockWidget(column[k - 1], column[k]);
    column.front()->raise();
    return;
  }
  QList<int> heights;
  for (const QDockWidget* dock : column)
    heights << dock->sizeHint().height();
  heights.last() += height() - heightWanted(column);
  resizeDocks(QList<QDockWidget*>(column.begin(), column.end()), heights, Qt::Vertical);
}

void Workspace::showEvent(QShowEvent* event) {
  QMainWindow::showEvent(event);
  if (arranged_) return;
  if (!restoreLayout(std::exchange(kept_, {}))) resetLayout();
}

QByteArray Workspace::saveLayout() const {
  if (!arranged_) return kept_;
  KeptLayout kept{{}, saveState(kLayoutVersion)};
  for (const DockDescription& description : docks_)
    kept.docks << description.id;
  return pack(kept);
}

bool Workspace::restoreLayout(const QByteArray& packed) {
  const std::optional<KeptLayout> kept = unpack(packed);
  if (!kept) return false;
  if (!arranged_ && !isVisible()) {
    kept_ = packed;
    return true;
  }
  if (!restoreState(kept->state, kLayoutVersion)) return false;
  arranged_ = true;
  for (const DockDescription& description : docks_) {
    if (!kept->docks.contains(description.id)) placeAsDescribed(description);
  }
  takeBackFromNowhere();
  Q_EMIT docksChanged();
  return true;
}

// A screen that a dock floated on may be gone.
void Workspace::takeBackFromNowhere() {
  for (const auto& [id, dock] : byId_) {
    const QRect place = dock->frameGeometry();
    const auto screens = QGuiApplication::screens();
    const bool reachable = std::any_of(screens.begin(), screens.end(), [&](const QScreen* screen) {
      return screen->availableGeometry().intersects(place);
    });
    if (dock->isFloating() && !reachable) dock->setFloating(false);
  }
}

}  // namespace cutis
