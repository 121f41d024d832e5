#include "src/color/ocio_cycles.h"

#include <set>

namespace cutis {

namespace ocio = OCIO_NAMESPACE;

namespace {

class DefinitionWalk {
 public:
  explicit DefinitionWalk(const ocio::Config& config) : config_(config) {}

  // Whether what this name stands for leads back to something on the way to it.
  bool findsCycle(const char* reference) {
    const std::string name = config_.getCurrentContext()->resolveStringVar(reference);
    if (done_.contains(name)) return false;
    if (!open_.insert(name).second) return true;
    const bool cycle = visitSpace(name) || visitLook(name) || visitNamedTransform(name);
    open_.erase(name);
    done_.insert(name);
    return cycle;
  }

 private:
  bool visitSpace(const std::string& name) {
    const auto space = config_.getColorSpace(name.c_str());
    if (!space) return false;
    // A role or alias and the space itself are one thing.
    if (name != space->getName()) return findsCycle(space->getName());
    return visit(space->getTransform(ocio::COLORSPACE_DIR_TO_REFERENCE)) ||
           visit(space->getTransform(ocio::COLORSPACE_DIR_FROM_REFERENCE));
  }

  bool visitLook(const std::string& name) {
    const auto look = config_.getLook(name.c_str());
    return look && (findsCycle(look->getProcessSpace()) || visit(look->getTransform()) ||
                    visit(look->getInverseTransform()));
  }

  bool visitNamedTransform(const std::string& name) {
    const auto named = config_.getNamedTransform(name.c_str());
    return named && (visit(named->getTransform(ocio::TRANSFORM_DIR_FORWARD)) ||
                     visit(named->getTransform(ocio::TRANSFORM_DIR_INVERSE)));
  }

  // "look_a, -look_b | look_c"
  bool visitLooks(const std::string& list) {
    std::size_t at = 0;
    while ((at = list.find_first_not_of(",|:+- \t", at)) != std::string::npos) {
      const std::size_t end = list.find_first_of(",|:+ \t", at);
      const std::string name = list.substr(at, end - at);
      if (findsCycle(name.c_str())) return true;
      at = end;
    }
    return false;
  }

  bool visit(const ocio::ConstTransformRcPtr& transform) {
    if (auto group = castTo<ocio::GroupTransform>(transform)) {
      for (int i = 0; i < group->getNumTransforms(); ++i) {
        if (visit(group->getTransform(i))) return true;
      }
    } else if (auto spaces = castTo<ocio::ColorSpaceTransform>(transform)) {
      return findsCycle(spaces->getSrc()) || findsCycle(spaces->getDst());
    } else if (auto looks = castTo<ocio::LookTransform>(transform)) {
      return findsCycle(looks->getSrc()) || findsCycle(looks->getDst()) ||
             visitLooks(looks->getLooks());
    } else if (auto view = castTo<ocio::DisplayViewTransform>(transform)) {
      return findsCycle(view->getSrc()) ||
             findsCycle(
                 config_.getDisplayViewColorSpaceName(view->getDisplay(), view->getView())) ||
             visitLooks(config_.getDisplayViewLooks(view->getDisplay(), view->getView()));
    }
    return false;
  }

  template <typename T>
  static std::shared_ptr<const T> castTo(const ocio::ConstTransformRcPtr& transform) {
    return std::dynamic_pointer_cast<const T>(transform);
  }

  const ocio::Config& config_;
  std::set<std::string> open_;
  std::set<std::string> done_;
};

}  // namespace

bool refersToItself(const ocio::Config& config, const std::string& name) {
  return DefinitionWalk(config).findsCycle(name.c_str());
}

}  // namespace cutis
