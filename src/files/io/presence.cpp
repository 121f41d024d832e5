#include "src/files/io/presence.h"

#include <system_error>

namespace cutis {

namespace fs = std::filesystem;

Result<fs::file_status> presentStatus(const fs::path& path) {
  const std::string place = path.string();
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (error == std::errc::permission_denied) {
    return inputError(place, "a folder on the way there may not be entered; check its permissions");
  }
  if (error == std::errc::too_many_symbolic_link_levels) {
    return inputError(place, "this is a link that goes round in circles; mend the link");
  }
  if (!fs::exists(status)) return inputError(place, "there is no such file; check the name");
  return status;
}

}  // namespace cutis
