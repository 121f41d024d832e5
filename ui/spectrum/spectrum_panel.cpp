#include "ui/spectrum/spectrum_panel.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
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
      bar_(new QWidget(this)),
      quantities_(new QComboBox(bar_)),
      sizeLabel_(new QLabel(tr("&Mean of"), bar_)),
      sizes_(new QComboBox(bar_)),
      tableButton_(new QToolButton(bar_)),
      exportButton_(new QPushButton(tr("Export"), bar_)),
      plot_(new SpectrumPlot(this)),
      table_(new PinTable(this)) {
  makeBar();
  auto* both = new QSplitter(Qt::Horizontal, this);
  both->setChildrenCollapsible(false);
  both->addWidget(plot_);
  both->addWidget(table_);
  both->setStretchFactor(0, 1);
  both->setStretchFactor(1, 1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(bar_);
  column->addWidget(both, 1);
  arrange();
}

void SpectrumPanel::makeBar() {
  makeQuantities();
  makeSizes();
  tableButton_->setText(tr("Table"));
  tableButton_->setProperty("segment", true);
  tableButton_->setCheckable(true);
  tableButton_->setAccessibleName(tr("Table of pins"));
  tableButton_->setToolTip(tr("Parameters, indices and colour differences of the pinned places"));
  connect(tableButton_, &QToolButton::toggled, this, &SpectrumPanel::arrange);
  exportButton_->setProperty("menu", true);
  exportButton_->setToolTip(tr("Curves, figure, table and methods as files or on the clipboard"));
  auto* row = new QHBoxLayout(bar_);
  row->setContentsMargins(theme::kSpace, theme::kHalfSpace, theme::kSpace, 0);
  row->setSpacing(theme::kSpace);
  row->addWidget(quantities_);
  row->addWidget(sizeLabel_);
  row->addWidget(sizes_);
  row->addStretch(1);
  row->addWidget(tableButton_);
  row->addWidget(exportButton_);
  // The plot says how narrow the dock may be.
  bar_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
}

void SpectrumPanel::makeSizes() {
  sizeLabel_->setBuddy(sizes_);
  theme::dimText(*sizeLabel_);
  for (const int size : kPinSizes)
    sizes_->addItem(size == 1 ? tr("1 pixel") : tr("%1 × %1").arg(size), size);
  sizes_->setAccessibleName(tr("Pixels whose spectra are averaged"));
  sizes_->setToolTip(
      tr("The square about the mouse and about each pin: the mean of its pixels' spectra"));
  connect(sizes_, &QComboBox::activated, this,
          [this](int row) { Q_EMIT sizeChosen(sizes_->itemData(row).toInt()); });
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

// Menus have the exports, too.
void SpectrumPanel::fitBar() {
  sizeLabel_->show();
  exportButton_->show();
  for (QWidget* widget :
       {static_cast<QWidget*>(sizeLabel_), static_cast<QWidget*>(exportButton_)}) {
    if (bar_->sizeHint().width() > width()) widget->hide();
  }
}

void SpectrumPanel::resizeEvent(QResizeEvent*) {
  fitBar();
  arrange();
}

void SpectrumPanel::setSize(int size) {
  sizes_->setCurrentIndex(sizes_->findData(size));
}

void SpectrumPanel::setExports(QMenu* menu) {
  exportButton_->setMenu(menu);
}

}  // namespace cutis
