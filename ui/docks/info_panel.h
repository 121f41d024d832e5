#pragma once

// What was said about a document, newest first: what was assumed, dropped or clipped, and what went
// wrong. The sentences can be copied. Interface thread only.

#include <QListWidget>

namespace cutis {

class InfoPanel : public QListWidget {
  Q_OBJECT

 public:
  explicit InfoPanel(QWidget* parent = nullptr);

  // A sentence that is there already comes to the top.
  void add(const QString& sentence, bool isError);
  // The oldest go, so that the newest `kept` are left.
  void keepNewest(int kept);
  // Those that are selected, or all.
  void copy() const;

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
};

}  // namespace cutis
