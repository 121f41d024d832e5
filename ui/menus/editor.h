#pragma once

// What the rows of the table of commands work on. The window owns it all; rows are made once
// everything is there, and are gone before it.

#include "ui/documents/document_page.h"
#include "ui/documents/document_tabs.h"

namespace cutis {

class CommandPalette;
class JobDisplay;
class OpenController;
class ShortcutSheet;

struct Editor {
  QWidget& window;
  DocumentTabs& tabs;
  OpenController& open;
  CommandPalette& palette;
  ShortcutSheet& shortcuts;
  JobDisplay& jobs;

  // The one that is looked at when a command runs.
  DocumentPage& page() const { return tabs.current(); }
  Document& document() const { return page().document(); }
};

}  // namespace cutis
