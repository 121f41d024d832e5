#include "src/files/profiles/table_cache.h"

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <optional>
#include <string>

#include "core/base/content_hash.h"
#include "src/files/io/atomic_write.h"

namespace cutis {

namespace fs = std::filesystem;

namespace {

constexpr char kMagic[] = "CUTIS TABLE 1\n";
constexpr std::size_t kDigestLength = 32;

// Names everything the table depends on.
std::string keyOf(const SkinModel& model, const SpectrumRows& rows) {
  ContentHash hash;
  hash.add(std::string_view(kMagic));
  hash.add(fingerprint(model.profile()));
  hash.add(std::span<const double>(rows.data(), static_cast<std::size_t>(rows.size())));
  return hash.digest();
}

std::string checksum(const SkinTable& table) {
  ContentHash hash;
  for (int k = 0; k < table.channelCount(); ++k) {
    hash.add(std::as_bytes(std::span<const float>(table.channel(k))));
  }
  return hash.digest();
}

// Nothing if the file is not exactly what was written for this key.
std::optional<SkinTable> readSkinTable(const fs::path& path, const std::string& key,
                                       const ParameterAxes& axes, int channelCount) {
  std::ifstream stream(path, std::ios::binary);
  std::string header(sizeof kMagic - 1 + 2 * kDigestLength, '\0');
  if (!stream.read(header.data(), static_cast<std::streamsize>(header.size()))) return {};
  const std::string digest = header.substr(header.size() - kDigestLength);
  if (!header.starts_with(kMagic + key)) return {};
  SkinTable table(axes, channelCount);
  for (int k = 0; k < channelCount; ++k) {
    std::vector<float>& channel = table.channel(k);
    const auto bytes = static_cast<std::streamsize>(channel.size() * sizeof(float));
    if (!stream.read(reinterpret_cast<char*>(channel.data()), bytes)) return {};
  }
  if (stream.peek() != std::ifstream::traits_type::eof()) return {};
  if (checksum(table) != digest) return {};
  return table;
}

Status writeSkinTable(const fs::path& path, const std::string& key, const SkinTable& table) {
  std::error_code ignored;
  fs::create_directories(path.parent_path(), ignored);
  return writeAtomically(path, [&](const fs::path& temporary) -> Status {
    std::ofstream stream(temporary, std::ios::binary);
    stream << kMagic << key << checksum(table);
    for (int k = 0; k < table.channelCount(); ++k) {
      const std::vector<float>& channel = table.channel(k);
      stream.write(reinterpret_cast<const char*>(channel.data()),
                   static_cast<std::streamsize>(channel.size() * sizeof(float)));
    }
    stream.close();
    if (!stream) return resourceError(path.string(), "the table cannot be cached");
    return {};
  });
}

}  // namespace

Result<std::shared_ptr<const SkinTable>> cachedSkinTable(const SkinModel& model,
                                                         const SpectrumRows& rows,
                                                         const fs::path& folder,
                                                         const JobContext& context) {
  // Other byte orders would need a conversion that nobody can test here.
  const bool usable = !folder.empty() && std::endian::native == std::endian::little;
  const std::string key = keyOf(model, rows);
  const fs::path path = folder / ("table-" + key + ".bin");
  std::error_code ignored;
  if (usable && fs::is_regular_file(path, ignored)) {
    if (auto table =
            readSkinTable(path, key, model.profile().axes, static_cast<int>(rows.rows()))) {
      return std::make_shared<const SkinTable>(std::move(*table));
    }
    context.say("the cached table " + path.string() +
                " is damaged or from another version; it is built again");
  }
  CUTIS_TRY(built, buildSkinTable(model, rows, context));
  if (usable) static_cast<void>(writeSkinTable(path, key, built));
  return std::make_shared<const SkinTable>(std::move(built));
}

}  // namespace cutis
