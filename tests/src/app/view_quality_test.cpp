// What is shown while a control moves and when it rests, on the embedded sample.

#include <cmath>

#include <QtTest>

#include "core/render/box_average.h"
#include "core/spectra/colorimetry.h"
#include "src/app/views/view_samples.h"
#include "src/app/views/view_server.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/rendered_view.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {
namespace view_quality {

constexpr int kPatienceMs = 120000;
const ViewRequest kAlbedo = {ViewKind::editedAlbedo, {300, 300, 501, 421}, 3};

Command flush(double factor, bool moving) {
  return {"flush", "flush",
          [factor](DocumentState& state) {
            if (state.edits.empty()) state.edits.emplace_back();
            state.edits.front().parameters[kHaemoglobinDermal].scale = factor;
          },
          moving};
}

double encoded(float linear) {
  return encodeSrgb(std::clamp(double{linear}, 0.0, 1.0));
}

double worstStep(const PictureBuffer& a, const PictureBuffer& b) {
  double worst = 0;
  for (std::size_t c = 0; c < a.channels.size(); ++c) {
    for (std::size_t i = 0; i < a.channels[c].size(); ++i)
      worst = std::max(worst, std::abs(encoded(a.channels[c][i]) - encoded(b.channels[c][i])));
  }
  return 255 * worst;
}

Eigen::Vector3d labOf(const PictureBuffer& picture, std::size_t i) {
  static const Eigen::Vector3d white = test::daylightWhite();
  const auto& c = picture.channels;
  return labFromXyz(xyzFromRec709(white) * Eigen::Vector3d(c[0][i], c[1][i], c[2][i]), white);
}

double worstDifference(const PictureBuffer& a, const PictureBuffer& b) {
  double worst = 0;
  for (std::size_t i = 0; i < a.present.size(); ++i)
    worst = std::max(worst, deltaE2000(labOf(a, i), labOf(b, i)));
  return worst;
}

}  // namespace view_quality

class ViewQualityTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() {
    document_.openSample();
    QTRY_VERIFY_WITH_TIMEOUT(document_.isFitted(), view_quality::kPatienceMs);
    QTRY_VERIFY(jobs_.isIdle());
  }
  void cleanupTestCase() { jobs_.stopAll(); }
  void init() {
    parts_.clear();
    watch_ = server_.watch(ViewPriority::detail, [this](const auto& part) { parts_ << part; });
  }
  void cleanup() {
    watch_.reset();
    while (document_.history().canUndo())
      document_.undo();
    QTRY_VERIFY_WITH_TIMEOUT(server_.isIdle(), view_quality::kPatienceMs);
  }

  // From samples in memory and a table nearly the same picture comes as from the planes.
  void movingPicturesAreNearTheExactOnesAtHalfTheResolution() {
    watch_->want(view_quality::kAlbedo);
    QTRY_COMPARE(parts_.size(), 2);
    document_.apply(view_quality::flush(1.7, true));
    QTRY_VERIFY(parts_.size() >= 3);
    ViewRequest coarse = view_quality::kAlbedo;
    coarse.step *= 2;
    QVERIFY(parts_[2]->request == coarse);
    const auto expected = test::renderedView(document_.scene(), engine_, {}, coarse);
    EXPECT_OK(expected);
    QVERIFY(parts_[2]->pixels.present == expected.value().pixels.present);
    EXPECT_AT_MOST(view_quality::worstDifference(parts_[2]->pixels, expected.value().pixels), 0.3);
  }

  // The button is still down.
  void aControlThatRestsShowsTheSharpPictureAndThenAllTexels() {
    watch_->want(view_quality::kAlbedo);
    QTRY_COMPARE(parts_.size(), 2);
    document_.apply(view_quality::flush(1.6, true));
    QTRY_COMPARE(parts_.size(), 5);
    QCOMPARE(parts_[2]->request.step, 6);
    QCOMPARE(parts_[3]->request.step, 3);
    QCOMPARE(parts_[4]->request.step, 3);
    const auto sharp = test::renderedView(document_.scene(), engine_, {}, view_quality::kAlbedo);
    EXPECT_OK(sharp);
    EXPECT_AT_MOST(view_quality::worstDifference(parts_[3]->pixels, sharp.value().pixels), 0.3);
    QVERIFY(parts_[4]->pixels.channels != sharp.value().pixels.channels);
  }

  // What an export writes, reduced in the same way.
  void atRestAPixelIsTheMeanOfItsEditedTexels() {
    document_.apply(view_quality::flush(1.8, false));
    watch_->want(view_quality::kAlbedo);
    QTRY_COMPARE(parts_.size(), 2);
    ViewRequest every = view_quality::kAlbedo;
    every.step = 1;
    const auto texels = test::renderedView(document_.scene(), engine_, {}, every);
    EXPECT_OK(texels);
    const PictureBuffer expected = boxAverage(texels.value().pixels, view_quality::kAlbedo.step);
    QCOMPARE(parts_[1]->pixels.width, 67);
    QCOMPARE(parts_[1]->pixels.height, 41);
    EXPECT_AT_MOST(view_quality::worstStep(parts_[1]->pixels, expected), 0.01);
    // Single texels are further off: there is something to average.
    QVERIFY(view_quality::worstStep(parts_[0]->pixels, expected) > 1.0);
  }

  void concentrationsAreNeverAveraged() {
    ViewRequest map = view_quality::kAlbedo;
    map.view = ViewKind::melanin;
    watch_->want(map);
    QTRY_COMPARE(parts_.size(), 1);
    QTRY_VERIFY(server_.isIdle());
    QTest::qWait(50);
    QCOMPARE(parts_.size(), 1);
  }

  // One pixel of the screen for each of the picture: no means follow, so that it is exact at once.
  void atOneToOneTheSharpPictureIsExact() {
    ViewRequest every = view_quality::kAlbedo;
    every.step = 1;
    watch_->want(every);
    QTRY_COMPARE(parts_.size(), 1);
    document_.apply(view_quality::flush(1.6, true));
    QTRY_COMPARE(parts_.size(), 3);
    const auto sharp = test::renderedView(document_.scene(), engine_, {}, every);
    EXPECT_OK(sharp);
    QVERIFY(parts_[2]->pixels.channels == sharp.value().pixels.channels);
  }

  // The photograph has no skin to thin.
  void aPhotographIsShownWhileAControlMoves() {
    ViewRequest photograph = view_quality::kAlbedo;
    photograph.view = ViewKind::photograph;
    watch_->want(photograph);
    QTRY_COMPARE(parts_.size(), 2);
    document_.apply(view_quality::flush(1.6, true));
    QTRY_VERIFY_WITH_TIMEOUT(server_.isIdle(), view_quality::kPatienceMs);
    QCOMPARE(parts_.back()->pixels.channels, parts_[1]->pixels.channels);
  }

  // A large picture would otherwise be fetched from disk for each thumbnail.
  void viewsOfOnePartReadTheMapsOnce() {
    const auto load = [this](ViewKind view, int step, const std::shared_ptr<const ViewSkin>& read) {
      ViewRequest request = view_quality::kAlbedo;
      request.view = view;
      request.step = step;
      return ViewSamples::load(document_.scene(), engine_, {}, request, read, {});
    };
    const auto first = load(ViewKind::melanin, 3, nullptr);
    EXPECT_OK(first);
    const auto second = load(ViewKind::skin, 3, first.value().skin());
    EXPECT_OK(second);
    QVERIFY(second.value().skin() == first.value().skin());
    const auto fresh = load(ViewKind::skin, 3, nullptr);
    EXPECT_OK(fresh);
    const auto shared = second.value().render({}, ViewAccuracy::exact, {});
    const auto apart = fresh.value().render({}, ViewAccuracy::exact, {});
    EXPECT_OK(shared);
    EXPECT_OK(apart);
    QVERIFY(shared.value().pixels.channels == apart.value().pixels.channels);
    const auto finer = load(ViewKind::skin, 2, first.value().skin());
    EXPECT_OK(finer);
    QVERIFY(finer.value().skin() != first.value().skin());
  }

  // A new light is shown with samples of its own, not with those of the last.
  void anotherLightIsAnotherPicture() {
    ViewRequest skin = view_quality::kAlbedo;
    skin.view = ViewKind::skin;
    watch_->want(skin);
    QTRY_COMPARE(parts_.size(), 2);
    const PictureRequest tungsten = {"A", "cie1931", ChromaticAdaptation::none, std::nullopt};
    server_.setPicture(tungsten);
    QTRY_COMPARE_WITH_TIMEOUT(parts_.size(), 4, view_quality::kPatienceMs);
    const auto expected = test::renderedView(document_.scene(), engine_, tungsten, skin);
    EXPECT_OK(expected);
    QVERIFY(parts_[2]->pixels.channels == expected.value().pixels.channels);
  }

 private:
  Engine engine_{std::filesystem::path()};
  JobRunner jobs_;
  Document document_{engine_, jobs_};
  ViewServer server_{document_, engine_, jobs_};
  QVector<std::shared_ptr<const ViewPart>> parts_;
  std::unique_ptr<ViewWatch> watch_;
};

CUTIS_TEST(ViewQualityTest)

}  // namespace
}  // namespace cutis

#include "view_quality_test.moc"
