#pragma once

// Options of an edit, shared by `edit` and `apply`.

#include <memory>
#include <string>
#include <vector>

#include <CLI/App.hpp>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/edit/edit_stack.h"

namespace cutis {

// As they were given; empty: not given.
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

// Reads the mask, if one is named, for maps of this size; `subject` names the maps in errors.
Status loadEditMask(const EditOptions& options, int width, int height, const std::string& subject,
                    const std::shared_ptr<TileStore>& store, const JobContext& context, Edit& edit);

}  // namespace cutis
