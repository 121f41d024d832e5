#pragma once

// Options of an edit, shared by `edit` and `apply`.

#include <memory>
#include <string>
#include <vector>

#include <CLI/App.hpp>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/edit/edit_stack.h"
#include "src/images/capture/mask_file.h"

namespace cutis {

// The texts as they were given; empty: not given.
struct EditOptions {
  std::string melanin;
  std::string melaninBlend;
  std::string carotene;
  std::string haemoglobinDermal;
  std::string haemoglobinEpidermal;
  std::string haemoglobin;
  std::vector<std::string> add;
  std::vector<std::string> set;
  std::string mask;
};

void addEditOptions(CLI::App& command, EditOptions& options);

// The parameters of the edit; its mask is still empty.
Result<Edit> parseEdit(const EditOptions& options);

// Reads the mask, if one is named.
Status loadEditMask(const EditOptions& options, const MaskedPicture& picture,
                    const std::shared_ptr<TileStore>& store, const JobContext& context, Edit& edit);

}  // namespace cutis
