#include "ui/window/main_window.h"

#include <algorithm>

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

#include "src/app/document/document.h"
#include "src/app/views/view_server.h"
#include "ui/commands/command_palette.h"
#include "ui/commands/command_registry.h"
#include "ui/commands/shortcut_settings.h"
#include "ui/commands/shortcut_sheet.h"
#include "ui/compare/comparison_controller.h"
#include "ui/dialogs/open_controller.h"
#include "ui/dialogs/reopen_controller.h"
#include "ui/dialogs/save_controller.h"
#include "ui/docks/workspace.h"
#include "ui/documents/document_page.h"
#include "ui/documents/document_tabs.h"
#include "ui/documents/job_display.h"
#include "ui/menus/command_catalogue.h"
#include "ui/menus/editor.h"
#include "ui/spectrum/pin_controller.h"
#include "ui/spectrum/spectrum_export.h"
#include "ui/theme/theme.h"
#include "ui/view/adjustment_bar.h"
#include "ui/view/view_controller.h"
#include "ui/view/viewport.h"
#include "ui/widgets/progress_strip.h"
#include "ui/window/close_guard.h"
#include "ui/window/file_thumbnails.h"
#include "ui/window/recent_menu.h"
#include "ui/window/recovery.h"
#include "ui/window/source_finder.h"
#include "ui/window/start_page.h"
#include "ui/window/window_size.h"

