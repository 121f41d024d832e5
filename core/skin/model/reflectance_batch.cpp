#include "core/skin/model/reflectance_batch.h"

#include <cassert>
#include <cstddef>

#include "core/skin/model/reflectance_kernel.h"

namespace cutis {

template <typename T>
PixelBuffer<T> parameterRows(std::span<const ParameterVector> people) {
  PixelBuffer<T> parameters(kParameterCount, people.size());
  for (std::size_t k = 0; k < kParameterCount; ++k) {
    const std::span<T> row = parameters[k];
    for (std::size_t i = 0; i < people.size(); ++i)
      row[i] = static_cast<T>(people[i][static_cast<Eigen::Index>(k)]);
  }
  return parameters;
}

template <typename T>
void reflectanceBatch(const CompiledModel& model, PixelRows<const T> parameters,
                      PixelRows<T> reflectance, PixelRows<T> perEpidermalAbsorption,
                      PixelRows<T> perDermalAbsorption) {
  assert(parameters.rowCount >= std::size_t{kParameterCount});
  assert(reflectance.rowCount == model.nodes<T>().size());
  assert(reflectance.count == parameters.count);
  runReflectanceKernel<T>({model.nodes<T>().data(), model.nodes<T>().size(), model.layers<T>(),
                           parameters, reflectance, perEpidermalAbsorption, perDermalAbsorption});
}

template <typename T>
void reflectanceBatch(const CompiledModel& model, PixelRows<const T> parameters,
                      PixelRows<T> reflectance) {
  reflectanceBatch<T>(model, parameters, reflectance, {}, {});
}

template PixelBuffer<float> parameterRows(std::span<const ParameterVector>);
template PixelBuffer<double> parameterRows(std::span<const ParameterVector>);
template void reflectanceBatch(const CompiledModel&, PixelRows<const float>, PixelRows<float>);
template void reflectanceBatch(const CompiledModel&, PixelRows<const double>, PixelRows<double>);
template void reflectanceBatch(const CompiledModel&, PixelRows<const float>, PixelRows<float>,
                               PixelRows<float>, PixelRows<float>);
template void reflectanceBatch(const CompiledModel&, PixelRows<const double>, PixelRows<double>,
                               PixelRows<double>, PixelRows<double>);

}  // namespace cutis
