#include "tests/src/app/project_fixture.h"

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "src/files/profiles/profile_file.h"
#include "src/images/image_file.h"

namespace cutis::test {

namespace fs = std::filesystem;

namespace {

Plane evenPlane(float value) {
  Plane plane(kTextureWidth, kTextureHeight);
  const std::vector<float> values(plane.bounds().pixelCount(), value);
  if (!plane.store(plane.bounds(), values)) std::abort();
  return plane;
}

}  // namespace

void writeTexture(const fs::path& path, float shade) {
  ImageContent content;
  content.channelNames = {"R", "G", "B"};
  content.channels = {evenPlane(0.62f * shade), evenPlane(0.46f * shade), evenPlane(0.38f * shade)};
  if (!writeImage(path, content, SampleType::uint16, {})) std::abort();
}

Project projectOf(const fs::path& image) {
  Project project;
  project.source.kind = SourceKind::image;
  project.source.path = image;
  project.source.files = listSourceFiles(image, {});
  if (!addHashes(image, {}, project.source.files, {})) std::abort();
  project.edits.emplace_back();
  project.edits.front().parameters[kMelanin].scale = 1.5;
  return project;
}

MapsFile mapsOfTexture(double exposure) {
  MapsFile file;
  file.maps = ChromophoreMaps(kTextureWidth, kTextureHeight);
  file.maps.values[kMelanin] = evenPlane(0.02f);
  file.attributes.profileName = kDefaultProfile;
  file.attributes.profileJson = profileText(kDefaultProfile, {}).value();
  file.attributes.rigName = "albedo";
  file.attributes.method = "refined";
  file.attributes.exposure = exposure;
  return file;
}

std::vector<std::string> allNames(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    names.push_back(entry.path().lexically_relative(folder).generic_string());
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace cutis::test
