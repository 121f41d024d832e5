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
  std::string preset;
};

void addEditOptions(CLI::App& command, EditOptions& options);

// The edits of the preset, if one is named, and that of the other options after them; their masks
// are still empty.
Result<EditStack> parseEditOptions(const EditOptions& options, const Notice& notice);

// Reads the mask, if one is named, which bounds all of the edits.
Status loadEditMask(const EditOptions& options, const MaskedPicture& picture,
                    const std::shared_ptr<TileStore>& store, const JobContext& context,
                    EditStack& edits);

}  // namespace cutis
