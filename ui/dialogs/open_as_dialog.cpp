#include "ui/dialogs/open_as_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/dialogs/file_field.h"
#include "ui/theme/theme.h"
#include "ui/widgets/panel_scroll.h"

namespace cutis {
namespace {

constexpr double kLeastExposure = 0.001;
constexpr double kMostExposure = 1000.0;
constexpr int kExposureDecimals = 3;
constexpr int kShownChoices = 16;
constexpr int kLongestWord = 24;

// Names of files and spaces may be long words without a blank: lines may break inside of them.
QString breakable(const QString& text) {
  constexpr QChar kMayBreak(0x200b);
  QString shown;
  int run = 0;
  for (const QChar c : text) {
    run = c.isSpace() ? 0 : run + 1;
    shown += c;
    if (run % kLongestWord == kLongestWord - 1 && !c.isSurrogate()) shown += kMayBreak;
  }
  return shown;
}

QLabel* wrapped(const QString& text, QWidget* parent) {
  auto* label = new QLabel(breakable(text), parent);
  label->setWordWrap(true);
  label->setTextFormat(Qt::PlainText);
  return label;
}

QString sentence(const std::string& text) {
  QString shown = QString::fromStdString(text);
  if (!shown.isEmpty()) shown[0] = shown[0].toUpper();
  return shown.endsWith('.') ? shown : shown + '.';
}

}  // namespace

OpenAsDialog::OpenAsDialog(const std::filesystem::path& path, const ImageInspection& image,
                           const QString& reason, QWidget* parent)
    : QDialog(parent),
      path_(path),
      image_(image),
      layer_(new QComboBox(this)),
      colors_(new QComboBox(this)),
      statements_(wrapped({}, this)),
      automaticExposure_(new QCheckBox(tr("&Automatic"), this)),
      exposure_(new QDoubleSpinBox(this)),
      mask_(new FileField(maskTexts(), path.parent_path(), this)),
      open_(new QPushButton(tr("&Open"), this)) {
  setWindowTitle(tr("Open as"));
  setAccessibleName(windowTitle());
  auto* form = new QFormLayout;
  form->setContentsMargins(0, 0, 0, 0);
  form->setSpacing(theme::kSpace);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  addLayer(*form);
  addColors(*form);
  addExposure(*form);
  form->addRow(tr("&Mask"), mask_);

  // Sentences may be long and the dialog small: what is above the buttons scrolls.
  auto* contents = new QWidget;
  auto* rows = new QVBoxLayout(contents);
  rows->setContentsMargins(0, theme::kSpace, 0, 0);
  rows->setSpacing(theme::kSpace);
  rows->addWidget(heading(reason));
  rows->addSpacing(theme::kSpace);
  rows->addLayout(form);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, theme::kDoubleSpace);
  column->setSpacing(theme::kSpace);
  column->addWidget(new PanelScroll(contents, this), 1);
  auto* foot = new QVBoxLayout;
  foot->setContentsMargins(theme::kDoubleSpace, 0, theme::kDoubleSpace, 0);
  foot->addWidget(buttons());
  column->addLayout(foot);
  showLayer();
  resize(sizeHint().expandedTo({520, 340}));
}

QWidget* OpenAsDialog::heading(const QString& reason) {
  auto* block = new QWidget(this);
  auto* column = new QVBoxLayout(block);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(theme::kHalfSpace);
  QLabel* name = wrapped(QString::fromStdString(path_.filename().string()), block);
  name->setFont(theme::headingFont(*name));
  column->addWidget(name);
  QLabel* format = wrapped(QString::fromStdString(image_.format), block);
  theme::dimText(*format);
  column->addWidget(format);
  if (!reason.isEmpty()) {
    QLabel* why = wrapped(reason, block);
    QPalette palette = why->palette();
    palette.setColor(QPalette::WindowText, theme::tones().error);
    why->setPalette(palette);
    why->setAccessibleName(tr("Why you are asked"));
    column->addSpacing(theme::kHalfSpace);
    column->addWidget(why);
  }
  return block;
}

void OpenAsDialog::addLayer(QFormLayout& form) {
  for (const LayerInspection& layer : image_.layers) {
    const QString channels = QString::fromStdString(layer.channels);
    layer_->addItem(layer.name.empty()
                        ? channels
                        : tr("%1 (%2)").arg(QString::fromStdString(layer.name), channels));
  }
  layer_->setCurrentIndex(static_cast<int>(image_.usualLayer));
  layer_->setAccessibleName(tr("Layer"));
  layer_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  layer_->setVisible(image_.layers.size() > 1);
  connect(layer_, &QComboBox::currentIndexChanged, this, &OpenAsDialog::showLayer);
  if (image_.layers.size() > 1) form.addRow(tr("&Layer"), layer_);
}

