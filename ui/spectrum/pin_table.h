#pragma once

// The pins as a table: a row each, with place, parameters, indices and the distance in colour from
// the reference. Where something is edited the value of the edited skin follows behind an arrow. A
// double click on the name changes it. Interface thread only.

#include <string>
#include <vector>

#include <QTableWidget>

#include "src/app/document/pin_readings.h"

namespace cutis {

class PinTable : public QTableWidget {
  Q_OBJECT

 public:
  explicit PinTable(QWidget* parent = nullptr);

  void setReadings(const std::vector<PinReading>& readings, const std::string& reference);
  // Emits nothing.
  void setSelected(const std::string& letter);

 Q_SIGNALS:
  void pinSelected(const std::string& letter);
  void nameTyped(const std::string& letter, const QString& name);

 private:
  void setCell(int row, int column, const QString& text, bool isNumber = true);
  void fillRow(int row, const PinReading& reading, bool isReference);
  std::string letterIn(int row) const;

  std::vector<PinReading> readings_;
};

}  // namespace cutis
