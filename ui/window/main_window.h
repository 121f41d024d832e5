#pragma once

// The editor's window: the start page, or the documents behind their tabs, above the progress
// strip. It joins them; what they do stands with them. Interface thread only.

#include <filesystem>
#include <memory>

#include <QMainWindow>
#include <QTimer>

#include "src/app/engine.h"
#include "src/app/job_runner.h"
#include "src/app/open/fit_choice.h"

class QPushButton;
class QStackedWidget;

namespace cutis {

class AdjustmentBar;
class CloseGuard;
class CommandRegistry;
class Document;
class DocumentPage;
class DocumentTabs;
class EditController;
class ExportController;
class FileThumbnails;
class FitController;
class JobDisplay;
class LightController;
class OpenController;
class ProgressStrip;
class Recovery;
class SaveController;
class SourceFinder;
class StartPage;
class TrainingController;
class ViewController;
class Viewport;
class Workspace;

class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit MainWindow(std::unique_ptr<Engine> engine, QWidget* parent = nullptr);
  ~MainWindow() override;

  // Nothing is being read, fitted, drawn or written.
  bool isIdle() const;

  // From now on unsaved edits are written down in the folder, and what a crash left there is
  // offered. Once, while the window is shown.
  void keepJournals(const std::filesystem::path& folder);
  // How documents are fitted at first. Before anything is opened.
  void setUsualFit(const FitChoice& choice);

  CommandRegistry& commands() { return *commands_; }
  OpenController& opener() { return *opener_; }
  ProgressStrip& progress() { return *progress_; }
  DocumentTabs& tabs() { return *tabs_; }
  // Those of the current page, here and below.
  Document& document();
  Workspace& workspace();
  ViewController& views();
  EditController& edits();
  LightController& light();
  FitController& fit();
  TrainingController& training();
  ExportController& exports();
  SaveController& saves();
  Viewport& viewport();

 protected:
  // What is dropped anywhere in the window is opened.
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dragLeaveEvent(QDragLeaveEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  // Who comes back from another program may have changed a source there. While the window is used
  // sources are looked at every two seconds.
  void changeEvent(QEvent* event) override;

 private:
  void fillTables();
  void layOut();
  void layOutCorner();
  void connectStartPage();
  void connectOpening();
  void connectPage(DocumentPage& page);
  void connectMessages(DocumentPage& page);
  void connectSaving(DocumentPage& page);
  void addRecentMenu();
  void keepThumbnail(DocumentPage& page);
  void showCurrent();
  void showRecentFiles();
  void openDropped(const QStringList& files);
  void showTitle();
  void refreshCommands();
  void restoreSettings();
  void checkSources();

  std::unique_ptr<Engine> engine_;
  JobRunner jobs_;  // of the window itself; each page has its own
  FitChoice usualFit_;

  QStackedWidget* contents_;
  StartPage* start_;
  ProgressStrip* progress_;
  JobDisplay* jobDisplay_;
  AdjustmentBar* adjustments_;
  QPushButton* exportButton_;
  CommandRegistry* commands_;
  OpenController* opener_;
  FileThumbnails* thumbnails_;
  DocumentTabs* tabs_;
  CloseGuard* closing_;
  SourceFinder* finder_;
  Recovery* recovery_;
  QTimer sourceTimer_;
};

}  // namespace cutis
