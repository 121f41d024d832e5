#include "ui/window/main_window.h"

#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QMimeData>
#include <QPushButton>
#include <QScrollArea>
#include <QSettings>
#include <QSplitter>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "src/app/export/export.h"
#include "ui/dialogs/training_controller.h"
#include "ui/docks/edit_controller.h"
#include "ui/docks/edit_panel.h"
#include "ui/docks/fit_controller.h"
#include "ui/docks/fit_panel.h"
#include "ui/docks/light_catalogue.h"
#include "ui/docks/light_panel.h"
#include "ui/docks/spectrum_controller.h"
#include "ui/plot/spectrum_plot.h"
#include "ui/theme/theme.h"
#include "ui/view/view_controller.h"
#include "ui/view/view_strip.h"
#include "ui/view/viewport.h"
#include "ui/widgets/progress_strip.h"
#include "ui/window/start_page.h"

namespace cutis {
namespace {

constexpr int kSidePanelWidth = 300;
constexpr int kPlotHeight = 220;
constexpr int kMostRecentFiles = 8;
constexpr char kRecentFiles[] = "recentFiles";
constexpr char kGeometry[] = "geometry";
constexpr std::size_t kMemoryForExport = std::size_t{1} << 30;

}  // namespace

MainWindow::MainWindow(std::unique_ptr<Engine> engine, QWidget* parent)
    : QMainWindow(parent),
      engine_(std::move(engine)),
      document_(std::make_unique<Document>(*engine_, jobs_)),
      server_(std::make_unique<ViewServer>(*document_, *engine_, jobs_)),
      pages_(new QStackedWidget(this)),
      start_(new StartPage(this)),
      viewport_(new Viewport(this)),
      strip_(new ViewStrip(this)),
      plot_(new SpectrumPlot(this)),
      editPanel_(new EditPanel(this)),
      lightPanel_(new LightPanel(this)),
      fitPanel_(new FitPanel(this)),
      progress_(new ProgressStrip(this)),
      exportButton_(new QPushButton(tr("Export edited albedo…"), this)),
      layers_(new ViewController(*document_, *server_, *viewport_, *strip_, this)),
      edits_(new EditController(*document_, *editPanel_, this)),
      spectrum_(new SpectrumController(*document_, *plot_, *progress_, this)),
      fit_(new FitController(*document_, *fitPanel_, this)),
      training_(new TrainingController(*document_, *engine_, jobs_, this)) {
  lightPanel_->setLights(lightGroups());
  lightPanel_->setObservers(observerChoices());
  pages_->addWidget(start_);
  pages_->addWidget(makeWorkArea());
  auto* central = new QWidget(this);
  auto* column = new QVBoxLayout(central);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(pages_, 1);
  column->addWidget(progress_);
  setCentralWidget(central);
  setAcceptDrops(true);
  makeMenus();
  connectJobs();

  connect(start_, &StartPage::sampleWanted, this, &MainWindow::openSample);
  connect(start_, &StartPage::captureWanted, this, &MainWindow::chooseCapture);
  connect(start_, &StartPage::imageWanted, this, &MainWindow::chooseImage);
  connect(start_, &StartPage::fileWanted, this, &MainWindow::openPath);
  connect(start_, &StartPage::filesWanted, this,
          [this](const QStringList& paths) { openPath(paths.first()); });
  connect(viewport_, &Viewport::cursorMoved, spectrum_, &SpectrumController::pointAt);
  connect(viewport_, &Viewport::cursorLeft, spectrum_, &SpectrumController::leave);
  connect(exportButton_, &QPushButton::clicked, this, &MainWindow::chooseExport);
  connect(fitPanel_, &FitPanel::loadWanted, this, &MainWindow::chooseProfile);
  connect(fitPanel_, &FitPanel::trainingWanted, training_, &TrainingController::train);
  connect(lightPanel_, &LightPanel::changed, this, &MainWindow::setLight);
  connect(layers_, &ViewController::currentChanged, this, &MainWindow::syncLight);
  // An edit of what is on the screen must be seen.
  connect(editPanel_, &EditPanel::factorChanged, this, [this] {
    if (layers_->current() == ViewKind::photograph) layers_->show(ViewKind::editedAlbedo);
  });
  restoreSettings();
  updateActions();
}

MainWindow::~MainWindow() {
  jobs_.stopAll();
}

QWidget* MainWindow::makeWorkArea() {
  plot_->setMinimumHeight(kPlotHeight / 2);
  auto* middle = new QSplitter(Qt::Vertical, this);
  middle->addWidget(viewport_);
  middle->addWidget(plot_);
  middle->setStretchFactor(0, 1);
  middle->setSizes({2 * kPlotHeight, kPlotHeight});
  middle->setChildrenCollapsible(false);

  auto* area = new QWidget(this);
  auto* row = new QHBoxLayout(area);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  row->addWidget(strip_);
  row->addWidget(middle, 1);
  row->addWidget(makeSidePanel());
  return area;
}

QWidget* MainWindow::makeSidePanel() {
  auto* content = new QWidget(this);
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(theme::kDoubleSpace, theme::kSpace, theme::kDoubleSpace, 0);
  column->setSpacing(theme::kDoubleSpace);
  column->addWidget(editPanel_);
  column->addWidget(lightPanel_);
  column->addWidget(fitPanel_);
  column->setAlignment(Qt::AlignTop);
  auto* scroll = new QScrollArea(this);
  scroll->setWidget(content);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  // In a low window the offer would stand below the edge. It has its place after the next layout.
  connect(
      document_.get(), &Document::networkMissing, scroll,
      [this, scroll] { scroll->ensureWidgetVisible(fitPanel_); }, Qt::QueuedConnection);

  // The way out stays in sight where a low window scrolls the rest.
  auto* foot = new QVBoxLayout;
  foot->setContentsMargins(theme::kDoubleSpace, theme::kHalfSpace, theme::kDoubleSpace,
                           theme::kHalfSpace);
  foot->addWidget(exportButton_);
  auto* side = new QWidget(this);
  side->setFixedWidth(kSidePanelWidth);
  auto* whole = new QVBoxLayout(side);
  whole->setContentsMargins(0, 0, 0, 0);
  whole->setSpacing(0);
  whole->addWidget(scroll, 1);
  whole->addLayout(foot);
  return side;
}

// The strip shows the newest job; when that ends, the one before it.
void MainWindow::connectStrip() {
  const auto show = [this](JobId id, const QString& stage, std::optional<double> fraction,
                           double left) {
    if (visibleJobs_.empty() || id != visibleJobs_.rbegin()->first) return;
    progress_->setJob({visibleJobs_.rbegin()->second, stage, fraction,
                       left < 0.0 ? std::nullopt : std::optional<double>(left)});
  };
  connect(&jobs_, &JobRunner::started, this, [this, show](JobId id, const QString& name) {
    visibleJobs_[id] = name;
    show(id, {}, std::nullopt, -1.0);
  });
  connect(&jobs_, &JobRunner::progressed, this, show);
  connect(&jobs_, &JobRunner::finished, this, [this, show](JobId id) {
    visibleJobs_.erase(id);
    if (visibleJobs_.empty()) {
      progress_->clearJob();
    } else {
      show(visibleJobs_.rbegin()->first, {}, std::nullopt, -1.0);
    }
    updateActions();
  });
  connect(progress_, &ProgressStrip::cancelWanted, this, [this] {
    if (visibleJobs_.empty()) return;
    const auto [id, name] = *visibleJobs_.rbegin();
    jobs_.cancel(id);
    progress_->showMessage(tr("%1: cancelled").arg(name), false);
  });
}

void MainWindow::connectJobs() {
  connectStrip();
  const auto showError = [this](const QString& sentence) {
    progress_->showMessage(sentence, true);
  };
  connect(document_.get(), &Document::failed, this, showError);
  connect(server_.get(), &ViewServer::failed, this, showError);
  connect(&jobs_, &JobRunner::failed, this,
          [this](JobId, const QString& sentence) { progress_->showMessage(sentence, true); });
  connect(document_.get(), &Document::noticed, this,
          [this](const QString& sentence) { progress_->showMessage(sentence, false); });
  connect(document_.get(), &Document::opened, this, &MainWindow::documentOpened);
  connect(document_.get(), &Document::fitted, this, &MainWindow::updateActions);
  connect(document_.get(), &Document::editsChanged, this, &MainWindow::updateActions);
  connect(document_.get(), &Document::fitChoiceChanged, this, &MainWindow::updateActions);
}

void MainWindow::documentOpened() {
  setWindowTitle(tr("%1 — Cutis").arg(document_->name()));
  pages_->setCurrentIndex(1);
  viewport_->setFocus();
  for (const auto& file : document_->sourceFiles())
    remember(QString::fromStdString(file.string()));
  updateActions();
}

void MainWindow::updateActions() {
  const bool open = document_->isOpen();
  const UndoHistory& history = document_->history();
  undo_->setEnabled(open && history.canUndo());
  redo_->setEnabled(open && history.canRedo());
  undo_->setText(history.canUndo() ? tr("&Undo %1").arg(history.undoName()) : tr("&Undo"));
  redo_->setText(history.canRedo() ? tr("&Redo %1").arg(history.redoName()) : tr("&Redo"));
  const bool exportable = open && document_->isFitted() && document_->scene().source != nullptr;
  for (QAction* action : {load_, train_})
    action->setEnabled(document_->canFit());
  export_->setEnabled(exportable);
  exportButton_->setEnabled(exportable);
}

void MainWindow::openSample() {
  progress_->clearMessages();
  document_->openSample();
}

void MainWindow::openPath(const QString& path) {
  progress_->clearMessages();
  document_->open(std::filesystem::path(path.toStdString()));
}

void MainWindow::exportAlbedo(const QString& path) {
  const Scene& scene = document_->scene();
  ExportTarget target = {std::filesystem::path(path.toStdString())};
  for (const std::filesystem::path& file : document_->sourceFiles())
    target.sources.push_back(file.string());
  jobs_.start(tr("Export %1").arg(QFileInfo(path).fileName()),
              [this, path, target,
               albedo = EditedAlbedo{scene, scene.source}](const JobRunner::Handle& job) {
                const auto store = std::make_shared<TileStore>(kMemoryForExport);
                const ExportOutcome outcome =
                    exportWithNotes(target, albedo, *engine_, store, job.context);
                if (outcome.status.cancelled()) return;
                const bool failed = outcome.status.failed();
                QString sentence = failed ? QString::fromStdString(outcome.status.error().text())
                                          : tr("Written: %1").arg(path);
                for (const std::string& note : outcome.notes)
                  sentence += "; " + QString::fromStdString(note);
                job.post([this, sentence, failed] { progress_->showMessage(sentence, failed); });
              });
}

void MainWindow::setLight(const LightChoice& choice) {
  lightPanel_->setChoice(choice);
  switch (choice.kind) {
    case LightChoice::Kind::ultraviolet:
      return layers_->show(ViewKind::ultraviolet);
    case LightChoice::Kind::nearInfrared:
      return layers_->show(ViewKind::nearInfrared);
    case LightChoice::Kind::colour:
      break;
  }
  PictureRequest picture;
  picture.light = choice.light.toStdString();
  picture.observer = choice.observer.toStdString();
  server_->setPicture(picture);
  layers_->show(ViewKind::skin);
}

void MainWindow::syncLight() {
  LightChoice choice = lightPanel_->choice();
  choice.kind = layers_->current() == ViewKind::ultraviolet    ? LightChoice::Kind::ultraviolet
                : layers_->current() == ViewKind::nearInfrared ? LightChoice::Kind::nearInfrared
                                                               : LightChoice::Kind::colour;
  lightPanel_->setChoice(choice);
}

bool MainWindow::isIdle() const {
  return !jobs_.isBusy() && jobs_.isIdle() && server_->isIdle();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  for (const QUrl& url : event->mimeData()->urls()) {
    if (url.isLocalFile()) return openPath(url.toLocalFile());
  }
}

void MainWindow::closeEvent(QCloseEvent* event) {
  training_->stop();
  QSettings().setValue(kGeometry, saveGeometry());
  event->accept();
}

void MainWindow::remember(const QString& path) {
  QSettings settings;
  QStringList files = settings.value(kRecentFiles).toStringList();
  const QString absolute = QFileInfo(path).absoluteFilePath();
  files.removeAll(absolute);
  files.prepend(absolute);
  settings.setValue(kRecentFiles, files.mid(0, kMostRecentFiles));
}

void MainWindow::restoreSettings() {
  const QSettings settings;
  QStringList existing;
  for (const QString& file : settings.value(kRecentFiles).toStringList()) {
    if (QFileInfo::exists(file)) existing << file;
  }
  start_->setRecentFiles(existing);
  if (!restoreGeometry(settings.value(kGeometry).toByteArray())) resize(1440, 900);
}

}  // namespace cutis
