// The first impression of each kind of file is the picture that is read later, made smaller.

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <QtTest>

#include "core/spectra/colorimetry.h"
#include "src/images/layer_choice.h"
#include "src/images/preview/image_preview.h"
#include "src/images/preview/preview_layout.h"
#include "src/images/preview/smaller_version.h"
#include "src/images/preview/sparse_rows.h"
#include "tests/src/images/foreign_file.h"
#include "tests/src/images/image_fixture.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {
namespace file_preview_test {

constexpr int kWidth = 1200;
constexpr int kHeight = 800;
constexpr int kLeastSide = 300;
constexpr int kStep = 4;

// Smooth colours that tell the corners of the picture apart, and an alpha.
float sampleAt(int channel, double u, double v) {
  const double values[] = {0.3 + 0.5 * u, 0.2 + 0.5 * v, 0.6 - 0.3 * u * v, 0.4 + 0.6 * u * v};
  return static_cast<float>(values[channel]);
}

OIIO::ImageSpec specOf(int channels, OIIO::TypeDesc type) {
  return {kWidth, kHeight, channels, type};
}

// Colours multiplied by the fourth channel where there is one.
std::vector<float> samplesOf(const OIIO::ImageSpec& spec) {
  std::vector<float> samples;
  for (int y = 0; y < spec.height; ++y) {
    for (int x = 0; x < spec.width; ++x) {
      const double u = (x + 0.5) / spec.width, v = (y + 0.5) / spec.height;
      const float alpha = spec.nchannels == 4 ? sampleAt(3, u, v) : 1.0f;
      for (int c = 0; c < spec.nchannels; ++c)
        samples.push_back(c == 3 ? alpha : alpha * sampleAt(c, u, v));
    }
  }
  return samples;
}

void write(const std::filesystem::path& path, const std::string& format,
           const OIIO::ImageSpec& spec) {
  test::writeForeign(path, format, spec, samplesOf(spec));
}

OIIO::ImageSpec tiled(OIIO::ImageSpec spec, int side) {
  spec.tile_width = spec.tile_height = side;
  spec.tile_depth = 1;
  return spec;
}

OIIO::ImageSpec with(OIIO::ImageSpec spec, const std::string& name, const std::string& value) {
  spec.attribute(name, value);
  return spec;
}

OIIO::ImageSpec turned(OIIO::ImageSpec spec, int orientation) {
  spec.attribute("Orientation", orientation);
  return spec;
}

// A quarter of each side, all of one colour by which it is known.
OIIO::ImageSpec quarterOf(OIIO::ImageSpec spec) {
  spec.full_width = spec.width /= kStep;
  spec.full_height = spec.height /= kStep;
  return spec;
}

void append(OIIO::ImageOutput& output, const std::filesystem::path& path,
            const OIIO::ImageSpec& spec, OIIO::ImageOutput::OpenMode mode, float value) {
  const std::vector<float> samples(spec.image_pixels() * static_cast<std::size_t>(spec.nchannels),
                                   value);
  if (!output.open(path.string(), spec, mode) ||
      !output.write_image(OIIO::TypeFloat, samples.data())) {
    test::fail("cannot write " + path.string() + ": " + output.geterror());
  }
}

void writeLevels(const std::filesystem::path& path) {
  OIIO::ImageSpec spec = tiled(specOf(3, OIIO::TypeHalf), 64);
  spec.attribute("openexr:levelmode", 1);
  spec.attribute("textureformat", "Plain Texture");
  const auto output = OIIO::ImageOutput::create("openexr");
  append(*output, path, spec, OIIO::ImageOutput::Create, 0.25f);
  for (float value = 0.5f; spec.width > 1 || spec.height > 1; value += 0.0625f) {
    spec.full_width = spec.width = std::max(1, spec.width / 2);
    spec.full_height = spec.height = std::max(1, spec.height / 2);
    append(*output, path, spec, OIIO::ImageOutput::AppendMIPLevel, value);
  }
  output->close();
}

void writePages(const std::filesystem::path& path, int subfile) {
  const OIIO::ImageSpec whole = specOf(3, OIIO::TypeUInt8);
  OIIO::ImageSpec small = quarterOf(whole);
  small.attribute("tiff:subfiletype", subfile);
  const auto output = OIIO::ImageOutput::create("tiff");
  append(*output, path, whole, OIIO::ImageOutput::Create, 0.25f);
  append(*output, path, small, OIIO::ImageOutput::AppendSubimage, 0.75f);
  output->close();
}

// What is shown of it at last, whether before it is read or while it is.
std::optional<ImagePreview> lastPreview(const std::filesystem::path& path,
                                        const PreviewOptions& options) {
  auto preview = previewImage(path, options, {});
  if (preview) return preview;
  const PreviewSink sink = {options, [&](ImagePreview seen) { preview = std::move(seen); }};
  const ImageReadOptions read = {.layer = options.layer, .overscan = true, .preview = &sink};
  if (!readImage(path, read, std::make_shared<TileStore>(), {})) return std::nullopt;
  return preview;
}

double encoded(double linear) {
  return encodeSrgb(std::clamp(linear, 0.0, 1.0));
}

// The whole picture, made smaller by averaging what is seen.
class WholePicture {
 public:
  WholePicture(const std::filesystem::path& path, const PreviewOptions& options)
      : image_(readImage(path, {.layer = options.layer, .overscan = true},
                         std::make_shared<TileStore>(), {})
                   .value()) {
    const auto decision = decideColors(image_.colors, options.colorSpace, {});
    const auto& layer = image_.layer;
    const int grey = image_.channelIndex("Y");
    const std::array<int, 3> colors = layer.colors.value_or(std::array<int, 3>{grey, grey, grey});
    const std::size_t pixels = Rect{0, 0, image_.width, image_.height}.pixelCount();
    rgb_.resize(3 * pixels);
    std::vector<float> alpha;
    if (layer.alpha >= 0 && image_.alphaKind == AlphaKind::associated)
      alpha = test::valuesOf(image_.channels[static_cast<std::size_t>(layer.alpha)]);
    for (std::size_t c = 0; c < 3; ++c) {
      auto plane = test::valuesOf(image_.channels[static_cast<std::size_t>(colors[c])]);
      if (!alpha.empty()) divideByAlpha(plane, alpha);
      for (std::size_t p = 0; p < pixels; ++p)
        rgb_[3 * p + c] = plane[p];
    }
    if (decision.value().followed.space.toLinearRec709(rgb_).failed()) test::fail("colours");
  }

