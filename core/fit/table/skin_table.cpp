#include "core/fit/table/skin_table.h"

#include <cassert>
#include <new>

#include "core/base/parallel.h"
#include "core/fit/table/table_kernel.h"
#include "core/skin/model/compiled_model.h"

namespace cutis {
namespace {

// Axes from the slowest to the fastest.
constexpr std::array<Parameter, kParameterCount> kOrder = {
    kMelanin, kMelaninBlend, kCarotene, kHaemoglobinDermal, kHaemoglobinEpidermal};
static_assert(kParameterCount == 5,
              "a sixth has a place in this order, a loop in fillBlock and an amount in "
              "TableArguments (core/fit/table/table_kernel.h)");

int samplesOf(const ParameterAxes& axes, Parameter parameter) {
  return axes[static_cast<std::size_t>(parameter)].samples;
}

double valueOf(const ParameterAxes& axes, Parameter parameter, int index) {
  return axes[static_cast<std::size_t>(parameter)].value(index);
}

std::vector<int> samplesInUse(const SpectrumRows& rows) {
  std::vector<int> samples;
  for (int i = 0; i < kSampleCount; ++i) {
    if ((rows.col(i) != 0.0).any()) samples.push_back(i);
  }
  return samples;
}

// All entries of one melanin and blend.
void fillBlock(TableArguments arguments, int melaninIndex, int blendIndex, SkinTable& table) {
  const ParameterAxes& axes = table.axes();
  const int dermalCount = samplesOf(axes, kHaemoglobinDermal);
  const auto channelCount = static_cast<std::size_t>(table.channelCount());
  std::vector<float> scratch(arguments.scratchSize());
  std::vector<float> values(channelCount * arguments.dermalStride);
  arguments.scratch = scratch.data();
  arguments.out = values.data();
  arguments.melanin = static_cast<float>(valueOf(axes, kMelanin, melaninIndex));
  arguments.blend = static_cast<float>(valueOf(axes, kMelaninBlend, blendIndex));
  for (int carotene = 0; carotene < samplesOf(axes, kCarotene); ++carotene) {
    arguments.carotene = static_cast<float>(valueOf(axes, kCarotene, carotene));
    for (int blood = 0; blood < samplesOf(axes, kHaemoglobinEpidermal); ++blood) {
      arguments.epidermalBlood = static_cast<float>(valueOf(axes, kHaemoglobinEpidermal, blood));
      runTableKernel(arguments);
      for (int dermal = 0; dermal < dermalCount; ++dermal) {
        const std::size_t entry = table.entry({melaninIndex, blendIndex, dermal, blood, carotene});
        for (std::size_t k = 0; k < channelCount; ++k) {
          table.channel(static_cast<int>(k))[entry] =
              values[k * arguments.dermalStride + static_cast<std::size_t>(dermal)];
        }
      }
    }
  }
}

}  // namespace

std::size_t tableSize(const ParameterAxes& axes) {
  std::size_t size = 1;
  for (const ParameterAxis& axis : axes)
    size *= static_cast<std::size_t>(axis.samples);
  return size;
}

SkinTable::SkinTable(const ParameterAxes& axes, int channelCount)
    : axes_(axes),
      size_(tableSize(axes)),
      channels_(static_cast<std::size_t>(channelCount), std::vector<float>(size_)) {}

std::size_t SkinTable::entry(const std::array<int, kParameterCount>& samples) const {
  std::size_t index = 0;
  for (const Parameter parameter : kOrder) {
    index = index * static_cast<std::size_t>(samplesOf(axes_, parameter)) +
            static_cast<std::size_t>(samples[static_cast<std::size_t>(parameter)]);
  }
  return index;
}

std::array<int, kParameterCount> SkinTable::samples(std::size_t entry) const {
  std::array<int, kParameterCount> samples = {};
  for (auto parameter = kOrder.rbegin(); parameter != kOrder.rend(); ++parameter) {
    const auto count = static_cast<std::size_t>(samplesOf(axes_, *parameter));
    samples[static_cast<std::size_t>(*parameter)] = static_cast<int>(entry % count);
    entry /= count;
  }
  return samples;
}

ParameterVector SkinTable::parameters(std::size_t entry) const {
  const std::array<int, kParameterCount> at = samples(entry);
  ParameterVector values;
  for (const Parameter parameter : kParameters) {
    values[parameter] = valueOf(axes_, parameter, at[static_cast<std::size_t>(parameter)]);
  }
  return values;
}

Result<SkinTable> buildSkinTable(const SkinModel& model, const SpectrumRows& rows,
                                 const JobContext& context) try {
  CUTIS_CHECK(requireFive(model.profile(), "a table of skin"));
  assert(rows.rows() <= kMaximumTableRows);
  const ParameterAxes& axes = model.profile().axes;
  const CompiledModel nodes(model, samplesInUse(rows));
  const int dermalCount = samplesOf(axes, kHaemoglobinDermal);
  std::vector<float> dermalBlood;
  for (int i = 0; i < dermalCount; ++i) {
    dermalBlood.push_back(static_cast<float>(valueOf(axes, kHaemoglobinDermal, i)));
  }
  std::vector<float> weights;  // by node, then row
  for (const int sample : nodes.samples()) {
    for (int k = 0; k < kMaximumTableRows; ++k) {
      weights.push_back(k < rows.rows() ? static_cast<float>(rows(k, sample)) : 0.0f);
    }
  }

  TableArguments arguments;
  arguments.nodes = nodes.nodes<float>().data();
  arguments.nodeCount = nodes.nodes<float>().size();
  arguments.layers = nodes.layers<float>();
  arguments.weights = weights.data();
  arguments.rowCount = static_cast<std::size_t>(rows.rows());
  arguments.dermalStride = roundUpToTableLanes(dermalBlood.size());
  dermalBlood.resize(arguments.dermalStride, 0.0f);
  arguments.dermalBlood = dermalBlood.data();
  std::vector<float> dermis(arguments.nodeCount * arguments.dermalStride);
  arguments.dermis = dermis.data();
  runDermisKernel(arguments);

  SkinTable table(axes, static_cast<int>(rows.rows()));
  const int blends = samplesOf(axes, kMelaninBlend);
  const auto pieces = static_cast<std::size_t>(samplesOf(axes, kMelanin) * blends);
  CUTIS_CHECK(parallelFor(pieces, context, [&](std::size_t i) -> Status {
    const int piece = static_cast<int>(i);
    fillBlock(arguments, piece / blends, piece % blends, table);
    return {};
  }));
  return table;
} catch (const std::bad_alloc&) {
  return resourceError("", "not enough memory for the table of skin; close other programs");
}

}  // namespace cutis
