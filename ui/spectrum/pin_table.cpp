#include "ui/spectrum/pin_table.h"

#include <cmath>

#include <QHeaderView>
#include <QLocale>
#include <QSignalBlocker>

#include "ui/plot/pin_colors.h"
#include "ui/theme/theme.h"
#include "ui/widgets/parameter_texts.h"

namespace cutis {
namespace {

constexpr int kLetterColumn = 0;
constexpr int kNameColumn = 1;
constexpr int kPlaceColumn = 2;
constexpr int kFirstParameter = 3;
constexpr int kFirstIndex = kFirstParameter + kParameterCount;
constexpr int kDifferenceColumn = kFirstIndex + 4;
constexpr int kColumnCount = kDifferenceColumn + 1;

QString fixedText(double value, int count) {
  return std::isfinite(value) ? QLocale().toString(value, 'f', count) : QString("–");
}

// The same words for both say nothing of an edit.
QString withEdited(const QString& original, const QString& edited) {
  return edited == original ? original : PinTable::tr("%1 → %2").arg(original, edited);
}

// Shares in per cent, as the sliders' limits are.
QString parameterValue(const PlaceSpectra& place, Parameter parameter) {
  const double factor = parameter == kCarotene ? 1.0 : 100.0;
  const int digits = parameter == kCarotene ? 4 : 2;
  const QString original = fixedText(factor * place.originalParameters[parameter], digits);
  const QString edited = fixedText(factor * place.editedParameters[parameter], digits);
  if (!place.parameterDeviation) return withEdited(original, edited);
  const QString deviation = fixedText(factor * (*place.parameterDeviation)[parameter], digits);
  const QString text = PinTable::tr("%1 ± %2").arg(original, deviation);
  return edited == original ? text : PinTable::tr("%1 → %2").arg(text, edited);
}

}  // namespace

PinTable::PinTable(QWidget* parent) : QTableWidget(0, kColumnCount, parent) {
  setAccessibleName(tr("Pins"));
  QStringList titles = {tr("Pin"), tr("Name"), tr("Place")};
  for (const Parameter parameter : kParameters) {
    titles << tr("%1, %2").arg(parameterTitle(parameter),
                               parameter == kCarotene ? parameterUnitText(parameter) : "%");
  }
  titles << tr("ITA°") << tr("Melanin index") << tr("Erythema index") << tr("Dawson’s index")
         << tr("ΔE2000");
  setHorizontalHeaderLabels(titles);
  const QString ofPosterior = tr("± one posterior standard deviation; → of the edited skin");
  for (int k = 0; k < kParameterCount; ++k)
    horizontalHeaderItem(kFirstParameter + k)->setToolTip(ofPosterior);
  horizontalHeaderItem(kFirstIndex)
      ->setToolTip(tr("Individual typology angle, atan((L* − 50) / b*) under D65, 2° observer"));
  horizontalHeaderItem(kFirstIndex + 1)
      ->setToolTip(tr("100 (A650 + A700) / 2, A = log10(1 / reflectance)"));
  horizontalHeaderItem(kFirstIndex + 2)
      ->setToolTip(tr("100 (A560 − (A650 + A510) / 2), A = log10(1 / reflectance)"));
  horizontalHeaderItem(kFirstIndex + 3)
      ->setToolTip(tr("Erythema index of Dawson et al. 1980, "
                      "100 (A560 + 1.5 (A540 + A580) − 2 (A510 + A610))"));
  horizontalHeaderItem(kDifferenceColumn)
      ->setToolTip(tr("From the reference pin, as edited, under D65; choose the reference by the "
                      "right button"));
  setSelectionBehavior(SelectRows);
  setSelectionMode(SingleSelection);
  setEditTriggers(DoubleClicked | EditKeyPressed);
  setFrameShape(NoFrame);
  setWordWrap(false);
  verticalHeader()->hide();
  verticalHeader()->setDefaultSectionSize(fontMetrics().height() + theme::kSpace);
  horizontalHeader()->setHighlightSections(false);
  connect(this, &QTableWidget::itemSelectionChanged, this, [this] {
    if (currentRow() >= 0) Q_EMIT pinSelected(letterIn(currentRow()));
  });
  connect(this, &QTableWidget::itemChanged, this, [this](QTableWidgetItem* item) {
    if (item->column() == kNameColumn) Q_EMIT nameTyped(letterIn(item->row()), item->text());
  });
}

std::string PinTable::letterIn(int row) const {
  return readings_[static_cast<std::size_t>(row)].pin.letter;
}

void PinTable::setCell(int row, int column, const QString& text, bool isNumber) {
  QTableWidgetItem* cell = item(row, column);
  if (cell == nullptr) {
    cell = new QTableWidgetItem;
    setItem(row, column, cell);
  }
  cell->setText(text);
  cell->setTextAlignment((isNumber ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  Qt::ItemFlags flags = Qt::ItemIsSelectable | Qt::ItemIsEnabled;
  if (column == kNameColumn) flags |= Qt::ItemIsEditable;
  cell->setFlags(flags);
}

void PinTable::fillRow(int row, const PinReading& reading, bool isReference) {
  const Pin& pin = reading.pin;
  setCell(row, kLetterColumn, QString::fromStdString(pin.letter), false);
  const Color color = pinColor(pinNumber(pin.letter));
  item(row, kLetterColumn)->setForeground(QColor(color.red, color.green, color.blue));
  setCell(row, kNameColumn, QString::fromStdString(pin.name), false);
  setCell(row, kPlaceColumn, QString("%1, %2").arg(pin.x).arg(pin.y));
  for (int column = kFirstParameter; column < kColumnCount; ++column)
    setCell(row, column, QString("–"));
  if (!reading.place) return;
  for (const Parameter parameter : kParameters)
    setCell(row, kFirstParameter + parameter, parameterValue(*reading.place, parameter));
  int column = kFirstIndex;
  for (const auto index : {&SkinIndices::typologyAngle, &SkinIndices::melanin,
                           &SkinIndices::erythema, &SkinIndices::dawsonErythema}) {
    setCell(row, column++,
            withEdited(fixedText(reading.original.*index, 1), fixedText(reading.edited.*index, 1)));
  }
  if (isReference) {
    setCell(row, kDifferenceColumn, tr("reference"));
  } else if (reading.difference) {
    setCell(row, kDifferenceColumn, fixedText(*reading.difference, 2));
  }
}

void PinTable::setReadings(const std::vector<PinReading>& readings, const std::string& reference) {
  const QSignalBlocker silent(this);
  const bool isLonger = readings.size() > readings_.size();
  readings_ = readings;
  setRowCount(static_cast<int>(readings.size()));
  for (std::size_t i = 0; i < readings.size(); ++i)
    fillRow(static_cast<int>(i), readings[i], readings[i].pin.letter == reference);
  if (isLonger) resizeColumnsToContents();
}

void PinTable::setSelected(const std::string& letter) {
  const QSignalBlocker silent(this);
  clearSelection();
  for (std::size_t i = 0; i < readings_.size(); ++i) {
    if (readings_[i].pin.letter == letter) selectRow(static_cast<int>(i));
  }
}

}  // namespace cutis
