// edit: maps to maps.

#include "core/render/render_picture.h"
#include "src/app/export/export.h"
#include "src/cli/command.h"
#include "src/cli/commands/maps_input.h"
#include "src/cli/options/add_option.h"
#include "src/cli/options/edit_options.h"

namespace cutis {
namespace {

struct EditCommand {
  std::string maps;
  std::string output;
  std::string profile;
  EditOptions edit;
};

// What was said of the original values does not hold for edited ones.
void dropEstimates(MapsFile& file, const JobContext& context) {
  if (file.deviations.empty() && file.residuals.empty()) return;
  context.say("deviations and residuals describe the original and are left out of the edited maps");
  file.deviations.clear();
  file.constantDeviations.clear();
  file.residuals.clear();
  file.residualNames.clear();
}

Status runEditCommand(const EditCommand& command, Session& session) {
  CUTIS_TRY(edits, parseEditOptions(command.edit, session.context.notice));
  const ExportTarget target = {.path = command.output,
                               .inputs = {command.edit.mask, command.edit.preset, command.profile},
                               .sources = {command.maps}};
  CUTIS_CHECK(checkMapsTarget(target));
  const JobContext& context = session.context;
  CUTIS_TRY(opened,
            openMaps(command.maps, command.profile, session, context.child(0.0, 0.4, "reading")));
  MapsFile& file = opened.file;
  CUTIS_CHECK(loadEditMask(command.edit,
                           {file.maps.width(), file.maps.height(), "'" + command.maps + "'"},
                           session.store, context.child(0.4, 0.45), edits));
  if (!isNeutral(edits)) {
    CUTIS_TRY(edited, editMaps({opened.model, file.maps, edits}, session.store,
                               context.child(0.45, 0.6, "editing")));
    file.maps = std::move(edited);
    dropEstimates(file, context);
  }
  return exportTo(target, file, session.engine, session.store, context.child(0.6, 1.0));
}

}  // namespace

void addEditCommand(CLI::App& app, Invocation& invocation) {
  const auto options = std::make_shared<EditCommand>();
  CLI::App& command = addCommand(app, invocation, "edit", "Change maps and write them as new maps",
                                 options, runEditCommand);
  addOption(command, "MAPS", options->maps, "", "Maps to edit, as written by fit")->required();
  addOption(command, "-o,--output", options->output, "MAPS",
            "Maps to write, an OpenEXR file (.exr)")
      ->required();
  addMapsProfileOption(command, options->profile);
  addEditOptions(command, options->edit);
}

}  // namespace cutis
