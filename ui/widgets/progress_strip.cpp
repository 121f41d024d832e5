#include "ui/widgets/progress_strip.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <QFontDatabase>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QShortcut>
#include <QToolButton>

#include "ui/theme/theme.h"
#include "ui/widgets/cross_button.h"
#include "ui/widgets/elided_label.h"
#include "ui/widgets/message_mark.h"

namespace cutis {
namespace {

constexpr int kHeight = 32;
constexpr int kBarWidth = 140;
constexpr int kSteps = 1000;
constexpr std::size_t kMostMessages = 40;  // older ones are forgotten
constexpr int kReadingMs = 1000;           // after so long a message is taken to be read
constexpr int kNoticeMs = 10000;           // after so long a notice is old news

}  // namespace

ProgressStrip::ProgressStrip(QWidget* parent)
    : QWidget(parent),
      job_(new ElidedLabel(this)),
      bar_(new QProgressBar(this)),
      cancel_(new CrossButton(tr("Cancel"), tr("Cancel"), this)),
      messageMark_(new QLabel(this)),
      message_(new ElidedLabel(this)),
      dismiss_(new CrossButton(tr("Dismiss message"), tr("Dismiss"), this)),
      readout_(new ElidedLabel(this)),
      escape_(new QShortcut(Qt::Key_Escape, this)) {
  setFixedHeight(kHeight);
  bar_->setRange(0, kSteps);
  bar_->setTextVisible(false);
  bar_->setFixedSize(kBarWidth, 10);
  bar_->setAccessibleName(tr("Progress"));
  // Digits of one width, so that the numbers stand still while the cursor moves.
  readout_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  readout_->setAccessibleDescription(tr("Under the cursor"));

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
  // The button's own shortcut would click visibly first and act a tenth of a second late. Where an
  // entry waits for Escape as well, each has its turn.
  connect(escape_, &QShortcut::activated, this, &ProgressStrip::dismiss);
  connect(escape_, &QShortcut::activatedAmbiguously, this, &ProgressStrip::dismiss);
  age_.setSingleShot(true);
  age_.setInterval(kNoticeMs);
  connect(&age_, &QTimer::timeout, this, &ProgressStrip::dismiss);
  clearJob();
  showCurrent();
}

void ProgressStrip::setNoticeLife(int ms) {
  age_.setInterval(ms);
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
}

void ProgressStrip::clearJob() {
  jobRuns_ = false;
  job_->hide();
  bar_->hide();
  cancel_->hide();
}

const ProgressStrip::Message* ProgressStrip::current() const {
  return messages_.empty() ? nullptr : &messages_.back();
}

bool ProgressStrip::currentIsRead() const {
  return isVisible() && current() != nullptr && shownFor_.hasExpired(kReadingMs);
}

QString ProgressStrip::topicOf(const QString& text) const {
  const auto said = std::find_if(messages_.begin(), messages_.end(),
                                 [&](const Message& message) { return message.text == text; });
  return said == messages_.end() ? QString() : said->topic;
}

void ProgressStrip::showMessage(const QString& text, bool isError, const QString& topic) {
  const Message message = {text, isError, topic.isEmpty() ? topicOf(text) : topic};
  const bool isRead = currentIsRead();
  const bool waits = !isError && messageIsError() && !isRead;
  if (isRead && (isError || !messageIsError())) messages_.pop_back();
  messages_.remove_if([&](const Message& old) {
    return (old.text == text && old.isError == isError) ||
           (!message.topic.isEmpty() && old.topic == message.topic);
  });
  auto place = messages_.end();
  while (waits && place != messages_.begin() && std::prev(place)->isError)
    --place;
  messages_.insert(place, message);
  if (messages_.size() > kMostMessages) messages_.pop_front();
  showCurrent();
}

void ProgressStrip::clearMessages() {
  messages_.clear();
  showCurrent();
}

void ProgressStrip::withdraw(const QString& topic) {
  messages_.remove_if([&](const Message& message) { return message.topic == topic; });
  showCurrent();
}

void ProgressStrip::dismiss() {
  if (!messages_.empty()) messages_.pop_back();
  showCurrent();
}

QString ProgressStrip::message() const {
  return current() == nullptr ? QString() : current()->text;
}

bool ProgressStrip::messageIsError() const {
  return current() != nullptr && current()->isError;
}

void ProgressStrip::setMessagesShown(bool shown) {
  messagesShown_ = shown;
  showCurrent();
}

void ProgressStrip::showCurrent() {
  const bool any = current() != nullptr && messagesShown_;
  messageMark_->setVisible(any);
  message_->setVisible(any);
  dismiss_->setVisible(any);
  const bool isAnother = message_->text() != message();
  if (isAnother) shownFor_.start();
  if (!any || messageIsError()) {
    age_.stop();
  } else if (isAnother || !age_.isActive()) {
    age_.start();
  }
  message_->setText(message());
  messageMark_->setPixmap(messageMark(messageIsError()));
  messageMark_->setAccessibleName(messageIsError() ? tr("Error") : tr("Notice"));
  updateEscape();
  Q_EMIT messageChanged();
}

void ProgressStrip::setReadout(const QString& text) {
  readout_->setText(text);
}

// While there is nothing to dismiss, Escape belongs to whatever has the keyboard.
void ProgressStrip::updateEscape() {
  escape_->setEnabled(!message().isEmpty());
}

QString timeLeftText(double seconds) {
  if (seconds < 1) return ProgressStrip::tr("less than 1 s left");
  if (seconds < 90) return ProgressStrip::tr("%1 s left").arg(std::ceil(seconds));
  if (seconds < 5400) return ProgressStrip::tr("%1 min left").arg(std::ceil(seconds / 60));
  return ProgressStrip::tr("%1 h left").arg(std::ceil(seconds / 3600));
}

}  // namespace cutis
