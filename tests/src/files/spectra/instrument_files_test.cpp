// One file of each instrument's program, in the layout that it writes.

#include <QtTest>

#include "core/base/number_text.h"
#include "src/files/spectra/measured_spectra_file.h"
#include "src/files/spectra/spectral_csv.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

// A reflectance with four decimals, another at each wavelength.
double reflectanceAt(double wavelengthNm, int spectrum = 0) {
  return 0.2 + (wavelengthNm - 380.0) / 1000.0 + 0.05 * spectrum;
}

std::string fixed(double value, int decimals, char mark = '.') {
  std::string text = fixedNumber(value, decimals);
  std::replace(text.begin(), text.end(), '.', mark);
  return text;
}

// line(wavelength) for every wavelength.
template <typename Line>
std::string lines(double from, double to, double step, const Line& line) {
  std::string text;
  for (double wavelength = from; wavelength <= to; wavelength += step)
    text += line(wavelength);
  return text;
}

std::string oceanOptics(const char* head, const char* begin, const char* end, char mark) {
  return head + std::string(begin) + "\r\n" +
         lines(350.0, 800.0, 2.5,
               [&](double w) {
                 return fixed(w, 3, mark) + "\t" +
                        // The lamp is dark at the ends.
                        (w < 380.0 ? "-1" : fixed(100.0 * reflectanceAt(w), 4, mark)) + "\r\n";
               }) +
         end;
}

std::string spectraSuite() {
  return oceanOptics(
      "SpectraSuite Data File\r\n++++++++++++++++++++++++++++++++++++\r\n"
      "Date: Mon Mar 12 14:22:33 CET 2012\r\nUser: lab\r\nDark Spectrum Present: Yes\r\n"
      "Reference Spectrum Present: Yes\r\nNumber of Sampled Component Spectra: 1\r\n"
      "Spectrometers: USB2+F01234\r\nIntegration Time (usec): 100000 (USB2+F01234)\r\n"
      "Spectra Averaged: 10 (USB2+F01234)\r\nBoxcar Smoothing: 5 (USB2+F01234)\r\n"
      "Number of Pixels in Processed Spectrum: 181\r\n",
      ">>>>>Begin Processed Spectral Data<<<<<", ">>>>>End Processed Spectral Data<<<<<\r\n", '.');
}

std::string oceanView() {
  return oceanOptics(
      "Data from cheek_Reflection__0__10-20-30-405.txt Node\r\n\r\n"
      "Date: Tue Jun 13 10:20:30 CEST 2023\r\nUser: lab\r\nSpectrometer: FLMS01234\r\n"
      "Trigger mode: 0\r\nIntegration Time (sec): 1,000000E-1\r\n"
      "Scans to average: 10\r\nNonlinearity correction enabled: true\r\n"
      "Boxcar width: 5\r\nXAxis mode: Wavelengths\r\n"
      "Number of Pixels in Spectrum: 181\r\n",
      ">>>>>Begin Spectral Data<<<<<", "", ',');
}

// Spectra over time: a row each.
std::string oceanViewTable() {
  std::string text =
      "Data from cheek Node\nDate: Tue Jun 13 10:20:30 CEST 2023\n"
      "XAxis mode: Wavelengths\n>>>>>Begin Spectral Data<<<<<\n\t";
  text += lines(380.0, 730.0, 10.0, [](double w) { return "\t" + fixed(w, 3); });
  text += "\n2023-06-13 10:20:30.405\t1686644430405";
  text +=
      lines(380.0, 730.0, 10.0, [](double w) { return "\t" + fixed(100.0 * reflectanceAt(w), 4); });
  return text + "\n";
}

std::string avaSoft() {
  return "\r\nIntegration time [ms]:  15,000\r\nAveraging Nr. [scans]: 10\r\n"
         "Smoothing Nr. [pixels]: 2\r\nData measured with spectrometer [name]: 1204091U1\r\n"
         "Wave   ;Sample   ;Dark     ;Reference;Reflectance\r\n"
         "[nm]   ;[counts] ;[counts] ;[counts] ;[%]\r\n\r\n" +
         lines(350.0, 800.0, 5.0, [](double w) {
           return " " + fixed(w, 2, ',') + ";  1234,500;   123,250;  4567,000;  " +
                  (w < 380.0 ? "-INF" : fixed(100.0 * reflectanceAt(w), 4, ',')) + "\r\n";
         });
}

