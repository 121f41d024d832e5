// The editor.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iterator>

#include <QApplication>
#include <QCommandLineParser>
#include <QSettings>
#include <QTimer>

#include "core/base/echoed_text.h"
#include "core/base/instruction_set.h"
#include "src/app/fit_method.h"
#include "src/app/open/fit_choice.h"
#include "src/app/project/journal.h"
#include "src/files/profiles/profile_file.h"
#include "src/files/system/error_stream.h"
#include "src/files/system/interruption.h"
#include "src/files/system/last_words.h"
#include "src/files/system/platform.h"
#include "ui/dialogs/open_controller.h"
#include "ui/menus/private_data.h"
#include "ui/theme/theme.h"
#include "ui/widgets/progress_strip.h"
#include "ui/window/main_window.h"
#include "ui/window/script.h"
#include "ui/window/window_icon.h"

namespace {

constexpr int kBadUsage = 2;
constexpr int kBadInput = 3;
constexpr int kNoDisplay = 4;
constexpr int kNoMemory = 4;
constexpr int kInterrupted = 130;
constexpr int kIdleCheckMs = 20;
constexpr QSize kPictureSize(1440, 900);

struct Arguments {
  QStringList files;
  bool sample = false;
  QString screenshot;
  std::optional<QSize> size;
  std::vector<cutis::ScriptLine> script;
  std::string scriptPlace;
  cutis::FitChoice fit;
};

int statusOf(const cutis::Error& error) {
  return error.kind == cutis::ErrorKind::usage ? kBadUsage : kBadInput;
}

int fail(int status, const std::string& sentence) {
  cutis::writeError("cutis: " + cutis::onOneLine(sentence) + "\n");
  return status;
}

std::optional<QSize> parseSize(const QString& text) {
  const QStringList sides = text.split('x');
  bool widthIsNumber = false, heightIsNumber = false;
  const QSize size(sides.value(0).toInt(&widthIsNumber), sides.value(1).toInt(&heightIsNumber));
  const bool good = sides.size() == 2 && widthIsNumber && heightIsNumber && size.width() >= 320 &&
                    size.height() >= 240 && size.width() <= 8192 && size.height() <= 8192;
  return good ? std::optional<QSize>(size) : std::nullopt;
}

// Empty texts keep what is usual.
cutis::Result<cutis::FitChoice> parseFit(const std::string& profile, const std::string& method) {
  cutis::FitChoice fit;
  if (!method.empty()) {
    CUTIS_TRY(named, cutis::fitMethodNamed(method, "--method"));
    fit.method = named;
  }
  if (!profile.empty()) {
    CUTIS_TRY(known, cutis::loadProfile(profile, "--profile"));
    static_cast<void>(known);
    fit.profile = profile;
  }
  return fit;
}

// Runs the script line by line, each when the editor is idle, takes the picture and quits.
class Automaton : public QObject {
 public:
  Automaton(cutis::MainWindow& window, Arguments arguments)
      : window_(window), arguments_(std::move(arguments)) {
    timer_.setInterval(kIdleCheckMs);
    connect(&timer_, &QTimer::timeout, this, &Automaton::next);
    timer_.start();
  }

 private:
  void next() {
    if (!window_.isIdle()) return;
    if (line_ < arguments_.script.size()) {
      const cutis::ScriptLine& line = arguments_.script[line_++];
      const auto status = cutis::runScriptLine(
          window_, line, arguments_.scriptPlace + ":" + std::to_string(line.number));
      if (status.failed()) QCoreApplication::exit(fail(kBadInput, status.error().text()));
      return;
    }
    // Idle twice in a row: what the last step set off has been drawn.
    if (++idle_ < 2) return;
    timer_.stop();
    if (!window_.grab().save(arguments_.screenshot)) {
      QCoreApplication::exit(
          fail(kBadInput, arguments_.screenshot.toStdString() +
                              ": the picture cannot be written; choose a .png in a folder that "
                              "exists"));
      return;
    }
    QCoreApplication::exit(0);
  }

