#include "src/report/plot/page.h"

#include <algorithm>
#include <map>

#include "src/report/plot/panel_drawing.h"
#include "src/report/plot/title_line.h"

namespace cutis {
namespace {

constexpr double kMargin = 24.0;
constexpr double kLineGap = 3.0;

std::size_t columnsOf(const PanelRow& row) {
  return std::max(row.columns, row.panels.size());
}

// What the panels that stand in line need left and right of their areas.
struct Columns {
  std::vector<double> left, right;
  double areaWidth = 0.0;

  // Where an area begins, from the left margin.
  double begin(std::size_t column) const {
    double x = left[column];
    for (std::size_t i = 0; i < column; ++i)
      x += left[i] + areaWidth + right[i];
    return x;
  }
};

class PageLayout {
 public:
  PageLayout(const Page& page, const PlotTheme& theme, const TextMetrics& metrics)
      : page_(page), theme_(theme), metrics_(metrics), width_(page.width - 2.0 * kMargin) {
    drawing_.width = page.width;
    drawing_.title = page.heading;
    drawing_.description = page.description;
    drawing_.add(Rectangle{});  // the ground, as soon as the height is known
  }

  Drawing make() {
    addHead();
    const auto columns = columnsOfRows();
    for (const PanelRow& row : page_.rows)
      addRow(row, columns.at(columnsOf(row)));
    y_ += theme_.space;
    for (const std::string& note : page_.notes)
      addLines(note, theme_.note);
    drawing_.height = y_ + kMargin - kLineGap;
    drawing_.primitives.front() = Rectangle{{0.5, 0.5, drawing_.width - 0.5, drawing_.height - 0.5},
                                            theme_.ground,
                                            {theme_.grid, 1.0},
                                            6.0};
    return std::move(drawing_);
  }

 private:
  void addText(const std::string& words, const TextStyle& style) {
    drawing_.add(Text{{kMargin, y_ + metrics_.ascent(style)}, words, style});
    y_ += metrics_.height(style) + kLineGap;
  }

  void addLines(const std::string& paragraph, const TextStyle& style) {
    for (const std::string& line : wrapped(paragraph, style, width_, metrics_))
      addText(line, style);
  }

  void addHead() {
    addText(shortened(page_.heading, theme_.heading, width_, metrics_), theme_.heading);
    y_ += kLineGap;
    for (const std::string& paragraph : page_.introduction)
      addLines(paragraph, theme_.label);
  }

  std::map<std::size_t, Columns> columnsOfRows() const {
    std::map<std::size_t, Columns> all;
    for (const PanelRow& row : page_.rows) {
      Columns& columns = all[columnsOf(row)];
      columns.left.resize(columnsOf(row));
      columns.right.resize(columnsOf(row));
      for (std::size_t i = 0; i < row.panels.size(); ++i) {
        const Rooms rooms = sideRooms(row.panels[i], theme_, metrics_);
        columns.left[i] = std::max(columns.left[i], rooms.left);
        columns.right[i] = std::max(columns.right[i], rooms.right);
      }
    }
    for (auto& [count, columns] : all) {
      // The last numbers may reach into the margin.
      double room = width_ + columns.right.back();
      for (std::size_t i = 0; i < count; ++i)
        room -= columns.left[i] + columns.right[i];
      columns.areaWidth = std::max(room / static_cast<double>(count), 1.0);
    }
    return all;
  }

  void addRow(const PanelRow& row, const Columns& columns) {
    y_ += theme_.farSpace;
    const TitleLine title = {row.title, theme_.title, row.legend};
    const double titled = titleHeight(title, width_, theme_, metrics_);
    drawTitle(drawing_, title, {kMargin, y_}, width_, theme_, metrics_);
    y_ += titled;
    if (!row.note.empty()) addLines(row.note, theme_.note);
    if (titled > 0.0) y_ += theme_.space;
    Rooms most;
    for (const Panel& panel : row.panels) {
      const Rooms rooms = roomsAround(panel, columns.areaWidth, theme_, metrics_);
      most.top = std::max(most.top, rooms.top);
      most.bottom = std::max(most.bottom, rooms.bottom);
    }
    const double top = y_ + most.top;
    for (std::size_t i = 0; i < row.panels.size(); ++i) {
      const Panel& panel = row.panels[i];
      const double left = kMargin + columns.begin(i), right = left + columns.areaWidth;
      const double ownTop = roomsAround(panel, columns.areaWidth, theme_, metrics_).top;
      const PanelLayout layout =
          layOut(panel, {left, top, right, top + row.height},
                 {columns.left[i], 0.0, columns.right[i], 0.0}, top - ownTop, theme_);
      drawFrame(drawing_, panel, layout, theme_, metrics_);
      drawContents(drawing_, panel, layout, theme_, metrics_);
    }
    y_ = top + row.height + most.bottom;
  }

  const Page& page_;
  const PlotTheme& theme_;
  const TextMetrics& metrics_;
  double width_;
  double y_ = kMargin - 6.0;
  Drawing drawing_;
};

}  // namespace

Drawing layOut(const Page& page, const PlotTheme& theme, const TextMetrics& metrics) {
  return PageLayout(page, theme, metrics).make();
}

}  // namespace cutis
