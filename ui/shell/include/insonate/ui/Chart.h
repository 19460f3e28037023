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

/// Contents of a chart over counted things (x), as data: drawn alike on the screen and, dark on white, on paper.
struct ChartPicture {
  enum class Tone { Text, Quiet, Accent, Good, Caution, Danger };

  /// Named ones are in the legend. Lines of one chart should differ by more than their tone.
  struct Line {
    QString name{};
    std::vector<QPointF> points{};
    Tone tone = Tone::Accent;
    Qt::PenStyle pen = Qt::SolidLine;  ///< NoPen: dots alone
    bool dots = false;
  };
  struct Band {
    QString name{};
    std::vector<QPointF> low{}, high{};  ///< from left to right
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
  QStringList categories{};     ///< below x = 0, 1, 2, ... in place of numbers
  std::optional<Interval> y{};  ///< shown at least
  QString words{};              ///< why there is nothing to see, and what to do; empty where there is something

  bool isEmpty() const { return bands.empty() && lines.empty() && boxes.empty(); }
};

/// A chart with a context menu (Shift+F10, too) that saves it as image, drawing or page; Ctrl+Shift+E is the same.
class Chart : public QWidget {
  Q_OBJECT

 public:
  explicit Chart(QWidget* parent = nullptr);
  ~Chart() override;

  void show(ChartPicture picture);
  const ChartPicture& picture() const { return picture_; }
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

  ChartPicture picture_;
  QwtPlot* plot_;
  QAction* save_;
};

/// Paints a chart on paper, within `place`; `unit` of the painter is one pixel of a screen.
void paintChart(QPainter& painter, const QRectF& place, double unit, const ChartPicture& picture);

/// Saves a chart by the ending: .png, .svg or .pdf; others are refused. Replaces the file when it is complete.
Result<void> saveChart(const QString& file, const ChartPicture& picture);

}  // namespace insonate::ui
