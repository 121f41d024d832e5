#pragma once  // internal to ui/window

// What the rows of the tables of commands and docks work on. The window owns it all; rows are made
// once everything is there, and are gone before it.

class QWidget;

namespace cutis {

class CommandRegistry;
class Document;
class EditController;
class ExportController;
class FitController;
class LightController;
class OpenController;
class ProgressStrip;
class TrainingController;
class ViewController;
class ViewServer;
class Viewport;
class Workspace;

struct Editor {
  QWidget& window;
  Document& document;
  ViewServer& server;
  ViewController& views;
  EditController& edits;
  LightController& light;
  FitController& fit;
  TrainingController& training;
  OpenController& open;
  ExportController& exports;
  Viewport& viewport;
  ProgressStrip& progress;
  Workspace& workspace;
  CommandRegistry& commands;
};

}  // namespace cutis
