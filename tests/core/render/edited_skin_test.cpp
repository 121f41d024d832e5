// Edited skin as pictures, and the spectra of skins with constants of their own.

#include "core/render/edited_skin.h"

#include <QtTest>

#include "core/render/relight.h"
#include "core/render/render_picture.h"
#include "core/render/skin_spectra.h"
#include "core/skin/pixel_state.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

// Two pixels of skin and one without an estimate.
EditedSkin threePixels() {
  const ParameterVector skin = {0.03, 0.7, 0.02, 0.01, 0.0005};
  EditedSkin edited;
  edited.model = std::make_shared<const SkinModel>(test::li2024().profile());
  edited.maps = ChromophoreMaps(3, 1);
  for (const Parameter k : kParameters) {
    const auto value = static_cast<float>(skin[k]);
    static_cast<void>(
        edited.maps.values[k].store({0, 0, 3, 1}, std::vector{value, 1.5f * value, 0.0f}));
  }
  static_cast<void>(edited.maps.state.store(
      {0, 0, 3, 1}, std::vector{0.0f, 0.0f, static_cast<float>(PixelState::masked)}));
  return edited;
}

ResponseModel daylight() {
  return ResponseModel(test::li2024(),
                       colourRows(test::light("D65"), test::cie1931(), ChromaticAdaptation::none,
                                  test::light("D65"), test::cie1931()));
}

PictureBuffer greyPart() {
  PictureBuffer grey;
  grey.channels.assign(3, std::vector<float>(3, 0.4f));
  return grey;
}

class EditedSkinTest : public QObject {
  Q_OBJECT

 private slots:
  // The albedo changes by what the edit changes in the model's picture, and only where there is
  // skin.
  void theAlbedoFollowsTheModel() {
    EditedSkin skin = threePixels();
    const ResponseModel response = daylight();
    const auto original = renderPart(skin, response, {0, 0, 3, 1}, 1);
    skin.edits.emplace_back().parameters[kMelanin].scale = 2.0;
    const auto changed = renderPart(skin, response, {0, 0, 3, 1}, 1);
    const auto albedo = editAlbedoPart(greyPart(), skin, response, false, {0, 0, 3, 1}, 1);
    const auto pure = editAlbedoPart(greyPart(), skin, response, true, {0, 0, 3, 1}, 1);
    EXPECT_OK(original);
    EXPECT_OK(changed);
    EXPECT_OK(albedo);
    EXPECT_OK(pure);
    for (std::size_t c = 0; c < 3; ++c) {
      for (std::size_t i = 0; i < 2; ++i) {
        const float before = original.value().channels[c][i];
        const float after = changed.value().channels[c][i];
        QVERIFY(after < before);
        QCOMPARE(albedo.value().channels[c][i], 0.4f * (after / before));
        QCOMPARE(pure.value().channels[c][i], after);
      }
      QCOMPARE(albedo.value().channels[c][2], 0.4f);
      QCOMPARE(pure.value().channels[c][2], 0.4f);
    }
  }

  void withoutEditsTheSourceStays() {
    const auto albedo =
        editAlbedoPart(greyPart(), threePixels(), daylight(), false, {0, 0, 3, 1}, 1);
    EXPECT_OK(albedo);
    QVERIFY(albedo.value().channels == greyPart().channels);
  }

  // As the profile with these constants would be.
  void spectraHaveTheirOwnConstants() {
    const auto model = std::make_shared<const SkinModel>(test::li2024().profile());
    const ParameterVector skin = {0.03, 0.7, 0.02, 0.01, 0.0005};
    const SkinConstants own = {0.35, 0.4};
    const auto spectra = SkinSpectra::make(model, {{true, true}, std::nullopt}, {});
    EXPECT_OK(spectra);
    const SkinModel expected(withConstants(model->profile(), own));
    const Spectrum found = spectra.value().reflectance(skin, own);
    EXPECT_AT_MOST((found - expected.reflectance(skin)).abs().maxCoeff(), 1e-12);
    QVERIFY((found - model->reflectance(skin)).abs().maxCoeff() > 1e-3);
  }

  void withoutFreeConstantsSpectraAreTheModels() {
    const auto model = std::make_shared<const SkinModel>(test::li2024().profile());
    const ParameterVector skin = {0.03, 0.7, 0.02, 0.01, 0.0005};
    const auto spectra = SkinSpectra::make(model, {}, {});
    EXPECT_OK(spectra);
    QVERIFY((spectra.value().reflectance(skin, {0.1, 0.1}) == model->reflectance(skin)).all());
  }
};

CUTIS_TEST(EditedSkinTest)

}  // namespace
}  // namespace cutis

#include "edited_skin_test.moc"
