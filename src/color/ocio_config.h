#pragma once  // internal to src/color

// The OpenColorIO configuration that $OCIO names.
//
// It is read once for each value of $OCIO. Its spaces are related to ours through its role
// aces_interchange or, in configurations without that role, through its own linear Rec.709.

#include <memory>
#include <string>
#include <vector>

#include "src/color/color_space.h"

namespace cutis {

class OcioConfig {
 public:
  // Null if $OCIO is not set. Fails with a sentence if what it names cannot be read.
  static Result<std::shared_ptr<const OcioConfig>> fromEnvironment();

  bool has(const std::string& name) const;
  std::string canonicalName(const std::string& name) const;
  std::vector<std::string> names() const;

  // Precondition: has(name).
  Result<ColorConverter> toLinearRec709(const std::string& name, const std::string& place) const;
  Result<ColorConverter> fromLinearRec709(const std::string& name, const std::string& place) const;

 private:
  struct Impl;
  explicit OcioConfig(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}
  std::shared_ptr<const Impl> impl_;
};

}  // namespace cutis