  cutis::MainWindow& window_;
  Arguments arguments_;
  QTimer timer_;
  std::size_t line_ = 0;
  int idle_ = 0;
};

// The window closes as if somebody had closed it, whatever dialog is open.
void closeOnInterrupt() {
  QMetaObject::invokeMethod(
      qApp, [] { QCoreApplication::exit(kInterrupted); }, Qt::QueuedConnection);
}

int runEditor(QApplication& application, const Arguments& arguments) {
  cutis::MainWindow window(std::make_unique<cutis::Engine>(cutis::cacheFolder()));
  window.setUsualFit(arguments.fit);
  // Pictures are of one size, whatever the screen.
  if (arguments.size) {
    window.resize(*arguments.size);
  } else if (!arguments.screenshot.isEmpty()) {
    window.resize(kPictureSize);
  }
  window.show();
  // A picture of the window shows nothing of what was there before.
  if (arguments.screenshot.isEmpty()) window.keepJournals(cutis::journalFolder());
  if (arguments.sample) window.opener().openSample();
  if (!arguments.files.isEmpty()) window.opener().openAll(arguments.files);
  std::unique_ptr<Automaton> automaton;
  if (!arguments.screenshot.isEmpty()) {
    automaton = std::make_unique<Automaton>(window, arguments);
  }
  const int status = application.exec();
  cutis::interrupt();
  return status;
}

// Without a display Qt would end the process with an abort.
bool hasDisplay() {
  const char* names[] = {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"};
  return std::any_of(std::begin(names), std::end(names), qEnvironmentVariableIsSet);
}

}  // namespace

int main(int argc, char** argv) {
  cutis::keepStandardStreams();
  cutis::endWellWithoutMemory("cutis");
#ifdef Q_OS_LINUX
  if (!hasDisplay()) {
    return fail(kNoDisplay,
                "there is no display to open a window on; use cutis-cli, or set "
                "QT_QPA_PLATFORM=offscreen for --screenshot");
  }
#endif
  QApplication application(argc, argv);
  QCoreApplication::setApplicationName("cutis");
  QCoreApplication::setOrganizationName("cutis");
  QGuiApplication::setApplicationDisplayName("Cutis");
  QCoreApplication::setApplicationVersion(CUTIS_VERSION);
  const char* pinned = std::getenv("CUTIS_ISA");
  const auto isa = cutis::pinInstructionSet(pinned == nullptr ? "" : pinned);
  if (isa.failed()) return fail(kBadInput, isa.error().text());

  QCommandLineParser parser;
  parser.setApplicationDescription(QObject::tr("Editor for human skin."));
  parser.addHelpOption();
  parser.addVersionOption();
  parser.addPositionalArgument(
      "FILE", QObject::tr("A capture, an albedo texture, maps or a project."), "[FILE...]");
  const QCommandLineOption sample("sample", QObject::tr("Open the embedded sample."));
  const QCommandLineOption screenshot(
      "screenshot", QObject::tr("Wait until idle, take a picture of the window and quit."), "PNG");
  const QCommandLineOption size("size", QObject::tr("Size of the window."), "WxH");
  const QCommandLineOption script("script", QObject::tr("Commands to run before the picture."),
                                  "FILE");
  const QCommandLineOption reset("reset-settings", QObject::tr("Forget all settings."));
  const QCommandLineOption profile(
      "profile",
      QObject::tr("Skin model: a built-in name or a JSON file (default: %1).")
          .arg(cutis::kDefaultProfile),
      "NAME|FILE");
  const QCommandLineOption method(
      "method", QObject::tr("How to fit: refined (default), network, three-stage or full-search."),
      "METHOD");
  const QCommandLineOption clear(
      "clear-private-data",
      QObject::tr(
          "Remove journals of unsaved edits, caches and the names of recent files, and quit."));
  parser.addOptions({sample, profile, method, screenshot, size, script, reset, clear});
  if (!parser.parse(application.arguments())) {
    return fail(kBadUsage, parser.errorText().toStdString() + "; see cutis --help");
  }
  if (parser.isSet("help")) parser.showHelp();
  if (parser.isSet("version")) parser.showVersion();

  if (parser.isSet(clear)) {
    cutis::clearPrivateData();
    return 0;
  }

  Arguments arguments;
  arguments.files = parser.positionalArguments();
  arguments.sample = parser.isSet(sample);
  arguments.screenshot = parser.value(screenshot);
  if (parser.isSet(size)) {
    arguments.size = parseSize(parser.value(size));
    if (!arguments.size) {
      return fail(kBadUsage, "--size: write WIDTHxHEIGHT in pixels, from 320x240 to 8192x8192");
    }
  }
  if (parser.isSet(script)) {
    if (arguments.screenshot.isEmpty()) {
      return fail(kBadUsage, "--script: runs before a picture; give --screenshot as well");
    }
    arguments.scriptPlace = parser.value(script).toStdString();
    auto lines = cutis::readScript(parser.value(script));
    if (lines.failed()) return fail(kBadInput, lines.error().text());
    arguments.script = std::move(lines).value();
  }
  const auto fit =
      parseFit(parser.value(profile).toStdString(), parser.value(method).toStdString());
  if (fit.failed()) return fail(statusOf(fit.error()), fit.error().text());
  arguments.fit = fit.value();
  if (parser.isSet(reset)) QSettings().clear();
  cutis::theme::apply(application);
  QApplication::setWindowIcon(cutis::windowIcon());
  const auto handled = cutis::onInterrupt(closeOnInterrupt);
  if (handled.failed()) return fail(kNoMemory, handled.error().text());
  return runEditor(application, arguments);
}