  int width() const { return image_.width; }
  int height() const { return image_.height; }

  double meanOf(int channel, int column, int row, int step) const {
    double sum = 0;
    for (int y = row * step; y < (row + 1) * step; ++y) {
      for (int x = column * step; x < (column + 1) * step; ++x)
        sum += rgb_[static_cast<std::size_t>(3 * (y * image_.width + x) + channel)];
    }
    return sum / (step * step);
  }

 private:
  Image image_;
  std::vector<float> rgb_;
};

double worstDifference(const ImagePreview& preview, const WholePicture& whole) {
  double worst = 0;
  for (int row = 0; row < preview.rows; ++row) {
    for (int column = 0; column < preview.columns; ++column) {
      for (int c = 0; c < 3; ++c) {
        const float seen = preview.colors[static_cast<std::size_t>(c)]
                                         [static_cast<std::size_t>(row * preview.columns + column)];
        const double difference =
            std::abs(encoded(double{seen}) - encoded(whole.meanOf(c, column, row, preview.step)));
        worst = std::isnan(seen) ? 1.0 : std::max(worst, difference);
      }
    }
  }
  return worst;
}

}  // namespace file_preview_test

using namespace file_preview_test;

class FilePreviewTest : public QObject {
  Q_OBJECT

  test::ImageFolder folder_;

  void compare(const std::filesystem::path& path, const PreviewOptions& options) {
    const auto preview = lastPreview(path, options);
    QVERIFY(preview.has_value());
    const WholePicture whole(path, options);
    QCOMPARE(preview->width, whole.width());
    QCOMPARE(preview->height, whole.height());
    QCOMPARE(preview->step, kStep);
    QCOMPARE(preview->columns, whole.width() / kStep);
    QCOMPARE(preview->rows, whole.height() / kStep);
    EXPECT_AT_MOST(worstDifference(*preview, whole), 2.0 / 255);
  }

  void compare(const std::string& name, const std::string& format, const OIIO::ImageSpec& spec) {
    const auto path = folder_.path(name);
    write(path, format, spec);
    compare(path, {{}, {}, kLeastSide});
  }

