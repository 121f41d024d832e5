// Reflectance of the two layers at one node, whatever theory its profile names. Included once per
// instruction set (Highway).

#if defined(CUTIS_CORE_SKIN_LAYERS_NODE_REFLECTANCE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CUTIS_CORE_SKIN_LAYERS_NODE_REFLECTANCE_INL_H_
#undef CUTIS_CORE_SKIN_LAYERS_NODE_REFLECTANCE_INL_H_
#else
#define CUTIS_CORE_SKIN_LAYERS_NODE_REFLECTANCE_INL_H_
#endif

#include <hwy/highway.h>

#include "core/skin/layers/diffusion-inl.h"
#include "core/skin/layers/node_constants.h"
#include "core/skin/layers/table-inl.h"

HWY_BEFORE_NAMESPACE();
namespace cutis {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <bool kDerivatives, class D, class V = hn::Vec<D>>
HWY_INLINE LayeredVectors<V> NodeReflectanceOf(D d, const LayerConstants<hn::TFromD<D>>& layers,
                                               const NodeConstants<hn::TFromD<D>>& node,
                                               V epidermalAbsorption, V dermalAbsorption) {
  if (node.transport != nullptr) {
    return TabulatedReflectanceOf<kDerivatives>(d, *node.transport, epidermalAbsorption,
                                                dermalAbsorption);
  }
  return LayeredReflectanceOf<kDerivatives>(d, layers, node, epidermalAbsorption, dermalAbsorption);
}

}  // namespace HWY_NAMESPACE
}  // namespace cutis
HWY_AFTER_NAMESPACE();

#endif
