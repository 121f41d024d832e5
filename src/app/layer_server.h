#pragma once

// Pictures for the screen, made for those who watch.
//
// A view holds a LayerWatch and tells which part of which layer it shows at which step; it is then
// handed that part whenever it changes, newest state first, computed in the background. What nobody
// watches is not computed. While a control is dragged parts come at half resolution; the full one
// follows when it rests.
//
// Lives on the interface thread.

#include <functional>
#include <memory>
#include <vector>

#include <QObject>

#include "src/app/document.h"
#include "src/app/engine.h"
#include "src/app/job_runner.h"
#include "src/app/layer_part.h"
#include "src/app/picture_request.h"

namespace cutis {

class LayerServer;

// A wish to be shown something. Nothing is delivered after its destruction.
class LayerWatch {
 public:
  using Show = std::function<void(const std::shared_ptr<const LayerPart>&)>;

  ~LayerWatch();
  LayerWatch(const LayerWatch&) = delete;
  LayerWatch& operator=(const LayerWatch&) = delete;

  // Replaces the wish; an empty rect wishes nothing.
  void want(const LayerRequest& request);

 private:
  friend class LayerServer;
  LayerWatch(LayerServer& server, int priority, Show show)
      : server_(server), priority_(priority), show_(std::move(show)) {}

  LayerServer& server_;
  int priority_;
  Show show_;
  LayerRequest request_;
  bool due_ = false;  // the last part shown is not of this state, or none was
};

class LayerServer : public QObject {
  Q_OBJECT

 public:
  // All outlive the server.
  LayerServer(Document& document, Engine& engine, JobRunner& jobs, QObject* parent = nullptr);

  // Lower priorities are served first. The server outlives its watches.
  std::unique_ptr<LayerWatch> watch(int priority, LayerWatch::Show show);

  // What the layer `skin` shows.
  void setPicture(const PictureRequest& picture);
  const PictureRequest& picture() const { return picture_; }

  // Nothing is due and nothing under way.
  bool isIdle() const;

 Q_SIGNALS:
  void failed(const QString& sentence);
  void becameIdle();

 private:
  friend class LayerWatch;

  // Marks what `concerns` says as due.
  void invalidate(const std::function<bool(LayerKind)>& concerns);
  void forget();
  void remove(const LayerWatch* watch);
  void startNext();
  LayerWatch* mostUrgent() const;
  void deliver(const LayerWatch* watch, const std::shared_ptr<const LayerPart>& part);

  Document& document_;
  Engine& engine_;
  JobRunner& jobs_;
  PictureRequest picture_;
  std::vector<LayerWatch*> watches_;
  JobId job_ = 0;
  bool jobIsCoarse_ = false;
  bool moving_ = false;
};

}  // namespace cutis
