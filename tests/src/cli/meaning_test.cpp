// One failure has one meaning: too little memory, what is not supported, what is damaged, and what
// nobody can compute are told apart, in one line each.

#include <algorithm>
#include <sstream>
#include <zlib.h>

#include "tests/src/cli/program_run.h"
#include "tests/support/expect.h"
#include "tests/support/icc_bytes.h"
#include "tests/support/test_registry.h"

namespace cutis::test {
namespace {

constexpr int kInput = 3;
constexpr int kResource = 4;
// The status of the system's own loader, before there is a program.
constexpr int kNotLoaded = 127;

QByteArray bigEndian(quint32 number) {
  QByteArray bytes(4, '\0');
  for (int i = 0; i < 4; ++i)
    bytes[i] = static_cast<char>(number >> (24 - 8 * i));
  return bytes;
}

QByteArray pngChunk(const QByteArray& name, const QByteArray& content) {
  const QByteArray body = name + content;
  const auto crc =
      crc32(0, reinterpret_cast<const Bytef*>(body.constData()), static_cast<uInt>(body.size()));
  return bigEndian(static_cast<quint32>(content.size())) + body +
         bigEndian(static_cast<quint32>(crc));
}

// 8 × 8 pixels of RGB, 8 bits.
QByteArray png8(const QByteArray& chunks, const QByteArray& pixels) {
  const QByteArray head = bigEndian(8) + bigEndian(8) + QByteArray("\x08\x02\0\0\0", 5);
  return QByteArray("\x89PNG\r\n\x1a\n") + pngChunk("IHDR", head) + chunks +
         pngChunk("IDAT", pixels) + pngChunk("IEND", {});
}

// Every checksum of the file is right, and its pixels are no stream of zlib.
QByteArray pngWithBadPixels() {
  return png8({}, QByteArray("\x78\x9c", 2) + QByteArray(40, '\xff'));
}

QByteArray zipped(const QByteArray& bytes) {
  // Qt puts the length in front.
  return qCompress(bytes).mid(4);
}

// A picture of skin's colour with a profile that says that its colours meet under D65, which libpng
// warns of.
QByteArray pngWithOddProfile() {
  std::string profile = matrixProfile(2, kRec709.chromaticities, curveTag({563}), "a monitor");
  std::string white;
  for (const double value : {0.9505, 1.0, 1.0891})
    putFixed(white, value);
  profile.replace(68, white.size(), white);
  QByteArray rows;
  for (int y = 0; y < 8; ++y)
    rows += QByteArray(1, '\0') + QByteArray("\xc8\x96\x78").repeated(8);
  return png8(pngChunk("iCCP", QByteArray("x\0\0", 3) + zipped(QByteArray::fromStdString(profile))),
              zipped(rows));
}

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
    lines.push_back(line);
  return lines;
}

class MeaningTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() {
    EXPECT_DONE(run_.run("simulate --patch 64x64 --noise 0.005 -o cap"));
    run_.writeImage("skin.png", skinTexture(64, 64, {"R", "G", "B"}), SampleType::uint8);
    EXPECT_DONE(run_.run("fit cap -o maps.exr --quiet"));
  }

  void librariesDoNotSpeak() {
    run_.write("bad.png", pngWithBadPixels().toStdString());
    run_.writeImage("small.png", skinTexture(8, 8, {"R", "G", "B"}), SampleType::uint8);
    for (const char* line : {"fit bad.png -o o.exr", "apply bad.png -o o.png",
                             "fit small.png --mask bad.png -o o.exr"}) {
      const Outcome outcome = run_.run(line);
      QVERIFY2(isOneError(outcome.errors), outcome.errors.c_str());
      QVERIFY2(outcome.errors.find("damaged") != std::string::npos, outcome.errors.c_str());
      QCOMPARE(outcome.status, kInput);
    }
  }

