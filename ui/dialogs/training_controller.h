#pragma once

// Trains a network for the rig and the profile of the document, in the background, and shows how it
// goes in a dialog. Interface thread only.

#include <functional>
#include <memory>

#include <QObject>

#include "src/app/document/document.h"
#include "src/app/engine.h"
#include "src/app/job_runner.h"
#include "src/app/training/network_training.h"

namespace cutis {

class TrainingDialog;

class TrainingController : public QObject {
  Q_OBJECT

 public:
  using Plan = std::function<NetworkTraining(const Rig& rig, const std::string& profile)>;

  // All outlive the controller; the dialog stands before the window.
  TrainingController(Document& document, Engine& engine, JobRunner& jobs, QWidget* window);

  // Opens the dialog and begins; one training at a time. Ignored where there is nothing to fit.
  void train();
  // Ends what is under way and closes the dialog.
  void stop();
  // Fits the document with the network. Precondition, here and below: isTrained().
  void use();
  // Writes the weights in the background.
  void save(const QString& path);

  bool isTrained() const { return trained_ != nullptr; }
  TrainingDialog& dialog() { return *dialog_; }
  // How long and how well to train.
  void setPlan(Plan plan) { plan_ = std::move(plan); }

 private:
  void start(const Rig& rig, const std::string& profile);
  // Runs on the thread of the job.
  void run(const Rig& rig, const std::string& profile, const NetworkTraining& training,
           const JobRunner::Handle& job);
  void chooseFile();

  Document& document_;
  Engine& engine_;
  JobRunner& jobs_;
  TrainingDialog* dialog_;
  Plan plan_;
  JobId job_ = 0;
  std::string profile_;  // that is trained for
  std::shared_ptr<const NetworkFile> trained_;
};

}  // namespace cutis
