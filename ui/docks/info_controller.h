#pragma once

// Keeps what a document has said in the list of notices, until something else is opened. Interface
// thread only.

#include <QObject>
#include <QSet>
#include <QString>

#include "src/app/document/document.h"

namespace cutis {

class InfoPanel;
class ViewServer;

class InfoController : public QObject {
  Q_OBJECT

 public:
  // All outlive the controller.
  InfoController(Document& document, ViewServer& server, InfoPanel& panel,
                 QObject* parent = nullptr);

  // What others say about the document.
  void add(const QString& sentence, bool isError);

 private:
  InfoPanel& panel_;
  QSet<QString> sinceOpening_;  // about what is being opened
};

}  // namespace cutis
