#include "ui/widgets/progress_strip.h"

#include <algorithm>
#include <cmath>

#include <QApplication>
#include <QFontDatabase>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QProgressBar>
#include <QShortcut>
#include <QToolButton>

#include "ui/theme/theme.h"
#include "ui/widgets/elided_label.h"

namespace cutis {
namespace {

constexpr int kHeight = 32;
constexpr int kBarWidth = 140;
constexpr int kSteps = 1000;
constexpr int kMostMessages = 20;  // of each kind; older ones are forgotten

// Draws its cross itself: fonts without the sign would show a box, and pictures blur at 1.5 ×.
class CrossButton : public QToolButton {
 public:
  CrossButton(const QString& name, const QString& toolTip, QWidget* parent) : QToolButton(parent) {
    setAutoRaise(true);
    setAccessibleName(name);
    setToolTip(toolTip);
    setFocusPolicy(Qt::TabFocus);
    setFixedSize(24, 24);
  }

 protected:
  void paintEvent(QPaintEvent* event) override {
    QToolButton::paintEvent(event);
    constexpr double kArm = 4;
    const QPointF middle = QRectF(rect()).center();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(theme::tones().text, 1.6, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(middle - QPointF(kArm, kArm), middle + QPointF(kArm, kArm));
    painter.drawLine(middle - QPointF(kArm, -kArm), middle + QPointF(kArm, -kArm));
    if (hasFocus()) theme::drawFocusRing(painter, QRectF(rect()));
  }
};

// A triangle for errors, a disc for notices: never colour alone.
QPixmap messageMark(bool isError) {
  constexpr int kSize = 14;
  const double ratio = qApp->devicePixelRatio();
  QPixmap pixmap(QSize(kSize, kSize) * ratio);
  pixmap.setDevicePixelRatio(ratio);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  if (isError) {
    painter.setBrush(theme::tones().error);
    painter.drawPolygon(QPolygonF({{7, 0.5}, {13.8, 13}, {0.2, 13}}));
  } else {
    painter.setBrush(theme::tones().accent);
    painter.drawEllipse(QPointF(7, 7), 6.5, 6.5);
  }
  painter.setPen(QPen(theme::tones().field, 1.8, Qt::SolidLine, Qt::RoundCap));
  if (isError) {
    painter.drawLine(QPointF(7, 5), QPointF(7, 8.4));
    painter.drawPoint(QPointF(7, 11));
  } else {
    painter.drawPoint(QPointF(7, 4));
    painter.drawLine(QPointF(7, 6.8), QPointF(7, 10.2));
  }
  return pixmap;
}

}  // namespace

ProgressStrip::ProgressStrip(QWidget* parent)
    : QWidget(parent),
      job_(new ElidedLabel(this)),
      bar_(new QProgressBar(this)),
      cancel_(new CrossButton(tr("Cancel"), tr("Cancel (Esc)"), this)),
      messageMark_(new QLabel(this)),
      message_(new ElidedLabel(this)),
      dismiss_(new CrossButton(tr("Dismiss message"), tr("Dismiss"), this)),
      readout_(new QLabel(this)),
      escape_(new QShortcut(Qt::Key_Escape, this)) {
  setFixedHeight(kHeight);
  bar_->setRange(0, kSteps);
  bar_->setTextVisible(false);
  bar_->setFixedSize(kBarWidth, 10);
  bar_->setAccessibleName(tr("Progress"));
  // Digits of one width, so that the numbers stand still while the cursor moves.
  readout_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  readout_->setAccessibleName(tr("Under the cursor"));

  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(theme::kSpace + theme::kHalfSpace, 0, theme::kSpace + theme::kHalfSpace,
                          0);
  row->setSpacing(theme::kSpace);
  // What changes its width stands where it pushes nothing else about.
  row->addWidget(bar_);
  row->addWidget(cancel_);
  row->addWidget(job_);
  row->addStretch(1);
  row->addWidget(messageMark_);
  row->addWidget(message_);
  row->addWidget(dismiss_);
  row->addSpacing(theme::kSpace);
  row->addWidget(readout_);

  connect(cancel_, &QToolButton::clicked, this, &ProgressStrip::cancelWanted);
  connect(dismiss_, &QToolButton::clicked, this, [this] { dismiss(); });
  // The buttons' own shortcuts would click visibly first and act a tenth of a second late.
  connect(escape_, &QShortcut::activated, this, [this] {
    if (jobRuns_) {
      Q_EMIT cancelWanted();
    } else {
      dismiss();
    }
  });
  clearJob();
  showCurrent();
}

void ProgressStrip::setJob(const JobState& job) {
  QString text = job.stage.isEmpty() ? job.name : tr("%1: %2").arg(job.name, job.stage);
  if (job.fraction) {
    const double fraction = std::clamp(*job.fraction, 0.0, 1.0);
    bar_->setRange(0, kSteps);
    bar_->setValue(static_cast<int>(std::lround(kSteps * fraction)));
    text = tr("%1, %2 %").arg(text).arg(std::floor(100 * fraction));
  } else {
    bar_->setRange(0, 0);
  }
  if (job.secondsLeft) text = tr("%1, %2").arg(text, timeLeftText(*job.secondsLeft));
  job_->setText(text);
  if (jobRuns_) return;
  jobRuns_ = true;
  job_->show();
  bar_->show();
  cancel_->show();
  updateEscape();
}

void ProgressStrip::clearJob() {
  jobRuns_ = false;
  job_->hide();
  bar_->hide();
  cancel_->hide();
  updateEscape();
}

void ProgressStrip::showMessage(const QString& text, bool isError) {
  QStringList& list = isError ? errors_ : notices_;
  list.removeAll(text);
  list.append(text);
  if (list.size() > kMostMessages) list.removeFirst();
  showCurrent();
}

void ProgressStrip::clearMessages() {
  errors_.clear();
  notices_.clear();
  showCurrent();
}

void ProgressStrip::dismiss() {
  QStringList& list = errors_.isEmpty() ? notices_ : errors_;
  if (!list.isEmpty()) list.removeLast();
  showCurrent();
}

QString ProgressStrip::message() const {
  if (!errors_.isEmpty()) return errors_.last();
  return notices_.isEmpty() ? QString() : notices_.last();
}

void ProgressStrip::showCurrent() {
  const bool any = !message().isEmpty();
  messageMark_->setVisible(any);
  message_->setVisible(any);
  dismiss_->setVisible(any);
  if (any) {
    const bool isError = !errors_.isEmpty();
    messageMark_->setPixmap(messageMark(isError));
    messageMark_->setAccessibleName(isError ? tr("Error") : tr("Notice"));
    message_->setText(message());
  }
  updateEscape();
}

void ProgressStrip::setReadout(const QString& text) {
  readout_->setText(text);
}

// While there is nothing to end, Escape belongs to whatever has the keyboard.
void ProgressStrip::updateEscape() {
  escape_->setEnabled(jobRuns_ || !message().isEmpty());
}

QString timeLeftText(double seconds) {
  if (seconds < 1) return ProgressStrip::tr("less than 1 s left");
  if (seconds < 90) return ProgressStrip::tr("%1 s left").arg(std::ceil(seconds));
  if (seconds < 5400) return ProgressStrip::tr("%1 min left").arg(std::ceil(seconds / 60));
  return ProgressStrip::tr("%1 h left").arg(std::ceil(seconds / 3600));
}

}  // namespace cutis
