#include "ui/spectrum/pin_controller.h"

#include <algorithm>
#include <utility>

#include <QColor>
#include <QInputDialog>

#include "ui/plot/pin_colors.h"
#include "ui/plot/spectrum_plot.h"
#include "ui/spectrum/pin_table.h"
#include "ui/spectrum/place_curves.h"
#include "ui/spectrum/spectrum_panel.h"
#include "ui/view/viewport.h"
#include "ui/widgets/progress_strip.h"

namespace cutis {
namespace {

constexpr int kLongestName = 40;

}  // namespace

PinController::PinController(Document& document, JobRunner& jobs, Viewport& viewport,
                             ProgressStrip& progress, QWidget* window)
    : document_(document), viewport_(viewport), progress_(progress), window_(window), job_(jobs) {
  connect(&viewport, &Viewport::clicked, this, &PinController::add);
  connect(&viewport, &Viewport::markerDragged, this, &PinController::move);
  connect(&viewport, &Viewport::markerPressed, this, [this](int marker) {
    select(document_.pins().pins[static_cast<std::size_t>(marker)].letter);
  });
  connect(&document, &Document::pinsChanged, this, &PinController::pinsChanged);
  connect(&document, &Document::opened, this, &PinController::pinsChanged);
  connect(&document, &Document::mapsChanged, this, &PinController::compute);
  connect(&document, &Document::sceneReplaced, this, &PinController::compute);
  connect(&document, &Document::editsChanged, this, &PinController::compute);
}

void PinController::attach(SpectrumPanel& panel) {
  panel_ = &panel;
  connect(panel_, &SpectrumPanel::sizeChosen, this, &PinController::setSize);
  connect(&panel.table(), &PinTable::pinSelected, this, &PinController::select);
  connect(&panel.table(), &PinTable::nameTyped, this, &PinController::setName);
  connect(this, &PinController::selectionChanged, &panel.table(),
          [this] { panel_->table().setSelected(selected_); });
}

void PinController::setSeen(bool seen) {
  if (seen == std::exchange(seen_, seen)) return;
  if (seen_) compute();
}

void PinController::add(int x, int y) {
  if (!document_.isOpen()) return;
  PinSet set = document_.pins();
  const std::string letter = freeLetter(set);
  if (letter.empty()) {
    return progress_.showMessage(tr("There are pins from A to Z; delete one to set another."), true,
                                 tr("Pins"));
  }
  set.pins.push_back({letter, {}, x, y});
  selected_ = letter;
  document_.setPins(set);
  Q_EMIT selectionChanged();
}

void PinController::select(const std::string& letter) {
  if (letter == selected_) return;
  selected_ = letter;
  showMarkers();
  Q_EMIT selectionChanged();
}

void PinController::move(int marker, int x, int y) {
  PinSet set = document_.pins();
  Pin& pin = set.pins[static_cast<std::size_t>(marker)];
  pin.x = x;
  pin.y = y;
  document_.setPins(set);
}

void PinController::setName(const std::string& letter, const QString& name) {
  PinSet set = document_.pins();
  const std::size_t index = pinIndex(set, letter);
  if (index == set.pins.size()) return;
  set.pins[index].name = name.simplified().left(kLongestName).toStdString();
  document_.setPins(set);
}

void PinController::setSize(int size) {
  PinSet set = document_.pins();
  set.size = size;
  document_.setPins(set);
}

void PinController::rename() {
  const PinSet& set = document_.pins();
  const std::string letter = selected_;
  auto* dialog = new QInputDialog(window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(tr("Rename pin"));
  dialog->setLabelText(tr("Name of pin %1:").arg(QString::fromStdString(letter)));
  dialog->setTextValue(QString::fromStdString(set.pins[pinIndex(set, letter)].name));
  connect(dialog, &QInputDialog::textValueSelected, this,
          [this, letter](const QString& name) { setName(letter, name); });
  dialog->open();
}

void PinController::removeSelected() {
  PinSet set = document_.pins();
  std::erase_if(set.pins, [this](const Pin& pin) { return pin.letter == selected_; });
  if (set.reference == selected_) set.reference.clear();
  document_.setPins(set);
}

void PinController::toggleReference() {
  PinSet set = document_.pins();
  set.reference = isReference() ? std::string() : selected_;
  document_.setPins(set);
}

bool PinController::isReference() const {
  return !selected_.empty() && document_.pins().reference == selected_;
}

void PinController::removeAll() {
  PinSet set = document_.pins();
  set.pins.clear();
  set.reference.clear();
  document_.setPins(set);
}

QString PinController::objectionToAll() const {
  return document_.isOpen() && !document_.pins().pins.empty()
             ? QString()
             : tr("There is no pin; click in the picture to set one");
}

QString PinController::objectionToReadings() const {
  const QString objection = objectionToAll();
  if (!objection.isEmpty()) return objection;
  if (!seen_) return tr("Pins are computed while the Spectrum dock is shown; show it (F9)");
  return job_.isRunning() ? tr("The pins are being computed; try again in a moment") : QString();
}

QString PinController::objectionToOne() const {
  const QString objection = objectionToAll();
  if (!objection.isEmpty() || !selected_.empty()) return objection;
  return tr("No pin is selected; click on one");
}

void PinController::pinsChanged() {
  const PinSet& set = document_.pins();
  if (pinIndex(set, selected_) == set.pins.size() && !std::exchange(selected_, {}).empty())
    Q_EMIT selectionChanged();
  if (panel_ != nullptr) panel_->setSize(set.size);
  showMarkers();
  compute();
}

void PinController::showMarkers() {
  const PinSet& set = document_.pins();
  QVector<PictureMarker> markers;
  for (const Pin& pin : set.pins) {
    const Color color = pinColor(pinNumber(pin.letter));
    markers << PictureMarker{QPoint(pin.x, pin.y),
                             QString::fromStdString(pin.letter),
                             QString::fromStdString(pin.name),
                             QColor(color.red, color.green, color.blue),
                             set.size,
                             pin.letter == selected_};
  }
  viewport_.setMarkers(markers);
}

void PinController::compute() {
  if (!seen_ || !document_.isOpen()) return;
  const PinSet& set = document_.pins();
  if (set.pins.empty()) {
    job_.cancel();
    return take({}, {});
  }
  job_.request([this, scene = document_.scene(), choice = document_.fitChoice(),
                set](const JobContext& context) -> std::function<void()> {
    const SceneSpectra spectra(scene, choice);
    auto readings = pinReadings(spectra, set, context);
    if (!readings) return {};
    return [this, readings = std::move(readings).value(), measured = spectra.measured()] {
      take(readings, measured);
    };
  });
}

void PinController::take(const std::vector<PinReading>& readings,
                         const std::optional<Band>& measured) {
  readings_ = readings;
  std::vector<PinnedCurves> curves;
  for (const PinReading& reading : readings) {
    if (!reading.place) continue;
    curves.push_back({QString::fromStdString(reading.pin.letter),
                      QString::fromStdString(reading.pin.name), pinNumber(reading.pin.letter),
                      placeCurves(*reading.place)});
  }
  if (panel_ != nullptr) {
    if (!curves.empty()) panel_->plot().setMeasured(measured);
    panel_->plot().setPins(curves);
    panel_->table().setReadings(readings_, document_.pins().reference);
    panel_->table().setSelected(selected_);
  }
  Q_EMIT readingsChanged();
}

}  // namespace cutis
