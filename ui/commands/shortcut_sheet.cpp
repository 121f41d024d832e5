#include "ui/commands/shortcut_sheet.h"

#include <utility>

#include <QAction>
#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "ui/commands/command_registry.h"
#include "ui/commands/command_search.h"
#include "ui/commands/key_catcher.h"
#include "ui/theme/theme.h"

namespace cutis {
namespace {

constexpr int kNameColumn = 0;
constexpr int kKeysColumn = 1;
constexpr int kIdRole = Qt::UserRole;
constexpr QSize kSheetSize(560, 560);

QString idOf(const QTreeWidgetItem* row) {
  return row == nullptr ? QString() : row->data(kNameColumn, kIdRole).toString();
}

}  // namespace

ShortcutSheet::ShortcutSheet(CommandRegistry& commands, QWidget& window)
    : QDialog(&window),
      commands_(commands),
      shortcuts_(commands),
      query_(new QLineEdit(this)),
      tree_(new QTreeWidget(this)),
      message_(new QLabel(this)) {
  setWindowTitle(tr("Keyboard shortcuts"));
  query_->setPlaceholderText(tr("Search commands and keys"));
  query_->setAccessibleName(tr("Search"));
  query_->setClearButtonEnabled(true);
  tree_->setAccessibleName(tr("Shortcuts"));
  tree_->setHeaderLabels({tr("Command"), tr("Keys")});
  tree_->setRootIsDecorated(false);
  tree_->setExpandsOnDoubleClick(false);
  tree_->setItemsExpandable(false);
  tree_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  tree_->header()->setStretchLastSection(true);
  message_->setWordWrap(true);
  message_->setMinimumHeight(2 * fontMetrics().height());
  message_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  layOut();
  connect(query_, &QLineEdit::textChanged, this, &ShortcutSheet::filter);
  connect(tree_, &QTreeWidget::itemActivated, this, &ShortcutSheet::startCatching);
  connect(tree_, &QTreeWidget::currentItemChanged, this, &ShortcutSheet::updateButtons);
}

void ShortcutSheet::layOut() {
  auto* buttons = new QDialogButtonBox(this);
  reset_ = buttons->addButton(tr("Reset"), QDialogButtonBox::ResetRole);
  reset_->setToolTip(tr("The chosen command gets its usual keys back"));
  resetAll_ = buttons->addButton(tr("Reset all"), QDialogButtonBox::ResetRole);
  resetAll_->setToolTip(tr("Every command gets its usual keys back"));
  buttons->addButton(QDialogButtonBox::Close);
  for (QAbstractButton* button : buttons->buttons())
    static_cast<QPushButton*>(button)->setAutoDefault(false);
  auto* column = new QVBoxLayout(this);
  column->setSpacing(theme::kSpace);
  column->addWidget(query_);
  column->addWidget(tree_, 1);
  column->addWidget(message_);
  column->addWidget(buttons);
  const QSize room = parentWidget()->size() - QSize(4, 8) * theme::kSpace;
  resize(kSheetSize.boundedTo(room).expandedTo({360, 320}));
  connect(reset_, &QPushButton::clicked, this, &ShortcutSheet::resetCurrent);
  connect(resetAll_, &QPushButton::clicked, this, [this] {
    shortcuts_.resetAll();
    fill();
  });
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void ShortcutSheet::open() {
  query_->clear();
  fill();
  query_->setFocus();
  QDialog::open();
}

QTreeWidgetItem* ShortcutSheet::group(const QString& title) {
  for (int at = 0; at < tree_->topLevelItemCount(); ++at) {
    if (tree_->topLevelItem(at)->text(kNameColumn) == title) return tree_->topLevelItem(at);
  }
  auto* added = new QTreeWidgetItem(tree_, {title});
  added->setFlags(Qt::ItemIsEnabled);
  added->setFont(kNameColumn, theme::headingFont(*tree_));
  added->setFirstColumnSpanned(true);
  added->setExpanded(true);
  return added;
}

void ShortcutSheet::fill() {
  stopCatching();
  const QString kept = idOf(tree_->currentItem());
  tree_->clear();
  for (const CommandDescription& command : commands_.all()) {
    auto* row =
        new QTreeWidgetItem(group(CommandRegistry::placeOf(command)), {commands_.nameOf(command)});
    row->setData(kNameColumn, kIdRole, command.id);
    row->setToolTip(kNameColumn, command.toolTip);
    row->setToolTip(kKeysColumn, tr("Double-click and press the new keys"));
    showKeys(*row);
    if (command.id == kept) tree_->setCurrentItem(row);
  }
  tree_->resizeColumnToContents(kNameColumn);
  message_->setText(tr("Double-click a command, or press Enter on it, and press its new keys."));
  filter(query_->text());
  updateButtons();
}

void ShortcutSheet::showKeys(QTreeWidgetItem& row) const {
  const QString id = idOf(&row);
  row.setText(kKeysColumn, QKeySequence::listToString(commands_.action(id)->shortcuts(),
                                                      QKeySequence::NativeText));
  QFont lettering = tree_->font();
  lettering.setBold(!shortcuts_.isUsual(id));
  row.setFont(kKeysColumn, lettering);
}

void ShortcutSheet::filter(const QString& query) {
  for (int at = 0; at < tree_->topLevelItemCount(); ++at) {
    QTreeWidgetItem& menu = *tree_->topLevelItem(at);
    bool any = false;
    for (int child = 0; child < menu.childCount(); ++child) {
      QTreeWidgetItem& row = *menu.child(child);
      const bool matches = matchQuality(query, row.text(kNameColumn),
                                        row.text(kKeysColumn) + ' ' + menu.text(kNameColumn)) > 0;
      row.setHidden(!matches);
      any = any || matches;
    }
    menu.setHidden(!any);
  }
}

void ShortcutSheet::startCatching(QTreeWidgetItem* row) {
  if (idOf(row).isEmpty()) return;
  stopCatching();
  auto* catcher = new KeyCatcher;
  connect(catcher, &KeyCatcher::caught, this, &ShortcutSheet::take);
  // One that is being replaced gives up later than the next one begins.
  connect(
      catcher, &KeyCatcher::givenUp, this,
      [this, catcher] {
        if (catching_ != nullptr && tree_->itemWidget(catching_, kKeysColumn) == catcher)
          stopCatching();
      },
      Qt::QueuedConnection);
  catching_ = row;
  tree_->setItemWidget(row, kKeysColumn, catcher);
  catcher->setFocus();
  message_->setText(tr("Press the new keys of “%1”; Backspace takes them away, Esc leaves them.")
                        .arg(row->text(kNameColumn)));
}

void ShortcutSheet::stopCatching() {
  if (catching_ == nullptr) return;
  QTreeWidgetItem* row = std::exchange(catching_, nullptr);
  const bool hadKeyboard = tree_->itemWidget(row, kKeysColumn)->hasFocus();
  tree_->removeItemWidget(row, kKeysColumn);
  if (hadKeyboard) tree_->setFocus();
  message_->clear();
}

void ShortcutSheet::take(const QKeySequence& keys) {
  if (catching_ == nullptr) return;
  const QString objection = shortcuts_.choose(idOf(catching_), keys);
  if (!objection.isEmpty()) return message_->setText(objection);
  QTreeWidgetItem* row = catching_;
  stopCatching();
  showKeys(*row);
  updateButtons();
}

void ShortcutSheet::resetCurrent() {
  QTreeWidgetItem* row = tree_->currentItem();
  if (idOf(row).isEmpty()) return;
  message_->setText(shortcuts_.reset(idOf(row)));
  showKeys(*row);
  updateButtons();
}

void ShortcutSheet::updateButtons() {
  const QString id = idOf(tree_->currentItem());
  reset_->setEnabled(!id.isEmpty() && !shortcuts_.isUsual(id));
}

}  // namespace cutis
