#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/Statistics.h>

#include <QPointF>
#include <QRectF>
#include <QString>
#include <QStringList>
#include <QWidget>
#include <optional>
#include <vector>

class QMenu;
class QPainter;
class QwtPlot;

namespace insonate::ui {

/// Contents of a chart. The x axis counts, e.g. attempts. The same contents are drawn on the screen and, dark on white,
/// on paper.
struct ChartContents {
  enum class Tone { Text, Quiet, Accent, Good, Caution, Danger };

  /// A line with a name appears in the legend. Lines of one chart should differ in more than their tone, since some
  /// users cannot distinguish colors.
  struct Line {
    QString name{};
    std::vector<QPointF> points{};
    Tone tone = Tone::Accent;
    Qt::PenStyle pen = Qt::SolidLine;  ///< Qt::NoPen: only dots are drawn
    bool dots = false;
  };
  struct Band {
    QString name{};
    std::vector<QPointF> low{}, high{};  ///< lower and upper edge of a band: points from left to right
    Tone tone = Tone::Accent;
  };
  struct Box {
    double x = 0;
    BoxPlot numbers{};
    Tone tone = Tone::Accent;
  };

  QString title{}, xTitle{}, yTitle{};
  std::vector<Band> bands{};
  std::vector<Line> lines{};
  std::vector<Box> boxes{};
  QStringList categories{};     ///< axis labels at x = 0, 1, 2, ... in place of numbers
  std::optional<Interval> y{};  ///< range that the y axis includes in any case
  QString words{};  ///< sentence that says why the chart is empty, and what to do; empty if the chart has contents

  bool isEmpty() const { return bands.empty() && lines.empty() && boxes.empty(); }
};

/// A chart. Its context menu (right click or Shift+F10) and Ctrl+Shift+E save the chart as PNG, SVG or PDF.
class Chart : public QWidget {
  Q_OBJECT

 public:
  explicit Chart(QWidget* parent = nullptr);
  ~Chart() override;

  void show(ChartContents picture);
  const ChartContents& picture() const { return picture_; }
  /// Saves the chart and emits written() or failed().
  void save(const QString& file);

 Q_SIGNALS:
  void written(const QString& sentence, const QString& folder);
  void failed(const QString& what, const QString& advice);

 protected:
  void contextMenuEvent(QContextMenuEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  void choose();

  ChartContents picture_;
  QwtPlot* plot_;
  QAction* save_;
};

/// Paints a chart into the rectangle `place`, in the colors for paper. `unit`: size of a screen pixel in units of the
/// painter.
void paintChart(QPainter& painter, const QRectF& place, double unit, const ChartContents& picture);

/// Saves a chart in the format that the ending of `file` selects: .png, .svg or .pdf. Fails for other endings. An
/// existing file is replaced only when the new one is complete.
Result<void> saveChart(const QString& file, const ChartContents& picture);

}  // namespace insonate::ui
