#include "ui/commands/command_palette.h"

#include <algorithm>

#include <QAction>
#include <QApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QVBoxLayout>

#include "ui/commands/command_delegate.h"
#include "ui/commands/command_registry.h"
#include "ui/commands/command_search.h"
#include "ui/theme/theme.h"

namespace cutis {
namespace {

constexpr int kPaletteWidth = 560;
constexpr int kMostPaletteRows = 9;
constexpr int kPaletteRowsPerPage = 8;
constexpr int kFromTop = 48;
constexpr int kListEdge = 2;  // of the style sheet

}  // namespace

CommandPalette::CommandPalette(CommandRegistry& commands, QWidget& window)
    : QFrame(&window),
      commands_(commands),
      window_(window),
      query_(new QLineEdit(this)),
      list_(new QListWidget(this)),
      nothing_(new QLabel(tr("No command is called that."), this)) {
  setAccessibleName(tr("Command palette"));
  setAutoFillBackground(true);
  setObjectName("palette");
  query_->setAccessibleName(tr("Command"));
  query_->setPlaceholderText(tr("Type what you want to do"));
  query_->setClearButtonEnabled(true);
  list_->setAccessibleName(tr("Commands"));
  list_->setItemDelegate(new CommandDelegate(list_));
  list_->setFrameShape(QFrame::NoFrame);
  list_->setFocusPolicy(Qt::NoFocus);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  nothing_->setContentsMargins(theme::kSpace, 0, 0, theme::kHalfSpace);

  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(theme::kSpace, theme::kSpace, theme::kSpace, theme::kSpace);
  column->setSpacing(theme::kSpace);
  column->addWidget(query_);
  column->addWidget(nothing_);
  column->addWidget(list_);
  hide();

  query_->installEventFilter(this);
  window_.installEventFilter(this);
  connect(query_, &QLineEdit::textChanged, this, &CommandPalette::fill);
  connect(list_, &QListWidget::itemClicked, this, &CommandPalette::runCurrent);
  connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) {
    if (isVisible() && (now == nullptr || !isAncestorOf(now))) hide();
  });
}

void CommandPalette::open() {
  before_ = QApplication::focusWidget();
  query_->clear();
  fill({});
  show();
  raise();
  query_->setFocus();
}

// Texts, objections and shortcuts are asked for anew: they depend on what is open.
void CommandPalette::fill(const QString& query) {
  list_->clear();
  for (const CommandDescription* command : findCommands(commands_, query)) {
    const QAction& action = *commands_.action(command->id);
    auto* row = new QListWidgetItem(commands_.nameOf(*command), list_);
    row->setData(CommandDelegate::idRole, command->id);
    row->setData(CommandDelegate::placeRole, CommandRegistry::placeOf(*command));
    row->setData(CommandDelegate::shortcutRole,
                 action.shortcut().toString(QKeySequence::NativeText));
    const QString reason = command->objection ? command->objection() : QString();
    row->setData(CommandDelegate::reasonRole, reason);
    row->setData(Qt::AccessibleDescriptionRole, reason.isEmpty() ? command->toolTip : reason);
  }
  list_->setCurrentRow(0);
  placeInWindow();
}

void CommandPalette::placeInWindow() {
  const int rows = std::min(list_->count(), kMostPaletteRows);
  nothing_->setVisible(rows == 0);
  list_->setVisible(rows > 0);
  if (rows > 0) {
    const int room = window_.height() - 2 * kFromTop - query_->sizeHint().height();
    list_->setFixedHeight(
        std::min(rows * list_->sizeHintForRow(0) + 2 * kListEdge, std::max(room, 80)));
  }
  const int width = std::min(kPaletteWidth, window_.width() - 2 * theme::kDoubleSpace);
  setFixedWidth(width);
  adjustSize();
  move((window_.width() - width) / 2, kFromTop);
}

void CommandPalette::dismiss() {
  hide();
  if (before_ != nullptr) before_->setFocus();
}

// A command that cannot run stays in sight, with its reason.
void CommandPalette::runCurrent() {
  const QListWidgetItem* row = list_->currentItem();
  if (row == nullptr || !row->data(CommandDelegate::reasonRole).toString().isEmpty()) return;
  const QString id = row->data(CommandDelegate::idRole).toString();
  dismiss();
  commands_.run(id);
}

void CommandPalette::moveBy(int rows) {
  if (list_->count() == 0) return;
  list_->setCurrentRow(std::clamp(list_->currentRow() + rows, 0, list_->count() - 1));
}

bool CommandPalette::keyPressed(int key) {
  switch (key) {
    case Qt::Key_Up:
      moveBy(-1);
      return true;
    case Qt::Key_Down:
      moveBy(1);
      return true;
    case Qt::Key_PageUp:
      moveBy(-kPaletteRowsPerPage);
      return true;
    case Qt::Key_PageDown:
      moveBy(kPaletteRowsPerPage);
      return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
      runCurrent();
      return true;
    case Qt::Key_Escape:
      dismiss();
      return true;
    default:
      return false;
  }
}

bool CommandPalette::eventFilter(QObject* watched, QEvent* event) {
  if (watched == &window_) {
    if (event->type() == QEvent::Resize && isVisible()) placeInWindow();
    return false;
  }
  if (event->type() == QEvent::ShortcutOverride) {
    // Esc is a shortcut elsewhere in the window.
    if (static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) event->accept();
    return event->isAccepted() && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape;
  }
  return event->type() == QEvent::KeyPress && keyPressed(static_cast<QKeyEvent*>(event)->key());
}

}  // namespace cutis
