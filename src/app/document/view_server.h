#pragma once

// Pictures for the screen, made for those who watch.
//
// A panel holds a ViewWatch and says which part of which view it shows at which step; it is then
// handed that part whenever it changes, newest state first, computed in the background. What nobody
// watches is not computed. While a control is dragged parts come at half resolution; the full one
// follows when it rests.
//
// Lives on the interface thread.

#include <cstdint>
#include <functional>
#include <map>
#include <memory>

#include <QObject>

#include "src/app/document/document.h"
#include "src/app/document/view_part.h"
#include "src/app/engine.h"
#include "src/app/job_runner.h"
#include "src/app/picture_request.h"

namespace cutis {

class ViewServer;

// What is served first: the earlier of these.
enum class ViewPriority {
  detail,     // what somebody looks at; alone served while a control is dragged
  overview,   // what stands in for it while the view moves
  thumbnail,  // what else there would be to see
};

// A wish to be shown something. Nothing is delivered after its destruction.
class ViewWatch {
 public:
  using Show = std::function<void(const std::shared_ptr<const ViewPart>&)>;

  ~ViewWatch();
  ViewWatch(const ViewWatch&) = delete;
  ViewWatch& operator=(const ViewWatch&) = delete;

  // Replaces the wish; an empty rect wishes nothing.
  void want(const ViewRequest& request);
  // While nobody sees what it shows, nothing is made for it; what has changed meanwhile is made
  // when it is seen again. At first it is seen.
  void setSeen(bool seen);

 private:
  friend class ViewServer;
  ViewWatch(ViewServer& server, std::uint64_t id, ViewPriority priority, Show show)
      : server_(server), id_(id), priority_(priority), show_(std::move(show)) {}

  ViewServer& server_;
  std::uint64_t id_;  // never given twice
  ViewPriority priority_;
  Show show_;
  ViewRequest request_;
  bool due_ = false;  // the last part shown is not of this state, or none was
  bool seen_ = true;
};

class ViewServer : public QObject {
  Q_OBJECT

 public:
  // All outlive the server.
  ViewServer(Document& document, Engine& engine, JobRunner& jobs, QObject* parent = nullptr);

  // Among watches of one priority the oldest is served first. The server outlives its watches.
  std::unique_ptr<ViewWatch> watch(ViewPriority priority, ViewWatch::Show show);

  // What the view `skin` shows.
  void setPicture(const PictureRequest& picture);
  const PictureRequest& picture() const { return picture_; }

  // Nothing is due and nothing under way.
  bool isIdle() const;

 Q_SIGNALS:
  void failed(const QString& sentence);

 private:
  friend class ViewWatch;

  // Marks what `concerns` says as due.
  void invalidate(const std::function<bool(ViewKind)>& concerns);
  void forget();
  void startNext();
  ViewWatch* mostUrgent() const;
  void deliver(std::uint64_t watch, const std::shared_ptr<const ViewPart>& part);

  Document& document_;
  Engine& engine_;
  JobRunner& jobs_;
  PictureRequest picture_;
  std::map<std::uint64_t, ViewWatch*> watches_;  // by id: a job may outlive the watch it works for
  std::uint64_t nextId_ = 1;
  JobId job_ = 0;
  bool jobIsCoarse_ = false;
  bool moving_ = false;
};

}  // namespace cutis
