// Weights files: written and read they are the same; what is not one is refused with a sentence.

#include "src/files/networks/network_file.h"

#include <limits>

#include <QtTest>

#include "core/rig/rig.h"
#include "core/skin/profile/profile_signature.h"
#include "src/files/profiles/profile_file.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

// Networks nobody trained, of two components and three channels.
NetworkFile smallNetworks() {
  NetworkFile file;
  file.rig = "mine";
  file.profile = "li2024";
  file.command = "train --rig \"mine\"";
  file.spectraOptions.hidden = {4};
  file.chromophoreOptions.hidden = {3, 3};
  file.chromophoreOptions.noise = {0.0, 0.01};
  file.spectra.profile = file.chromophores.profile = {1.0f, 2.5f};
  file.spectra.axes = file.chromophores.axes = test::li2024().profile().axes;
  file.spectra.mean = Spectrum::Constant(0.25);
  file.spectra.components = Eigen::MatrixXd::Constant(kSampleCount, 2, 0.1f);
  file.spectra.network = randomNetwork({5, 4, 2}, Activation::squareplus, Activation::linear, 1);
  file.chromophores.channels = {0.25f, 0.5f};
  file.chromophores.inputs = {"a", "b", "c"};
  file.chromophores.network = randomNetwork({3, 3, 3, 5}, Activation::relu, Activation::sigmoid, 2);
  return file;
}

// The small networks with a piece of text replaced.
std::string changedNetwork(const std::string& from, const std::string& to) {
  std::string text = networkText(smallNetworks());
  const auto at = text.find(from);
  if (at == std::string::npos) return "test is wrong: " + from;
  return text.replace(at, from.size(), to);
}

class NetworkFileTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void readsWhatItWrote() {
    const NetworkFile file = smallNetworks();
    const std::string path = (folder_ / "weights.json").string();
    EXPECT_OK(writeNetworks(path, file));
    const auto read = readNetworks(path);
    EXPECT_OK(read);
    QVERIFY(networkText(read.value()) == folder_.read("weights.json"));
    QCOMPARE(read.value().rig, file.rig);
    QCOMPARE(read.value().command, file.command);
    QVERIFY(read.value().spectraOptions == file.spectraOptions);
    QVERIFY(read.value().chromophoreOptions.trainer == file.chromophoreOptions.trainer);
    QCOMPARE(read.value().chromophoreOptions.noise.proportional, 0.01);
    QVERIFY(read.value().spectra.network == file.spectra.network);
    QVERIFY(read.value().chromophores.network == file.chromophores.network);
    QVERIFY(read.value().spectra.components == file.spectra.components);
    QVERIFY(read.value().chromophores.channels == file.chromophores.channels);
    QVERIFY(read.value().chromophores.inputs == file.chromophores.inputs);
    QVERIFY(read.value().spectra.profile == file.spectra.profile);
  }

  void extremeFloatsSurvive() {
    NetworkFile file = smallNetworks();
    using Limits = std::numeric_limits<float>;
    file.spectra.network.layers[0].bias = {1e7f, Limits::denorm_min(), -0.0f, 1.0f / 3.0f};
    const auto read = parseNetworks(networkText(file), "weights");
    EXPECT_OK(read);
    QVERIFY(read.value().spectra.network == file.spectra.network);
    QVERIFY(networkText(read.value()) == networkText(file));
  }

  void builtInNetworksAreWhole() {
    const auto names = builtInNetworkNames();
    QVERIFY(!names.empty());
    const Signature profile = signatureOf(test::li2024().profile());
    const Signature channels = signatureOf(networkChannels(test::monitorRig()));
    bool found = false;
    for (const std::string& name : names) {
      const auto file = builtInNetworks(name);
      EXPECT_OK(file);
      found = found || (alike(file.value().chromophores.profile, profile) &&
                        alike(file.value().chromophores.channels, channels));
    }
    QVERIFY(found);
    EXPECT_ERROR(builtInNetworks("nobody's"), "no networks of this name");
  }

  void builtInNetworksHaveNames() {
    const Profile paper = loadProfile("li2024", "").value();
    const auto five = loadNetworks("monitor-5", paper, "--weights");
    EXPECT_OK(five);
    QCOMPARE(five.value().profile, std::string("li2024"));
    QVERIFY(five.value().chromophores.inputs ==
            (std::vector<std::string>{"r", "g", "b", "sb", "sg"}));
    EXPECT_OK(loadNetworks("monitor-5_skin2026", paper, "--weights"));
    EXPECT_ERROR(loadNetworks("monitor5", paper, "--weights"), "did you mean 'monitor-5'");
    Profile mine = paper;
    mine.epidermalThicknessMm *= 1.5;
    EXPECT_ERROR(loadNetworks("monitor-5", mine, "--weights"), "none are built in for it");
    EXPECT_ERROR(loadNetworks("none.json", paper, "--weights"), "none.json");
  }

  // A discrepancy and a prior leave the physics as it is.
  void networksServeProfilesOfOnePhysics() {
    const Profile profile = loadProfile("skin2026b", "").value();
    QVERIFY(profile.name == "skin2026b");
    const auto five = loadNetworks("monitor-5", profile, "--weights");
    EXPECT_OK(five);
    QCOMPARE(five.value().profile, std::string("skin2026"));
    EXPECT_ERROR(loadNetworks("monitor-6", profile, "--weights"), "did you mean 'monitor-5'");
  }

  void whatIsNoWeightsFileIsRefused_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("sentence");
    const std::string whole = networkText(smallNetworks());
    const auto add = [](const char* name, const std::string& text, const char* sentence) {
      QVERIFY2(!text.starts_with("test is wrong"), text.c_str());
      QTest::newRow(name) << QString::fromStdString(text) << QString(sentence);
    };
    add("truncated", whole.substr(0, whole.size() / 2), "weights.json:");
    add("foreign", "{\"cutis_rig\": 1}", "\"cutis_network\": 1 is missing");
    add("a list", "[1, 2]", "one JSON object");
    add("newer", changedNetwork("\"cutis_network\":1", "\"cutis_network\":2"), "a newer version");
    add("unknown field", changedNetwork("\"rig\"", "\"ring\""), "unknown field 'ring'");
    add("no rig", changedNetwork("\"rig\":\"mine\",", ""), "rig must be a text (it is missing)");
    add("no networks", changedNetwork("\"chrom_nn\":{", "\"chrom_nn\":7,\"x\":{"),
        "unknown field 'x'");
    add("wrong type", changedNetwork("\"profile\":[1,", "\"profile\":[true,"),
        "spectra_nn.profile must be a list of 2 finite numbers");
    add("huge layer",
        changedNetwork("\"inputs\":5,\"outputs\":4", "\"inputs\":5,\"outputs\":2000000000"),
        "spectra_nn.layers[0].outputs must be a whole number from 1 to 512");
    add("negative size", changedNetwork("\"inputs\":5", "\"inputs\":-5"), "from 1 to 512");
    add("size of a fraction", changedNetwork("\"inputs\":5", "\"inputs\":5.5"), "inputs must be");
    add("other size", changedNetwork("\"inputs\":5,\"outputs\":4", "\"inputs\":4,\"outputs\":4"),
        "spectra_nn.layers[0].weights must be a list of 16 finite numbers");
    add("a name missing", changedNetwork("[\"a\",\"b\",\"c\"]", "[\"a\",\"b\"]"),
        "as many inputs as it has channels");
    add("a name that is none", changedNetwork("[\"a\",\"b\",", "[\"a\",7,"), "chrom_nn.inputs[1]");
    add("no layers", changedNetwork("\"layers\":[", "\"layers\":[],\"x\":["), "spectra_nn");
    add("not a number", changedNetwork("\"mean\":[0.25", "\"mean\":[NaN"), "not valid JSON");
    add("a text for a number", changedNetwork("\"mean\":[0.25", "\"mean\":[\"0.25\""),
        "spectra_nn.mean must be a list of 351 finite numbers");
    add("null for a number", changedNetwork("\"mean\":[0.25", "\"mean\":[null"), "spectra_nn.mean");
    add("infinite", changedNetwork("\"mean\":[0.25", "\"mean\":[1e999"), "weights.json");
    add("too large", changedNetwork("\"bias\":[", "\"bias\":[1e300,"), "spectra_nn.layers[0].bias");
    add("short mean", changedNetwork("\"mean\":[0.25,", "\"mean\":["), "351 finite numbers");
    add("activation", changedNetwork("\"activation\":\"sigmoid\"", "\"activation\":\"tanh\""),
        "activation must be linear, relu, sigmoid or squareplus");
    add("no sigmoid", changedNetwork("\"activation\":\"sigmoid\"", "\"activation\":\"relu\""),
        "does not end in a sigmoid");
    add("axis", changedNetwork("\"exponent\":3", "\"exponent\":9"), "an axis");
    add("profiles differ", changedNetwork("\"profile\":[1,", "\"profile\":[1.5,"),
        "are of different profiles");
    add("noise", changedNetwork("\"noise\":[0.0", "\"noise\":[-1.0"),
        "noise must be two numbers from 0");
    add("seed", changedNetwork("\"seed\":1", "\"seed\":-1"), "seed must be a whole number from 0");
    add("hidden", changedNetwork("\"hidden\":[4]", "\"hidden\":[4000]"), "hidden[0] must be");
    add("empty options", changedNetwork("\"hidden\":[4]", "\"hidden\":[]"),
        "hidden must be a list");
  }

  void whatIsNoWeightsFileIsRefused() {
    QFETCH(QString, text);
    QFETCH(QString, sentence);
    const auto read = parseNetworks(text.toStdString(), "weights.json");
    EXPECT_ERROR(read, sentence.toStdString());
    QVERIFY(read.error().text().starts_with("weights.json"));
    QVERIFY(read.error().text().find('\n') == std::string::npos);
  }

  void manyLayersAreRefused() {
    std::string layers = "\"layers\":[";
    for (int i = 0; i < 20'000; ++i)
      layers += "{},";
    EXPECT_ERROR(parseNetworks(changedNetwork("\"layers\":[", layers), "weights.json"),
                 "spectra_nn.layers must be a list of 1 to 16 layers");
  }

  void damageAnywhereIsNoCrash() {
    const std::string whole = networkText(smallNetworks());
    for (std::size_t at = 0; at < whole.size(); at += 97) {
      std::string cut = whole.substr(0, at);
      QVERIFY(!parseNetworks(cut, "cut"));
      std::string bent = whole;
      bent[at] = static_cast<char>(bent[at] ^ 0x15);
      const auto read = parseNetworks(bent, "bent");
      QVERIFY(read || read.failed());
    }
  }

 private:
  test::ScratchFolder folder_;
};

CUTIS_TEST(NetworkFileTest)

}  // namespace
}  // namespace cutis

#include "network_file_test.moc"
