#include "src/files/profiles/layer_table_cache.h"

#include <bit>
#include <fstream>
#include <numeric>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "core/base/content_hash.h"
#include "src/files/io/atomic_write.h"

namespace cutis {

namespace fs = std::filesystem;

namespace {

constexpr char kLayerMagic[] = "CUTIS LAYERS 1\n";
constexpr std::size_t kLayerDigestLength = 32;

using Polynomial = LayerPolynomial<double>;
static_assert(std::is_trivially_copyable_v<Polynomial>);

std::vector<int> wholeGrid() {
  std::vector<int> samples(kSampleCount);
  std::iota(samples.begin(), samples.end(), 0);
  return samples;
}

std::string polynomialChecksum(std::span<const Polynomial> polynomials) {
  return ContentHash().add(std::as_bytes(polynomials)).digest();
}

// Nothing if the file is not exactly what was written for this key.
std::optional<LayerTable> readLayerTable(const fs::path& path, const std::string& key) {
  std::ifstream stream(path, std::ios::binary);
  std::string header(sizeof kLayerMagic - 1 + 2 * kLayerDigestLength, '\0');
  if (!stream.read(header.data(), static_cast<std::streamsize>(header.size()))) return {};
  if (!header.starts_with(kLayerMagic + key)) return {};
  std::vector<Polynomial> polynomials(kSampleCount);
  const auto bytes = static_cast<std::streamsize>(polynomials.size() * sizeof(Polynomial));
  if (!stream.read(reinterpret_cast<char*>(polynomials.data()), bytes)) return {};
  if (stream.peek() != std::ifstream::traits_type::eof()) return {};
  if (polynomialChecksum(polynomials) != header.substr(header.size() - kLayerDigestLength))
    return {};
  return LayerTable::restore(wholeGrid(), polynomials);
}

Status writeLayerTable(const fs::path& path, const std::string& key, const LayerTable& table) {
  std::error_code ignored;
  fs::create_directories(path.parent_path(), ignored);
  return writeAtomically(path, [&](const fs::path& temporary) -> Status {
    std::ofstream stream(temporary, std::ios::binary);
    const std::span<const Polynomial> polynomials = table.polynomials();
    stream << kLayerMagic << key << polynomialChecksum(polynomials);
    stream.write(reinterpret_cast<const char*>(polynomials.data()),
                 static_cast<std::streamsize>(polynomials.size_bytes()));
    stream.close();
    if (!stream) return resourceError(path.string(), "the table cannot be cached");
    return {};
  });
}

}  // namespace

Result<std::shared_ptr<const LayerTable>> cachedLayerTable(const Profile& profile,
                                                           const fs::path& folder,
                                                           const JobContext& context) {
  // Other byte orders would need a conversion that nobody can test here.
  const bool usable = !folder.empty() && std::endian::native == std::endian::little;
  const std::string key = layerTableFingerprint(profile);
  const fs::path path = folder / ("layers-" + key + ".bin");
  std::error_code ignored;
  if (usable && fs::is_regular_file(path, ignored)) {
    if (auto table = readLayerTable(path, key))
      return std::make_shared<const LayerTable>(std::move(*table));
    context.say("the cached table " + path.string() +
                " is damaged or from another version; it is built again");
  }
  CUTIS_TRY(made, LayerTable::makeWhole(profile, {}, context));
  if (usable) static_cast<void>(writeLayerTable(path, key, made));
  return std::make_shared<const LayerTable>(std::move(made));
}

}  // namespace cutis
