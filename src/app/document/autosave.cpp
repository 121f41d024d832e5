#include "src/app/document/autosave.h"

#include <utility>

#include <QPointer>

#include "src/app/project/manifest.h"

namespace cutis {
namespace {

constexpr int kRestMs = 2'000;
constexpr int kLongestMs = 30'000;

}  // namespace

Autosave::Autosave(Document& document, JobRunner& jobs, std::shared_ptr<Journal> journal,
                   QObject* parent)
    : QObject(parent),
      document_(document),
      jobs_(jobs),
      journal_(std::move(journal)),
      written_(std::filesystem::exists(journal_->path())) {
  rest_.setSingleShot(true);
  rest_.setInterval(kRestMs);
  longest_.setSingleShot(true);
  longest_.setInterval(kLongestMs);
  connect(&rest_, &QTimer::timeout, this, &Autosave::write);
  connect(&longest_, &QTimer::timeout, this, &Autosave::write);
  connect(&document, &Document::modifiedChanged, this, &Autosave::follow);
}

Autosave::~Autosave() {
  if (discarded_ || !document_.isOpen()) return;
  if (document_.isModified()) {
    static_cast<void>(journal_->write(journal_->nextTurn(), text()));
  } else {
    journal_->erase();
  }
}

void Autosave::discard() {
  discarded_ = true;
  rest_.stop();
  longest_.stop();
  journal_->erase();
}

void Autosave::follow() {
  if (discarded_) return;
  if (document_.isModified()) {
    rest_.start();
    if (!longest_.isActive()) longest_.start();
    return;
  }
  rest_.stop();
  longest_.stop();
  if (std::exchange(written_, false)) journal_->erase();
}

void Autosave::write() {
  rest_.stop();
  longest_.stop();
  written_ = true;
  jobs_.startQuiet([self = QPointer(this), journal = journal_, turn = journal_->nextTurn(),
                    now = text()](const JobRunner::Handle& job) {
    const Status written = journal->write(turn, now);
    if (written) return;
    job.post([self, sentence = QString::fromStdString(written.error().text())] {
      if (self) Q_EMIT self->failed(sentence);
    });
  });
}

// Maps can be fitted again.
std::string Autosave::text() const {
  Project project = document_.project();
  project.maps.clear();
  project.editsOf = document_.projectPath();
  return projectText(project, {});
}

}  // namespace cutis
