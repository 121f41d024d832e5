// Whatever is wrong: one line that says so, the right exit status, and no file more than before.

#include <cmath>
#include <filesystem>
#include <limits>

#include <nlohmann/json.hpp>

#include "tests/src/cli/program_run.h"
#include "tests/src/cli/refusal.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis::test {
namespace {

namespace fs = std::filesystem;

constexpr int kUsageStatus = 2;
constexpr int kInput = 3;
constexpr int kResource = 4;

struct BadInput {
  const char* commandLine;
  int status;
  const char* part;  // of the error
};
const std::vector<BadInput> kBadInputs = {
    {"fit missing.png -o x.exr", kInput, "missing.png: "},
    {"fit empty.png -o x.exr", kInput, "empty.png: "},
    {"fit text.png -o x.exr", kInput, "text.png: "},
    {"fit cut.png -o x.exr", kInput, "cut.png: "},
    {"render cut.exr -o x.png", kInput, "cut.exr: "},
    {"render skin.png -o x.png", kInput, "skin.png: this is not a Cutis maps file"},
    {"edit missing.exr -o x.exr", kInput, "missing.exr: "},
    {"info empty.png", kInput, "empty.png: "},
    {"fit sizes -o x.exr", kInput, "all photographs must have the same size"},
    {"fit syntax -o x.exr", kInput, "syntax/capture.json:2:"},
    {"fit outside -o x.exr", kInput, "in or below the folder of the capture"},
    {"fit lamp -o x.exr", kInput, "lamp/capture.json: images[0].light"},
    {"fit gone -o x.exr", kInput, "gone/white.exr: "},
    {"fit cap --lights red -o x.exr", kInput, "--lights: "},
    {"fit cap --rig monitr -o x.exr", kInput, "did you mean 'monitor'?"},
    {"fit cap --rig ./rig.json -o x.exr", kInput, "rig.json:3:"},
    {"fit cap --profile li2042 -o x.exr", kInput, "did you mean 'li2024'?"},
    {"fit skin.png --colorspace sRGBB -o x.exr", kInput, "did you mean 'sRGB'?"},
    {"fit skin.png --prior prior.json -o x.exr", kInput, "prior.json:2:"},
    {"fit skin.png --mask small.png -o x.exr", kInput, "small.png: "},
    {"edit maps.exr --melanin 2 --mask small.png -o x.exr", kInput, "small.png: "},
    {"apply small.png --maps maps.exr -o x.png", kInput, "maps.exr: the maps are 32 × 24"},
    {"render maps.exr --light D56 -o x.png", kInput, "--light: unknown light 'D56'"},
    {"render maps.exr --observer cie1932 -o x.png", kInput, "did you mean 'cie1931'?"},
    {"render maps.exr --colorspace nowhere -o x.png", kInput, "--colorspace: unknown"},
    {"spectrum --params 0.6,0,0,0,0", kInput, "--params: melanin is 0.6"},
    {"simulate --patch 8x8 --recipe nothing -o x", kInput, "--recipe: unknown recipe"},
    {"fit cap -o nowhere/x.exr", kResource, "'nowhere' does not exist"},
    {"render maps.exr -o nowhere/x.png", kResource, "'nowhere' does not exist"},
    {"fit cap -o x.exr --report sizes", kResource, "this is a folder"},
    {"simulate --patch 8x8 -o skin.png", kResource, "there is a file of this name"},
    {"spectrum --params 0,0,0,0,0 -o nowhere/x.csv", kResource, "'nowhere' does not exist"},
    {"edit maps.exr -o maps.exr", kUsageStatus, "sources are never written to"},
    {"edit maps.exr -o link.exr", kUsageStatus, "sources are never written to"},
    {"apply skin.png -o ./cap/../skin.png", kUsageStatus, "sources are never written to"},
    {"fit cap -o cap/white.exr", kUsageStatus, "sources are never written to"},
    {"fit cap -o x.exr --report x.exr", kUsageStatus, "two results cannot be one file"},
    {"fit cap -o x.png", kUsageStatus, "name the file with .exr"},
    {"render maps.exr -o x.bmp", kUsageStatus, ".exr, .tif, .png or .jpg"},
    {"render maps.exr -o x.png --bit-depth half", kUsageStatus, "does not hold samples"},
    {"render maps.exr -o x.png --band 500", kUsageStatus, "--band: '500' is not a band"},
    {"fit cap -o x.exr --threads 0", kUsageStatus, "--threads: "},
    {"fit skin.png -o x.exr --exposure -1", kUsageStatus, "--exposure: -1 is out of range"},
    {"fit cap -o x.exr --exposure auto", kUsageStatus, "--exposure: "},
    {"fit cap -o x.exr --noise 0.1", kUsageStatus, "--noise: '0.1' must be 2 numbers"},
    {"fit cap -o x.exr --fix melanin=2", kUsageStatus, "--fix: melanin=2 is out of range"},
    {"fit cap -o x.exr --fix melanine=0", kUsageStatus, "did you mean 'melanin'?"},
    {"edit maps.exr -o x.exr --melanin nan", kUsageStatus, "--melanin: 'nan' is not a number"},
    {"edit maps.exr -o x.exr --melanin 2 --set melanin=0", kUsageStatus, "--set: melanin"},
    {"simulate --patch 0x8 -o x", kUsageStatus, "--patch: "},
    {"simulate -o x", kUsageStatus, "name maps or give --patch"},
};

class BadInputTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    EXPECT_DONE(run_.run("simulate --patch 32x24 -o cap"));
    fs::copy_file(run_ / "cap/maps.exr", run_ / "maps.exr");
    run_.writeImage("skin.png", skinTexture(32, 24, {"R", "G", "B"}), SampleType::uint8);
    run_.writeImage("small.png", skinTexture(20, 24, {"R", "G", "B"}), SampleType::uint8);
    run_.write("empty.png", "");
    run_.write("text.png", "this is no picture at all\n");
    run_.write("cut.png", run_.read("skin.png").substr(0, 400));
    run_.write("cut.exr", run_.read("maps.exr").substr(0, run_.read("maps.exr").size() / 2));
    run_.write("prior.json", "{ \"scale\": \"log\",\n  \"mean\": }\n");
    run_.write("rig.json", "{\n  \"cutis_rig\": 1\n  \"name\": \"x\"\n}\n");
    fs::create_symlink("maps.exr", run_ / "link.exr");
    writeCaptures();

