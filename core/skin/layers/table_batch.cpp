#include "core/skin/layers/table_batch.h"

#include "core/skin/layers/table_kernel.h"

namespace cutis {

template <typename T>
void evaluateBatch(const LayerPolynomial<T>& polynomial, const LayerTableBatch<T>& batch) {
  runLayerTableKernel<T>({&polynomial, batch.epidermalAbsorption, batch.dermalAbsorption,
                          batch.count, batch.reflectance, batch.perEpidermalAbsorption,
                          batch.perDermalAbsorption});
}

template void evaluateBatch(const LayerPolynomial<float>&, const LayerTableBatch<float>&);
template void evaluateBatch(const LayerPolynomial<double>&, const LayerTableBatch<double>&);

}  // namespace cutis
