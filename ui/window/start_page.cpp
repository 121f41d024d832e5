#include "ui/window/start_page.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>

#include "ui/theme/theme.h"
#include "ui/widgets/recent_list.h"

namespace cutis {
namespace {

constexpr int kColumnWidth = 520;
constexpr int kDropHeight = 104;
constexpr int kPrimaryHeight = 40;
constexpr int kButtonHeight = 32;

void setTone(QLabel& label, const QColor& tone) {
  QPalette palette = label.palette();
  palette.setColor(QPalette::WindowText, tone);
  label.setPalette(palette);
}

QLabel* dimLabel(const QString& text, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  setTone(*label, theme::tones().dimText);
  label->setWordWrap(true);
  return label;
}

}  // namespace

StartPage::StartPage(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("Start page"));

  auto* column = new QWidget(this);
  column->setFixedWidth(kColumnWidth + 2 * theme::kSpace);
  auto* title = new QLabel(tr("Cutis"), column);
  QFont large = font();
  large.setPointSizeF(font().pointSizeF() * 2.6);
  title->setFont(large);
  auto* promise =
      dimLabel(tr("Edit skin by what it is made of: melanin, haemoglobin and carotene."), column);

  sample_ = new QPushButton(tr("Open the sample face patch"), column);
  sample_->setMinimumHeight(kPrimaryHeight);
  sample_->setDefault(true);
  sample_->setProperty("primary", true);
  auto* capture = new QPushButton(tr("Open capture…"), column);
  capture->setToolTip(
      tr("Photographs of one subject under several lights, with their capture.json"));
  auto* image = new QPushButton(tr("Open image, maps or project…"), column);
  image->setToolTip(
      tr("An albedo texture, such as an EXR, TIFF or PNG, maps that were fitted before, or a "
         "project that was saved"));
  for (QPushButton* button : {capture, image})
    button->setMinimumHeight(kButtonHeight);

  dropArea_ = new QWidget(column);
  dropArea_->setFixedHeight(kDropHeight);
  auto* dropHint = dimLabel(
      tr("or drop a capture folder, an albedo texture, maps or a project here"), dropArea_);
  dropHint->setAlignment(Qt::AlignCenter);
  auto* dropLayout = new QHBoxLayout(dropArea_);
  dropLayout->addWidget(dropHint);

  message_ = new QLabel(column);
  message_->setWordWrap(true);
  message_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  message_->setAccessibleName(tr("Message"));
  message_->hide();

  recentHeading_ = new QLabel(tr("Recent files"), column);
  recentHeading_->setFont(theme::headingFont(*this));
  recent_ = new RecentList(column);

  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(theme::kSpace);
  buttons->addWidget(capture);
  buttons->addWidget(image);
  auto* stack = new QVBoxLayout;
  stack->setContentsMargins(theme::kSpace, 0, theme::kSpace, 0);
  stack->setSpacing(theme::kSpace);
  stack->addWidget(title);
  stack->addWidget(promise);
  stack->addSpacing(theme::kDoubleSpace);
  stack->addWidget(sample_);
  stack->addLayout(buttons);
  stack->addSpacing(theme::kHalfSpace);
  stack->addWidget(dropArea_);
  stack->addWidget(message_);
  stack->addSpacing(theme::kDoubleSpace);
  stack->addWidget(recentHeading_);
  // The list is wider by the inset of its rows: its text stands below the heading's.
  auto* whole = new QVBoxLayout(column);
  whole->setContentsMargins(0, 0, 0, 0);
  whole->setSpacing(theme::kHalfSpace);
  whole->addLayout(stack);
  whole->addWidget(recent_);

  auto* page = new QVBoxLayout(this);
  page->addStretch(2);
  page->addWidget(column, 0, Qt::AlignHCenter);
  page->addStretch(3);

  connect(sample_, &QPushButton::clicked, this, &StartPage::sampleWanted);
  connect(capture, &QPushButton::clicked, this, &StartPage::captureWanted);
  connect(image, &QPushButton::clicked, this, &StartPage::imageWanted);
  connect(recent_, &RecentList::fileChosen, this, &StartPage::fileWanted);
  setRecentFiles({});
  setFocusProxy(sample_);
}

void StartPage::setRecentFiles(const QStringList& paths) {
  recent_->setFiles(paths);
  recentHeading_->setVisible(!paths.isEmpty());
  recent_->setVisible(!paths.isEmpty());
}

void StartPage::showThumbnails(const std::function<QImage(const QString& path)>& thumbnailOf) {
  recent_->showThumbnails(thumbnailOf);
}

void StartPage::showMessage(const QString& text, bool isError) {
  message_->setText(text);
  message_->setVisible(!text.isEmpty());
  setTone(*message_, isError ? theme::tones().error : theme::tones().text);
}

void StartPage::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF area(QPointF(dropArea_->mapTo(this, QPoint(0, 0))), QSizeF(dropArea_->size()));
  QPen pen(dropLit_ ? theme::tones().accent : QColor(0x6a, 0x6a, 0x6a), dropLit_ ? 2 : 1);
  pen.setDashPattern({5, 4});
  painter.setPen(pen);
  painter.setBrush(dropLit_ ? theme::tones().raised : QColor(Qt::transparent));
  painter.drawRoundedRect(area.adjusted(1, 1, -1, -1), theme::kCornerRadius + 2,
                          theme::kCornerRadius + 2);
}

void StartPage::setDropLit(bool lit) {
  dropLit_ = lit;
  update();
}

}  // namespace cutis
