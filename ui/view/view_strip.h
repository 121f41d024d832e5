#pragma once

// The column of views: photograph, reconstruction, chromophore maps, … One is always current; a
// click or the arrow keys choose another. Interface thread only.

#include <QListWidget>
#include <QString>
#include <QVector>

namespace cutis {

struct ViewEntry {
  QString id;  // unique in the strip
  QString name;
  QString toolTip;
  QString group = {};  // a heading stands where another one begins; empty: none
};

class ViewStrip : public QListWidget {
  Q_OBJECT

 public:
  explicit ViewStrip(QWidget* parent = nullptr);

  // Keeps thumbnails, and the current view, of ids that stay. Silent.
  void setViews(const QVector<ViewEntry>& views);
  // Any size and shape, fitted into the plate; a null image brings the empty plate back. An unknown
  // id is ignored: its view may have gone while the image was computed.
  void setThumbnail(const QString& id, const QImage& image);
  // Silent.
  void setCurrent(const QString& id);
  // Empty if there is none.
  QString current() const;

 Q_SIGNALS:
  // The user has chosen a view.
  void chosen(const QString& id);

 protected:
  void mousePressEvent(QMouseEvent* event) override;

 private:
  QListWidgetItem* itemOf(const QString& id) const;
  void addHeading(const QString& group);
};

}  // namespace cutis
