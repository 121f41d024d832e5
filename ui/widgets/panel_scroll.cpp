#include "ui/widgets/panel_scroll.h"

#include <algorithm>

#include <QScrollBar>
#include <QVBoxLayout>

#include "ui/theme/theme.h"

namespace cutis {
namespace {

constexpr int kLeastHeight = 64;

}  // namespace

PanelScroll::PanelScroll(QWidget* panel, QWidget* parent) : QScrollArea(parent) {
  auto* content = new QWidget(this);
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(theme::kDoubleSpace, theme::kHalfSpace, theme::kDoubleSpace,
                             theme::kSpace);
  column->addWidget(panel);
  column->addStretch(1);
  setWidget(content);
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setFocusPolicy(Qt::NoFocus);
  // More height than the panel's shows nothing more.
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Preferred);
}

QSize PanelScroll::sizeHint() const {
  return widget()->sizeHint();
}

// The bar stands in the margin of the panel.
QSize PanelScroll::minimumSizeHint() const {
  const QSize least = widget()->minimumSizeHint();
  return {least.width(), std::min(least.height(), kLeastHeight)};
}

}  // namespace cutis
