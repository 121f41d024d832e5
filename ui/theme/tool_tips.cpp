#include "ui/theme/tool_tips.h"

#include <QAbstractItemView>
#include <QAction>
#include <QHelpEvent>
#include <QMenu>
#include <QToolTip>

namespace cutis::theme {
namespace {

constexpr int kLongestLine = 60;

// What Qt would show at this place of the widget.
QString textAt(const QWidget& widget, const QPoint& position) {
  if (const auto* menu = qobject_cast<const QMenu*>(&widget)) {
    const QAction* action = menu->toolTipsVisible() ? menu->actionAt(position) : nullptr;
    return action ? action->toolTip() : QString();
  }
  if (const auto* view = qobject_cast<const QAbstractItemView*>(widget.parentWidget())) {
    if (view->viewport() == &widget)
      return view->indexAt(position).data(Qt::ToolTipRole).toString();
  }
  return widget.toolTip();
}

}  // namespace

ToolTips::ToolTips(QObject* application) : QObject(application) {
  application->installEventFilter(this);
}

bool ToolTips::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::ToolTip || !watched->isWidgetType()) return false;
  auto* widget = static_cast<QWidget*>(watched);
  const auto* help = static_cast<const QHelpEvent*>(event);
  const QString text = textAt(*widget, help->pos());
  if (text.size() <= kLongestLine || Qt::mightBeRichText(text)) return false;
  QToolTip::showText(help->globalPos(), "<qt>" + text.toHtmlEscaped() + "</qt>", widget);
  return true;
}

}  // namespace cutis::theme
