#pragma once  // internal to src/cli/commands/train

// A training as a picture: curves of both losses, the error that principal components leave against
// their number, the components themselves, and a spectrum taken apart and put together again.

#include "core/skin/model/skin_model.h"
#include "src/app/training/network_training.h"
#include "src/report/drawing.h"

namespace cutis {

// model: that of the networks. About 0.1 s.
Drawing trainPlot(const SkinModel& model, const TrainedNetworks& trained);

}  // namespace cutis
