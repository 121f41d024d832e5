#pragma once

// Edits as text: presets, the clipboard and projects hold the same JSON.
//
//   { "cutis_edits": 1,
//     "edits": [ { "name": "Tan", "region": null, "opacity": 1.0, "on": true,
//                  "melanin": {"mode": "scale", "value": 1.4} } ],
//     "regions": [] }
//
// A parameter that is left out stays as it is. Its mode is "scale" (by the parameter's law of
// editing, see core/edit/edit_stack.h; with "add" beside "value" that is added after it), "add" or
// "set", both in the parameter's unit. "region", "opacity" and "on" may be left out as well. There
// are no regions in this version: an edit that names one is refused, and so is a mode that it does
// not have.
//
// Errors are sentences that name file and field. Pure.

#include <filesystem>
#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/edit/edit_stack.h"
#include "src/files/io/json_file.h"

namespace cutis {

inline constexpr int kNewestEdits = 1;

// `place` stands for the text in sentences: the name of its file, "the clipboard". `notice` hears
// of every field that means nothing here and is passed over.
Result<EditStack> readEdits(std::string_view text, const std::string& place, const Notice& notice);
Result<EditStack> readEditsFile(const std::filesystem::path& path, const Notice& notice);

// readEdits() gives the same edits again. Precondition: no edit has a mask, which is a picture.
std::string editsText(const EditStack& edits);

// The fields "edits" and "regions" of a document that holds them among others.
Result<EditStack> parseEdits(const JsonValue& document, const Notice& notice);
void addEditsTo(nlohmann::ordered_json& document, const EditStack& edits);

}  // namespace cutis
