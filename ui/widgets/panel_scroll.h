#pragma once

// Scrolls a panel that is higher than its dock. It is never narrower than the panel, and as high
// as that where there is room. Interface thread only.

#include <QScrollArea>

namespace cutis {

class PanelScroll : public QScrollArea {
  Q_OBJECT

 public:
  // Becomes the owner of the panel.
  explicit PanelScroll(QWidget* panel, QWidget* parent = nullptr);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;
};

}  // namespace cutis
