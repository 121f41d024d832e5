#include "core/skin/model/reflectance_batch.h"

#include "core/skin/model/reflectance_kernel.h"

namespace cutis {

template <typename T>
void reflectanceBatch(const CompiledModel& model, const ParameterBatch<T>& batch, T* reflectance,
                      T* perEpidermalAbsorption, T* perDermalAbsorption) {
  BatchArguments<T> arguments = {};
  arguments.nodes = model.nodes<T>().data();
  arguments.nodeCount = model.nodes<T>().size();
  arguments.layers = model.layers<T>();
  for (std::size_t k = 0; k < batch.values.size(); ++k)
    arguments.parameters[k] = batch.values[k];
  arguments.count = batch.count;
  arguments.reflectance = reflectance;
  arguments.perEpidermal = perEpidermalAbsorption;
  arguments.perDermal = perDermalAbsorption;
  runReflectanceKernel(arguments);
}

template <typename T>
void reflectanceBatch(const CompiledModel& model, const ParameterBatch<T>& batch, T* reflectance) {
  reflectanceBatch<T>(model, batch, reflectance, nullptr, nullptr);
}

template void reflectanceBatch(const CompiledModel&, const ParameterBatch<float>&, float*);
template void reflectanceBatch(const CompiledModel&, const ParameterBatch<double>&, double*);
template void reflectanceBatch(const CompiledModel&, const ParameterBatch<float>&, float*, float*,
                               float*);
template void reflectanceBatch(const CompiledModel&, const ParameterBatch<double>&, double*,
                               double*, double*);

}  // namespace cutis