  void librariesDoNotWarn() {
    run_.write("odd.png", pngWithOddProfile().toStdString());
    for (const char* line :
         {"info odd.png", "fit odd.png -o odd.exr", "apply odd.png -o odd_again.png --melanin 2",
          "apply odd.png -o odd.tif", "info odd_again.png", "apply odd.tif -o odd_third.png",
          "fit odd.png --mask odd.png -o odd_mask.exr"}) {
      const Outcome outcome = run_.run(line);
      QCOMPARE(outcome.status, 0);
      for (const std::string& sentence : linesOf(outcome.errors))
        QVERIFY2(sentence.empty() || sentence.starts_with("cutis-cli: note: "), sentence.c_str());
    }
  }

  void whatIsEchoedIsShort() {
    const QString endless(20000, 'x');
    for (const QString& line :
         {"fit skin.png -o o.exr --colorspace " + endless, "fit skin.png -o o.exr --rig " + endless,
          "spectrum --params " + endless, "fit skin.png -o o.exr --exposure " + endless,
          "spectrum --params 0,0,0,0,0 --profile " + endless, "--" + endless, endless,
          "info --" + endless, "info a b" + endless,
          "fit skin.png -o o.exr --fix " + endless + "=1",
          "render maps.exr -o o.png --light " + endless}) {
      const Outcome outcome = run_.run(line);
      QVERIFY2(isOneError(outcome.errors), outcome.errors.c_str());
      QVERIFY2(outcome.errors.size() < 1200, qPrintable(line.left(60)));
    }
  }

  void linesInNamesBreakNoOutput() {
    const std::string name = "two\nlines.png";
    run_.writeImage(name, skinTexture(16, 16, {"R", "G", "B"}), SampleType::uint8);
    QProcess program;
    program.setWorkingDirectory(QString::fromStdString((run_ / "").string()));
    program.start(CUTIS_CLI, {"fit", QString::fromStdString(name), "-o", "named.exr", "--quiet"});
    QVERIFY(program.waitForFinished(60000));
    QCOMPARE(program.exitCode(), 0);
    const Outcome info = run_.run("info named.exr");
    QCOMPARE(info.status, 0);
    QVERIFY2(info.output.find("two lines.png") != std::string::npos, info.output.c_str());
  }

  // Less and less memory: a command is done, or says in one line that memory is missing.
  void littleMemoryIsSaid_data() {
    QTest::addColumn<QString>("command");
    for (const char* command :
         {"--version", "spectrum --params 0.02,0.5,0.02,0.01,0.001", "info maps.exr",
          "fit cap -o o.exr --quiet", "fit skin.png -o o.exr --quiet",
          "apply skin.png --maps maps.exr -o o.png --quiet", "render maps.exr -o o.png --quiet",
          "simulate --patch 64x64 -o other --quiet"}) {
      QTest::newRow(command) << QString(command);
    }
  }
  void littleMemoryIsSaid() {
    QFETCH(QString, command);
    const auto before = run_.contents();
    for (int mebibytes = 60; mebibytes < 2400; mebibytes += mebibytes / 5) {
      QProcess shell;
      shell.setWorkingDirectory(QString::fromStdString((run_ / "").string()));
      shell.start("bash", {"-c", QString("ulimit -c 0; ulimit -v %1; exec %2 %3")
                                     .arg(mebibytes * 1024)
                                     .arg(CUTIS_CLI, command)});
      QVERIFY(shell.waitForFinished(120000));
      const std::string errors = shell.readAllStandardError().toStdString();
      const QString where = QString("%1 MiB: status %2: ").arg(mebibytes).arg(shell.exitCode()) +
                            QString::fromStdString(errors);
      QVERIFY2(shell.exitStatus() == QProcess::NormalExit, qPrintable(where));
      if (shell.exitCode() == kNotLoaded) continue;
      if (shell.exitCode() == 0) {
        for (const char* made : {"o.exr", "o.png", "other"})
          std::filesystem::remove_all(run_ / made);
        continue;
      }
      QVERIFY2(shell.exitCode() == kResource && isOneError(errors), qPrintable(where));
      QVERIFY(run_.contents() == before);
    }
  }

 private:
  ProgramRun run_;
};

CUTIS_TEST(MeaningTest)

}  // namespace
}  // namespace cutis::test

#include "meaning_test.moc"
