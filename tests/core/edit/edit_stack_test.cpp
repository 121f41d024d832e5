#include "core/edit/edit_stack.h"

#include <cmath>
#include <cstring>
#include <limits>

#include <QtTest>

#include "core/base/random.h"
#include "core/skin/pixel_state.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

constexpr int kWidth = 300, kHeight = 280;
constexpr Rect kAll = {0, 0, kWidth, kHeight};

const ParameterAxes& axes() {
  return test::li2024().profile().axes;
}

// Random skin; every seventh pixel is masked, every eleventh hard.
ChromophoreMaps randomMaps() {
  ChromophoreMaps maps(kWidth, kHeight);
  Random random(1);
  std::vector<float> values(kAll.pixelCount()), states(kAll.pixelCount());
  for (std::size_t i = 0; i < states.size(); ++i) {
    const auto state = i % 7 == 0    ? PixelState::masked
                       : i % 11 == 0 ? PixelState::noConvergence
                                     : PixelState::solved;
    states[i] = storedState(state);
  }
  for (std::size_t k = 0; k < kParameterCount; ++k) {
    for (float& value : values)
      value = static_cast<float>(random.uniform(0, axes()[k].maximum));
    static_cast<void>(maps.values[k].store(kAll, values));
  }
  static_cast<void>(maps.state.store(kAll, states));
  return maps;
}

Edit scaled(Parameter parameter, double scale) {
  Edit edit;
  edit.parameters[parameter].scale = scale;
  return edit;
}

Plane maskOf(const std::function<float(int, int)>& value) {
  Plane mask(kWidth, kHeight, PixelFormat::half);
  std::vector<float> values;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x)
      values.push_back(value(x, y));
  }
  static_cast<void>(mask.store(kAll, values));
  return mask;
}

class EditStackTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() {
    maps_ = randomMaps();
    original_ = loaded(kAll, 1);
  }

  void onlyWhatIsEditedChanges() {
    const ParameterBuffer edited = apply({scaled(kHaemoglobinDermal, 1.7)});
    for (const Parameter parameter : kParameters) {
      const auto k = static_cast<std::size_t>(parameter);
      for (std::size_t i = 0; i < edited.count(); ++i) {
        const double before = double{original_.values[k][i]};
        if (parameter != kHaemoglobinDermal || !edited.present[i]) {
          QCOMPARE(edited.values[k][i], original_.values[k][i]);
        } else {
          const double expected = std::min(0.5, before * (1.0 + 0.7 * std::cbrt(before / 0.5)));
          EXPECT_NEAR(edited.values[k][i], expected, 1e-6);
        }
      }
    }
  }

  // An edit that changes nothing changes not a bit.
  void neutralEditsAreNoOps() {
    Edit off = scaled(kMelanin, 3.0);
    off.enabled = false;
    Edit clear = scaled(kMelanin, 3.0);
    clear.opacity = 0.0;
    Edit covered = scaled(kMelanin, 3.0);
    covered.mask = maskOf([](int, int) { return 0.0f; });
    for (const EditStack& stack :
         {EditStack{}, EditStack{Edit()}, EditStack{off, clear, covered}}) {
      QVERIFY(same(apply(stack), original_));
    }
  }

  void masksAndOpacityBlend() {
    Edit edit = scaled(kMelanin, 0.5);
    edit.mask = maskOf([](int x, int) { return static_cast<float>(x) / 256.0f; });
    edit.opacity = 0.75;
    const ParameterBuffer edited = apply({edit});
    for (std::size_t i = 0; i < edited.count(); ++i) {
      const double mask = std::min(1.0, static_cast<double>(i % kWidth) / 256.0);
      const double weight = edited.present[i] ? 0.75 * mask : 0.0;
      const double before = double{original_.values[kMelanin][i]};
      EXPECT_NEAR(edited.values[kMelanin][i], before - weight * 0.5 * before, 1e-7);
    }
  }

  // A mask from a file may hold anything; what is no number includes nothing.
  void oddMasksAreClamped() {
    Edit edit = scaled(kMelanin, 0.5);
    edit.mask = maskOf([](int x, int) {
      const float odd[] = {-1.0f, 7.0f, std::numeric_limits<float>::quiet_NaN(),
                           std::numeric_limits<float>::infinity()};
      return odd[x % 4];
    });
    const ParameterBuffer edited = apply({edit});
    for (std::size_t i = 0; i < edited.count(); ++i) {
      const bool included = edited.present[i] && (i % kWidth) % 2 == 1;
      const float before = original_.values[kMelanin][i];
      QCOMPARE(edited.values[kMelanin][i], included ? 0.5f * before : before);
    }
  }

  // The edits of a stack see what those before them made.
  void editsApplyFromFirstToLast() {
    Edit add;
    add.parameters[kMelanin].add = 0.1;
    const Edit doubled = scaled(kMelanin, 2.0);
    const ParameterBuffer addedFirst = apply({add, doubled});
    const ParameterBuffer doubledFirst = apply({doubled, add});
    for (std::size_t i = 0; i < addedFirst.count(); ++i) {
      if (!addedFirst.present[i]) continue;
      const double c = double{original_.values[kMelanin][i]};
      EXPECT_NEAR(addedFirst.values[kMelanin][i], std::min(0.5, 2.0 * std::min(0.5, c + 0.1)),
                  1e-6);
      EXPECT_NEAR(doubledFirst.values[kMelanin][i], std::min(0.5, std::min(0.5, 2.0 * c) + 0.1),
                  1e-6);
    }
  }

  void setReplaces() {
    Edit edit;
    edit.parameters[kMelaninBlend].set = 0.25;
    edit.parameters[kCarotene].set = 5.0;  // beyond the range
    const ParameterBuffer edited = apply({edit});
    for (std::size_t i = 0; i < edited.count(); ++i) {
      if (!edited.present[i]) continue;
      QCOMPARE(edited.values[kMelaninBlend][i], 0.25f);
      QCOMPARE(edited.values[kCarotene][i], 0.01f);
    }
  }

  void unsolvedPixelsStay() {
    Edit edit;
    for (const Parameter parameter : kParameters) {
      edit.parameters[static_cast<std::size_t>(parameter)].set = 0.005;
    }
    const ParameterBuffer edited = apply({edit});
    std::size_t unsolved = 0;
    for (std::size_t i = 0; i < edited.count(); ++i) {
      if (i % 7 != 0) continue;
      ++unsolved;
      QVERIFY(!edited.present[i]);
      for (std::size_t k = 0; k < edited.values.rowCount(); ++k) {
        QCOMPARE(edited.values[k][i], original_.values[k][i]);
      }
    }
    QVERIFY(unsolved > 1000);
  }

  // Any rectangle, and any step between pixels, shows the same pixels.
  void partsAgreeWithTheWhole() {
    Edit edit = scaled(kHaemoglobinEpidermal, 1.9);
    edit.mask =
        maskOf([](int x, int y) { return static_cast<float>((x * 7 + y * 3) % 100) / 100; });
    edit.opacity = 0.6;
    const EditStack stack = {edit, scaled(kMelanin, 1.2)};
    const ParameterBuffer whole = apply(stack);
    for (const auto& [rect, step] : std::vector<std::pair<Rect, int>>{{{0, 0, 300, 280}, 3},
                                                                      {{17, 250, 290, 263}, 1},
                                                                      {{255, 255, 257, 257}, 1},
                                                                      {{5, 9, 298, 271}, 8}}) {
      ParameterBuffer part = loaded(rect, step);
      EXPECT_OK(applyEdits(stack, axes(), rect, step, part));
      std::size_t i = 0;
      for (int y = rect.y0; y < rect.y1; y += step) {
        for (int x = rect.x0; x < rect.x1; x += step, ++i) {
          const auto at = static_cast<std::size_t>(y * kWidth + x);
          for (std::size_t k = 0; k < kParameterCount; ++k) {
            QCOMPARE(part.values[k][i], whole.values[k][at]);
          }
        }
      }
      QCOMPARE(part.count(), i);
    }
  }

  void resultsStayInTheirRanges() {
    Random random(3);
    for (int turn = 0; turn < 20; ++turn) {
      Edit edit;
      for (std::size_t k = 0; k < kParameterCount; ++k) {
        edit.parameters[k].scale = random.uniform(0.0, 5.0);
        edit.parameters[k].add = random.uniform(-1.0, 1.0) * axes()[k].maximum;
      }
      edit.opacity = random.uniform();
      const ParameterBuffer edited = apply({edit});
      for (std::size_t k = 0; k < kParameterCount; ++k) {
        const auto maximum = static_cast<float>(axes()[k].maximum);
        for (const float value : edited.values[k])
          QVERIFY(value >= 0.0f && value <= maximum);
      }
    }
  }

 private:
  ParameterBuffer loaded(const Rect& rect, int step) const {
    return loadParameters(maps_, rect, step).value();
  }
  ParameterBuffer apply(const EditStack& stack) const {
    ParameterBuffer buffer = original_;
    static_cast<void>(applyEdits(stack, axes(), kAll, 1, buffer));
    return buffer;
  }
  static bool same(const ParameterBuffer& a, const ParameterBuffer& b) {
    for (std::size_t k = 0; k < kParameterCount; ++k) {
      if (std::memcmp(a.values[k].data(), b.values[k].data(), 4 * a.count()) != 0) return false;
    }
    return a.present == b.present;
  }

  ChromophoreMaps maps_;
  ParameterBuffer original_;
};

CUTIS_TEST(EditStackTest)

}  // namespace
}  // namespace cutis

#include "edit_stack_test.moc"
