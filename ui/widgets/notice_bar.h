#pragma once

// A line above the picture that says something about the document and offers what can be done about
// it. It stays until one of its buttons is pressed. Interface thread only.

#include <QString>
#include <QWidget>

class QPushButton;

namespace cutis {

class ElidedLabel;

class NoticeBar : public QWidget {
  Q_OBJECT

 public:
  explicit NoticeBar(QWidget* parent = nullptr);

  // accept: what is done about it, "Reload"; dismiss: that nothing is, "Keep".
  void ask(const QString& text, const QString& accept, const QString& dismiss);
  QString text() const;

 Q_SIGNALS:
  void accepted();

 private:
  ElidedLabel* text_;
  QPushButton* accept_;
  QPushButton* dismiss_;
};

}  // namespace cutis
