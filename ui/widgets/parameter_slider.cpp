#include "ui/widgets/parameter_slider.h"

#include <QClipboard>
#include <QContextMenuEvent>
#include <QGridLayout>
#include <QGuiApplication>
#include <QLabel>
#include <QMenu>
#include <QShortcut>

#include "ui/theme/theme.h"
#include "ui/widgets/factor_field.h"
#include "ui/widgets/factor_text.h"
#include "ui/widgets/neutral_slider.h"

namespace cutis {
namespace {

// Keys and notches that follow each other faster belong together.
constexpr int kBurstMs = 700;

}  // namespace

ParameterSlider::ParameterSlider(const QString& name, const QString& toolTip,
                                 const SliderScale& scale, QWidget* parent)
    : QWidget(parent),
      scale_(scale),
      usualToolTip_(toolTip),
      label_(new QLabel(name, this)),
      slider_(new NeutralSlider(scale, this)),
      field_(new FactorField(scale, this)),
      message_(new QLabel(this)),
      escape_(new QShortcut(Qt::Key_Escape, this)) {
  field_->setAccessibleName(tr("%1, number").arg(name));
  field_->setAccessibleDescription(limitsText(scale));
  slider_->setAccessibleName(name);
  label_->setBuddy(field_);
  setAccessibleName(name);
  setResting({});
  layOut();
  setFocusProxy(slider_);
  burst_.setSingleShot(true);
  burst_.setInterval(kBurstMs);

  connect(slider_, &NeutralSlider::valueMoved, this, &ParameterSlider::change);
  connect(field_, &FactorField::numberTyped, this,
          [this](double number) { change(number, SliderMotion::done); });
  connect(field_, &FactorField::numberStepped, this,
          [this](double number) { change(number, SliderMotion::stepping); });
  connect(field_, &FactorField::refused, this, [this](const QString& sentence) {
    message_->setText(sentence);
    message_->setVisible(!sentence.isEmpty());
    escape_->setEnabled(!sentence.isEmpty());
    Q_EMIT entryRefused();
  });
  escape_->setEnabled(false);
  // Where a message waits for Escape as well, each has its turn.
  connect(escape_, &QShortcut::activated, this, &ParameterSlider::dropEntry);
  connect(escape_, &QShortcut::activatedAmbiguously, this, &ParameterSlider::dropEntry);
  connect(&burst_, &QTimer::timeout, this, &ParameterSlider::stepEnded);
  for (QWidget* part : {static_cast<QWidget*>(slider_), static_cast<QWidget*>(field_)})
    part->installEventFilter(this);
}

void ParameterSlider::layOut() {
  QPalette alarmed = message_->palette();
  alarmed.setColor(QPalette::WindowText, theme::tones().error);
  message_->setPalette(alarmed);
  message_->setWordWrap(true);
  message_->hide();
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(theme::kSpace);
  grid->setVerticalSpacing(0);
  grid->addWidget(label_, 0, 0, 1, 2);
  grid->addWidget(slider_, 1, 0);
  grid->addWidget(field_, 1, 1);
  grid->addWidget(message_, 2, 0, 1, 2);
  grid->setColumnStretch(0, 1);
}

double ParameterSlider::value() const {
  return slider_->number();
}

void ParameterSlider::setValue(double value) {
  slider_->setNumber(value);
  field_->setNumber(slider_->number());
}

void ParameterSlider::setResting(const QString& why) {
  setEnabled(why.isEmpty());
  setToolTip(why.isEmpty() ? usualToolTip_ : why);
  field_->setToolTip(why.isEmpty() ? tr("From %1").arg(limitsText(scale_)) : why);
}

void ParameterSlider::dropEntry() {
  field_->dropEntry();
}

bool ParameterSlider::isEntryRefused() const {
  return field_->isRefused();
}

void ParameterSlider::change(double value, SliderMotion motion) {
  if (motion != SliderMotion::stepping) endBurst();
  slider_->setNumber(value);
  field_->setNumber(slider_->number());
  dropEntry();
  Q_EMIT valueChanged(value, motion == SliderMotion::dragging);
  if (motion == SliderMotion::stepping) burst_.start();
  if (motion == SliderMotion::done) Q_EMIT stepEnded();
}

void ParameterSlider::endBurst() {
  if (!burst_.isActive()) return;
  burst_.stop();
  Q_EMIT stepEnded();
}

bool ParameterSlider::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::FocusOut) endBurst();
  return QWidget::eventFilter(watched, event);
}

void ParameterSlider::enterValue() {
  field_->setFocus(Qt::ShortcutFocusReason);
  field_->selectAll();
}

void ParameterSlider::contextMenuEvent(QContextMenuEvent* event) {
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  const QAction* reset = menu->addAction(tr("&Reset to %1").arg(factorText(scale_.neutral)));
  const QAction* copy = menu->addAction(tr("&Copy value"));
  const QAction* enter = menu->addAction(tr("&Enter value"));
  connect(reset, &QAction::triggered, this, [this] {
    if (value() != scale_.neutral) change(scale_.neutral, SliderMotion::done);
  });
  connect(copy, &QAction::triggered, this,
          [this] { QGuiApplication::clipboard()->setText(factorText(value()).mid(1)); });
  connect(enter, &QAction::triggered, this, &ParameterSlider::enterValue);
  menu->popup(event->globalPos());
}

}  // namespace cutis
