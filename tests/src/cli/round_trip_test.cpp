// Files of every kind through a neutral apply, compared by OpenImageIO alone: format × samples ×
// alpha × orientation × declared colours. The table is printed.

#include <cmath>
#include <cstdio>
#include <vector>

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include "tests/src/cli/program_run.h"
#include "tests/src/images/foreign_file.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis::test {
namespace {

constexpr int kWidth = 9;
constexpr int kHeight = 6;

struct Row {
  std::string extension;  // "png"
  std::string library;    // of OpenImageIO
  OIIO::TypeDesc type;
  std::string samples;  // "8", "16", "half", "float"
  std::string alpha;    // "none", "straight", "associated"
  int orientation = 1;
  std::string colors;  // what the file declares

  std::string name() const {
    return extension + "_" + samples + "_" + alpha + "_" + std::to_string(orientation) + "_" +
           colors;
  }
  std::string file() const { return name() + "." + extension; }
  std::string again() const { return "same_" + file(); }
};

struct Samples {
  std::string extension;
  std::string library;
  OIIO::TypeDesc type;
  std::string samples;
  std::vector<std::string> alphas;
  std::vector<int> orientations;
  std::vector<std::string> colors;
};

std::vector<Row> rows() {
  const std::vector<std::string> straight = {"none", "straight"};
  const std::vector<std::string> both = {"none", "straight", "associated"};
  const std::vector<std::string> associated = {"none", "associated"};
  const std::vector<int> some = {1, 3, 6};
  std::vector<Row> rows;
  for (const Samples& kind : {
           Samples{"png", "png", OIIO::TypeUInt8, "8", straight, some, {"nothing", "sRGB"}},
           Samples{"png", "png", OIIO::TypeUInt16, "16", straight, some, {"nothing", "sRGB"}},
           Samples{"tif", "tiff", OIIO::TypeUInt8, "8", both, some, {"nothing", "sRGB"}},
           Samples{"tif", "tiff", OIIO::TypeUInt16, "16", both, some, {"nothing", "sRGB"}},
           Samples{"tif", "tiff", OIIO::TypeFloat, "float", both, some, {"nothing"}},
           Samples{"jpg", "jpeg", OIIO::TypeUInt8, "8", {"none"}, some, {"nothing"}},
           Samples{
               "exr", "openexr", OIIO::TypeHalf, "half", associated, {1}, {"nothing", "ACEScg"}},
           Samples{
               "exr", "openexr", OIIO::TypeFloat, "float", associated, {1}, {"nothing", "ACEScg"}},
       }) {
    for (const std::string& alpha : kind.alphas) {
      for (const int orientation : kind.orientations) {
        for (const std::string& colors : kind.colors) {
          rows.push_back(
              {kind.extension, kind.library, kind.type, kind.samples, alpha, orientation, colors});
        }
      }
    }
  }
  return rows;
}

// Skin colours with noise; alpha runs from 0, with a colour behind it, to 1.
std::vector<float> samplesOf(const Row& row) {
  const std::vector<float> random = noise(3 * kWidth * kHeight, 5);
  std::vector<float> samples;
  for (std::size_t p = 0; p < kWidth * kHeight; ++p) {
    const float alpha = static_cast<float>(p % kWidth) / static_cast<float>(kWidth - 1);
    const bool multiplied = row.alpha == "associated" && alpha > 0.0f;
    for (std::size_t c = 0; c < 3; ++c) {
      const float color = 0.7f - 0.2f * static_cast<float>(c) + 0.05f * random[3 * p + c];
      samples.push_back(multiplied ? color * alpha : color);
    }
    if (row.alpha != "none") samples.push_back(alpha);
  }
  return samples;
}

void writeRow(const ProgramRun& run, const Row& row) {
  OIIO::ImageSpec spec(kWidth, kHeight, row.alpha == "none" ? 3 : 4, row.type);
  if (row.alpha == "straight") spec.attribute("oiio:UnassociatedAlpha", 1);
  if (row.extension != "exr") spec.attribute("Orientation", row.orientation);
  if (row.colors == "sRGB") {
    spec.attribute("oiio:ColorSpace", "sRGB");
    if (row.extension == "tif") spec.attribute("Exif:ColorSpace", 1);
  }
  if (row.colors == "ACEScg") {
    const float primaries[8] = {0.713f, 0.293f, 0.165f, 0.83f, 0.128f, 0.044f, 0.32168f, 0.33767f};
    spec.attribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8), primaries);
  }
  writeForeign(run / row.file(), row.library, spec, samplesOf(row));
  if (row.extension == "png" && row.orientation != 1) {
    addPngOrientation(run / row.file(), row.orientation);
  }
}

