#include "ui/widgets/notice_bar.h"

#include <utility>

#include <QHBoxLayout>
#include <QPushButton>

#include "ui/theme/theme.h"
#include "ui/widgets/elided_label.h"

namespace cutis {

NoticeBar::NoticeBar(QWidget* parent)
    : QWidget(parent),
      text_(new ElidedLabel(this)),
      accept_(new QPushButton(this)),
      dismiss_(new QPushButton(this)) {
  setAccessibleName(tr("Notice"));
  setAutoFillBackground(true);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(theme::kSpace, theme::kHalfSpace, theme::kSpace, theme::kHalfSpace);
  row->setSpacing(theme::kSpace);
  row->addWidget(text_, 1);
  row->addWidget(accept_);
  row->addWidget(dismiss_);
  connect(accept_, &QPushButton::clicked, this, [this] {
    hide();
    then_();
  });
  connect(dismiss_, &QPushButton::clicked, this, &QWidget::hide);
  hide();
}

void NoticeBar::ask(const QString& text, const QString& accept, const QString& dismiss,
                    std::function<void()> then) {
  then_ = std::move(then);
  text_->setText(text);
  accept_->setText(accept);
  dismiss_->setText(dismiss);
  show();
}

QString NoticeBar::text() const {
  return isHidden() ? QString() : text_->text();
}

}  // namespace cutis