void OpenAsDialog::addColors(QFormLayout& form) {
  colors_->addItem({});
  for (const std::string& name : image_.colorSpaces)
    colors_->addItem(QString::fromStdString(name), QString::fromStdString(name));
  colors_->setAccessibleName(tr("Colour space"));
  colors_->setMaxVisibleItems(kShownChoices);
  colors_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  connect(colors_, &QComboBox::currentIndexChanged, this, &OpenAsDialog::showLayer);
  form.addRow(tr("&Colour space"), colors_);
  statements_->setAccessibleName(tr("What the file says"));
  theme::dimText(*statements_);
  form.addRow(QString(), statements_);
}

void OpenAsDialog::addExposure(QFormLayout& form) {
  automaticExposure_->setChecked(true);
  automaticExposure_->setToolTip(
      tr("1, unless another factor brings much more of the picture into the range of skin"));
  exposure_->setRange(kLeastExposure, kMostExposure);
  exposure_->setDecimals(kExposureDecimals);
  exposure_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  exposure_->setValue(1.0);
  exposure_->setPrefix(tr("× "));
  exposure_->setEnabled(false);
  exposure_->setAccessibleName(tr("Exposure"));
  exposure_->setToolTip(tr("Multiplies the light of the picture before it is fitted"));
  connect(automaticExposure_, &QCheckBox::toggled, exposure_, &QWidget::setDisabled);
  auto* row = new QHBoxLayout;
  row->setSpacing(theme::kSpace);
  row->addWidget(automaticExposure_);
  row->addWidget(exposure_);
  row->addStretch(1);
  form.addRow(tr("Exposure"), row);
}

QWidget* OpenAsDialog::buttons() {
  auto* box = new QDialogButtonBox(this);
  open_->setProperty("primary", true);
  open_->setDefault(true);
  box->addButton(open_, QDialogButtonBox::AcceptRole);
  box->addButton(QDialogButtonBox::Cancel);
  connect(box, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(box, &QDialogButtonBox::rejected, this, &QDialog::reject);
  return box;
}

const LayerInspection& OpenAsDialog::layer() const {
  return image_.layers[static_cast<std::size_t>(layer_->currentIndex())];
}

void OpenAsDialog::showLayer() {
  const LayerInspection& chosen = layer();
  colors_->setItemText(0, chosen.isDecided ? tr("As the file says") : tr("Choose one"));
  QStringList lines;
  if (!chosen.hasColors) {
    lines << tr("This layer has no red, green and blue; choose another.");
  } else {
    lines << sentence(chosen.decision);
    for (const std::string& contradiction : chosen.contradictions)
      lines << sentence(contradiction);
    for (const std::string& statement : chosen.statements)
      lines << tr("Stated by %1.").arg(QString::fromStdString(statement));
  }
  statements_->setText(breakable(lines.join('\n')));
  open_->setEnabled(chosen.hasColors && (chosen.isDecided || colors_->currentIndex() > 0));
}

void OpenAsDialog::showInterpretation(const OpenChoice& choice) {
  setWindowTitle(tr("Interpret as"));
  setAccessibleName(windowTitle());
  open_->setText(tr("&Apply"));
  const SourceOptions& source = choice.source;
  for (std::size_t k = 0; k < image_.layers.size(); ++k) {
    const bool isChosen = !source.layer.empty() && image_.layers[k].name == source.layer;
    if (isChosen) layer_->setCurrentIndex(static_cast<int>(k));
  }
  if (!source.colorSpace.empty()) {
    const QString name = QString::fromStdString(source.colorSpace);
    if (colors_->findData(name) < 0) colors_->addItem(name, name);
    colors_->setCurrentIndex(colors_->findData(name));
  }
  automaticExposure_->setChecked(!choice.exposure);
  exposure_->setValue(choice.exposure.value_or(1.0));
  mask_->setPath(source.mask);
}

OpenChoice OpenAsDialog::choice() const {
  OpenChoice choice;
  choice.source.layer = layer().name;
  choice.source.colorSpace = colors_->currentData().toString().toStdString();
  choice.source.mask = mask_->path();
  if (!automaticExposure_->isChecked()) choice.exposure = exposure_->value();
  return choice;
}

}  // namespace cutis
