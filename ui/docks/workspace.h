#pragma once

// The picture with the docks about it. Docks float, hide, stand beside and behind each other; how
// they stand can be kept and brought back. Interface thread only.

#include <map>
#include <set>
#include <vector>

#include <QByteArray>
#include <QMainWindow>
#include <QTimer>

#include "ui/docks/dock_description.h"

class QDockWidget;

namespace cutis {

class Workspace : public QMainWindow {
  Q_OBJECT

 public:
  // Becomes the owner of the widget in the middle.
  explicit Workspace(QWidget* middle, QWidget* parent = nullptr);
  ~Workspace() override;

  // Adds rows to the end of the table. Precondition: each id is new.
  void add(const std::vector<DockDescription>& docks);
  const std::vector<DockDescription>& all() const { return docks_; }
  // Null if there is no such dock.
  QDockWidget* dock(const QString& id) const;

  // Whether it is to be seen: neither hidden nor behind another one. Precondition, here and below:
  // there is such a dock.
  bool isInFront(const QString& id) const;
  // Brings it to the front wherever it is, hidden or behind another one.
  void present(const QString& id);
  // Hides it if it is in front, else presents it.
  void toggle(const QString& id);

  // Every dock stands where the table says. Where the height does not suffice for a column, its
  // docks stand behind each other.
  void resetLayout();

  // How the docks stand, for settings; not the size of the window.
  QByteArray saveLayout() const;
  // False, and nothing has changed, if this is no layout, or damaged. Docks that it does not know
  // stand where the table says. Waits for the first showing.
  bool restoreLayout(const QByteArray& layout);

 Q_SIGNALS:
  // A dock has come, gone or changed its place.
  void docksChanged();

 protected:
  // The first layout waits until this event is over. The size of the window is known then; and
  // whoever shows the workspace may hold back its updates meanwhile, which a dock that becomes a
  // window of its own would never have back.
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  QMenu* createPopupMenu() override { return nullptr; }

 private:
  void addDock(const DockDescription& description);
  std::vector<QDockWidget*> columnOf(Qt::DockWidgetArea area) const;
  void arrange(Qt::DockWidgetArea area);
  int heightWanted(const std::vector<QDockWidget*>& column) const;
  void placeAsDescribed(const DockDescription& description);
  void stand(const DockDescription& description);
  void takeBackFromNowhere();
  bool applyLayout(const QByteArray& layout);
  void tellWhatIsSeen();
  void settle();
  void settleColumn(Qt::DockWidgetArea area);

  std::vector<DockDescription> docks_;
  std::map<QString, QDockWidget*> byId_;
  std::set<QString> seen_;
  bool arranged_ = false;  // by a layout that was restored or by resetLayout()
  QByteArray kept_;        // to be restored when the size is known
  QTimer settling_;        // fires once Qt has laid out what has changed
};

}  // namespace cutis
