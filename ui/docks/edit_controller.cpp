#include "ui/docks/edit_controller.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include <QScopedValueRollback>

#include "ui/docks/edit_panel.h"
#include "ui/view/view_controller.h"
#include "ui/widgets/parameter_texts.h"
#include "ui/widgets/slider_scale.h"

namespace cutis {
namespace {

bool isHaemoglobin(int parameter) {
  return parameter == kHaemoglobinDermal || parameter == kHaemoglobinEpidermal;
}

// Linked haemoglobins move together and are undone together.
QString mergeGroupOf(int parameter) {
  return isHaemoglobin(parameter) ? "factor haemoglobin" : QString("factor %1").arg(parameter);
}

}  // namespace

bool slidersShow(const EditStack& edits) {
  const SliderScale scale;
  if (edits.empty()) return true;
  const Edit& edit = edits.front();
  return edits.size() == 1 && edit.enabled && edit.opacity == 1.0 && edit.mask.empty() &&
         std::all_of(edit.parameters.begin(), edit.parameters.end(), [&](const ParameterEdit& p) {
           return p.add == 0.0 && !p.set && p.scale >= scale.minimum && p.scale <= scale.maximum;
         });
}

EditController::EditController(Document& document, ViewController& views, QObject* parent)
    : QObject(parent), document_(document), views_(views) {
  connect(&document, &Document::opened, this, &EditController::showFactors);
  connect(&document, &Document::editsChanged, this, &EditController::showFactors);
}

void EditController::attach(EditPanel& panel) {
  connect(&panel, &EditPanel::factorChanged, this,
          [this](int parameter, double factor, bool stillMoving) {
            const QScopedValueRollback<bool> applying(applying_, true);
            change(parameter, factor, stillMoving);
          });
  connect(&panel, &EditPanel::stepEnded, this, [this] { document_.endGroup(); });
  connect(&panel, &EditPanel::resetWanted, this, &EditController::reset);
  connect(this, &EditController::factorsChanged, &panel, &EditPanel::setFactors);
  connect(this, &EditController::furtherEditsChanged, &panel, &EditPanel::setFurtherEdits);
  const auto rest = [this, &panel] { panel.setResting(objection()); };
  connect(&document_, &Document::opened, &panel, rest);
  connect(&document_, &Document::fitted, &panel, rest);
  connect(&document_, &Document::fitChoiceChanged, &panel, rest);
}

QString EditController::objection() const {
  if (!document_.isOpen()) return tr("Nothing is open yet.");
  if (document_.isFitted() || document_.isFitting()) return {};
  return tr("There is no complete estimate to edit; fit the picture again.");
}

void EditController::setFactor(int parameter, double factor, bool stillMoving) {
  change(parameter, factor, stillMoving);
  if (!stillMoving) document_.endGroup();
}

void EditController::change(int parameter, double factor, bool stillMoving) {
  if (!document_.isOpen()) return;
  const QString name = isHaemoglobin(parameter) ? haemoglobinTitle()
                                                : parameterTitle(static_cast<Parameter>(parameter));
  document_.apply({tr("%1 × %2").arg(name).arg(factor, 0, 'g', 3), mergeGroupOf(parameter),
                   [parameter, factor](DocumentState& state) {
                     if (state.edits.empty()) state.edits.emplace_back();
                     state.edits.front().parameters[static_cast<std::size_t>(parameter)].scale =
                         factor;
                   },
                   stillMoving});
  if (views_.current() == ViewKind::photograph) views_.show(ViewKind::editedAlbedo);
}

void EditController::reset() {
  if (!document_.isOpen()) return;
  document_.apply({tr("Reset"), {}, [](DocumentState& state) { state.edits.clear(); }, false});
}

void EditController::showFactors() {
  if (applying_ || !document_.isOpen()) return;
  std::array<double, kParameterCount> factors = {};
  factors.fill(1.0);
  const EditStack& edits = document_.scene().edits;
  if (!edits.empty()) {
    for (std::size_t k = 0; k < factors.size(); ++k)
      factors[k] = edits.front().parameters[k].scale;
  }
  Q_EMIT factorsChanged(factors);
  Q_EMIT furtherEditsChanged(!slidersShow(edits));
}

}  // namespace cutis
