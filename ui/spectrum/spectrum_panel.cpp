#include "ui/spectrum/spectrum_panel.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSplitter>
#include <QToolButton>
#include <QVBoxLayout>

#include "src/app/project/pin.h"
#include "ui/plot/spectrum_plot.h"
#include "ui/spectrum/pin_table.h"
#include "ui/theme/theme.h"

namespace cutis {
namespace {

// Of plot and table side by side.
constexpr int kRoomForBoth = 620;

}  // namespace

SpectrumPanel::SpectrumPanel(QWidget* parent)
    : QWidget(parent),
      quantities_(new QComboBox(this)),
      sizes_(new QComboBox(this)),
      tableButton_(new QToolButton(this)),
      exportButton_(new QToolButton(this)),
      plot_(new SpectrumPlot(this)),
      table_(new PinTable(this)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  auto* bar = new QHBoxLayout;
  bar->setContentsMargins(theme::kSpace, theme::kHalfSpace, theme::kSpace, 0);
  bar->setSpacing(theme::kSpace);
  makeBar(*bar);
  column->addLayout(bar);
  auto* both = new QSplitter(Qt::Horizontal, this);
  both->setChildrenCollapsible(false);
  both->addWidget(plot_);
  both->addWidget(table_);
  both->setStretchFactor(0, 1);
  both->setStretchFactor(1, 1);
  column->addWidget(both, 1);
  arrange();
}

void SpectrumPanel::makeBar(QHBoxLayout& bar) {
  auto* label = new QLabel(tr("&Mean of"), this);
  label->setBuddy(sizes_);
  theme::dimText(*label);
  for (const int size : kPinSizes)
    sizes_->addItem(size == 1 ? tr("1 pixel") : tr("%1 × %1 pixels").arg(size), size);
  sizes_->setAccessibleName(tr("Pixels whose spectra are averaged"));
  sizes_->setToolTip(
      tr("The square about the mouse and about each pin: the mean of its pixels' spectra"));
  connect(sizes_, &QComboBox::activated, this,
          [this](int row) { Q_EMIT sizeChosen(sizes_->itemData(row).toInt()); });
  tableButton_->setText(tr("Table of pins"));
  tableButton_->setCheckable(true);
  tableButton_->setToolTip(tr("Parameters, indices and colour differences of the pinned places"));
  connect(tableButton_, &QToolButton::toggled, this, &SpectrumPanel::arrange);
  exportButton_->setText(tr("Export"));
  exportButton_->setPopupMode(QToolButton::InstantPopup);
  exportButton_->setToolTip(tr("Curves, figure, table and methods as files or on the clipboard"));
  makeQuantities();
  bar.addWidget(quantities_);
  bar.addWidget(label);
  bar.addWidget(sizes_);
  bar.addStretch(1);
  bar.addWidget(tableButton_);
  bar.addWidget(exportButton_);
}

void SpectrumPanel::makeQuantities() {
  const auto add = [this](const QString& name, SpectrumQuantity quantity, const QString& toolTip) {
    quantities_->addItem(name, static_cast<int>(quantity));
    quantities_->setItemData(quantities_->count() - 1, toolTip, Qt::ToolTipRole);
  };
  add(tr("Reflectance"), SpectrumQuantity::reflectance,
      tr("Of the skin under the mouse and of pins"));
  add(tr("Absorption"), SpectrumQuantity::absorption, tr("Of epidermis and dermis, per mm"));
  add(tr("Contributions"), SpectrumQuantity::contributions,
      tr("What each chromophore takes from the reflectance: without it minus with it"));
  quantities_->setAccessibleName(tr("What the plot shows"));
  connect(quantities_, &QComboBox::activated, this, [this](int row) {
    Q_EMIT quantityChosen(static_cast<SpectrumQuantity>(quantities_->itemData(row).toInt()));
  });
}

void SpectrumPanel::arrange() {
  const bool isTable = tableButton_->isChecked();
  table_->setVisible(isTable);
  plot_->setVisible(!isTable || width() >= kRoomForBoth);
}

void SpectrumPanel::resizeEvent(QResizeEvent*) {
  arrange();
}

void SpectrumPanel::setSize(int size) {
  sizes_->setCurrentIndex(sizes_->findData(size));
}

void SpectrumPanel::setExports(QMenu* menu) {
  exportButton_->setMenu(menu);
}

}  // namespace cutis
