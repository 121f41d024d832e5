#include "ui/edits/preset_controller.h"

#include <algorithm>

#include <QClipboard>
#include <QFileDialog>
#include <QFileInfo>
#include <QGuiApplication>

#include "src/files/edits/edits_file.h"
#include "src/files/io/atomic_write.h"
#include "src/files/io/named_files.h"
#include "src/files/io/text_file.h"
#include "src/files/resources.h"
#include "ui/dialogs/file_to_write.h"
#include "ui/docks/edit_controller.h"
#include "ui/edits/preset_catalogue.h"
#include "ui/view/view_controller.h"
#include "ui/widgets/progress_strip.h"

namespace cutis {
namespace {

QString presetFilter() {
  return PresetController::tr("Presets (*.json)");
}

}  // namespace

PresetController::PresetController(Document& document, ViewController& views,
                                   ProgressStrip& progress, QWidget* window)
    : QObject(window), document_(document), views_(views), progress_(progress), window_(window) {}

void PresetController::fail(const Error& error) {
  Q_EMIT document_.failed(QString::fromStdString(error.text()));
}

void PresetController::take(const EditStack& edits, const QString& name) {
  document_.apply({name, {}, [&edits](DocumentState& state) { state.edits = edits; }, false});
  document_.endGroup();
  if (views_.current() == ViewKind::photograph) views_.show(ViewKind::editedAlbedo);
  if (slidersShow(edits)) return;
  Q_EMIT document_.noticed(
      tr("%1 holds edits that the sliders do not show; they act, and Reset takes them away.")
          .arg(name));
}

void PresetController::use(std::string_view text, const QString& name, const std::string& place) {
  if (!document_.isOpen()) return;
  const auto edits = readEdits(text, place, [this](const std::string& sentence) {
    Q_EMIT document_.noticed(QString::fromStdString(sentence));
  });
  if (edits.failed()) return fail(edits.error());
  take(edits.value(), name);
}

void PresetController::useBuiltIn(const QString& id) {
  const std::string file = "presets/" + id.toStdString() + ".json";
  const auto text = resource(file);
  const auto& all = presetCatalogue();
  const auto preset =
      std::find_if(all.begin(), all.end(), [&](const auto& known) { return known.id == id; });
  Q_ASSERT(text && preset != all.end());
  use(*text, tr("Preset %1").arg(preset->title), file);
}

void PresetController::useFile(const QString& path) {
  const auto text = readTextFile(path.toStdString());
  if (text.failed()) return fail(text.error());
  if (text)
    use(text.value(), tr("Preset %1").arg(QFileInfo(path).completeBaseName()), path.toStdString());
}

void PresetController::saveFile(const QString& path) {
  const std::filesystem::path target = path.toStdString();
  for (const std::filesystem::path& source : document_.sourceFiles()) {
    if (!isSameFile(target, source)) continue;
    return fail({ErrorKind::input, target.string(),
                 "is what was opened and is never written to; choose another name"});
  }
  EditStack edits = document_.scene().edits;
  if (!edits.empty()) edits.front().name = target.stem().string();
  const Status written = writeTextAtomically(target, editsText(edits));
  if (written.failed()) return fail(written.error());
  progress_.showMessage(tr("Written: %1").arg(path), false);
}

void PresetController::copy() {
  QGuiApplication::clipboard()->setText(QString::fromStdString(editsText(document_.scene().edits)));
  progress_.showMessage(tr("The edits are on the clipboard, as text."), false);
}

void PresetController::paste() {
  const QString text = QGuiApplication::clipboard()->text();
  if (text.trimmed().isEmpty()) {
    Q_EMIT document_.failed(tr("The clipboard holds no edits; copy those of a picture first."));
    return;
  }
  use(text.toStdString(), tr("Pasted edits"), tr("clipboard").toStdString());
}

void PresetController::load() {
  const QString file = QFileDialog::getOpenFileName(window_, tr("Load preset"), {},
                                                    presetFilter() + ";;" + tr("All files (*)"));
  if (!file.isEmpty()) useFile(file);
}

void PresetController::save() {
  const QString file = chooseFileToWrite(window_, tr("Save preset"),
                                         besideSource(document_, "preset.json"), presetFilter());
  if (!file.isEmpty()) saveFile(file);
}

QString PresetController::objectionToUse() const {
  return document_.isOpen() ? QString() : tr("Nothing is open yet");
}

QString PresetController::objectionToKeeping() const {
  if (!document_.isOpen()) return objectionToUse();
  return isNeutral(document_.scene().edits) ? tr("There are no edits") : QString();
}

}  // namespace cutis
