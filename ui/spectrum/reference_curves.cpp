#include "ui/spectrum/reference_curves.h"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <mutex>

#include <QFileDialog>
#include <QFileInfo>

#include "src/files/spectra/measured_spectra_file.h"
#include "ui/plot/spectrum_plot.h"
#include "ui/spectrum/spectrum_panel.h"
#include "ui/widgets/progress_strip.h"

namespace cutis {
namespace {

constexpr std::size_t kFewestWavelengths = 2;

// Nothing beyond the wavelengths that were measured.
QVector<double> valuesOf(const MeasuredSpectra& spectra, std::size_t index) {
  const Spectrum all = onGrid(spectra, index);
  QVector<double> values(kSampleCount, std::numeric_limits<double>::quiet_NaN());
  for (int i = 0; i < kSampleCount; ++i) {
    const double nm = wavelengthNm(i);
    if (nm >= spectra.wavelengthsNm.front() && nm <= spectra.wavelengthsNm.back())
      values[i] = all[i];
  }
  return values;
}

// The only spectrum of a file bears the name of the file.
std::vector<NamedCurve> curvesOf(const MeasuredSpectra& spectra, const QString& file) {
  std::vector<NamedCurve> curves;
  const std::size_t count = std::min(spectra.ids.size(), kMostReferences);
  for (std::size_t i = 0; i < count; ++i) {
    const QString name = spectra.ids.size() == 1 ? file : QString::fromStdString(spectra.ids[i]);
    curves.push_back({name, valuesOf(spectra, i)});
  }
  return curves;
}

// Notices may come from any thread.
class ReadingNotes {
 public:
  Notice notice() {
    return [this](const std::string& sentence) {
      const std::lock_guard lock(mutex_);
      text_ += "; " + QString::fromStdString(sentence);
    };
  }
  QString text() const { return text_; }

 private:
  std::mutex mutex_;
  QString text_;
};

}  // namespace

ReferenceCurves::ReferenceCurves(JobRunner& jobs, ProgressStrip& progress, QWidget* window)
    : jobs_(jobs), progress_(progress), window_(window) {}

void ReferenceCurves::choose() {
  const QString file =
      QFileDialog::getOpenFileName(window_, tr("Add reference spectra"), {},
                                   tr("Spectra (*.csv *.tsv *.txt *.cgats);;All files (*)"));
  if (!file.isEmpty()) add(file);
}

void ReferenceCurves::add(const QString& path) {
  const QString file = QFileInfo(path).completeBaseName();
  jobs_.start(tr("Read %1").arg(QFileInfo(path).fileName()),
              [this, path, file](const JobRunner::Handle& job) {
                ReadingNotes notes;
                JobContext context = job.context;
                context.notice = notes.notice();
                const WavelengthRange range = {kFirstWavelengthNm, kLastWavelengthNm};
                const auto read = readMeasuredSpectra(std::filesystem::path(path.toStdString()),
                                                      range, kFewestWavelengths, context);
                if (read.failed()) {
                  job.post([this, sentence = QString::fromStdString(read.error().text())] {
                    progress_.showMessage(sentence, true);
                  });
                  return;
                }
                if (!read) return;
                if (read.value().ids.size() > kMostReferences)
                  notes.notice()(tr("only the first %1 of %2 spectra are drawn")
                                     .arg(kMostReferences)
                                     .arg(read.value().ids.size())
                                     .toStdString());
                job.post([this, file, curves = curvesOf(read.value(), file), text = notes.text()] {
                  take(file, curves, text);
                });
              });
}

// The newest ones stay where there are too many.
void ReferenceCurves::take(const QString& file, const std::vector<NamedCurve>& curves,
                           const QString& notes) {
  curves_.insert(curves_.end(), curves.begin(), curves.end());
  if (curves_.size() > kMostReferences) {
    const auto surplus = static_cast<std::ptrdiff_t>(curves_.size() - kMostReferences);
    curves_.erase(curves_.begin(), curves_.begin() + surplus);
  }
  if (panel_ != nullptr) panel_->plot().setReferences(curves_);
  progress_.showMessage(tr("Reference spectra: %1").arg(file) + notes, false);
}

void ReferenceCurves::removeAll() {
  curves_.clear();
  if (panel_ != nullptr) panel_->plot().setReferences(curves_);
}

QString ReferenceCurves::objectionToRemoving() const {
  return curves_.empty() ? tr("There are no reference spectra") : QString();
}

}  // namespace cutis