std::string spectraMagic() {
  std::string text =
      "\"SpectraMagic NX\"\n\"Instrument\"\t\"CM-700d\"\n\n"
      "Data Name\tDate\tGroup\tL*(D65)\ta*(D65)\tb*(D65)";
  text += lines(400.0, 700.0, 10.0, [](double w) { return "\t" + fixed(w, 0) + "[nm]"; });
  text += "\tComment\n";
  for (int i = 0; i < 2; ++i) {
    text += "cheek " + std::to_string(i) + "\t2024/05/0" + std::to_string(i + 1) +
            "\tSCE\t65.1\t10.2\t15.3";
    text += lines(400.0, 700.0, 10.0,
                  [&](double w) { return "\t" + fixed(100.0 * reflectanceAt(w, i), 2); });
    text += "\t\n";
  }
  return text;
}

std::string cs10w() {
  return "CS-S10w,Ver.1.5\nData Name,cheek 0,cheek 1\nDate,2024/05/01,2024/05/02\n"
         "Observer,2,2\nLv,102.5,99.1\n" +
         lines(380.0, 780.0, 5.0, [](double w) {
           return fixed(w, 0) + "nm," + fixed(reflectanceAt(w), 4) + "," +
                  fixed(reflectanceAt(w, 1), 4) + "\n";
         });
}

std::string sekonic() {
  const auto section = [](double step) {
    return lines(380.0, 780.0, step, [](double w) {
      return "Spectral Data " + fixed(w, 0) + "[nm]," + fixed(reflectanceAt(w), 5) + "\n";
    });
  };
  return "\xEF\xBB\xBF"
         "Date Saved,2024/05/01 12:00:00\nTitle,cheek 0\nMeasuring Mode,Ambient\n"
         "Viewing Angle [\xC2\xB0],2\nTcp [K],5500\nIlluminance [lx],1020\nCRI Ra,97.1\n"
         "Peak Wavelength [nm],560\n" +
         section(5.0) + section(1.0) + "TM-30 Rf,95\nTM-30 Rg,101\n";
}

std::string upRtek() {
  return "Model Name\tMK350N Premium\nSerial Number\tMKP01234\nTime\t2024/05/01_12:00:00\n"
         "CCT\t5500\nLUX\t1020.5\nLambdaP\t560\n" +
         lines(380.0, 780.0, 1.0,
               [](double w) { return fixed(w, 0) + "nm\t" + fixed(reflectanceAt(w), 6) + "\n"; });
}

std::string cgats(const char* label, double scale) {
  std::string text =
      "CGATS.17\nORIGINATOR \"a \"\"program\"\"\"\nINSTRUMENTATION \"i1Pro 2\"\n"
      "MEASUREMENT_SOURCE \"Illumination=D50\"\nNUMBER_OF_FIELDS 37\n"
      "BEGIN_DATA_FORMAT\nSAMPLE_ID SAMPLE_NAME LAB_L";
  text +=
      lines(380.0, 730.0, 10.0, [&](double w) { return " " + std::string(label) + fixed(w, 0); });
  text += "\nEND_DATA_FORMAT\n\nNUMBER_OF_SETS 2\nBEGIN_DATA\n";
  for (int i = 0; i < 2; ++i) {
    text += std::to_string(i + 1) + "\t\"cheek " + std::to_string(i) + "\"\t65.2";
    text += lines(380.0, 730.0, 10.0,
                  [&](double w) { return "\t" + fixed(scale * reflectanceAt(w, i), 4); });
    text += "\n";
  }
  return text + "END_DATA\n";
}

class InstrumentFilesTest : public QObject {
  Q_OBJECT

