#pragma once

// A line above the picture that says something about the document and offers what can be done about
// it. It stays until one of its buttons is pressed. Interface thread only.

#include <functional>

#include <QString>
#include <QWidget>

class QPushButton;

namespace cutis {

class ElidedLabel;

class NoticeBar : public QWidget {
  Q_OBJECT

 public:
  explicit NoticeBar(QWidget* parent = nullptr);

  // accept: what `then` does about it, "Reload"; dismiss: that nothing is done, "Keep". Takes the
  // place of what was asked before.
  void ask(const QString& text, const QString& accept, const QString& dismiss,
           std::function<void()> then);
  QString text() const;

 private:
  ElidedLabel* text_;
  QPushButton* accept_;
  QPushButton* dismiss_;
  std::function<void()> then_;
};

}  // namespace cutis
