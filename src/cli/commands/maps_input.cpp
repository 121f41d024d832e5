#include "src/cli/commands/maps_input.h"

#include "core/base/echoed_text.h"

namespace cutis {
namespace {

Result<std::shared_ptr<const SkinModel>> modelOf(const MapsAttributes& attributes,
                                                 const std::string& path,
                                                 const std::string& profile, Engine& engine) {
  if (attributes.profileJson.empty()) {
    if (!profile.empty()) return engine.model(profile, "--profile");
    return inputError(path,
                      "the maps do not carry the profile of their skin model; name it with "
                      "--profile");
  }
  if (!profile.empty()) {
    return usageError("--profile", "the maps carry their own profile " +
                                       inQuotes(attributes.profileName) + "; leave this out");
  }
  return engine.modelFromText(attributes.profileJson, path + ": profile of the maps");
}

}  // namespace

Result<OpenedMaps> openMaps(const std::string& path, const std::string& profile,
                            const Session& session, const JobContext& context) {
  CUTIS_TRY(file, readMaps(path, PixelFormat::float32, session.store, context));
  CUTIS_TRY(model, modelOf(file.attributes, path, profile, session.engine));
  CUTIS_CHECK(checkCoefficients(file.maps, model->profile(), path));
  return OpenedMaps{std::move(file), model};
}

void addMapsProfileOption(CLI::App& command, std::string& profile) {
  command
      .add_option("--profile", profile,
                  "Skin model of maps that do not carry their own: a built-in name or a JSON "
                  "file")
      ->type_name("NAME|FILE");
}

}  // namespace cutis
