#pragma once

// Pictures for the screen, made for those who watch.
//
// A panel holds a ViewWatch and says which part of which view it shows at which step; it is then
// handed that part whenever it changes, newest state first, computed in the background. What nobody
// watches is not computed. While a control is dragged parts come at half resolution; the full one
// follows when it rests, whether it is let go or not, and after it, where a sample stands for
// several texels of light, their mean. Whatever changes stops what it makes needless.
//
// What a watch last showed is kept as samples in memory (src/app/views/view_samples.h): an edit
// reads no plane again.
//
// Lives on the interface thread.

#include <cstdint>
#include <functional>
#include <map>
#include <memory>

#include <QObject>
#include <QTimer>

#include "src/app/document/document.h"
#include "src/app/engine.h"
#include "src/app/job_runner.h"
#include "src/app/picture_request.h"
#include "src/app/views/view_part.h"
#include "src/app/views/view_samples.h"

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
  bool due_ = false;         // the last part shown is not of this state, or none was
  bool averageDue_ = false;  // it is, but nothing was done yet that waits for everything else
  bool seen_ = true;
  // The samples of the request and the maps as they are, if they were read; and every other one of
  // them.
  std::shared_ptr<const ViewSamples> samples_;
  std::shared_ptr<const ViewSamples> coarse_;
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

  enum class Quality {
    coarse,   // half the resolution of the screen
    sharp,    // one texel for each pixel of it
    averaged  // all texels, where they have a mean; and what the next move will ask for
  };
  struct Made {
    std::shared_ptr<const ViewPart> part;  // null: nothing new to be shown
    std::shared_ptr<const ViewSamples> samples;
    std::shared_ptr<const ViewSamples> coarse;
    std::shared_ptr<const ViewSkin> skin;  // that the view has read, or another before it
  };
  // What a job works for.
  struct Task {
    std::uint64_t watch = 0;
    Quality quality = Quality::sharp;
    ViewAccuracy accuracy = ViewAccuracy::exact;
    bool hasMeans = false;  // that differ from its samples
    ViewRequest request;
    std::uint64_t state = 0;
  };

  void connectDocument();
  void editsChanged(bool moving);
  void controlRests();
  // Marks what `concerns` says as due.
  void invalidate(const std::function<bool(const ViewRequest&)>& concerns);
  // Samples are of another state now.
  void forgetSamples();
  void forget();
  void cancelJob();
  // Means wait for everything else.
  void postponeAverage();
  bool isCoarse() const { return moving_ && !resting_; }
  bool isServed(const ViewWatch& watch) const;
  // Whether exact means follow what it shows sharply.
  bool willBeAveraged(const ViewWatch& watch, const ViewRequest& request) const;
  void startNext();
  void start(ViewWatch& watch, Quality quality);
  // On the thread of the job.
  Result<Made> make(const Task& task, Made known, const Scene& scene, const PictureRequest& picture,
                    const JobContext& context) const;
  ViewWatch* mostUrgent() const;
  ViewWatch* notAveraged() const;
  void deliver(const Task& task, const Made& made);

  Document& document_;
  Engine& engine_;
  JobRunner& jobs_;
  PictureRequest picture_;
  std::map<std::uint64_t, ViewWatch*> watches_;  // by id: a job may outlive the watch it works for
  std::uint64_t nextId_ = 1;
  std::uint64_t state_ = 0;  // counts the states of maps and light
  JobId job_ = 0;
  // What was last read of the maps as they are; null: nothing.
  std::shared_ptr<const ViewSkin> skin_;
  Task task_;             // of the job
  bool moving_ = false;   // a control is held …
  bool resting_ = false;  // … but has not moved for a while
  QTimer restTimer_;
};

}  // namespace cutis
