// The command line itself: help, versions, words nobody knows, words of later versions.

#include "tests/src/cli/program_run.h"
#include "tests/src/cli/refusal.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis::test {
namespace {

constexpr int kUsage = 2;

struct Case {
  const char* commandLine;
  const char* part;  // of the error
};
const std::vector<Case> kCases = {
    {"", "name a command"},
    {"fitt", "unknown command 'fitt'; did you mean 'fit'?"},
    {"fit a.png -o b.exr --expsoure 1", "--expsoure: unknown option; did you mean '--exposure'?"},
    {"render -x", "-x: unknown option"},
    {"fit", "SOURCE is required"},
    {"fit a.png -o", "fit: "},
    {"render a.exr b.exr -o c.png", "render: "},
    {"measure a.exr -o b.csv", "measure: not in this version"},
    {"calibrate-profile skin2026", "SPECTRA is required"},
    {"fit a.png -o b.exr --shading --method full-search",
     "--shading: only the method refined takes this"},
    {"fit a.png -o b.exr --frames 1-240", "--frames: not in this version"},
    {"fit a.png -o b.exr --method net", "--method: unknown method 'net'"},
    {"train --rig albedo", "train: "},
    {"fit a.png b.png -o b.exr", "b.png: several images are not in this version"},
    {"render a.exr -o b.png --scatter", "--scatter: not in this version"},
    {"fit-spectra a.csv -o b.csv --specular both",
     "--specular: 'both' is unknown; choose included, excluded or cross-polarised"},
    {"fit-spectra a.csv -o b.csv --range 400-700", "--range: '400-700' is not a range"},
    {"fit-spectra a.csv -o b.csv --range 700:400", "--range: '700:400' is empty"},
    {"fit-spectra a.csv -o b.csv --range 200:700", "--range: 200 is out of range"},
    {"spectrum --params 0,0,0,0,0 --specular-share 0.04",
     "--specular-share: this goes with --specular included"},
    {"spectrum --params 0,0,0,0,0 --specular included --specular-share 4",
     "--specular-share: 4 is out of range"},
    {"validate a.csv --aperture-radius 0", "--aperture-radius: 0 is out of range"},
    {"validate a.csv --plot b.txt", "the plot is written as SVG or PNG"},
    {"validate", "SPECTRA is required"},
};

class UsageTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    std::vector<QString> commandLines;
    for (const Case& wrong : kCases)
      commandLines.emplace_back(wrong.commandLine);
    outcomes_ = run_.runAll(commandLines);
    QVERIFY(run_.contents().empty());
  }

  void helpAndVersionAreToldEverywhere() {
    const Outcome all = run_.run("--help");
    EXPECT_DONE(all);
    for (const char* command : {"fit", "edit", "render", "apply", "spectrum", "fit-spectra",
                                "simulate", "validate", "bench", "info", "Exit status"}) {
      QVERIFY2(all.output.find(command) != std::string::npos, command);
    }
    const Outcome fit = run_.run("fit --help");
    EXPECT_DONE(fit);
    for (const char* option : {"--method", "--noise", "--fix", "--report", "--threads", "-o"}) {
      QVERIFY2(fit.output.find(option) != std::string::npos, option);
    }
    for (const char* line : {"--version", "render --version"}) {
      const Outcome version = run_.run(line);
      EXPECT_DONE(version);
      QCOMPARE(version.output, std::string("cutis-cli " CUTIS_VERSION "\n"));
    }
  }

  void isRefused_data() {
    QTest::addColumn<int>("number");
    for (std::size_t i = 0; i < kCases.size(); ++i) {
      QTest::newRow(kCases[i].commandLine) << static_cast<int>(i);
    }
  }

  void isRefused() {
    QFETCH(int, number);
    const Case& wanted = kCases[static_cast<std::size_t>(number)];
    const Outcome& outcome = outcomes_[static_cast<std::size_t>(number)];
    EXPECT_REFUSED(outcome, kUsage, wanted.part);
  }

 private:
  ProgramRun run_;
  std::vector<Outcome> outcomes_;
};

CUTIS_TEST(UsageTest)

}  // namespace
}  // namespace cutis::test

#include "usage_test.moc"
