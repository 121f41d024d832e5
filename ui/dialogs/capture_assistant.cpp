#include "ui/dialogs/capture_assistant.h"

#include <algorithm>
#include <set>

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFormLayout>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>

#include "src/app/open/image_search.h"
#include "src/files/rig_file.h"
#include "ui/dialogs/file_field.h"
#include "ui/theme/theme.h"

namespace cutis {
namespace {

constexpr int kThumbnail = 96;
constexpr int kMostHeight = 4 * (kThumbnail + theme::kSpace);
// The window manager's frame about the dialog.
constexpr QSize kFrame(16, 44);
constexpr double kWorthSaying = 0.001;  // of saturated pixels
constexpr char kFirstRig[] = "monitor";

// As high as its rows, up to a few of them.
class PhotographScroll : public QScrollArea {
 public:
  using QScrollArea::QScrollArea;
  QSize sizeHint() const override {
    const QSize content = widget()->sizeHint();
    return {content.width(), std::min(content.height(), kMostHeight)};
  }
};

QString text(const std::filesystem::path& path) {
  return QString::fromStdString(path.string());
}

QString textOf(LightClue clue) {
  switch (clue) {
    case LightClue::name:
      return CaptureAssistant::tr("from its name");
    case LightClue::color:
      return CaptureAssistant::tr("from its colour");
    case LightClue::order:
      return CaptureAssistant::tr("a mere guess, please check");
  }
  return {};
}

QImage imageOf(const PhotographThumbnail& thumbnail, const std::string& encoding) {
  const std::vector<std::uint8_t> bytes = screenBytes(thumbnail, encoding);
  return QImage(bytes.data(), thumbnail.width, thumbnail.height, 3 * thumbnail.width,
                QImage::Format_RGB888)
      .copy();
}

std::filesystem::path folderOf(const CaptureCandidates& candidates) {
  std::vector<std::filesystem::path> files;
  for (const CandidatePhotograph& photograph : candidates.photographs)
    files.push_back(photograph.path);
  return commonFolder(files);
}

// That of the first: what the others say is compared with it when the capture is read, and two
// names may well stand for one curve. Numbers that nobody declared linear are never taken for it.
std::string usualEncoding(const CaptureCandidates& candidates) {
  return candidates.photographs.front().encoding;
}

}  // namespace

CaptureAssistant::CaptureAssistant(const CaptureCandidates& candidates, QWidget* parent)
    : QDialog(parent),
      candidates_(candidates),
      folder_(folderOf(candidates)),
      rigs_(new QComboBox(this)),
      encoding_(new QComboBox(this)),
      mask_(new FileField(maskTexts(), folder_, this)),
      note_(new QLabel(this)),
      write_(new QPushButton(tr("&Write capture.json and open"), this)) {
  setWindowTitle(tr("Photographs of one capture"));
  setAccessibleName(windowTitle());
  note_->setWordWrap(true);
  note_->setAccessibleName(tr("What will happen"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(theme::kDoubleSpace, theme::kDoubleSpace, theme::kDoubleSpace,
                             theme::kDoubleSpace);
  column->setSpacing(theme::kSpace);
  column->addWidget(heading());
  column->addWidget(photographs(), 1);
  column->addLayout(form());
  column->addWidget(note_);
  column->addSpacing(theme::kSpace);
  column->addWidget(buttons());
  takeRig();
  showThumbnails();
  resize(sizeHint().expandedTo({560, 0}).boundedTo(screen()->availableSize() - kFrame));
}

QWidget* CaptureAssistant::heading() {
  auto* label = new QLabel(tr("Which photograph was taken under which light?"), this);
  label->setFont(theme::headingFont(*label));
  label->setWordWrap(true);
  return label;
}

QWidget* CaptureAssistant::photographs() {
  auto* content = new QWidget(this);
  auto* grid = new QGridLayout(content);
  grid->setContentsMargins(0, 0, theme::kSpace, 0);
  grid->setHorizontalSpacing(theme::kDoubleSpace);
  grid->setVerticalSpacing(theme::kSpace);
  grid->setColumnStretch(1, 1);
  for (const CandidatePhotograph& photograph : candidates_.photographs)
    addPhotograph(*grid, photograph);
  auto* scroll = new PhotographScroll(this);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setMinimumHeight(kThumbnail);
  scroll->setWidget(content);
  return scroll;
}

void CaptureAssistant::addPhotograph(QGridLayout& grid, const CandidatePhotograph& photograph) {
  const int row = static_cast<int>(rows_.size());
  const QString name = text(photograph.path.filename());
  Row widgets = {new QLabel(this), new QComboBox(this), new QLabel(this)};
  widgets.thumbnail->setFixedSize(kThumbnail, kThumbnail);
  widgets.thumbnail->setAlignment(Qt::AlignCenter);
  widgets.thumbnail->setAccessibleName(tr("Picture of %1").arg(name));
  widgets.light->setAccessibleName(tr("Light of %1").arg(name));
  widgets.light->setMinimumContentsLength(14);
  connect(widgets.light, &QComboBox::activated, this, [this, row] {
    rows_[static_cast<std::size_t>(row)].clue->setText(tr("chosen by you"));
    check();
  });
  theme::dimText(*widgets.clue);
  auto* title = new QLabel(name, this);
  title->setTextInteractionFlags(Qt::TextSelectableByMouse);
  title->setToolTip(text(photograph.path));
  QString facts = tr("%1 × %2 pixels").arg(photograph.width).arg(photograph.height);
  if (photograph.saturatedShare > kWorthSaying) {
    facts += tr(", %1 % saturated").arg(100.0 * photograph.saturatedShare, 0, 'f', 1);
  }
  auto* details = new QLabel(facts, this);
  theme::dimText(*details);
  auto* left = new QVBoxLayout;
  left->addStretch(1);
  left->addWidget(title);
  left->addWidget(details);
  left->addStretch(1);
  auto* right = new QVBoxLayout;
  right->addStretch(1);
  right->addWidget(widgets.light);
  right->addWidget(widgets.clue);
  right->addStretch(1);
  grid.addWidget(widgets.thumbnail, row, 0);
  grid.addLayout(left, row, 1);
  grid.addLayout(right, row, 2);
  rows_.push_back(widgets);
}

QLayout* CaptureAssistant::form() {
  auto* form = new QFormLayout;
  form->setContentsMargins(0, 0, 0, 0);
  form->setSpacing(theme::kSpace);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  for (const std::string& name : rigNames())
    rigs_->addItem(QString::fromStdString(name), QString::fromStdString(name));
  rigs_->addItem(tr("From a file…"));
  rigs_->setCurrentIndex(rigs_->findData(QString(kFirstRig)));
  rigs_->setAccessibleName(tr("Rig"));
  rigs_->setToolTip(tr("The camera, and the lights that there are"));
  connect(rigs_, &QComboBox::activated, this, [this] {
    if (rigs_->currentData().isNull()) chooseRig();
    takeRig();
  });
  form->addRow(tr("&Rig"), rigs_);
  encoding_->addItem(tr("Linear light"), "linear");
  encoding_->addItem(tr("Linear, whatever the files say"), "raw");
  for (const std::string& name : candidates_.colorSpaces)
    encoding_->addItem(tr("Curve of %1").arg(QString::fromStdString(name)),
                       QString::fromStdString(name));
  encoding_->setCurrentIndex(
      encoding_->findData(QString::fromStdString(usualEncoding(candidates_))));
  encoding_->setAccessibleName(tr("Numbers"));
  encoding_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  encoding_->setToolTip(tr("How the numbers of the photographs follow the light"));
  connect(encoding_, &QComboBox::currentIndexChanged, this, &CaptureAssistant::showThumbnails);
  form->addRow(tr("&Numbers"), encoding_);
  mask_->setPath(maskBeside(candidates_.photographs.front().path));
  form->addRow(tr("&Mask"), mask_);
  return form;
}

QWidget* CaptureAssistant::buttons() {
  auto* box = new QDialogButtonBox(this);
  write_->setProperty("primary", true);
  write_->setDefault(true);
  box->addButton(write_, QDialogButtonBox::AcceptRole);
  box->addButton(QDialogButtonBox::Cancel);
  auto* each = box->addButton(tr("Open &each by itself"), QDialogButtonBox::ActionRole);
  each->setToolTip(tr("As an albedo texture, behind a tab of its own"));
  connect(box, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(box, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(each, &QPushButton::clicked, this, [this] {
    std::vector<std::filesystem::path> files;
    for (const CandidatePhotograph& photograph : candidates_.photographs)
      files.push_back(photograph.path);
    Q_EMIT eachWanted(files);
    reject();
  });
  return box;
}

void CaptureAssistant::chooseRig() {
  const QString file = QFileDialog::getOpenFileName(this, tr("Choose rig"), text(folder_),
                                                    tr("Rigs (*.json);;All files (*)"));
  const int before =
      rigs_->findData(QString::fromStdString(rig_.file.empty() ? rig_.name : rig_.file));
  if (file.isEmpty()) return rigs_->setCurrentIndex(before);
  rigs_->insertItem(rigs_->count() - 1, QDir::toNativeSeparators(QFileInfo(file).fileName()), file);
  rigs_->setCurrentIndex(rigs_->count() - 2);
}

// A rig that cannot be read has no lights, and says why.
void CaptureAssistant::takeRig() {
  const std::string name = rigs_->currentData().toString().toStdString();
  const auto rig = loadRig(name, {}, "rig");
  rig_ = rig ? rig.value() : Rig{};
  rig_.file = rig && rig_.name == name ? std::string() : name;
  fillLights();
  if (rig.failed()) {
    note_->setText(QString::fromStdString(rig.error().text()));
    write_->setEnabled(false);
  }
}

void CaptureAssistant::fillLights() {
  std::vector<PhotographClues> clues;
  for (const CandidatePhotograph& photograph : candidates_.photographs)
    clues.push_back(photograph.clues);
  const std::vector<LightGuess> guesses = guessLights(clues, rig_);
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    QComboBox* box = rows_[k].light;
    box->clear();
    for (const RigLight& light : rig_.lights)
      box->addItem(QString::fromStdString(light.name));
    box->addItem(tr("Not used"));
    box->setCurrentIndex(guesses[k].light < 0 ? box->count() - 1 : guesses[k].light);
    rows_[k].clue->setText(guesses[k].light < 0 ? tr("there are no more lights")
                                                : textOf(guesses[k].clue));
  }
  check();
}

void CaptureAssistant::showThumbnails() {
  const std::string encoding = encoding_->currentData().toString().toStdString();
  const double ratio = devicePixelRatioF();
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    QPixmap pixmap = QPixmap::fromImage(imageOf(candidates_.photographs[k].thumbnail, encoding)
                                            .scaled(QSize(kThumbnail, kThumbnail) * ratio,
                                                    Qt::KeepAspectRatio, Qt::SmoothTransformation));
    pixmap.setDevicePixelRatio(ratio);
    rows_[k].thumbnail->setPixmap(pixmap);
  }
}

QString CaptureAssistant::objection() const {
  std::set<int> taken;
  for (const Row& row : rows_) {
    const int light = row.light->currentIndex();
    if (light >= static_cast<int>(rig_.lights.size())) continue;
    if (!taken.insert(light).second) {
      return tr("Two photographs have the light “%1”; choose another for one of them.")
          .arg(row.light->currentText());
    }
  }
  return taken.empty() ? tr("No photograph is used; choose the light of at least one.") : QString();
}

void CaptureAssistant::check() {
  const QString why = objection();
  write_->setEnabled(why.isEmpty());
  const QString where = tr("capture.json is written into %1; the photographs stay as they are.");
  const QString there = tr("The capture.json of %1 is replaced; the photographs stay as they are.");
  QPalette palette = note_->palette();
  palette.setColor(QPalette::WindowText,
                   why.isEmpty() ? theme::tones().dimText : theme::tones().error);
  note_->setPalette(palette);
  note_->setText(why.isEmpty() ? (hasCaptureDescription(folder_) ? there : where).arg(text(folder_))
                               : why);
}

CaptureDescription CaptureAssistant::description() const {
  CaptureDescription description;
  description.rig = rigReference(rigs_->currentData().toString().toStdString(), folder_);
  description.encoding = encoding_->currentData().toString().toStdString();
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    const auto light = static_cast<std::size_t>(rows_[k].light->currentIndex());
    if (light >= rig_.lights.size()) continue;
    description.photographs.push_back({rig_.lights[light].name, candidates_.photographs[k].path});
  }
  description.mask = mask_->path();
  return description;
}

}  // namespace cutis