OIIO::ImageBuf bufferOf(const std::filesystem::path& path) {
  OIIO::ImageSpec asStored;
  asStored.attribute("oiio:UnassociatedAlpha", 1);
  OIIO::ImageBuf buffer(path.string(), 0, 0, nullptr, &asStored);
  buffer.read(0, 0, true);
  return buffer;
}

std::vector<float> pixelsOf(const OIIO::ImageBuf& buffer) {
  std::vector<float> pixels(static_cast<std::size_t>(buffer.spec().width) *
                            static_cast<std::size_t>(buffer.spec().height) *
                            static_cast<std::size_t>(buffer.spec().nchannels));
  buffer.get_pixels(buffer.roi(), OIIO::TypeFloat, pixels.data());
  return pixels;
}

// What came back another way; empty if nothing did.
std::string differences(const ProgramRun& run, const Row& row) {
  const OIIO::ImageBuf source = OIIO::ImageBufAlgo::reorient(bufferOf(run / row.file()));
  const OIIO::ImageBuf written = bufferOf(run / row.again());
  const OIIO::ImageSpec &a = source.spec(), &b = written.spec();
  std::string found;
  const auto differs = [&](const char* what) {
    found += (found.empty() ? "" : ", ") + std::string(what);
  };
  if (a.width != b.width || a.height != b.height) return "size";
  if (a.channelnames != b.channelnames) return "channels";
  if (a.format != b.format) differs("samples' type");
  if (b.get_int_attribute("Orientation", 1) != 1) differs("orientation");
  const char* alpha = "oiio:UnassociatedAlpha";
  const OIIO::ImageSpec raw = bufferOf(run / row.file()).spec();
  if (raw.get_int_attribute(alpha) != b.get_int_attribute(alpha)) differs("kind of alpha");
  if (run.image(row.file()).colors.stated() != run.image(row.again()).colors.stated() &&
      row.colors != "nothing") {
    differs("colours declared");
  }
  const std::vector<float> before = pixelsOf(source), after = pixelsOf(written);
  const float tolerance = row.extension == "jpg" ? 0.06f : 0.0f;
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (std::abs(before[i] - after[i]) > tolerance) {
      differs("samples");
      break;
    }
  }
  return found;
}

class RoundTripTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void everyKindComesBack() {
    const std::vector<Row> all = rows();
    const ProgramRun run;
    std::vector<QString> commands;
    for (const Row& row : all) {
      writeRow(run, row);
      commands.push_back(
          QString::fromStdString("apply " + row.file() + " -o " + row.again() + " --quiet"));
    }
    const std::vector<Outcome> outcomes = run.runAll(commands);
    std::printf("%-8s%-9s%-12s%-13s%-10s%s\n", "format", "samples", "alpha", "orientation",
                "colours", "came back");
    int failures = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Row& row = all[i];
      const bool done = outcomes[i].status == 0;
      const std::string found = done ? differences(run, row) : outcomes[i].errors;
      std::printf("%-8s%-9s%-12s%-13d%-10s%s\n", row.extension.c_str(), row.samples.c_str(),
                  row.alpha.c_str(), row.orientation, row.colors.c_str(),
                  found.empty() ? (row.extension == "jpg" ? "close" : "the same") : found.c_str());
      failures += found.empty() ? 0 : 1;
    }
    std::fflush(stdout);
    QCOMPARE(failures, 0);
  }
};

CUTIS_TEST(RoundTripTest)

}  // namespace
}  // namespace cutis::test

#include "round_trip_test.moc"
