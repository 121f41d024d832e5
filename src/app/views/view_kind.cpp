#include "src/app/views/view_kind.h"

#include "core/rig/rig.h"

namespace cutis {
namespace {

int numberOf(ViewKind view) {
  return static_cast<int>(view);
}

// The parameter of one of five views in the order of Parameter.
std::optional<Parameter> parameterFrom(ViewKind first, ViewKind view) {
  static_assert(kParameterCount == 5,
                "a sixth has its views in view_kind.h and its rows in ui/view/view_catalogue.cpp");
  const int index = numberOf(view) - numberOf(first);
  if (index < 0 || index >= kParameterCount) return std::nullopt;
  return kParameters[static_cast<std::size_t>(index)];
}

}  // namespace

std::optional<Parameter> parameterOf(ViewKind view) {
  return parameterFrom(ViewKind::melanin, view);
}

std::optional<Parameter> deviationOf(ViewKind view) {
  return parameterFrom(ViewKind::melaninDeviation, view);
}

std::optional<SkinConstant> constantOf(ViewKind view) {
  if (view == ViewKind::oxygenation) return kOxygenation;
  if (view == ViewKind::thickness) return kThickness;
  return std::nullopt;
}

ViewKind lightView(int light) {
  return static_cast<ViewKind>(numberOf(ViewKind::firstLight) + light);
}

std::optional<int> lightOf(ViewKind view) {
  const int light = numberOf(view) - numberOf(ViewKind::firstLight);
  if (light < 0 || light >= kMaximumLights) return std::nullopt;
  return light;
}

bool isPhotograph(ViewKind view) {
  return view == ViewKind::photograph || lightOf(view).has_value();
}

bool isJudgement(ViewKind view) {
  return deviationOf(view) || view == ViewKind::residual || view == ViewKind::shading;
}

bool canBeAveraged(ViewKind view) {
  return !parameterOf(view) && !constantOf(view) && !isJudgement(view);
}

bool canShow(const Scene& scene, ViewKind view) {
  if (view == ViewKind::photograph || view == ViewKind::editedAlbedo)
    return scene.source != nullptr;
  // Of an only light it is the photograph itself.
  if (const auto light = lightOf(view)) {
    if (scene.source == nullptr) return false;
    const auto count = static_cast<int>(scene.source->measurements.rig.lights.size());
    return count > 1 && *light < count;
  }
  if (const auto constant = constantOf(view)) return scene.maps.free().has(*constant);
  if (!isJudgement(view)) return true;
  if (scene.evidence == nullptr) return false;
  if (deviationOf(view)) return scene.evidence->hasDeviations();
  return view != ViewKind::shading || scene.evidence->hasShading();
}

}  // namespace cutis