 private slots:
  void scanLinesOfOpenExr_data() {
    QTest::addColumn<QString>("compression");
    for (const char* name : {"none", "zips", "zip", "piz", "dwaa"})
      QTest::newRow(name) << name;
  }
  void scanLinesOfOpenExr() {
    QFETCH(QString, compression);
    compare("lines.exr", "openexr",
            with(specOf(3, OIIO::TypeHalf), "compression", compression.toStdString()));
  }

  void tilesOfOpenExr() { compare("tiles.exr", "openexr", tiled(specOf(3, OIIO::TypeFloat), 64)); }

  // Colours are divided by alpha, and what lies around the display window is part of the picture.
  void openExrWithAlphaAndOverscan() {
    OIIO::ImageSpec spec = specOf(4, OIIO::TypeHalf);
    spec.x = -40;
    spec.y = 24;
    spec.full_x = 0;
    spec.full_y = 0;
    spec.full_width = kWidth - 40;
    spec.full_height = kHeight + 24;
    compare("around.exr", "openexr", spec);
  }

  void aLayerOfOpenExr() {
    OIIO::ImageSpec spec = specOf(6, OIIO::TypeHalf);
    spec.channelnames = {"R", "G", "B", "skin.R", "skin.G", "skin.B"};
    spec.alpha_channel = -1;
    std::vector<float> samples;
    for (int p = 0; p < kWidth * kHeight; ++p)
      samples.insert(samples.end(), {0.1f, 0.2f, 0.3f, 0.4f, 0.5f, 0.6f});
    const auto path = folder_.path("layers.exr");
    test::writeForeign(path, "openexr", spec, samples);
    compare(path, {{}, "skin", kLeastSide});
    compare(path, {{}, {}, kLeastSide});
    compare(path, {"ACEScg", {}, kLeastSide});
    QVERIFY(!previewImage(path, {{}, "no such layer", kLeastSide}, {}).has_value());
  }

  void theLevelThatIsLargeEnoughIsRead() {
    const auto path = folder_.path("levels.exr");
    writeLevels(path);
    const auto preview = previewImage(path, {{}, {}, kLeastSide}, {});
    QVERIFY(preview.has_value());
    QCOMPARE(preview->width, kWidth);
    QCOMPARE(preview->step, kStep);
    QCOMPARE(preview->columns, kWidth / kStep);
    // The second level after the picture.
    EXPECT_NEAR(preview->colors[0][5000], 0.5625, 1e-3);
  }

  void stripsOfTiff_data() {
    QTest::addColumn<QString>("compression");
    for (const char* name : {"none", "lzw", "zip"})
      QTest::newRow(name) << name;
  }
  void stripsOfTiff() {
    QFETCH(QString, compression);
    compare("strips.tif", "tiff",
            with(specOf(3, OIIO::TypeUInt8), "compression", compression.toStdString()));
  }

  void tilesOfTiff() { compare("tiles.tif", "tiff", tiled(specOf(3, OIIO::TypeUInt16), 64)); }

  void tiffWithAlpha() {
    compare("multiplied.tif", "tiff", specOf(4, OIIO::TypeUInt16));
    OIIO::ImageSpec straight = specOf(4, OIIO::TypeUInt16);
    straight.attribute("oiio:UnassociatedAlpha", 1);
    compare("straight.tif", "tiff", straight);
  }

  void greyTiff() { compare("grey.tif", "tiff", specOf(1, OIIO::TypeUInt8)); }

  void pagesThatSayTheyAreSmaller() {
    const auto path = folder_.path("pages.tif");
    writePages(path, 1);
    const auto preview = previewImage(path, {{}, {}, kLeastSide}, {});
    QVERIFY(preview.has_value());
    QCOMPARE(preview->width, kWidth);
    QCOMPARE(preview->step, kStep);
    EXPECT_NEAR(encoded(preview->colors[0][5000]), 0.75, 2.0 / 255);
    // Another page is another picture.
    writePages(path, 0);
    const auto other = previewImage(path, {{}, {}, kLeastSide}, {});
    QVERIFY(other.has_value());
    EXPECT_NEAR(encoded(other->colors[0][5000]), 0.25, 2.0 / 255);
  }

