// How the window answers a hand: opens each file that is named, drags the melanin slider with mouse
// events at the rate of a screen, counts the frames that are painted, and prints the times.
//
//   cutis-window-bench [--size WxH] [--moves N] [FILE...]      no file: the embedded sample
//
// On a screen (Xvfb with a window manager will do) the painted pixels reach the display, too; with
// QT_QPA_PLATFORM=offscreen they end in memory.

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include <QApplication>
#include <QCommandLineParser>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QMouseEvent>
#include <QStandardPaths>
#include <QThread>
#include <QTimer>

#include "src/app/document/document.h"
#include "src/files/system/platform.h"
#include "ui/commands/command_registry.h"
#include "ui/dialogs/open_controller.h"
#include "ui/theme/theme.h"
#include "ui/view/view_controller.h"
#include "ui/view/viewport.h"
#include "ui/widgets/neutral_slider.h"
#include "ui/window/main_window.h"

namespace cutis {
namespace {

constexpr int kPatienceMs = 300000;
constexpr double kMovesPerSecond = 60;
constexpr int kHeldMs = 600;
constexpr int kReleasedMs = 2500;

double milliseconds() {
  static QElapsedTimer timer = [] {
    QElapsedTimer started;
    started.start();
    return started;
  }();
  return static_cast<double>(timer.nsecsElapsed()) * 1e-6;
}

// Notes when a watched widget has been painted.
class PaintClock : public QApplication {
 public:
  using QApplication::QApplication;

  void watch(const QWidget* widget) { watched_ = widget; }
  double lastPaint() const { return lastPaint_; }
  int paints() const { return paints_; }

  bool notify(QObject* receiver, QEvent* event) override {
    const bool isPaint = receiver == watched_ && event->type() == QEvent::Paint;
    const bool result = QApplication::notify(receiver, event);
    if (isPaint) {
      ++paints_;
      lastPaint_ = milliseconds();
    }
    return result;
  }

 private:
  const QObject* watched_ = nullptr;
  double lastPaint_ = -1;
  int paints_ = 0;
};

void pumpUntil(double until) {
  const double left = until - milliseconds();
  if (left <= 0) return QCoreApplication::processEvents();
  QEventLoop loop;
  QTimer::singleShot(std::chrono::milliseconds(static_cast<int>(left + 0.5)), Qt::PreciseTimer,
                     &loop, &QEventLoop::quit);
  loop.exec();
}

template <typename Condition>
bool waitFor(Condition condition) {
  const double end = milliseconds() + kPatienceMs;
  while (!condition()) {
    if (milliseconds() > end) return false;
    QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 5);
    pumpUntil(milliseconds() + 1);
  }
  return true;
}

// In MiB; 0 where the platform does not tell.
double memory(const char* key) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with(key)) return std::stod(line.substr(line.find(':') + 1)) / 1024;
  }
  return 0;
}

std::string summary(std::vector<double> values) {
  if (values.empty()) return "none";
  std::sort(values.begin(), values.end());
  const std::size_t last = values.size() - 1;
  char text[96];
  std::snprintf(text, sizeof text, "median %.1f, 95 %% %.1f, worst %.1f ms", values[last / 2],
                values[last * 95 / 100], values.back());
  return text;
}

std::string list(const std::vector<double>& values) {
  std::string text;
  for (const double value : values)
    text += " " + std::to_string(static_cast<int>(value + 0.5));
  return text.empty() ? " none" : text;
}

class WindowBench {
 public:
  WindowBench(PaintClock& clock, QSize size, int moves) : clock_(clock), moves_(moves) {
    window_ = std::make_unique<MainWindow>(std::make_unique<Engine>(cacheFolder()));
    window_->resize(size);
    window_->show();
    pumpUntil(milliseconds() + 300);
  }

  bool run(const QString& file) {
    std::printf("%s\n", file.isEmpty() ? "the sample" : file.toUtf8().constData());
    clock_.watch(&window_->viewport());
    if (!open(file)) return false;
    window_->views().show(ViewKind::editedAlbedo);
    waitUntilIdle();
    drag();
    const double held = memory("VmRSS");
    // Edits that are not saved would be asked about.
    while (window_->document().history().canUndo())
      window_->document().undo();
    waitUntilIdle();
    window_->commands().run("file.close");
    pumpUntil(milliseconds() + 1000);
    std::printf("  memory: open %.0f MiB, closed %.0f MiB, at most %.0f MiB\n", held,
                memory("VmRSS"), memory("VmHWM"));
    std::fflush(stdout);
    return true;
  }

 private:
  // Whether something else than the empty view is seen in its middle.
  bool showsPicture() const {
    Viewport& viewport = window_->viewport();
    if (!viewport.isVisible()) return false;
    const QRect middle(viewport.rect().center(), QSize(1, 1));
    const QImage image = viewport.grab(middle).toImage();
    return image.pixelColor(0, 0) != theme::tones().surround;
  }

