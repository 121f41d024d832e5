#include "ui/docks/info_controller.h"

#include "src/app/views/view_server.h"
#include "ui/docks/info_panel.h"

namespace cutis {

InfoController::InfoController(Document& document, ViewServer& server, InfoPanel& panel,
                               QObject* parent)
    : QObject(parent), panel_(panel) {
  connect(&document, &Document::openingStarted, this, [this] { sinceOpening_.clear(); });
  connect(&document, &Document::opened, this,
          [this] { panel_.keepNewest(static_cast<int>(sinceOpening_.size())); });
  connect(&document, &Document::noticed, this,
          [this](const QString& sentence) { add(sentence, false); });
  const auto addError = [this](const QString& sentence) { add(sentence, true); };
  connect(&document, &Document::failed, this, addError);
  connect(&server, &ViewServer::failed, this, addError);
}

void InfoController::add(const QString& sentence, bool isError) {
  panel_.add(sentence, isError);
  sinceOpening_ << sentence;
}

}  // namespace cutis
