#include "ui/docks/workspace.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <QDataStream>
#include <QDockWidget>
#include <QGuiApplication>
#include <QIODevice>
#include <QLayout>
#include <QScreen>
#include <QStringList>
#include <QStyle>

#include "ui/docks/dock_column.h"

namespace cutis {
namespace {

constexpr Qt::DockWidgetArea kAreas[] = {Qt::LeftDockWidgetArea, Qt::RightDockWidgetArea,
                                         Qt::TopDockWidgetArea, Qt::BottomDockWidgetArea};

// To be raised when what a layout holds becomes something else.
constexpr int kLayoutVersion = 1;
constexpr char kLayoutMark[] = "cutis layout";

// How long to wait for the user to let go of a dock.
constexpr int kStillDraggedMs = 50;

bool standsAtSide(Qt::DockWidgetArea area) {
  return area == Qt::LeftDockWidgetArea || area == Qt::RightDockWidgetArea;
}

// Whether more height shows more.
bool grows(const QDockWidget& dock) {
  return (dock.widget()->sizePolicy().expandingDirections() & Qt::Vertical) != 0;
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
  settling_.setSingleShot(true);
  connect(&settling_, &QTimer::timeout, this, &Workspace::settle);
  connect(this, &Workspace::docksChanged, this, &Workspace::tellWhatIsSeen);
}

// Docks still say that they go out of sight while they are taken down with the window.
Workspace::~Workspace() {
  for (const auto& [id, dock] : byId_)
    dock->disconnect(this);
}

void Workspace::add(const std::vector<DockDescription>& docks) {
  for (const DockDescription& description : docks) {
    Q_ASSERT(description.makePanel && !byId_.contains(description.id));
    docks_.push_back(description);
    addDock(description);
  }
}

void Workspace::addDock(const DockDescription& description) {
  auto* dock = new QDockWidget(QString(description.title).remove('&'), this);
  dock->setObjectName(description.id);
  dock->setWidget(description.makePanel());
  byId_[description.id] = dock;
  stand(description);
  // Later: while these are sent the dock is on its way.
  connect(dock, &QDockWidget::visibilityChanged, this, &Workspace::docksChanged,
          Qt::QueuedConnection);
  connect(dock, &QDockWidget::topLevelChanged, this, &Workspace::docksChanged,
          Qt::QueuedConnection);
  const auto settleSoon = [this] { settling_.start(0); };
  connect(dock, &QDockWidget::visibilityChanged, this, settleSoon);
  connect(dock, &QDockWidget::topLevelChanged, this, settleSoon);
  connect(dock, &QDockWidget::dockLocationChanged, this, settleSoon);
  // In the column it may have had the rest of the height.
  connect(
      dock, &QDockWidget::topLevelChanged, dock,
      [dock](bool floating) {
        if (floating && dock->isFloating() && !grows(*dock))
          dock->resize(dock->width(), std::min(dock->height(), dock->sizeHint().height()));
      },
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
  stand(description);
}

void Workspace::stand(const DockDescription& description) {
  QDockWidget* dock = byId_.at(description.id);
  addDockWidget(description.area, dock);
  if (!description.behind.isEmpty()) tabifyDockWidget(byId_.at(description.behind), dock);
  dock->setVisible(description.shownAtFirst);
}

void Workspace::resetLayout() {
  for (const DockDescription& description : docks_)
    placeAsDescribed(description);
  for (const Qt::DockWidgetArea area : kAreas)
    arrange(area);
  arranged_ = true;
  settling_.start(0);
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

// Where the height does not suffice, docks stand behind each other.
void Workspace::arrange(Qt::DockWidgetArea area) {
  const std::vector<QDockWidget*> column = columnOf(area);
  if (column.empty()) return;
  const auto first = std::find_if(docks_.begin(), docks_.end(), [area](const auto& description) {
    return description.area == area && description.shownAtFirst;
  });
  resizeDocks({column.front()}, {first->extent},
              standsAtSide(area) ? Qt::Horizontal : Qt::Vertical);
  if (!standsAtSide(area) || heightWanted(column) <= height()) return;
  for (std::size_t k = 1; k < column.size(); ++k)
    tabifyDockWidget(column[k - 1], column[k]);
  column.front()->raise();
}

// A dock that was hidden, came back, or was laid out for another height leaves the others with too
// much or too little: Qt divides in proportion, and panels have a height of their own.
void Workspace::settle() {
  if (!isVisible()) return;
  if (!arranged_) {
    if (!applyLayout(std::exchange(kept_, {}))) resetLayout();
  } else if (QGuiApplication::mouseButtons() != Qt::NoButton) {
    return settling_.start(kStillDraggedMs);
  }
  for (const Qt::DockWidgetArea area : kAreas) {
    if (standsAtSide(area)) settleColumn(area);
  }
}

void Workspace::settleColumn(Qt::DockWidgetArea area) {
  layout()->activate();
  const int separator = style()->pixelMetric(QStyle::PM_DockWidgetSeparatorExtent, nullptr, this);
  std::vector<QDockWidget*> column;
  for (const auto& [id, dock] : byId_) {
    const bool stands = dockWidgetArea(dock) == area && !dock->isFloating() && isInFront(id);
    if (stands) column.push_back(dock);
  }
  std::sort(column.begin(), column.end(),
            [](const QDockWidget* a, const QDockWidget* b) { return a->y() < b->y(); });
  std::vector<ColumnPlace> places;
  for (std::size_t k = 0; k < column.size(); ++k) {
    const QDockWidget* dock = column[k];
    // Below a dock that others stand behind are their tabs.
    const int end = k + 1 < column.size() ? column[k + 1]->y() - separator : height();
    const int tabs = end - dock->geometry().bottom() - 1;
    // Docks beside each other were put so by the user.
    if (tabs < 0) return;
    places.push_back({end - dock->y(), dock->sizeHint().height() + tabs, grows(*dock),
                      dock->minimumSizeHint().height() + tabs});
  }
  const std::vector<int> heights = settledHeights(places);
  resizeDocks(QList<QDockWidget*>(column.begin(), column.end()),
              QList<int>(heights.begin(), heights.end()), Qt::Vertical);
}

void Workspace::showEvent(QShowEvent* event) {
  QMainWindow::showEvent(event);
  settling_.start(0);
}

void Workspace::hideEvent(QHideEvent* event) {
  QMainWindow::hideEvent(event);
  tellWhatIsSeen();
}

void Workspace::tellWhatIsSeen() {
  for (const DockDescription& description : docks_) {
    const bool seen = isInFront(description.id);
    if (!description.seen || seen == seen_.contains(description.id)) continue;
    if (seen) {
      seen_.insert(description.id);
    } else {
      seen_.erase(description.id);
    }
    description.seen(*byId_.at(description.id)->widget(), seen);
  }
}

void Workspace::resizeEvent(QResizeEvent* event) {
  QMainWindow::resizeEvent(event);
  settling_.start(0);
}

QByteArray Workspace::saveLayout() const {
  if (!arranged_) return kept_;
  KeptLayout kept{{}, saveState(kLayoutVersion)};
  for (const DockDescription& description : docks_)
    kept.docks << description.id;
  return pack(kept);
}

bool Workspace::restoreLayout(const QByteArray& packed) {
  if (arranged_) return applyLayout(packed);
  if (!unpack(packed)) return false;
  kept_ = packed;
  return true;
}

bool Workspace::applyLayout(const QByteArray& packed) {
  const std::optional<KeptLayout> kept = unpack(packed);
  if (!kept || !restoreState(kept->state, kLayoutVersion)) return false;
  arranged_ = true;
  for (const DockDescription& description : docks_) {
    if (!kept->docks.contains(description.id)) placeAsDescribed(description);
  }
  takeBackFromNowhere();
  settling_.start(0);
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
