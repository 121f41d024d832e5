#pragma once

// Choice of light, observer and chromatic adaptation, or of one of the bands outside the visible.
// Those are marked: they are radiometric, and extrapolated from what visible light has shown.

#include <QVector>
#include <QWidget>

#include "ui/docks/light_choice.h"

class QButtonGroup;
class QComboBox;
class QLabel;
class QStackedWidget;

namespace cutis {

class LightPanel : public QWidget {
  Q_OBJECT

 public:
  explicit LightPanel(QWidget* parent = nullptr);

  // Names as given back; shown are their titles (ui/docks/light_catalogue.h). Keep the choice where
  // it is still offered, else take the first. Silent.
  void setLights(const QVector<LightGroup>& groups);
  void setObservers(const QStringList& names);

  LightChoice choice() const;
  // Silent; names that are not offered are ignored.
  void setChoice(const LightChoice& choice);

 Q_SIGNALS:
  // By the user.
  void changed(const cutis::LightChoice& choice);

 private:
  void showKind(LightChoice::Kind kind);
  void updateAdaptation();

  QButtonGroup* kinds_;
  QStackedWidget* pages_;
  QComboBox* lights_;
  QComboBox* observers_;
  QComboBox* adaptations_;
  QLabel* band_;
};

}  // namespace cutis
