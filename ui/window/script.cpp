#include "ui/window/script.h"

#include <functional>
#include <map>

#include <QPixmap>

#include "core/base/echoed_text.h"
#include "core/skin/profile/parameter.h"
#include "src/app/fit_method.h"
#include "src/files/io/text_file.h"
#include "ui/commands/command_registry.h"
#include "ui/dialogs/export_controller.h"
#include "ui/dialogs/open_controller.h"
#include "ui/dialogs/training_controller.h"
#include "ui/dialogs/training_dialog.h"
#include "ui/docks/edit_controller.h"
#include "ui/docks/fit_controller.h"
#include "ui/docks/light_controller.h"
#include "ui/view/view_catalogue.h"
#include "ui/view/view_controller.h"
#include "ui/view/viewport.h"
#include "ui/window/main_window.h"

namespace cutis {
namespace {

struct Call {
  MainWindow& window;
  const QStringList& words;
  std::string place;

  Error wrong(const QString& demand) const {
    return inputError(place, inQuotes(words.join(' ').toStdString()) + ": " + demand.toStdString());
  }
};

Status view(const Call& call) {
  const auto kind = viewById(call.words[1]);
  if (!kind) return call.wrong("there is no view of this name");
  call.window.views().show(*kind);
  return {};
}

Status factor(const Call& call) {
  bool isNumber = false;
  const double value = call.words[2].toDouble(&isNumber);
  const auto parameter = parameterByName(call.words[1].toStdString());
  if (!parameter || !isNumber) return call.wrong("write factor, a parameter's name and a number");
  call.window.edits().setFactor(*parameter, value, false);
  return {};
}

Status light(const Call& call) {
  LightChoice choice;
  choice.light = call.words[1];
  choice.observer = call.words.value(2, "cie1931");
  call.window.light().setLight(choice);
  return {};
}

Status method(const Call& call) {
  FitChoice choice = call.window.document().fitChoice();
  CUTIS_TRY(method, fitMethodNamed(call.words[1].toStdString(), call.place));
  choice.method = method;
  call.window.fit().fitWith(choice);
  return {};
}

Status use(const Call& call) {
  if (!call.window.training().isTrained()) {
    return call.wrong("nothing is trained; begin with train");
  }
  call.window.training().use();
  return {};
}

Status shading(const Call& call) {
  FitChoice choice = call.window.document().fitChoice();
  if (call.words[1] != "on" && call.words[1] != "off") return call.wrong("write shading on or off");
  choice.shading = call.words[1] == "on";
  call.window.fit().fitWith(choice);
  return {};
}

Status command(const Call& call) {
  CommandRegistry& commands = call.window.commands();
  if (commands.action(call.words[1]) == nullptr) {
    return call.wrong("there is no such command of the menus");
  }
  const QString objection = commands.run(call.words[1]);
  return objection.isEmpty() ? Status() : Status(call.wrong(objection));
}

Status point(const Call& call) {
  Q_EMIT call.window.viewport().cursorMoved(call.words[1].toInt(), call.words[2].toInt());
  return {};
}

Status zoom(const Call& call) {
  Viewport& viewport = call.window.viewport();
  if (call.words[1] == "fit") {
    viewport.fitPicture();
  } else if (call.words[1] == "one") {
    viewport.zoomOneToOne();
  } else if (call.words[1].toDouble() > 0.0) {
    viewport.zoomBy(call.words[1].toDouble());
  } else {
    return call.wrong("write zoom and a positive factor, fit or one");
  }
  return {};
}

// The training dialog stands before the window.
Status picture(const Call& call) {
  QWidget* dialog = &call.window.training().dialog();
  QWidget* shown = dialog->isVisible() ? dialog : &call.window;
  if (!shown->grab().save(call.words[1])) return call.wrong("the picture cannot be written");
  return {};
}

struct Verb {
  int fewestWords;
  int mostWords;
  std::function<Status(const Call&)> run;
};

const std::map<QString, Verb>& verbs() {
  static const auto simple = [](void (*action)(const Call&)) {
    return [action](const Call& call) -> Status {
      action(call);
      return {};
    };
  };
  static const std::map<QString, Verb> all = {
      {"sample", {1, 1, simple([](const Call& call) { call.window.opener().openSample(); })}},
      {"open", {2, 2, simple([](const Call& call) { call.window.opener().open(call.words[1]); })}},
      {"view", {2, 2, view}},
      {"factor", {3, 3, factor}},
      {"light", {2, 3, light}},
      {"profile",
       {2, 2, simple([](const Call& call) { call.window.fit().fitWithProfile(call.words[1]); })}},
      {"method", {2, 2, method}},
      {"shading", {2, 2, shading}},
      {"train", {1, 1, simple([](const Call& call) { call.window.training().train(); })}},
      {"use", {1, 1, use}},
      {"point", {3, 3, point}},
      {"zoom", {2, 2, zoom}},
      {"undo", {1, 1, simple([](const Call& call) { call.window.document().undo(); })}},
      {"redo", {1, 1, simple([](const Call& call) { call.window.document().redo(); })}},
      {"reset", {1, 1, simple([](const Call& call) { call.window.edits().reset(); })}},
      {"export",
       {2, 2, simple([](const Call& call) { call.window.exports().exportAlbedo(call.words[1]); })}},
      {"picture", {2, 2, picture}},
      {"command", {2, 2, command}},
  };
  return all;
}

bool needsDocument(const QString& verb) {
  return verb != "sample" && verb != "open" && verb != "picture" && verb != "command";
}

}  // namespace

Result<std::vector<ScriptLine>> readScript(const QString& path) {
  CUTIS_TRY(text, readTextFile(path.toStdString()));
  std::vector<ScriptLine> lines;
  int number = 0;
  for (const QString& raw : QString::fromStdString(text).split('\n')) {
    ++number;
    const QString line = raw.section('#', 0, 0).simplified();
    if (!line.isEmpty()) lines.push_back({number, line.split(' ')});
  }
  return lines;
}

Status runScriptLine(MainWindow& window, const ScriptLine& line, const std::string& place) {
  const Call call{window, line.words, place};
  const auto verb = verbs().find(line.words[0]);
  if (verb == verbs().end()) return call.wrong("there is no such command");
  if (line.words.size() < verb->second.fewestWords || line.words.size() > verb->second.mostWords) {
    return call.wrong("too few or too many words");
  }
  if (needsDocument(line.words[0]) && !window.document().isOpen()) {
    return call.wrong("nothing is open; begin with sample or open");
  }
  return verb->second.run(call);
}

}  // namespace cutis
