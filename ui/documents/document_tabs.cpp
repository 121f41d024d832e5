#include "ui/documents/document_tabs.h"

#include <utility>

#include <QAbstractSpinBox>
#include <QApplication>
#include <QDir>
#include <QFileInfo>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPointer>
#include <QStackedWidget>
#include <QTabBar>
#include <QTimer>
#include <QVBoxLayout>

#include "ui/docks/workspace.h"
#include "ui/documents/document_page.h"
#include "ui/widgets/cross_button.h"

namespace cutis {
namespace {

class ClosableTabBar : public QTabBar {
 public:
  using QTabBar::QTabBar;

 protected:
  void mouseReleaseEvent(QMouseEvent* event) override {
    const int tab = tabAt(event->pos());
    if (event->button() == Qt::MiddleButton && tab >= 0) Q_EMIT tabCloseRequested(tab);
    QTabBar::mouseReleaseEvent(event);
  }
};

// The project's, else what it was made from; empty for the sample.
QString placeOf(const Document& document) {
  std::filesystem::path place = document.projectPath();
  if (place.empty() && !document.sourceFiles().empty()) place = document.sourceFiles().front();
  return QString::fromStdString(place.string());
}

// A button of the mouse is held, or something is being typed.
bool handsAreBusy() {
  const QWidget* focus = QApplication::focusWidget();
  const bool types =
      qobject_cast<const QLineEdit*>(focus) || qobject_cast<const QAbstractSpinBox*>(focus);
  return QGuiApplication::mouseButtons() != Qt::NoButton || types;
}

}  // namespace

DocumentTabs::DocumentTabs(MakePage makePage, QWidget* parent)
    : QWidget(parent),
      makePage_(std::move(makePage)),
      bar_(new ClosableTabBar(this)),
      stack_(new QStackedWidget(this)) {
  bar_->setAccessibleName(tr("Documents"));
  bar_->setMovable(true);
  bar_->setExpanding(false);
  bar_->setDocumentMode(true);
  bar_->setElideMode(Qt::ElideMiddle);
  // One document needs no tab.
  bar_->setAutoHide(true);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(bar_);
  column->addWidget(stack_, 1);
  connect(bar_, &QTabBar::currentChanged, this, [this](int tab) {
    if (tab >= 0) makeCurrent(pageOf(tab));
  });
  connect(bar_, &QTabBar::tabCloseRequested, this,
          [this](int tab) { Q_EMIT closeWanted(pageOf(tab)); });
}

// While those whom pages tell that they go are still there.
DocumentTabs::~DocumentTabs() {
  for (DocumentPage* page : pages())
    delete page;
}

void DocumentTabs::begin() {
  makePage();
}

DocumentPage& DocumentTabs::current() const {
  return static_cast<DocumentPage&>(*stack_->currentWidget());
}

std::vector<DocumentPage*> DocumentTabs::pages() const {
  std::vector<DocumentPage*> all;
  for (int k = 0; k < stack_->count(); ++k)
    all.push_back(static_cast<DocumentPage*>(stack_->widget(k)));
  return all;
}

int DocumentTabs::count() const {
  return bar_->count();
}

DocumentPage& DocumentTabs::makePage() {
  DocumentPage* page = makePage_(stack_);
  stack_->addWidget(page);
  connect(&page->document(), &Document::previewed, this, [this, page] { takeOpened(*page); });
  connect(&page->document(), &Document::opened, this, [this, page] { takeOpened(*page); });
  // Not from within its own signal, and it may have been closed by then.
  connect(
      &page->document(), &Document::previewEnded, this,
      [this, ended = QPointer(page)] {
        if (ended && !ended->document().isOpen()) close(*ended);
      },
      Qt::QueuedConnection);
  // What could not be opened, or was cancelled, leaves no page. Not from within its own signal.
  connect(
      &page->jobs(), &JobRunner::idle, this, [this] { discardBlankPages(); }, Qt::QueuedConnection);
  Q_EMIT pageMade(*page);
  return *page;
}

void DocumentTabs::open(const std::filesystem::path& path) {
  for (DocumentPage* page : pages()) {
    if (!page->isFor(path)) continue;
    // What is still being read will come by itself.
    if (tabOf(*page) >= 0 && !isBatchBegun_) present(*page);
    beginBatch();
    return;
  }
  openAs(path, {});
}

void DocumentTabs::openAs(const std::filesystem::path& path, const OpenChoice& choice) {
  pageToOpenIn().open(path, choice);
}

// What is asked for in one turn of the event loop was dropped or named together.
void DocumentTabs::beginBatch() {
  if (std::exchange(isBatchBegun_, true)) return;
  QTimer::singleShot(0, this, [this] { isBatchBegun_ = false; });
}

DocumentPage& DocumentTabs::pageToOpenIn() {
  DocumentPage& page = current().isBlank() ? current() : makePage();
  if (isBatchBegun_) behind_.insert(&page);
  beginBatch();
  return page;
}

int DocumentTabs::tabOf(const DocumentPage& page) const {
  for (int tab = 0; tab < bar_->count(); ++tab) {
    if (&pageOf(tab) == &page) return tab;
  }
  return -1;
}

DocumentPage& DocumentTabs::pageOf(int tab) const {
  return *static_cast<DocumentPage*>(bar_->tabData(tab).value<QWidget*>());
}

void DocumentTabs::takeOpened(DocumentPage& page) {
  const bool isNew = tabOf(page) < 0;
  if (isNew) addTab(page);
  refreshTitles();
  const bool staysBehind = behind_.erase(&page) > 0;
  if (isNew && !staysBehind) {
    const Document& inFront = current().document();
    const bool takesNothingAway =
        &page == &current() || !(inFront.isOpen() || inFront.isPreviewed());
    if (takesNothingAway || !handsAreBusy()) {
      present(page);
    } else {
      Q_EMIT openedBehind(page);
    }
  }
  if (&page == &current()) Q_EMIT currentChanged();
  QTimer::singleShot(0, this, &DocumentTabs::discardBlankPages);
}

// In the order in which they were asked for, however long each takes to be read.
void DocumentTabs::addTab(DocumentPage& page) {
  const int order = stack_->indexOf(&page);
  int place = 0;
  while (place < bar_->count() && stack_->indexOf(&pageOf(place)) < order)
    ++place;
  // The data come before the signal that looks for them.
  const QSignalBlocker silent(bar_);
  const int tab = bar_->insertTab(place, QString());
  bar_->setTabData(tab, QVariant::fromValue<QWidget*>(&page));
  auto* button = new CrossButton({}, tr("Close"), bar_);
  connect(button, &QToolButton::clicked, this, [this, &page] { Q_EMIT closeWanted(page); });
  bar_->setTabButton(tab, QTabBar::RightSide, button);
}

// Where documents have one name, their folders tell which is which.
QString DocumentTabs::titleOf(const Document& document) const {
  const QString folder = QFileInfo(placeOf(document)).dir().dirName();
  int namesakes = 0;
  for (int tab = 0; tab < bar_->count(); ++tab)
    namesakes += pageOf(tab).document().name() == document.name() ? 1 : 0;
  const bool isAmbiguous = namesakes > 1 && !placeOf(document).isEmpty() && !folder.isEmpty();
  return isAmbiguous ? tr("%1 (%2)").arg(document.name(), folder) : document.name();
}

void DocumentTabs::refreshTitles() {
  for (int tab = 0; tab < bar_->count(); ++tab) {
    const Document& document = pageOf(tab).document();
    // A single & would be taken as a mnemonic.
    const QString text = titleOf(document).replace("&", "&&") + (document.isModified() ? "*" : "");
    // A drag of a slider asks for every frame.
    if (bar_->tabText(tab) != text) bar_->setTabText(tab, text);
    bar_->tabButton(tab, QTabBar::RightSide)
        ->setAccessibleName(tr("Close %1").arg(titleOf(document)));
    const QString place = placeOf(document);
    bar_->setTabToolTip(tab, place.isEmpty() ? document.name() : place);
  }
}

void DocumentTabs::present(DocumentPage& page) {
  bar_->setCurrentIndex(tabOf(page));
  makeCurrent(page);
}

void DocumentTabs::step(int direction) {
  if (bar_->count() == 0) return;
  bar_->setCurrentIndex((bar_->currentIndex() + direction + bar_->count()) % bar_->count());
}

// Docks stand where they stood, whichever document is looked at.
void DocumentTabs::makeCurrent(DocumentPage& page) {
  DocumentPage& before = current();
  if (&before == &page) return;
  page.workspace().restoreLayout(before.workspace().saveLayout());
  stack_->setCurrentWidget(&page);
  Q_EMIT currentChanged();
}

void DocumentTabs::close(DocumentPage& page) {
  const int tab = tabOf(page);
  page.closeDialogs();
  if (bar_->count() <= 1) makeCurrent(makePage());
  // The bar chooses a neighbour where this one was current.
  if (tab >= 0) bar_->removeTab(tab);
  stack_->removeWidget(&page);
  behind_.erase(&page);
  delete &page;
  refreshTitles();
  Q_EMIT currentChanged();
}

void DocumentTabs::discardBlankPages() {
  // What was to come to the front did not open, what was to stay behind it did.
  if (current().isBlank() && bar_->count() > 0) present(pageOf(0));
  for (DocumentPage* page : pages()) {
    if (page == &current() || !page->isBlank()) continue;
    stack_->removeWidget(page);
    behind_.erase(page);
    delete page;
  }
}

}  // namespace cutis