 private slots:
  void readsWhatInstrumentsWrite_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QStringList>("ids");
    QTest::addColumn<QString>("note");
    const auto row = [](const char* name, const std::string& text, const QStringList& ids,
                        const char* note) {
      QTest::newRow(name) << QByteArray::fromStdString(text) << ids << note;
    };
    row("SpectraSuite", spectraSuite(), {"1"}, "percent");
    row("OceanView", oceanView(), {"1"}, "percent");
    row("OceanView, a table", oceanViewTable(), {"2023-06-13 10:20:30.405"}, "percent");
    row("AvaSoft", avaSoft(), {"Reflectance"}, "percent");
    row("SpectraMagic NX", spectraMagic(), {"cheek 0", "cheek 1"}, "percent");
    row("CS-S10w", cs10w(), {"cheek 0", "cheek 1"}, "");
    row("Sekonic", sekonic(), {"cheek 0"}, "of 2 sections of wavelengths the one with the most");
    row("UPRtek", upRtek(), {"1"}, "");
    row("CGATS", cgats("SPECTRAL_NM", 1.0), {"cheek 0", "cheek 1"}, "");
    row("CGATS, nm", cgats("nm", 1.0), {"cheek 0", "cheek 1"}, "");
    row("CGATS, NM_", cgats("NM_", 1.0), {"cheek 0", "cheek 1"}, "");
    row("CGATS, SPECTRAL_", cgats("SPECTRAL_", 1.0), {"cheek 0", "cheek 1"}, "");
    row("CGATS, Argyll", cgats("SPEC_", 100.0), {"cheek 0", "cheek 1"}, "percent");
  }
  void readsWhatInstrumentsWrite() {
    QFETCH(QByteArray, text);
    QFETCH(QStringList, ids);
    QFETCH(QString, note);
    std::string said;
    JobContext context;
    context.notice = [&](const std::string& sentence) { said += sentence + "\n"; };
    const auto read = parseMeasuredSpectra(text.toStdString(), "i.txt", {400.0, 700.0}, 5, context);
    EXPECT_OK(read);
    const MeasuredSpectra& spectra = read.value();
    QCOMPARE(spectra.ids.size(), static_cast<std::size_t>(ids.size()));
    QCOMPARE(spectra.wavelengthsNm.front(), 400.0);
    QCOMPARE(spectra.wavelengthsNm.back(), 700.0);
    QVERIFY(spectra.wavelengthsNm.size() >= 31);
    for (std::size_t s = 0; s < spectra.ids.size(); ++s) {
      QCOMPARE(QString::fromStdString(spectra.ids[s]), ids[static_cast<int>(s)]);
      for (std::size_t w = 0; w < spectra.wavelengthsNm.size(); ++w) {
        EXPECT_NEAR(spectrumAt(spectra, s)[w],
                    reflectanceAt(spectra.wavelengthsNm[w], static_cast<int>(s)), 1e-4);
      }
    }
    QVERIFY2(said.find(note.toStdString()) != std::string::npos, said.c_str());
    QCOMPARE(said.empty(), note.isEmpty());
  }

  void lightsOfInstrumentsAreCurves_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("Sekonic") << QByteArray::fromStdString(sekonic());
    QTest::newRow("UPRtek") << QByteArray::fromStdString(upRtek());
    QTest::newRow("CS-S10w") << QByteArray::fromStdString(cs10w());
  }
  void lightsOfInstrumentsAreCurves() {
    QFETCH(QByteArray, text);
    const auto table = parseSpectralCsv(text.toStdString(), "i.csv");
    EXPECT_OK(table);
    EXPECT_NEAR(table.value().onGrid(0)[100], reflectanceAt(500.0), 1e-4);
  }

  // The finer of two sections is read in whole.
  void sekonicHasOneNanometre() {
    const auto read = parseMeasuredSpectra(sekonic(), "i.csv", {380.0, 780.0}, 5, {});
    EXPECT_OK(read);
    QCOMPARE(read.value().wavelengthsNm.size(), std::size_t{401});
  }

  void saysWhatIsWrongInCgats() {
    const auto parse = [](const std::string& text) {
      return parseMeasuredSpectra(text, "c.txt", {}, 2, {});
    };
    const std::string head =
        "CGATS.17\nBEGIN_DATA_FORMAT\nSAMPLE_ID NM400 NM500\nEND_DATA_FORMAT\n";
    EXPECT_OK(parse(head + "BEGIN_DATA\n1 .1 .2\nEND_DATA\n"));
    EXPECT_ERROR(parse(head + "BEGIN_DATA\n1 .1 .2\n2 .1\nEND_DATA\n"),
                 "c.txt:7: the last set has 2 values where the format names 3 fields");
    EXPECT_ERROR(parse(head + "BEGIN_DATA\n1 .1\n2 .1 .2\n3 .1 .2 .3\nEND_DATA\n"),
                 "c.txt:7: the sets");
    EXPECT_ERROR(parse(head + "BEGIN_DATA\n1 .1 .2\n"), "c.txt:5: the data that begin here");
    EXPECT_ERROR(parse(head + "BEGIN_DATA\n1 .1 x\nEND_DATA\n"),
                 "c.txt:6, column 3: 'x' is not a finite number");
    EXPECT_ERROR(parse("CGATS.17\nBEGIN_DATA_FORMAT\nSAMPLE_ID LAB_L\nEND_DATA_FORMAT\nBEGIN_DATA\n"
                       "1 50\nEND_DATA\n"),
                 "c.txt: this CGATS file names no spectral fields");
  }

  void countsAreNoReflectance() {
    const std::string text = "Wave;Sample;Dark\n[nm];[counts];[counts]\n400;1000;10\n500;900;10\n";
    EXPECT_ERROR(parseMeasuredSpectra(text, "a.txt", {}, 2, {}),
                 "a.txt:1: all columns are counts of the detector ('Sample', 'Dark'); export");
  }
};

CUTIS_TEST(InstrumentFilesTest)

}  // namespace
}  // namespace cutis

#include "instrument_files_test.moc"
