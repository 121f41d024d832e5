#pragma once

// Scripts for pictures and tests: one command a line, `#` starts a comment.
//
//   sample                      open the embedded sample
//   open PATH                   a capture, an image or maps
//   view ID                     photograph, albedo, skin, melanin, …, uv, nir
//   factor NAME VALUE           melanin, melanin_blend, haemoglobin_dermal, …
//   light NAME [OBSERVER]       shows the skin under it
//   profile NAME|FILE           fits with it
//   method NAME                 refined, network, three-stage, full-search
//   shading on|off
//   train                       a network for what is fitted; its dialog opens
//   use                         fits with the network that was trained
//   point X Y                   the spectrum of a pixel
//   zoom FACTOR | zoom fit | zoom one
//   undo | redo | reset
//   export PATH
//   command ID                  of the menus: edit.undo, dock.spectrum, dock.resetLayout, …
//   picture PATH.png            of the window, or of the training dialog while that is open
//
// Each command waits until the editor is idle.

#include <QStringList>

#include "core/base/result.h"

namespace cutis {

class MainWindow;

struct ScriptLine {
  int number = 0;  // in the file, from 1
  QStringList words;
};

Result<std::vector<ScriptLine>> readScript(const QString& path);

// Runs one line. `place` stands in front of errors. What runs in the background goes on after it.
Status runScriptLine(MainWindow& window, const ScriptLine& line, const std::string& place);

}  // namespace cutis