namespace cutis {
namespace {

constexpr char kGeometry[] = "geometry";
constexpr char kLayout[] = "layout";
constexpr QSize kFirstSize(1440, 900);
constexpr int kSourceCheckMs = 2000;

}  // namespace

MainWindow::MainWindow(std::unique_ptr<Engine> engine, QWidget* parent)
    : QMainWindow(parent),
      engine_(std::move(engine)),
      contents_(new QStackedWidget(this)),
      start_(new StartPage(this)),
      progress_(new ProgressStrip(this)),
      jobDisplay_(new JobDisplay(*progress_, this)),
      adjustments_(new AdjustmentBar(this)),
      exportButton_(new QPushButton(tr("Export edited albedo…"), this)),
      commands_(new CommandRegistry(*this)),
      opener_(new OpenController(jobs_, *progress_, this)),
      thumbnails_(new FileThumbnails(jobs_, thumbnailFolder(), this)),
      tabs_(new DocumentTabs(
          [this](QWidget* stack) {
            return new DocumentPage(*engine_, *progress_, *commands_, stack);
          },
          this)),
      closing_(new CloseGuard(*tabs_, *progress_, *this)),
      finder_(new SourceFinder(*tabs_, *this)),
      recovery_(new Recovery(*tabs_, *progress_, *this)) {
  jobDisplay_->watch(jobs_);
  connect(tabs_, &DocumentTabs::pageMade, this, &MainWindow::connectPage);
  tabs_->begin();
  fillTables();
  layOut();
  connectStartPage();
  connectOpening();
  restoreSettings();
  showCurrent();
}

// Pages go first: they tell the others.
MainWindow::~MainWindow() {
  jobs_.stopAll();
  disconnect(tabs_, nullptr, this, nullptr);
  delete tabs_;
}

void MainWindow::keepJournals(const std::filesystem::path& folder) {
  recovery_->begin(folder);
}

void MainWindow::setUsualFit(const FitChoice& choice) {
  usualFit_ = choice;
  for (DocumentPage* page : tabs_->pages())
    page->document().setUsualFit(choice);
}

void MainWindow::fillTables() {
  auto* palette = new CommandPalette(*commands_, *this);
  auto* shortcuts = new ShortcutSheet(*commands_, *this);
  commands_->add(commandCatalogue({*this, *tabs_, *opener_, *palette, *shortcuts, *jobDisplay_}));
  ShortcutSettings(*commands_).restore();
  commands_->fill(*menuBar());
  addRecentMenu();
}

void MainWindow::addRecentMenu() {
  auto* recent = new RecentMenu([this] { return opener_->recentFiles(); }, this);
  connect(recent, &RecentMenu::openWanted, opener_, &OpenController::open);
  connect(recent, &RecentMenu::clearWanted, this, [this] {
    forgetRecentFiles();
    thumbnails_->clear();
    start_->setRecentFiles({});
  });
  const auto thumbnailOf = [this](const QString& file) { return thumbnails_->of(file); };
  connect(recent, &QMenu::aboutToShow, this, [this, recent, thumbnailOf] {
    recent->showThumbnails(thumbnailOf);
    thumbnails_->look(opener_->recentFiles());
  });
  connect(thumbnails_, &FileThumbnails::changed, this, [this, recent, thumbnailOf] {
    recent->showThumbnails(thumbnailOf);
    start_->showThumbnails(thumbnailOf);
  });
  // Behind what else opens files.
  QMenu* file = menuBar()->actions().front()->menu();
  const QList<QAction*> rows = file->actions();
  file->insertMenu(rows[rows.indexOf(commands_->action("file.interpretAs")) - 1], recent);
}

void MainWindow::keepThumbnail(DocumentPage& page) {
  const QString file = OpenController::fileOf(page.document());
  if (!file.isEmpty()) thumbnails_->keep(file, page.views().firstPicture(), opener_->recentFiles());
}

void MainWindow::layOut() {
  contents_->addWidget(start_);
  contents_->addWidget(tabs_);
  auto* central = new QWidget(this);
  auto* column = new QVBoxLayout(central);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(contents_, 1);
  column->addWidget(progress_);
  setCentralWidget(central);
  setAcceptDrops(true);
  layOutCorner();
}

void MainWindow::layOutCorner() {
  // The way out stays in sight, whatever the docks do.
  auto* corner = new QWidget(this);
  auto* row = new QHBoxLayout(corner);
  row->setContentsMargins(0, 2, theme::kSpace, 1);
  row->setSpacing(theme::kDoubleSpace);
  row->addWidget(adjustments_);
  row->addWidget(exportButton_);
  menuBar()->setCornerWidget(corner);
  connect(exportButton_, &QPushButton::clicked, this, [this] { commands_->run("file.export"); });
  connect(adjustments_, &AdjustmentBar::chosen, this,
          [this](const ViewAdjustment& adjustment) { views().setAdjustment(adjustment); });
}

void MainWindow::connectStartPage() {
  connect(start_, &StartPage::sampleWanted, this, [this] { commands_->run("file.openSample"); });
  connect(start_, &StartPage::captureWanted, this, [this] { commands_->run("file.openCapture"); });
  connect(start_, &StartPage::imageWanted, this, [this] { commands_->run("file.openImage"); });
  connect(start_, &StartPage::fileWanted, opener_, &OpenController::open);
  connect(progress_, &ProgressStrip::messageChanged, start_,
          [this] { start_->showMessage(progress_->message(), progress_->messageIsError()); });
}

void MainWindow::connectOpening() {
  connect(opener_, &OpenController::openWanted, tabs_, &DocumentTabs::open);
  connect(opener_, &OpenController::openAsWanted, tabs_, &DocumentTabs::openAs);
  connect(&jobs_, &JobRunner::failed, this,
          [this](JobId, const QString& sentence) { progress_->showMessage(sentence, true); });
  connect(&jobs_, &JobRunner::finished, this, &MainWindow::refreshCommands);
  connect(tabs_, &DocumentTabs::currentChanged, this, &MainWindow::showCurrent);
  connect(tabs_, &DocumentTabs::closeWanted, closing_, &CloseGuard::closePage);
  connect(tabs_, &DocumentTabs::openedBehind, this, [this](DocumentPage& page) {
    progress_->showMessage(tr("%1 is open in a tab of its own").arg(page.document().name()), false);
  });
  sourceTimer_.setInterval(kSourceCheckMs);
  connect(&sourceTimer_, &QTimer::timeout, this, &MainWindow::checkSources);
}

void MainWindow::connectPage(DocumentPage& page) {
  jobDisplay_->watch(page.jobs());
  page.document().setUsualFit(usualFit_);
  connectMessages(page);
  connectSaving(page);
  const Document* document = &page.document();
  connect(document, &Document::openingFailed, opener_, &OpenController::openAs);
  connect(&page.reopening(), &ReopenController::pictureWanted, opener_, &OpenController::open);
  connect(document, &Document::opened, this, [this, document] { opener_->remember(*document); });
  connect(&page.views(), &ViewController::firstPictureSeen, this,
          [this, &page] { keepThumbnail(page); });
  connect(document, &Document::fitted, this, &MainWindow::refreshCommands);
  connect(document, &Document::editsChanged, this, &MainWindow::refreshCommands);
  connect(document, &Document::fitChoiceChanged, this, &MainWindow::refreshCommands);
  connect(document, &Document::pinsChanged, this, &MainWindow::refreshCommands);
  connect(&page.pins(), &PinController::selectionChanged, this, &MainWindow::refreshCommands);
  connect(&page.spectrumExport(), &SpectrumExport::objectionsChanged, this,
          &MainWindow::refreshCommands);
  connect(&page.jobs(), &JobRunner::started, this, &MainWindow::refreshCommands);
  connect(&page.jobs(), &JobRunner::finished, this, &MainWindow::refreshCommands);
  connect(&page.views(), &ViewController::currentChanged, this, &MainWindow::refreshCommands);
  connect(&page.views(), &ViewController::rangeChanged, this, &MainWindow::refreshCommands);
  connect(&page.views(), &ViewController::adjustmentChanged, this, [this] {
    adjustments_->setAdjustment(views().adjustment());
    refreshCommands();
  });
  connect(&page.comparison(), &ComparisonController::changed, this, &MainWindow::refreshCommands);
  connect(&page.workspace(), &Workspace::docksChanged, this, &MainWindow::refreshCommands);
}

void MainWindow::connectSaving(DocumentPage& page) {
  finder_->watch(page);
  const Document* document = &page.document();
  connect(document, &Document::saved, this, [this, document, &page] {
    opener_->remember(*document);
    keepThumbnail(page);
  });
  connect(document, &Document::modifiedChanged, this, [this] {
    tabs_->refreshTitles();
    showTitle();
  });
}

void MainWindow::connectMessages(DocumentPage& page) {
  const auto showError = [this](const QString& sentence) {
    progress_->showMessage(sentence, true);
  };
  connect(&page.document(), &Document::failed, this, showError);
  connect(&page.server(), &ViewServer::failed, this, showError);
  connect(&page.jobs(), &JobRunner::failed, this,
          [showError](JobId, const QString& sentence) { showError(sentence); });
  connect(&page.document(), &Document::noticed, this,
          [this](const QString& sentence) { progress_->showMessage(sentence, false); });
}

void MainWindow::showCurrent() {
  const bool isOpen = document().isOpen() || document().isPreviewed();
  showTitle();
  // First, as it may make the menu bar higher: the workspace lays out its docks when it is shown.
  exportButton_->setVisible(isOpen);
  adjustments_->setVisible(isOpen);
  adjustments_->setAdjustment(views().adjustment());
  if (!isOpen) showRecentFiles();
  contents_->setCurrentWidget(isOpen ? static_cast<QWidget*>(tabs_) : start_);
  progress_->setMessagesShown(isOpen);
  if (isOpen) viewport().setFocus();
  refreshCommands();
}

void MainWindow::showRecentFiles() {
  const QStringList files = opener_->recentFiles();
  start_->setRecentFiles(files);
  start_->showThumbnails([this](const QString& file) { return thumbnails_->of(file); });
  thumbnails_->look(files);
}

void MainWindow::showTitle() {
  QString name = document().name();
  const bool isShown = document().isOpen() || document().isPreviewed();
  setWindowTitle(isShown ? tr("%1[*] — Cutis").arg(name.replace("[*]", "[*][*]")) : tr("Cutis"));
  setWindowModified(document().isModified());
}

// While the tables are filled there are no commands yet.
void MainWindow::refreshCommands() {
  const QAction* action = commands_->action("file.export");
  if (action == nullptr) return;
  commands_->refresh();
  exportButton_->setEnabled(action->isEnabled());
  exportButton_->setToolTip(action->isEnabled() ? QString() : action->toolTip());
}

bool MainWindow::isIdle() const {
  const auto pages = tabs_->pages();
  return !jobs_.isBusy() && jobs_.isIdle() &&
         std::all_of(pages.begin(), pages.end(),
                     [](const DocumentPage* page) { return page->isIdle(); });
}

Document& MainWindow::document() {
  return tabs_->current().document();
}

Workspace& MainWindow::workspace() {
  return tabs_->current().workspace();
}

ViewController& MainWindow::views() {
  return tabs_->current().views();
}

EditController& MainWindow::edits() {
  return tabs_->current().edits();
}

LightController& MainWindow::light() {
  return tabs_->current().light();
}

FitController& MainWindow::fit() {
  return tabs_->current().fit();
}

TrainingController& MainWindow::training() {
  return tabs_->current().training();
}

ExportController& MainWindow::exports() {
  return tabs_->current().exports();
}

SaveController& MainWindow::saves() {
  return tabs_->current().saves();
}

Viewport& MainWindow::viewport() {
  return tabs_->current().viewport();
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
  // The program that they come from waits until this returns.
  QMetaObject::invokeMethod(
      this, [this, files] { openDropped(files); }, Qt::QueuedConnection);
}

void MainWindow::openDropped(const QStringList& files) {
  const bool isOne = files.size() == 1;
  if (isOne && tabs_->current().reopening().askWhetherMask(files.front().toStdString())) return;
  opener_->openAll(files);
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!closing_->mayClose()) return event->ignore();
  for (DocumentPage* page : tabs_->pages())
    page->closeDialogs();
  QSettings settings;
  settings.setValue(kGeometry, saveGeometry());
  settings.setValue(kLayout, workspace().saveLayout());
  event->accept();
}

void MainWindow::changeEvent(QEvent* event) {
  QMainWindow::changeEvent(event);
  if (event->type() != QEvent::ActivationChange) return;
  if (!isActiveWindow()) return sourceTimer_.stop();
  checkSources();
  sourceTimer_.start();
}

void MainWindow::checkSources() {
  for (DocumentPage* page : tabs_->pages())
    page->document().checkSource();
}

void MainWindow::restoreSettings() {
  const QSettings settings;
  // A screen may have become smaller, or have gone.
  const QRect room = screen()->availableGeometry();
  if (!restoreGeometry(settings.value(kGeometry).toByteArray())) {
    resize(withinScreen(QRect(room.topLeft(), kFirstSize), room).size());
  } else if (!isMaximized() && !isFullScreen()) {
    setGeometry(withinScreen(geometry(), room));
  }
  // A layout that is not one leaves the docks where the table says.
  workspace().restoreLayout(settings.value(kLayout).toByteArray());
}

}  // namespace cutis