    const auto before = run_.contents();
    std::vector<QString> commandLines;
    for (const BadInput& wrong : kBadInputs)
      commandLines.emplace_back(wrong.commandLine);
    outcomes_ = run_.runAll(commandLines);
    QVERIFY(run_.contents() == before);
  }

  void isRefused_data() {
    QTest::addColumn<int>("number");
    for (std::size_t i = 0; i < kBadInputs.size(); ++i) {
      QTest::newRow(kBadInputs[i].commandLine) << static_cast<int>(i);
    }
  }

  void isRefused() {
    QFETCH(int, number);
    const BadInput& wanted = kBadInputs[static_cast<std::size_t>(number)];
    const Outcome& outcome = outcomes_[static_cast<std::size_t>(number)];
    EXPECT_REFUSED(outcome, wanted.status, wanted.part);
  }

  void spoiledPixelsAreCountedAndLeftOut() {
    ImageContent spoiled = skinTexture(32, 24, {"R", "G", "B"});
    std::vector<float> green = valuesOf(spoiled.channels[1]);
    green[0] = std::numeric_limits<float>::quiet_NaN();
    green[1] = std::numeric_limits<float>::infinity();
    green[2] = -5.0f;
    spoiled.channels[1] = planeOf(32, 24, green);
    run_.writeImage("spoiled.exr", spoiled, SampleType::float32);
    EXPECT_DONE(run_.run("fit spoiled.exr -o spoiled_maps.exr --report spoiled.json --exposure 1"));
    const auto report = nlohmann::json::parse(run_.read("spoiled.json"));
    QCOMPARE(report["pixels"]["invalid"].get<int>(), 3);
    EXPECT_DONE(run_.run("apply spoiled.exr --maps spoiled_maps.exr -o kept.exr --melanin 3"));
    const std::vector<float> kept = valuesOf(run_.image("kept.exr").channels[1]);
    QVERIFY(std::isnan(kept[0]) && std::isinf(kept[1]) && kept[2] == -5.0f && kept[3] < green[3]);
  }

  void damagedTableIsBuiltAgain() {
    EXPECT_DONE(run_.run("fit skin.png -o table.exr --method full-search"));
    const fs::path cache = run_ / "cache" / "cutis";
    int tables = 0;
    for (const auto& entry : fs::directory_iterator(cache)) {
      fs::resize_file(entry.path(), fs::file_size(entry.path()) - 100);
      ++tables;
    }
    // The layers of the default profile, and the skin that is searched.
    QCOMPARE(tables, 2);
    const Outcome again = run_.run("fit skin.png -o table2.exr --method full-search");
    QCOMPARE(again.status, 0);
    QVERIFY2(again.errors.starts_with("cutis-cli: note: the cached table "), again.errors.c_str());
    EXPECT_DONE(run_.run("fit skin.png -o table3.exr --method full-search"));
    const MapsFile first = run_.maps("table.exr"), second = run_.maps("table2.exr");
    for (const Parameter parameter : kParameters) {
      QVERIFY(valuesOf(first.maps.values[parameter]) == valuesOf(second.maps.values[parameter]));
    }
  }

 private:
  void writeCaptures() {
    const auto capture = [](const std::string& light, const std::string& file) {
      return "{ \"cutis_capture\": 1, \"rig\": \"monitor\", \"encoding\": \"linear\",\n"
             "  \"images\": [ {\"light\": \"" +
             light + "\", \"file\": \"" + file + "\"} ] }\n";
    };
    run_.write("syntax/capture.json", "{ \"cutis_capture\": 1,\n  \"rig\" \"monitor\" }\n");
    run_.write("outside/capture.json", capture("white", "../skin.png"));
    run_.write("lamp/capture.json", capture("lamp", "white.exr"));
    run_.write("gone/capture.json", capture("white", "white.exr"));
    fs::copy(run_ / "cap", run_ / "sizes");
    run_.writeImage("sizes/white_blue.exr", skinTexture(20, 24, {"R", "G", "B"}), SampleType::half);
  }

  ProgramRun run_;
  std::vector<Outcome> outcomes_;
};

CUTIS_TEST(BadInputTest)

}  // namespace
}  // namespace cutis::test

#include "bad_input_test.moc"
