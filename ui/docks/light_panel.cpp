#include "ui/docks/light_panel.h"

#include <QButtonGroup>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QStandardItemModel>
#include <QToolButton>

#include "ui/docks/light_catalogue.h"
#include "ui/theme/theme.h"

namespace cutis {
namespace {

using Kind = LightChoice::Kind;

constexpr int kColourPage = 0;
constexpr int kBandPage = 1;

// Titles cannot be chosen; the keyboard skips them.
void addGroup(QStandardItemModel& model, const LightGroup& group, const QFont& font) {
  auto* title = new QStandardItem(group.title);
  QFont bold = font;
  bold.setBold(true);
  title->setFont(bold);
  title->setFlags(Qt::NoItemFlags);
  model.appendRow(title);
  for (const QString& name : group.names) {
    auto* item = new QStandardItem(titleOf(name));
    item->setData(name, Qt::UserRole);
    model.appendRow(item);
  }
}

int firstChoice(const QComboBox& box) {
  for (int i = 0; i < box.count(); ++i) {
    if (box.itemData(i).isValid()) return i;
  }
  return -1;
}

void choose(QComboBox& box, const QString& name) {
  const QSignalBlocker silent(box);
  const int index = box.findData(name);
  box.setCurrentIndex(index >= 0 ? index : firstChoice(box));
}

}  // namespace

LightPanel::LightPanel(QWidget* parent)
    : QWidget(parent),
      kinds_(new QButtonGroup(this)),
      pages_(new QStackedWidget(this)),
      lights_(new QComboBox(this)),
      observers_(new QComboBox(this)),
      adaptations_(new QComboBox(this)),
      band_(new QLabel(this)) {
  setAccessibleName(tr("Light"));

  auto* segments = new QHBoxLayout;
  segments->setSpacing(0);
  const auto add = [&](Kind kind, const QString& text, const QString& toolTip) {
    auto* button = new QToolButton(this);
    button->setText(text);
    button->setToolTip(toolTip);
    button->setAccessibleName(toolTip);
    button->setCheckable(true);
    button->setProperty("segment", true);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    button->setFocusPolicy(Qt::StrongFocus);
    kinds_->addButton(button, static_cast<int>(kind));
    segments->addWidget(button);
  };
  add(Kind::colour, tr("Visible"), tr("Visible light: colour under a light"));
  add(Kind::ultraviolet, tr("UV"), tr("Ultraviolet, 300–400 nm"));
  add(Kind::nearInfrared, tr("NIR"), tr("Near infrared, 700–1000 nm"));

  lights_->setAccessibleName(tr("Light source"));
  lights_->setMaxVisibleItems(20);
  observers_->setAccessibleName(tr("Observer"));
  observers_->setToolTip(tr("Whose eyes see the skin: a standard observer or a camera"));
  adaptations_->setAccessibleName(tr("Chromatic adaptation"));
  adaptations_->addItem(tr("None: as the light colours it"),
                        static_cast<int>(ChromaticAdaptation::none));
  adaptations_->addItem(tr("Bradford"), static_cast<int>(ChromaticAdaptation::bradford));
  adaptations_->addItem(tr("CAT16"), static_cast<int>(ChromaticAdaptation::cat16));
  for (QComboBox* box : {lights_, observers_, adaptations_}) {
    box->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  }
  auto* colour = new QWidget(this);
  auto* form = new QFormLayout(colour);
  form->addRow(tr("Source"), lights_);
  form->addRow(tr("Observer"), observers_);
  form->addRow(tr("Adapt"), adaptations_);
  theme::alignForm(*form);
  band_->setWordWrap(true);
  band_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  pages_->addWidget(colour);
  pages_->addWidget(band_);
  pages_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);

  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(theme::kSpace);
  column->addLayout(segments);
  column->addWidget(pages_);

  showKind(Kind::colour);
  connect(kinds_, &QButtonGroup::idClicked, this, [this](int id) {
    showKind(static_cast<Kind>(id));
    Q_EMIT changed(choice());
  });
  for (QComboBox* box : {lights_, observers_, adaptations_}) {
    connect(box, &QComboBox::currentIndexChanged, this, [this] {
      updateAdaptation();
      Q_EMIT changed(choice());
    });
  }
  updateAdaptation();
}

void LightPanel::updateAdaptation() {
  const bool isObserver = !isCamera(observers_->currentData().toString());
  adaptations_->setEnabled(isObserver);
  adaptations_->setToolTip(
      isObserver ? tr("Eyes get used to the colour of a light: white becomes the white of daylight")
                 : tr("A camera does not adapt; choose an observer"));
}

void LightPanel::setLights(const QVector<LightGroup>& groups) {
  const QSignalBlocker silent(lights_);
  const QString kept = lights_->currentData().toString();
  auto* model = new QStandardItemModel(lights_);
  for (const LightGroup& group : groups) {
    if (!group.names.isEmpty()) addGroup(*model, group, font());
  }
  delete lights_->model();
  lights_->setModel(model);
  choose(*lights_, kept);
}

void LightPanel::setObservers(const QStringList& names) {
  const QSignalBlocker silent(observers_);
  const QString kept = observers_->currentData().toString();
  observers_->clear();
  for (const QString& name : names)
    observers_->addItem(titleOf(name), name);
  choose(*observers_, kept);
  updateAdaptation();
}

LightChoice LightPanel::choice() const {
  return {lights_->currentData().toString(), observers_->currentData().toString(),
          static_cast<Kind>(kinds_->checkedId()),
          static_cast<ChromaticAdaptation>(adaptations_->currentData().toInt())};
}

void LightPanel::setChoice(const LightChoice& choice) {
  if (lights_->findData(choice.light) >= 0) choose(*lights_, choice.light);
  if (observers_->findData(choice.observer) >= 0) choose(*observers_, choice.observer);
  {
    const QSignalBlocker silent(adaptations_);
    adaptations_->setCurrentIndex(adaptations_->findData(static_cast<int>(choice.adaptation)));
  }
  updateAdaptation();
  showKind(choice.kind);
}

void LightPanel::showKind(Kind kind) {
  kinds_->button(static_cast<int>(kind))->setChecked(true);
  pages_->setCurrentIndex(kind == Kind::colour ? kColourPage : kBandPage);
  if (kind == Kind::colour) return;
  const QString band =
      kind == Kind::ultraviolet ? tr("Ultraviolet, 300–400 nm") : tr("Near infrared, 700–1000 nm");
  band_->setText(tr("%1\nRadiometric, extrapolated").arg(band));
  band_->setToolTip(
      tr("Mean reflectance over the band, shown grey. The photographs saw visible "
         "light only; the model of skin carries it on."));
}

}  // namespace cutis
