#include "core/skin/model/node_cache.h"

#include <cstddef>
#include <span>

#include "core/base/content_hash.h"

namespace cutis {
namespace {

// Some kilobytes each; a window that is fed ever new lights must not grow for ever.
constexpr std::size_t kMost = 256;

std::string keyOf(const SpectrumRows& rows, const NodeOptions& options) {
  ContentHash hash;
  hash.add(std::span(rows.data(), static_cast<std::size_t>(rows.size())));
  hash.add(options.rmsTolerance).add(static_cast<double>(options.maximumNodes));
  return hash.digest();
}

}  // namespace

SpectralNodes NodeCache::get(const SpectrumRows& rows, const NodeOptions& options,
                             const std::function<SpectralNodes()>& choose) {
  const std::string key = keyOf(rows, options);
  {
    const std::lock_guard lock(mutex_);
    const auto found = known_.find(key);
    if (found != known_.end()) return found->second;
  }
  SpectralNodes nodes = choose();
  const std::lock_guard lock(mutex_);
  if (known_.size() >= kMost) known_.clear();
  known_.emplace(key, nodes);
  return nodes;
}

}  // namespace cutis