  bool open(const QString& file) {
    double first = 0, maps = 0, complete = 0;
    const Document& document = window_->document();
    QObject listener;
    QObject::connect(&document, &Document::sceneReplaced, &listener,
                     [&] { maps = maps > 0 ? maps : milliseconds(); });
    QObject::connect(&document, &Document::fitted, &listener, [&] { complete = milliseconds(); });
    bool failed = false;
    QObject::connect(&document, &Document::failed, &listener, [&](const QString& sentence) {
      std::printf("  %s\n", sentence.toUtf8().constData());
      failed = true;
    });
    const double start = milliseconds();
    file.isEmpty() ? window_->opener().openSample() : window_->opener().openAll({file});
    int seen = clock_.paints();
    const bool done = waitFor([&] {
      if (first == 0 && clock_.paints() != seen) {
        seen = clock_.paints();
        if (showsPicture()) first = clock_.lastPaint();
        seen = clock_.paints();
      }
      return failed || (complete > 0 && window_->isIdle());
    });
    std::printf("  opened: first picture %.0f, first maps %.0f, fitted %.0f, idle %.0f ms\n",
                first - start, maps - start, complete - start, milliseconds() - start);
    return done && !failed;
  }

  void waitUntilIdle() {
    waitFor([this] { return window_->isIdle(); });
    pumpUntil(milliseconds() + 300);
  }

  NeutralSlider* slider() const {
    for (NeutralSlider* slider : window_->findChildren<NeutralSlider*>()) {
      if (slider->accessibleName() == "Melanin") return slider;
    }
    return nullptr;
  }

  void send(QEvent::Type type, QPointF at) const {
    NeutralSlider* target = slider();
    const bool isMove = type == QEvent::MouseMove;
    QMouseEvent event(type, at, target->mapToGlobal(at), isMove ? Qt::NoButton : Qt::LeftButton,
                      type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton,
                      Qt::NoModifier);
    QCoreApplication::sendEvent(target, &event);
  }

  // Frames painted until then, in order.
  std::vector<double> framesUntil(double until) {
    std::vector<double> frames;
    int seen = clock_.paints();
    while (milliseconds() < until) {
      QCoreApplication::processEvents(QEventLoop::AllEvents);
      if (clock_.paints() != seen) frames.push_back(clock_.lastPaint());
      seen = clock_.paints();
      QThread::usleep(200);
    }
    return frames;
  }

  void drag() {
    const QPointF middle = QRectF(slider()->rect()).center();
    send(QEvent::MouseButtonPress, middle);
    framesUntil(milliseconds() + 200);
    std::vector<double> moved, frames;
    double next = milliseconds();
    for (int i = 1; i <= moves_; ++i) {
      send(QEvent::MouseMove, middle + QPointF(i, 0));
      moved.push_back(milliseconds());
      next += 1000 / kMovesPerSecond;
      const auto painted = framesUntil(next);
      frames.insert(frames.end(), painted.begin(), painted.end());
    }
    const double rested = milliseconds();
    const std::size_t whileMoving = frames.size();
    const auto held = framesUntil(rested + kHeldMs);
    const double released = milliseconds();
    send(QEvent::MouseButtonRelease, middle + QPointF(moves_, 0));
    const auto after = framesUntil(released + kReleasedMs);
    frames.insert(frames.end(), held.begin(), held.end());
    frames.insert(frames.end(), after.begin(), after.end());

    std::vector<double> late;
    for (const double move : moved) {
      const auto frame = std::upper_bound(frames.begin(), frames.end(), move);
      if (frame != frames.end()) late.push_back(*frame - move);
    }
    std::printf("  slider: %d moves, %zu frames while moving, move to screen %s\n", moves_,
                whileMoving, summary(late).c_str());
    const auto since = [](std::vector<double> times, double zero) {
      for (double& time : times)
        time -= zero;
      return list(times);
    };
    std::printf("  at rest: frames while held, ms:%s; after release:%s\n",
                since(held, rested).c_str(), since(after, released).c_str());
  }

  PaintClock& clock_;
  int moves_;
  std::unique_ptr<MainWindow> window_;
};

}  // namespace
}  // namespace cutis

int main(int argc, char** argv) {
  cutis::PaintClock application(argc, argv);
  QStandardPaths::setTestModeEnabled(true);
  QCoreApplication::setApplicationName("cutis-window-bench");
  QCoreApplication::setOrganizationName("cutis-window-bench");
  QCommandLineParser parser;
  parser.addHelpOption();
  const QCommandLineOption size("size", "Size of the window.", "WxH", "1920x1080");
  const QCommandLineOption moves("moves", "Moves of the mouse in a drag.", "N", "60");
  parser.addOptions({size, moves});
  parser.addPositionalArgument("FILE", "What is opened.", "[FILE...]");
  parser.process(application);
  const QStringList sides = parser.value(size).split('x');
  cutis::theme::apply(application);
  cutis::WindowBench bench(application, {sides.value(0).toInt(), sides.value(1).toInt()},
                           parser.value(moves).toInt());
  const QStringList files = parser.positionalArguments();
  bool good = true;
  for (const QString& file : files.isEmpty() ? QStringList{QString()} : files)
    good = bench.run(file) && good;
  return good ? 0 : 1;
}
