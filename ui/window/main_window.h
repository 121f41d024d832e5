#pragma once

// The editor's window: the start page, or the workspace with picture and docks, above the progress
// strip. It owns the document and everything that works for it, and joins them; what they do stands
// with them. Interface thread only.

#include <memory>

#include <QMainWindow>

#include "src/app/document/document.h"
#include "src/app/document/view_server.h"
#include "src/app/engine.h"
#include "src/app/job_runner.h"

class QPushButton;
class QStackedWidget;

namespace cutis {

class CommandRegistry;
class EditController;
class ExportController;
class FitController;
class LightController;
class OpenController;
class ProgressStrip;
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

  Document& document() { return *document_; }
  CommandRegistry& commands() { return *commands_; }
  Workspace& workspace() { return *workspace_; }
  ViewController& views() { return *views_; }
  EditController& edits() { return *edits_; }
  LightController& light() { return *light_; }
  FitController& fit() { return *fit_; }
  TrainingController& training() { return *training_; }
  OpenController& opener() { return *opener_; }
  ExportController& exports() { return *exports_; }
  Viewport& viewport() { return *viewport_; }
  ProgressStrip& progress() { return *progress_; }

 protected:
  // What is dropped anywhere in the window is opened.
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dragLeaveEvent(QDragLeaveEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void closeEvent(QCloseEvent* event) override;

 private:
  void fillTables();
  void layOut();
  void connectDocument();
  void connectStartPage();
  void showDocument();
  void refreshCommands();
  void restoreSettings();

  std::unique_ptr<Engine> engine_;
  JobRunner jobs_;
  std::unique_ptr<Document> document_;
  std::unique_ptr<ViewServer> server_;

  QStackedWidget* pages_;
  StartPage* start_;
  Viewport* viewport_;
  Workspace* workspace_;
  ProgressStrip* progress_;
  QPushButton* exportButton_;
  CommandRegistry* commands_;
  // They go before what they work on.
  std::unique_ptr<ViewController> views_;
  std::unique_ptr<EditController> edits_;
  std::unique_ptr<LightController> light_;
  std::unique_ptr<FitController> fit_;
  std::unique_ptr<TrainingController> training_;
  std::unique_ptr<OpenController> opener_;
  std::unique_ptr<ExportController> exports_;
};

}  // namespace cutis
