#pragma once

// The manifest of a project, NAME.cutis: JSON beside the fitted maps in NAME.cutis.data.
//
//   { "cutis_project": 1,
//     "source": { "kind": "image", "path": "face.png",
//                 "files": [ {"file": "face.png", "hash": "0b93…"} ],
//                 "rig": "", "lights": [], "mask": "", "layer": "", "colorspace": "",
//                 "exposure": "auto" },
//     "fit": {"profile": "skin2026", "method": "refined", "shading": false,
//             "specular": "included", "specular_share": 0.04},
//     "maps": "face.cutis.data/4f1c….exr",
//     "edits": [ … ], "regions": [],
//     "view": {"view": "skin", "place": [x, y, zoom], "light": "D65", "observer": "cie1931",
//               "adaptation": "none"},
//     "pins": [ {"letter": "A", "name": "cheek", "place": [812, 440]} ],
//     "pin_size": 3, "pin_reference": "A" }
//
// Paths are relative to the folder of the manifest where there is a way. "kind" is sample, image,
// capture or maps; a journal names the project that it belongs to as "edits_of"; "maps" is null
// while nothing is fitted, "place" while the whole picture is shown; pins are left out where there
// are none, and so is what is usual of them. Edits are those of
// src/files/edits/edits_file.h. Fields this version does not know are passed over with a notice; a
// newer version is refused.
//
// Errors are sentences that name file and field. Pure, but for readProject().

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "src/app/project/project.h"

namespace cutis {

inline constexpr int kNewestProject = 1;
inline constexpr char kProjectExtension[] = ".cutis";

bool isProjectFile(const std::filesystem::path& path);  // by its name

// The text of the manifest in this folder; an empty folder names all files absolutely.
std::string projectText(const Project& project, const std::filesystem::path& folder);

// The project that the text of a manifest at `path` describes. readProject() reads it from there.
Result<Project> parseProject(std::string_view text, const std::filesystem::path& path,
                             const Notice& notice);
Result<Project> readProject(const std::filesystem::path& path, const Notice& notice);

}  // namespace cutis