  void eachWayToLieInAFile() {
    for (int orientation = 1; orientation <= 8; ++orientation)
      compare("turned.tif", "tiff", turned(specOf(3, OIIO::TypeUInt8), orientation));
    for (int orientation : {3, 6}) {
      const auto path = folder_.path("turned.png");
      write(path, "png", specOf(3, OIIO::TypeUInt8));
      test::addPngOrientation(path, orientation);
      compare(path, {{}, {}, kLeastSide});
      compare("turned.jpg", "jpeg",
              turned(with(specOf(3, OIIO::TypeUInt8), "compression", "jpeg:98"), orientation));
    }
  }

  void otherFilesRowByRow() {
    compare("colors.png", "png", specOf(3, OIIO::TypeUInt8));
    compare("deep.png", "png", specOf(4, OIIO::TypeUInt16));
    compare("colors.bmp", "bmp", specOf(3, OIIO::TypeUInt8));
    compare("colors.tga", "targa", specOf(4, OIIO::TypeUInt8));
    compare("colors.hdr", "hdr", specOf(3, OIIO::TypeFloat));
  }

  // The first rows come first, and the rest is not there yet.
  void rowsAreSeenAsTheyAreRead() {
    const auto path = folder_.path("rows.png");
    write(path, "png", specOf(3, OIIO::TypeUInt8));
    std::vector<ImagePreview> seen;
    const PreviewSink sink = {{{}, {}, kLeastSide},
                              [&](ImagePreview preview) { seen.push_back(std::move(preview)); }};
    EXPECT_OK(readImage(path, {.preview = &sink}, std::make_shared<TileStore>(), {}));
    QVERIFY(seen.size() >= 2);
    const auto& first = seen.front().colors[0];
    QVERIFY(!std::isnan(first.front()));
    QVERIFY(std::isnan(first.back()));
    const auto& last = seen.back().colors[0];
    QVERIFY(std::none_of(last.begin(), last.end(), [](float value) { return std::isnan(value); }));
  }

  // Some rows of large files are read, and what lies between them is filled in.
  void aLargeFileIsReadSparsely() {
    const auto path = folder_.path("large.exr");
    write(path, "openexr", with(specOf(3, OIIO::TypeHalf), "compression", "zip"));
    auto reader = ImageReader::open(path, {});
    const auto part = reader.value().part(0).value();
    const auto layers = layersOf(reader.value());
    const std::int64_t bytes = std::int64_t{kWidth} * kHeight * 6;
    const auto rows = chooseRows(part, ImageFileKind::openExr, kStep, bytes / 3);
    QCOMPARE(rows.count, 16);
    QCOMPARE(rows.spacing, 64);
    const auto layout = canvasLayout(part, layers.value().front(), kStep);
    const auto linear = decideColors(readImageHeader(path, {}).value().colors, {}, {});
    PreviewCanvas canvas(*layout, linear.value().followed.space.toLinearRec709);
    EXPECT_OK(readSparsely(path, part, rows, canvas, {}));
    const auto empty = canvas.picture(PreviewCanvas::Gaps::empty, {});
    const std::size_t betweenRows = std::size_t{kWidth / kStep} * 8;
    QVERIFY(std::isnan(empty->colors[0][betweenRows]));
    const auto filled = canvas.picture(PreviewCanvas::Gaps::filled, {});
    EXPECT_AT_MOST(worstDifference(*filled, WholePicture(path, {})), 8.0 / 255);
    // Too few rows are no picture.
    QVERIFY(chooseRows(part, ImageFileKind::openExr, kStep, bytes / 20).empty());
  }

  // The whole reading says what is wrong with them.
  void whatIsCutOffHasNone_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("format");
    QTest::newRow("OpenEXR") << "cut.exr"
                             << "openexr";
    QTest::newRow("TIFF") << "cut.tif"
                          << "tiff";
    QTest::newRow("PNG") << "cut.png"
                         << "png";
  }
  void whatIsCutOffHasNone() {
    QFETCH(QString, name);
    QFETCH(QString, format);
    const auto path = folder_.path(name.toStdString());
    write(path, format.toStdString(), specOf(3, OIIO::TypeUInt8));
    const QByteArray bytes = test::readBytes(path);
    for (const qsizetype length : {bytes.size() / 2, bytes.size() - 200, qsizetype{40}}) {
      test::writeBytes(path, bytes.left(length));
      QVERIFY(!lastPreview(path, {{}, {}, kLeastSide}).has_value());
    }
  }
};

CUTIS_TEST(FilePreviewTest)

}  // namespace
}  // namespace cutis

#include "file_preview_test.moc"
