#pragma once  // internal to ui/dialogs

// What several photographs are that nobody has described: one capture, as the user then says in the
// assistant, or pictures that have nothing to do with each other. Interface thread only.

#include <filesystem>
#include <vector>

#include <QObject>

class QWidget;

namespace cutis {

class JobRunner;
class ProgressStrip;
struct CaptureCandidates;

class CaptureController : public QObject {
  Q_OBJECT

 public:
  using Files = std::vector<std::filesystem::path>;

  // All outlive the controller; the assistant stands before the window.
  CaptureController(JobRunner& jobs, ProgressStrip& progress, QWidget* window);

  // The photographs of a folder without capture.json, or the files themselves, if they may be a
  // capture by names and headers; else none. On any thread.
  static Files photographsOf(const Files& opened);
  // Looks at them in the background. If they show one scene, or the user says that they do, the
  // assistant asks; otherwise each is opened by itself.
  void look(const Files& photographs, bool areOneCapture);
  // By a dialog.
  void choose();

 Q_SIGNALS:
  // A capture, or one of the pictures.
  void openWanted(const std::filesystem::path& path);

 private:
  void ask(const CaptureCandidates& candidates);
  void openEach(const Files& files);

  JobRunner& jobs_;
  ProgressStrip& progress_;
  QWidget* window_;
};

}  // namespace cutis
