#pragma once  // internal to ui/widgets

// A line of text that is shortened with "…" where there is no room; the whole of it is its tool tip
// then.

#include <QFrame>
#include <QString>

namespace cutis {

class ElidedLabel : public QFrame {
 public:
  explicit ElidedLabel(QWidget* parent = nullptr);

  void setText(const QString& text);
  QString text() const { return text_; }

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void updateToolTip();

  QString text_;
};

}  // namespace cutis
