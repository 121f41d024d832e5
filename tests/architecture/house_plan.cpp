#include "tests/architecture/house_plan.h"

#include <algorithm>
#include <iterator>
#include <sstream>

namespace cutis::test {
namespace {

// Names of rooms, one blank apart. "core/skin" is that room alone, "core/skin/*" the rooms below it
// as well.
struct Room {
  const char* name;
  const char* sees;
};

// From the ground up: a room sees only rooms that stand above it in this list.
constexpr Room kRooms[] = {
    {"resources", ""},
    {"core/base", ""},
    {"core/maths", "core/base"},
    {"core/transport", "core/base core/maths"},
    {"core/spectra", "core/base"},

    // Skin: its parts do not see the face that they make up together.
    {"core/skin/profile", "core/base core/spectra"},
    {"core/skin/layers", "core/base core/maths core/transport core/spectra core/skin/profile"},
    {"core/skin/model",
     "core/base core/maths core/transport core/spectra core/skin/profile core/skin/layers"},
    {"core/skin/free",
     "core/base core/maths core/transport core/spectra core/skin/profile core/skin/layers "
     "core/skin/model"},
    {"core/skin", "core/base core/maths core/spectra core/skin/*"},

    {"core/rig", "core/base core/spectra core/skin/*"},
    {"core/neural/dense", "core/base core/maths"},
    {"core/neural", "core/base core/maths core/spectra core/skin/* core/rig core/neural/dense"},

    // Fit: the run and the seam of solvers lie below, the methods above and apart.
    {"core/fit", "core/base core/maths core/spectra core/skin/* core/rig core/neural"},
    {"core/fit/table", "core/base core/maths core/spectra core/skin/* core/rig core/fit"},
    {"core/fit/refined", "core/base core/maths core/spectra core/skin/* core/rig core/fit"},
    {"core/fit/free",
     "core/base core/maths core/spectra core/skin/* core/rig core/fit core/fit/refined"},
    {"core/fit/spectra", "core/base core/maths core/spectra core/skin/* core/rig core/fit"},
    {"core/fit/reference", "core/base core/maths core/spectra core/skin/* core/rig core/fit"},

    // What turns maps into other maps and pictures never sees rig or fit.
    {"core/edit", "core/base core/spectra core/skin/*"},
    {"core/render", "core/base core/maths core/spectra core/skin/* core/edit"},

    {"core/simulate/paint", "core/base core/skin/profile"},
    {"core/simulate", "core/base core/spectra core/skin/* core/rig core/simulate/paint"},
    {"core/analyse", "core/base core/maths core/spectra core/skin/* core/rig core/fit/*"},
    {"core/evaluate",
     "core/base core/maths core/spectra core/skin/* core/rig core/fit/* core/simulate"},
    {"core/calibrate/discrepancy",
     "core/base core/maths core/spectra core/skin/* core/rig core/fit/*"},
    {"core/calibrate",
     "core/base core/maths core/spectra core/skin/* core/rig core/fit/* core/evaluate "
     "core/calibrate/discrepancy"},

    {"src/files/system", "core/base"},
    {"src/files/io", "core/base src/files/system"},
    {"src/files/spectra", "core/base core/spectra src/files/io"},
    {"src/files", "core/* resources src/files/io src/files/spectra"},
    {"src/files/profiles", "core/* resources src/files src/files/io src/files/spectra"},
    {"src/files/networks", "core/* resources src/files src/files/io src/files/spectra"},
    {"src/files/edits", "core/* resources src/files src/files/io"},

    {"src/images/pixels", "core/base"},
    {"src/color", "core/* src/files/*"},
    {"src/images/inputs", "core/base src/files/io"},
    {"src/images/codec",
     "core/base core/spectra src/files/io src/files/system src/color src/images/pixels "
     "src/images/inputs"},
    {"src/images/color", "core/* src/files/io src/color src/images/codec src/images/inputs"},
    {"src/images",
     "core/* src/files/io src/color src/images/codec src/images/color src/images/pixels"},
    {"src/images/preview",
     "core/* src/files/io src/color src/images src/images/codec src/images/color "
     "src/images/inputs src/images/pixels"},
    {"src/images/maps",
     "core/* src/files/* src/color src/images src/images/codec src/images/color"},
    {"src/images/capture",
     "core/* src/files/* src/color src/images src/images/codec src/images/color "
     "src/images/pixels"},
    {"src/report", "core/base src/files src/files/io src/files/system"},
    {"src/report/plot", "core/base src/report"},

    {"src/app", "core/* src/files/* src/images/* src/color"},
    {"src/app/open", "core/* src/files/* src/images/* src/color src/app"},
    {"src/app/project", "core/* src/files/* src/images/* src/color src/app src/app/open"},
    {"src/app/document",
     "core/* src/files/* src/images/* src/color src/app src/app/open "
     "src/app/project"},
    {"src/app/views", "core/* src/files/* src/app src/app/open src/app/document"},
    {"src/app/export",
     "core/* src/files/* src/images/* src/color src/app src/app/open src/app/document"},
    {"src/app/training", "core/* src/files/* src/app src/app/open src/app/document"},

    {"src/bench", "core/* src/files/* src/images/* src/color src/app/*"},
    {"src/cli/options", "core/* src/files/* src/images/* src/color src/app/*"},
    {"src/cli", "core/* src/files/* src/images/* src/color src/report/* src/app/* src/cli/options"},
    // The folders of the larger commands are apart from each other.
    {"src/cli/commands/bench",
     "core/* src/files/* src/images/* src/color src/report/* src/app/* src/bench src/cli "
     "src/cli/options"},
    {"src/cli/commands/info",
     "core/* src/files/* src/images/* src/color src/app/* src/cli src/cli/options"},
    {"src/cli/commands/rig",
     "core/* src/files/* src/report/* src/app/* src/bench src/cli src/cli/options"},
    {"src/cli/commands/train",
     "core/* src/files/* src/report/* src/app/* src/bench src/cli src/cli/options"},
    {"src/cli/commands/validate",
     "core/* src/files/* src/report/* src/app/* src/bench src/cli src/cli/options"},
    {"src/cli/commands",
     "core/* src/files/* src/images/* src/color src/report/* src/app/* src/bench "
     "src/cli src/cli/options src/cli/commands/validate"},

    {"ui/theme", "core/base"},
    {"ui/commands", "core/base ui/theme"},
    {"ui/plot", "core/base core/spectra src/report/* ui/theme"},
    {"ui/widgets", "core/base core/spectra core/skin/profile src/app/training ui/theme"},
    {"ui/color", "core/spectra core/analyse src/app/document ui/theme"},
    {"ui/view",
     "core/base core/maths core/spectra core/skin/* src/app src/app/document src/app/views "
     "ui/theme ui/widgets "
     "ui/color"},
    {"ui/compare",
     "core/base core/edit core/render src/app src/app/document src/app/views ui/theme ui/color "
     "ui/view"},
    {"ui/docks", "core/* src/files/* src/app/* ui/theme ui/commands ui/plot ui/widgets ui/view"},
    {"ui/dialogs",
     "core/* src/files/* src/images/* src/app/* ui/theme ui/commands ui/plot ui/widgets"},
    {"ui/edits", "core/* src/files/* src/app/* ui/theme ui/widgets ui/view ui/docks ui/dialogs"},
    {"ui/spectrum",
     "core/* src/files/* src/report/* src/app/* ui/theme ui/commands ui/plot ui/widgets ui/view "
     "ui/dialogs"},
    {"ui/inspector",
     "core/* src/files src/app src/app/document src/app/views ui/theme ui/color ui/plot ui/widgets "
     "ui/view"},
    {"ui/documents",
     "core/* src/files/* src/app/* ui/theme ui/commands ui/plot ui/widgets ui/view ui/compare "
     "ui/docks ui/dialogs ui/edits ui/spectrum ui/inspector"},
    {"ui/menus",
     "core/base core/skin/profile src/app/* src/files/system ui/theme ui/color ui/commands ui/view "
     "ui/compare ui/docks ui/dialogs ui/edits ui/spectrum ui/documents"},
    {"ui/window",
     "core/* src/files/* src/images/* src/color src/app/* ui/theme ui/color ui/commands ui/plot "
     "ui/widgets ui/view ui/compare ui/docks ui/dialogs ui/edits ui/spectrum ui/documents "
     "ui/menus"},
    {"src/cutis", "core/* src/files/* src/images/* src/color src/app/* ui/*"},
};

const Room* find(const std::string& name) {
  const auto* found = std::find_if(std::begin(kRooms), std::end(kRooms),
                                   [&](const Room& room) { return name == room.name; });
  return found == std::end(kRooms) ? nullptr : found;
}

bool isWithin(const std::string& path, const std::string& folder) {
  return path == folder || path.starts_with(folder + "/");
}

bool covers(const std::string& entry, const std::string& room) {
  if (entry.ends_with("/*")) return isWithin(room, entry.substr(0, entry.size() - 2));
  return entry == room;
}

// "core" of "core", "core/skin" of "core/skin/profile/profile.h".
std::string firstParts(const std::string& path, int count) {
  std::size_t end = 0;
  for (int i = 0; i < count && end != std::string::npos; ++i)
    end = path.find('/', end + (i > 0 ? 1 : 0));
  return path.substr(0, end);
}

}  // namespace

std::string roomOf(const std::string& path) {
  const std::string top = firstParts(path, 1);
  if (top == path) return {};
  if (top == "resources" || top == "tests") return top;
  if (top != "core" && top != "src" && top != "ui") return {};
  return path.substr(0, path.rfind('/'));
}

std::string libraryOf(const std::string& path) {
  const std::string top = firstParts(path, 1);
  if (top == "ui" || top == "resources" || top == "tests") return top;
  if (top != "core" && top != "src") return {};
  const std::string two = firstParts(path, 2);
  return two == path ? std::string() : two;
}

std::vector<std::string> planErrors() {
  std::vector<std::string> errors;
  for (const Room* room = std::begin(kRooms); room != std::end(kRooms); ++room) {
    std::istringstream entries(room->sees);
    for (std::string entry; entries >> entry;) {
      const bool any = std::any_of(std::begin(kRooms), std::end(kRooms),
                                   [&](const Room& each) { return covers(entry, each.name); });
      if (!any) errors.push_back(std::string(room->name) + " sees " + entry + ", which is no room");
    }
    for (const Room* later = room + 1; later != std::end(kRooms); ++later) {
      if (mayInclude(room->name, later->name)) {
        errors.push_back(std::string(room->name) + " sees " + later->name + ", which stands later");
      }
    }
  }
  return errors;
}

bool isRoom(const std::string& name) {
  return find(name) != nullptr;
}

bool mayInclude(const std::string& room, const std::string& other) {
  const Room* from = find(room);
  if (from == nullptr || !isRoom(other)) return false;
  if (room == other) return true;
  std::istringstream entries(from->sees);
  for (std::string entry; entries >> entry;) {
    if (covers(entry, other)) return true;
  }
  return false;
}

bool mayLink(const std::string& library, const std::string& other) {
  for (const Room& room : kRooms) {
    if (libraryOf(std::string(room.name) + "/") != library) continue;
    for (const Room& used : kRooms) {
      if (libraryOf(std::string(used.name) + "/") != other) continue;
      if (mayInclude(room.name, used.name)) return true;
    }
  }
  return false;
}

}  // namespace cutis::test
