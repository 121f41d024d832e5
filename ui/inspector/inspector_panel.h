#pragma once

// A table of what is known of the pixel under the cursor: names, values as found, and values as
// edited. Ctrl+C and the menu of the right button copy it. Interface thread only.

#include <vector>

#include <QTreeWidget>

#include "ui/inspector/inspector_text.h"

namespace cutis {

class InspectorPanel : public QTreeWidget {
  Q_OBJECT

 public:
  explicit InspectorPanel(QWidget* parent = nullptr);

  void showRows(const std::vector<InspectorRow>& rows);
  // In place of a table.
  void showSentence(const QString& sentence);
  const std::vector<InspectorRow>& rows() const { return rows_; }
  void copy() const;

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  std::vector<InspectorRow> rows_;
  QString sentence_;
};

}  // namespace cutis
