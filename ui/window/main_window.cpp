#include "ui/window/main_window.h"

#include <QAction>
#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QMenuBar>
#include <QMimeData>
#include <QPushButton>
#include <QScreen>
#include <QSettings>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "ui/commands/command_registry.h"
#include "ui/dialogs/export_controller.h"
#include "ui/dialogs/open_controller.h"
#include "ui/dialogs/training_controller.h"
#include "ui/docks/edit_controller.h"
#include "ui/docks/fit_controller.h"
#include "ui/docks/light_controller.h"
#include "ui/docks/workspace.h"
#include "ui/theme/theme.h"
#include "ui/view/view_controller.h"
#include "ui/view/viewport.h"
#include "ui/widgets/progress_strip.h"
#include "ui/window/command_catalogue.h"
#include "ui/window/dock_catalogue.h"
#include "ui/window/job_display.h"
#include "ui/window/start_page.h"
#include "ui/window/window_size.h"

namespace cutis {
namespace {

constexpr char kGeometry[] = "geometry";
constexpr char kLayout[] = "layout";
constexpr QSize kFirstSize(1440, 900);

}  // namespace

MainWindow::MainWindow(std::unique_ptr<Engine> engine, QWidget* parent)
    : QMainWindow(parent),
      engine_(std::move(engine)),
      document_(std::make_unique<Document>(*engine_, jobs_)),
      server_(std::make_unique<ViewServer>(*document_, *engine_, jobs_)),
      pages_(new QStackedWidget(this)),
      start_(new StartPage(this)),
      viewport_(new Viewport(this)),
      workspace_(new Workspace(viewport_, this)),
      progress_(new ProgressStrip(this)),
      exportButton_(new QPushButton(tr("Export edited albedo…"), this)),
      commands_(new CommandRegistry(*this)),
      views_(std::make_unique<ViewController>(*document_, *server_, *viewport_)),
      edits_(std::make_unique<EditController>(*document_, *views_)),
      light_(std::make_unique<LightController>(*server_, *views_)),
      fit_(std::make_unique<FitController>(*document_)),
      training_(std::make_unique<TrainingController>(*document_, *engine_, jobs_, this)),
      opener_(std::make_unique<OpenController>(*document_, jobs_, *progress_, this)),
      exports_(std::make_unique<ExportController>(*document_, *engine_, jobs_, *progress_, this)) {
  new JobDisplay(jobs_, *progress_, this);
  setWindowTitle(tr("Cutis"));
  fillTables();
  layOut();
  connectStartPage();
  connectDocument();
  restoreSettings();
  refreshCommands();
}

MainWindow::~MainWindow() {
  jobs_.stopAll();
  // Docks that go out of sight say so: while those they say it to are still there.
  hide();
}

void MainWindow::fillTables() {
  const Editor editor = {*this,      *document_, *server_,    *views_,   *edits_,
                         *light_,    *fit_,      *training_,  *opener_,  *exports_,
                         *viewport_, *progress_, *workspace_, *commands_};
  workspace_->add(dockCatalogue(editor));
  commands_->add(commandCatalogue(editor));
  commands_->fill(*menuBar());
}

void MainWindow::layOut() {
  pages_->addWidget(start_);
  pages_->addWidget(workspace_);
  auto* central = new QWidget(this);
  auto* column = new QVBoxLayout(central);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(pages_, 1);
  column->addWidget(progress_);
  setCentralWidget(central);
  setAcceptDrops(true);
  // The way out stays in sight, whatever the docks do.
  auto* corner = new QWidget(this);
  auto* row = new QHBoxLayout(corner);
  row->setContentsMargins(0, 2, theme::kSpace, 1);
  row->addWidget(exportButton_);
  menuBar()->setCornerWidget(corner);
  exportButton_->hide();
  connect(exportButton_, &QPushButton::clicked, this, [this] { commands_->run("file.export"); });
}

void MainWindow::connectStartPage() {
  connect(start_, &StartPage::sampleWanted, this, [this] { commands_->run("file.openSample"); });
  connect(start_, &StartPage::captureWanted, this, [this] { commands_->run("file.openCapture"); });
  connect(start_, &StartPage::imageWanted, this, [this] { commands_->run("file.openImage"); });
  connect(start_, &StartPage::fileWanted, opener_.get(), &OpenController::open);
  connect(progress_, &ProgressStrip::messageChanged, start_,
          [this] { start_->showMessage(progress_->message(), progress_->messageIsError()); });
  progress_->setMessagesShown(false);
}

void MainWindow::connectDocument() {
  const Document* document = document_.get();
  const auto showError = [this](const QString& sentence) {
    progress_->showMessage(sentence, true);
  };
  connect(document, &Document::failed, this, showError);
  connect(server_.get(), &ViewServer::failed, this, showError);
  connect(&jobs_, &JobRunner::failed, this,
          [showError](JobId, const QString& sentence) { showError(sentence); });
  connect(document, &Document::noticed, this,
          [this](const QString& sentence) { progress_->showMessage(sentence, false); });
  connect(document, &Document::opened, this, &MainWindow::showDocument);

  connect(document, &Document::opened, this, &MainWindow::refreshCommands);
  connect(document, &Document::fitted, this, &MainWindow::refreshCommands);
  connect(document, &Document::editsChanged, this, &MainWindow::refreshCommands);
  connect(document, &Document::fitChoiceChanged, this, &MainWindow::refreshCommands);
  connect(&jobs_, &JobRunner::finished, this, &MainWindow::refreshCommands);
  connect(views_.get(), &ViewController::currentChanged, this, &MainWindow::refreshCommands);
  connect(workspace_, &Workspace::docksChanged, this, &MainWindow::refreshCommands);
}

void MainWindow::showDocument() {
  setWindowTitle(tr("%1 — Cutis").arg(document_->name()));
  // First, as it may make the menu bar higher: the workspace lays out its docks when it is shown.
  exportButton_->show();
  pages_->setCurrentWidget(workspace_);
  progress_->setMessagesShown(true);
  viewport_->setFocus();
}

void MainWindow::refreshCommands() {
  commands_->refresh();
  const QAction* action = commands_->action("file.export");
  exportButton_->setEnabled(action->isEnabled());
  exportButton_->setToolTip(action->isEnabled() ? QString() : action->toolTip());
}

bool MainWindow::isIdle() const {
  return !jobs_.isBusy() && jobs_.isIdle() && server_->isIdle();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (!event->mimeData()->hasUrls()) return;
  event->acceptProposedAction();
  start_->setDropLit(true);
}

void MainWindow::dragLeaveEvent(QDragLeaveEvent*) {
  start_->setDropLit(false);
}

void MainWindow::dropEvent(QDropEvent* event) {
  event->acceptProposedAction();
  start_->setDropLit(false);
  QStringList files;
  for (const QUrl& url : event->mimeData()->urls()) {
    if (url.isLocalFile()) files << url.toLocalFile();
  }
  opener_->openAll(files);
}

void MainWindow::closeEvent(QCloseEvent* event) {
  training_->stop();
  QSettings settings;
  settings.setValue(kGeometry, saveGeometry());
  settings.setValue(kLayout, workspace_->saveLayout());
  event->accept();
}

void MainWindow::restoreSettings() {
  start_->setRecentFiles(opener_->recentFiles());
  const QSettings settings;
  // A screen may have become smaller, or have gone.
  const QRect room = screen()->availableGeometry();
  if (!restoreGeometry(settings.value(kGeometry).toByteArray())) {
    resize(withinScreen(QRect(room.topLeft(), kFirstSize), room).size());
  } else if (!isMaximized() && !isFullScreen()) {
    setGeometry(withinScreen(geometry(), room));
  }
  // A layout that is not one leaves the docks where the table says.
  workspace_->restoreLayout(settings.value(kLayout).toByteArray());
}

}  // namespace cutis
