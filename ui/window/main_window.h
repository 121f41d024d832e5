#pragma once

// The editor's window: start page or the document's layers, viewport, spectrum, edits and light.
// It owns the document and everything that works for it. Interface thread only.

#include <map>
#include <memory>

#include <QMainWindow>
#include <QStringList>

#include "src/app/document/document.h"
#include "src/app/document/view_server.h"
#include "src/app/engine.h"
#include "src/app/job_runner.h"
#include "ui/docks/light_choice.h"

class QAction;
class QPushButton;
class QStackedWidget;

namespace cutis {

class EditController;
class EditPanel;
class FitController;
class FitPanel;
class ViewController;
class ViewStrip;
class LightPanel;
class ProgressStrip;
class SpectrumController;
class SpectrumPlot;
class StartPage;
class TrainingController;
class Viewport;

class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit MainWindow(std::unique_ptr<Engine> engine, QWidget* parent = nullptr);
  ~MainWindow() override;

  void openSample();
  void openPath(const QString& path);
  // Writes the edited albedo in the background.
  void exportAlbedo(const QString& path);
  void setLight(const LightChoice& choice);

  // Nothing is being read, fitted, drawn or written.
  bool isIdle() const;

  Document& document() { return *document_; }
  ViewController& layers() { return *layers_; }
  EditController& edits() { return *edits_; }
  FitController& fit() { return *fit_; }
  TrainingController& training() { return *training_; }
  Viewport& viewport() { return *viewport_; }
  ProgressStrip& progress() { return *progress_; }

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void closeEvent(QCloseEvent* event) override;

 private:
  QWidget* makeWorkArea();
  QWidget* makeSidePanel();
  void makeMenus();
  void connectJobs();
  void connectStrip();
  void documentOpened();
  void updateActions();
  void syncLight();
  void chooseCapture();
  void chooseImage();
  void chooseExport();
  void chooseProfile();
  void remember(const QString& path);
  void restoreSettings();

  std::unique_ptr<Engine> engine_;
  JobRunner jobs_;
  std::unique_ptr<Document> document_;
  std::unique_ptr<ViewServer> server_;

  QStackedWidget* pages_;
  StartPage* start_;
  Viewport* viewport_;
  ViewStrip* strip_;
  SpectrumPlot* plot_;
  EditPanel* editPanel_;
  LightPanel* lightPanel_;
  FitPanel* fitPanel_;
  ProgressStrip* progress_;
  QPushButton* exportButton_;
  ViewController* layers_;
  EditController* edits_;
  SpectrumController* spectrum_;
  FitController* fit_;
  TrainingController* training_;

  QAction* undo_ = nullptr;
  QAction* redo_ = nullptr;
  QAction* export_ = nullptr;
  QAction* load_ = nullptr;
  QAction* train_ = nullptr;
  std::map<JobId, QString> visibleJobs_;  // with their names; the newest is shown
};

}  // namespace cutis
