#pragma once

// Fills the panel of distributions: the histogram from the overview of the current view, the locus
// from a small picture of the photograph. While nobody sees the panel nothing is made for it.
// Interface thread only.

#include <memory>
#include <vector>

#include <QObject>

#include "src/app/document/document.h"
#include "src/app/latest_job.h"
#include "src/app/views/view_server.h"

namespace cutis {

class DistributionPanel;
class ViewController;
class Viewport;

class DistributionController : public QObject {
  Q_OBJECT

 public:
  // All outlive the controller.
  DistributionController(Document& document, JobRunner& jobs, ViewServer& server,
                         ViewController& views, Viewport& viewport);
  ~DistributionController() override;

  void attach(DistributionPanel& panel);
  // At first nobody sees it.
  void setSeen(bool seen);

 private:
  using Part = std::shared_ptr<const ViewPart>;

  void refresh();
  void wantColors();
  void showHistogram();
  void showColors(const Part& part);
  void makeSheet();
  void pointAt(int x, int y);

  Document& document_;
  ViewServer& server_;
  ViewController& views_;
  LatestJob sheetJob_;
  DistributionPanel* panel_ = nullptr;
  bool seen_ = false;
  Part colors_;  // of the photograph, or of the skin where there is none
  std::unique_ptr<ViewWatch> watch_;
};

}  // namespace cutis
